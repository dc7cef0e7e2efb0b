// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/callgrind.hpp"

#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): SIGILL beside POSIX signals
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is not in <cstdlib>
#include <unistd.h>

#include <filesystem>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/external/child.hpp"
#include "experiments/failure.hpp"
#include "experiments/race/counts.hpp"
#include "experiments/race/processor_models.hpp"
#include "experiments/run/interruption.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* variable = "BEZIERBENCH_COUNTS";
constexpr const char* valgrind = "valgrind";
constexpr int not_started = 127;  // as in a shell

/// The words of this process's command line, without the program.
std::vector<std::string> own_arguments() {
  const auto text = bundle::read_file("/proc/self/cmdline");
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size(); at = text.find('\0', at) + 1) words.emplace_back(text.c_str() + at);
  words.erase(words.begin());
  return words;
}

/// A new folder for Callgrind's files, removed at the end.
class Folder {
 public:
  Folder() : path_((fs::temp_directory_path() / "bezierbench-counts-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr)
      throw Failure(Exit::input_output, "{}: cannot be created; set TMPDIR to another folder", path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The words as execvp takes them, which end with a null.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  all.reserve(words.size() + 1);
  for (auto& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

std::string own_program() { return fs::read_symlink("/proc/self/exe").string(); }

/// Becomes Valgrind. Of the environment it keeps only where programs and libraries are, since its size moves the
/// stack.
[[noreturn]] void become_callgrind(const std::string& folder) {
  std::vector<std::string> words{valgrind};
  words.insert(words.end(), std::begin(race::callgrind_options), std::end(race::callgrind_options));
  words.push_back("--callgrind-out-file=" + folder + "/counts.%p");
  words.push_back(own_program());
  for (auto& word : own_arguments()) words.push_back(std::move(word));
  std::vector<std::string> environment{fmt::format("{}=yes", variable)};
  for (const char* kept : {"PATH", "LD_LIBRARY_PATH", "TMPDIR", "HOME"})
    if (const char* value = std::getenv(kept)) environment.push_back(fmt::format("{}={}", kept, value));
  execvpe(valgrind, pointers(words).data(), pointers(environment).data());
  _exit(not_started);
}

constexpr external::Limits limits{.seconds = 3600, .megabytes = 16384};
constexpr std::size_t max_output = std::size_t{1} << 30U;

/// One of LLVM's programs, to its end.
std::string run_llvm(std::vector<std::string> command, const std::string& input) {
  const auto work = [&] {
    execvp(command[0].c_str(), pointers(command).data());
    _exit(not_started);
  };
  auto ended = external::run_in_child(work, input, max_output, limits, run::interrupted);
  if (ended.end != external::End::exited || ended.code != 0)
    throw Failure(Exit::environment, "{} failed: {}", command[0],
                  echo(ended.errors.empty() ? "it was stopped" : ended.errors));
  return std::move(ended.output);
}

/// Adds what LLVM's models of other processors predict. Where they cannot, one line says why.
void add_cycles(std::vector<std::string>& files) {
  try {
#if !defined(__x86_64__)
    throw Failure(Exit::environment, "only the code of x86-64 is modelled");
#endif
    for (const char* program : {race::disassembler, race::simulator})
      if (!folder_on_path(program)) throw Failure(Exit::environment, "{} is not installed; install llvm-19", program);
    race::add_cycles(files, own_program(), run_llvm);
  } catch (const std::exception& error) {  // of numbers, too, where LLVM's output is not what is expected
    if (!run::interrupted()) say(fmt::format("no cycles of other processors: {}", error.what()));
  }
}

}  // namespace

std::string why_uncounted() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return "a program with sanitizers does not run under Valgrind; build preset release";
#endif
  if (!folder_on_path(valgrind)) return "Valgrind is not installed; install it and build again";
  return race::can_count() ? "" : "the program was built without Valgrind's headers; install valgrind and build again";
}

std::vector<std::string> counts_by_callgrind() {
  const Folder folder;
  const auto ended =
      external::run_in_child([&] { become_callgrind(folder.path()); }, {}, max_output, limits, run::interrupted);
  if (ended.end == external::End::interrupted) return {};
  if (ended.end == external::End::signalled && ended.code == SIGILL)
    throw Failure(Exit::environment,
                  "--counts: Valgrind does not know an instruction of this build; build it without -march=native");
  if (ended.end != external::End::exited || ended.code != 0)
    throw Failure(Exit::environment, "--counts: {} failed: {}; leave --counts out", valgrind,
                  echo(ended.errors.empty() ? "it was stopped" : ended.errors));
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder.path())) files.push_back(bundle::read_file(entry.path()));
  add_cycles(files);
  return files;
}

bool is_to_count() { return std::getenv(variable) != nullptr && race::runs_under_valgrind(); }

}  // namespace bezierbench::cli
