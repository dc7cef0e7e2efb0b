// SPDX-License-Identifier: MIT
// Chains of operations for the target that the including translation unit is compiled for.
#pragma once

#include <hwy/highway.h>

#include <utility>

#include "core/batch/operation_work.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Odd, so that chains that swing between two values have moved.
inline constexpr int steps_of_chains = 255;

template <Operation Kind, class Vector>
HWY_INLINE Vector step(Vector x, Vector operand) {
  if constexpr (Kind == Operation::add) return hn::Add(x, operand);
  if constexpr (Kind == Operation::multiply) return hn::Mul(x, operand);
  if constexpr (Kind == Operation::fused) return hn::MulAdd(x, operand, operand);
  if constexpr (Kind == Operation::divide) return hn::Div(operand, x);
  if constexpr (Kind == Operation::square_root) return hn::Sqrt(x);
}

/// Factors of the operand of divisions whose significands have no short quotients; the product is exact in float.
inline constexpr double divisor = 2731.0 / 2048;
inline constexpr double quotient = 3413.0 / 2048;

constexpr double operand_of(Operation kind) {
  switch (kind) {
    case Operation::multiply: return -1;
    case Operation::divide: return divisor * quotient;
    default: return 0.5;
  }
}

template <class S>
constexpr ChainEnds<S> ends_of(Operation kind, std::size_t values) {
  constexpr S half = 0.5;
  switch (kind) {
    case Operation::add: return {values, 0, half * steps_of_chains};
    case Operation::multiply: return {values, 1, -1};
    case Operation::fused: return {values, 0, 1};  // x/2 + 1/2
    case Operation::divide: return {values, S(divisor), S(quotient)};
    case Operation::square_root: return {values, 2, 1};
  }
  return {};
}

/// `Count` chains of one kind and `BesideCount` of another, a vector of `Lanes` numbers in each.
template <class S, std::size_t Lanes, Operation Kind, int Count, Operation Beside, int BesideCount>
class Chains {
 public:
  static void run(S operand, S* values) {
    advance(operand, values, std::make_integer_sequence<int, Count>(), std::make_integer_sequence<int, BesideCount>());
  }
  static constexpr OperationWork<S> work() {
    return {run,
            S(operand_of(Kind)),
            {ends_of<S>(Kind, Count * Lanes), ends_of<S>(Beside, BesideCount * Lanes)},
            (Count + BesideCount) * steps_of_chains};
  }

 private:
  template <int... X, int... Y>
  static HWY_INLINE void advance(S operand, S* values, std::integer_sequence<int, X...> /*chains*/,
                                 std::integer_sequence<int, Y...> /*chains beside*/) {
    const hn::FixedTag<S, Lanes> tag;
    using Vector = hn::Vec<hn::FixedTag<S, Lanes>>;
    const Vector all = hn::Set(tag, operand);
    Vector x[Count];
    [[maybe_unused]] Vector y[BesideCount + 1];  // no array is empty
    ((x[X] = hn::LoadU(tag, values + X * Lanes)), ...);
    ((y[Y] = hn::LoadU(tag, values + (Count + Y) * Lanes)), ...);
    for (int k = 0; k < steps_of_chains; ++k) {
      ((x[X] = step<Kind>(x[X], all)), ...);
      ((y[Y] = step<Beside>(y[Y], all)), ...);
    }
    (hn::StoreU(x[X], tag, values + X * Lanes), ...);
    (hn::StoreU(y[Y], tag, values + (Count + Y) * Lanes), ...);
  }
};

template <Operation...>
struct OperationList {};

/// 12 chains hide the latency of the pipelined kinds: it is 4 cycles, and 2 operations are issued in a cycle. Divisions
/// and square roots are hardly pipelined.
template <class S, std::size_t Lanes, Operation... Kinds>
constexpr OperationWorks<S> works_of(OperationList<Kinds...> /*kinds*/) {
  constexpr bool many_registers = HWY_TARGET != HWY_AVX2;
  constexpr int fused = many_registers ? 12 : 8;
  constexpr int added = many_registers ? 12 : 7;  // with the operand, sixteen registers
  return {Lanes,
          {Chains<S, Lanes, Kinds, (Kinds < Operation::divide ? 12 : 8), Kinds, 0>::work()...},
          {Chains<S, Lanes, Kinds, 1, Kinds, 0>::work()...},
          Chains<S, Lanes, Operation::fused, fused, Operation::add, added>::work()};
}

/// From 16 bytes up to the full vectors.
template <class S, std::size_t... Doublings>
constexpr std::array<OperationWorks<S>, sizeof...(Doublings)> works_of_widths(
    std::index_sequence<Doublings...> /*widths*/) {
  using enum Operation;
  constexpr OperationList<add, multiply, fused, divide, square_root> kinds;
  return {works_of<S, (std::size_t(16) << Doublings) / sizeof(S)>(kinds)...};
}

constexpr std::size_t widths() {
  std::size_t count = 1;
  while ((std::size_t(16) << count) <= HWY_LANES(float) * sizeof(float)) ++count;
  return count;
}

template <class S>
inline constexpr std::array<OperationWorks<S>, widths()> all_works =
    works_of_widths<S>(std::make_index_sequence<widths()>());

}  // namespace bezierbench::batch::HWY_NAMESPACE

namespace bezierbench::batch {

template <class Target, class Scalar>
constinit const WorksOfWidths<Scalar> WorksOf<Target, Scalar>::table = HWY_NAMESPACE::all_works<Scalar>;

}  // namespace bezierbench::batch
