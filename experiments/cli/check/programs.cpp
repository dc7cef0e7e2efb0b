// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "experiments/bundle/bundle.hpp"
#include "experiments/cli/check/report.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/compare/join.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/tables/table_row.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {
namespace {

namespace fs = std::filesystem;

struct Ended {
  int code;  ///< as a shell gives it: 128 + the number of the signal that ended the process
  std::string output;
};

/// Runs a command line of the shell.
Ended run_line(const std::string& line) {
  std::FILE* const pipe = popen(line.c_str(), "re");
  if (pipe == nullptr) throw std::system_error(errno, std::generic_category(), "popen");
  Ended ended{0, ""};
  std::array<char, 4096> piece{};
  while (const auto count = std::fread(piece.data(), 1, piece.size(), pipe)) ended.output.append(piece.data(), count);
  const int status = pclose(pipe);
  ended.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  if (run::interrupted() || ended.code == static_cast<int>(Exit::interrupted))
    throw Failure(Exit::interrupted, "check: interrupted; run the same command again");
  return ended;
}

/// The line that git prints; empty where it fails.
std::string git(const std::string& arguments) {
  const auto ended = run_line("git " + arguments + " 2>/dev/null");
  return ended.code == 0 ? ended.output.substr(0, ended.output.find('\n')) : "";
}

fs::path cache_folder() {
  for (const auto& [name, below] :
       {std::pair("XDG_CACHE_HOME", "bezierbench"), std::pair("HOME", ".cache/bezierbench")})
    if (const char* folder = std::getenv(name); folder != nullptr && *folder != '\0') return fs::path(folder) / below;
  throw Failure(Exit::environment, "neither XDG_CACHE_HOME nor HOME is set; set one, since a commit is built below it");
}

/// The program of a commit.
Against build(const std::string& id, const std::string& repository, bool quiet) {
  constexpr std::size_t enough_digits = 12;
  const auto name = "commit " + id.substr(0, enough_digits);
  const auto folder = cache_folder() / "commits" / id;
  const auto log = folder.string() + ".log";
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  if (error)
    throw Failure(Exit::input_output, "{}: cannot be created: {}; set XDG_CACHE_HOME to another folder",
                  folder.parent_path().string(), error.message());
  if (!quiet)
    say(fmt::format("builds {} in {}, output in {}; the first build may take an hour", name, folder.string(), log));
  const auto steps = fmt::format(
      "exec >>{log} 2>&1; set -ex\n"
      "test -d {folder} || git clone --quiet --no-checkout {repository} {folder}\n"
      "cd {folder}; git checkout --quiet --detach {id}\n"
      "cmake --preset release -DBEZIERBENCH_TESTS=OFF; cmake --build build/release --target bezierbench\n",
      fmt::arg("log", shell_word(log)), fmt::arg("folder", shell_word(folder.string())),
      fmt::arg("repository", shell_word(repository)), fmt::arg("id", id));
  if (run_line(steps).code != 0) throw Failure(Exit::environment, "{}: cannot be built; see {}", name, log);
  return {.is_bundle = false, .name = name, .program = {folder / "build/release/bezierbench"}};
}

}  // namespace

Against find_against(const std::string& word, const TestedProgram& now, const suite::ExternalMethod* method,
                     bool quiet) {
  std::error_code error;
  if (fs::is_directory(word, error)) return {.is_bundle = true, .name = word, .bundle = word};
  if (method != nullptr && method->kind == suite::ExternalKind::program)
    return {.is_bundle = false, .name = word, .program = {now.path, {"--program", word}}};
  if (fs::is_regular_file(word, error)) {
    if (method != nullptr && method->kind == suite::ExternalKind::plugin && word.ends_with(".so"))
      return {.is_bundle = false, .name = word, .program = {now.path, {"--plugin", word}}};
    return {.is_bundle = false, .name = word, .program = {fs::absolute(word), now.arguments}};
  }
  const auto repository = git("rev-parse --show-toplevel");
  const auto commit = word.starts_with('-') ? "" : git("rev-parse --verify --quiet " + shell_word(word + "^{commit}"));
  if (repository.empty() || commit.empty())
    throw Failure(Exit::usage,
                  "--against {}: is not a file, a folder or a commit of the repository here; name a program, a bundle "
                  "or a commit",
                  echo(word));
  auto against = build(commit, repository, quiet);
  against.program.arguments = now.arguments;
  return against;
}

void run_suite(const TestedProgram& program, const fs::path& suite, const fs::path& out,
               std::vector<std::string> more) {
  const auto& path = program.path;
  if (access(path.c_str(), X_OK) != 0)
    throw Failure(Exit::usage, "{}: cannot be started; name a bezierbench, a bundle or a commit", path.string());
  more.insert(more.end(), program.arguments.begin(), program.arguments.end());
  auto line = fmt::format("exec {} run {} --out {} --quiet", shell_word(path.string()), shell_word(suite.string()),
                          shell_word(out.string()));
  for (const auto& word : more) line += ' ' + shell_word(word);
  const auto ended = run_line(line);
  if (ended.code != static_cast<int>(Exit::fine) && ended.code != static_cast<int>(Exit::finding))
    throw Failure(Exit::usage,
                  "{}: `run` of the method's cells ended with exit code {}; name a bezierbench that has the method",
                  path.string(), ended.code);
}

namespace {

bundle::CsvDocument timed(const TestedProgram& program, const Programs& programs) {
  const auto out = programs.scratch / "times";
  fs::remove_all(out);
  run_suite(program, programs.suite, out, {});
  const auto directory = bundle::BundleDirectory::open(out);
  return bundle::parse_csv(directory.read_listed(compare::timing_file), directory.place(compare::timing_file));
}

}  // namespace

metric::Interval PairedTimes::ratio() const {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < before.size(); ++k) ratios.push_back(after[k] / before[k]);
  return metric::median_interval(ratios, metric::timing_confidence);
}

metric::Verdict PairedTimes::verdict() const {
  return metric::covers_median(before.size(), metric::timing_confidence) ? metric::verdict(ratio())
                                                                         : metric::Verdict::unresolved;
}

std::string PairedTimes::quality() const {
  if (!checked) return "unchecked";
  return metric::covers_median(before.size(), metric::timing_confidence) ? "ok" : "few_rounds";
}

std::map<compare::Inputs, PairedTimes> paired_times(const Programs& programs, const std::string& method, int pairs) {
  std::map<compare::Inputs, PairedTimes> times;
  for (int pair = 0; pair < pairs; ++pair) {
    const bool before_first = pair % 2 == 0;
    const auto first = timed(before_first ? programs.before : programs.after, programs);
    const auto second = timed(before_first ? programs.after : programs.before, programs);
    const auto& before = before_first ? first : second;
    const auto& after = before_first ? second : first;
    for (const auto& row : compare::join(*bundle::declared_table(compare::timing_file), before, after).pairs) {
      if (row.inputs.field("method") != method) continue;
      auto& time = times[row.inputs];
      time.before.push_back(tables::TableRow(before, row.a).number("median_ns"));
      time.after.push_back(tables::TableRow(after, row.b).number("median_ns"));
      time.checked = time.checked && after.at(row.b, "checked") == "yes";
    }
  }
  return times;
}

}  // namespace bezierbench::cli
