// SPDX-License-Identifier: MIT
#include "experiments/bundle/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <limits>
#include <system_error>

#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view temporary_prefix = ".bezierbench-";
constexpr std::string_view temporary_suffix = ".tmp";

std::string reason(int error) { return std::generic_category().message(error); }

std::string_view write_advice(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT: return "free space or choose another --out";
    case EFBIG: return "raise the file size limit (ulimit -f) or choose another --out";
    case EACCES:
    case EPERM:
    case EROFS: return "choose an --out that you may write to";
    default: return "check the path or choose another --out";
  }
}

[[noreturn]] void fail_write(const fs::path& path, int error) {
  throw Failure(Exit::input_output,
                fmt::format("{}: cannot be written: {}; {}", path.string(), reason(error), write_advice(error)));
}

[[noreturn]] void fail_read(const fs::path& path, int error) {
  throw Failure(Exit::input_output, fmt::format("{}: cannot be read: {}; check the path and its permissions",
                                                path.string(), reason(error)));
}

// Owns a file descriptor. close() reports an error; the destructor closes on the way out of a failure and ignores
// errors.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }

  // Returns 0 or the error. Linux frees the number even where a signal interrupts close(): a second close could hit
  // another thread's file, and the data was already synced.
  int close() {
    if (number_ == -1) return 0;
    const int result = ::close(number_);
    number_ = -1;
    return result == 0 || errno == EINTR ? 0 : errno;
  }

 private:
  int number_;
};

// Removes a temporary file unless it got its final name.
class TemporaryName {
 public:
  explicit TemporaryName(fs::path path) : path_(std::move(path)) {}
  ~TemporaryName() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  void release() { path_.clear(); }

 private:
  fs::path path_;
};

// Writes all of `bytes`. Returns 0 or the error.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = uninterrupted([&] { return ::write(descriptor, bytes.data(), bytes.size()); });
    if (written == -1) return errno;
    if (written == 0) return EIO;  // no progress without an error: do not try for ever
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

// Opens a new file under a name that no other thread or process uses. O_EXCL ensures this also between machines that
// share the folder and may use the same process id. Mode 0666 leaves the permissions to the user's umask, as for any
// other file.
int open_temporary(const fs::path& folder, fs::path& name) {
  static std::atomic<unsigned long> count{0};
  for (;;) {
    name = folder / fmt::format("{}{}-{}{}", temporary_prefix, ::getpid(), count++, temporary_suffix);
    const int descriptor =
        uninterrupted([&] { return ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
    if (descriptor != -1 || errno != EEXIST) return descriptor;
  }
}

// Makes a rename in `folder` durable. Returns 0 or the error.
int sync_folder(const fs::path& folder) {
  Descriptor descriptor(uninterrupted([&] { return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
  if (descriptor.number() == -1) return errno == EACCES ? 0 : errno;  // a folder may be writable but not readable
  if (uninterrupted([&] { return ::fsync(descriptor.number()); }) == -1) {
    if (errno != EINVAL && errno != ENOTSUP) return errno;  // some network file systems cannot sync folders
  }
  return descriptor.close();
}

void write_device(const fs::path& path, std::string_view bytes) {
  Descriptor descriptor(uninterrupted([&] { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); }));
  if (descriptor.number() == -1) fail_write(path, errno);
  if (const int error = write_all(descriptor.number(), bytes)) fail_write(path, error);
  if (const int error = descriptor.close()) fail_write(path, error);
}

// Replaces the file `target` by `bytes`. Error messages name `path`, which the user gave.
void replace(const fs::path& path, const fs::path& target, std::string_view bytes) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  fs::path name;
  Descriptor descriptor(open_temporary(folder, name));
  if (descriptor.number() == -1) fail_write(path, errno);
  TemporaryName temporary(name);
  if (const int error = write_all(descriptor.number(), bytes)) fail_write(path, error);
  if (uninterrupted([&] { return ::fsync(descriptor.number()); }) == -1) fail_write(path, errno);
  if (const int error = descriptor.close()) fail_write(path, error);
  if (::rename(temporary.path().c_str(), target.c_str()) == -1) fail_write(path, errno);
  temporary.release();
  if (const int error = sync_folder(folder)) fail_write(path, error);
}

[[noreturn]] void fail_size(const fs::path& path, std::string_view advice) {
  throw Failure(Exit::input_output, fmt::format("{}: larger than the {} MiB that a file of a bundle may have; {}",
                                                path.string(), largest_bundle_file >> 20, advice));
}

// Reads to the end of the file. Throws Failure where it is larger than `most` bytes.
std::string read_all(const fs::path& path, int descriptor, std::uintmax_t most) {
  struct stat facts {};
  if (::fstat(descriptor, &facts) == -1) fail_read(path, errno);
  constexpr std::string_view advice = "check that it is what it should be";
  const auto size = static_cast<std::uintmax_t>(std::max<off_t>(facts.st_size, 0));  // only a hint: it is 0 in /proc
  if (size > most) fail_size(path, advice);
  std::string bytes;
  bytes.reserve(size);
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t count = uninterrupted([&] { return ::read(descriptor, buffer.data(), buffer.size()); });
    if (count == -1) fail_read(path, errno);
    if (count == 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (bytes.size() > most) fail_size(path, advice);
  }
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
  // A rename over /dev/null, or over a link into another folder, would destroy what the user meant to write to.
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_character_file(status) || fs::is_fifo(status)) return write_device(path, bytes);
  if (fs::is_directory(status)) fail_write(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) fail_write(path, EINVAL);
  fs::path target = path;
  if (fs::is_symlink(fs::symlink_status(path, error))) {
    target = fs::weakly_canonical(path, error);
    if (error) fail_write(path, error.value());
  }
  replace(path, target, bytes);
}

std::string read_file(const fs::path& path) {
  Descriptor descriptor(uninterrupted([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY); }));
  if (descriptor.number() == -1) fail_read(path, errno);
  return read_all(path, descriptor.number(), std::numeric_limits<std::uintmax_t>::max());
}

std::string read_bundle_file(const fs::path& path) {
  // Opening a device can have effects of its own: anything but a regular file is not opened at all.
  struct stat facts {};
  if (::lstat(path.c_str(), &facts) == -1) fail_read(path, errno);
  if (!S_ISREG(facts.st_mode))
    throw Failure(Exit::input_output, fmt::format("{}: is not a regular file; restore the file", path.string()));
  Descriptor descriptor(
      uninterrupted([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NOFOLLOW | O_NONBLOCK); }));
  if (descriptor.number() == -1) fail_read(path, errno);
  return read_all(path, descriptor.number(), largest_bundle_file);
}

void write_bundle_file(const fs::path& path, std::string_view bytes) {
  if (bytes.size() > largest_bundle_file) fail_size(path, "split the suite (--only) over several bundles");
  replace(path, path, bytes);
}

void ignore_file_size_signal() { std::signal(SIGXFSZ, SIG_IGN); }

bool is_temporary_name(std::string_view name) {
  return name.starts_with(temporary_prefix) && name.ends_with(temporary_suffix);
}

}  // namespace bezierbench::bundle
