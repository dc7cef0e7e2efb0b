// SPDX-License-Identifier: MIT
// Foot points as a timing study asks them, of points that are drawn like control points. Right where none is missed.
#pragma once

#include <array>

#include "experiments/judge/methods.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/sample/placement.hpp"
#include "experiments/studies/projection/projection.hpp"
#include "reference/projection.hpp"

namespace bezierbench::studies {

class TimedProjection {
 public:
  static constexpr Problem problem = Problem::projection;
  static constexpr bool each_data = false;
  using Kernel = ProjectionKernel;
  using Result = std::array<double, 2>;  ///< t, distance

  static std::span<const Kernel> kernels(int dimension) { return judge::projection_methods(dimension); }

  TimedProjection(const race::RaceCell& race_cell, const suite::Study& study, std::uint64_t seed) {
    const sample::Sampler sampler(seed, study.id, sample::with_point(race_cell.cell));
    for (std::size_t k = 0; k < 64; ++k) {
      problems_.push_back(sample::place(sample::placements().front(), sampler, race_cell.cell, k));
      truths_.push_back(reference::projection(curve(k), problems_[k].point));
    }
  }

  [[nodiscard]] std::size_t count() const { return problems_.size(); }
  void solve(const Kernel& method, std::size_t k, Result& result) const {
    const auto foot = method.project(curve(k), problems_[k].point);
    result = {foot.t, foot.distance};
  }
  [[nodiscard]] bool is_right(const Kernel& /*method*/, std::size_t k, const Result& result) const {
    return reference::foot_error(reference::error_format, result[0], result[1], truths_[k]) <=
           missed_tolerance * sample::largest_coordinate(problems_[k]);
  }

 private:
  [[nodiscard]] CurveView<double> curve(std::size_t k) const {
    return {Form::bernstein, problems_[k].dimension, problems_[k].degree, problems_[k].points};
  }

  std::vector<sample::PlacedPoint> problems_;
  std::vector<reference::ExactProjection> truths_;
};

}  // namespace bezierbench::studies
