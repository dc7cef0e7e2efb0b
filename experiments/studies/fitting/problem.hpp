// SPDX-License-Identifier: MIT
// Data of one kind fitted to a tolerance, judged from both sides: the largest exact distance of a data point from the
// fitted curve, and the departure of the curve from the polyline of the data. An answer is right if the former is within
// the tolerance, the latter within what tolerance and sampling allow (reference/companion/polyline_departure.hpp), and no
// handle longer than three times the polyline beside it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fit/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/sample/data_kind.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/companion/polyline_departure.hpp"

namespace bezierbench::studies {

/// Errors are the largest distance of a data point from the fitted curve.
struct FitErrors {
  metric::Tally error;    ///< true distance, in coordinate units
  metric::Tally claimed;  ///< distance that the method returns, in coordinate units
  std::uint64_t non_finite = 0;
  std::uint64_t non_converged = 0;
  metric::TrialCount broken;      ///< the method reports convergence, but the answer is not right
  std::uint64_t understated = 0;  ///< trials with a true distance larger than the claimed one
  metric::Total segments;
  std::uint64_t one_segment = 0;  ///< trials with a fit of one segment
  metric::Total iterations;
  metric::Largest<double> departure;             ///< of the curve from the polyline of the data, in coordinate units
  metric::Largest<double> departure_over_limit;  ///< above 1 where it is certainly more than allowed
  metric::Largest<double> handle_over_chords;    ///< longest handle / length of the polyline beside its segment
  std::uint64_t out_of_order = 0;                ///< data points whose place is before that of the point before

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.claimed, self.non_finite, self.non_converged, self.broken, self.understated,
                 self.segments, self.one_segment, self.iterations, self.departure, self.departure_over_limit,
                 self.handle_over_chords, self.out_of_order);
  }
};

class FittingProblem {
 public:
  static constexpr Problem problem = Problem::fitting;
  static constexpr judge::CaseAxes axes{.tolerance = true, .data = true};
  static constexpr std::string_view table = "fitting";
  static constexpr std::int64_t block_trials = 50;

  using Kernel = FittingKernel;
  using Answer = Fit;
  using Errors = FitErrors;
  using Row = TrialRow<Kernel, Errors>;
  using Drawn = std::vector<double>;  ///< data points

  static constexpr std::array case_columns{judge::case_column::data, judge::case_column::points,
                                           judge::case_column::tolerance};
  static constexpr std::array columns{
      TrialColumn<Row>{"mean_segments", column::per_trial<&Errors::segments, &metric::Total::sum>},
      TrialColumn<Row>{"max_segments", column::count<&Errors::segments, &metric::Total::largest>},
      TrialColumn<Row>{"one_segment", column::count<&Errors::one_segment>},
      TrialColumn<Row>{"mean_error", column::statistic<tables::mean, &Errors::error>},
      TrialColumn<Row>{"p50_error", column::statistic<tables::median, &Errors::error>},
      TrialColumn<Row>{"max_error", column::statistic<tables::largest, &Errors::error>},
      TrialColumn<Row>{"max_error_over_tolerance",
                       [](const Row& row) {
                         const metric::Tally& error = row.errors.error;
                         return error.count() > 0 ? tables::Field(error.max() / *row.values.tolerance)
                                                  : tables::Field();
                       }},
      TrialColumn<Row>{"mean_claimed", column::statistic<tables::mean, &Errors::claimed>},
      TrialColumn<Row>{"max_claimed", column::statistic<tables::largest, &Errors::claimed>},
      TrialColumn<Row>{"mean_iterations", column::per_trial<&Errors::iterations, &metric::Total::sum>},
      TrialColumn<Row>{"max_iterations", column::count<&Errors::iterations, &metric::Total::largest>},
      TrialColumn<Row>{"non_converged", column::count<&Errors::non_converged>},
      TrialColumn<Row>{"broken_promises", column::count<&Errors::broken>},
      TrialColumn<Row>{"understated", column::count<&Errors::understated>},
      TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
      TrialColumn<Row>{"max_departure", column::where_any<&Errors::departure>},
      TrialColumn<Row>{"max_departure_over_limit", column::where_any<&Errors::departure_over_limit>},
      TrialColumn<Row>{"max_handle_over_chords", column::where_any<&Errors::handle_over_chords>},
      TrialColumn<Row>{"out_of_order", column::count<&Errors::out_of_order>},
  };
  static constexpr std::array failures{TrialFailure<Row>{"", column::trials<&Errors::broken>, run::Broken::promise}};

  static std::span<const Kernel> kernels(int dimension) { return fitting_kernels(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 16; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t /*methods*/) {
    return *part.values.points * 50'000.0;
  }

  FittingProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part);

  void draw(std::uint64_t number, Drawn& data) const { data = sample::data_points(kind_, sampler_, cell_, number); }
  static void ask(const Kernel& method, const Drawn& data, double tolerance, Answer& fit) {
    fit = method.fit(data, tolerance, {});
  }
  static std::array<std::span<double>, 2> numbers(Answer& fit) { return {fit.control_points, fit.t}; }
  static void judge(const Kernel& method, const Drawn& data, double tolerance, const Answer& fit, std::uint64_t number,
                    Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& data, double tolerance, const Answer& fit);

  /// Adds the example of the study to fitting_example.csv.
  static void write_example(tables::Tables& tables, const suite::Study& study, std::uint64_t seed);

 private:
  sample::Cell cell_;
  const sample::DataKind& kind_;
  sample::Sampler sampler_;
};

}  // namespace bezierbench::studies
