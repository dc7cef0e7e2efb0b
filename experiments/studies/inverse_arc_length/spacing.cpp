// SPDX-License-Identifier: MIT
#include "experiments/studies/inverse_arc_length/spacing.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "experiments/number/number.hpp"
#include "experiments/sample/draw.hpp"
#include "reference/exact_curve.hpp"
#include "reference/length_along.hpp"
#include "reference/rational.hpp"

namespace bezierbench::studies {
namespace {

using reference::LongReal;

struct Spacing {
  std::string_view id;
  int steps;
  bool by_length;
  bool measured;  ///< has shares and gaps
};

constexpr Spacing spacings[]{
    {"outline", 200, false, false}, {"parameter", 20, false, true}, {"arc_length", 20, true, true}};

const std::vector<std::string> columns{
    "study", "dimension", "degree", "coordinate_range", "generator", "trial", "spacing", "index", "t", "x", "y",
    "z",     "share",     "gap"};

std::string decimal(const LongReal& value) { return number::decimal(value.convert_to<double>()); }

}  // namespace

void add_spacing(tables::Tables& tables, const suite::Study& study, const sample::Cell& cell, std::uint64_t seed) {
  sample::Trial drawn;
  sample::Sampler(seed, study.id, cell).draw(0, drawn);
  const CurveView<double> curve{Form::bernstein, cell.dimension, cell.degree, drawn.coefficients};
  const reference::LengthAlong lengths(curve);
  reference::ExactCurve exact;
  auto& table = tables.table("spacing.csv", columns);
  for (const auto& [id, steps, by_length, measured] : spacings) {
    const bool any = measured && lengths.whole() > 0;
    LongReal before = 0;
    for (int k = 0; k <= steps; ++k) {
      const LongReal part = LongReal(k) / steps;
      const double t = LongReal(by_length ? lengths.parameter_at(part * lengths.whole()) : part).convert_to<double>();
      const LongReal share = any ? LongReal(lengths.length_to(LongReal(t)) / lengths.whole()) : LongReal(0);
      std::vector<std::string> row{study.id,
                                   std::to_string(cell.dimension),
                                   std::to_string(cell.degree),
                                   number::decimal(cell.coordinate_range),
                                   cell.generator,
                                   "0",
                                   std::string(id),
                                   std::to_string(k),
                                   number::decimal(t)};
      const auto& point = exact.point(curve, t);
      for (int axis = 0; axis < 3; ++axis)
        row.push_back(axis < cell.dimension
                          ? number::decimal(reference::round_to(reference::binary64, point.coordinate(axis)))
                          : "");
      row.push_back(any ? decimal(share) : "");
      row.push_back(any && k > 0 ? decimal((share - before) * steps) : "");
      before = share;
      table.add_row(std::move(row));
    }
  }
}

}  // namespace bezierbench::studies
