// SPDX-License-Identifier: MIT
#include "experiments/studies/inverse_arc_length/spacing.hpp"

#include <string_view>

#include "experiments/sample/draw.hpp"
#include "reference/exact_curve.hpp"
#include "reference/length/length_along.hpp"
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
  sample::Trial drawn;
  sample::Sampler(seed, study.id, cell).draw(0, drawn);
  const CurveView<double> curve{Form::bernstein, cell.dimension, cell.degree, drawn.coefficients};
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
          .set("coordinate_range", cell.coordinate_range)
          .set("generator", cell.generator)
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

}  // namespace bezierbench::studies
