// SPDX-License-Identifier: MIT
// A scalar that counts the operations on it by kind, and knows when each result is known.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "core/operations/operations.hpp"

namespace bezierbench::counting {

/// The operations so far, and what each takes: set both before a method runs.
struct Tape {
  ByOperation count{};
  ByOperation latency{};
};
inline thread_local Tape tape;

/// When a number that does not depend on t is known.
inline constexpr double always = -std::numeric_limits<double>::infinity();

/// A number that counts the operations on it. Its value decides the branches of a method.
class Counting {
 public:
  Counting() = default;  ///< an input
  explicit Counting(double value) : value_(value), is_constant_in_t_(true) {}
  /// An input that is known at this time.
  static Counting input(double value, double ready = always) {
    Counting result(value);
    result.is_constant_in_t_ = false;
    result.ready_ = ready;
    return result;
  }
  explicit operator double() const { return value_; }
  [[nodiscard]] double ready() const { return ready_; }

  friend Counting operator+(const Counting& a, const Counting& b) {
    return after(Operation::add, a.value_ + b.value_, {a, b});
  }
  friend Counting operator-(const Counting& a, const Counting& b) {
    return after(Operation::add, a.value_ - b.value_, {a, b});
  }
  friend Counting operator*(const Counting& a, const Counting& b) {
    return after(Operation::multiply, a.value_ * b.value_, {a, b});
  }
  friend Counting operator/(const Counting& a, const Counting& b) {
    return after(Operation::divide, a.value_ / b.value_, {a, b});
  }
  [[nodiscard]] Counting fused(const Counting& b, const Counting& c) const {
    return after(Operation::fused, std::fma(value_, b.value_, c.value_), {*this, b, c});
  }
  friend Counting sqrt(const Counting& a) { return after(Operation::square_root, std::sqrt(a.value_), {a}); }
  friend Counting operator-(Counting a) {
    a.value_ = -a.value_;
    return a;
  }
  friend Counting abs(Counting a) {
    a.value_ = std::abs(a.value_);
    return a;
  }
  Counting& operator+=(const Counting& b) { return *this = *this + b; }
  Counting& operator-=(const Counting& b) { return *this = *this - b; }
  Counting& operator*=(const Counting& b) { return *this = *this * b; }
  Counting& operator/=(const Counting& b) { return *this = *this / b; }

  /// A comparison, which knows whether it depends on t: then so does what it chooses.
  struct Truth {
    bool value;
    bool is_constant_in_t;
    double ready;

    operator bool() const { return value; }  // NOLINT(google-explicit-constructor): as a comparison of numbers
  };
  friend Truth operator<(const Counting& a, const Counting& b) { return truth(a.value_ < b.value_, a, b); }
  friend Truth operator<=(const Counting& a, const Counting& b) { return truth(a.value_ <= b.value_, a, b); }
  friend Truth operator>(const Counting& a, const Counting& b) { return b < a; }
  friend Truth operator>=(const Counting& a, const Counting& b) { return b <= a; }
  friend Counting select(const Truth& condition, const Counting& first, const Counting& second) {
    Counting chosen = condition ? first : second;
    chosen.is_constant_in_t_ = chosen.is_constant_in_t_ && condition.is_constant_in_t;
    chosen.ready_ = std::max(chosen.ready_, condition.ready);
    return chosen;
  }
  friend bool operator==(const Counting& a, const Counting& b) { return a.value_ == b.value_; }

 private:
  static Truth truth(bool value, const Counting& a, const Counting& b) {
    return {value, a.is_constant_in_t_ && b.is_constant_in_t_, std::max(a.ready_, b.ready_)};
  }
  static Counting after(Operation kind, double value, std::initializer_list<Counting> operands) {
    if (std::ranges::all_of(operands, &Counting::is_constant_in_t_)) return Counting(value);
    tape.count[kind] += 1;
    double ready = always;
    for (const auto& operand : operands) ready = std::max(ready, operand.ready_);
    return input(value, ready + tape.latency[kind]);
  }

  double value_ = 0;
  double ready_ = always;
  bool is_constant_in_t_ = false;
};

}  // namespace bezierbench::counting
