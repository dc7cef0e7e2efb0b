// SPDX-License-Identifier: MIT
// `report`: the process becomes scripts/report, which is Python and knows bundles as they are written.
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/suite_options.hpp"

namespace bezierbench::cli {
namespace {

struct ReportOptions {
  std::string bundle;
  std::optional<std::string> comparison;
  std::optional<std::string> out;
  bool summary = false;
};

[[noreturn]] void become_report(const ReportOptions& options) {
  std::vector<std::string> words{report_script().string()};
  if (options.comparison) words.push_back("--comparison=" + *options.comparison);
  if (options.out) words.push_back("--out=" + *options.out);
  if (options.summary) words.emplace_back("--summary");
  words.insert(words.end(), {"--", options.bundle});
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  throw Failure(Exit::environment, "{}: cannot be run ({}); install bash and python3", words[0],
                std::generic_category().message(errno));
}

}  // namespace

void add_report(Command program) {
  auto options = std::make_shared<ReportOptions>();
  auto command = program.command("report", "render pages, tables and figures from a bundle");
  command.option("BUNDLE", options->bundle, "folder of the bundle").required();
  command.option("--comparison", options->comparison, "folder that compare --out wrote").takes(folder_value);
  command.option("--out", options->out, "folder for the pages; default: BUNDLE-report").takes(folder_value);
  command.flag("--summary", options->summary, "print scorecard and findings as text, write nothing");
  command.action([options] { become_report(*options); });
}

}  // namespace bezierbench::cli
