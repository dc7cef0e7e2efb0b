// SPDX-License-Identifier: MIT
#include "experiments/run/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/check/few_lines.hpp"
#include "experiments/bundle/check/method_digest.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/folder.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/pattern.hpp"
#include "experiments/suite/text/writer.hpp"
#include "experiments/tables/choices.hpp"
#include "experiments/tables/scorecard.hpp"
#include "experiments/tables/timed_checks.hpp"

namespace bezierbench::run {
namespace {

std::vector<suite::Study> studies_of(const RunRequest& request) {
  std::vector<suite::Study> studies;
  for (const auto& one : request.suites) studies.insert(studies.end(), one.studies.begin(), one.studies.end());
  return studies;
}

bundle::Manifest manifest_of(const RunRequest& request, const std::string& suite_text) {
  bundle::Manifest manifest;
  for (const auto& one : request.suites) manifest.suites.push_back(one.id);
  manifest.suite_digest = bundle::sha256_hex(suite_text);
  manifest.seed = request.suites.front().seed;
  manifest.state = bundle::partial;
  manifest.program_version = request.build.program_version;
  manifest.git_commit = request.git_commit;
  manifest.git_clean = request.git_clean;
  manifest.fp_flags = request.build.fp_flags;
  return manifest;
}

/// The study without the names of external methods; empty where it names no other.
std::optional<suite::Study> with_own_methods(suite::Study study) {
  const bool names_some = !study.methods.empty();
  std::erase_if(study.methods, [](const auto& id) { return suite::is_external(id); });
  if (names_some && study.methods.empty()) return std::nullopt;
  return study;
}

/// The jobs of a study for external methods: of those that it names, if it names any, else of all. Throws
/// Failure(usage) where none that it names can be asked for its inputs.
void add_external_jobs(const RunRequest& request, const suite::Study& study, const JobContext& context, Plan& plan) {
  const auto named = std::ranges::find_if(study.methods, suite::is_external);
  const bool names_some = named != study.methods.end();
  const auto before = plan.jobs.size();
  for (const auto& method : request.external) {
    const auto means = [&](const std::string& entry) {
      return suite::is_external(entry) && suite::matches(entry, method.id);
    };
    if (!request.kinds.make_external_job) continue;
    if (names_some && std::ranges::none_of(study.methods, means)) {
      plan.unasked.push_back({method.id, study.id, "it names other external methods"});
      continue;
    }
    auto job = request.kinds.make_external_job(study, method, context);
    if (!job) {
      plan.unasked.push_back({method.id, study.id, request.kinds.why_unasked(study, method)});
      continue;
    }
    plan.jobs.push_back(std::move(job));
    plan.job_names.push_back(study.id + ", " + method.id);
  }
  if (names_some && plan.jobs.size() == before)
    suite::refuse(study, {"methods", static_cast<std::size_t>(named - study.methods.begin()), "kind",
                          fmt::format("method \"{}\" is external and not available in this study, because of its "
                                      "kind, form or scalar; remove it",
                                      *named)});
}

void add(const Violation& violation, Outcome& outcome) {
  const auto& [where, count, what] = violation;
  switch (what) {
    case Broken::bound:
      outcome.violations += count;
      outcome.findings.push_back(fmt::format("bound violated {} times: {}", count, where));
      break;
    case Broken::promise:
      outcome.broken_promises += count;
      outcome.findings.push_back(fmt::format("promise broken {} times: {}", count, where));
      break;
    case Broken::proof:
      outcome.refuted_proofs += count;
      outcome.findings.push_back(fmt::format("proof refuted: {}", where));
      break;
  }
}

/// Finds times of external methods that did not give the results that were judged, in every table of times. Among our
/// own some are as printed and wrong, or keep no tolerance, which their rows say.
void find_unchecked_times(const tables::Tables& tables, Outcome& outcome) {
  for (const auto& [file, table] : tables.all()) {
    if (bundle::declared_table(file)->column("checked") == nullptr) continue;
    bundle::FewLines lines(file);
    const auto document = bundle::parse_csv(table.text(), file);
    for (std::size_t row = 0; row < document.row_count(); ++row)
      if (document.at(row, "checked") == "no" && suite::is_external(document.at(row, "method")))
        lines.add(
            fmt::format("what was timed did not give what was judged: study {}, method {}, degree {}, mode {}; "
                        "see {}:{}",
                        document.at(row, "study"), document.at(row, "method"), document.at(row, "degree"),
                        document.at(row, "mode"), file, document.line(row)));
    for (auto& line : lines.take()) outcome.findings.push_back(std::move(line));
  }
}

void count_times(const tables::Tables& tables, Outcome& outcome) {
  const auto timing = tables.all().find("timing.csv");
  if (timing == tables.all().end()) return;
  const auto document = bundle::parse_csv(timing->second.text(), timing->first);
  outcome.times = document.row_count();
  for (std::size_t row = 0; row < outcome.times; ++row)
    if (document.at(row, "quality") == "noisy") ++outcome.noisy;
}

}  // namespace

Plan::Plan(const RunRequest& request)
    : suite_text(suite::to_toml(request.suites) + suite::to_toml(request.external)),
      manifest(manifest_of(request, suite_text)),
      reference(reference::name(request.tier)) {
  for (const auto& one : request.suites)
    for (const auto& study : one.studies)
      if (auto own = with_own_methods(study); own) studies.push_back({std::move(*own), {one.seed, request.tier}});
  for (const auto& [study, context] : studies) {
    jobs.push_back(request.kinds.make_job(study, context));
    job_names.push_back(study.id);
  }
  // Last, so that no row of another method is elsewhere than without them.
  for (const auto& one : request.suites)
    for (const auto& study : one.studies) add_external_jobs(request, study, {one.seed, request.tier}, *this);
}

void tell_unasked(const RunRequest& request, const Plan& plan) {
  const auto all = studies_of(request).size();
  for (const auto& method : request.external) {
    std::map<std::string, std::vector<std::string>> studies;  // by reason
    std::size_t count = 0;
    for (const auto& [id, study, why] : plan.unasked)
      if (id == method.id) {
        studies[why].push_back(study);
        ++count;
      }
    const auto sentence = [](const auto& one) {
      return fmt::format("stud{} {}: {}", one.second.size() == 1 ? "y" : "ies", fmt::join(one.second, ", "), one.first);
    };
    if (count == all)
      throw Failure(Exit::usage,
                    fmt::format("{}: no study asks it, of {}; choose a suite with a study of kind accuracy "
                                "for its form of curves, in double",
                                method.id, sentence(*studies.begin())));
    if (request.telling != Telling::nothing)
      for (const auto& one : studies) note(fmt::format("{}: is not asked in {}", method.id, sentence(one)));
  }
}

std::optional<std::string> difference(const bundle::Manifest& theirs, const bundle::Manifest& ours) {
  const auto both = [](std::string_view what, const auto& a, const auto& b) {
    return fmt::format("{} {}, this run has {}", what, a, b);
  };
  const auto suites = [](const bundle::Manifest& manifest) {
    return fmt::format("{} ({})", fmt::join(manifest.suites, "+"), manifest.suite_digest.substr(0, 12));
  };
  if (theirs.seed != ours.seed) return both("seed", theirs.seed, ours.seed);
  if (theirs.suite_digest != ours.suite_digest) return both("resolved suite", suites(theirs), suites(ours));
  if (theirs.program_version != ours.program_version)
    return both("program version", theirs.program_version, ours.program_version);
  if (theirs.git_commit != ours.git_commit) return both("commit", theirs.git_commit, ours.git_commit);
  const auto source = [](const bundle::Manifest& manifest) {
    return fmt::format("{}{}", manifest.git_commit, manifest.git_clean ? " unmodified" : " with modifications");
  };
  if (theirs.git_clean != ours.git_clean) return both("commit", source(theirs), source(ours));
  if (theirs.fp_flags != ours.fp_flags) return both("floating-point flags", theirs.fp_flags, ours.fp_flags);
  return std::nullopt;
}

std::optional<bundle::Manifest> existing(const RunRequest& request, const Plan& plan) {
  const auto path = request.out / bundle::manifest_name;
  std::error_code ignored;  // if the folder cannot be read, making it fails with the reason
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, ignored))) return std::nullopt;
  const auto theirs = bundle::parse_manifest(bundle::read_bundle_file(path), path.string());
  if (const auto why = difference(theirs, plan.manifest))
    throw Failure(Exit::usage, fmt::format("{}: holds results of {}; choose another --out or move it away",
                                           request.out.string(), *why));
  return theirs;
}

std::vector<std::pair<std::string, std::string>> lists_of(const RunRequest& request) {
  return {{"methods.csv", request.methods_csv}, {"generators.csv", request.generators_csv}};
}

void refuse_foreign(const RunRequest& request, const std::function<bool(const std::string&)>& is_table) {
  std::vector<std::string> own{std::string(bundle::manifest_name),
                               std::string(bundle::sums_name),
                               std::string(bundle::blocks_name),
                               bundle::digests_name,
                               suite_name,
                               machine_name};
  for (const auto& list : lists_of(request)) own.push_back(list.first);
  const auto found = bundle::list_folder(request.out);
  for (const auto* names : {&found.files, &found.others})
    for (const auto& name : *names)
      if (!name.starts_with('.') && std::ranges::find(own, name) == own.end() && !is_table(name))
        throw Failure(Exit::input_output,
                      fmt::format("{}: is nothing that this run writes; move it away, or choose another --out",
                                  (request.out / name).string()));
}

void require_same(const Found& found, const Plan& ours, Exit exit) {
  for (const auto& [path, file] : found.readable) {
    auto why = difference(file.manifest, ours.manifest);
    if (!why && file.reference != ours.reference)
      why = fmt::format("reference {}, this run has {}", file.reference, ours.reference);
    if (why)
      throw Failure(
          exit, fmt::format("{}: holds blocks of {}; remove the file or choose another --out", path.string(), *why));
  }
}

std::size_t cells_of(const Jobs& jobs) {
  std::size_t sum = 0;
  for (const auto& job : jobs) sum += job->extent().cells;
  return sum;
}

Outcome outcome_of(const Jobs& jobs, const tables::Tables& tables) {
  Outcome outcome;
  outcome.ending = Ending::complete;
  outcome.cells = cells_of(jobs);
  for (const auto& job : jobs)
    for (const auto& violation : job->violations()) add(violation, outcome);
  find_unchecked_times(tables, outcome);
  count_times(tables, outcome);
  return outcome;
}

tables::Tables written_tables(const RunRequest& request, const Plan& plan) {
  tables::Tables tables;
  std::vector<tables::Series> series;
  for (const auto& job : plan.jobs) {
    job->write(tables);
    for (auto& one : job->series()) series.push_back(std::move(one));
  }
  tables::write_scorecards(studies_of(request), series, tables);
  tables::check_timed_errors(tables);
  tables::write_pareto(tables);
  return tables;
}

void assemble(const RunRequest& request, const tables::Tables& tables, const Plan& plan,
              const bundle::BundleDirectory& directory) {
  refuse_foreign(request, [&](const std::string& name) { return tables.all().contains(name); });
  for (const auto& [file, table] : tables.all()) directory.write(file, table.text());
  bundle::Manifest manifest = plan.manifest;
  manifest.state = bundle::complete;
  directory.finish(manifest);
}

}  // namespace bezierbench::run
