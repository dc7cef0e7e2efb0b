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

}  // namespace bezierbench::reference
