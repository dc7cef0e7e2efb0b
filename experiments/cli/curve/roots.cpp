// SPDX-License-Identifier: MIT
// `curve roots`: every parameter at which a coordinate has a value or is stationary, or a plane curve has an
// inflection, with its multiplicity: the true ones, rounded once; or the answers of methods, compared with them.
#include <cmath>
#include <limits>

#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/studies/roots/problem.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr const char* of_value = "value";
constexpr const char* of_extrema = "extrema";
constexpr const char* of_inflections = "inflections";

struct RootsOptions {
  CurveOptions curve;
  std::string of = of_value;
  std::optional<std::string> value;
  std::vector<std::string> methods;
};

void add_rows(const std::string& axis, const reference::Roots& found, const CurveFile& curve, int dimension,
              CurveTable& table) {
  const auto add = [&](const std::string& t, const std::string& multiplicity, const std::vector<std::string>& point) {
    table.add_row({axis, t, multiplicity}, 0, point);
  };
  if (found.everywhere) add("", "inf", std::vector<std::string>(static_cast<std::size_t>(dimension)));
  for (const auto& [t, multiplicity] : found.roots)
    add(number::decimal(t), std::to_string(multiplicity), point_fields_at(curve.view(), t, dimension));
}

/// A row for each answer, with its root where it has one, and for each root without an answer.
void add_judged_rows(const CurveView<double>& curve, std::span<const RootsKernel* const> methods, int axis,
                     double value, CurveTable& table) {
  const auto truth = reference::roots_of_value(curve, axis, value);
  for (const auto* method : methods) {
    const auto answers = method->find(curve, axis, value).t;
    const auto match = studies::matched(truth.roots, answers);
    const auto add = [&](const std::string& t, const std::string& error, std::size_t root) {
      std::vector<std::string> row{std::string(method->info->id), axis_name(axis), t, "", "", error};
      if (truth.everywhere) row[4] = "inf";
      if (root < truth.roots.size()) {
        row[3] = number::decimal(truth.roots[root].t);
        row[4] = std::to_string(truth.roots[root].multiplicity);
      }
      table.add_row(std::move(row));
    };
    for (std::size_t k = 0; k < answers.size(); ++k) {
      const auto root = match.root_of[k];
      add(number::decimal(answers[k]),
          root < truth.roots.size() ? number::decimal(std::abs(answers[k] - truth.roots[root].t)) : "", root);
    }
    if (truth.everywhere && answers.empty()) add("", "", 0);
    for (std::size_t root = 0; root < truth.roots.size(); ++root)
      if (match.error[root] == std::numeric_limits<double>::infinity()) add("", "", root);
  }
}

void find_judged_roots(const RootsOptions& options, double value) {
  if (options.of != of_value) throw Failure(Exit::usage, "--method: methods take --of value; leave one of the two out");
  const auto curves = options.curve.read();
  CurveTable table(curves.size() > 1, false, {"method", "axis", "t", "exact_t", "multiplicity", "error"});
  for (const auto& curve : curves) {
    table.begin(curve.id);
    const auto methods = chosen(roots_kernels(), options.methods, curve, Problem::roots);
    for (int axis = 0; axis < curve.dimension; ++axis) add_judged_rows(curve.view(), methods, axis, value, table);
  }
  table.print();
}

void find_roots(const RootsOptions& options) {
  if (options.value && options.of != of_value)
    throw Failure(Exit::usage, "--value: goes with --of value; leave one of them out");
  const double value = options.value ? finite_option("--value", *options.value) : 0;
  if (!options.methods.empty()) return find_judged_roots(options, value);
  const auto curves = options.curve.read();
  const int dimension = largest_dimension(curves);
  CurveTable table(curves.size() > 1, false, with_axes({"axis", "t", "multiplicity"}, dimension));
  for (const auto& curve : curves) {
    const auto name =
        curves.size() > 1 ? fmt::format("{}#{}", options.curve.name(), echo(curve.id)) : options.curve.name();
    refuse_pole(curve.view(), 0, 1, name);
    table.begin(curve.id);
    if (options.of == of_inflections) {
      if (curve.dimension != 2)
        throw Failure(Exit::usage, "{}: must be a curve in the plane; ask for --of extrema or for a --value", name);
      add_rows("", reference::roots_of_curvature(curve.view()), curve, dimension, table);
      continue;
    }
    for (int axis = 0; axis < curve.dimension; ++axis)
      add_rows(axis_name(axis),
               options.of == of_extrema ? reference::roots_of_derivative(curve.view(), axis)
                                        : reference::roots_of_value(curve.view(), axis, value),
               curve, dimension, table);
  }
  table.print();
}

void add_roots(Command command) {
  const auto options = std::make_shared<RootsOptions>();
  options->curve.add_to(command);
  command
      .option("--of", options->of,
              "what to find: where a coordinate has a value, where it is stationary, or where x'y'' = x''y' on a "
              "plane curve; default: value")
      .one_of({of_value, of_extrema, of_inflections});
  command.option("--value", options->value, "value of the coordinate; default: 0").takes("V");
  command
      .option("--method", options->methods,
              "method whose answers are compared with the true roots; may be repeated; default: the true roots alone")
      .takes("METHOD", methods_of(Problem::roots));
  command.action([options] { find_roots(*options); });
}

}  // namespace

extern constexpr CurveCommand curve_roots{"roots", "find all roots, extrema or inflections, with their multiplicities",
                                          add_roots};

}  // namespace bezierbench::cli
