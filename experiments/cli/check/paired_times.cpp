// SPDX-License-Identifier: MIT
#include "experiments/cli/check/paired_times.hpp"

#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/cli/check/against.hpp"
#include "experiments/compare/side.hpp"
#include "experiments/tables/table_row.hpp"

namespace bezierbench::cli {
namespace {

bundle::CsvDocument timed(const std::filesystem::path& program, const TimedPrograms& programs) {
  const auto out = programs.scratch / "times";
  std::filesystem::remove_all(out);
  run_suite(program, programs.suite, out);
  bundle::CheckedReader reader(out, bundle::Damage::refused);
  return bundle::parse_csv(reader.read(compare::timing_file), reader.place(compare::timing_file));
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

std::map<compare::Inputs, PairedTimes> paired_times(const TimedPrograms& programs, const std::string& method,
                                                    int pairs) {
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
