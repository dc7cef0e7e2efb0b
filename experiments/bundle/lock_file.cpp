// SPDX-License-Identifier: MIT
#include "experiments/bundle/lock_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw Failure(Exit::input_output, "{}: cannot be locked: {}; choose an --out that you may write to", path.string(),
                std::generic_category().message(error));
}

}  // namespace

LockFile::LockFile(std::filesystem::path path) : path_(std::move(path)) {
  constexpr int most_tries = 1000;
  for (int tries = 0; tries < most_tries; ++tries) {
    // Network file systems want write access for an exclusive lock.
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY, 0666);
    if (descriptor_ != -1 || errno != ENOENT) break;
    if (::mkdir(path_.parent_path().c_str(), 0777) == -1 && errno != EEXIST) break;  // the folder was removed just now
  }
  if (descriptor_ == -1) fail(path_, errno);
  struct stat facts {};
  if (::fstat(descriptor_, &facts) == 0 && S_ISREG(facts.st_mode)) return;
  ::close(descriptor_);
  throw Failure(Exit::input_output, "{}: lock file is not a regular file; remove it", path_.string());
}

LockFile::~LockFile() { ::close(descriptor_); }

bool LockFile::try_lock(Sharing sharing) {
  if (::flock(descriptor_, (sharing == Sharing::shared ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0) return true;
  unsupported_ = errno == EOPNOTSUPP || errno == ENOLCK || errno == ENOSYS;
  if (!unsupported_ && errno != EWOULDBLOCK) fail(path_, errno);
  return unsupported_;
}

void LockFile::unlock() { ::flock(descriptor_, LOCK_UN); }

}  // namespace bezierbench::bundle
