// SPDX-License-Identifier: MIT
// Studies of kind `inverse_arc_length`: the parameter at a share of the length of random curves, to each tolerance,
// against the true parameter. The share is the trial's t, drawn from the interval of t. A method that reports that it
// kept its tolerance and did not fails the run. Writes inverse_arc_length.csv, and for each study spacing.csv: the
// curve of its first trial with points at equal steps of t and at equal steps of the length.
#include <cmath>
#include <string_view>

#include "experiments/sample/draw.hpp"
#include "experiments/studies/inverse_arc_length/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "experiments/suite/kind.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/exact_curve.hpp"
#include "reference/length/length_truth.hpp"
#include "reference/rational.hpp"

namespace bezierbench::studies {

namespace {

using reference::LongReal;

struct Spacing {
  std::string_view id;
  int steps;
  bool by_length;
  bool measured;  ///< whether its points have shares and gaps
};

constexpr const char* axes[]{"x", "y", "z"};

constexpr Spacing spacings[]{
    {"outline", 200, false, false}, {"parameter", 20, false, true}, {"arc_length", 20, true, true}};

}  // namespace

void add_spacing(tables::Tables& tables, const suite::Study& study, const sample::Cell& cell, std::uint64_t seed) {
  const auto of = tables::drawn_fields(cell);
  sample::Trial drawn;
  sample::Sampler(seed, study.id, cell).draw(0, drawn);
  const CurveView<double> curve{study.form, cell.dimension, cell.degree, drawn.coefficients, drawn.weights};
  if (reference::pole(curve)) return;
  const reference::LengthAlong<LongReal> lengths(curve);
  reference::ExactCurve exact;
  for (const auto& [id, steps, by_length, measured] : spacings) {
    const bool any = measured && lengths.whole() > 0;
    LongReal before = 0;
    for (int k = 0; k <= steps; ++k) {
      const LongReal part = LongReal(k) / steps;
      const double t = LongReal(by_length ? lengths.parameter_at(part * lengths.whole()) : part).convert_to<double>();
      const LongReal share = any ? LongReal(lengths.length_to(LongReal(t)) / lengths.whole()) : LongReal(0);
      tables::Row row("spacing.csv");
      row.set("study", study.id)
          .set("dimension", cell.dimension)
          .set("degree", cell.degree)
          .set("coordinate_range", of[0])
          .set("generator", of[3])
          .set("curves", of[4])
          .set("trial", 0)
          .set("spacing", id)
          .set("index", k)
          .set("t", t);
      const auto& point = exact.point(curve, t);
      for (int axis = 0; axis < cell.dimension; ++axis)
        row.set(axes[axis], reference::round_to(reference::binary64, point.coordinate(axis)));
      if (any) row.set("share", share.convert_to<double>());
      if (any && k > 0) row.set("gap", LongReal((share - before) * steps).convert_to<double>());
      before = share;
      tables.add(row);
    }
  }
}

void InverseArcLengthProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  drawn.truth.reset();
  if (reference::pole(drawn.curve)) return;
  drawn.truth.emplace(drawn.curve, tier_);
  drawn.target = drawn.truth->length_at_share(drawn.trial.t);
}

void InverseArcLengthProblem::judge(const Kernel& /*method*/, Drawn& drawn, double tolerance, const Answer& answer,
                                    std::uint64_t number, Errors& errors) {
  if (!drawn.truth) return;  // a pole
  errors.promises.add(answer.converged, answer.evaluations);
  errors.iterations.add(static_cast<double>(answer.iterations));
  if (!std::isfinite(answer.t)) {
    ++errors.promises.non_finite;
    return;
  }
  const double length = drawn.truth->whole();
  const double error = drawn.truth->error_of_length(answer.t, drawn.target, metric::to_24_bits);
  errors.error.add(error);
  errors.relative.add(error == 0 ? 0 : metric::to_24_bits(error / length));
  errors.t_error.add(drawn.truth->error_of_parameter(answer.t, drawn.target, metric::to_24_bits));
  errors.outside += answer.t < 0 || answer.t > 1 ? 1 : 0;
  errors.promises.judge(answer.converged, error, tolerance * length, number);
}

bool InverseArcLengthProblem::is_right(const Kernel& /*method*/, const Drawn& drawn, double tolerance,
                                       const Answer& answer) {
  if (!drawn.truth) return true;
  if (!std::isfinite(answer.t)) return false;
  const double error = drawn.truth->error_of_length(answer.t, drawn.target, metric::to_24_bits);
  return Promises::keeps(error, tolerance * drawn.truth->whole());
}

namespace {

constexpr std::array inverse_arc_length_fields{suite::field<&suite::Study::tolerance>(suite::tolerance_key(
    "tolerances that the methods are given, relative to the length of the whole curve", "[1e-3, 1e-6]"))};

}  // namespace

extern constexpr StudyKind inverse_arc_length_kind = companion_kind<InverseArcLengthProblem>(
    {.id = "inverse_arc_length",
     .about = "errors of the parameter at a length, and whether tolerances are kept",
     .own = inverse_arc_length_fields,
     .methods_example = "[\"bracketed_newton\"]",
     .inputs = {.forms = suite::forms_with_control_points,
                .forms_reason = "lengths are those of Bezier curves",
                .double_only = true,
                .parameters = suite::Parameters::from_0_to_1,
                .parameters_reason = "the share of the length at which t is sought"}});

}  // namespace bezierbench::studies
