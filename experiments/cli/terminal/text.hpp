// SPDX-License-Identifier: MIT
// Text for people: lines of a given width, tables, words of command lines, and messages.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/failure.hpp"

namespace bezierbench::cli {

/// `text` cut at spaces into lines of at most `width` characters; a longer word has a line of its own. At least one
/// line, which may be empty.
std::vector<std::string> lines_of(std::string_view text, std::size_t width);

/// The width of lines on standard output; in a pipe, where terminal_width() knows none, lines are not broken.
std::size_t output_width();

/// `head` and `text` in lines of at most `width` characters. The first line begins with `head`, the others with
/// `indent` spaces.
std::string wrapped(std::string_view head, std::string_view text, std::size_t indent,
                    std::size_t width = output_width());

/// The number of characters of a UTF-8 text.
std::size_t length_of(std::string_view text);

/// `text` with spaces up to this number of characters.
std::string padded(std::string_view text, std::size_t width);

// Tables for people that fit the terminal.

/// A table with aligned columns: one line per row where `width` is empty or wide enough. In a narrower terminal the
/// last column is broken at spaces, if enough of it stays; else as many columns as fit stay aligned, and each row's
/// other fields follow below it, with the names of their columns where these are several. `lines` are the header and
/// the rows, all of one length. Fields are escaped as reference/number/echo.hpp describes. Colours are those of
/// standard output.
std::string fitted(std::vector<std::vector<std::string>> lines, std::optional<std::size_t> width);

// Words of command lines.

/// `text` as one word of a command line that can be pasted into a shell.
std::string shell_word(const std::string& text);

/// The program as it was called, for commands that are printed.
std::string this_program();

// Messages of the program on standard error.

/// Writes one line to standard error. `text` may come from a damaged file: line ends and other control characters are
/// escaped, and the middle of a very long word or text is left out. Does not throw where standard error cannot be
/// written.
void say(const std::string& text);

/// Says each finding of a command; returns the exit code that they mean.
Exit say_findings(std::span<const std::string> findings);

}  // namespace bezierbench::cli
