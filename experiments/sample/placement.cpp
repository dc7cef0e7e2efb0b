// SPDX-License-Identifier: MIT
#include "experiments/sample/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bezierbench::sample {
namespace {

using Vector = std::vector<double>;

double& at(ProjectionCase& problem, int i, int axis) {
  return problem.points[static_cast<std::size_t>(i * problem.dimension + axis)];
}

/// The point of the k-th hodograph at t, without the factors (n)_k. Its rounding errors do not matter.
Vector difference_at(const ProjectionCase& problem, int k, double t) {
  auto b = problem;
  for (int last = b.degree; last > 0; --last)
    for (int i = 0; i < last; ++i)
      for (int axis = 0; axis < b.dimension; ++axis) {
        const double step = at(b, i + 1, axis) - at(b, i, axis);
        at(b, i, axis) = b.degree - last < k ? step : at(b, i, axis) + t * step;
      }
  b.points.resize(static_cast<std::size_t>(b.dimension));
  return b.points;
}

/// The point of the curve at t. Its rounding errors do not matter.
Vector point_at(const ProjectionCase& problem, double t) {
  if (problem.weights.empty()) return difference_at(problem, 0, t);
  ProjectionCase homogeneous{problem.dimension + 1, problem.degree, {}, {}, {}};
  for (std::size_t i = 0; i < problem.weights.size(); ++i) {
    const auto d = static_cast<std::size_t>(problem.dimension);
    for (std::size_t axis = 0; axis < d; ++axis)
      homogeneous.points.push_back(problem.weights[i] * problem.points[i * d + axis]);
    homogeneous.points.push_back(problem.weights[i]);
  }
  auto point = difference_at(homogeneous, 0, t);
  const double weight = point.back();
  point.pop_back();
  for (double& x : point) x /= weight;
  return point;
}

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += a[axis] * b[axis];
  return sum;
}

void uniform(ProjectionCase& /*problem*/, double /*t*/) {}

void on_curve(ProjectionCase& problem, double t) { problem.point = point_at(problem, t); }

/// 2^-20, about a millionth, of the way from the curve to the drawn point.
void beside(ProjectionCase& problem, double t) {
  const auto foot = point_at(problem, t);
  for (std::size_t axis = 0; axis < foot.size(); ++axis)
    problem.point[axis] = foot[axis] + 0x1p-20 * (problem.point[axis] - foot[axis]);
}

/// The centre of curvature C + N / kappa. With v = C' and a the part of C'' normal to v it is C + a |v|^2 / |a|^2.
/// Where the curve is straight, or nearly, the drawn point is kept.
void centre(ProjectionCase& problem, double t) {
  if (problem.degree < 2 || problem.dimension < 2) return;
  const double n = problem.degree;
  const auto foot = difference_at(problem, 0, t);
  const auto v = difference_at(problem, 1, t);
  auto a = difference_at(problem, 2, t);
  const double along = dot(v, a) / dot(v, v);
  for (std::size_t axis = 0; axis < a.size(); ++axis) a[axis] -= along * v[axis];
  const double radius = n * dot(v, v) / ((n - 1) * dot(a, a));
  if (!std::isfinite(radius) || radius > 0x1p+20) return;
  for (std::size_t axis = 0; axis < a.size(); ++axis) problem.point[axis] = foot[axis] + radius * a[axis];
}

/// A curve with a cusp at t = 1/2, with the point at the cusp. The control points are rounded to a lattice of about
/// 2^20 steps, then the first one is moved such that sum C(n-1,j) (b_(j+1) - b_j) = 0. C'(1/2) = 0 is exact while
/// doubles hold the integers of this sum, about 2^20 2^n.
void cusp(ProjectionCase& problem, double /*t*/) {
  double largest = 0;
  for (const double x : problem.points) largest = std::fmax(largest, std::abs(x));
  if (largest == 0 || problem.degree < 2) return on_curve(problem, 0.5);
  const double lattice = std::ldexp(1.0, std::ilogb(largest) - 20);
  for (double& x : problem.points) x = std::floor(x / lattice) * lattice;
  for (int axis = 0; axis < problem.dimension; ++axis) {
    double sum = 0;
    double binomial = 1;
    for (int j = 1; j < problem.degree; ++j) {
      binomial = binomial * (problem.degree - j) / j;
      sum += binomial * (at(problem, j + 1, axis) - at(problem, j, axis));
    }
    at(problem, 0, axis) = at(problem, 1, axis) + sum;
  }
  on_curve(problem, 0.5);
}

/// A curve whose second half mirrors the first at the plane x = 0, with the point in this plane: nearest points come in
/// pairs.
void mirrored(ProjectionCase& problem, double /*t*/) {
  const int n = problem.degree;
  for (int i = 0; 2 * i <= n; ++i)
    for (int axis = 0; axis < problem.dimension; ++axis)
      at(problem, n - i, axis) = axis == 0 ? -at(problem, i, axis) : at(problem, i, axis);
  if (n % 2 == 0) at(problem, n / 2, 0) = 0;
  for (std::size_t i = 0; i < problem.weights.size() / 2; ++i)
    problem.weights[problem.weights.size() - 1 - i] = problem.weights[i];
  problem.point[0] = 0;
}

/// Control points at equal steps on a line: C'' = 0 and all leading coefficients of (C - P).C' vanish, except for
/// rounding errors of the steps.
void line(ProjectionCase& problem, double /*t*/) {
  for (int i = 1; i < problem.degree; ++i)
    for (int axis = 0; axis < problem.dimension; ++axis) {
      const double from = at(problem, 0, axis);
      at(problem, i, axis) =
          from + (at(problem, problem.degree, axis) - from) * (static_cast<double>(i) / problem.degree);
    }
}

constexpr std::array all{
    Placement{"uniform", "as a control point", uniform, true},
    Placement{"on_curve", "on the curve, rounded", on_curve, true},
    Placement{"beside", "a millionth of the way from the curve to a uniform point", beside, true},
    Placement{"centre", "the centre of curvature", centre},
    Placement{"cusp", "in a cusp of the curve", cusp},
    Placement{"mirrored", "on the axis of a symmetric curve", mirrored, true},
    Placement{"line", "as a control point; the curve is a line at constant speed, unless it is rational", line, true}};

bool is_finite(const ProjectionCase& problem) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return std::ranges::all_of(problem.points, finite) && std::ranges::all_of(problem.point, finite);
}

}  // namespace

double largest_coordinate(const ProjectionCase& problem) {
  double largest = 0;
  for (const auto* values : {&problem.points, &problem.point})
    for (const double x : *values) largest = std::max(largest, std::abs(x));
  return largest;
}

std::span<const Placement> placements() { return all; }

std::vector<std::string_view> placement_ids(Form form) {
  std::vector<std::string_view> ids;
  for (const auto& placement : all)
    if (placement.is_rational || form != Form::rational) ids.push_back(placement.id);
  return ids;
}

Cell with_point(Cell cell) {
  ++cell.degree;
  return cell;
}

ProjectionCase place(const Placement& placement, const Sampler& sampler, const Cell& cell, std::uint64_t trial) {
  Trial drawn;
  sampler.draw(trial, drawn);
  const auto d = static_cast<std::ptrdiff_t>(cell.dimension);
  ProjectionCase problem{cell.dimension,
                         cell.degree,
                         {drawn.coefficients.begin(), drawn.coefficients.end() - d},
                         {drawn.coefficients.end() - d, drawn.coefficients.end()},
                         drawn.weights};
  if (!problem.weights.empty()) problem.weights.pop_back();  // that of the point
  auto placed = problem;
  placement.place(placed, drawn.t);
  return is_finite(placed) ? placed : problem;
}

}  // namespace bezierbench::sample
