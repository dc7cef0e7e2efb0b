// SPDX-License-Identifier: MIT
#include "reference/length/length_along.hpp"

#include <algorithm>

namespace bezierbench::reference {
namespace {

/// The length of the panel's part on its local parameters [0, x].
LongReal length_within(const LengthPanel& panel, const LongReal& x) {
  return x == 0 ? LongReal(0) : LongReal(panel.width * x * panel.series.mean_speed_to(2 * x - 1));
}

/// The x in [0, 1] with that length. The interval [low, high] holds the root; it is halved where a step of Newton's
/// method leaves it or did not halve the distance, so the loop ends.
LongReal local_parameter(const LengthPanel& panel, const LongReal& length, const LongReal& negligible) {
  LongReal low = 0;
  LongReal high = 1;
  LongReal x = length / panel.length;
  LongReal before = panel.length;
  const LongReal last_digit("1e-60");
  while (high - low > last_digit) {
    const LongReal distance = length_within(panel, x) - length;
    if (abs(distance) <= negligible) break;
    (distance < 0 ? low : high) = x;
    const LongReal speed = panel.width * panel.series.speed(2 * x - 1);
    const bool halved = 2 * abs(distance) <= before;
    before = abs(distance);
    if (halved && speed > 0) x -= distance / speed;
    if (!halved || x <= low || x >= high) x = (low + high) / 2;
  }
  return x;
}

}  // namespace

LengthAlong::LengthAlong(const CurveView<double>& curve) {
  const auto h = long_hodograph(curve, 0, 1);
  if (h.polygon() == 0) return;
  const LengthPanels integral(h);
  require_certain(integral.length(), integral.uncertainty());
  uncertainty_ = integral.uncertainty();
  panels_ = integral.panels();
  for (const auto& panel : panels_) cumulative_.push_back(cumulative_.back() + panel.length);
  cumulative_.back() = integral.length();
}

LongReal LengthAlong::length_to(const LongReal& t) const {
  if (t <= 0 || panels_.empty()) return 0;
  if (t >= 1) return whole();
  const auto behind =
      std::upper_bound(panels_.begin(), panels_.end(), t,
                       [](const LongReal& value, const LengthPanel& panel) { return value < panel.begin; });
  const auto& panel = *(behind - 1);
  return cumulative_[static_cast<std::size_t>(behind - panels_.begin()) - 1] +
         length_within(panel, (t - panel.begin) / panel.width);
}

LongReal LengthAlong::distance(const LongReal& t, const LongReal& length) const {
  LongReal error = abs(length_to(t) - length);
  return error <= uncertainty_ ? LongReal(0) : error;
}

LongReal LengthAlong::parameter_at(const LongReal& length) const {
  if (length <= 0 || panels_.empty()) return 0;
  if (length >= whole()) return 1;
  const auto behind = std::upper_bound(cumulative_.begin(), cumulative_.end(), length);
  const auto k = static_cast<std::size_t>(behind - cumulative_.begin()) - 1;
  const LongReal negligible = whole() * LongReal("1e-40");
  return panels_[k].begin + panels_[k].width * local_parameter(panels_[k], length - cumulative_[k], negligible);
}

}  // namespace bezierbench::reference
