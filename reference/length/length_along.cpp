// SPDX-License-Identifier: MIT
#include "reference/length/length_along.hpp"

#include <algorithm>
#include <concepts>
#include <limits>

namespace bezierbench::reference {
namespace {

/// The length of the panel's part on its local parameters [0, x].
template <class Real>
Real length_within(const LengthPanel<Real>& panel, const Real& x) {
  return x == 0 ? Real(0) : Real(panel.width * x * panel.series.mean_speed_to(2 * x - 1));
}

/// The x in [0, 1] with that length. The interval [low, high] holds the root; it is halved where a step of Newton's
/// method leaves it or did not halve the distance, so the loop ends.
template <class Real>
Real local_parameter(const LengthPanel<Real>& panel, const Real& length, const Real& negligible) {
  Real low = 0;
  Real high = 1;
  Real x = length / panel.length;
  Real before = panel.length;
  const Real last_digit = Precision<Real>::straight;
  while (high - low > last_digit) {
    const Real distance = length_within(panel, x) - length;
    if (abs(distance) <= negligible) break;
    (distance < 0 ? low : high) = x;
    const Real speed = panel.width * panel.series.speed(2 * x - 1);
    const bool halved = 2 * abs(distance) <= before;
    before = abs(distance);
    if (halved && speed > 0) x -= distance / speed;
    if (!halved || x <= low || x >= high) x = (low + high) / 2;
  }
  return x;
}

}  // namespace

template <class Real>
LengthAlong<Real>::LengthAlong(const CurveView<double>& curve) : hodograph_(hodograph<Real>(curve, 0, 1)) {
  if (hodograph_.polygon() == 0) return;
  const LengthPanels<Real> integral(hodograph_);
  if constexpr (std::same_as<Real, LongReal>) require_certain(integral.length(), integral.uncertainty());
  uncertainty_ = integral.uncertainty();
  panels_ = integral.panels();
  for (const auto& panel : panels_) cumulative_.push_back(cumulative_.back() + panel.length);
  cumulative_.back() = integral.length();
}

template <class Real>
Real LengthAlong<Real>::length_to(const Real& t) const {
  if (panels_.empty() || t == 0) return 0;
  if (t < 0) return -excess(t).length;
  if (t >= 1) return whole() + excess(t).length;
  const std::size_t k = panel_at(t);
  return cumulative_[k] + length_within<Real>(panels_[k], (t - panels_[k].begin) / panels_[k].width);
}

template <class Real>
typename LengthAlong<Real>::Excess LengthAlong<Real>::excess(const Real& t) const {
  if (panels_.empty() || (t >= 0 && t <= 1)) return {};
  const Real width = t < 0 ? Real(-t) : Real(t - 1);
  auto before = hodograph_;
  const auto behind = before.split(t);  // one of the two is the part between t and the end, the other one the rest
  auto part = t < 0 ? before : behind;
  if (part.polygon() == 0) return {};
  // A step of de Casteljau's algorithm at t multiplies magnitudes by at most |t| + |1 - t| = 1 + 2 width.
  const auto set_off = [&](Hodograph<Real>& cut, const Hodograph<Real>& whole) {
    Real largest = 0;
    for (const Real& x : whole.vectors) largest = std::max(largest, Real(abs(x)));
    for (std::size_t step = 0; step < whole.degree(); ++step) largest *= 1 + 2 * width;
    cut.off = 8 * static_cast<double>(cut.dimension * (cut.degree() + 1)) * Precision<Real>::unit() * largest;
  };
  set_off(part, hodograph_);
  for (std::size_t k = 0; k < part.weight.size(); ++k) set_off(part.weight[k], hodograph_.weight[k]);
  const LengthPanels<Real> integral(part);
  // Next to a pole the length is infinite, and nothing about it is uncertain.
  if (!part.weight.empty() && integral.length() > std::numeric_limits<double>::max()) return {integral.length(), 0};
  return {width * integral.length(), width * integral.uncertainty()};
}

template <class Real>
std::size_t LengthAlong<Real>::panel_at(const Real& t) const {
  const auto behind =
      std::upper_bound(panels_.begin(), panels_.end(), t,
                       [](const Real& value, const LengthPanel<Real>& panel) { return value < panel.begin; });
  return static_cast<std::size_t>(behind - panels_.begin()) - 1;
}

template <class Real>
Real LengthAlong<Real>::speed_at(const Real& t) const {
  const auto& panel = panels_[panel_at(t)];
  return panel.series.speed(2 * ((t - panel.begin) / panel.width) - 1);
}

template <class Real>
Real LengthAlong<Real>::distance(const Real& t, const Real& length) const {
  Real error = abs(length_to(t) - length);
  return error <= uncertainty_ + excess(t).uncertainty ? Real(0) : error;
}

template <class Real>
Real LengthAlong<Real>::parameter_at(const Real& length) const {
  if (length <= 0 || panels_.empty()) return 0;
  if (length >= whole()) return 1;
  const auto behind = std::upper_bound(cumulative_.begin(), cumulative_.end(), length);
  const auto k = static_cast<std::size_t>(behind - cumulative_.begin()) - 1;
  const Real negligible = whole() * Precision<Real>::parameter_error;
  return panels_[k].begin + panels_[k].width * local_parameter<Real>(panels_[k], length - cumulative_[k], negligible);
}

template <class Real>
std::optional<Real> LengthAlong<Real>::known_parameter_at(const Real& length) const {
  const Real t = parameter_at(length);
  if (t == 0 || t == 1) return t;
  const Real slack = uncertainty_ + 2 * whole() * Precision<Real>::parameter_error;
  const auto low = parameter_at(length - slack).template convert_to<double>();
  const auto high = parameter_at(length + slack).template convert_to<double>();
  return low == high ? std::optional(t) : std::nullopt;
}

template class LengthAlong<LongReal>;
template class LengthAlong<PairReal>;

}  // namespace bezierbench::reference
