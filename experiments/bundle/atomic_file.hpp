// SPDX-License-Identifier: MIT
// Whole files, read and written such that a reader sees either the old bytes or the new ones.
#pragma once

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace bezierbench::bundle {

/// Replaces `path` by `bytes`: temporary file beside it, write, fsync, rename, fsync of the folder. A symbolic link is
/// followed; a pipe or character device (/dev/stdout) is written directly. Safe from several threads and processes.
/// Throws Failure(Exit::input_output) with one line; then the old file is untouched and the temporary file removed
/// (should the folder's own fsync fail, the new file is in place but may not survive a power cut).
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// All bytes of a file. Throws Failure(Exit::input_output) with one line.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// The largest file that a bundle may have, in bytes: far more than any table, and little enough for memory.
inline constexpr std::uintmax_t largest_bundle_file = std::uintmax_t{1} << 30;

/// All bytes of a file of a bundle. Bundles come from strangers: opens only a regular file, follows no link,
/// never blocks, and takes no file beyond largest_bundle_file. Throws Failure(Exit::input_output) with one line.
[[nodiscard]] std::string read_bundle_file(const std::filesystem::path& path);

/// Writes a file of a bundle as write_file does, but replaces whatever has this name, a link or a pipe too, and never
/// writes through it. Throws also for more than largest_bundle_file bytes, since no program would read them again.
void write_bundle_file(const std::filesystem::path& path, std::string_view bytes);

/// Makes a write beyond the file size limit (`ulimit -f`) fail with EFBIG, which write_file reports, instead of killing
/// the program. The disposition is the process's: call it first thing in main(), before any thread starts. Programs
/// started by exec inherit it.
void ignore_file_size_signal();

/// Whether `name` is that of a temporary file of write_file. Such files remain only where the program was killed.
[[nodiscard]] bool is_temporary_name(std::string_view name);

/// The result of `call()`, which returns -1 and sets errno where it fails; repeated where a signal interrupts it.
template <class Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

}  // namespace bezierbench::bundle
