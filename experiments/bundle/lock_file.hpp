// SPDX-License-Identifier: MIT
// Locks that end with the process that holds them, however it ends.
#pragma once

#include <filesystem>

namespace bezierbench::bundle {

enum class Sharing { shared, exclusive };

/// A file to be locked. The lock is the kernel's (flock), so that a killed process leaves none behind; on a network
/// file system the server releases it when the client is gone.
class LockFile {
 public:
  /// Opens the file. Makes the file and its folder where they are absent: other processes may remove the folder at any
  /// time. Throws Failure(Exit::input_output).
  explicit LockFile(std::filesystem::path path);
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;
  LockFile(LockFile&&) = delete;
  LockFile& operator=(LockFile&&) = delete;

  /// Tries to get the lock without waiting and returns whether this process has it. True also where the file system has
  /// no locks. Throws Failure(Exit::input_output).
  [[nodiscard]] bool try_lock(Sharing sharing);
  void unlock();
  /// Whether try_lock() found that the file system has no locks.
  [[nodiscard]] bool unsupported() const { return unsupported_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  bool unsupported_ = false;
};

}  // namespace bezierbench::bundle
