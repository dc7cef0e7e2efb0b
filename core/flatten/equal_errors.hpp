// SPDX-License-Identifier: MIT
// Formula: of a cubic over [a, b], the inner control points p_1 = C(a) + h/3 C'(a) and p_2 = C(b) - h/3 C'(b) are at
//   distances d_1, d_2 from the chord, a segment. No point of the piece is farther than e = max d M(r), where r is the
//   smaller distance over the larger one, below 0 where both feet are inside and the points on different sides. Equal
//   steps, half of Wang's count and at least 6, are measured; sqrt(e/E) is the number of chords that a step takes,
//   since e grows with the square of a small step. The sum, less 0.3 where it is small, is rounded up to the number of
//   chords, and each gets an equal share. Up to 7, this number and the next one are tried at once. If a chord is too
//   far, the shares are measured again on these chords, once for each number, and then there is one chord more. Of 20
//   and more chords, one in 20 may be halved instead; so are all that are still too far after 8 rounds. Where a step
//   turns back and Wang's count is above 6, both sides of the least speed are flattened, and their chords at the turn
//   become one if it is near enough.
// Source: the inner control points are those of [Farin 2002], cubic Hermite interpolation; the rest is derived here.
//   The distance from a segment is convex, so that the point at t is at most 3 t (1-t) ((1-t) d_1 + t d_2) away. Its
//   largest absolute value over t, M(r) for d_1 = 1 and d_2 = r, is a largest absolute value of affine functions of r,
//   therefore convex, and the chords between its points M(-1) = sqrt(3)/6, M(0) = 4/9, M(1/2) = 1/sqrt(3) and
//   M(1) = 3/4 are above it. The code takes the largest of these three, rounded up.
// Cost: for each chord and round, mostly 2 rounds; 2 square roots and a division are among the flops.
// Bound: the tolerance, where it is above 2^-44 of the largest coordinate and 2^-1040. Chords are measured against
//   E (1 - 2^-20) - 2^-45 max|b|: the power form that is evaluated, and what is made of it, are off by less than
//   2^-46 max|b|, by fewer than 60 roundings of numbers below 12 max|b|. Reversed curves have the same points: of both
//   directions, the one whose control points come first in lexicographic order is flattened.
// Fails: for degrees above 3.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/flatten/flattening.hpp"
#include "core/vector/vectors.hpp"

namespace bezierbench {

namespace equal_errors {

/// By value, which compilers turn into vector instructions.
constexpr double smaller(double a, double b) { return b < a ? b : a; }
constexpr double larger(double a, double b) { return a < b ? b : a; }

constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
constexpr std::size_t whole_groups(std::size_t count) { return (count + 3) & ~std::size_t{3}; }

/// At least `more` M(`less` / `more`): e, where the inner control points are at the distances `more` and |`less`| from
/// the chord, |less| <= more; `less` is below 0 where both feet are inside and the points on different sides.
constexpr double largest_distance(double more, double less) {
  return larger(larger(0.44444445 * more + 0.155769 * less, 0.44444445 * more + 0.265812 * less),
                0.404701 * more + 0.3453 * less);
}

/// Up to this number of chords, a number and the next one are tried at once.
inline constexpr int most_tried_at_once = 7;

/// 0, 1/n, ..., 1, 0, 1/(n+1), ..., 1.
using Parts = std::array<double, whole_groups(2 * most_tried_at_once + 3)>;
inline constexpr auto parts_of_two = [] {
  std::array<Parts, most_tried_at_once + 1> all{};
  for (int n = 1; n <= most_tried_at_once; ++n) {
    for (int i = 0; i <= n; ++i) all[at(n)][at(i)] = 1.0 * i / n;
    for (int i = 0; i <= n + 1; ++i) all[at(n)][at(n + 1 + i)] = 1.0 * i / (n + 1);
  }
  return all;
}();

}  // namespace equal_errors

struct EqualErrors {
  static constexpr bool keeps_tolerance = true;
  static constexpr bool reverses = true;
  static constexpr MethodInfo info{.id = "equal_errors",
                                   .label = "Equal errors by measured chords",
                                   .problem = Problem::flattening,
                                   .min_degree = 1,
                                   .max_degree = 3,
                                   .promise = "the tolerance, and the same points for the reversed curve",
                                   .flops = "40d",
                                   .citation = "[Farin 2002], cubic Hermite interpolation; bound derived here"};

  template <int Dimension, int Degree>
  static void flatten(const Curve<Form::bernstein, double, Dimension, Degree>& curve, double tolerance,
                      Flattening& chords) {
    const int n = curve.degree();
    const double order = order_of_ends(curve);
    Run<Dimension> run(curve, order > 0, tolerance, chords);
    run.add_end(0);
    int parts = 1;
    int steps = 6;
    if (!run.takes_at_most(16)) {
      const double wanted = run.half_wang_count();
      parts = static_cast<int>(std::min(wanted / (most_steps / 2) + 1, 1024.0));
      steps = static_cast<int>(std::clamp(std::ceil(wanted / parts), 6.0, most_steps / 2.0));
    }
    const double whole = order == 0 && n > 1 ? 0.5 : 1;  // a curve that is its own reverse returns on its first half
    for (int k = 0; k < parts; ++k) run.flatten_part(whole * k / parts, whole * (k + 1) / parts, steps, 0);
    if (whole < 1)
      append_mirrored(chords, Dimension);
    else if (order > 0)
      reverse(chords, Dimension);
  }

 private:
  static constexpr int most_steps = 256;
  static constexpr int deepest = 40;

  /// Below 0 where the control points come before the reversed ones in lexicographic order, above 0 where after them.
  template <int Dimension, int Degree>
  static double order_of_ends(const Curve<Form::bernstein, double, Dimension, Degree>& curve) {
    const int n = curve.degree();
    for (int i = 0; 2 * i < n; ++i)
      for (int axis = 0; axis < Dimension; ++axis)
        if (curve(axis, i) != curve(axis, n - i)) return curve(axis, i) - curve(axis, n - i);
    return 0;
  }

  static void append_mirrored(Flattening& chords, int dimension) {
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t k = chords.t.size() - 1; k > 0; --k) {
      chords.t.push_back(1 - chords.t[k - 1]);
      for (std::size_t axis = 0; axis < d; ++axis) chords.points.push_back(chords.points[(k - 1) * d + axis]);
    }
  }

  static void reverse(Flattening& chords, int dimension) {
    std::ranges::reverse(chords.t);
    for (double& t : chords.t) t = 1 - t;
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t low = 0, high = chords.points.size() - d; low < high; low += d, high -= d)
      std::swap_ranges(&chords.points[low], &chords.points[low] + d, &chords.points[high]);
  }

  static constexpr std::size_t at(int k) { return equal_errors::at(k); }
  static constexpr double smaller(double a, double b) { return equal_errors::smaller(a, b); }
  static constexpr double larger(double a, double b) { return equal_errors::larger(a, b); }
  static constexpr std::size_t whole_groups(std::size_t count) { return equal_errors::whole_groups(count); }
  static constexpr int most_tried_at_once = equal_errors::most_tried_at_once;
  static constexpr std::size_t room = most_steps + 8;
  using Row = std::array<double, room>;

  /// Steps from each t to the next, in rows, so that loops over them are vector code.
  struct Steps {
    Row t;
    Row square;  ///< of e over the limit; where a foot may be outside, minus the square for the chord's line
    Row share;   ///< chords that the step takes
  };
  /// Steps from `begin` on that lead from end to end.
  struct Division {
    Steps* steps = nullptr;
    std::size_t begin = 0;
    int count = 0;
    double largest = 0;  ///< square
    double total = 0;    ///< of shares
    int turning = -1;    ///< the last step over which the direction turns by more than 90 degrees, with a foot outside
  };

  template <int Dimension>
  struct Run {
    using P = Point<double, Dimension>;
    static constexpr std::size_t axes = Dimension;

    template <int Degree>
    Run(const Curve<Form::bernstein, double, Dimension, Degree>& curve, bool reversed, double tolerance,
        Flattening& result)
        : chords(result) {
      const int n = curve.degree();
      std::array<P, 4> b;
      double largest = 0;
      for (int i = 0; i < 4; ++i) {
        const int k = std::min(i, n);
        b[at(i)] = control_point(curve, reversed ? n - k : k);
        for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(b[at(i)][axis]));
      }
      unit = 1;
      double scale = 1;
      if (!(largest >= 0x1p-20 && largest <= 0x1p+20)) {
        const double power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(largest) & 0x7FF0000000000000U);
        unit = std::clamp(power, 0x1p-1021, 0x1p+1021);
        scale = 1 / unit;
        for (auto& point : b) point *= scale;
      }
      last = b[3];
      limit = scale * tolerance * (1 - 0x1p-20) - 0x1p-45 * scale * largest;
      if (!(limit >= 0.5 * scale * tolerance) || tolerance < 0x1p-1040) {
        chords.complete = false;
        limit = std::max(0.5 * scale * tolerance, 0x1p-44 * scale * largest);
      }
      const P zero = P::Zero();
      if (n == 3)
        powers = {b[0], 3 * (b[1] - b[0]), 3 * ((b[2] - b[1]) - (b[1] - b[0])), (b[3] - b[0]) - 3 * (b[2] - b[1])};
      else if (n == 2)
        powers = {b[0], 2 * (b[1] - b[0]), (b[2] - b[1]) - (b[1] - b[0]), zero};
      else
        powers = {b[0], b[1] - b[0], zero, zero};
      second = std::max((2 * powers[2]).squaredNorm(), (2 * powers[2] + 6 * powers[3]).squaredNorm());
    }

    /// Half of Wang's count; C'' is largest at an end.
    double half_wang_count() const { return 0.5 * std::sqrt(0.125 * std::sqrt(second) / limit); }
    /// Whether Wang's count is at most `count`, without waiting for square roots.
    bool takes_at_most(double count) const { return second <= squared(8 * count * count * limit); }
    static double squared(double x) { return x * x; }

    P point_at(double t) const {
      if (t == 1) return last;
      return powers[0] + t * (powers[1] + t * (powers[2] + t * powers[3]));
    }
    P derivative_at(double t) const { return powers[1] + t * (2 * powers[2] + 3 * t * powers[3]); }

    /// The steps between the first `size` t.
    void measure(Steps& steps, std::size_t size) const {
      const std::size_t padded = whole_groups(size - 1);
      if constexpr (Dimension == 2) {
        const double squared_limit = limit * limit;
        const auto p = powers;
        for (std::size_t k = 0; k < padded; ++k) {
          const double from = steps.t[k];
          const double to = steps.t[k + 1];
          const double third = (to - from) * (1.0 / 3);
          const auto coordinate = [&](int axis, double t) {
            return p[0][axis] + t * (p[1][axis] + t * (p[2][axis] + t * p[3][axis]));
          };
          const auto derivative = [&](int axis, double t) {
            return p[1][axis] + t * (2 * p[2][axis] + 3 * t * p[3][axis]);
          };
          const double cx = coordinate(0, to) - coordinate(0, from);
          const double cy = coordinate(1, to) - coordinate(1, from);
          const double ox = third * derivative(0, from);
          const double oy = third * derivative(1, from);
          const double px = cx - third * derivative(0, to);
          const double py = cy - third * derivative(1, to);
          const double squared_length = cx * cx + cy * cy;
          const double along_one = ox * cx + oy * cy;
          const double along_other = px * cx + py * cy;
          const double d1 = cx * oy - cy * ox;
          const double d2 = cx * py - cy * px;
          const double more = larger(std::abs(d1), std::abs(d2));
          const double less = smaller(std::abs(d1), std::abs(d2));
          const double same_side = d1 * d2 < 0 ? -1 : 1;
          const double e = equal_errors::largest_distance(more, same_side * less);
          // 2^-1000 is far below all products that count, and keeps 0/0 and a zero without sign away.
          const double square = e * e / (squared_length * squared_limit + 0x1p-1000) + 0x1p-1000;
          const double inside = smaller(smaller(along_one, squared_length - along_one),
                                        smaller(along_other, squared_length - along_other));
          const double sign = smaller(inside, squared_length - 0x1p-800) >= 0 ? 1 : -1;
          steps.square[k] = sign * square;
          steps.share[k] = larger(std::sqrt(std::sqrt(square)), 0x1p-30);
        }
      } else {
        for (std::size_t k = 0; k + 1 < size; ++k) steps.square[k] = -0x1p-1000;
      }
    }

    /// The square of e over the limit, wherever the feet are.
    double measured(double from, double to) const {
      const P chord = point_at(to) - point_at(from);
      const double third = (to - from) * (1.0 / 3);
      const P one = third * derivative_at(from);
      const P other = chord - third * derivative_at(to);
      const P zero = P::Zero();
      const double s1 = squared_distance_to_segment<Dimension>(one, zero, chord);
      const double s2 = squared_distance_to_segment<Dimension>(other, zero, chord);
      const double e = equal_errors::largest_distance(std::sqrt(std::max(s1, s2)), std::sqrt(std::min(s1, s2)));
      return e * e / (limit * limit);
    }
    bool is_near(double from, double to) const { return measured(from, to) <= 1; }

    /// Decides the steps with a foot outside, unless the line refutes them, and sums up. A step that turns back takes
    /// few chords, but where it turns.
    Division summed(Steps& steps, std::size_t begin, int count) const {
      Division all{&steps, begin, count};
      for (std::size_t k = begin; k < begin + at(count); ++k) {
        if (steps.square[k] < 0) {
          if (steps.square[k] >= -1) {
            steps.square[k] = steps.t[k] < steps.t[k + 1] ? measured(steps.t[k], steps.t[k + 1]) : 0x1p+100;
            steps.share[k] = std::max(std::sqrt(std::sqrt(steps.square[k])), 0x1p-30);
          } else {
            steps.square[k] = -steps.square[k];
          }
          if (Dimension == 2) steps.share[k] = std::min(steps.share[k], 2.0);
          if (derivative_at(steps.t[k]).dot(derivative_at(steps.t[k + 1])) < 0)
            all.turning = static_cast<int>(k - begin);
        }
        all.total += steps.share[k];
        all.largest = std::max(all.largest, steps.square[k]);
      }
      return all;
    }

    /// The t at these parts of the shares' total, in fours.
    static void place(const Division& old, const double* parts, std::size_t size, Steps& to) {
      using Four = VectorOf<double, 4>;
      const double* const t = &old.steps->t[old.begin];
      const double* const share = &old.steps->share[old.begin];
      const std::size_t n = at(old.count);
      Row pace;
      for (std::size_t k = 0; k < whole_groups(n); ++k) pace[k] = (t[k + 1] - t[k]) / share[k];
      for (std::size_t i = 0; i < size; i += 4) {
        Four left;
        std::memcpy(&left, &parts[i], sizeof left);
        const auto is_end = left == 1;
        left *= old.total;
        Four sum = Four{} + t[0];
        for (std::size_t k = 0; k < n; ++k) {
          const Four most = Four{} + share[k];
          const Four least = Four{};
          Four taken = left < most ? left : most;
          taken = taken < least ? least : taken;
          sum += pace[k] * taken;
          left -= share[k];
        }
        const Four end = Four{} + t[n];
        sum = is_end ? end : sum;
        sum = end < sum ? end : sum;
        std::memcpy(&to.t[i], &sum, sizeof sum);
      }
    }

    /// The t that divide the shares into `count` equal ones, for many steps; `start` finds the step without a search.
    static void divide(const Division& old, int count, Steps& to) {
      const double* const t = &old.steps->t[old.begin];
      const double* const share = &old.steps->share[old.begin];
      const int n = old.count;
      Row pace;
      std::array<int, room> start;
      Row before;
      double sum = 0;
      for (std::size_t k = 0; k < whole_groups(at(n)); ++k) pace[k] = (t[k + 1] - t[k]) / share[k];
      for (int i = 0; i <= count + 1; ++i) start[at(i)] = 0;
      const double inverse = count / old.total;
      for (int k = 0; k < n; ++k) {
        before[at(k)] = sum;
        start[at(static_cast<int>(sum * inverse)) + 1] = k;
        sum += share[at(k)];
      }
      const double each = old.total / count;
      to.t[0] = t[0];
      for (std::size_t i = at(count); i <= whole_groups(at(count)); ++i) to.t[i] = t[n];
      for (int i = 1, k = 0; i < count; ++i) {
        k = std::max(k, start[at(i)]);
        to.t[at(i)] = smaller(t[k] + pace[at(k)] * larger(i * each - before[at(k)], 0), t[k + 1]);
      }
    }

    void write(const Division& division) { write(&division.steps->t[division.begin], at(division.count)); }
    void write(const double* t, std::size_t count) {
      const std::size_t base = chords.t.size() - 1;
      chords.t.resize(base + count + 1);
      chords.points.resize((base + count + 1) * axes);
      double* const parameters = &chords.t[base];
      double* const points = &chords.points[base * axes];
      const auto p = powers;
      const double scale = unit;
      for (std::size_t k = 1; k <= count; ++k) {
        parameters[k] = t[k];
        for (std::size_t axis = 0; axis < axes; ++axis) {
          const int i = static_cast<int>(axis);
          points[k * axes + axis] = scale * (p[0][i] + t[k] * (p[1][i] + t[k] * (p[2][i] + t[k] * p[3][i])));
        }
      }
      if (t[count] == 1)
        for (std::size_t axis = 0; axis < axes; ++axis)
          points[count * axes + axis] = scale * last[static_cast<int>(axis)];
    }
    void add_end(double t) { chords.add(t, P(unit * point_at(t))); }

    /// About the t at which the speed is least; an end of the step, if the speed does not first fall and then rise.
    double turn_in(double from, double to) const {
      const auto falls = [&](double t) { return derivative_at(t).dot(P(2 * powers[2] + 6 * t * powers[3])) < 0; };
      if (!falls(from)) return from;
      for (int k = 0; k < 7; ++k) {
        const double middle = 0.5 * (from + to);
        (falls(middle) ? from : to) = middle;
      }
      return from;
    }

    /// Appends the chords of the piece over [from, to].
    void flatten_part(double from, double to, int steps, int depth) {
      Steps* now = &workspace[0];
      Steps* next = &workspace[1];
      const double step = (to - from) / steps;
      for (int k = 0; k < steps + 8; ++k) now->t[at(k)] = from + step * k;
      now->t[at(steps)] = to;
      now->t[at(steps) + 1] = from;
      now->t[at(steps) + 2] = to;
      chords.evaluations += steps;
      measure(*now, at(steps) + 3);
      const double whole = now->square[at(steps) + 1];
      if (whole >= 0 ? whole <= 1 : whole > -1 && is_near(from, to)) return add_end(to);
      Division old = summed(*now, 0, steps);
      if (old.turning >= 0 && depth < most_turns && !takes_at_most(6)) {
        const double turn = turn_in(now->t[at(old.turning)], now->t[at(old.turning) + 1]);
        if (from < turn && turn < to) return flatten_sides(from, turn, to, steps, depth);
      }
      double wanted = old.total > 12 ? old.total * 1.01 : old.total - 0.3;
      int count = 0;
      bool again = false;
      Division accepted;
      for (int round = 0; round < most_rounds && wanted <= most_steps; ++round) {
        count = std::max({static_cast<int>(std::ceil(wanted)), count, 2});
        const bool both = count <= most_tried_at_once && !accepted.steps;
        const std::size_t size = at(both ? 2 * count + 3 : count + 1);
        if (count <= most_tried_at_once)
          place(old, equal_errors::parts_of_two[at(count)].data(), size, *next);
        else
          divide(old, count, *next);
        chords.evaluations += static_cast<int>(size) - 2;
        measure(*next, size);
        const Division fewer = summed(*next, 0, count);
        if (fewer.largest <= 1) return write(fewer);
        if (count >= 20 && far_chords(fewer) * 20 <= count) return write_halved(fewer);
        Division more;
        if (both) {
          more = summed(*next, at(count) + 1, count + 1);
          if (more.largest <= 1) accepted = more;
        }
        if (!again && fewer.total <= 1.2 * count) {
          if (accepted.steps) {
            for (int i = 0; i <= count + 1; ++i) saved.t[at(i)] = next->t[at(count + 1 + i)];
            accepted = {&saved, 0, count + 1};
          }
          old = fewer;
          again = true;
          wanted = count;
        } else {
          if (accepted.steps) return write(accepted);
          again = both && more.total <= count + 1;
          old = both ? more : fewer;
          wanted = std::max<double>(both && !again ? count + 2 : count + 1, old.total - 0.3);
        }
        std::swap(now, next);
      }
      if (accepted.steps) return write(accepted);
      write_halved(old);
    }

    /// Both sides of a turn, and the chords that meet there as one, if it is near enough.
    void flatten_sides(double from, double turn, double to, int steps, int depth) {
      const double before = std::ceil(steps * (turn - from) / (to - from));
      flatten_part(from, turn, std::max(static_cast<int>(before), 4), depth + 1);
      const std::size_t joint = chords.t.size() - 1;
      flatten_part(turn, to, std::max(steps - static_cast<int>(before), 4), depth + 1);
      if (!is_near(chords.t[joint - 1], chords.t[joint + 1])) return;
      chords.t.erase(chords.t.begin() + static_cast<std::ptrdiff_t>(joint));
      const auto point = chords.points.begin() + static_cast<std::ptrdiff_t>(joint * axes);
      chords.points.erase(point, point + Dimension);
    }

    static int far_chords(const Division& division) {
      int count = 0;
      for (std::size_t k = division.begin; k < division.begin + at(division.count); ++k)
        count += division.steps->square[k] > 1 ? 1 : 0;
      return count;
    }

    void write_halved(const Division& division) {
      const double* const t = &division.steps->t[division.begin];
      const double* const square = &division.steps->square[division.begin];
      std::size_t done = 0;
      for (std::size_t k = 0; k < at(division.count); ++k) {
        if (square[k] <= 1) continue;
        if (k > done) write(t + done, k - done);
        add_halved(t[k], t[k + 1], is_near(t[k], t[k + 1]), 0);
        done = k + 1;
      }
      if (at(division.count) > done) write(t + done, at(division.count) - done);
    }

    /// Adds the chord, or halves that are near enough.
    void add_halved(double from, double to, bool near, int depth) {
      const double middle = 0.5 * (from + to);
      if (near || depth == deepest || static_cast<int>(chords.t.size()) >= max_chords ||
          !(from < middle && middle < to)) {
        chords.complete = chords.complete && near;
        if (to > chords.t.back()) add_end(to);
        return;
      }
      ++chords.evaluations;
      add_halved(from, middle, is_near(from, middle), depth + 1);
      add_halved(middle, to, is_near(middle, to), depth + 1);
    }

    static constexpr int most_rounds = 8;
    static constexpr int most_turns = 2;  ///< the squared speed of a cubic has at most two minima

    Flattening& chords;
    P last;
    std::array<P, 4> powers;
    double unit;    ///< what the curve is measured in: a power of two
    double limit;   ///< of measured errors
    double second;  ///< the square of the largest |C''|
    std::array<Steps, 2> workspace;
    Steps saved;
  };
};

}  // namespace bezierbench
