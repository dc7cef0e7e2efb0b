// SPDX-License-Identifier: MIT
// A random curve flattened to a tolerance, which is relative to its size: every chord against its piece of the curve.
// An answer is right if no piece is certainly farther from its chord than the tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/flatten/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/companion/chord_distance.hpp"

namespace bezierbench::studies {

/// The trial with the largest certain distance over the tolerance, where that is above 1.
struct WorstFlattening {
  double over_tolerance = 0;
  std::uint64_t trial = 0;
  std::vector<double> numbers;  ///< control points and, of a rational curve, weights

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.over_tolerance, self.trial, self.numbers);
  }
  void merge(const WorstFlattening& other) {
    const bool same = other.over_tolerance == over_tolerance;
    if (other.over_tolerance > over_tolerance || (same && other.trial < trial)) *this = other;
  }
};

struct FlatteningErrors {
  metric::Total chords;
  metric::Total least_low;              ///< lower bounds of the least number of chords
  metric::Total least_high;             ///< numbers of chords that suffice
  metric::Tally over_least;             ///< chords over `least_low`
  metric::Tally error;                  ///< largest distance of a piece from its chord over the tolerance, from above
  metric::TrialCount broken;            ///< trials in which a piece is certainly farther than the tolerance
  metric::TrialCount undecided;         ///< trials, not broken, in which that is neither proved nor refuted for a piece
  metric::TrialCount broken_promises;   ///< broken trials of a method that promises the tolerance and said it kept it
  metric::TrialCount reversed_apart;    ///< trials in which the reversed curve has other points
  metric::TrialCount broken_reversals;  ///< such trials of methods that promise the same points
  metric::TrialCount malformed;  ///< trials in which the chords do not lead from end to end; nothing else is judged
  metric::Total evaluations;
  std::uint64_t incomplete = 0;  ///< trials in which the method said that it did not keep the tolerance
  std::uint64_t non_finite = 0;  ///< trials with a number that is not finite; nothing else is judged
  WorstFlattening worst;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.chords, self.least_low, self.least_high, self.over_least, self.error, self.broken, self.undecided,
                 self.broken_promises, self.reversed_apart, self.broken_reversals, self.malformed, self.evaluations,
                 self.incomplete, self.non_finite, self.worst);
  }
};

/// The control points of the worst trial in hexadecimal, point by point, and the weights of a rational curve; empty where
/// no tolerance is broken.
tables::Field worst_curve(const FlatteningErrors& errors);

class FlatteningProblem {
 public:
  static constexpr Problem problem = Problem::flattening;
  static constexpr judge::CaseAxes axes{.tolerance = true};
  static constexpr std::string_view table = "flattening";
  static constexpr std::int64_t block_trials = 16;

  using Kernel = FlattenKernel;
  using Answer = Flattening;
  using Errors = FlatteningErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    double size = 0;  ///< largest extent of the control points; without any, the largest coordinate or else 1
    std::vector<double> reversed;          ///< control points
    std::vector<double> reversed_weights;  ///< of a rational curve
    std::optional<reference::ScaledCurve> scaled;
    double least_for = 0;  ///< the tolerance that `least` is for
    reference::LeastChords least{};
  };

  static constexpr std::array case_columns{judge::case_column::tolerance};
  static constexpr std::array columns{
      TrialColumn<Row>{"mean_chords", column::per_trial<&Errors::chords, &metric::Total::sum>},
      TrialColumn<Row>{"max_chords", column::count<&Errors::chords, &metric::Total::largest>},
      TrialColumn<Row>{"least_low", column::per_trial<&Errors::least_low, &metric::Total::sum>},
      TrialColumn<Row>{"least_high", column::per_trial<&Errors::least_high, &metric::Total::sum>},
      TrialColumn<Row>{"mean_over_least", column::statistic<tables::mean, &Errors::over_least>},
      TrialColumn<Row>{"max_over_least", column::statistic<tables::largest, &Errors::over_least>},
      TrialColumn<Row>{"mean_error_over_tolerance", column::statistic<tables::mean, &Errors::error>},
      TrialColumn<Row>{"max_error_over_tolerance", column::statistic<tables::largest, &Errors::error>},
      TrialColumn<Row>{"broken", column::count<&Errors::broken>},
      TrialColumn<Row>{"undecided", column::count<&Errors::undecided>},
      TrialColumn<Row>{"broken_promises", column::count<&Errors::broken_promises>},
      TrialColumn<Row>{"reversed_apart", column::count<&Errors::reversed_apart>},
      TrialColumn<Row>{"malformed", column::count<&Errors::malformed>},
      TrialColumn<Row>{"mean_evaluations", column::per_trial<&Errors::evaluations, &metric::Total::sum>},
      TrialColumn<Row>{"incomplete", column::count<&Errors::incomplete>},
      TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
      TrialColumn<Row>{"worst_trial",
                       [](const Row& row) {
                         const bool any = row.errors.broken.count > 0;
                         return any ? tables::field(row.errors.worst.trial) : tables::Field();
                       }},
      TrialColumn<Row>{"worst_curve", [](const Row& row) { return worst_curve(row.errors); }},
  };
  static constexpr std::array failures{
      TrialFailure<Row>{"tolerance", column::trials<&Errors::broken_promises>, run::Broken::promise},
      TrialFailure<Row>{"reversed curve", column::trials<&Errors::broken_reversals>, run::Broken::promise},
      TrialFailure<Row>{"ends of chords", column::trials<&Errors::malformed>, run::Broken::promise},
  };

  static std::span<const Kernel> kernels(int dimension) { return flatten_kernels(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 64; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t methods) {
    const double n = part.cell.degree + 1.0;
    return 100'000 * n * (10 + static_cast<double>(methods));
  }

  FlatteningProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
      : curves_(study, seed, part.cell) {}

  void draw(std::uint64_t number, Drawn& drawn) const;
  static void ask(const Kernel& method, const Drawn& drawn, double tolerance, Answer& chords) {
    method.flatten(drawn.curve, tolerance * drawn.size, chords);
  }
  static std::array<std::span<double>, 2> numbers(Answer& chords) { return {chords.t, chords.points}; }
  static void judge(const Kernel& method, Drawn& drawn, double tolerance, const Answer& chords, std::uint64_t number,
                    Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& chords);

 private:
  judge::CurveSampler curves_;
};

}  // namespace bezierbench::studies
