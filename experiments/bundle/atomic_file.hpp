// SPDX-License-Identifier: MIT
// Whole files, read and written such that a reader sees either the old bytes or the new ones.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bezierbench::bundle {

/// Replaces `path` by `bytes`: temporary file beside it, write, fsync, rename, fsync of the folder where it can. A
/// symbolic link is followed; a pipe or character device (/dev/stdout) is written directly. Safe from several threads
/// and processes. Throws Failure(Exit::input_output) with one line, which names the `option` that gave the path; then
/// the old file is untouched and the temporary file removed.
void write_file(const std::filesystem::path& path, std::string_view bytes, std::string_view option = "--out");

/// All bytes of a file. Throws Failure(Exit::input_output) with one line.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// All bytes of a file of a bundle. Bundles come from strangers: opens only a regular file and follows no link. Throws
/// Failure(Exit::input_output) with one line.
[[nodiscard]] std::string read_bundle_file(const std::filesystem::path& path);

/// Writes a file of a bundle as write_file does, but replaces whatever has this name, a link or a pipe too, and never
/// writes through it.
void write_bundle_file(const std::filesystem::path& path, std::string_view bytes);

/// Makes a write beyond the file size limit (`ulimit -f`) fail with EFBIG, which write_file reports, instead of killing
/// the program. The disposition is the process's: call it first thing in main(), before any thread starts. Programs
/// started by exec inherit it.
void ignore_file_size_signal();

/// Whether `name` is that of a temporary file of write_file. Such files remain only where the program was killed.
[[nodiscard]] bool is_temporary_name(std::string_view name);

}  // namespace bezierbench::bundle
