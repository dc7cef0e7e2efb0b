// SPDX-License-Identifier: MIT
// `curve ease`: y for x on easing curves by any method, against the exact y.
#include <array>

#include "core/easing/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"
#include "reference/companion/easing.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct EaseOptions {
  std::vector<std::string> beziers;
  std::optional<std::string> file;
  std::vector<std::string> x;
  std::vector<std::string> methods;
};

struct EasingCase {
  std::string id;
  EasingCurve<double> curve;
};

/// Throws Failure(usage) unless x1 and x2 are in [0, 1].
EasingCase checked(const std::string& name, std::string id, const EasingCurve<double>& curve) {
  if (!is_easing(curve))
    throw Failure(Exit::usage, "{}: x1 and x2 must be in [0, 1], but are {} and {}", name, number::decimal(curve.x1),
                  number::decimal(curve.x2));
  return {std::move(id), curve};
}

std::vector<EasingCase> cases_of(const EaseOptions& options) {
  std::vector<EasingCase> cases;
  for (const auto& text : options.beziers) {
    const auto values = finite_numbers("--bezier", text);
    if (values.size() != 4)
      throw Failure(Exit::usage, "--bezier {}: {} number{}; write X1,Y1,X2,Y2", text, values.size(),
                    values.size() == 1 ? "" : "s");
    cases.push_back(checked("--bezier " + text, text, {values[0], values[1], values[2], values[3]}));
  }
  if (options.file)
    for (const auto& curve : read_curves(*options.file, Form::bernstein)) {
      const auto name = curve.id.empty() ? *options.file : fmt::format("{}#{}", *options.file, echo(curve.id));
      const auto& c = curve.coefficients;
      const bool is_plane_cubic = curve.form == Form::bernstein && curve.dimension == 2 && curve.degree() == 3;
      if (!is_plane_cubic || c[0] != 0 || c[1] != 0 || c[6] != 1 || c[7] != 1)
        throw Failure(Exit::usage, "{}: must be a plane cubic from (0, 0) to (1, 1)", name);
      cases.push_back(checked(name, curve.id, {c[2], c[3], c[4], c[5]}));
    }
  if (cases.empty()) throw Failure(Exit::usage, "--bezier is required; write --bezier X1,Y1,X2,Y2, or --curve FILE");
  return cases;
}

/// The nearest double to y, and the error.
std::array<std::string, 3> judged(const EasingCurve<double>& c, double x, double y) {
  reference::ExactEased exact(c.x1, c.y1, c.x2, c.y2, x);
  return {number::decimal(exact.nearest(reference::binary64)), number::decimal(exact.error(y)),
          number::decimal(exact.error_ulp(y, reference::binary64))};
}

void ease_curves(const EaseOptions& options) {
  const auto cases = cases_of(options);
  const auto x = finite_options("--x", options.x);
  std::vector<const EasingKernel*> methods;
  for (const auto& id : options.methods) methods.push_back(&chosen_one(easing_kernels(), id, Problem::easing));
  if (methods.empty())
    for (const auto& kernel : easing_kernels()) methods.push_back(&kernel);
  CurveTable table(cases.size() > 1, false, {"method", "x", "t", "y", "exact", "error", "error_ulp"});
  std::vector<Eased<double>> eased(x.size());
  for (const auto& [id, curve] : cases) {
    table.begin(id);
    for (const auto* method : methods) {
      method->ease(curve, x, eased.data());
      for (std::size_t k = 0; k < x.size(); ++k) {
        const auto [exact, error, error_ulp] = judged(curve, x[k], eased[k].y);
        table.add_row({std::string(method->info->id), number::decimal(x[k]), number::decimal(eased[k].t),
                       number::decimal(eased[k].y), exact, error, error_ulp});
      }
    }
  }
  table.print();
}

void add_ease(Command command) {
  const auto options = std::make_shared<EaseOptions>();
  command
      .option("--bezier", options->beziers,
              "inner control points of an easing curve, as in cubic-bezier() of CSS; may be repeated")
      .one_each_time()
      .takes("X1,Y1,X2,Y2");
  command.option("--curve", options->file, "file of more easing curves (CSV), cubics from (0, 0) to (1, 1)")
      .takes(file_value);
  command.option("--x", options->x, "where y is wanted; outside [0, 1] on the tangents; may be repeated")
      .required()
      .one_each_time()
      .takes("X");
  add_method_option(command, Problem::easing, options->methods);
  command.action([options] { ease_curves(*options); });
}

}  // namespace

extern constexpr CurveCommand curve_ease{"ease", "find y for x on easing curves, cubic-bezier() of CSS", add_ease};

}  // namespace bezierbench::cli
