// SPDX-License-Identifier: MIT
#include "experiments/cli/check/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "experiments/failure.hpp"
#include "experiments/run/interruption.hpp"

namespace bezierbench::cli {
namespace {

constexpr int ended_by_signal = 128;

/// An open file; -1 is none.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { reset(); }

  [[nodiscard]] int number() const { return number_; }
  void reset() {
    if (number_ >= 0) close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// The redirections of a new process.
class SpawnActions {
 public:
  SpawnActions() { posix_spawn_file_actions_init(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }

  void replace(int stream, int by) { posix_spawn_file_actions_adddup2(&actions_, by, stream); }
  void drop(int stream) { posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_WRONLY, 0); }
  void change_folder(const std::filesystem::path& folder) {
    if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> piece{};
  while (true) {
    const auto count = read(descriptor, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
}

int code_of(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? ended_by_signal + WTERMSIG(status) : WEXITSTATUS(status);
}

int open_log(const std::filesystem::path& log) {
  constexpr mode_t readable_by_all = 0644;
  const int number = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, readable_by_all);
  if (number < 0)
    throw Failure(Exit::input_output, fmt::format("{}: cannot be written: {}; free space or choose another place",
                                                  log.string(), std::generic_category().message(errno)));
  return number;
}

}  // namespace

Ended run_process(const std::vector<std::string>& words, const ProcessPlace& place) {
  std::array<int, 2> ends{-1, -1};
  if (place.log.empty() && pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe");
  const Descriptor reading(ends[0]);
  Descriptor writing(place.log.empty() ? ends[1] : open_log(place.log));
  SpawnActions actions;
  actions.change_folder(place.folder);
  actions.replace(STDOUT_FILENO, writing.number());
  if (!place.log.empty()) actions.replace(STDERR_FILENO, writing.number());
  if (place.silent) actions.drop(STDERR_FILENO);
  std::vector<char*> arguments;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t process = 0;
  const int fault = posix_spawnp(&process, arguments[0], actions.get(), nullptr, arguments.data(), environ);
  writing.reset();
  if (fault != 0) return {cannot_be_started, ""};
  Ended ended{0, place.log.empty() ? read_all(reading.number()) : ""};
  ended.code = code_of(process);
  if (run::interrupted() || ended.code == static_cast<int>(Exit::interrupted))
    throw Failure(Exit::interrupted, fmt::format("{}: interrupted; run the same command again", words.front()));
  return ended;
}

}  // namespace bezierbench::cli
