// SPDX-License-Identifier: MIT
#include "reference/length/true_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "reference/stop.hpp"

namespace bezierbench::reference {

TrueLength::TrueLength(const CurveView<double>& curve, double from, double to) {
  if (from == to) return;
  const auto h = hodograph<LongReal>(curve, from, to);
  if (h.polygon() == 0) return;
  const LengthPanels<LongReal> integral(h);
  const LongReal width = LongReal(to) - LongReal(from);
  value_ = width * integral.length();
  uncertainty_ = width * integral.uncertainty();
  require_certain(value_, uncertainty_);
}

std::string TrueLength::decimal(int digits) const { return value_.str(digits, std::ios_base::fmtflags{}); }

double TrueLength::error_of(double length) const {
  if (!std::isfinite(length)) return std::numeric_limits<double>::infinity();
  const LongReal error = abs(LongReal(length) - value_);
  return error <= uncertainty_ ? 0 : error.convert_to<double>();
}

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
/// by at most 4 units of the convex combination of magnitudes, which `max_magnitude` bounds. The quotient from / to, at
/// which the curve is cut the second time, is rounded as well: this moves the beginning of the part.
template <class Real>
Real rounding_of_part(const Hodograph<Real>& h, const Real& max_magnitude, double from, double to) {
  const Real unit = Precision<Real>::unit();
  const auto d = static_cast<double>(h.dimension);
  Real off = 8 * d * static_cast<double>(h.degree() + 1) * unit * max_magnitude;
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

/// U and W over [0, 1], or, if `magnitudes`, the sums of the sizes of the terms of each.
template <class Real>
Hodograph<Real> quotient(const CurveView<double>& curve, bool magnitudes) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  const int n = curve.degree;
  const auto binomials = [](int m) {
    std::vector<Real> row{1};
    for (int i = 0; i < m; ++i) row.push_back(row.back() * (m - i) / (i + 1));
    return row;
  };
  const auto row = binomials(n);
  const auto row_of_result = binomials(2 * n - 2);
  const auto at = [](const std::vector<Real>& values, int i) -> const Real& {
    return values[static_cast<std::size_t>(i)];
  };
  Hodograph<Real> h{d, {}, 0, {{1, {}}}};
  auto& weights = h.weight.front().vectors;
  for (const double w : curve.weights) weights.push_back(magnitudes ? std::abs(w) : w);
  for (int k = 0; k <= std::max(2 * n - 2, 0); ++k) {
    std::vector<Real> sum(d, 0);
    for (int i = std::max(0, k + 1 - n); 2 * i < k + 1 && n > 0; ++i) {
      StopWhen::poll();
      const int j = k + 1 - i;
      const Real factor = at(row, i) * at(row, j) / at(row_of_result, k) * (j - i) * (at(weights, i) * at(weights, j));
      for (std::size_t axis = 0; axis < d; ++axis) {
        const Real step = Real(curve(static_cast<int>(axis), j)) - Real(curve(static_cast<int>(axis), i));
        sum[axis] += factor * (magnitudes ? Real(abs(step)) : step);
      }
    }
    h.vectors.insert(h.vectors.end(), sum.begin(), sum.end());
  }
  return h;
}

template <class Real>
void cut(Hodograph<Real>& h, double from, double to) {
  if (to < 1) h.split(to);
  if (from > 0) h = h.split(Real(from) / Real(to));
}

/// Of a rational curve. In units, a term of U_k is off by less than 2n + 4 of itself, and each step of de Casteljau's
/// algorithm by 4 of what `sizes` has. The quotient from / to moves the parameter of the part by no more than
/// 2 units to / (to - from), and a polynomial of degree m changes by 2 m of its largest control vector with it.
template <class Real>
Hodograph<Real> rational_hodograph(const CurveView<double>& curve, double from, double to) {
  auto h = quotient<Real>(curve, false);
  auto sizes = quotient<Real>(curve, true);
  cut(h, from, to);
  cut(sizes, from, to);
  const Real moved = from > 0 && from < to ? Real(4 * (Real(to) / (Real(to) - Real(from)))) : Real(0);
  const auto set_off = [&](Hodograph<Real>& part, const Hodograph<Real>& size) {
    const auto m = static_cast<double>(part.degree() + 1);
    const auto terms = static_cast<double>(2 * curve.degree + 4);
    part.off = Precision<Real>::unit() * static_cast<double>(part.dimension) * (terms + 8 * m + moved * m) *
               largest(size.vectors);
  };
  set_off(h.weight.front(), sizes.weight.front());
  set_off(h, sizes);
  return h;
}

/// With two digits. A number's own str() would link all of iostream, which no other part of the reference uses.
std::string text_of(double share) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2g", share);
  return text.data();
}

}  // namespace

template <class Real>
Hodograph<Real> hodograph(const CurveView<double>& curve, double from, double to) {
  if (curve.form == Form::rational) return rational_hodograph<Real>(curve, from, to);
  const auto d = static_cast<std::size_t>(curve.dimension);
  Hodograph<Real> h{d, {}};
  for (std::size_t k = d; k < curve.coefficients.size(); ++k)
    h.vectors.push_back(curve.degree * (Real(curve.coefficients[k]) - Real(curve.coefficients[k - d])));
  if (h.vectors.empty()) h.vectors.assign(d, 0);
  auto sizes = h;
  for (Real& x : sizes.vectors) x = abs(x);
  cut(h, from, to);
  cut(sizes, from, to);
  h.off = rounding_of_part(h, largest(sizes.vectors), from, to);
  return h;
}

template <class Real>
LengthPanels<Real>::LengthPanels(const Hodograph<Real>& hodograph)
    : halving_(std::max(hodograph.degree(), hodograph.weight.empty() ? 0 : hodograph.weight.front().degree())) {
  const SpeedSeries<Real> series(hodograph);
  negligible_ = series.mean_speed_to(1) * Precision<Real>::negligible;
  const Real of_series = Precision<Real>::unit() * rounding_of_series(hodograph);
  Off off;  // of polynomial curves it is counted once, in the end
  for (const auto& w : hodograph.weight)
    off = {hodograph.off + of_series, w.off + Precision<Real>::unit() * rounding_of_series(w)};
  add(series, 0, 1, off, 0);
  const Real sum_of_panels = static_cast<double>(panels_.size()) / 8;
  if (!hodograph.weight.empty()) {
    uncertainty_ += Precision<Real>::unit() * length_ * sum_of_panels;
    return;
  }
  uncertainty_ += hodograph.off + of_series + Precision<Real>::unit() * series.largest() * sum_of_panels;
  // The length of a straight line that does not turn is its chord, without the roundings of a rule.
  const Real chord = hodograph.chord();
  const Real longer = hodograph.polygon() - chord;
  if (longer > chord * Precision<Real>::straight) return;
  length_ = chord;
  uncertainty_ = hodograph.off + 2 * chord * Precision<Real>::straight;
}

template <class Real>
void LengthPanels<Real>::add(SpeedSeries<Real> series, const Real& begin, const Real& width, const Off& off_before,
                             int depth) {
  StopWhen::poll();
  const Real unit = Precision<Real>::unit();
  const auto plus = [](const Off& a, const Off& b, const Real& factor) {
    return Off{a.vectors + factor * b.vectors, a.weight + factor * b.weight};
  };
  const Real allowed = negligible_ / width;
  const Off off = plus(off_before, series.shorten(allowed / 8), 1);
  const Real chord = series.chord_to(1);
  const Real slack = series.largest() - chord;
  const Real missed = series.proved_miss(allowed);
  const bool proved = missed >= 0;
  const auto terms = static_cast<double>((series.degree() + 1) * series.dimension());
  if (proved || slack <= allowed || depth == depth_limit || work_ > Precision<Real>::work_limit) {
    const Real speed = proved ? series.mean_speed_to(1) : Real(chord + slack / 2);
    work_ += Precision<Real>::points_of_rule * terms;
    length_ += width * speed;
    const Real changed = series.change_of_speed(plus(off, series.rounding_of_values(), unit));
    const Real rounding = series.largest() * (Precision<Real>::points_of_rule / 8.0 + 4);
    uncertainty_ += width * ((proved ? missed : Real(slack / 2)) + changed + unit * rounding);
    panels_.push_back({begin, width, std::move(series), width * speed});
    return;
  }
  work_ += terms * static_cast<double>(series.degree() + 1);
  const Off halved_off = plus(off, series.rounding_of_halving(), unit);
  const SpeedSeries<Real> right = series.halve(halving_);
  const Real half = width / 2;
  add(std::move(series), begin, half, halved_off, depth + 1);
  add(right, begin + half, half, halved_off, depth + 1);
}

NotCertain::NotCertain(LongReal length, const LongReal& uncertainty)
    : std::runtime_error("the true length is not certain to 30 digits, " +
                         (uncertainty < length
                              ? "only to " + text_of(static_cast<double>(uncertainty / length)) + " of itself"
                              : std::string("nor to one"))),
      length_(std::move(length)),
      has_digits_(uncertainty < length_) {}

void require_certain(const LongReal& length, const LongReal& uncertainty) {
  if (uncertainty > length * LongReal("1e-30")) throw NotCertain(length, uncertainty);
}

template Hodograph<LongReal> hodograph(const CurveView<double>&, double, double);
template Hodograph<PairReal> hodograph(const CurveView<double>&, double, double);
template class LengthPanels<LongReal>;
template class LengthPanels<PairReal>;

}  // namespace bezierbench::reference
