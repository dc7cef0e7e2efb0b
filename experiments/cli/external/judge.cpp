// SPDX-License-Identifier: MIT
// `judge`: the errors of answers to what `inputs` wrote, as accuracy.csv has them.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/external/external_options.hpp"
#include "experiments/cli/external/inputs.hpp"
#include "experiments/cli/startup/curve_sets.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/studies/external/external.hpp"

namespace bezierbench::cli {
namespace {

struct JudgeOptions {
  std::string file;
  std::optional<std::string> id;
  std::optional<std::string> out;
};

/// Prints the rows of accuracy.csv; a status that is not ok is a finding.
Exit print_rows(const run::RunRequest& request, const external::Method& method) {
  tables::Tables tables;
  for (const auto& one : request.suites)
    for (const auto& written : one.studies)
      for (const auto& study : sample::studies_of(written)) {
        const auto job = studies::external_job(study, method.record(), &method, {one.seed, request.tier});
        if (!job) continue;
        run::run_all(*job);
        job->write(tables);
      }
  const auto& table = tables.table("accuracy.csv");
  fmt::print("{}", table.text());
  const auto is_ok = [](const tables::Row& row) { return row.field("status") == tables::field("ok"); };
  return std::ranges::all_of(table.rows(), is_ok) ? Exit::fine : Exit::finding;
}

Exit judge(const JudgeOptions& options) {
  const external::Methods methods{read_answers(options.file, options.id)};
  auto request = request_of_this_build(methods);
  const auto table = bundle::parse_csv(bundle::read_file(options.file), options.file);
  request.suites = suites_of(table, methods.front()->record().id);
  auto findings = foreign_inputs(table, request.suites);
  if (!options.out) return std::max(print_rows(request, *methods.front()), say_findings(findings));
  if (options.out->empty()) throw Failure(Exit::usage, "--out: is empty; name a folder");
  request.curve_files = curves_beside(request.suites);
  request.out = *options.out;
  request.telling = run::Telling::nothing;
  const auto of_run = run::run(request).findings;
  findings.insert(findings.end(), of_run.begin(), of_run.end());
  return say_findings(findings);
}

}  // namespace

void add_judge(Command program, Exit& exit) {
  auto options = std::make_shared<JudgeOptions>();
  auto command = program.command("judge", "judge answers that were computed elsewhere");
  command.option("FILE", options->file, "the file that `inputs` wrote, with the answers in the columns x, y and z")
      .required()
      .takes(file_value);
  command.option("--id", options->id, "id of the method, answers_NAME; default: from the name of the file");
  command.option("--out", options->out, "write a bundle to this folder; default: print the rows of accuracy.csv")
      .takes(folder_value);
  command.action([options, &exit] { exit = judge(*options); });
}

}  // namespace bezierbench::cli
