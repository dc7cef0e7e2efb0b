// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/curve_command.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "experiments/cli/commands/commands.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/suite/ids.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"
#include "reference/stop.hpp"

namespace bezierbench::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int always_below = 21;  // of degrees at which the truth takes milliseconds, most often
constexpr std::chrono::seconds unasked{1};
constexpr std::chrono::seconds without_a_word{3};

}  // namespace

void CurveOptions::add_to(Command command) {
  command
      .option("--curve", file,
              "file of curves (see bezierbench curves), - for standard input; FILE#ID selects a curve by its "
              "id or its number from 0, or a path")
      .takes(file_value);
  command.option("--path", path, "SVG path data, in place of --curve").takes("'M0,0 C...'");
  command.option("--form", form, "form of the file").one_of({"bernstein", "power"});
}

std::vector<CurveFile> CurveOptions::read() const {
  if (file && path) throw Failure(Exit::usage, "--path: must not be given with --curve; give one of them");
  if (!file && !path) throw Failure(Exit::usage, "--curve is required; write --curve FILE, or --path 'M0,0 C...'");
  return path ? path_curves(*path) : read_curves(*file, form == "bernstein" ? Form::bernstein : Form::power);
}

void add_method_option(Command command, Problem problem, std::vector<std::string>& methods) {
  command.option("--method", methods, "method id; may be repeated; default: all that apply")
      .takes("METHOD", methods_of(problem));
}

double finite_option(const std::string& option, const std::string& text) {
  const auto value = number::parse_number(text);
  if (!value || !std::isfinite(*value))
    throw Failure(Exit::usage, "{} {}: {}", option, echo(text), number::fault(text));
  return *value;
}

std::vector<double> finite_options(const std::string& option, const std::vector<std::string>& texts) {
  std::vector<double> numbers;
  for (const auto& text : texts) numbers.push_back(finite_option(option, text));
  return numbers;
}

std::vector<double> finite_numbers(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    numbers.push_back(finite_option(option, text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return numbers;
}

std::vector<double> finite_coordinates(const std::string& option, const std::string& text, int dimension,
                                       const std::string& owner) {
  auto numbers = finite_numbers(option, text);
  if (numbers.size() != static_cast<std::size_t>(dimension))
    throw Failure(Exit::usage, "{} {}: {} coordinate{}, but {} {}; write one per axis", option, text, numbers.size(),
                  numbers.size() == 1 ? "" : "s", owner, dimension);
  return numbers;
}

double relative_tolerance(const std::string& text) {
  const double tolerance = finite_option("--tolerance", text);
  if (tolerance <= 0)
    throw Failure(Exit::usage, "--tolerance {}: must be above 0; it is relative to the length of the curve", text);
  return tolerance;
}

bool applies(const MethodInfo& info, const CurveFile& curve) {
  return info.form == curve.form && info.supports<double>(curve.degree());
}

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

void refuse_curve(const std::string& name, const CurveFile& curve, const MethodInfo& any) {
  std::string problem(bezierbench::name(any.problem));
  std::ranges::replace(problem, '_', ' ');
  std::string why = why_not(any, curve);
  if (curve.form == Form::rational)
    why = fmt::format(
        "no method for {} takes rational curves (column w); `curve eval`, `grid`, `derivative`, `length`, `at-length`, "
        "`project`, `split`, `flatten` and `box` do",
        problem);
  else if (curve.form == Form::power)
    why = fmt::format("no method for {} takes the power form; see `curve convert`", problem);
  throw Failure(Exit::usage, "{}: {}", name, why);
}

void require_point(const reference::ExactPoint& point, double t, const std::string& name) {
  if (!point.exists())
    throw Failure(Exit::usage,
                  fmt::format("--t {}: the weights of {} sum to zero there, so the curve has no point; see "
                              "column w or choose another t",
                              number::decimal(t), name));
}

void refuse_pole(const CurveView<double>& curve, double from, double to, const std::string& name) {
  if (const auto t = reference::pole(curve, from, to))
    throw Failure(
        Exit::usage,
        "{}: has a pole, since the weights (column w) sum to zero at t = {}; `curve part` gives the parts beside it",
        name, number::decimal(*t));
}

void unknown_method(const std::string& id, Problem problem) {
  for (const auto& peer : peers::absent())
    if (peer.id == id) throw Failure(Exit::usage, "--method {}: is not in this build; {}", id, peer.remedy);
  const auto guess = suite::nearest(id, methods_of(problem)());
  throw Failure(Exit::usage, "--method {}: no such method{}; see `list methods`", id,
                guess.empty() ? "" : fmt::format(", did you mean \"{}\"?", guess));
}

void TruthOption::add_to(Command command) {
  command.flag("--truth", wanted_, "wait for the exact result; default: for at most a second above degree 20");
}

bool TruthOption::finishes(const std::string& name, int degree, const std::function<void()>& compute) const {
  const auto begin = Clock::now();
  const bool limited = degree >= always_below && !wanted_;
  bool silent = true;
  const reference::StopWhen stop([&] {
    const auto taken = Clock::now() - begin;
    if (silent && !limited && taken >= without_a_word) {
      silent = false;
      fmt::print(stderr,
                 "bezierbench: {}: the exact result at degree {} takes more than {} seconds; Ctrl-C ends this\n",
                 printable(name), degree, without_a_word.count());
    }
    return limited && taken >= unasked;
  });
  try {
    compute();
    return true;
  } catch (const reference::Stopped&) {
    fmt::print(stderr,
               "bezierbench: {}: the exact result at degree {} takes more than a second, so its columns are empty; add "
               "--truth to compute it\n",
               printable(name), degree);
    return false;
  }
}

std::vector<std::string> judged_columns(std::vector<std::string> first) {
  for (const auto* name : {"axis", "value", "exact", "error", "error_ulp", "error_u", "bound_u"})
    first.emplace_back(name);
  return first;
}

std::vector<std::string> judged_coordinate(double value, const reference::Rational& truth,
                                           const reference::Rational& p_tilde, std::optional<double> bound) {
  const auto judged = reference::coordinate_error(value, truth, p_tilde);
  const auto bound_u = bound ? reference::bound_units(*bound, p_tilde) : std::nullopt;
  return tables::texts(value, judged.exact, judged.error, judged.error_ulp, judged.error_u, bound_u);
}

void CurveTable::add_point(const std::vector<std::string>& first, std::span<const double> point,
                           const reference::ExactPoint& truth, const reference::ExactPoint& p_tilde,
                           const std::function<std::optional<double>(int axis)>& bound) {
  for (int axis = 0; axis < static_cast<int>(point.size()); ++axis) {
    auto row = first;
    row.push_back(axis_name(axis));
    for (auto& field : judged_coordinate(point[static_cast<std::size_t>(axis)], truth.coordinate(axis),
                                         p_tilde.coordinate(axis), bound(axis)))
      row.push_back(std::move(field));
    add_row(std::move(row));
  }
}

std::vector<std::string> point_fields(std::span<const double> point, int dimension) {
  std::vector<std::string> fields;
  for (const double x : point) fields.push_back(number::decimal(x));
  fields.resize(static_cast<std::size_t>(dimension));
  return fields;
}

std::vector<std::string> point_fields_at(const CurveView<double>& curve, double t, int dimension) {
  std::vector<double> point;
  reference::ExactCurve exact;
  if (std::isfinite(t)) {
    const auto& truth = exact.point(curve, t);
    for (int axis = 0; axis < curve.dimension && truth.exists(); ++axis)
      point.push_back(reference::round_to(reference::binary64, truth.coordinate(axis)));
  }
  return point_fields(point, dimension);
}

std::vector<std::string> with_axes(std::vector<std::string> columns, int dimension) {
  for (int axis = 0; axis < dimension; ++axis) columns.push_back(axis_name(axis));
  return columns;
}

std::vector<std::span<const CurveFile>> paths_of(std::span<const CurveFile> curves) {
  std::vector<std::span<const CurveFile>> paths;
  for (std::size_t begin = 0; begin < curves.size();) {
    std::size_t end = begin + 1;
    while (end < curves.size() && !curves[end].begins_path) ++end;
    paths.push_back(curves.subspan(begin, end - begin));
    begin = end;
  }
  return paths;
}

std::string path_id(const std::string& id) {
  const auto colon = id.rfind(':');
  return colon == std::string::npos || colon == 0 ? id : id.substr(0, colon);
}

int largest_dimension(std::span<const CurveFile> curves) {
  return std::ranges::max(curves, {}, &CurveFile::dimension).dimension;
}

void say_left_out(const std::string& name, std::size_t count, std::size_t all, std::string_view why) {
  fmt::print(stderr, "bezierbench: {}: {} of {} left out, the first because: {}\n", printable(name), count, all,
             printable(why));
}

extern const CurveCommand curve_eval, curve_convert, curve_derivative, curve_length, curve_at_length, curve_project,
    curve_interpolate, curve_fit, curve_split, curve_grid, curve_bspline, curve_spaced, curve_flatten, curve_box,
    curve_ease, curve_roots, curve_part, curve_elevate;

void add_curve(Command program, Exit& /*exit*/) {
  auto curve = program.command("curve", "solve one problem by any method, with its true error");
  curve.needs_command();
  for (const auto* one :
       {&curve_eval, &curve_convert, &curve_derivative, &curve_length, &curve_at_length, &curve_project,
        &curve_interpolate, &curve_fit, &curve_split, &curve_grid, &curve_bspline, &curve_spaced, &curve_flatten,
        &curve_box, &curve_ease, &curve_roots, &curve_part, &curve_elevate})
    one->add(curve.command(one->name, one->help));
}

}  // namespace bezierbench::cli
