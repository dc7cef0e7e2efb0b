// SPDX-License-Identifier: MIT
#include "experiments/sample/data_kind.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bezierbench::sample {
namespace {

using Data = std::vector<double>;

std::size_t dimension_of(const DataSource& source) { return static_cast<std::size_t>(source.dimension); }
std::size_t count_of(const DataSource& source) { return source.displacements.size() / dimension_of(source); }

/// Appends the point of the curve at `t`.
void append_point(const DataSource& source, double t, Data& data) {
  const auto d = dimension_of(source);
  auto b = source.control_points;
  for (std::size_t last = b.size() / d - 1; last > 0; --last)
    for (std::size_t k = 0; k < last * d; ++k) b[k] = (1 - t) * b[k] + t * b[k + d];
  data.insert(data.end(), b.begin(), b.begin() + source.dimension);
}

double equal_step(std::size_t k, std::size_t count) { return static_cast<double>(k) / static_cast<double>(count - 1); }

Data samples(DataSource source) {
  Data data;
  for (std::size_t k = 0; k < count_of(source); ++k) append_point(source, equal_step(k, count_of(source)), data);
  return data;
}

/// The k-th of m parameters lies in the k-th of m equal parts of the interval, at the place given by the first
/// coordinate of its displacement. The first and the last parameter are the ends of the interval.
Data uneven(DataSource source) {
  const auto count = count_of(source);
  double range = 0;
  for (const double x : source.displacements) range = std::max(range, std::abs(x));
  Data data;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = source.displacements[k * dimension_of(source)];
    const double shift = range > 0 ? x / range / 2 : 0;
    const double t = (static_cast<double>(k) + 0.5 + shift) / static_cast<double>(count);
    append_point(source, k == 0 ? 0 : k + 1 == count ? 1 : t, data);
  }
  return data;
}

/// Samples moved by a 1024th of their displacements.
Data noisy(DataSource source) {
  auto data = samples(source);
  for (std::size_t k = 0; k < data.size(); ++k) data[k] += 0x1p-10 * source.displacements[k];
  return data;
}

/// Points at equal steps along each side of the control polygon, its vertices among them. The last side gets the
/// remaining points.
Data polyline(DataSource source) {
  const auto d = dimension_of(source);
  const auto sides = static_cast<std::size_t>(source.degree);
  const auto last = count_of(source) - 1;
  const auto per_side = std::max<std::size_t>(last / sides, 1);
  Data data;
  for (std::size_t k = 0; k <= last; ++k) {
    const auto side = std::min(k / per_side, sides - 1);
    const auto begin = side * per_side;
    const auto end = side + 1 < sides ? begin + per_side : std::max(last, begin + 1);
    const double t = static_cast<double>(k - begin) / static_cast<double>(end - begin);
    for (std::size_t axis = 0; axis < d; ++axis)
      data.push_back((1 - t) * source.control_points[side * d + axis] +
                     t * source.control_points[(side + 1) * d + axis]);
  }
  return data;
}

/// Samples of a closed curve. From degree 4 on both ends have the same derivative. For a cubic this would give
/// b_2 - b_0 = -(b_1 - b_0), a curve that runs forth and back on a line.
Data closed(DataSource source) {
  const auto d = dimension_of(source);
  auto& b = source.control_points;
  std::copy_n(b.begin(), d, b.end() - source.dimension);
  if (source.degree >= 4)
    for (std::size_t axis = 0; axis < d; ++axis) b[b.size() - 2 * d + axis] = 2 * b[axis] - b[d + axis];
  auto data = samples(source);
  std::copy_n(data.begin(), d, data.end() - source.dimension);
  return data;
}

/// Points as from a poor pointing device: with noise, repeated points and some steps backwards.
Data drawn(DataSource source) {
  const auto d = source.dimension;
  const auto clean = noisy(std::move(source));
  Data data;
  for (std::size_t k = 0; k < clean.size() / static_cast<std::size_t>(d); ++k) {
    const auto from = clean.begin() + static_cast<std::ptrdiff_t>(k % 7 == 3 ? k - 1 : k % 11 == 10 ? k - 3 : k) * d;
    data.insert(data.end(), from, from + d);
  }
  return data;
}

constexpr std::array all{DataKind{"samples", "a curve at equal steps of t", samples},
                         DataKind{"uneven", "a curve at random parameters in order", uneven},
                         DataKind{"noisy", "samples, moved by up to 2^-10 R", noisy},
                         DataKind{"polyline", "equal steps along the control polygon", polyline},
                         DataKind{"closed", "samples of a closed curve, smoothly closed from degree 4 on", closed},
                         DataKind{"drawn", "noisy samples with repetitions and steps backwards", drawn}};

}  // namespace

std::span<const DataKind> data_kinds() { return all; }

Cell with_displacements(Cell cell, int points) {
  cell.degree += points;
  return cell;
}

std::vector<double> data_points(const DataKind& kind, const Sampler& sampler, const Cell& cell, std::uint64_t trial) {
  Trial drawn;
  sampler.draw(trial, drawn);
  const auto own = drawn.coefficients.begin() + static_cast<std::ptrdiff_t>(cell.degree + 1) * cell.dimension;
  return kind.make({cell.dimension, cell.degree, {drawn.coefficients.begin(), own}, {own, drawn.coefficients.end()}});
}

}  // namespace bezierbench::sample
