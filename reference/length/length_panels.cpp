// SPDX-License-Identifier: MIT
#include "reference/length/length_panels.hpp"

#include <string>
#include <utility>

#include "reference/stop.hpp"

namespace bezierbench::reference {
namespace {

constexpr int depth_limit = 200;

template <class Real>
Real largest(const std::vector<Real>& values) {
  Real result = 0;
  for (const Real& x : values)
    if (abs(x) > result) result = abs(x);
  return result;
}

/// A bound of what rounding adds to the length of the part. Each step of de Casteljau's algorithm rounds a coordinate
/// by at most 4 units of the convex combination of magnitudes, which `largest_size` bounds. The quotient from / to, at
/// which the curve is cut the second time, is rounded as well: this moves the beginning of the part.
template <class Real>
Real rounding_of_part(const Hodograph<Real>& h, const Real& largest_size, double from, double to) {
  const Real unit = Precision<Real>::unit();
  const auto d = static_cast<double>(h.dimension);
  Real off = 8 * d * static_cast<double>(h.degree() + 1) * unit * largest_size;
  if (from > 0 && from < to) off += 4 * d * unit * largest(h.vectors) * to / (Real(to) - Real(from));
  return off;
}

/// What roundings in its values change the series of h by, with c = m + 1 coefficients. The values are right to 2 c
/// units of the largest control vector, and interpolation raises that by at most 6 (its Lebesgue constant is 1 + 2/pi
/// ln c at these nodes). The sums of c values lose c/8 units in each of c coefficients, twice for the factor 2.
template <class Real>
Real rounding_of_series(const Hodograph<Real>& h) {
  const auto c = static_cast<double>(h.degree() + 1);
  return (12 * c + (c + 3) * c / 4) * static_cast<double>(h.dimension) * largest(h.vectors);
}

}  // namespace

template <class Real>
Hodograph<Real> hodograph(const CurveView<double>& curve, double from, double to) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  Hodograph<Real> h{d, {}};
  for (std::size_t k = d; k < curve.coefficients.size(); ++k)
    h.vectors.push_back(curve.degree * (Real(curve.coefficients[k]) - Real(curve.coefficients[k - d])));
  if (h.vectors.empty()) h.vectors.assign(d, 0);
  auto sizes = h;
  for (Real& x : sizes.vectors) x = abs(x);
  for (auto* cut : {&h, &sizes}) {
    if (to < 1) cut->split(to);
    if (from > 0) *cut = cut->split(Real(from) / Real(to));
  }
  h.off = rounding_of_part(h, largest(sizes.vectors), from, to);
  return h;
}

template <class Real>
LengthPanels<Real>::LengthPanels(const Hodograph<Real>& hodograph) : halving_(hodograph.degree()) {
  const SpeedSeries<Real> series(hodograph);
  negligible_ = series.mean_speed_to(1) * Precision<Real>::negligible;
  add(series, 0, 1, 0, 0);
  const Real sum_of_panels = series.largest() * (static_cast<double>(panels_.size()) / 8);
  uncertainty_ += hodograph.off + Precision<Real>::unit() * (rounding_of_series(hodograph) + sum_of_panels);
  // The length of a straight line that does not turn is its chord, without the roundings of a rule.
  const Real chord = hodograph.chord();
  const Real longer = hodograph.polygon() - chord;
  if (longer > chord * Precision<Real>::straight) return;
  length_ = chord;
  uncertainty_ = hodograph.off + 2 * chord * Precision<Real>::straight;
}

template <class Real>
void LengthPanels<Real>::add(SpeedSeries<Real> series, const Real& begin, const Real& width, const Real& off_before,
                             int depth) {
  StopWhen::poll();
  const Real allowed = negligible_ / width;
  const Real off = off_before + series.shorten(allowed / 8);
  const Real chord = series.chord_to(1);
  const Real slack = series.largest() - chord;
  const Real missed = series.proved_miss(allowed);
  const bool proved = missed >= 0;
  const auto terms = static_cast<double>((series.degree() + 1) * series.dimension());
  if (proved || slack <= allowed || depth == depth_limit || work_ > Precision<Real>::work_limit) {
    const Real speed = proved ? series.mean_speed_to(1) : Real(chord + slack / 2);
    work_ += Precision<Real>::points_of_rule * terms;
    length_ += width * speed;
    const Real rounding = series.rounding_of_speed() + series.largest() * (Precision<Real>::points_of_rule / 8.0 + 2);
    uncertainty_ += width * ((proved ? missed : Real(slack / 2)) + off + Precision<Real>::unit() * rounding);
    panels_.push_back({begin, width, std::move(series), width * speed});
    return;
  }
  work_ += terms * static_cast<double>(series.degree() + 1);
  const Real halved_off = off + Precision<Real>::unit() * series.rounding_of_halving();
  const SpeedSeries<Real> right = series.halve(halving_);
  const Real half = width / 2;
  add(std::move(series), begin, half, halved_off, depth + 1);
  add(right, begin + half, half, halved_off, depth + 1);
}

NotCertain::NotCertain(LongReal length, const LongReal& uncertainty)
    : std::runtime_error("the true length is not certain to 30 digits, " +
                         (uncertainty < length ? "only to " + LongReal(uncertainty / length).str(2) + " of itself"
                                               : std::string("nor to one"))),
      length_(std::move(length)) {}

void require_certain(const LongReal& length, const LongReal& uncertainty) {
  if (uncertainty > length * LongReal("1e-30")) throw NotCertain(length, uncertainty);
}

template Hodograph<LongReal> hodograph(const CurveView<double>&, double, double);
template Hodograph<PairReal> hodograph(const CurveView<double>&, double, double);
template class LengthPanels<LongReal>;
template class LengthPanels<PairReal>;

}  // namespace bezierbench::reference
