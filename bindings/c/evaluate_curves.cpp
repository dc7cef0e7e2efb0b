// SPDX-License-Identifier: MIT
// Points of many curves of one degree by a method.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <limits>

#include "bindings/c/curve.hpp"
#include "bindings/c/evaluation.hpp"

using namespace bezierbench;

namespace {

constexpr std::size_t lanes = batch::curves_at_once;
constexpr int max_degree_of_groups = 63;         // whose coefficients stay in the first cache
constexpr std::size_t max_count_of_groups = 64;  // with more parameters each, curves are faster one by one
constexpr std::size_t groups_at_once = 8;
constexpr std::size_t largest_prepared = 80 * 1024;  // bytes

std::ptrdiff_t places(std::size_t count) { return static_cast<std::ptrdiff_t>(count); }

/// An index of an array: how many values it has, and over how many numbers it steps.
struct Index {
  std::size_t count;
  std::ptrdiff_t step;
};

/// Calls `check` with spans that together are all numbers of an array with three indices.
template <class Scalar, class Check>
void check_all(const Scalar* values, std::array<Index, 3> indices, const Check& check) {
  for (auto& index : indices) {
    if (index.count == 0) return;
    if (index.step == 0) index.count = 1;
  }
  c::require_pointers(values);
  std::ranges::sort(indices, std::greater(), [](const Index& index) {
    return index.count == 1 ? std::numeric_limits<std::ptrdiff_t>::max() : std::abs(index.step);
  });
  // An index that goes on where the one inside of it ends is one with it.
  auto& [outer, middle, inner] = indices;
  for (int indices_left = 3; indices_left > 1; --indices_left)
    if (middle.count == 1 || middle.step == places(inner.count) * inner.step) {
      inner.count *= middle.count;
      middle = outer;
      outer = {1, 0};
    }
  for (std::size_t i = 0; i < outer.count; ++i)
    for (std::size_t j = 0; j < middle.count; ++j) {
      const Scalar* first = values + places(i) * outer.step + places(j) * middle.step;
      if (inner.step == 1)
        check(std::span(first, inner.count));
      else
        for (std::size_t k = 0; k < inner.count; ++k) check(std::span(first + places(k) * inner.step, 1));
    }
}

/// The method and the arrays of a call, checked.
template <class Scalar>
class Curves {
 public:
  Curves(const char* method, const bb_batch& batch, const Scalar* points, const Scalar* weights, const Scalar* t,
         Scalar* out)
      : points_(points), weights_(weights), t_(t), out_(out), batch_(batch) {
    curve_ = {c::form_at(batch.form), batch.dimension, batch.degree, {}, {}};
    c::require_shape(batch.dimension, batch.degree);
    kernel_ = &c::evaluator(method, curve_);
    d_ = batch.dimension;
    coefficients_ = static_cast<std::size_t>(batch.degree) + 1;
    const auto or_dense = [](const bb_strides* given, bb_strides dense) { return given != nullptr ? *given : dense; };
    of_points_ = or_dense(batch.points, {places(coefficients_) * d_, d_, 1});
    of_t_ = or_dense(batch.t, {places(batch.count), 1, 0});
    of_out_ = or_dense(batch.out, {places(batch.count) * d_, d_, 1});
    check();
  }

  void evaluate() const {
    if (batch_.curves == 0 || batch_.count == 0) return;
    const bool side_by_side = batch_.curves > 1 && batch_.degree <= max_degree_of_groups &&
                              (batch_.count <= max_count_of_groups || of_out_.curve == 1);
    if (side_by_side)
      if (const Group group = best_group(); group.kernel.evaluate != nullptr) return evaluate_groups(group.kernel);
    evaluate_one_by_one();
  }

 private:
  /// Empty where a group's coefficients cannot be made of those that are given.
  struct Group {
    batch::GroupKernel<Scalar> kernel;
    explicit operator bool() const { return kernel.evaluate != nullptr; }
  };

  Group best_group() const {
    return c::on_best_target([&](const batch::Target& target) {
      const auto found = batch::find_group(target, *kernel_);
      return kernel_->conversion == nullptr || found.convert != nullptr ? Group{found} : Group{};
    });
  }

  void check() const {
    const auto finite = [](std::span<const Scalar> some) { c::require_finite(some); };
    const auto [curves, point, axis] = of_points_;
    const auto axes = static_cast<std::size_t>(d_);
    check_all(points_, {{{batch_.curves, curves}, {coefficients_, point}, {axes, axis}}}, finite);
    if (curve_.form == Form::rational)
      for (std::size_t k = 0; k < batch_.curves; ++k) c::weights_of(weights_ + k * coefficients_, batch_.degree);
    check_all(t_, {{{batch_.curves, of_t_.curve}, {batch_.count, of_t_.point}, {1, 0}}},
              [&](std::span<const Scalar> some) { c::require_parameters(*kernel_->info, some); });
    if (batch_.curves > 0 && batch_.count > 0) c::require_pointers(out_);
  }

  const Scalar* coefficient(std::size_t curve, std::size_t i, std::ptrdiff_t axis) const {
    return points_ + places(curve) * of_points_.curve + places(i) * of_points_.point + axis * of_points_.axis;
  }

  /// A number of each of `some` curves for the lanes of a group; the other lanes have that of the first curve as well.
  static void gather(const Scalar* from, std::ptrdiff_t step, std::size_t some, Scalar* to) {
    if (some == lanes) return copy_lanes(from, step, to, 1);
    c::copy_strided(from, step, some, to, 1);
    std::fill(to + some, to + lanes, *from);
  }

  static void scatter(const Scalar* from, std::size_t some, Scalar* to, std::ptrdiff_t step) {
    if (some == lanes) return copy_lanes(from, 1, to, step);
    c::copy_strided(from, 1, some, to, step);
  }

  static void copy_lanes(const Scalar* from, std::ptrdiff_t from_step, Scalar* to, std::ptrdiff_t to_step) {
    if (from_step != 1 || to_step != 1) return c::copy_strided(from, from_step, lanes, to, to_step);
    // GCC calls functions for std::copy_n and std::memcpy, also where it knows the length.
    constexpr std::size_t bytes = 32;
    using Vector [[gnu::vector_size(bytes), gnu::aligned(sizeof(Scalar)), gnu::may_alias]] = Scalar;
    for (std::size_t k = 0; k < lanes; k += bytes / sizeof(Scalar))
      *reinterpret_cast<Vector*>(to + k) = *reinterpret_cast<const Vector*>(from + k);
  }

  /// The coefficients of a group, side by side.
  void gather_curves(std::size_t first, std::size_t some, Scalar* to) const {
    const bool is_dense = of_points_.axis == 1 && of_points_.point == d_;
    if (!is_dense || some < lanes) {
      for (std::size_t i = 0; i < coefficients_; ++i)
        for (std::ptrdiff_t axis = 0; axis < d_; ++axis, to += lanes)
          gather(coefficient(first, i, axis), of_points_.curve, some, to);
      return;
    }
    const std::size_t numbers = coefficients_ * static_cast<std::size_t>(d_);
    const Scalar* from = coefficient(first, 0, 0);
    std::size_t i = 0;
    for (; i + 4 <= numbers; i += 4)
      for (std::size_t k = 0; k < lanes; k += 4)
        transpose(from + places(k) * of_points_.curve + i, of_points_.curve, to + i * lanes + k);
    for (; i < numbers; ++i) gather(from + i, of_points_.curve, lanes, to + i * lanes);
  }

  /// Four numbers of each of four curves, which are `step` apart.
  static void transpose(const Scalar* from, std::ptrdiff_t step, Scalar* to) {
    using Four [[gnu::vector_size(4 * sizeof(Scalar)), gnu::aligned(sizeof(Scalar)), gnu::may_alias]] = Scalar;
    const auto row = [&](int k) { return *reinterpret_cast<const Four*>(from + k * step); };
    const auto store = [&](int i, Four column) { *reinterpret_cast<Four*>(to + i * places(lanes)) = column; };
    const Four even = __builtin_shufflevector(row(0), row(1), 0, 4, 2, 6);
    const Four odd = __builtin_shufflevector(row(0), row(1), 1, 5, 3, 7);
    const Four even_too = __builtin_shufflevector(row(2), row(3), 0, 4, 2, 6);
    const Four odd_too = __builtin_shufflevector(row(2), row(3), 1, 5, 3, 7);
    store(0, __builtin_shufflevector(even, even_too, 0, 1, 4, 5));
    store(1, __builtin_shufflevector(odd, odd_too, 0, 1, 4, 5));
    store(2, __builtin_shufflevector(even, even_too, 2, 3, 6, 7));
    store(3, __builtin_shufflevector(odd, odd_too, 2, 3, 6, 7));
  }

  /// Some groups at once: a load of a vector that was just stored in parts would wait for the stores.
  void evaluate_groups(const batch::GroupKernel<Scalar>& group) const {
    constexpr auto room = static_cast<std::size_t>(max_degree_of_groups + 1) * c::max_dimension * lanes;
    std::array<Scalar, room> given;
    std::array<Scalar, room> converted;
    const std::size_t values = coefficients_ * static_cast<std::size_t>(d_) * lanes;  // of a group
    const std::size_t at_once = lanes * std::min(room / values, groups_at_once);
    for (std::size_t begin = 0; begin < batch_.curves; begin += at_once) {
      const std::size_t end = std::min(begin + at_once, batch_.curves);
      Scalar* next = given.data();
      for (std::size_t first = begin; first < end; first += lanes, next += values)
        gather_curves(first, std::min(lanes, end - first), next);
      const Scalar* evaluated = given.data();
      for (std::size_t first = begin; first < end; first += lanes, evaluated += values) {
        if (group.convert != nullptr) group.convert(batch_.degree, evaluated, converted.data());
        evaluate_group(group, first, std::min(lanes, end - first),
                       group.convert != nullptr ? converted.data() : evaluated);
      }
    }
  }

  void evaluate_group(const batch::GroupKernel<Scalar>& group, std::size_t first, std::size_t some,
                      const Scalar* coefficients) const {
    std::array<Scalar, lanes> ts;
    std::array<Scalar, lanes * c::max_dimension> computed;
    for (std::size_t k = 0; k < batch_.count; ++k) {
      gather(t_ + places(first) * of_t_.curve + places(k) * of_t_.point, of_t_.curve, some, ts.data());
      group.evaluate(batch_.degree, coefficients, ts.data(), computed.data());
      Scalar* out = out_ + places(first) * of_out_.curve + places(k) * of_out_.point;
      for (std::ptrdiff_t axis = 0; axis < d_; ++axis)
        scatter(computed.data() + axis * places(lanes), some, out + axis * of_out_.axis, of_out_.curve);
    }
  }

  void evaluate_one_by_one() const {
    const c::Evaluation<Scalar> evaluation(*kernel_, batch_.degree, batch_.count);
    const std::size_t values = coefficients_ * static_cast<std::size_t>(d_);
    std::array<Scalar, (max_degree + 1) * c::max_dimension> gathered;
    alignas(std::max_align_t) std::array<std::byte, largest_prepared> prepared;
    c::require(kernel_->prepared_size <= prepared.size(), BB_ERROR_INTERNAL);
    const bool dense = of_points_.axis == 1 && of_points_.point == d_;
    for (std::size_t k = 0; k < batch_.curves; ++k) {
      if (!dense)
        for (std::ptrdiff_t axis = 0; axis < d_; ++axis)
          c::copy_strided(coefficient(k, 0, axis), of_points_.point, coefficients_, gathered.data() + axis, d_);
      auto curve = curve_;
      curve.coefficients = {dense ? coefficient(k, 0, 0) : gathered.data(), values};
      if (curve.form == Form::rational) curve.weights = {weights_ + k * coefficients_, coefficients_};
      kernel_->prepare(curve, prepared.data());
      evaluation(prepared.data(), t_ + places(k) * of_t_.curve, of_t_.point, batch_.count,
                 out_ + places(k) * of_out_.curve, of_out_);
    }
  }

  const Scalar* points_;
  const Scalar* weights_;
  const Scalar* t_;
  Scalar* out_;
  bb_batch batch_;
  CurveView<Scalar> curve_;  ///< what all curves have in common
  const Kernel<Scalar>* kernel_;
  std::ptrdiff_t d_;
  std::size_t coefficients_;  ///< of a curve, on each axis
  bb_strides of_points_;
  bb_strides of_t_;
  bb_strides of_out_;
};

template <class Scalar>
int evaluate_curves(const char* method, const bb_batch* batch, const Scalar* points, const Scalar* weights,
                    const Scalar* t, Scalar* out) {
  return c::guarded([&] {
    c::require_pointers(batch);
    Curves<Scalar>(method, *batch, points, weights, t, out).evaluate();
  });
}

}  // namespace

int bb_evaluate_curves(const char* method, const bb_batch* batch, const double* points, const double* weights,
                       const double* t, double* out) {
  return evaluate_curves(method, batch, points, weights, t, out);
}

int bb_evaluate_curves_float(const char* method, const bb_batch* batch, const float* points, const float* weights,
                             const float* t, float* out) {
  return evaluate_curves(method, batch, points, weights, t, out);
}
