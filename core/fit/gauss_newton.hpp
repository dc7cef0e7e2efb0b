// SPDX-License-Identifier: MIT
// Formula: orthogonal distance fit: handles h and all parameters t_i at once by Levenberg and Marquardt. With
//   r_i = C(t_i) - P_i, c_i = C'(t_i) and J_i = dC(t_i)/dh, each t_i is eliminated from the normal equations by itself,
//     sum J_i^T Q_i J_i dh = -sum J_i^T Q_i r_i,  Q_i = I - c_i c_i^T / |c_i|^2,  dt_i = -c_i.(r_i + J_i dh) / |c_i|^2,
//   so that a system of at most 2d equations remains. The unknowns of a free end are its whole control point. Those of
//   a smooth joint are the length of its handle, which must stay positive. Few points leave directions free along which
//   a sum of squares falls slowly while handles grow without end. So a segment that keeps the promise is given up only
//   for one that keeps it, too, with half the error: samples of a cubic lead to that cubic, noise ends the search.
// Source: the Jacobian is that of [Kaufman 1975]; damping by [Marquardt 1963].
// Cost: three starts of at most 64 steps each. Of more than 513 points a sample of 513 is fitted first, and all of
//   them from that result where it keeps the tolerance.
// Bound: none of the fit itself; piecewise.hpp bounds the distance of every data point from the result. Where the data
//   are samples of a cubic, this cubic is a minimum of 0, to which steps converge quadratically from nearby. The first
//   start takes parameters by chord length; where that does not keep the tolerance, two more take the square roots of
//   chord lengths ([Lee 1989]) and equal steps.
// Fails: it may end in another minimum, where a cubic has a loop or is near a cusp.
#pragma once

#include <Eigen/Cholesky>
#include <limits>

#include "core/fit/fitting.hpp"

namespace bezierbench {

struct GaussNewton {
  static constexpr MethodInfo info{.id = "gauss_newton",
                                   .label = "Orthogonal distances",
                                   .problem = Problem::fitting,
                                   .form = Form::bernstein,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .promise = fit_promise,
                                   .flops = "O(d^2 m) per step",
                                   .citation = "[Golub and Pereyra 1973]; [Borges and Pastva 2002], section 3"};

  template <int Dimension>
  static Piece<Dimension> piece(const Section<Dimension>& section) {
    if (section.points.cols() <= max_points) return best_of_starts(section);
    const auto some = thinned(section);
    const auto coarse = best_of_starts(some);
    Piece<Dimension> guess{coarse.cubic, parameters_between(some.t, coarse.t, section.t), coarse.iterations};
    if (largest_error(some, coarse) > section.tolerance) return guess;
    auto fine = adjusted(section, std::move(guess.t));
    fine.iterations += coarse.iterations;
    return fine;
  }

  /// The tangent of the parabola through the three points, with the distances between the points as steps of its
  /// parameter.
  template <int Dimension>
  static Point<double, Dimension> tangent(const Point<double, Dimension>& before,
                                          const Point<double, Dimension>& after) {
    const double h = length<Dimension>(before);
    const double k = length<Dimension>(after);
    return (k / h) * before + (h / k) * after;
  }

 private:
  using Parameters = std::vector<double>;

  static constexpr Eigen::Index max_points = 513;  ///< more points than these are sampled first

  /// The best of the fits from three choices of parameters.
  template <int Dimension>
  static Piece<Dimension> best_of_starts(const Section<Dimension>& section) {
    Piece<Dimension> best;
    double least = std::numeric_limits<double>::infinity();
    int iterations = 0;
    for (const auto start : {as_given, centripetal, uniform}) {
      auto found = adjusted(section, start(section.t));
      iterations += found.iterations;
      const bool kept = keeps_promise(section, found);
      const double error = largest_error(section, found);
      if (kept || error < least) {
        least = error;
        best = std::move(found);
      }
      if (kept) break;
    }
    best.iterations = iterations;
    return best;
  }

  /// A sample of `max_points` points at even steps, both ends among them.
  template <int Dimension>
  static Section<Dimension> thinned(const Section<Dimension>& section) {
    Section<Dimension> some{Polygon<Dimension>(Dimension, max_points),
                            {},
                            section.length,
                            std::vector<double>(max_points - 1, std::numeric_limits<double>::infinity()),
                            section.start,
                            section.end,
                            section.tolerance};
    for (Eigen::Index k = 0; k < max_points; ++k) {
      const Eigen::Index i = k * (section.points.cols() - 1) / (max_points - 1);
      some.points.col(k) = section.points.col(i);
      some.t.push_back(section.t[static_cast<std::size_t>(i)]);
    }
    return some;
  }

  /// The values at `all` of the piecewise linear function that has the values `value` at `at`. `at` ascends, and its
  /// ends are those of `all`.
  static Parameters parameters_between(const Parameters& at, const Parameters& value, const Parameters& all) {
    Parameters result;
    std::size_t k = 0;
    for (const double x : all) {
      while (k + 2 < at.size() && at[k + 1] < x) ++k;
      const double width = at[k + 1] - at[k];
      const double share = width > 0 ? (x - at[k]) / width : 0;
      result.push_back(value[k] + share * (value[k + 1] - value[k]));
    }
    return result;
  }

  static Parameters as_given(const Parameters& t) { return t; }

  /// Parameters whose steps are the square roots of the given ones ([Lee 1989]).
  static Parameters centripetal(const Parameters& t) {
    Parameters result{0};
    for (std::size_t i = 1; i < t.size(); ++i) result.push_back(result.back() + std::sqrt(t[i] - t[i - 1]));
    for (double& value : result) value /= result.back();
    return result;
  }

  static Parameters uniform(const Parameters& t) {
    Parameters result;
    for (std::size_t i = 0; i < t.size(); ++i)
      result.push_back(static_cast<double>(i) / static_cast<double>(t.size() - 1));
    return result;
  }

  template <int Dimension>
  static Piece<Dimension> adjusted(const Section<Dimension>& section, Parameters start) {
    constexpr int max_steps = 64;
    constexpr double min_damping = 0x1p-40;
    constexpr double max_damping = 0x1p+20;
    Adjustment<Dimension> adjustment(section);
    State<Dimension> now = adjustment.begin(std::move(start));
    bool kept = adjustment.keeps_promise(now);
    int steps = 0;
    for (double damping = 0x1p-10; steps < max_steps && damping < max_damping; ++steps) {
      auto next = adjustment.step(now, damping);
      if (!(next.cost < now.cost)) {
        if (kept) break;
        damping *= 16;
        continue;
      }
      const bool next_kept = adjustment.keeps_promise(next);
      if (kept && !(next_kept && next.cost < now.cost / 4)) break;
      const bool settled = damping < 0x1p-20 && next.cost > now.cost * (1 - 0x1p-10);
      now = std::move(next);
      kept = next_kept;
      if (settled) break;
      damping = std::max(damping / 16, min_damping);
    }
    return {adjustment.cubic(now.handles), std::move(now.t), steps};
  }

  /// The unknowns of two handles in three dimensions. All dimensions use the same type, so that Eigen's solver is
  /// compiled once.
  static constexpr int max_unknowns = 6;
  using Handles = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_unknowns, 1>;
  using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_unknowns, max_unknowns>;

  template <int Dimension>
  struct State {
    Handles handles;
    std::vector<double> t;
    double cost;
  };

  template <int Dimension>
  class Adjustment {
   public:
    explicit Adjustment(const Section<Dimension>& section)
        : section_(section),
          start_unknowns_(section.start.bound ? 1 : Dimension),
          unknowns_(start_unknowns_ + (section.end.bound ? 1 : Dimension)) {}

    /// The best handles for these parameters. Handles that are not positive are replaced by a third of the polyline's
    /// length.
    [[nodiscard]] State<Dimension> begin(Parameters t) const {
      const double third = section_.length / 3;
      Handles handles(unknowns_);
      for (int k = 0; k < unknowns_; ++k) {
        const bool start = k < start_unknowns_;
        const auto& end = start ? section_.start : section_.end;
        handles[k] = end.bound ? third : third * end.direction[start ? k : k - start_unknowns_];
      }
      State<Dimension> thirds{handles, std::move(t), 0};
      State<Dimension> best{handles + change(thirds, 0x1p-30, [](const auto&) { return Square::Identity(); }), thirds.t,
                            0};
      auto& state = allowed(best.handles) ? best : thirds;
      settle(state);
      return state;
    }

    [[nodiscard]] Cubic<Dimension> cubic(const Handles& handles) const {
      const Point<double, Dimension> first = section_.points.col(0);
      const Point<double, Dimension> last = section_.points.col(section_.points.cols() - 1);
      return {first, first + handle(section_.start, handles, 0), last + handle(section_.end, handles, start_unknowns_),
              last};
    }

    [[nodiscard]] bool keeps_promise(const State<Dimension>& state) const {
      return bezierbench::keeps_promise<Dimension>(section_, {cubic(state.handles), state.t});
    }

    /// The state after one damped step. Its cost is infinite where the length of a handle at a smooth joint would not
    /// be positive.
    [[nodiscard]] State<Dimension> step(const State<Dimension>& now, double damping) const {
      const auto curve = cubic(now.handles);
      const Handles moves = change(now, damping, projection);
      State<Dimension> next{now.handles + moves, now.t, std::numeric_limits<double>::infinity()};
      if (!allowed(next.handles)) return next;
      for (std::size_t i = 1; i + 1 < next.t.size(); ++i) {
        const auto at = offset_at<Dimension>(curve, point(i), now.t[i]);
        const Point<double, Dimension> moved = at.offset + jacobian_at(now.t[i]) * moves;
        const double dt = -dot<Dimension>(at.velocity, moved) / squared<Dimension>(at.velocity);
        if (std::isfinite(dt)) next.t[i] = std::clamp(now.t[i] + dt, 0.0, 1.0);
      }
      settle(next);
      return next;
    }

   private:
    using Jacobian = Eigen::Matrix<double, Dimension, Eigen::Dynamic, Dimension == 1 ? Eigen::RowMajor : 0, Dimension,
                                   2 * Dimension>;
    using Square = Eigen::Matrix<double, Dimension, Dimension>;

    /// The solution of the damped normal equations; `measured` returns the matrix that weights the residuals.
    template <class Measured>
    [[nodiscard]] Handles change(const State<Dimension>& now, double damping, Measured measured) const {
      const auto curve = cubic(now.handles);
      System normal = System::Zero(unknowns_, unknowns_);
      Handles gradient = Handles::Zero(unknowns_);
      for (std::size_t i = 1; i + 1 < now.t.size(); ++i) {
        const auto at = offset_at<Dimension>(curve, point(i), now.t[i]);
        const auto jacobian = jacobian_at(now.t[i]);
        const Square across = measured(at.velocity);
        normal += jacobian.transpose() * across * jacobian;
        gradient += jacobian.transpose() * (across * at.offset);
      }
      const double largest = normal.diagonal().maxCoeff();
      for (int k = 0; k < unknowns_; ++k) normal(k, k) += damping * normal(k, k) + 0x1p-50 * largest;
      return -normal.ldlt().solve(gradient);
    }

    [[nodiscard]] Point<double, Dimension> point(std::size_t i) const {
      return section_.points.col(static_cast<Eigen::Index>(i));
    }

    [[nodiscard]] Point<double, Dimension> handle(const End<Dimension>& end, const Handles& handles, int from) const {
      if (end.bound) return handles[from] * end.direction;
      return handles.template segment<Dimension>(from);
    }

    [[nodiscard]] Jacobian jacobian_at(double t) const {
      const auto basis = cubic_basis(t);
      Jacobian jacobian = Jacobian::Zero(Dimension, unknowns_);
      const auto fill = [&](const End<Dimension>& end, int from, double weight) {
        for (int axis = 0; axis < Dimension; ++axis) {
          if (end.bound)
            jacobian(axis, from) = weight * end.direction[axis];
          else
            jacobian(axis, from + axis) = weight;
        }
      };
      fill(section_.start, 0, basis[1]);
      fill(section_.end, start_unknowns_, basis[2]);
      return jacobian;
    }

    /// Q = I - c c^T / |c|^2. Q is I where C' = 0, and in one dimension, where it would be 0; the parameter then stays.
    static Square projection(const Point<double, Dimension>& c) {
      Square across = Square::Identity();
      const double square = squared<Dimension>(c);
      if (Dimension > 1 && square > 0) across -= (c / square) * c.transpose();
      return across;
    }

    [[nodiscard]] bool allowed(const Handles& handles) const {
      constexpr double least = 0x1p-10;  // of the polyline's length
      const auto curve = cubic(handles);
      const double most = longest_handle * section_.length;
      if (!(length<Dimension>(curve[1] - curve[0]) <= most && length<Dimension>(curve[2] - curve[3]) <= most))
        return false;
      return (!section_.start.bound || handles[0] >= least * section_.length) &&
             (!section_.end.bound || handles[start_unknowns_] >= least * section_.length);
    }

    /// Moves the parameters of a state to foot points nearby and sums up the squared distances there.
    void settle(State<Dimension>& state) const {
      constexpr int max_steps = 3;
      const auto curve = cubic(state.handles);
      state.cost = 0;
      for (std::size_t i = 1; i + 1 < state.t.size(); ++i) {
        state.t[i] = approach<Dimension>(curve, point(i), state.t[i], max_steps);
        state.cost += squared<Dimension>(offset_at<Dimension>(curve, point(i), state.t[i]).offset);
      }
    }

    const Section<Dimension>& section_;
    int start_unknowns_;  ///< number of unknowns of the first handle
    int unknowns_;
  };
};

}  // namespace bezierbench
