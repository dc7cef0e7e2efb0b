// SPDX-License-Identifier: MIT
// `curve bspline`: the points of one B-spline curve, with weights or without, by any method, and the Bernstein form of
// the knot span by those that make it, against the exact ones; or a B-spline curve made of it: with knots inserted or
// removed, in a higher degree, a part, a derivative.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/bspline/kernel.hpp"
#include "core/error_free.hpp"
#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "reference/companion/bspline_control_points.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct BsplineOptions {
  std::string points;
  std::string knots;
  std::optional<std::string> weights;
  int closed = 0;  ///< its degree; 0 where it is not closed
  std::vector<std::string> t;
  std::vector<std::string> methods;
  bool control_points = false;

  // Another curve of it
  std::vector<std::string> insert;
  std::vector<std::string> remove;
  std::optional<std::string> tolerance;  ///< with `remove`
  int elevate_to = 0;                    ///< 0 where it is not given, as below
  int derivative = 0;
  std::optional<std::string> from;
  std::optional<std::string> to;
  std::optional<std::string> knots_out;

  /// How many other curves are requested.
  [[nodiscard]] int curves() const {
    return (insert.empty() ? 0 : 1) + (remove.empty() ? 0 : 1) + (elevate_to > 0 ? 1 : 0) + (derivative > 0 ? 1 : 0) +
           (from || to ? 1 : 0);
  }
};

/// The numbers of an option: separated by commas or, in a file that it names, by commas, blanks or line ends.
std::vector<double> numbers_of(const std::string& option, const std::string& text) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(text, ignored)) {
    if (text.find(',') == std::string::npos && !number::parse_number(text))
      throw Failure(Exit::usage, "{} {}: is neither a file nor numbers separated by commas; write either", option,
                    echo(text));
    return finite_numbers(option, text);
  }
  constexpr std::string_view separators = ", \t\r\n";
  const auto contents = contents_of(text);
  std::vector<double> numbers;
  for (auto begin = contents.find_first_not_of(separators); begin != std::string::npos;) {
    const auto end = std::min(contents.find_first_of(separators, begin), contents.size());
    numbers.push_back(finite_option(fmt::format("{} {}:", option, text), contents.substr(begin, end - begin)));
    begin = contents.find_first_not_of(separators, end);
  }
  return numbers;
}

/// Says on standard error which knots stand more than degree + 1 times.
void say_useless_knots(const BsplineCurve& curve) {
  const auto most = static_cast<std::ptrdiff_t>(curve.degree) + 1;
  for (auto first = curve.knots.begin(); first != curve.knots.end();) {
    const auto next = std::upper_bound(first, curve.knots.end(), *first);
    if (next - first > most)
      fmt::print(stderr,
                 "bezierbench: --knots: {} stands {} times; above degree + 1 = {} a control point has no influence\n",
                 number::decimal(*first), next - first, most);
    first = next;
  }
}

void require_order(const std::vector<double>& knots) {
  const auto descent = std::ranges::is_sorted_until(knots);
  if (descent != knots.end())
    throw Failure(Exit::usage, "--knots: {} follows on {}; knots must not descend", number::decimal(*descent),
                  number::decimal(*(descent - 1)));
}

/// Makes a closed curve of this degree of points and the knots of one period: its first points and spans follow again.
void close(BsplineCurve& curve, int degree, std::size_t points, const std::string& file) {
  const auto n = static_cast<std::size_t>(degree);
  if (curve.knots.size() != points + 1 || n > points)
    throw Failure(Exit::usage,
                  "--closed {}: {} knots for the {} points in {}; write {} knots, those of one period, and a degree of "
                  "at most {}",
                  degree, curve.knots.size(), points, file, points + 1, points);
  const auto one = curve.knots;
  require_order(one);
  bool is_exact = true;
  const auto shifted = [&is_exact](double knot, double by) {
    const auto sum = two_sum(knot, by);
    is_exact = is_exact && sum.error == 0;
    return sum.value;
  };
  const double period = shifted(one.back(), -one.front());
  for (std::size_t k = 1; k <= n; ++k) {
    curve.knots.insert(curve.knots.begin(), shifted(one[points - k], -period));
    curve.knots.push_back(shifted(one[k], period));
  }
  const auto is_finite = [](double knot) { return std::isfinite(knot); };
  if (!std::ranges::all_of(curve.knots, is_finite) || !std::ranges::is_sorted(curve.knots))
    throw Failure(Exit::usage,
                  "--closed {}: the knots of other periods exceed the largest double, or do not ascend after rounding; "
                  "write knots nearer to 0, and farther from each other",
                  degree);
  if (!is_exact)
    fmt::print(
        stderr,
        "bezierbench: --closed {}: the knots of other periods are rounded, so that the ends of the curve may not "
        "meet exactly; with integers as knots they meet\n",
        degree);
  const auto repeat = [n](std::vector<double>& numbers, std::size_t each) {
    for (std::size_t k = 0; k < n * each; ++k) numbers.push_back(numbers[k]);
  };
  repeat(curve.control_points, static_cast<std::size_t>(curve.dimension));
  if (!curve.weights.empty()) repeat(curve.weights, 1);
}

BsplineCurve curve_of(const BsplineOptions& options) {
  auto read = read_points(options.points, 2, true);
  std::size_t points = read.count();
  BsplineCurve curve{read.dimension, 1, numbers_of("--knots", options.knots), std::move(read.coordinates),
                     std::move(read.weights)};
  if (options.weights) {
    if (!curve.weights.empty())
      throw Failure(Exit::usage, "--weights: {} has a column w; leave one of them out", options.points);
    curve.weights = numbers_of("--weights", *options.weights);
    if (curve.weights.size() != points)
      throw Failure(Exit::usage, "--weights: {} for the {} points in {}; write one for each", curve.weights.size(),
                    points, options.points);
  }
  for (const double weight : curve.weights)
    if (!(weight > 0))
      throw Failure(Exit::usage, "{}: {} is not above 0, as every weight must be",
                    options.weights ? "--weights" : options.points + ", column w", number::decimal(weight));
  if (options.closed > 0) {
    close(curve, options.closed, points, options.points);
    points += static_cast<std::size_t>(options.closed);
  }
  if (curve.knots.size() < points + 2 || curve.knots.size() > 2 * points)
    throw Failure(Exit::usage,
                  "--knots: {} knots for the {} points in {}; a curve of degree n has n + 1 knots more than points, so "
                  "write {} to {}",
                  curve.knots.size(), points, options.points, points + 2, 2 * points);
  curve.degree = static_cast<int>(curve.knots.size() - points) - 1;
  require_order(curve.knots);
  if (!(curve.begin() < curve.end()))
    throw Failure(Exit::usage, "--knots: the curve begins and ends at {}; there is no span that is not empty",
                  number::decimal(curve.begin()));
  say_useless_knots(curve);
  return curve;
}

/// One t, and what is judged there: the point, then the control points of the Bernstein form of its span.
struct BsplineTarget {
  double t;
  BsplineSpanView span;
  std::vector<reference::ExactPoint> truth;
  std::vector<reference::ExactPoint> p_tilde;
  std::vector<double> weight_sums;               ///< of a rational curve, the sum of weights at each
  std::vector<reference::ExactPoint> weights{};  ///< of the control points of its Bernstein form
};

BsplineTarget target_of(const BsplineCurve& curve, double t) {
  if (t < curve.begin() || t > curve.end())
    throw Failure(Exit::usage, "--t {}: the curve is defined from {} to {}", number::decimal(t),
                  number::decimal(curve.begin()), number::decimal(curve.end()));
  BsplineTarget target{t, curve.span(curve.span_at(t)), {}, {}, {}};
  const auto knots = target.span.knots;
  const auto control_points = target.span.control_points;
  std::vector<double> magnitudes;
  for (const double x : control_points) magnitudes.push_back(std::abs(x));
  const auto add = [&](const reference::ExactBsplineWeights& basis) {
    const auto& w = target.span.weights;
    const auto rational = w.empty() ? basis : basis.with(w);
    target.truth.push_back(rational.sum(curve.dimension, control_points));
    target.p_tilde.push_back(rational.sum(curve.dimension, magnitudes));
    if (w.empty()) return;
    const auto sum = basis.sum(1, w);
    target.weight_sums.push_back(reference::round_to(reference::binary64, sum.coordinate(0)));
    if (target.truth.size() > 1) target.weights.push_back(sum);
  };
  add(reference::ExactBsplineWeights::at(knots, t));
  for (int k = 0; k <= target.span.degree; ++k) add(reference::ExactBsplineWeights::of_control_point(knots, k));
  return target;
}

/// The bound on one axis of point `k` of what a method writes.
double bound_of(const BsplineKernel& method, const BsplineTarget& target, std::size_t k, int axis) {
  const auto& part = k == 0 ? method.bound->point : *method.bound->control;
  const auto& span = target.span;
  const double p_tilde = reference::round_to(reference::binary64, target.p_tilde[k].coordinate(axis));
  metric::BsplineSizes sizes{span.degree, 1, p_tilde, 0};
  metric::BsplineWeightSizes weights{};
  for (std::size_t i = 0; i <= static_cast<std::size_t>(span.degree); ++i) {
    const double size =
        std::abs(span.control_points[i * static_cast<std::size_t>(span.dimension) + static_cast<std::size_t>(axis)]);
    sizes.largest = std::max(sizes.largest, size);
    if (span.weights.empty()) continue;
    weights.largest = std::max(weights.largest, span.weights[i]);
    weights.largest_product = std::max(weights.largest_product, span.weights[i] * size);
  }
  if (span.weights.empty()) return metric::bound_at(part, sizes, reference::double_arithmetic);
  weights.sum = target.weight_sums[k];
  return metric::bound_at(part, sizes, weights, reference::double_arithmetic);
}

void add_rows(const BsplineKernel& method, const BsplineTarget& target, CurveTable& table) {
  const auto d = static_cast<std::size_t>(target.span.dimension);
  std::vector<double> values(static_cast<std::size_t>(numbers_solved(method, target.span)));
  method.solve(target.span, target.t, values.data());
  const auto points = static_cast<std::size_t>(points_solved(method, target.span.degree));
  const auto first_fields = [&](std::size_t k) {
    return std::vector{std::string(method.info->id), number::decimal(target.t), k == 0 ? "" : std::to_string(k - 1)};
  };
  for (std::size_t k = 0; k < points; ++k)
    table.add_point(first_fields(k), std::span(values).subspan(k * d, d), target.truth[k], target.p_tilde[k],
                    [&](int axis) -> std::optional<double> {
                      if (method.bound == nullptr) return std::nullopt;
                      return bound_of(method, target, k, axis);
                    });
  for (std::size_t k = points * d; k < values.size(); ++k) {
    const std::size_t index = k - points * d;
    auto fields = first_fields(index + 1);
    fields.emplace_back("w");
    const auto truth = target.weights[index].coordinate(0);
    std::optional<double> bound;
    if (method.bound != nullptr)
      bound = metric::bound_at(
          *method.bound->control,
          {target.span.degree, 1, target.weight_sums[index + 1], *std::ranges::max_element(target.span.weights)},
          reference::double_arithmetic);
    const auto judged = judged_coordinate(values[k], truth, truth, bound);
    fields.insert(fields.end(), judged.begin(), judged.end());
    table.add_row(std::move(fields));
  }
}

/// The spans that are not empty in Bernstein form, by the first method that makes it. Their ids are their numbers.
curves::CurveSet spans_of(const BsplineCurve& curve, std::span<const BsplineKernel* const> methods) {
  const auto maker = std::ranges::find_if(methods, &BsplineKernel::makes_bernstein);
  if (maker == methods.end())
    throw Failure(Exit::usage, "--control-points: --method {} does not make them; leave it out",
                  methods.front()->info->id);
  curves::CurveSet set;
  for (auto k = static_cast<std::size_t>(curve.degree); k < curve.points(); ++k) {
    if (curve.knots[k] == curve.knots[k + 1]) continue;
    const auto span = curve.span(k);
    const auto d = static_cast<std::size_t>(span.dimension);
    std::vector<double> values(static_cast<std::size_t>(numbers_solved(**maker, span)));
    (*maker)->solve(span, curve.knots[k], values.data());
    const auto id = std::to_string(set.size());
    const auto numbers = std::span(values).subspan(d);
    const std::size_t coordinates = (static_cast<std::size_t>(span.degree) + 1) * d;
    const CurveView<double> view{span.weights.empty() ? Form::bernstein : Form::rational, span.dimension, span.degree,
                                 numbers.first(coordinates), numbers.subspan(coordinates)};
    set.add(id, view, !set.continues_path(id, view));
  }
  return set;
}

/// The knots that an option names, in the domain of the curve.
std::vector<double> knots_within(const std::string& option, const std::vector<std::string>& texts,
                                 const BsplineCurve& curve) {
  const auto knots = finite_options(option, texts);
  for (const double u : knots)
    if (u < curve.begin() || u > curve.end())
      throw Failure(Exit::usage, "{} {}: the curve is defined from {} to {}; write a number between", option,
                    number::decimal(u), number::decimal(curve.begin()), number::decimal(curve.end()));
  return knots;
}

using MadeCurve = std::optional<BsplineCurve>;

MadeCurve with_knots_inserted(const BsplineCurve& curve, const BsplineOptions& options) {
  const auto knots = knots_within("--insert", options.insert, curve);
  for (const double u : knots) {
    const auto most = curve.degree + (u == curve.begin() || u == curve.end() ? 1 : 0);
    const auto given = std::ranges::count(knots, u);
    const auto count = std::ranges::count(curve.knots, u) + given;
    if (count > most)
      throw Failure(Exit::usage, "--insert {}: the knot would stand {} times; leave {} of them out", number::decimal(u),
                    count, std::min(given, count - most));
  }
  return reference::with_knots_inserted(curve, knots);
}

MadeCurve with_knots_removed(const BsplineCurve& curve, const BsplineOptions& options) {
  const auto knots = knots_within("--remove", options.remove, curve);
  for (const double u : knots) {
    const auto count = u == curve.begin() || u == curve.end() ? 0 : std::ranges::count(curve.knots, u);
    if (count < std::ranges::count(knots, u))
      throw Failure(
          Exit::usage,
          "--remove {}: stands {} times between the ends of the curve; write a knot that stands there, and as "
          "often at most",
          number::decimal(u), count);
  }
  const double tolerance = options.tolerance ? finite_option("--tolerance", *options.tolerance) : 0;
  if (tolerance < 0)
    throw Failure(Exit::usage, "--tolerance {}: is a distance; write 0 or more", number::decimal(tolerance));
  auto removed = reference::with_knots_removed(curve, knots);
  if (!removed) return std::nullopt;
  if (std::isinf(removed->deviation))
    throw Failure(Exit::input_output,
                  "--remove: how far a point might move exceeds the largest double; scale the coordinates down");
  const auto deviation = number::decimal(removed->deviation);
  if (removed->deviation > tolerance)
    throw Failure(Exit::finding, "--remove: a point of the curve might move by {}; write --tolerance {} to allow it",
                  deviation, deviation);
  if (removed->deviation > 0)
    fmt::print(stderr, "bezierbench: --remove: no point of the curve moves farther than {}\n", deviation);
  return removed->curve;
}

MadeCurve part_of(const BsplineCurve& curve, const BsplineOptions& options) {
  const auto bound = [&](const std::string& option, const std::optional<std::string>& text, double otherwise) {
    return text ? knots_within(option, {*text}, curve).front() : otherwise;
  };
  const double from = bound("--from", options.from, curve.begin());
  const double to = bound("--to", options.to, curve.end());
  if (!(from < to))
    throw options.from
        ? Failure(Exit::usage, "--from {}: the part ends at {}; write a number below", number::decimal(from),
                  number::decimal(to))
        : Failure(Exit::usage, "--to {}: the curve begins there; write a number above", number::decimal(to));
  return reference::part_of_bspline(curve, from, to);
}

MadeCurve derivative_of(const BsplineCurve& curve, int order) {
  if (!curve.weights.empty())
    throw Failure(Exit::usage,
                  "--derivative: that of a rational curve is not one of its degree; write --control-points, and ask "
                  "`curve derivative` for values");
  if (order >= curve.degree)
    throw Failure(Exit::usage, "--derivative {}: the curve has degree {}; write a lower order", order, curve.degree);
  return reference::derivative_of_bspline(curve, order);
}

MadeCurve elevated(const BsplineCurve& curve, int degree) {
  if (curve.degree > reference::max_elevated_bspline_degree)
    throw Failure(Exit::usage,
                  "--elevate-to: the curve has degree {}, and only {} and less can be elevated; leave it out",
                  curve.degree, reference::max_elevated_bspline_degree);
  if (degree < curve.degree)
    throw Failure(Exit::usage, "--elevate-to {}: the curve has degree {}; write that or a higher one", degree,
                  curve.degree);
  return reference::elevated_bspline(curve, degree);
}

/// Prints the control points of the curve that the options request, and writes its knots.
void make_curve(const BsplineCurve& curve, const BsplineOptions& options) {
  if (options.curves() > 1 || !options.t.empty() || options.control_points || !options.methods.empty())
    throw Failure(
        Exit::usage,
        "--insert, --remove, --elevate-to, --derivative and --from with --to each print another curve, without "
        "--t, --method and --control-points; write one of them, and read its result again");
  if (options.tolerance && options.remove.empty())
    throw Failure(Exit::usage, "--tolerance goes with --remove; leave it out");
  if (!options.knots_out)
    throw Failure(Exit::usage,
                  "--knots-out is required: the file for the knots of the curve that is printed; give one");
  const auto made = !options.insert.empty()   ? with_knots_inserted(curve, options)
                    : !options.remove.empty() ? with_knots_removed(curve, options)
                    : options.elevate_to > 0  ? elevated(curve, options.elevate_to)
                    : options.derivative > 0  ? derivative_of(curve, options.derivative)
                                              : part_of(curve, options);
  if (!made)
    throw Failure(Exit::usage, "{}: a control point would have a weight that is not above 0; choose other knots",
                  options.points);
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(made->control_points, is_finite) || !std::ranges::all_of(made->weights, is_finite))
    throw Failure(Exit::input_output, "{}: a control point exceeds the largest double; scale the coordinates down",
                  options.points);
  std::vector<std::string> header;
  for (int axis = 0; axis < made->dimension; ++axis) header.push_back(axis_name(axis));
  if (!made->weights.empty()) header.emplace_back("w");
  bundle::CsvTable table(header);
  const auto d = static_cast<std::size_t>(made->dimension);
  for (std::size_t i = 0; i < made->points(); ++i) {
    std::vector<std::string> row;
    for (std::size_t axis = 0; axis < d; ++axis) row.push_back(number::decimal(made->control_points[i * d + axis]));
    if (!made->weights.empty()) row.push_back(number::decimal(made->weights[i]));
    table.add_row(std::move(row));
  }
  std::string knots;
  for (const double knot : made->knots) knots += number::decimal(knot) + "\n";
  bundle::write_file(*options.knots_out, knots, "--knots-out");
  fmt::print("{}", table.text());
}

void run_bspline(const BsplineOptions& options) {
  const auto curve = curve_of(options);
  if (options.curves() > 0) {
    make_curve(curve, options);
    return;
  }
  if (options.tolerance || options.knots_out)
    throw Failure(
        Exit::usage,
        "--tolerance goes with --remove, and --knots-out with an option that prints another curve; leave it out");
  const auto form = curve.weights.empty() ? Form::bernstein : Form::rational;
  const CurveFile of_degree{{}, form, 1, std::vector<double>(static_cast<std::size_t>(curve.degree) + 1), {}};
  const auto methods = chosen(bspline_kernels(curve.dimension), options.methods, of_degree, Problem::bspline);
  if (options.control_points) {
    fmt::print("{}", curves::to_csv(spans_of(curve, methods), number::decimal));
    return;
  }
  if (options.t.empty()) throw Failure(Exit::usage, "--t is required; write --t T, or --control-points for all spans");
  std::vector<BsplineTarget> targets;
  for (const double t : finite_options("--t", options.t)) targets.push_back(target_of(curve, t));
  CurveTable table(false, false, judged_columns({"method", "t", "index"}));
  for (const auto* method : methods)
    for (const auto& target : targets) add_rows(*method, target, table);
  table.print();
}

void add_bspline(Command command) {
  auto options = std::make_shared<BsplineOptions>();
  command.option("--points", options->points, "control points (CSV), and in a column w their weights")
      .required()
      .takes(file_value);
  command
      .option("--knots", options->knots,
              "all knots, separated by commas, or a file of them; degree + 1 more than points")
      .required()
      .takes("U0,U1,...|FILE");
  command.option("--weights", options->weights, "weights of a rational curve (NURBS), above 0, one for each point")
      .takes("W0,W1,...|FILE");
  command
      .option("--closed", options->closed,
              "degree of a closed curve, whose knots are those of one period, one more than points")
      .within(1);
  command.option("--t", options->t, "parameter; may be repeated").takes("T");
  command.flag("--control-points", options->control_points,
               "print the spans in Bernstein form as a set of curves, by the first method that makes it");
  command.option("--insert", options->insert, "print the curve with a knot inserted; may be repeated")
      .one_each_time()
      .takes("U");
  command
      .option("--remove", options->remove,
              "print the curve without a knot, where no point moves farther than the tolerance; may be repeated")
      .one_each_time()
      .takes("U");
  command.option("--tolerance", options->tolerance, "with --remove; 0 where it is left out: the curve stays the same")
      .takes("DISTANCE");
  command
      .option("--elevate-to", options->elevate_to,
              fmt::format("print the curve in this degree, at most {}", reference::max_elevated_bspline_degree))
      .within(1, reference::max_elevated_bspline_degree);
  command.option("--derivative", options->derivative, "print the derivative of this order, of a curve without weights")
      .within(1);
  command.option("--from", options->from, "print the part from this parameter, else from where the curve begins")
      .takes("T");
  command.option("--to", options->to, "print the part to this parameter, else to where the curve ends").takes("T");
  command.option("--knots-out", options->knots_out, "file for the knots of the curve that is printed; --knots reads it")
      .takes(file_value);
  add_method_option(command, Problem::bspline, options->methods);
  command.action([options] { run_bspline(*options); });
}

}  // namespace

extern constexpr CurveCommand curve_bspline{
    "bspline", "evaluate a B-spline curve; insert and remove knots, elevate, differentiate and cut it", add_bspline};

}  // namespace bezierbench::cli
