// SPDX-License-Identifier: MIT
// A random B-spline curve in one knot span, with weights or without: the point at t and the Bernstein form of the span,
// its weights too, against the exact ones.
// An answer is right if all of it keeps its bounds or, where none is proved, half of its digits are right.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bspline/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/sample/knot_kind.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::studies {

struct BsplineErrors {
  metric::Tally error;              ///< of points
  metric::Tally error_u;            ///< over u p~
  metric::Largest<double> bound_u;  ///< bound / (u p~) of a point
  metric::Tally control_error_u;    ///< of all control points and weights of the Bernstein form, over u p~ of each
  metric::Largest<double> control_bound_u;  ///< bound / (u p~) of one of them
  std::uint64_t bounded = 0;                ///< trials for which bounds are proved
  metric::TrialCount violations;            ///< trials with a point or control point beyond its bound
  std::uint64_t non_finite = 0;  ///< trials with a number that is not finite; nothing else is judged in these

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_u, self.bound_u, self.control_error_u, self.control_bound_u, self.bounded,
                 self.violations, self.non_finite);
  }
};

class BsplineProblem {
 public:
  static constexpr Problem problem = Problem::bspline;
  static constexpr judge::CaseAxes axes{.knots = true};
  static constexpr std::string_view table = "bspline";
  static constexpr std::int64_t block_trials = 32;

  using Kernel = BsplineKernel;
  using Answer = std::vector<double>;  ///< what BsplineKernel::solve writes
  using Errors = BsplineErrors;
  using Row = TrialRow<Kernel, Errors>;
  /// Stays where it was drawn: the span refers to the rest.
  struct Drawn {
    sample::Trial trial;
    std::vector<double> knots;
    BsplineSpanView span;
    double t = 0;
    /// Of the point, then of the control points of the Bernstein form and of its weights, which have one coordinate.
    std::vector<reference::ExactPoint> truth;
    std::vector<reference::Distance> distances;  ///< from the points of `truth`
    std::vector<double> p_tilde;
    double largest = 0;  ///< max |d_i|
    std::vector<metric::BsplineWeightSizes>
        weight_sizes{};  ///< of the point and the control points of a rational curve

    Drawn() = default;
    Drawn(const Drawn&) = delete;
    Drawn& operator=(const Drawn&) = delete;
  };

  static constexpr std::array case_columns{judge::case_column::knots};
  static constexpr auto
      columns =
          joined(
              error_columns<Row>,
              std::array{
                  TrialColumn<Row>{"bound_u", column::where_bounded<&Errors::bound_u>},
                  TrialColumn<Row>{"mean_control_error_u", column::statistic<tables::mean, &Errors::control_error_u>},
                  TrialColumn<Row>{"max_control_error_u", column::statistic<tables::largest, &Errors::control_error_u>},
                  TrialColumn<Row>{
                      "control_bound_u",
                      [](const Row& row) {
                        const bool proved = row.errors.bounded > 0 && row.method.makes_bernstein;
                        return proved ? tables::field(row.errors.control_bound_u) : tables::Field();
                      }},
                  TrialColumn<Row>{"bound_violations", column::where_bounded<&Errors::violations>},
                  TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
              });
  static constexpr std::array failures{TrialFailure<Row>{"", column::trials<&Errors::violations>}};

  static std::span<const Kernel> kernels(int dimension) { return bspline_kernels(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 64; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t methods) {
    const double n = part.cell.degree + 1.0;
    return n * n * (1000 * n + 80 * n * n * n + 200 * static_cast<double>(methods));  // fractions grow with n
  }

  BsplineProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part);

  void draw(std::uint64_t number, Drawn& drawn) const;
  static void ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& answer) {
    answer.resize(static_cast<std::size_t>(numbers_solved(method, drawn.span)));
    method.solve(drawn.span, drawn.t, answer.data());
  }
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {answer}; }
  static void judge(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer,
                    std::uint64_t number, Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer);

 private:
  sample::Cell cell_;
  sample::Sampler sampler_;
  const sample::KnotKind& knots_;
  std::uint64_t seed_;
  std::uint64_t knots_key_;  ///< in place of the study's, so that knots have random words of their own
};

}  // namespace bezierbench::studies
