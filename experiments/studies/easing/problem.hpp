// SPDX-License-Identifier: MIT
// An easing curve at a random x, at its neighbours and at k/64: each method in double and in float. A cubic that is not
// an easing curve, as drawn ones, gives its two inner points: x1 and x2 are their |x| / R, y1 and y2 their y. An answer
// is right if y at the random x is as accurate as users expect.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/easing/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/companion/easing.hpp"

namespace bezierbench::studies {

/// Of the range of y, as results/audit asks of other libraries. Browsers stop at |x(t) - x| < 1e-7.
inline constexpr double expected_accuracy = 1e-6;

/// The errors of one method in one scalar type.
struct EasedErrors {
  metric::Tally error;               ///< |y - true y| at the judged x
  metric::Tally error_ulp;           ///< the same in ulp of the true y
  std::uint64_t misrounded = 0;      ///< judged x
  metric::TrialCount non_monotone;   ///< trials, of curves that do not fall, in which y falls between two x in order
  metric::TrialCount wrong_ends;     ///< trials in which y(0) is not 0 or y(1) is not 1
  metric::TrialCount wrong_outside;  ///< trials in which y outside [0, 1] is not on the line, up to its roundings
  metric::Total steps;               ///< of each trial, the most of an x
  std::uint64_t not_converged = 0;   ///< trials with a loop that was ended
  std::uint64_t non_finite = 0;      ///< trials with a number that is not finite
  metric::TrialCount broken;         ///< trials with a promise broken

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_ulp, self.misrounded, self.non_monotone, self.wrong_ends, self.wrong_outside,
                 self.steps, self.not_converged, self.non_finite, self.broken);
  }
};

struct EasingErrors {
  EasedErrors in_double;
  EasedErrors in_float;
  std::uint64_t monotone_trials = 0;  ///< those of curves that do not fall: y1 and y2 in [0, 1]

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.in_double, self.in_float, self.monotone_trials);
  }
};

/// The x of a trial, ascending in two sequences, and the truth at two of them.
template <class Scalar>
struct EasingTrial {
  static constexpr std::size_t neighbours = 32;  ///< from the drawn x on
  static constexpr std::size_t parts = 64;       ///< then k/64 for k = 0..64
  EasingCurve<Scalar> curve{};
  std::vector<Scalar> x;
  std::size_t on_grid = 0;  ///< place of the second judged x; the first is at 0
  std::vector<reference::ExactEased> truth;
  std::array<Scalar, 2> outside;  ///< an x before 0 and one after 1
  std::vector<reference::ExactEased> truth_outside;
};

struct EasingAnswer {
  std::vector<Eased<double>> eased;
  std::vector<double> y;
};

class EasingProblem {
 public:
  static constexpr Problem problem = Problem::easing;
  static constexpr judge::CaseAxes axes{};
  static constexpr std::string_view table = "easing";
  static constexpr std::int64_t block_trials = 64;

  using Kernel = EasingKernel;
  using Answer = EasingAnswer;
  using Errors = EasingErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    EasingTrial<double> in_double;
    EasingTrial<float> in_float;
    double nearest = 0;  ///< to the true y at the drawn x
  };

  static constexpr std::size_t answers_per_call = EasingTrial<double>::neighbours + 1 + EasingTrial<double>::parts;
  static constexpr std::array<judge::CaseColumn, 0> case_columns{};
  template <auto member>
  static constexpr std::array columns_of_scalar{
      TrialColumn<Row>{"mean_error", column::statistic<tables::mean, member, &EasedErrors::error>},
      TrialColumn<Row>{"max_error", column::statistic<tables::largest, member, &EasedErrors::error>},
      TrialColumn<Row>{"mean_error_ulp", column::statistic<tables::mean, member, &EasedErrors::error_ulp>},
      TrialColumn<Row>{"p50_error_ulp", column::statistic<tables::median, member, &EasedErrors::error_ulp>},
      TrialColumn<Row>{"p99_error_ulp", column::statistic<tables::p99, member, &EasedErrors::error_ulp>},
      TrialColumn<Row>{"max_error_ulp", column::statistic<tables::largest, member, &EasedErrors::error_ulp>},
      TrialColumn<Row>{"misrounded", column::count<member, &EasedErrors::misrounded>},
      TrialColumn<Row>{"non_monotone", column::count<member, &EasedErrors::non_monotone>},
      TrialColumn<Row>{"wrong_ends", column::count<member, &EasedErrors::wrong_ends>},
      TrialColumn<Row>{"wrong_outside", column::count<member, &EasedErrors::wrong_outside>},
      TrialColumn<Row>{"max_steps", column::count<member, &EasedErrors::steps, &metric::Total::largest>},
      TrialColumn<Row>{"not_converged", column::count<member, &EasedErrors::not_converged>},
      TrialColumn<Row>{"non_finite", column::count<member, &EasedErrors::non_finite>},
  };
  /// The same in float, by other names.
  static constexpr auto float_columns = [] {
    auto all = columns_of_scalar<&Errors::in_float>;
    constexpr std::array<std::string_view, all.size()> names{
        "float_mean_error",    "float_max_error",     "float_mean_error_ulp", "float_p50_error_ulp",
        "float_p99_error_ulp", "float_max_error_ulp", "float_misrounded",     "float_non_monotone",
        "float_wrong_ends",    "float_wrong_outside", "float_max_steps",      "float_not_converged",
        "float_non_finite"};
    for (std::size_t k = 0; k < all.size(); ++k) all[k].name = names[k];
    return all;
  }();
  static constexpr auto columns = joined(
      joined(joined(std::array{TrialColumn<Row>{"monotone_trials", column::count<&Errors::monotone_trials>}},
                    columns_of_scalar<&Errors::in_double>),
             float_columns),
      std::array{TrialColumn<Row>{"broken_promises", column::count<&Errors::in_double, &EasedErrors::broken>},
                 TrialColumn<Row>{"float_broken_promises", column::count<&Errors::in_float, &EasedErrors::broken>}});
  static constexpr std::array failures{
      TrialFailure<Row>{"y", column::trials<&Errors::in_double, &EasedErrors::broken>, run::Broken::promise},
      TrialFailure<Row>{"y in float", column::trials<&Errors::in_float, &EasedErrors::broken>, run::Broken::promise}};

  static std::span<const Kernel> kernels(int /*dimension*/) { return easing_kernels(); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 32; }
  static double trial_nanoseconds(const judge::TrialPart& /*part*/, std::size_t methods) {
    return 400'000 + 40'000 * static_cast<double>(methods);
  }

  EasingProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part);

  void draw(std::uint64_t number, Drawn& drawn) const;
  static void ask(const Kernel& method, const Drawn& drawn, double tolerance, Answer& answer);
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {answer.y}; }
  static void judge(const Kernel& method, Drawn& drawn, double tolerance, const Answer& answer, std::uint64_t number,
                    Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer);

 private:
  judge::CurveSampler curves_;
  double range_;
};

}  // namespace bezierbench::studies
