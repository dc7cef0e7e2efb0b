// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "experiments/cli/choose/choose.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

bool is_of_kind(const tables::TableRow& row, const tables::ChoiceGroup& group) {
  return row.text("form") == group.form && row.text("scalar") == group.scalar &&
         row.text("dimension") == group.dimension && row.text("degree") == group.degree;
}

DrawnClass drawn_class(const tables::TableRow& row) {
  return {row.number("coordinate_range"), {row.number("t_min"), row.number("t_max")}};
}

bool lies_within(const DrawnClass& part, const DrawnClass& whole) {
  return part.range <= whole.judged_range() && part.t.min >= whole.t.min && part.t.max <= whole.t.max;
}

bool is_same(const DrawnClass& a, const DrawnClass& b) { return a.range == b.judged_range() && a.t == b.t; }

std::string cell_words(const tables::TableRow& row) {
  return fmt::format("{}: R {}, t in [{}, {}], {}{}", row.text("study"), row.text("coordinate_range"),
                     row.text("t_min"), row.text("t_max"), row.text("generator"),
                     row.has("trials") ? ", " + row.text("trials") + " trials" : "");
}

/// The observed errors of one method.
struct Seen {
  tables::LargestErrors errors;
  bool of_the_class = false;  ///< whether a row covers the whole class
};

int whole(const std::string& text) { return static_cast<int>(number::parse_integer(text).value_or(-1)); }

/// The class with its ends rounded to the scalar type, as the numbers drawn from it are.
template <class Scalar>
metric::CurveClass curve_class(const tables::ChoiceGroup& group, const DrawnClass& of) {
  const auto rounded = [](double end) { return static_cast<double>(static_cast<Scalar>(end)); };
  const auto form = suite::parse<Form>(group.form);
  return {form.value_or(Form::rational),  // rational classes have no bound
          whole(group.dimension),
          whole(group.degree),
          std::max(of.range, rounded(of.range)),
          std::min(of.t.min, rounded(of.t.min)),
          std::max(of.t.max, rounded(of.t.max))};
}

/// The bound that methods.csv states; empty where it does not name the method.
std::optional<std::string> stated_bound(const bundle::CsvDocument& methods, const std::string& id, Form form) {
  for (std::size_t at = 0; at < methods.row_count(); ++at)
    if (methods.at(at, "id") == id && methods.at(at, "problem") == name(Problem::evaluation) &&
        methods.at(at, "form") == name(form))
      return methods.at(at, "bound");
  return std::nullopt;
}

template <class Scalar>
void add_class_bounds(tables::ChoiceGroup& group, const DrawnClass& of, const bundle::CsvDocument& methods) {
  const auto curves = curve_class<Scalar>(group, of);
  if (curves.degree < 0 || curves.dimension < 1 || curves.dimension > reference::max_dimension) return;
  for (auto& choice : group.choices) {
    const auto* method = judge::find_method<Scalar>(choice.method, curves.form, curves.dimension);
    if (method == nullptr || !method->info->bound || !method->info->template supports<Scalar>(curves.degree)) continue;
    if (stated_bound(methods, choice.method, curves.form) != method->info->bound->text) continue;
    const auto bound = metric::class_bound(*method->info->bound, curves, judge::ScalarFacts<Scalar>::arithmetic);
    if (std::isfinite(bound.in_u)) choice.errors.in_u.class_bound = bound.in_u;
    if (std::isfinite(bound.coordinate)) choice.errors.absolute.class_bound = bound.coordinate;
  }
}

bool is_float(const tables::ChoiceGroup& group) { return group.scalar == suite::name(suite::ScalarKind::float32); }

}  // namespace

std::optional<DrawnClass> class_of(const tables::ChoiceGroup& group, std::optional<double> range) {
  const auto number = [&](std::size_t at) {
    return at < group.drawn.size() ? number::parse_number(group.drawn[at]) : std::nullopt;
  };
  if (const auto r = number(0), low = number(1), high = number(2); r && low && high)
    return DrawnClass{range.value_or(*r), {*low, *high}};
  return std::nullopt;
}

std::vector<double> judged_ranges(const tables::ChoiceGroup& group, const tables::JudgedTables& judged,
                                  const std::string& accuracy_study) {
  std::set<double> ranges;
  judged.each_row(accuracy_study, [&](const tables::TableRow& row) {
    if (is_of_kind(row, group) &&
        std::ranges::find(group.choices, row.text("method"), &tables::Choice::method) != group.choices.end())
      ranges.insert(row.number("coordinate_range"));
  });
  return {ranges.begin(), ranges.end()};
}

std::optional<DrawnClass> scaled_to(DrawnClass of, double timed, const std::vector<double>& judged, bool in_float) {
  if (std::ranges::find(judged, of.range) != judged.end()) return of;
  const int most = in_float ? 60 : 500;
  std::optional<DrawnClass> best;
  for (const double range : judged) {
    DrawnClass one{0, of.t, static_cast<int>(std::ceil(std::log2(of.range / range)))};
    while (std::ldexp(range, one.exponent) < of.range) ++one.exponent;
    one.range = std::ldexp(range, one.exponent);
    if (std::abs(std::ilogb(one.range)) > most) continue;
    const auto order = [&](const DrawnClass& c) {
      return std::tuple(c.range, c.judged_range() != timed, std::abs(c.exponent));
    };
    if (!best || order(one) < order(*best)) best = one;
  }
  return best;
}

std::vector<std::string> judge_class(tables::ChoiceGroup& group, const DrawnClass& of,
                                     const tables::JudgedTables& judged,
                                     const std::optional<bundle::CsvDocument>& methods,
                                     const std::string& accuracy_study) {
  std::map<std::string, Seen> seen;
  for (const auto& choice : group.choices) seen[choice.method];
  std::vector<std::string> studies;
  std::vector<std::string> cells;
  const auto add_once = [](std::vector<std::string>& texts, const std::string& text) {
    if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
  };
  judged.each_row(accuracy_study, [&](const tables::TableRow& row) {
    const auto method = seen.find(row.text("method"));
    if (method == seen.end() || !is_of_kind(row, group)) return;
    const auto drawn = drawn_class(row);
    if (!lies_within(drawn, of)) return;
    method->second.errors.add(row, std::ldexp(1.0, of.exponent));
    method->second.of_the_class = method->second.of_the_class || is_same(drawn, of);
    add_once(studies, row.text("study"));
    add_once(cells, cell_words(row));
  });
  std::erase_if(group.choices, [&](const tables::Choice& one) { return !seen.at(one.method).of_the_class; });
  for (auto& choice : group.choices) choice.errors = seen.at(choice.method).errors;
  group.accuracy_study = fmt::format("{}", fmt::join(studies, ", "));
  if (methods)
    is_float(group) ? add_class_bounds<float>(group, of, *methods) : add_class_bounds<double>(group, of, *methods);
  return cells;
}

double least_p_tilde(const tables::ChoiceGroup& group, const DrawnClass& of) {
  return is_float(group) ? metric::min_p_tilde(curve_class<float>(group, of), reference::float_arithmetic)
                         : metric::min_p_tilde(curve_class<double>(group, of), reference::double_arithmetic);
}

}  // namespace bezierbench::cli
