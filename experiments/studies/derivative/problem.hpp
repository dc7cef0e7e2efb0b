// SPDX-License-Identifier: MIT
// The derivative of a random curve, of one order, at a random t, against the exact one. An answer is right if it keeps
// its bound or, where none is proved, half of its digits are right.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/derivative/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/metric/derivative_scale.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::studies {

struct DerivativeErrors {
  metric::Tally error;
  metric::Tally error_u;
  std::uint64_t non_finite = 0;
  std::uint64_t bounded = 0;  ///< trials for which a bound is proved
  metric::TrialCount violations;
  metric::Largest<double> bound_u;  ///< bound / (u p~)

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_u, self.non_finite, self.bounded, self.violations, self.bound_u);
  }
};

class DerivativeProblem {
 public:
  static constexpr Problem problem = Problem::derivative;
  static constexpr judge::CaseAxes axes{};
  static constexpr std::string_view table = "derivative";
  static constexpr std::int64_t block_trials = 512;

  using Kernel = DerivativeKernel;
  using Answer = std::array<double, 3>;  ///< coordinates; those beyond the dimension are not written
  using Errors = DerivativeErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    reference::ExactCurve exact;
    metric::DerivativeScale scale;
    std::optional<reference::Distance> distance;  ///< distance from the exact derivative
  };

  static constexpr std::array case_columns{judge::case_column::order};
  static constexpr auto columns =
      joined(error_columns<Row>, std::array{
                                     TrialColumn<Row>{"bound_u", column::where_bounded<&Errors::bound_u>},
                                     TrialColumn<Row>{"bound_violations", column::where_bounded<&Errors::violations>},
                                     TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
                                 });
  static constexpr std::array failures{TrialFailure<Row>{"", column::trials<&Errors::violations>}};

  static std::span<const Kernel> kernels(int dimension) { return derivative_kernels(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 256; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t methods) {
    const double n = part.cell.degree + 1.0;
    return 400 + n * n * (20 + 2 * static_cast<double>(methods));
  }

  DerivativeProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
      : curves_(study, seed, part.cell), order_(*part.values.order) {}

  void draw(std::uint64_t number, Drawn& drawn) const;
  void ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& answer) const {
    method.derivative(drawn.curve, order_, drawn.trial.t, answer.data());
  }
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {answer}; }
  static void judge(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer,
                    std::uint64_t number, Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer);

 private:
  judge::CurveSampler curves_;
  int order_;
};

}  // namespace bezierbench::studies
