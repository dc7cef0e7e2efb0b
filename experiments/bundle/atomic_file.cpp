// SPDX-License-Identifier: MIT
#include "experiments/bundle/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view temporary_prefix = ".bezierbench-";
constexpr std::string_view temporary_suffix = ".tmp";

[[noreturn]] void fail(const fs::path& path, std::string_view what, int error, std::string_view advice) {
  throw Failure(Exit::input_output, "{}: cannot be {}: {}; {}", path.empty() ? "\"\"" : path.string(), what,
                std::generic_category().message(error), advice);
}

[[noreturn]] void fail_write(const fs::path& path, int error, std::string_view option) {
  const bool is_full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  fail(path, "written", error,
       fmt::format("{} or choose another {}", is_full ? "free space" : "check the path", option));
}

[[noreturn]] void fail_read(const fs::path& path, int error) {
  fail(path, "read", error, "check the path and its permissions");
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

// Writes all of `bytes` and closes the file. Returns 0 or the error.
int write_all(File file, std::string_view bytes, bool is_durable) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() || std::fflush(file.get()) != 0 ||
      (is_durable && ::fsync(::fileno(file.get())) == -1))
    return errno;
  return std::fclose(file.release()) == 0 ? 0 : errno;
}

// Makes a rename in `folder` durable, where the file system can: after a power cut the old file may be back otherwise.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor == -1) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

// Replaces the file `target` by `bytes`. Error messages name `path`, which the user gave by `option`.
void replace(const fs::path& path, const fs::path& target, std::string_view bytes, std::string_view option) {
  static std::atomic<unsigned long> count{0};
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  fs::path name;
  File file;
  do {  // a process of the same id may have left its file, or share the folder from another machine
    name = folder / fmt::format("{}{}-{}{}", temporary_prefix, ::getpid(), count++, temporary_suffix);
    file.reset(std::fopen(name.c_str(), "wxe"));
  } while (!file && errno == EEXIST);
  if (!file) fail_write(path, errno, option);
  int error = write_all(std::move(file), bytes, true);
  if (error == 0 && ::rename(name.c_str(), target.c_str()) == -1) error = errno;
  if (error != 0) {
    ::unlink(name.c_str());
    fail_write(path, error, option);
  }
  sync_folder(folder);
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes, std::string_view option) {
  // A rename over /dev/null, or over a link into another folder, would destroy what the user meant to write to.
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_character_file(status) || fs::is_fifo(status)) {
    File file(std::fopen(path.c_str(), "we"));
    if (const int failed = file ? write_all(std::move(file), bytes, false) : errno) fail_write(path, failed, option);
    return;
  }
  if (fs::is_directory(status)) fail_write(path, EISDIR, option);
  if (fs::exists(status) && !fs::is_regular_file(status)) fail_write(path, EINVAL, option);
  fs::path target = path;
  if (fs::is_symlink(fs::symlink_status(path, error))) {
    target = fs::weakly_canonical(path, error);
    if (error) fail_write(path, error.value(), option);
  }
  replace(path, target, bytes, option);
}

std::string read_file(const fs::path& path) {
  const File file(std::fopen(path.c_str(), "re"));
  if (!file) fail_read(path, errno);
  std::string bytes;
  std::array<char, 65536> buffer;
  while (const auto count = std::fread(buffer.data(), 1, buffer.size(), file.get())) bytes.append(buffer.data(), count);
  if (std::ferror(file.get()) != 0) fail_read(path, errno);
  return bytes;
}

std::string read_bundle_file(const fs::path& path) {
  std::error_code ignored;  // reading reports it
  const auto status = fs::symlink_status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Failure(Exit::input_output, "{}: is not a regular file; restore the file", path.string());
  return read_file(path);
}

void write_bundle_file(const fs::path& path, std::string_view bytes) { replace(path, path, bytes, "--out"); }

void ignore_file_size_signal() { std::signal(SIGXFSZ, SIG_IGN); }

bool is_temporary_name(std::string_view name) {
  return name.starts_with(temporary_prefix) && name.ends_with(temporary_suffix);
}

}  // namespace bezierbench::bundle
