// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/callgrind.hpp"

#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): SIGILL beside POSIX signals
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is not in <cstdlib>
#include <unistd.h>

#include <filesystem>
#include <string_view>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/external/child.hpp"
#include "experiments/failure.hpp"
#include "experiments/race/counts.hpp"
#include "experiments/run/interruption.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* variable = "BEZIERBENCH_COUNTS";
constexpr const char* valgrind = "valgrind";

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
      throw Failure(Exit::input_output, fmt::format("{}: cannot be created; set TMPDIR to another folder", path_));
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

/// Becomes Valgrind. Of the environment it keeps only where programs and libraries are, since its size moves the
/// stack.
[[noreturn]] void become_callgrind(const std::string& folder) {
  std::vector<std::string> words{valgrind};
  words.insert(words.end(), std::begin(race::callgrind_options), std::end(race::callgrind_options));
  words.push_back("--callgrind-out-file=" + folder + "/counts.%p");
  words.push_back(fs::read_symlink("/proc/self/exe").string());
  for (auto& word : own_arguments()) words.push_back(std::move(word));
  std::vector<std::string> environment{fmt::format("{}=yes", variable)};
  for (const char* kept : {"PATH", "LD_LIBRARY_PATH", "TMPDIR", "HOME"})
    if (const char* value = std::getenv(kept)) environment.push_back(fmt::format("{}={}", kept, value));
  const auto pointers = [](std::vector<std::string>& texts) {
    std::vector<char*> all;
    for (auto& text : texts) all.push_back(text.data());
    all.push_back(nullptr);
    return all;
  };
  execvpe(valgrind, pointers(words).data(), pointers(environment).data());
  _exit(127);  // NOLINT(readability-magic-numbers): as a shell does
}

}  // namespace

std::string why_uncounted() {
  if (!folder_on_path(valgrind)) return "Valgrind is not installed";
  return race::can_count() ? "" : "the program was built without Valgrind's headers";
}

std::vector<std::string> counts_by_callgrind() {
  const Folder folder;
  constexpr external::Limits limits{.seconds = 3600, .megabytes = 16384};
  constexpr std::size_t max_output = std::size_t{1} << 30U;
  const auto ended =
      external::run_in_child([&] { become_callgrind(folder.path()); }, {}, max_output, limits, run::interrupted);
  if (ended.end == external::End::interrupted) return {};
  if (ended.end == external::End::signalled && ended.code == SIGILL)
    throw Failure(Exit::environment,
                  "--counts: Valgrind does not know an instruction of this build; build it without -march=native");
  if (ended.end != external::End::exited || ended.code != 0)
    throw Failure(Exit::environment, fmt::format("--counts: {} failed: {}; leave --counts out", valgrind,
                                                 echo(ended.errors.empty() ? "it was stopped" : ended.errors)));
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder.path())) files.push_back(bundle::read_file(entry.path()));
  return files;
}

bool is_to_count() { return std::getenv(variable) != nullptr && race::runs_under_valgrind(); }

}  // namespace bezierbench::cli
