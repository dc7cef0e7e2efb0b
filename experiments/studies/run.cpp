// SPDX-License-Identifier: MIT
#include "experiments/studies/run.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/manifest.hpp"
#include "experiments/failure.hpp"
#include "experiments/studies/interruption.hpp"
#include "experiments/studies/progress.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/scorecard.hpp"
#include "experiments/suite/writer.hpp"
#include "experiments/timing/counters.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::string_view complete = "complete";
constexpr std::string_view partial = "partial";

using Jobs = std::vector<std::unique_ptr<Job>>;

std::vector<suite::Study> studies_of(const RunRequest& request) {
  std::vector<suite::Study> studies;
  for (const auto& one : request.suites) studies.insert(studies.end(), one.studies.begin(), one.studies.end());
  return studies;
}

Jobs plan(const RunRequest& request) {
  Jobs jobs;
  for (const auto& one : request.suites)
    for (const auto& study : one.studies) jobs.push_back(make_job(study, {one.seed, request.tier}));
  return jobs;
}

bundle::Manifest manifest_of(const RunRequest& request, const std::string& suite_text) {
  bundle::Manifest manifest;
  manifest.schema_version = 1;
  for (const auto& one : request.suites) manifest.suites.push_back(one.id);
  manifest.suite_digest = bundle::sha256_hex(suite_text);
  manifest.seed = request.suites.front().seed;
  manifest.state = partial;
  manifest.program_version = request.build.program_version;
  manifest.git_commit = request.git_commit;
  manifest.git_clean = request.git_clean;
  manifest.fp_flags = request.build.fp_flags;
  return manifest;
}

/// Refuses a bundle of other suites, seed or build, naming both.
void require_same(const std::string& path, const bundle::Manifest& theirs, const bundle::Manifest& ours) {
  const auto refuse = [&](std::string_view what, const auto& a, const auto& b) {
    throw Failure(Exit::usage,
                  fmt::format("{}: holds results of {} {}, this run has {}; choose another --out or move it away", path,
                              what, a, b));
  };
  if (theirs.seed != ours.seed) refuse("seed", theirs.seed, ours.seed);
  if (theirs.suite_digest != ours.suite_digest)
    refuse("resolved suite", fmt::format("{} ({})", fmt::join(theirs.suites, "+"), theirs.suite_digest.substr(0, 12)),
           fmt::format("{} ({})", fmt::join(ours.suites, "+"), ours.suite_digest.substr(0, 12)));
  if (theirs.program_version != ours.program_version)
    refuse("program version", theirs.program_version, ours.program_version);
  if (theirs.git_commit != ours.git_commit) refuse("commit", theirs.git_commit, ours.git_commit);
  if (theirs.fp_flags != ours.fp_flags) refuse("floating-point flags", theirs.fp_flags, ours.fp_flags);
}

void describe(const RunRequest& request, const Jobs& jobs, bool already_complete) {
  Extent extent;
  for (const auto& job : jobs) extent += job->extent();
  constexpr double evaluations_per_second = 1.5e6;  // one thread, judged, degree 20: an order of magnitude
  constexpr std::size_t bytes_per_row = 300;
  constexpr double megabyte = 1e6;
  fmt::print(
      "studies      {}\ncells        {}\nevaluations  {}\nestimated    {:.0f} s on one thread, {:.1f} MB of disk, "
      "{:.0f} MB of memory\nout          {}{}\n",
      jobs.size(), extent.cells, extent.evaluations, static_cast<double>(extent.evaluations) / evaluations_per_second,
      static_cast<double>(extent.rows * bytes_per_row) / megabyte, static_cast<double>(extent.memory) / megabyte,
      request.out.string(), already_complete ? " (already complete)" : "");
}

void run_blocks(const RunRequest& request, const Jobs& jobs) {
  std::vector<Job*> shared;
  std::vector<std::size_t> ends;  // of their blocks, numbered through; a list of all blocks might not fit in memory
  double total = 0;
  for (const auto& job : jobs) {
    total += job->total_cost();
    if (job->exclusive() || job->blocks() == 0) continue;
    shared.push_back(job.get());
    ends.push_back((ends.empty() ? 0 : ends.back()) + job->blocks());
  }
  Progress progress(total, request.quiet);
  const auto run_one = [&](Job& job, std::size_t block) {
    if (interrupted()) return;
    job.run_block(block);
    progress.add(job.cost(block));
  };
  const auto threads = request.jobs > 0 ? static_cast<std::size_t>(request.jobs)
                                        : static_cast<std::size_t>(tbb::info::default_concurrency());
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto run_range = [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t k = range.begin(); k < range.end() && !interrupted(); ++k) {
        const auto job = static_cast<std::size_t>(std::ranges::upper_bound(ends, k) - ends.begin());
        run_one(*shared[job], k - (job == 0 ? 0 : ends[job - 1]));
      }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, ends.empty() ? 0 : ends.back()), run_range);
  }
  for (const auto& job : jobs)
    for (std::size_t number = 0; job->exclusive() && number < job->blocks(); ++number) run_one(*job, number);
  if (interrupted())
    throw Failure(Exit::interrupted,
                  fmt::format("{}: interrupted before the results were complete; run the same command again",
                              request.out.string()));
}

Findings findings_of(const Jobs& jobs) {
  Findings findings;
  for (const auto& job : jobs)
    for (const auto& violation : job->violations())
      findings.push_back(fmt::format("bound violated {} times: {}", violation.count, violation.where));
  return findings;
}

}  // namespace

Findings run(const RunRequest& request) {
  const Jobs jobs = plan(request);
  const std::string suite_text = suite::to_toml(request.suites);
  bundle::Manifest manifest = manifest_of(request, suite_text);
  std::error_code ignored;  // a place that cannot be looked at cannot be made either, which says why
  const bool exists = std::filesystem::exists(request.out / "bundle.json", ignored);
  bool done = false;
  if (exists) {
    const auto theirs =
        bundle::parse_manifest(bundle::read_file(request.out / "bundle.json"), (request.out / "bundle.json").string());
    require_same(request.out.string(), theirs, manifest);
    done = theirs.state == complete;
  }
  if (request.dry_run) {
    describe(request, jobs, done);
    return {};
  }
  if (done) {
    if (!request.quiet) std::fputs((request.out.string() + ": already complete, nothing to do\n").c_str(), stderr);
    return {};
  }
  auto directory = bundle::BundleDirectory::create(request.out);
  directory.write("suite.toml", suite_text);
  directory.write("machine.json", bundle::machine_json(request.build, timing::Counters().state()));
  directory.write("methods.csv", request.methods_csv);
  directory.finish(manifest);  // says `partial` until the work is done

  run_blocks(request, jobs);

  Tables tables;
  std::vector<Series> series;
  for (const auto& job : jobs) {
    job->write(tables);
    for (auto& one : job->series()) series.push_back(std::move(one));
  }
  write_scorecards(studies_of(request), series, tables);
  for (const auto& [file, table] : tables.all()) directory.write(file, table.text());
  manifest.state = complete;
  directory.finish(manifest);
  return findings_of(jobs);
}

}  // namespace bezierbench::studies
