// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "core/evaluate/kernel.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands.hpp"
#include "experiments/cli/curve_file.hpp"
#include "experiments/cli/vocabulary.hpp"
#include "experiments/metric/trial_scale.hpp"
#include "experiments/number/number.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/studies/workspace.hpp"
#include "experiments/suite/nearest.hpp"
#include "experiments/suite/pattern.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::cli {
namespace {

struct Options {
  std::string curve;
  std::string form = "bernstein";
  std::vector<std::string> t;
  std::vector<std::string> methods;

  [[nodiscard]] Form form_value() const { return form == "bernstein" ? Form::bernstein : Form::power; }
};

std::string why_not(const MethodInfo& info, const CurveFile& curve) {
  if (info.form != curve.form && curve.form == Form::rational)
    return fmt::format(
        "takes curves in {} form, the file has weights (column w); see `list methods` for methods that "
        "take the rational form",
        name(info.form));
  if (info.form == Form::rational && curve.form != Form::rational)
    return fmt::format("takes curves in rational form, the file has no weights (column w); see `list methods`");
  if (info.form != curve.form)
    return fmt::format("takes curves in {} form, the file is in {} form; see --form and `list methods`",
                       name(info.form), name(curve.form));
  return fmt::format("supports degrees {} to {}, the curve has degree {}; see `list methods`", info.min_degree,
                     info.max_degree, curve.degree());
}

bool applies(const MethodInfo& info, const CurveFile& curve) {
  return info.form == curve.form && info.supports<double>(curve.degree());
}

[[noreturn]] void unknown_method(const std::string& id, const std::vector<std::string>& known) {
  for (const auto& peer : peers::absent())
    if (peer.id == id)
      throw Failure(Exit::usage, fmt::format("--method {}: is not in this build; {}", id, peer.remedy));
  const auto guess = suite::nearest(id, known);
  throw Failure(Exit::usage, fmt::format("--method {}: no such method{}; see `list methods`", id,
                                         guess.empty() ? "" : fmt::format(", did you mean \"{}\"?", guess)));
}

/// The named entries as named, or all that apply in the order of the roster. `Table` holds entries with an `info`.
template <class Table>
std::vector<const typename Table::element_type*> chosen(Table table, const std::vector<std::string>& ids,
                                                        const CurveFile& curve, const std::vector<std::string>& known) {
  std::vector<const typename Table::element_type*> result;
  for (const auto& id : ids) {
    const typename Table::element_type* candidate = nullptr;
    for (const auto& entry : table)  // an id may exist for several forms
      if (entry.info->id == id && (candidate == nullptr || applies(*entry.info, curve))) candidate = &entry;
    if (candidate == nullptr) unknown_method(id, known);
    if (!applies(*candidate->info, curve))
      throw Failure(Exit::usage, fmt::format("--method {}: {}", id, why_not(*candidate->info, curve)));
    result.push_back(candidate);
  }
  if (!ids.empty()) return result;
  for (const auto& entry : table)
    if (applies(*entry.info, curve) && !suite::is_peer(entry.info->id)) result.push_back(&entry);
  return result;
}

double parameter(const std::string& text) {
  const auto t = number::parse_number(text);
  if (!t || !std::isfinite(*t))
    throw Failure(Exit::usage, fmt::format("--t {}: not a finite number; write a decimal or hexadecimal double", text));
  return *t;
}

/// u p~, exactly.
reference::Rational unit_of(const reference::Rational& p_tilde) { return p_tilde * reference::Rational{1, 1, -53}; }

/// bound / (u p~) on one axis; nothing where no bound is stated or proved, or p~ is zero.
std::string bound_units(const MethodInfo& info, const CurveFile& curve, int axis, double t,
                        const reference::Rational& truth, const reference::Rational& p_tilde) {
  if (!info.bound || p_tilde.numerator == 0) return "";
  std::vector<double> coefficients;
  for (int i = 0; i <= curve.degree(); ++i) coefficients.push_back(curve.view()(axis, i));
  metric::TrialScale scale;
  scale.set({curve.form, 1, curve.degree(), coefficients, curve.weights}, t);
  const double length = std::abs(reference::round_to(reference::binary64, truth));
  const double bound = scale.bound(*info.bound, metric::double_arithmetic, length);
  if (!std::isfinite(bound)) return "";
  return number::decimal(reference::quotient(reference::binary64, reference::exactly(bound), unit_of(p_tilde)));
}

/// The columns value to error_u of one coordinate.
std::vector<std::string> judged(double value, const reference::Rational& truth, const reference::Rational& p_tilde) {
  using reference::binary64;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double error = infinite;
  double error_ulp = infinite;
  double error_u = infinite;
  if (std::isfinite(value)) {
    const auto difference = abs(reference::exactly(value) - truth);
    error = reference::round_to(binary64, difference);
    error_ulp = reference::quotient(binary64, difference, reference::ulp(truth));
    if (difference.numerator == 0)
      error_u = 0;
    else if (p_tilde.numerator != 0)
      error_u = reference::quotient(binary64, difference, unit_of(p_tilde));
  }
  return {number::decimal(value), number::decimal(reference::round_to(binary64, truth)), number::decimal(error),
          number::decimal(error_ulp), number::decimal(error_u)};
}

void evaluate(const Options& options) {
  const auto curve = read_curve(options.curve, options.form_value());
  const auto methods = chosen(studies::methods<double>(curve.dimension), options.methods, curve, vocabulary().methods);
  std::vector<double> ts;
  for (const auto& text : options.t) ts.push_back(parameter(text));
  std::vector<reference::ExactPoint> truths;
  std::vector<reference::ExactPoint> p_tildes;
  reference::ExactCurve exact;
  for (const double t : ts) {
    truths.push_back(exact.point(curve.view(), t));
    if (!truths.back().exists())
      throw Failure(Exit::usage,
                    fmt::format("--t {}: the weights of {} sum to zero there, so the curve has no point; see "
                                "column w or choose another t",
                                number::decimal(t), options.curve));
    p_tildes.push_back(exact.p_tilde(curve.view(), t));
  }
  bundle::CsvTable table({"method", "t", "axis", "value", "exact", "error", "error_ulp", "error_u", "bound_u"});
  studies::PreparedStorage storage;
  std::vector<double> point(static_cast<std::size_t>(curve.dimension));
  for (const auto* kernel : methods)
    for (std::size_t k = 0; k < ts.size(); ++k) {
      studies::evaluate_once<double>(*kernel, curve.view(), ts[k], storage, point);
      for (int axis = 0; axis < curve.dimension; ++axis) {
        std::vector<std::string> row{std::string(kernel->info->id), number::decimal(ts[k]), axis_name(axis)};
        for (auto& field :
             judged(point[static_cast<std::size_t>(axis)], truths[k].coordinate(axis), p_tildes[k].coordinate(axis)))
          row.push_back(std::move(field));
        row.push_back(
            bound_units(*kernel->info, curve, axis, ts[k], truths[k].coordinate(axis), p_tildes[k].coordinate(axis)));
        table.add_row(std::move(row));
      }
    }
  fmt::print("{}", table.text());
}

void convert(const Options& options) {
  auto curve = read_curve(options.curve, options.form_value());
  const auto methods =
      chosen(conversion_kernels<double>(curve.dimension), options.methods, curve, vocabulary().conversions);
  std::vector<double> converted(curve.coefficients.size());
  methods.front()->convert(curve.view(), converted.data());
  curve.coefficients = converted;
  fmt::print("{}", curve_csv(curve));
}

void add_curve_options(CLI::App& command, Options& options) {
  command.add_option("--curve", options.curve, "curve file (CSV)")->required();
  command.add_option("--form", options.form, "form of the file")->check(CLI::IsMember({"bernstein", "power"}));
}

}  // namespace

void add_curve(CLI::App& app, Exit& /*exit*/) {
  auto* curve = app.add_subcommand("curve", "one curve, any method, against the truth");
  curve->require_subcommand(1);
  auto options = std::make_shared<Options>();

  auto* eval = curve->add_subcommand("eval", "points of a curve");
  add_curve_options(*eval, *options);
  eval->add_option("--t", options->t, "parameter; may be repeated")->required();
  eval->add_option("--method", options->methods, "method id; may be repeated; default: all that apply");
  eval->callback([options] { evaluate(*options); });

  auto* conversion = curve->add_subcommand("convert", "coefficients in the other form");
  add_curve_options(*conversion, *options);
  conversion->add_option("--method", options->methods, "conversion id")->required()->expected(1);
  conversion->callback([options] { convert(*options); });
}

}  // namespace bezierbench::cli
