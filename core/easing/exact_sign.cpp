// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "core/easing/enclosure.hpp"
#include "core/split_double.hpp"

namespace bezierbench {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Polynomial = std::vector<Integer>;  // ascending; the last one is not 0

/// The numbers over one power of two.
template <std::size_t count>
std::array<Integer, count> integers(const std::array<double, count>& values) {
  std::array<Integer, count> result;
  std::ranges::move(aligned<Integer>(values).integers, result.begin());
  return result;
}

void trim(Polynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

/// 3 p1 t (1-t)^2 + 3 p2 t^2 (1-t) + one t^3 - value.
Polynomial cubic(const Integer& p1, const Integer& p2, const Integer& one, const Integer& value) {
  Polynomial p{-value, 3 * p1, 3 * (p2 - 2 * p1), one + 3 * (p1 - p2)};
  trim(p);
  return p;
}

/// a modulo b, times a positive number.
Polynomial remainder(Polynomial a, const Polynomial& b) {
  const Integer leading = abs(b.back());
  const bool negative = b.back() < 0;
  while (a.size() >= b.size()) {
    const Integer factor = negative ? Integer(-a.back()) : a.back();
    const auto shift = a.size() - b.size();
    for (auto& c : a) c *= leading;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= factor * b[i];
    trim(a);
  }
  return a;
}

Polynomial derivative_times(const Polynomial& p, const Polynomial& q) {
  Polynomial result(p.size() + q.size());
  for (std::size_t i = 1; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) result[i - 1 + j] += i * p[i] * q[j];
  trim(result);
  return result;
}

/// Counts the changes of sign of a sequence, zeros left out.
class Variations {
 public:
  void add(const Integer& value) {
    if (value == 0) return;
    count_ += last_ * value.sign() < 0 ? 1 : 0;
    last_ = value.sign();
  }
  [[nodiscard]] int count() const { return count_; }

 private:
  int last_ = 0;
  int count_ = 0;
};

}  // namespace

int exact_easing_sign(const EasingCurve<double>& curve, double x, double a, double b) {
  const auto [x1, x2, x_one, value] = integers<4>({curve.x1, curve.x2, 1, x});
  const auto [y1, y2, y_one, low, high] = integers<5>({curve.y1, curve.y2, 1, a, b});
  Polynomial before = cubic(x1, x2, x_one, value);
  const Polynomial twice_y = cubic(2 * y1, 2 * y2, 2 * y_one, low + high);
  Polynomial here = remainder(derivative_times(before, twice_y), before);
  Variations at_0;
  Variations at_1;
  const auto add = [&](const Polynomial& p) {
    at_0.add(p.front());
    Integer sum = 0;
    for (const auto& c : p) sum += c;
    at_1.add(sum);
  };
  add(before);
  while (!here.empty()) {
    add(here);
    Polynomial next = remainder(before, here);
    for (auto& c : next) c = -c;
    before = std::exchange(here, std::move(next));
  }
  return at_0.count() - at_1.count();
}

}  // namespace bezierbench
