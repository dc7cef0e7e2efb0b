// SPDX-License-Identifier: MIT
// The messages of the program on standard error while and after it works. Errors of writing are ignored.
#pragma once

#include <string>
#include <string_view>

namespace bezierbench::run {

/// How a run reports its progress: not at all, in lines for people, or as objects of JSON for programs, one per line.
enum class Telling { nothing, text, json };

/// From now on note() writes JSON, so that everything on standard error is.
void write_notes_as_json();

/// Writes one line, escaped by reference/number/echo.hpp. `head` is put before it, in colour on a terminal.
void note(const std::string& line, std::string_view head = {});

/// Writes one line of JSON as it is.
void note_event(const std::string& json);

}  // namespace bezierbench::run
