// SPDX-License-Identifier: MIT
// Who works here: locks that end with their process, however it ends.
#pragma once

#include <filesystem>

namespace bezierbench::bundle {

enum class Sharing { shared, exclusive };

/// A file to be locked. The lock is the kernel's (flock), so that a killed process leaves none behind; on a network
/// file system the server lets go of it when the client is gone.
class LockFile {
 public:
  /// Opens the file, and makes it where it is absent, its folder too: others may remove that at any moment. Throws
  /// Failure(Exit::input_output).
  explicit LockFile(std::filesystem::path path);
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;
  LockFile(LockFile&&) = delete;
  LockFile& operator=(LockFile&&) = delete;

  /// At once: is it ours now? True as well where the file system has no locks. Throws Failure(Exit::input_output).
  [[nodiscard]] bool try_lock(Sharing sharing);
  void unlock();
  /// Whether the file system turned out to have no locks.
  [[nodiscard]] bool unsupported() const { return unsupported_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  bool unsupported_ = false;
};

}  // namespace bezierbench::bundle
