// SPDX-License-Identifier: MIT
#include "experiments/studies/plan.hpp"

#include <fmt/format.h>

#include "experiments/bundle/digest.hpp"
#include "experiments/studies/choices.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/scorecard.hpp"
#include "experiments/suite/writer.hpp"

namespace bezierbench::studies {
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

Findings findings_of(const Jobs& jobs) {
  Findings findings;
  for (const auto& job : jobs)
    for (const auto& violation : job->violations())
      findings.push_back(fmt::format("bound violated {} times: {}", violation.count, violation.where));
  return findings;
}

}  // namespace

Plan::Plan(const RunRequest& request)
    : suite_text(suite::to_toml(request.suites)),
      manifest(manifest_of(request, suite_text)),
      reference(reference::name(request.tier)) {
  for (const auto& one : request.suites)
    for (const auto& study : one.studies) jobs.push_back(make_job(study, {one.seed, request.tier}));
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
  if (theirs.fp_flags != ours.fp_flags) return both("floating-point flags", theirs.fp_flags, ours.fp_flags);
  return std::nullopt;
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

Findings assemble(const RunRequest& request, const Plan& plan, const bundle::BundleDirectory& directory) {
  Tables tables;
  std::vector<Series> series;
  for (const auto& job : plan.jobs) {
    job->write(tables);
    for (auto& one : job->series()) series.push_back(std::move(one));
  }
  write_scorecards(studies_of(request), series, tables);
  write_pareto(tables);
  for (const auto& [file, table] : tables.all()) directory.write(file, table.text());
  bundle::Manifest manifest = plan.manifest;
  manifest.state = bundle::complete;
  directory.finish(manifest);
  return findings_of(plan.jobs);
}

}  // namespace bezierbench::studies
