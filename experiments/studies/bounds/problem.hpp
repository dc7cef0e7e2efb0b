// SPDX-License-Identifier: MIT
// The box of a random curve against the tightest box of doubles. An answer is right if no point of the curve is outside
// or, where nothing is promised, if at least half of the digits of the curve's size are right.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/bounds/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/companion/exact_roots.hpp"

namespace bezierbench::studies {

/// How far one side of a box is from that of the tightest one.
struct SideError {
  double ulp = 0;       ///< doubles from one to the other; below 0 where the computed side is inside
  double distance = 0;  ///< likewise in coordinate units
};

/// Of lower sides that are numbers; upper ones are lower ones of the mirrored curve.
SideError side_error(double computed, double tightest);

/// The curve whose box is too small by the most, of equal ones the first. Its fields are those of judge::input_fields.
struct SmallestBox {
  double distance = 0;  ///< that the side is inside
  std::uint64_t trial = 0;
  std::string coefficients;
  std::string weights;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.distance, self.trial, self.coefficients, self.weights);
  }
  [[nodiscard]] bool yields_to(double other, std::uint64_t other_trial) const {
    return other > distance || (other == distance && other > 0 && other_trial < trial);
  }
  void merge(const SmallestBox& other) {
    if (yields_to(other.distance, other.trial)) *this = other;
  }
};

struct BoundsErrors {
  metric::Tally excess_ulp;   ///< of sides that are not inside
  metric::Tally excess_size;  ///< of these, over the size of the curve
  metric::Largest<double> inside_ulp;
  metric::Largest<double> inside_size;
  metric::TrialCount too_small;   ///< trials with a point of the curve outside
  metric::TrialCount violations;  ///< such trials of methods that promise to have none
  metric::TrialCount loose;       ///< trials with a side 2 ulp or more outside, of methods that promise at most 1
  SmallestBox smallest;
  std::uint64_t non_finite = 0;  ///< trials with a side that is not a number

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.excess_ulp, self.excess_size, self.inside_ulp, self.inside_size, self.too_small, self.violations,
                 self.loose, self.smallest, self.non_finite);
  }
};

class BoundsProblem {
 public:
  static constexpr Problem problem = Problem::bounds;
  static constexpr judge::CaseAxes axes{};
  static constexpr std::string_view table = "bounds";
  static constexpr std::int64_t block_trials = 256;

  using Kernel = BoundsKernel;
  using Answer = std::vector<double>;  ///< the lower and the upper side, axis by axis
  using Errors = BoundsErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    std::vector<reference::ExactRange> truth;  ///< axis by axis
    double size = 0;                           ///< the largest extent of the tightest box
  };

  static constexpr std::array<judge::CaseColumn, 0> case_columns{};
  static constexpr std::array columns{
      TrialColumn<Row>{"contains",
                       [](const Row& row) -> tables::Field {
                         if (row.errors.too_small.count > 0) return "refuted";
                         return row.method.promises->contains ? "proved" : "as_far_as_judged";
                       }},
      TrialColumn<Row>{"too_small", column::count<&Errors::too_small>},
      TrialColumn<Row>{"max_inside_ulp", column::count<&Errors::inside_ulp>},
      TrialColumn<Row>{"max_inside_size", column::count<&Errors::inside_size>},
      TrialColumn<Row>{"mean_excess_size", column::statistic<tables::mean, &Errors::excess_size>},
      TrialColumn<Row>{"max_excess_size", column::statistic<tables::largest, &Errors::excess_size>},
      TrialColumn<Row>{"p50_excess_ulp", column::statistic<tables::median, &Errors::excess_ulp>},
      TrialColumn<Row>{"p99_excess_ulp", column::statistic<tables::p99, &Errors::excess_ulp>},
      TrialColumn<Row>{"max_excess_ulp", column::statistic<tables::largest, &Errors::excess_ulp>},
      TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
      TrialColumn<Row>{"trial",
                       [](const Row& row) {
                         return row.errors.too_small.count > 0 ? tables::field(row.errors.smallest.trial)
                                                               : tables::Field();
                       }},
      TrialColumn<Row>{"coefficients",
                       [](const Row& row) -> tables::Field { return row.errors.smallest.coefficients; }},
      TrialColumn<Row>{"weights", [](const Row& row) -> tables::Field { return row.errors.smallest.weights; }},
  };
  static constexpr std::array failures{
      TrialFailure<Row>{"points outside", column::trials<&Errors::violations>, run::Broken::promise},
      TrialFailure<Row>{"sides 2 ulp outside", column::trials<&Errors::loose>, run::Broken::promise}};

  static std::span<const Kernel> kernels(int dimension) { return bounds_kernels(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 32; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t methods) {
    const double n = part.cell.degree;
    return n * n * (4'000 + 1'000 * static_cast<double>(methods));
  }

  BoundsProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
      : curves_(study, seed, part.cell) {}

  void draw(std::uint64_t number, Drawn& drawn) const;
  /// Of the curve that was drawn.
  static void find_truth(Drawn& drawn);
  static void ask(const Kernel& method, const Drawn& drawn, double tolerance, Answer& box);
  static std::array<std::span<double>, 1> numbers(Answer& box) { return {box}; }
  static void judge(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& box, std::uint64_t number,
                    Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& box);

 private:
  judge::CurveSampler curves_;
};

}  // namespace bezierbench::studies
