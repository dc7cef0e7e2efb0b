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
  friend bool operator<=(Counting /*a*/, Counting /*b*/) { return true; }
  Counting& operator+=(Counting b) { return *this = *this + b; }
  Counting& operator*=(Counting b) { return *this = *this * b; }
  [[nodiscard]] Counting fused(Counting /*b*/, Counting /*c*/) const { return after(2); }
};

/// The prepared state of an evaluator for a curve of this degree; its coefficients do not matter.
template <class Prepared, int Dimension>
Prepared any_state(int degree) {
  using Points = Curve<Form::bernstein, Counting, Dimension>;
  if constexpr (requires { Prepared(degree); })
    return Prepared(degree);
  else if constexpr (requires(const Points& points) { Prepared{points, points}; })
    return Prepared{Points(degree), Points(degree)};
  else
    return Prepared{Points(degree)};
}

template <class Entry, int Dimension>
long count(int degree) {
  using Prepared = typename Entry::State::template Prepared<Counting, Dimension, dynamic>;
  const auto state = any_state<Prepared, Dimension>(degree);
  operations = 0;
  Entry::Evaluator::evaluate(state, Counting());
  return operations;
}

using Count = long (*)(int degree);

template <class... Entries>
Count find_count(const MethodInfo& evaluator, std::size_t dimension, TypeList<Entries...> /*entries*/) {
  Count found = nullptr;
  ((found =
        &Entries::Evaluator::info == &evaluator
            ? std::array<Count, max_dimension>{count<Entries, 1>, count<Entries, 2>, count<Entries, 3>}[dimension - 1]
            : found),
   ...);
  return found;
}

}  // namespace

double flops_per_point(const MethodInfo& evaluator, int degree, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  Count found = find_count(evaluator, d, Unfused{});
  if (found == nullptr) found = find_count(evaluator, d, Fused{});
  if (found == nullptr) throw std::invalid_argument("flops_per_point: no evaluator of the batch roster");
  return static_cast<double>(found(degree));
}

}  // namespace bezierbench::batch
