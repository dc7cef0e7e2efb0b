// SPDX-License-Identifier: MIT
// Random points joined by a C2 natural spline: its inner control points against the exact ones, and the residuals of
// the conditions that it must meet. An answer is right if every residual is within the bound or, where none is proved,
// half of the digits are right.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/interpolate/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/companion/interpolation.hpp"

namespace bezierbench::studies {

// Judges one spline through drawn points against the truth, axis by axis.

/// The largest errors of each trial over knots and axes. All but `error` are in u times the largest coordinate of the
/// axis.
struct SplineErrors {
  metric::Tally error;              ///< of the inner control points, in coordinate units
  metric::Tally error_u;            ///< the same in u times the largest coordinate
  metric::Tally data;               ///< residuals: |P0,i - K_i| and |P3,i - K_(i+1)|
  metric::Tally c0;                 ///< gaps between segments
  metric::Tally c1;                 ///< jumps of first differences
  metric::Tally c2;                 ///< jumps of second differences
  metric::Tally natural;            ///< second differences at the ends
  metric::Largest<double> bound_u;  ///< the proved bound with its underflow term; 0 if there is none
  std::uint64_t non_finite = 0;
  metric::TrialCount violations;  ///< trials with a residual above its proved bound

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_u, self.data, self.c0, self.c1, self.c2, self.natural, self.bound_u,
                 self.non_finite, self.violations);
  }
};

/// The points of one trial and, unless there are too many of them, the exact spline through them.
class SplineJudge {
 public:
  SplineJudge(std::span<const double> points, int dimension, bool with_exact);

  /// Adds the errors of `segments`, 4 control points each, point by point. `bound` is the bound of the residuals in u
  /// times the largest coordinate of an axis; 0 if there is none.
  void judge(std::span<const double> segments, double bound, std::uint64_t trial, SplineErrors& errors) const;

  /// Whether all numbers are finite and all residuals within `bound`.
  [[nodiscard]] bool meets(std::span<const double> segments, double bound) const;

 private:
  struct Axis {
    std::vector<double> coordinates;
    reference::Rational unit;  ///< u times the largest coordinate
    std::optional<reference::ExactSpline> exact;
  };
  std::vector<Axis> axes_;
};

/// The largest number of points for which the exact spline is computed: its size grows with the square of this number.
/// The conditions are checked exactly for any number of points.
inline constexpr int max_exact_spline_points = 1025;

class InterpolationProblem {
 public:
  static constexpr Problem problem = Problem::interpolation;
  static constexpr judge::CaseAxes axes{.degree = false};
  static constexpr std::string_view table = "interpolation";
  static constexpr std::int64_t block_trials = 32;

  using Kernel = InterpolationKernel;
  using Answer = std::vector<double>;  ///< control points
  using Errors = SplineErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn {
    sample::Trial points;
    std::optional<SplineJudge> judge;
  };

  static constexpr std::array case_columns{judge::case_column::points};
  static constexpr std::array columns{
      TrialColumn<Row>{"mean_error", column::statistic<tables::mean, &Errors::error>},
      TrialColumn<Row>{"p50_error", column::statistic<tables::median, &Errors::error>},
      TrialColumn<Row>{"p99_error", column::statistic<tables::p99, &Errors::error>},
      TrialColumn<Row>{"max_error", column::statistic<tables::largest, &Errors::error>},
      TrialColumn<Row>{"mean_error_u", column::statistic<tables::mean, &Errors::error_u>},
      TrialColumn<Row>{"max_error_u", column::statistic<tables::largest, &Errors::error_u>},
      TrialColumn<Row>{"max_data_u", column::statistic<tables::largest, &Errors::data>},
      TrialColumn<Row>{"max_c0_u", column::statistic<tables::largest, &Errors::c0>},
      TrialColumn<Row>{"mean_c1_u", column::statistic<tables::mean, &Errors::c1>},
      TrialColumn<Row>{"max_c1_u", column::statistic<tables::largest, &Errors::c1>},
      TrialColumn<Row>{"mean_c2_u", column::statistic<tables::mean, &Errors::c2>},
      TrialColumn<Row>{"p99_c2_u", column::statistic<tables::p99, &Errors::c2>},
      TrialColumn<Row>{"max_c2_u", column::statistic<tables::largest, &Errors::c2>},
      TrialColumn<Row>{"mean_natural_u", column::statistic<tables::mean, &Errors::natural>},
      TrialColumn<Row>{"max_natural_u", column::statistic<tables::largest, &Errors::natural>},
      TrialColumn<Row>{"bound_u",
                       [](const Row& row) {
                         const double bound = row.errors.bound_u.value;
                         return bound > 0 ? tables::Field(bound) : tables::Field();
                       }},
      TrialColumn<Row>{"bound_violations",
                       [](const Row& row) {
                         return row.method.residual_bound > 0 ? tables::field(row.errors.violations) : tables::Field();
                       }},
      TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
  };
  static constexpr std::array failures{TrialFailure<Row>{"", column::trials<&Errors::violations>}};

  static std::span<const Kernel> kernels(int /*dimension*/) { return interpolation_kernels(); }
  /// Sets per batch: fewer where they have many points, so that every batch takes about as long.
  static std::size_t timed_trials(const judge::TrialPart& part) {
    return static_cast<std::size_t>(std::clamp(4096 / *part.values.points, 1, 64));
  }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t /*methods*/) {
    const double k = *part.values.points;
    const double per_point = 1500 + (*part.values.points <= max_exact_spline_points ? 1500 + 2 * k : 0);
    return k * part.cell.dimension * per_point;
  }

  InterpolationProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
      : dimension_(part.cell.dimension),
        with_exact_(*part.values.points <= max_exact_spline_points),
        sampler_(seed, study.id, as_one_curve(part)) {}

  void draw(std::uint64_t number, Drawn& drawn) const {
    sampler_.draw(number, drawn.points);
    drawn.judge.emplace(drawn.points.coefficients, dimension_, with_exact_);
  }
  void ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& answer) const {
    answer = method.interpolate(drawn.points.coefficients, dimension_);
  }
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {answer}; }
  static void judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer,
                    std::uint64_t number, Errors& errors) {
    drawn.judge->judge(answer, method.residual_bound, number, errors);
  }
  static bool is_right(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer) {
    return drawn.judge->meets(answer, method.residual_bound > 0 ? method.residual_bound : judge::half_of_the_digits);
  }

 private:
  /// A cell whose curve has the points as its control points; this is how they are drawn.
  static sample::Cell as_one_curve(const judge::TrialPart& part) {
    sample::Cell cell = part.cell;
    cell.degree = *part.values.points - 1;
    return cell;
  }

  int dimension_;
  bool with_exact_;
  sample::Sampler sampler_;
};

}  // namespace bezierbench::studies
