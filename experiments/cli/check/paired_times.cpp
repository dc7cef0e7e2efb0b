// SPDX-License-Identifier: MIT
#include "experiments/cli/check/paired_times.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/cli/check/against.hpp"
#include "experiments/compare/timing.hpp"
#include "experiments/tables/table_row.hpp"

namespace bezierbench::cli {
namespace {

/// The times of one row, pair by pair.
struct Sample {
  std::vector<double> before_ns;
  std::vector<double> after_ns;
  bool right = true;
};

bundle::CsvDocument timed(const std::filesystem::path& program, const TimedPrograms& programs) {
  const auto out = programs.scratch / "times";
  std::filesystem::remove_all(out);
  run_suite(program, programs.suite, out);
  bundle::CheckedReader reader(out, bundle::Damage::refused);
  return bundle::parse_csv(reader.read(compare::timing_file), reader.place(compare::timing_file));
}

void add(std::map<compare::Inputs, Sample>& samples, const bundle::CsvDocument& before,
         const bundle::CsvDocument& after, const std::string& method) {
  for (auto& pair : compare::match_rows(*bundle::declared_table(compare::timing_file), before, after).pairs) {
    if (pair.inputs.field("method") != method) continue;
    auto& sample = samples[std::move(pair.inputs)];
    sample.before_ns.push_back(tables::TableRow(before, pair.a).number("median_ns"));
    sample.after_ns.push_back(tables::TableRow(after, pair.b).number("median_ns"));
    sample.right = sample.right && after.at(pair.b, "checked") == "yes";
  }
}

}  // namespace

PairedTime paired_time(compare::Inputs inputs, const std::vector<double>& before_ns,
                       const std::vector<double>& after_ns) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < before_ns.size(); ++k) ratios.push_back(after_ns[k] / before_ns[k]);
  const auto interval = [](const std::vector<double>& sample) {
    return metric::median_interval(sample, metric::timing_confidence);
  };
  PairedTime time{.inputs = std::move(inputs),
                  .before = interval(before_ns),
                  .after = interval(after_ns),
                  .ratio = interval(ratios),
                  .verdict = metric::Verdict::unresolved};
  if (metric::covers_median(ratios.size(), metric::timing_confidence)) time.verdict = metric::verdict(time.ratio);
  return time;
}

std::vector<PairedTime> paired_times(const TimedPrograms& programs, const std::string& method, int pairs) {
  std::map<compare::Inputs, Sample> samples;
  for (int pair = 0; pair < pairs; ++pair) {
    if (pair % 2 == 0) {
      const auto before = timed(programs.before, programs);
      add(samples, before, timed(programs.after, programs), method);
    } else {
      const auto after = timed(programs.after, programs);
      add(samples, timed(programs.before, programs), after, method);
    }
  }
  std::vector<PairedTime> times;
  for (auto& [inputs, sample] : samples) {
    times.push_back(paired_time(inputs, sample.before_ns, sample.after_ns));
    times.back().right = sample.right;
  }
  return times;
}

}  // namespace bezierbench::cli
