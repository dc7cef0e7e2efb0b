// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/choose/choose.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/metric/pareto.hpp"
#include "experiments/run/job.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/table_row.hpp"
#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::size_t most_judged = 16384;  ///< curves and parameters of a ranking: some seconds at degree 3
constexpr double nearly_correct = 0.05;     ///< share of misrounded coordinates

/// A unit of errors, and its columns in accuracy.csv.
struct Unit {
  std::string_view id;
  std::string_view words;
  const char* observed;
  const char* bound;  ///< null: no column has the bound in this unit
};
constexpr Unit error_units[]{{"u", "u p~", "max_error_u", "bound_u"},
                             {"ulp", "ulp", "max_error_ulp", nullptr},
                             {"coordinate", "coordinate units", "max_error", "max_bound"},
                             {"size", "of the size", "max_error_size", nullptr}};

struct RankedMethod {
  std::string method;
  double error = std::numeric_limits<double>::infinity();  ///< the largest, in the unit
  std::optional<double> bound;                             ///< of these curves; empty where one of them has none
  double misrounded = 1;
  std::optional<metric::Interval> ns;
  std::string_view front = {};
};

/// The methods on the curves of one form, dimension and degree.
struct Ranking {
  Form form;
  int dimension;
  int degree;
  std::size_t curves;
  std::size_t judged;
  std::vector<RankedMethod> candidates;  ///< those that keep the tolerance, best first
  std::optional<RankedMethod> most_accurate;
};

/// Times by method, of one form, scalar, dimension, degree and mode.
using Times = std::map<std::string, metric::Interval>;

metric::Interval interval_of(const tables::TableRow& row) {
  return {row.number("median_ns"), row.number("low_ns"), row.number("high_ns")};
}

/// Every k-th curve where there are more than can be judged in seconds.
std::shared_ptr<const sample::LoadedSet> thinned(const sample::CurveSlice& slice) {
  auto some = std::make_shared<sample::LoadedSet>();
  some->id = slice.set().id;
  some->sha256 = slice.set().sha256;
  const std::size_t count = std::min(slice.curve_count(), most_judged);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t number = k * slice.curve_count() / count;
    some->curves.add(slice.curve_id(number), slice.curve(number));
  }
  return some;
}

tables::Tables tables_of_run(const suite::Study& study) {
  const auto job = studies::make_job(study, {.seed = 1, .tier = reference::Tier::certified});
  run::run_all(*job);
  tables::Tables tables;
  job->write(tables);
  return tables;
}

/// A study of all these curves, each at several parameters if there are few.
suite::Study study_of(const suite::Study& slice, const Wish& wish) {
  suite::Study study;
  study.id = "choose";
  study.kind = &studies::accuracy_kind.asks;
  study.curves = slice.curves;
  study.sets = {thinned(*slice.slice)};
  study.dimension.clear();
  study.parameters =
      static_cast<std::int64_t>(std::max<std::size_t>(1, most_judged / study.sets.front()->curves.size()));
  study.scalar = {*suite::parse<suite::ScalarKind>(wish.scalar)};
  return sample::studies_of(study).front();
}

std::vector<RankedMethod> judged(const suite::Study& study, const Unit& unit) {
  std::vector<RankedMethod> all;
  const auto tables = tables_of_run(study);
  const auto* accuracy = tables.find("accuracy.csv");
  if (accuracy == nullptr) return all;
  for (const auto& row : tables::rows_of(*accuracy)) {
    if (row.text("status") != "ok" || row.number("non_finite") > 0) continue;
    const auto error = row.optional_number(unit.observed);
    if (!error) continue;
    RankedMethod one;
    one.method = row.text("method");
    one.error = *error;
    if (unit.bound != nullptr && row.optional_number("unbounded_trials") == 0)
      one.bound = row.optional_number(unit.bound);
    one.misrounded = row.number("misrounded");
    all.push_back(std::move(one));
  }
  return all;
}

/// Times of now, in a race on the first of the curves.
Times measured(suite::Study study, const std::vector<RankedMethod>& candidates, const Wish& wish) {
  study.kind = &studies::timing_kind.asks;
  study.modes = {*suite::parse<suite::Mode>(wish.mode)};
  study.methods.clear();
  for (const auto& one : candidates) study.methods.push_back(one.method);
  Times times;
  const auto tables = tables_of_run(study);
  if (const auto* timing = tables.find("timing.csv"))
    for (const auto& row : tables::rows_of(*timing)) times.emplace(row.text("method"), interval_of(row));
  return times;
}

/// The times of the shipped bundles.
class Answers {
 public:
  Answers() {
    for (const auto& folder : {real_folder(), answers_folder()})
      timings_.push_back(bundle::BundleDirectory::open(folder).table("timing.csv").value());
  }

  /// Of several studies the first that has most of the methods; its times can be compared with each other.
  [[nodiscard]] Times of(const Ranking& ranking, const Wish& wish) const {
    Times best;
    for (const auto& timing : timings_) {
      std::map<std::string, Times> by_study;
      for (const auto& row : tables::rows_of(timing)) {
        if (row.text("form") != name(ranking.form) || row.text("scalar") != wish.scalar ||
            row.text("mode") != wish.mode || row.optional_number("dimension") != ranking.dimension ||
            row.optional_number("degree") != ranking.degree)
          continue;
        auto& times = by_study[row.text("study")];
        times.emplace(row.text("method"), interval_of(row));
        if (times.size() > best.size()) best = times;
      }
    }
    return best;
  }

 private:
  std::vector<bundle::CsvDocument> timings_;
};

void set_fronts(std::vector<RankedMethod>& candidates) {
  std::vector<metric::Tradeoff> tradeoffs;
  std::vector<RankedMethod*> timed;
  for (auto& one : candidates)
    if (one.ns) {
      tradeoffs.push_back({*one.ns, one.misrounded});
      timed.push_back(&one);
    }
  const auto fronts = metric::pareto_front(tradeoffs);
  for (std::size_t k = 0; k < timed.size(); ++k) timed[k]->front = metric::name(fronts[k]);
}

double median_ns(const RankedMethod& one) { return one.ns ? one.ns->median : std::numeric_limits<double>::infinity(); }

/// The order of the ranking: with a tolerance by time; without one, first the methods that are nearly correctly rounded
/// on these curves, by time, then the others, by their share of misrounded coordinates.
bool is_better(const RankedMethod& a, const RankedMethod& b, bool has_tolerance) {
  const bool a_is_near = has_tolerance || a.misrounded <= nearly_correct;
  const bool b_is_near = has_tolerance || b.misrounded <= nearly_correct;
  if (a_is_near != b_is_near) return a_is_near;
  if (a_is_near && median_ns(a) != median_ns(b)) return median_ns(a) < median_ns(b);
  return std::pair(a.misrounded, a.error) < std::pair(b.misrounded, b.error);
}

Ranking ranking_of(const suite::Study& slice, const Wish& wish, const Unit& unit,
                   const std::optional<Answers>& answers) {
  const auto study = study_of(slice, wish);
  Ranking ranking{slice.form,
                  slice.dimension.front(),
                  slice.degree.front(),
                  slice.slice->curve_count(),
                  static_cast<std::size_t>(study.trials),
                  judged(study, unit),
                  {}};
  auto& candidates = ranking.candidates;
  const bool has_tolerance = !wish.tolerance_text.empty();
  const auto best = std::ranges::min_element(candidates, {}, &RankedMethod::error);
  if (best != candidates.end()) ranking.most_accurate = *best;
  std::erase_if(candidates, [&](const RankedMethod& one) { return has_tolerance && one.error > wish.tolerance; });
  const auto times = answers ? answers->of(ranking, wish) : measured(study, candidates, wish);
  for (auto& one : candidates)
    if (const auto found = times.find(one.method); found != times.end()) one.ns = found->second;
  set_fronts(candidates);
  std::ranges::stable_sort(
      candidates, [&](const RankedMethod& a, const RankedMethod& b) { return is_better(a, b, has_tolerance); });
  return ranking;
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

std::string first_text(const Ranking& ranking, const Wish& wish, const Unit& unit) {
  if (ranking.candidates.empty()) return "";
  const auto& best = ranking.candidates.front();
  std::string why = !wish.tolerance_text.empty()
                        ? fmt::format("the fastest within {} {}", wish.tolerance_text, unit.words)
                    : best.misrounded <= nearly_correct
                        ? fmt::format("the fastest that rounds more than {} of the coordinates correctly",
                                      percent(1 - nearly_correct))
                        : "the one that misrounds least";
  if (!best.ns) why = "the most accurate; there is no time for this degree, --measure takes one";
  auto text = wrapped("", fmt::format("{}: {}", best.method, why), 4) +
              wrapped("  ",
                      fmt::format("{} of the coordinates are not the nearest {}, largest error {} {}{}",
                                  percent(best.misrounded), wish.scalar, brief(best.error), unit.words,
                                  best.bound ? fmt::format(", bound {}", brief(*best.bound)) : ""),
                      4);
  return text;
}

std::string text_of(const Ranking& ranking, const Wish& wish, const Unit& unit) {
  std::string text = wrapped(
      "",
      fmt::format("{} curve{} of degree {}, {} form, {} axes; {}, mode {}; {} points judged against the exact value",
                  ranking.curves, ranking.curves == 1 ? "" : "s", ranking.degree, name(ranking.form), ranking.dimension,
                  wish.scalar, wish.mode, ranking.judged),
      4);
  text += first_text(ranking, wish, unit) + "\n";
  std::vector<std::vector<std::string>> lines{{"method", "ns", "misrounded", "error", "bound", "pareto"}};
  for (const auto& one : ranking.candidates)
    lines.push_back({one.method, one.ns ? brief(one.ns->median) : "", percent(one.misrounded), brief(one.error),
                     one.bound ? brief(*one.bound) : "", std::string(one.front)});
  return text + fitted(std::move(lines), terminal_width(STDOUT_FILENO)) + "\n";
}

void add_rows(const Ranking& ranking, const Wish& wish, const Unit& unit, bundle::CsvTable& table) {
  for (const auto& one : ranking.candidates)
    table.add_row(tables::texts(name(ranking.form), ranking.degree, ranking.curves, ranking.dimension, one.method,
                                wish.mode, end_of(one.ns, &metric::Interval::median),
                                end_of(one.ns, &metric::Interval::low), end_of(one.ns, &metric::Interval::high),
                                one.error, one.bound, unit.id, one.front, one.misrounded));
}

/// The studies of the files, one for each form, dimension and degree: the most frequent non-linear one first.
std::vector<suite::Study> slices_of(const Wish& wish) {
  suite::Suite all;
  auto& study = all.studies.emplace_back();
  study.id = "choose";
  study.kind = &studies::accuracy_kind.asks;
  std::vector<suite::Suite> suites{all};
  take_curves(suites, wish.curves);
  suites.front().studies.front().places.keys.erase("curve");  // all forms
  if (wish.degree_text) suites.front().studies.front().degree = {wish.degree};
  load_curves(suites);
  auto slices = sample::studies_of(suites.front().studies.front());
  std::ranges::stable_sort(slices, [](const suite::Study& a, const suite::Study& b) {
    const bool a_is_curved = a.degree.front() > 1;
    const bool b_is_curved = b.degree.front() > 1;
    if (a_is_curved != b_is_curved) return a_is_curved;
    return a.slice->curve_count() > b.slice->curve_count();
  });
  return slices;
}

}  // namespace

Exit choose_on_curves(const Wish& wish) {
  const auto& unit = *std::ranges::find(error_units, wish.unit, &Unit::id);
  const auto slices = slices_of(wish);
  std::optional<Answers> answers;
  if (!wish.measure) answers.emplace();
  bundle::CsvTable table({"form", "degree", "curves", "dimension", "method", "mode", "ns", "ns_low", "ns_high",
                          "observed_max", "bound", "unit", "pareto", "misrounded"});
  auto exit = Exit::fine;
  if (wish.format == "text")
    fmt::print("{}\n",
               paragraph(answers ? "times: of the shipped answers, from another run and perhaps another machine; "
                                   "--measure takes them here"
                                 : "times: measured now"));
  for (const auto& slice : slices) {
    const auto ranking = ranking_of(slice, wish, unit, answers);
    if (wish.format == "csv")
      add_rows(ranking, wish, unit, table);
    else
      fmt::print("{}", text_of(ranking, wish, unit));
    if (!ranking.candidates.empty() || !ranking.most_accurate) continue;
    say(fmt::format("no method stays within {} {} on the {} curves of degree {}; the most accurate is {} with {}",
                    wish.tolerance_text, unit.words, ranking.curves, ranking.degree, ranking.most_accurate->method,
                    brief(ranking.most_accurate->error)));
    exit = Exit::finding;
  }
  if (wish.format == "csv") fmt::print("{}", table.text());
  return exit;
}

}  // namespace bezierbench::cli
