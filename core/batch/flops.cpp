// SPDX-License-Identifier: MIT
#include "core/batch/flops.hpp"

#include <array>
#include <stdexcept>

#include "core/batch/roster.hpp"
#include "core/batch/target_table.hpp"

namespace bezierbench::batch {
namespace {

thread_local long operations = 0;

/// A scalar without a value that counts the operations on it.
struct Counting {
  Counting() = default;
  explicit Counting(double /*value*/) {}

  static Counting after(long more) {
    operations += more;
    return {};
  }
  friend Counting operator+(Counting /*a*/, Counting /*b*/) { return after(1); }
  friend Counting operator-(Counting /*a*/, Counting /*b*/) { return after(1); }
  friend Counting operator*(Counting /*a*/, Counting /*b*/) { return after(1); }
  friend Counting operator/(Counting /*a*/, Counting /*b*/) { return after(1); }
  friend Counting operator-(Counting a) { return a; }
  friend bool operator<(Counting /*a*/, Counting /*b*/) { return false; }
  friend bool operator==(Counting /*a*/, Counting /*b*/) { return false; }
  friend bool operator<=(Counting /*a*/, Counting /*b*/) { return true; }
  Counting& operator+=(Counting b) { return *this = *this + b; }
  Counting& operator*=(Counting b) { return *this = *this * b; }
  [[nodiscard]] Counting fused(Counting /*b*/, Counting /*c*/) const { return after(2); }
};

/// The prepared state of an evaluator for a curve of this degree; its coefficients do not matter.
template <class Prepared, int Dimension>
Prepared any_state(int degree) {
  using Points = Curve<Form::bernstein, Counting, Dimension>;
  using Row = PerCoefficient<Counting, dynamic>;
  const auto row = [degree] { return per_coefficient<Counting, dynamic>(degree); };
  if constexpr (requires { Prepared(degree); })
    return Prepared(degree);
  else if constexpr (requires(const Points& points, const Row& values) { Prepared{points, values}; })
    return Prepared{Points(degree), row()};
  else if constexpr (requires(const Points& points, const Row& values) { Prepared{values, values, points}; })
    return Prepared{row(), row(), Points(degree)};
  else if constexpr (requires(const Points& points) { Prepared{points, points}; })
    return Prepared{Points(degree), Points(degree)};
  else
    return Prepared{Points(degree)};
}

/// Of an evaluator with the prepared state of an entry, for curves with `Dimension` coordinates.
template <class Evaluator, class Entry, int Dimension>
long count(int degree) {
  using Prepared = typename Entry::State::template Prepared<Counting, Dimension, dynamic>;
  const auto state = any_state<Prepared, Dimension>(degree);
  operations = 0;
  Evaluator::evaluate(state, Counting());
  return operations;
}

using Count = long (*)(int degree);

template <class Entry>
Count count_of(const MethodInfo& evaluator, std::size_t dimension) {
  using E = typename Entry::Evaluator;
  if (&E::info == &evaluator)
    return std::array<Count, max_dimension>{count<E, Entry, 1>, count<E, Entry, 2>, count<E, Entry, 3>}[dimension - 1];
  if constexpr (takes_rational<E>) {
    using Rational = Homogeneous<E>;
    if (&Rational::info == &evaluator)
      return std::array<Count, max_dimension>{count<Rational, Entry, 2>, count<Rational, Entry, 3>,
                                              count<Rational, Entry, 4>}[dimension - 1];
  }
  return nullptr;
}

template <class... Entries>
Count find_count(const MethodInfo& evaluator, std::size_t dimension, TypeList<Entries...> /*entries*/) {
  Count found = nullptr;
  ((found = found == nullptr ? count_of<Entries>(evaluator, dimension) : found), ...);
  return found;
}

template <class... Family>
Count find_count(const MethodInfo& evaluator, std::size_t dimension, TypeList<Family...>* /*families*/) {
  Count found = nullptr;
  ((found = found == nullptr ? find_count(evaluator, dimension, EntriesOf<Family>()) : found), ...);
  return found;
}

}  // namespace

double flops_per_point(const MethodInfo& evaluator, int degree, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  const Count found = find_count(evaluator, d, static_cast<Families*>(nullptr));
  if (found == nullptr) throw std::invalid_argument("flops_per_point: no evaluator of the batch roster");
  return static_cast<double>(found(degree));
}

}  // namespace bezierbench::batch
