// SPDX-License-Identifier: MIT
// All floats of an interval in [0, 1] in ascending order, and the counts over the values of one method at consecutive
// floats t.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/float_values.hpp"

namespace bezierbench::studies {

/// Floats that are not negative are in the order of their bits.
inline float float_of(std::uint32_t bits) { return std::bit_cast<float>(bits); }

/// The floats from `first` to `last`, by their bits.
struct FloatRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;

  [[nodiscard]] std::uint64_t count() const { return std::uint64_t{last} - first + 1; }
};

/// The floats of the interval, 0 <= min <= max <= 1; empty where there is none.
inline std::optional<FloatRange> floats_in(const suite::Interval& interval) {
  const auto bits = [](double x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x + 0.0)); };
  std::uint32_t first = bits(interval.min);
  std::uint32_t last = bits(interval.max);
  if (double{float_of(first)} < interval.min) ++first;
  if (double{float_of(last)} > interval.max) {
    if (last == 0) return std::nullopt;
    --last;
  }
  if (first > last) return std::nullopt;
  return FloatRange{first, last};
}

/// The counts are of points, or of steps from a t to the next, for any number of coordinates.
struct FloatTally {
  std::uint64_t misrounded = 0;
  std::uint64_t non_monotone = 0;
  std::uint64_t out_of_hull = 0;
  double max_error = -1;        ///< in ulp, right to 2^-19 and a relative 2^-22; infinite where a value is not finite
  std::uint32_t worst_t = ~0U;  ///< bits of the first t that has it

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.misrounded, self.non_monotone, self.out_of_hull, self.max_error, self.worst_t);
  }
  /// The order of merging changes nothing.
  void merge(const FloatTally& other);
};

/// The limits of a coordinate.
struct AxisLimits {
  float low = 0;  ///< the interval of the control coordinates
  float high = 0;
  bool rises = false;  ///< they never decrease
  bool falls = false;  ///< they never increase

  explicit AxisLimits(std::span<const float> control_coordinates);
};

/// Judges points at up to float_values_at_once consecutive t, axis by axis.
class FloatJudge {
 public:
  /// Begins with other points.
  void begin(std::size_t count);
  /// One coordinate of each; `before` is that at the t before the first, null where there is none.
  void add_axis(const AxisLimits& limits, const reference::FloatValues& truth, const float* values,
                const float* before);
  /// Adds them to the tally; `first_t` has the bits of the first t.
  void end(std::uint32_t first_t, FloatTally& tally) const;

 private:
  template <class T>
  using Row = std::array<T, reference::float_values_at_once>;

  std::size_t count_ = 0;
  alignas(64) Row<std::int32_t> errors_{};              ///< the largest of all axes in ulp, the bits of a float
  alignas(64) Row<std::int32_t> findings_{};            ///< sums of bits
  std::vector<std::pair<std::size_t, double>> beyond_;  ///< places and errors that no float holds, in ulp
};

// A Bezier curve of floats, as exhaustive studies evaluate it.

struct FloatCurve {
  /// The coefficients are rounded to float.
  FloatCurve(std::string_view of_set, std::string_view name, const CurveView<double>& curve)
      : set(of_set),
        id(name),
        dimension(curve.dimension),
        control_points(curve.coefficients.begin(), curve.coefficients.end()) {}

  std::string set;  ///< id of its curve set
  std::string id;
  int dimension;
  std::vector<float> control_points;  ///< point by point

  [[nodiscard]] int degree() const { return static_cast<int>(control_points.size()) / dimension - 1; }
  [[nodiscard]] CurveView<float> view() const { return {Form::bernstein, dimension, degree(), control_points}; }
  /// The coordinates of one axis.
  [[nodiscard]] std::vector<float> axis(int axis) const {
    std::vector<float> coordinates;
    for (int i = 0; i <= degree(); ++i) coordinates.push_back(view()(axis, i));
    return coordinates;
  }
};

}  // namespace bezierbench::studies
