// SPDX-License-Identifier: MIT
#include "reference/true_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bezierbench::reference {

const ExactPoint& TruePoint::exact() {
  if (point_ == nullptr) point_ = &exact_->point(curve_, t_);
  return *point_;
}

bool TruePoint::exists() { return certified_ || curve_.form != Form::rational || exact().exists(); }

const Distance& TruePoint::exact_distance() {
  if (!distance_) distance_.emplace(exact());
  return *distance_;
}

double TruePoint::distance(std::span<const double> point) {
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(point, finite)) return std::numeric_limits<double>::infinity();
  if (certified_ && !distance_) {
    if (const auto proved = certified_->distance(point)) return *proved;
    escalated_ = true;
  }
  return exact_distance().to(point);
}

double TruePoint::length() {
  constexpr std::array<double, max_dimension> origin{};
  return distance(std::span(origin).first(static_cast<std::size_t>(curve_.dimension)));
}

double TruePoint::ulp(double length, const Format& format) {
  if (const auto decided = ulp_at_length(length, format)) return *decided;
  escalated_ = escalated_ || certified_.has_value();
  return ulp_of_length(exact(), length, format);
}

namespace {

/// The number nearest to high + low, which is the coordinate up to `error`; empty where the error leaves two of them.
template <class Scalar>
std::optional<double> certain_nearest(double high, double low, double error) {
  const auto number = static_cast<Scalar>(high);
  if (!std::isfinite(number)) return std::nullopt;
  const double rest = (high - static_cast<double>(number)) + low;  // the difference is exact
  const double unsure = error + std::numeric_limits<double>::epsilon() * std::abs(rest);
  if (rest == 0 && unsure == 0) return number;
  // Below a power of two the numbers are closer to each other, so the gap towards 0 serves for both sides.
  const double gap = std::abs(static_cast<double>(number) - static_cast<double>(std::nextafter(number, Scalar{0})));
  return std::abs(rest) + unsure < gap / 2 ? std::optional<double>(number) : std::nullopt;
}

}  // namespace

double TruePoint::nearest(int axis, const Format& format) {
  if (certified_) {
    const auto a = static_cast<std::size_t>(axis);
    const double high = certified_->high[a];
    const double low = certified_->low[a];
    const auto number = format.precision == binary32.precision ? certain_nearest<float>(high, low, certified_->error)
                                                               : certain_nearest<double>(high, low, certified_->error);
    if (number) return *number;
  }
  return round_to(format, exact().coordinate(axis));
}

}  // namespace bezierbench::reference
