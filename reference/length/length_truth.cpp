// SPDX-License-Identifier: MIT
#include "reference/length/length_truth.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

namespace bezierbench::reference {

namespace {

constexpr int largest_degree = 24;
constexpr double largest_size = 0x1p+300;
constexpr double largest_weight = 0x1p+100;
constexpr double min_size = 0x1p-300;
constexpr double max_uncertain = 0x1p-60;  ///< part of a length; one that is less certain decides nothing
constexpr double digits_error = 2e-30;  ///< part of the whole length by which 70 digits may be off, and as much again
constexpr double difference_error = 0x1p-100;  ///< part of two numbers by which their difference may be off

bool is_moderate(const CurveView<double>& curve) {
  if (curve.degree > largest_degree) return false;
  return std::ranges::all_of(curve.coefficients, [](double x) { return std::abs(x) <= largest_size; }) &&
         std::ranges::all_of(curve.weights, [](double w) { return std::abs(w) <= largest_weight; });
}

bool is_certain(const PairReal& length, const PairReal& off) {
  return length >= min_size && length <= largest_size && off <= length * max_uncertain;
}

/// Of |a - b|, where b is right to `off`; empty where it may be no more than what 70 digits cannot tell from 0.
std::optional<Enclosure> enclosed_difference(const PairReal& a, const PairReal& b, const PairReal& off) {
  const PairReal difference = abs(a - b);
  const PairReal uncertain = off + (abs(a) + abs(b)) * difference_error;
  const PairReal low = difference - uncertain;
  if (low <= uncertain) return std::nullopt;
  return Enclosure{low.convert_to<double>(), PairReal(difference + uncertain).convert_to<double>()};
}

/// The double nearest to both ends of x -+ off, if there is one.
std::optional<double> nearest(const PairReal& x, const PairReal& off) {
  const auto low = PairReal(x - off).convert_to<double>();
  const auto high = PairReal(x + off).convert_to<double>();
  return low == high ? std::optional(low) : std::nullopt;
}

}  // namespace

LengthTruth::LengthTruth(const CurveView<double>& curve, double from, double to, Tier tier)
    : curve_(curve), from_(from), to_(to) {
  if (tier == Tier::exact || from == to || !is_moderate(curve)) return;
  const auto h = hodograph<PairReal>(curve, from, to);
  if (h.polygon() == 0) return;
  const LengthPanels<PairReal> integral(h);
  const PairReal width = PairReal(to) - PairReal(from);
  value_ = width * integral.length();
  off_ = width * integral.uncertainty() + value_ * (digits_error + difference_error);
  certified_ = is_certain(value_, off_);
}

double LengthTruth::length() const {
  if (certified_)
    if (const auto decided = nearest(value_, off_)) return *decided;
  return exact().value().convert_to<double>();
}

std::optional<Enclosure> LengthTruth::enclosed_error(double length) const {
  if (!certified_ || !(std::abs(length) <= largest_size)) return std::nullopt;
  return enclosed_difference(length, value_, off_);
}

const TrueLength& LengthTruth::exact() const {
  if (!exact_) exact_.emplace(curve_, from_, to_);
  return *exact_;
}

AlongTruth::AlongTruth(const CurveView<double>& curve, Tier tier) : curve_(curve) {
  if (tier == Tier::exact || !is_moderate(curve)) return;
  pairs_.emplace(curve);
  off_ = 8 * pairs_->uncertainty() + pairs_->whole() * (digits_error + difference_error);
  if (!is_certain(pairs_->whole(), off_)) pairs_.reset();
}

double AlongTruth::whole() const {
  if (pairs_)
    if (const auto decided = nearest(pairs_->whole(), off_)) return *decided;
  return exact().whole().convert_to<double>();
}

double AlongTruth::length_at_share(double share) const {
  if (pairs_) {
    const PairReal length = share * pairs_->whole();
    if (const auto decided = nearest(length, std::abs(share) * off_ + abs(length) * difference_error)) return *decided;
  }
  return LongReal(share * exact().whole()).convert_to<double>();
}

std::optional<Enclosure> AlongTruth::enclosed_error(double t, double length) const {
  if (!pairs_ || !(t >= 0 && t <= 1) || !(std::abs(length) <= largest_size)) return std::nullopt;
  return enclosed_difference(length, pairs_->length_to(t), off_);
}

/// Newton's method says where the parameter is, two lengths prove it: s does not fall.
AlongTruth::Bracket AlongTruth::bracket(double length) const {
  Bracket found{length, {}, {}};
  if (length <= 0) {
    found.low = found.high = 0;
    return found;
  }
  const PairReal off = off_ + length * difference_error;
  if (length + off >= pairs_->whole()) return found;
  const PairReal t = pairs_->parameter_at(length);
  const PairReal speed = pairs_->speed_at(t);
  if (!(speed >= min_size)) return found;
  const PairReal step = 1.5 * off / speed + difference_error;
  const PairReal low = t - step;
  const PairReal high = t + step;
  if (low <= 0)
    found.low = 0;
  else if (pairs_->length_to(low) + off < length)
    found.low = low;
  if (high >= 1)
    found.high = 1;
  else if (pairs_->length_to(high) - off > length)
    found.high = high;
  return found;
}

std::optional<Enclosure> AlongTruth::enclosed_parameter_error(double t, double length) const {
  if (!pairs_ || !(std::abs(t) <= largest_size) || !(std::abs(length) <= largest_size)) return std::nullopt;
  if (!bracket_ || bracket_->length != length) bracket_ = bracket(length);
  if (!bracket_->low || !bracket_->high) return std::nullopt;
  const PairReal off = *bracket_->high - *bracket_->low;
  return enclosed_difference(t, *bracket_->low, off);
}

const LengthAlong<LongReal>& AlongTruth::exact() const {
  if (!exact_) exact_.emplace(curve_);
  return *exact_;
}

const LongReal& AlongTruth::exact_parameter(double length) const {
  if (!exact_parameter_ || exact_parameter_->first != length)
    exact_parameter_.emplace(length, exact().parameter_at(LongReal(length)));
  return exact_parameter_->second;
}

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
