// SPDX-License-Identifier: MIT
#include "experiments/run/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "experiments/bundle/check/verify.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/run/progress.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/validate.hpp"
#include "experiments/tables/choices.hpp"
#include "experiments/tables/table_row.hpp"
#include "experiments/tables/tables.hpp"

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

std::string name_of_job(const std::string& study, const std::string& external) { return study + ", " + external; }

/// The jobs of a study for external methods: of those that it names, if it names any, else of all. Throws
/// Failure(usage) where none that it names can be asked for its inputs.
void add_external_jobs(const RunRequest& request, const suite::Study& study, JobContext context, Plan& plan) {
  const auto named = std::ranges::find_if(study.methods, suite::is_external);
  const bool names_some = named != study.methods.end();
  const auto before = plan.jobs.size();
  std::string why = "it was not given";
  for (const auto& method : request.external) {
    const auto means = [&](const std::string& entry) {
      return suite::is_external(entry) && suite::matches(entry, method.id);
    };
    if (!request.kinds.make_external_job) continue;
    if (names_some && std::ranges::none_of(study.methods, means)) {
      plan.unasked.push_back({method.id, study.id, "it names other external methods"});
      continue;
    }
    context.number = plan.jobs.size();
    auto job = request.kinds.make_external_job(study, method, context);
    if (!job) {
      why = request.kinds.why_unasked(study, method);
      plan.unasked.push_back({method.id, study.id, why});
      continue;
    }
    plan.jobs.push_back(std::move(job));
    plan.job_names.push_back(name_of_job(study.id, method.id));
  }
  if (names_some && plan.jobs.size() == before)
    suite::refuse(
        study, {"methods", static_cast<std::size_t>(named - study.methods.begin()), "kind",
                fmt::format("method \"{}\" is external and not available in this study: {}; remove it", *named, why)});
}

/// Throws Failure(usage) for a study of curve sets whose methods take none of the curves.
void refuse_idle_studies(const Plan& plan) {
  std::map<std::string_view, std::pair<const suite::Study*, std::size_t>> rows;
  for (std::size_t k = 0; k < plan.studies.size(); ++k) {
    auto& [study, count] = rows[plan.studies[k].study.id];
    study = &plan.studies[k].study;
    count += plan.jobs[k]->extent().rows;
  }
  for (const auto& [id, of_study] : rows)
    if (of_study.first->slice && of_study.second == 0)
      suite::refuse(*of_study.first,
                    {"methods", 0, "curves", "none of its methods takes a curve of the sets; see `list methods`"});
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
    std::size_t line = 1;
    for (const auto& row : tables::rows_of(table)) {
      ++line;
      if (row.text("checked") == "no" && suite::is_external(row.text("method")))
        lines.add(fmt::format(
            "what was timed did not give what was judged: study {}, method {}, degree {}, mode {}; see "
            "{}:{}",
            row.text("study"), row.text("method"), text(row.field("degree")), row.text("mode"), file, line));
    }
    for (auto& found : lines.take()) outcome.findings.push_back(std::move(found));
  }
}

void count_times(const tables::Tables& tables, Outcome& outcome) {
  const auto* timing = tables.find("timing.csv");
  if (timing == nullptr) return;
  outcome.times = timing->row_count();
  std::vector<double> widths;
  for (const auto& row : tables::rows_of(*timing))
    if (const auto ratio = row.optional_number("ratio"); ratio && row.text("relative_to") != row.text("method"))
      widths.push_back((row.number("ratio_high") - row.number("ratio_low")) / *ratio);
  if (widths.empty()) return;
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::ranges::nth_element(widths, middle);
  outcome.ratio_width = *middle;
}

}  // namespace

Plan::Plan(const RunRequest& request)
    : suite_text(suite::to_toml(request.suites) + suite::to_toml(request.external)),
      manifest(manifest_of(request, suite_text)),
      reference(reference::name(request.tier)) {
  const auto each_study = [&](const auto& plan) {
    for (const auto& one : request.suites)
      for (const auto& written : one.studies)
        for (const auto& study : request.kinds.studies_of(written))
          plan(study,
               JobContext{
                   .seed = one.seed, .tier = request.tier, .number = jobs.size(), .count_jobs = request.count_jobs});
  };
  each_study([&](const suite::Study& study, const JobContext& context) {
    auto own = with_own_methods(study);
    if (!own) return;
    jobs.push_back(request.kinds.make_job(*own, context));
    job_names.push_back(study.id);
    studies.push_back({std::move(*own), context});
  });
  refuse_idle_studies(*this);
  // Last, so that no row of another method is elsewhere than without them.
  each_study(
      [&](const suite::Study& study, const JobContext& context) { add_external_jobs(request, study, context, *this); });
  // Of the forms and degrees of a curve set, a method may take some.
  std::erase_if(unasked, [&](const Unasked& one) {
    return std::ranges::find(job_names, name_of_job(one.study, one.method)) != job_names.end();
  });
  const auto same = [](const Unasked& a, const Unasked& b) { return a.method == b.method && a.study == b.study; };
  unasked.erase(std::unique(unasked.begin(), unasked.end(), same), unasked.end());
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
    if (count == all) {
      std::vector<std::string> sentences;
      for (const auto& one : studies) sentences.push_back(sentence(one));
      throw Failure(Exit::usage,
                    "{}: no study asks it, of {}; choose a suite with a study of its problem, for its form of curves, "
                    "degrees and precision",
                    method.id, fmt::join(sentences, ", of "));
    }
    if (!request.quiet)
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

std::vector<std::pair<std::string, std::string>> lists_of(const RunRequest& request) {
  std::vector<std::pair<std::string, std::string>> lists{{methods_name, request.methods_csv},
                                                         {generators_name, request.generators_csv}};
  lists.insert(lists.end(), request.curve_files.begin(), request.curve_files.end());
  return lists;
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

tables::Tables filled_tables(const RunRequest& request, const Plan& plan) {
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

bundle::Expected expected_of(std::span<const suite::Suite> suites) {
  bundle::Expected expected;
  expected.seed = suites.front().seed;
  for (const auto& suite : suites) {
    expected.suites.push_back(suite.id);
    for (const auto& study : suite.studies) expected.studies.push_back(study.id);
  }
  return expected;
}

}  // namespace bezierbench::run
