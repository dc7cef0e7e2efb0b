// SPDX-License-Identifier: MIT
#include "reference/length/length_panels.hpp"

#include <limits>
#include <string>
#include <utility>

namespace bezierbench::reference {
namespace {

constexpr int depth_limit = 200;
constexpr double work_limit = 1.5e8;  // products, some ten seconds; then panels are taken as they are

constexpr auto unit = std::numeric_limits<LongReal>::epsilon;

LongReal largest(const std::vector<LongReal>& values) {
  LongReal result = 0;
  for (const LongReal& x : values)
    if (abs(x) > result) result = abs(x);
  return result;
}

/// Each step of de Casteljau's algorithm changes a coordinate by at most 4 units of what the same steps give of the
/// sizes of the coordinates, of which the largest is given. from / to, where the second cut is, is rounded too: that
/// moves the beginning of the part.
LongReal rounding_of_part(const LongHodograph& h, const LongReal& largest_size, double from, double to) {
  const auto d = static_cast<double>(h.dimension);
  LongReal off = 8 * d * static_cast<double>(h.degree() + 1) * unit() * largest_size;
  if (from > 0 && from < to) off += 4 * d * unit() * largest(h.vectors) * to / (LongReal(to) - LongReal(from));
  return off;
}

/// The uncertainty of a length that is computed with 70 digits. The values of h that a series is made of are right to 8
/// (m + 1) units of the largest control vector, and so its coefficients, of which there are m + 1. Halving a panel and
/// Clenshaw's algorithm change values by at most 4 (m + 1)^2 units of the sum of the coefficients, and no panel is
/// halved more than 200 times.
LongReal rounding(const LongHodograph& h, const SpeedSeries& series) {
  const auto count = static_cast<double>(h.degree() + 1);
  return unit() * static_cast<double>(h.dimension) * count * count *
         (8 * largest(h.vectors) + 4 * depth_limit * series.largest());
}

}  // namespace

LongHodograph long_hodograph(const CurveView<double>& curve, double from, double to) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  LongHodograph h{d, {}};
  for (std::size_t k = d; k < curve.coefficients.size(); ++k)
    h.vectors.push_back(curve.degree * (LongReal(curve.coefficients[k]) - LongReal(curve.coefficients[k - d])));
  if (h.vectors.empty()) h.vectors.assign(d, 0);
  auto sizes = h;
  for (LongReal& x : sizes.vectors) x = abs(x);
  for (auto* cut : {&h, &sizes}) {
    if (to < 1) cut->split(to);
    if (from > 0) *cut = cut->split(LongReal(from) / LongReal(to));
  }
  h.off = rounding_of_part(h, largest(sizes.vectors), from, to);
  return h;
}

LengthPanels::LengthPanels(const LongHodograph& hodograph) : halving_(hodograph.degree()) {
  const SpeedSeries series(hodograph);
  negligible_ = series.mean_speed_to(1) * LongReal("1e-36");
  add(series, 0, 1, 0, 0);
  uncertainty_ += hodograph.off + rounding(hodograph, series);
  // The length of a straight line that does not turn is its chord, without the roundings of a rule.
  const LongReal chord = hodograph.chord();
  const LongReal longer = hodograph.polygon() - chord;
  if (longer > chord * LongReal("1e-60")) return;
  length_ = chord;
  uncertainty_ = hodograph.off + chord * LongReal("1e-60");
}

void LengthPanels::add(SpeedSeries series, const LongReal& begin, const LongReal& width, const LongReal& cut_before,
                       int depth) {
  const LongReal allowed = negligible_ / width;
  const LongReal cut = cut_before + series.shorten(allowed / 8);
  const LongReal chord = series.chord_to(1);
  const LongReal slack = series.largest() - chord;
  const LongReal missed = series.proved_miss(allowed);
  const bool proved = missed >= 0;
  const auto terms = static_cast<double>((series.degree() + 1) * series.dimension());
  if (proved || slack <= allowed || depth == depth_limit || work_ > work_limit) {
    const LongReal speed = proved ? series.mean_speed_to(1) : LongReal(chord + slack / 2);
    work_ += 44 * terms;
    length_ += width * speed;
    uncertainty_ += width * ((proved ? missed : LongReal(slack / 2)) + cut);
    panels_.push_back({begin, width, std::move(series), width * speed});
    return;
  }
  work_ += terms * static_cast<double>(series.degree() + 1);
  const SpeedSeries right = series.halve(halving_);
  const LongReal half = width / 2;
  add(std::move(series), begin, half, cut, depth + 1);
  add(right, begin + half, half, cut, depth + 1);
}

NotCertain::NotCertain(LongReal length, const LongReal& uncertainty)
    : std::runtime_error("the true length is not certain to 30 digits, " +
                         (uncertainty < length ? "only to " + LongReal(uncertainty / length).str(2) + " of itself"
                                               : std::string("nor to one"))),
      length_(std::move(length)) {}

void require_certain(const LongReal& length, const LongReal& uncertainty) {
  if (uncertainty > length * LongReal("1e-30")) throw NotCertain(length, uncertainty);
}

}  // namespace bezierbench::reference
