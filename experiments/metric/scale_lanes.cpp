// SPDX-License-Identifier: MIT
#include "experiments/metric/scale_lanes.hpp"

#include "core/batch/lanes.hpp"
#include "core/bound/amplification.hpp"
#include "reference/error/norm.hpp"

namespace bezierbench::metric {
namespace {

/// As many trials as the steps of a formula keep in registers: two vectors of this build's processor.
using Pack = batch::HWY_NAMESPACE::Lanes<double, 2>;
static_assert(reference::certified_lanes % Pack::size == 0);

}  // namespace

void ScaleLanes::begin(int dimension, int degree) {
  dimension_ = dimension;
  degree_ = degree;
  norms_.resize(static_cast<std::size_t>(degree) + 1);
  coefficients_.resize(norms_.size() * static_cast<std::size_t>(dimension));
}

void ScaleLanes::load(std::size_t lane, const CurveView<double>& curve, double t) {
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i][lane] = curve.coefficients[i];
  t_[lane] = t;
}

void ScaleLanes::compute(const std::set<Amplification>& kinds) {
  kinds_ = kinds;
  for (std::size_t first = 0; first < reference::certified_lanes; first += Pack::size) {
    const auto pack = [first](const Lanes& lanes) { return Pack::load(&lanes[first]); };
    Pack largest(0);
    for (std::size_t i = 0; i < norms_.size(); ++i) {
      const Lanes* const point = &coefficients_[i * static_cast<std::size_t>(dimension_)];
      const Pack length = reference::norm<Pack>(dimension_, [&](int axis) { return pack(point[axis]); });
      length.store(&norms_[i][first]);
      largest = reference::larger(largest, length);
    }
    largest.store(&largest_[first]);
    const Pack t = pack(t_);
    const auto norm_of = [&](int i) { return pack(norms_[static_cast<std::size_t>(i)]); };
    const auto point = [&](int i) { return &coefficients_[static_cast<std::size_t>(i * dimension_)]; };
    const auto near_start = t + t <= Pack(1);
    for (const Amplification kind : kinds_) {
      const auto norm_from_anchor = [&](int i) {
        return reference::norm<Pack>(dimension_, [&](int axis) {
          const Pack start = pack(point(0)[axis]);
          const Pack anchor =
              anchor_of(kind) == Anchor::start ? start : select(near_start, start, pack(point(degree_)[axis]));
          return pack(point(i)[axis]) - anchor;
        });
      };
      const Pack amplified = anchor_of(kind) == Anchor::none ? amplification(kind, degree_, norm_of, t)
                                                             : amplification(kind, degree_, norm_from_anchor, t);
      amplified.store(&amplified_[static_cast<std::size_t>(kind)][first]);
    }
  }
}

}  // namespace bezierbench::metric
