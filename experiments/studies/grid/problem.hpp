// SPDX-License-Identifier: MIT
// The points of a random curve at k/m, k = 0..m, against the exact ones. An answer is right if every point keeps its
// bound.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/exact_curve.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::studies {

struct GridErrors {
  metric::Tally error;              ///< of all points
  metric::Tally error_u;            ///< over u p~ at the point
  metric::Tally last_error_u;       ///< at t = 1
  metric::Largest<double> bound_u;  ///< bound / (u p~) of a point
  metric::TrialCount violations;    ///< trials with a point beyond its bound
  std::uint64_t bounded = 0;        ///< points for which a bound is proved
  std::uint64_t non_finite = 0;     ///< trials with a number that is not finite; nothing else is judged in these

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_u, self.last_error_u, self.bound_u, self.violations, self.bounded,
                 self.non_finite);
  }
};

class GridProblem {
 public:
  static constexpr Problem problem = Problem::grid;
  static constexpr judge::CaseAxes axes{};
  static constexpr std::string_view table = "grid";
  static constexpr std::int64_t block_trials = 16;

  using Kernel = GridKernel;
  using Answer = std::vector<double>;  ///< coordinates, point by point
  using Errors = GridErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    reference::ExactCurve exact;
    std::vector<reference::ExactPoint> truth;
    std::vector<reference::Distance> distances;  ///< from the points of `truth`
  };

  static constexpr std::array case_columns{judge::case_column::points};
  static constexpr auto columns =
      joined(error_columns<Row>,
             std::array{
                 TrialColumn<Row>{"mean_last_error_u", column::statistic<tables::mean, &Errors::last_error_u>},
                 TrialColumn<Row>{"max_last_error_u", column::statistic<tables::largest, &Errors::last_error_u>},
                 TrialColumn<Row>{"bound_u", column::where_bounded<&Errors::bound_u>},
                 TrialColumn<Row>{"bound_violations", column::where_bounded<&Errors::violations>},
                 TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
             });
  static constexpr std::array failures{TrialFailure<Row>{"", column::trials<&Errors::violations>}};

  static std::span<const Kernel> kernels(int dimension) { return grid_kernels(dimension); }
  /// Curves per batch: fewer on fine grids, so that every batch takes about as long.
  static std::size_t timed_trials(const judge::TrialPart& part);
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t methods) {
    const double n = part.cell.degree + 1.0;
    return *part.values.points * (1500 + 100 * n + (300 + 20 * n) * static_cast<double>(methods));
  }

  /// Throws Failure(usage) for a number of points that is not a power of two and one.
  GridProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part);

  void draw(std::uint64_t number, Drawn& drawn) const;
  void ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& answer) const {
    answer.resize(static_cast<std::size_t>(steps_ + 1) * static_cast<std::size_t>(drawn.curve.dimension));
    method.points(drawn.curve, steps_, answer.data());
  }
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {answer}; }
  static void judge(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer,
                    std::uint64_t number, Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer);

 private:
  judge::CurveSampler curves_;
  int steps_;
};

}  // namespace bezierbench::studies
