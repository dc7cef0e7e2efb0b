// SPDX-License-Identifier: MIT
#include "core/bounds/exact_box.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/split_double.hpp"

namespace bezierbench {
namespace {

/// Up to this many bits without an allocation.
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>, boost::multiprecision::et_off>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest double that is not above numerator / denominator 2^exponent, for denominator > 0.
double rounded_down(const Integer& numerator, const Integer& denominator, long exponent) {
  if (numerator == 0) return 0;
  const bool negative = numerator < 0;
  Integer quotient = negative ? Integer(-numerator) : numerator;
  bool cut = false;  // whether something was cut off from the magnitude
  constexpr int precision = 53;
  if (denominator != 1) {
    const long shift =
        std::max(0L, 2 + precision + static_cast<long>(msb(denominator)) - static_cast<long>(msb(quotient)));
    Integer remainder;
    divide_qr(Integer(quotient << shift), denominator, quotient, remainder);
    cut = remainder != 0;
    exponent -= shift;
  }
  const long drop = std::max(static_cast<long>(msb(quotient)) + 1 - precision, -1074 - exponent);
  std::uint64_t magnitude = 0;
  if (drop <= 0) {
    magnitude = static_cast<std::uint64_t>(quotient);
  } else {
    const Integer kept = quotient >> drop;
    cut = cut || static_cast<long>(lsb(quotient)) < drop;
    magnitude = static_cast<std::uint64_t>(kept);
    exponent += drop;
  }
  if (negative && cut) ++magnitude;
  const double value = std::ldexp(static_cast<double>(magnitude), static_cast<int>(exponent));
  return negative ? -value : value;
}

/// A piece of the curve: its homogeneous control points, over a power of two that all pieces of a level share.
struct Piece {
  std::vector<Integer> points;
  std::vector<Integer> weights;  ///< none of a polynomial curve
};

/// The halves of both, times 2^n.
std::pair<std::vector<Integer>, std::vector<Integer>> halves(std::vector<Integer> b) {
  const std::size_t n = b.empty() ? 0 : b.size() - 1;
  std::vector<Integer> left(b.size());
  for (std::size_t k = 0; k < b.size(); ++k) {
    left[k] = b[0] << (n - k);
    for (std::size_t i = 0; i + k < n; ++i) b[i] += b[i + 1];
    b[n - k] <<= n - k;
  }
  return {std::move(left), std::move(b)};
}

class LowSide {
 public:
  LowSide(std::span<const double> b, std::span<const double> weights) {
    auto points = aligned<Integer>(b);
    Piece whole{std::move(points.integers), aligned<Integer>(weights).integers};
    const bool negative = std::ranges::any_of(weights, [](double w) { return w < 0; });
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (negative) whole.weights[i] = -whole.weights[i];
      whole.points[i] *= whole.weights[i];
    }
    exponent_ = points.exponent;  // that of the weights cancels
    growth_ = weights.empty() ? static_cast<long>(b.size()) - 1 : 0;
    known_ = std::min(b.front(), b.back());
    pieces_.push_back(std::move(whole));
  }

  double find() {
    for (;;) {
      halve();
      const double low = drop_what_is_above();
      if (known_ <= std::nextafter(low, infinity)) return low;
    }
  }

 private:
  [[nodiscard]] double at(const Piece& piece, std::size_t i) const {
    if (piece.weights.empty()) return rounded_down(piece.points[i], 1, exponent_);
    return piece.weights[i] == 0 ? infinity : rounded_down(piece.points[i], piece.weights[i], exponent_);
  }
  void halve() {
    std::vector<Piece> all;
    exponent_ -= growth_;
    for (auto& piece : pieces_) {
      auto [left, right] = halves(std::move(piece.points));
      auto [left_weights, right_weights] = halves(std::move(piece.weights));
      all.push_back({std::move(left), std::move(left_weights)});
      all.push_back({std::move(right), std::move(right_weights)});
      known_ = std::min(known_, at(all.back(), 0));
    }
    pieces_ = std::move(all);
  }
  /// Leaves the pieces that may reach below `known_`. Returns their lowest control point.
  double drop_what_is_above() {
    double lowest = known_;
    std::erase_if(pieces_, [&](const Piece& piece) {
      double low = known_;
      for (std::size_t i = 1; i + 1 < piece.points.size(); ++i) low = std::min(low, at(piece, i));
      lowest = std::min(lowest, low);
      return low >= known_;
    });
    return lowest;
  }

  std::vector<Piece> pieces_;
  long exponent_ = 0;
  long growth_ = 0;   ///< of the power of two by a halving; of a rational curve it cancels
  double known_ = 0;  ///< the lowest point so far, rounded down
};

}  // namespace

double exact_low_side(std::span<const double> b, std::span<const double> weights) { return LowSide(b, weights).find(); }

}  // namespace bezierbench
