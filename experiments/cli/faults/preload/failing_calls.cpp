// SPDX-License-Identifier: MIT
// To be preloaded (LD_PRELOAD) into the program under test: counts and lists the system calls that change files, and
// makes one or several of them fail. Environment variables control it:
//   FAILING_CALLS_LIST   a file to which every call that counts is appended, one "NAME PATH" per line
//   FAILING_CALLS_AT     the number, from 1, of the call at which it happens
//   FAILING_CALLS_HOW    what happens: an errno (a number), `short` (a write takes one byte of many), or `vanish`
//                        (before the call, the folder FAILING_CALLS_FOLDER gets ".gone" added to its name)
//   FAILING_CALLS_TIMES  to how many calls in a row, of those that count; 1 if not set
// What counts: open for writing or of a folder, write, ftruncate, fsync, rename, mkdir, unlink, rmdir, flock, and close
// of what was so opened. A close that fails closes nevertheless, as on Linux.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

long number_in(const char* variable, long otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtol(text, nullptr, 10);
}

// Only the program's calls are counted: this library calls the kernel directly.
void list_call(const char* name, const std::string& path) {
  const char* list = std::getenv("FAILING_CALLS_LIST");
  if (list == nullptr) return;
  const auto file =
      static_cast<int>(syscall(SYS_openat, AT_FDCWD, list, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
  const std::string line = std::string(name) + ' ' + path + '\n';
  if (syscall(SYS_write, file, line.data(), line.size()) != static_cast<long>(line.size())) std::abort();
  syscall(SYS_close, file);
}

enum class Outcome { done, fails, is_short };

Outcome outcome_of(const char* name, const std::string& path) {
  static std::atomic<long> count{0};
  static const long at = number_in("FAILING_CALLS_AT", 0);
  static const long times = number_in("FAILING_CALLS_TIMES", 1);
  list_call(name, path);
  const long number = ++count;
  if (at == 0 || number < at || number - at >= times) return Outcome::done;
  const std::string how = std::getenv("FAILING_CALLS_HOW");
  if (how == "short") return Outcome::is_short;
  if (how == "vanish") {
    const std::string folder = std::getenv("FAILING_CALLS_FOLDER");
    syscall(SYS_rename, folder.c_str(), (folder + ".gone").c_str());
    return Outcome::done;
  }
  errno = std::atoi(how.c_str());
  return Outcome::fails;
}

std::string path_of(int descriptor) {
  char path[PATH_MAX];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = readlink(link.c_str(), path, sizeof path);
  return length > 0 ? std::string(path, static_cast<std::size_t>(length)) : "?";
}

bool is_counted(int flags) { return (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_DIRECTORY)) != 0; }

/// A regular file open for writing, or a folder.
bool is_counted_descriptor(int descriptor) {
  struct stat facts {};
  if (fstat(descriptor, &facts) != 0) return false;
  if (S_ISDIR(facts.st_mode)) return true;
  return S_ISREG(facts.st_mode) && is_counted(fcntl(descriptor, F_GETFL));
}

template <class Call>
int attempt(const char* name, const std::string& path, Call call) {
  return outcome_of(name, path) == Outcome::fails ? -1 : static_cast<int>(call());
}

int open_at(int folder, const char* path, int flags, unsigned mode) {
  const auto call = [&] { return syscall(SYS_openat, folder, path, flags, mode); };
  return is_counted(flags) ? attempt("open", path, call) : static_cast<int>(call());
}

unsigned mode_of(int flags, va_list arguments) { return (flags & O_CREAT) != 0 ? va_arg(arguments, unsigned) : 0; }

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const unsigned mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_at(AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const unsigned mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_at(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const unsigned mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_at(folder, path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const unsigned mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_at(folder, path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
  const auto outcome = is_counted_descriptor(descriptor) ? outcome_of("write", path_of(descriptor)) : Outcome::done;
  if (outcome == Outcome::fails) return -1;
  return syscall(SYS_write, descriptor, bytes, outcome == Outcome::is_short && size > 1 ? 1 : size);
}

int close(int descriptor) {
  static const auto call = next<int (*)(int)>("close");
  if (!is_counted_descriptor(descriptor)) return call(descriptor);
  const bool fails = outcome_of("close", path_of(descriptor)) == Outcome::fails;
  const int error = errno;
  const int result = call(descriptor);
  if (!fails) return result;
  errno = error;
  return -1;
}

int ftruncate(int descriptor, off_t size) {
  static const auto call = next<int (*)(int, off_t)>("ftruncate");
  return attempt("ftruncate", path_of(descriptor), [&] { return call(descriptor, size); });
}

int fsync(int descriptor) {
  static const auto call = next<int (*)(int)>("fsync");
  return attempt("fsync", path_of(descriptor), [&] { return call(descriptor); });
}

int fdatasync(int descriptor) {
  static const auto call = next<int (*)(int)>("fdatasync");
  return attempt("fsync", path_of(descriptor), [&] { return call(descriptor); });
}

int flock(int descriptor, int operation) noexcept {
  static const auto call = next<int (*)(int, int)>("flock");
  return attempt("flock", path_of(descriptor), [&] { return call(descriptor, operation); });
}

int rename(const char* from, const char* to) noexcept {
  static const auto call = next<int (*)(const char*, const char*)>("rename");
  return attempt("rename", to, [&] { return call(from, to); });
}

int mkdir(const char* path, mode_t mode) noexcept {
  static const auto call = next<int (*)(const char*, mode_t)>("mkdir");
  return attempt("mkdir", path, [&] { return call(path, mode); });
}

int unlink(const char* path) noexcept {
  static const auto call = next<int (*)(const char*)>("unlink");
  return attempt("unlink", path, [&] { return call(path); });
}

int remove(const char* path) noexcept {
  static const auto call = next<int (*)(const char*)>("remove");
  return attempt("unlink", path, [&] { return call(path); });
}

int rmdir(const char* path) noexcept {
  static const auto call = next<int (*)(const char*)>("rmdir");
  return attempt("rmdir", path, [&] { return call(path); });
}

int unlinkat(int folder, const char* path, int flags) noexcept {
  static const auto call = next<int (*)(int, const char*, int)>("unlinkat");
  const char* name = (flags & AT_REMOVEDIR) != 0 ? "rmdir" : "unlink";
  return attempt(name, path, [&] { return call(folder, path, flags); });
}

}  // extern "C"
