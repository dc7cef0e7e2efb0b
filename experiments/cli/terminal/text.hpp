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
#include "experiments/terminal.hpp"

namespace bezierbench::cli {

/// `text` in lines as wrapped() cuts it; a word that is longer than `width` is cut, too. At least one line, which may be
/// empty.
std::vector<std::string> lines_of(std::string_view text, std::size_t width);

/// The width of lines on standard output; in a pipe, where terminal_width() knows none, lines are not broken.
std::size_t output_width();

/// The width of text that is read, such as help: that of the terminal up to 100, 80 in a pipe.
std::size_t reading_width();

using bezierbench::wrapped;

/// The same in the width of standard output.
std::string wrapped(std::string_view head, std::string_view text, std::size_t indent);

/// `text` with spaces up to this number of characters.
std::string padded(std::string_view text, std::size_t width);

// Tables for people that fit the terminal.

/// A table with aligned columns: one line per row where `width` is empty or wide enough. In a narrower terminal the
/// last `optional` columns are left out as far as required, then the widest columns are broken at spaces. Where that
/// does not suffice, as many columns as fit stay aligned, and each row's other fields follow below it, with the names
/// of their columns where these are several. `lines` are the header and the rows, all of one length. Fields are escaped
/// as reference/number/echo.hpp describes. Colours are those of standard output.
std::string fitted(std::vector<std::vector<std::string>> lines, std::optional<std::size_t> width,
                   std::size_t optional = 0);

// Words of command lines.

/// `text` as one word of a command line that can be pasted into a shell.
std::string shell_word(const std::string& text);

/// The program as it was called, for commands that are printed.
std::string this_program();

// Messages of the program on standard error.

/// Writes one line to standard error, which a terminal gets broken at spaces. `text` may come from a damaged file: line ends and other control characters are
/// escaped, and the middle of a very long word or text is left out. Does not throw where standard error cannot be
/// written.
void say(const std::string& text);

/// Says each finding of a command; returns the exit code that they mean.
Exit say_findings(std::span<const std::string> findings);

}  // namespace bezierbench::cli
