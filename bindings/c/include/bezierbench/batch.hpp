// SPDX-License-Identifier: MIT
// Many points of one curve, or of many curves, in one call, several of them in every instruction of the processor that runs
// it: bb_evaluate_curves of libbezierbench.so for ranges. Each point has the bits of `evaluate<Method>(points, t)`.
#pragma once

#include <bezierbench/bezierbench.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <new>
#include <ranges>
#include <stdexcept>
#include <type_traits>

namespace bezierbench {

namespace detail {

template <class T>
inline constexpr bool is_batch_point = false;
template <std::floating_point Scalar, std::size_t d>
inline constexpr bool is_batch_point<std::array<Scalar, d>> = d >= 1 && d <= 3 && sizeof(Scalar) <= sizeof(double);

inline int evaluate_curves(const char* method, const bb_batch& batch, const float* points, const float* t, float* out) {
  return bb_evaluate_curves_float(method, &batch, points, nullptr, t, out);
}
inline int evaluate_curves(const char* method, const bb_batch& batch, const double* points, const double* t,
                           double* out) {
  return bb_evaluate_curves(method, &batch, points, nullptr, t, out);
}

}  // namespace detail

/// A contiguous range of std::array<float, d> or std::array<double, d>, d = 1, 2 or 3.
template <class Range>
concept BatchPoints = std::ranges::contiguous_range<Range> && std::ranges::sized_range<Range> &&
    detail::is_batch_point<std::ranges::range_value_t<Range>>;

/// Points of curves of one degree. `points` has the degree + 1 control points (coefficients for BB_POWER) of each, curve after
/// curve, `t` the same number of parameters for each, and out[k] becomes the point at t[k]. `method` is an id, such as
/// `HornerBernstein::info.id.data()`; null stands for what `evaluate` chooses. Throws std::invalid_argument for what the
/// library refuses and for sizes that do not fit; allocates nothing otherwise.
template <BatchPoints Points, std::ranges::contiguous_range Parameters, BatchPoints Out>
void evaluate_curves(const Points& points, int degree, const Parameters& t, Out&& out, const char* method = nullptr,
                     bb_form form = BB_BERNSTEIN) {
  using Point = std::ranges::range_value_t<Points>;
  using Scalar = typename Point::value_type;
  static_assert(std::is_same_v<std::ranges::range_value_t<Out>, Point>, "control points and points are of one type");
  static_assert(std::is_same_v<std::ranges::range_value_t<Parameters>, Scalar>, "t has the type of the coordinates");
  if (form == BB_RATIONAL) throw std::invalid_argument("bezierbench: rational curves have weights: bb_evaluate_curves");
  const std::size_t coefficients = degree < 0 ? 1 : static_cast<std::size_t>(degree) + 1;
  const std::size_t curves = std::ranges::size(points) / coefficients;
  const std::size_t count = curves == 0 ? 0 : std::ranges::size(t) / curves;
  if (curves * coefficients != std::ranges::size(points) || curves * count != std::ranges::size(t) ||
      std::ranges::size(out) != std::ranges::size(t))
    throw std::invalid_argument("bezierbench: the numbers of control points, parameters and points do not fit");
  const bb_batch batch{form,   static_cast<int>(std::tuple_size_v<Point>), degree, curves, count, nullptr, nullptr,
                       nullptr};
  const auto* first = std::ranges::data(points);
  auto* first_out = std::ranges::data(out);
  const int status = detail::evaluate_curves(method, batch, curves > 0 ? first->data() : nullptr, std::ranges::data(t),
                                             count > 0 ? first_out->data() : nullptr);
  if (status == BB_ERROR_MEMORY) throw std::bad_alloc();
  if (status != BB_OK) throw std::invalid_argument(bb_strerror(status));
}

/// Points of one curve; as above.
template <BatchPoints Points, std::ranges::contiguous_range Parameters, BatchPoints Out>
void evaluate_batch(const Points& points, const Parameters& t, Out&& out, const char* method = nullptr,
                    bb_form form = BB_BERNSTEIN) {
  evaluate_curves(points, static_cast<int>(std::ranges::size(points)) - 1, t, out, method, form);
}

}  // namespace bezierbench
