// SPDX-License-Identifier: MIT
// The roots in [0, 1] of the coordinates of a curve minus a value against the exact ones. The value is 0 for drawn
// curves and the middle of the control points for those of sets, which may be anywhere.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/roots/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "experiments/suite/kind.hpp"
#include "reference/companion/exact_roots.hpp"

namespace bezierbench::studies {

/// An answer belongs to a root that is at most as far away.
inline constexpr double root_within = 0x1p-20;

/// The answers of one polynomial beside its roots.
struct MatchedRoots {
  std::vector<double> error;         ///< of each root, that of its nearest answer; infinite where it has none
  std::vector<std::size_t> root_of;  ///< of each answer, the number of its root; that of all roots where it has none
  std::uint64_t spurious = 0;        ///< answers without a root, and all but one of those of the same root
};

MatchedRoots matched(const std::vector<reference::Root>& roots, const std::vector<double>& answers);

/// Whether every root is in an enclosure, and a certain enclosure has exactly one. Roots are rounded, and so may be on
/// the common end of two enclosures.
bool keeps_enclosures(const std::vector<reference::Root>& roots, const std::vector<RootEnclosure>& enclosures);

struct RootsErrors {
  std::uint64_t polynomials = 0;
  std::uint64_t right_count = 0;
  std::uint64_t right_odd_count = 0;
  std::uint64_t roots = 0;
  std::uint64_t missed = 0;
  std::uint64_t missed_odd = 0;
  std::uint64_t spurious = 0;
  metric::Largest<double> error;            ///< of roots that are not missed
  metric::Largest<double> simple_error;     ///< of these, of simple ones
  metric::Largest<double> error_condition;  ///< of these, over u and the condition, if it is above 1
  std::uint64_t uncertain = 0;
  metric::TrialCount broken;
  std::uint64_t evaluations = 0;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.polynomials, self.right_count, self.right_odd_count, self.roots, self.missed, self.missed_odd,
                 self.spurious, self.error, self.simple_error, self.error_condition, self.uncertain, self.broken,
                 self.evaluations);
  }
};

class RootsProblem {
 public:
  static constexpr Problem problem = Problem::roots;
  static constexpr judge::CaseAxes axes{};
  static constexpr std::string_view table = "roots";
  static constexpr std::int64_t block_trials = 256;

  using Kernel = RootsKernel;
  using Answer = std::vector<FoundRoots>;  ///< axis by axis
  using Errors = RootsErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    std::vector<double> value;            ///< axis by axis
    std::vector<reference::Roots> truth;  ///< axis by axis
    /// Of each root of an axis, p~ / |p'|; infinite where the root is not simple.
    std::vector<std::vector<double>> condition;
  };

  static constexpr std::array<judge::CaseColumn, 0> case_columns{};
  static constexpr std::array columns{
      TrialColumn<Row>{"polynomials", column::count<&Errors::polynomials>},
      TrialColumn<Row>{"right_count", column::count<&Errors::right_count>},
      TrialColumn<Row>{"right_odd_count", column::count<&Errors::right_odd_count>},
      TrialColumn<Row>{"roots", column::count<&Errors::roots>},
      TrialColumn<Row>{"missed", column::count<&Errors::missed>},
      TrialColumn<Row>{"missed_odd", column::count<&Errors::missed_odd>},
      TrialColumn<Row>{"spurious", column::count<&Errors::spurious>},
      TrialColumn<Row>{"max_t_error", column::count<&Errors::error>},
      TrialColumn<Row>{"max_simple_t_error", column::count<&Errors::simple_error>},
      TrialColumn<Row>{"max_error_condition", column::count<&Errors::error_condition>},
      TrialColumn<Row>{"uncertain", column::count<&Errors::uncertain>},
      TrialColumn<Row>{"broken_promises", column::count<&Errors::broken>},
      TrialColumn<Row>{"mean_evaluations",
                       [](const Row& row) {
                         const auto count = static_cast<double>(row.errors.polynomials);
                         return count > 0 ? tables::field(static_cast<double>(row.errors.evaluations) / count)
                                          : tables::Field();
                       }},
  };
  static constexpr std::array failures{
      TrialFailure<Row>{"roots outside their enclosures", column::trials<&Errors::broken>, run::Broken::promise}};

  static std::span<const Kernel> kernels(int /*dimension*/) { return roots_kernels(); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 32; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t methods) {
    const double n = part.cell.degree + 1.0;
    return part.cell.dimension * n * n * (4'000 + 500 * static_cast<double>(methods));
  }

  RootsProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
      : curves_(study, seed, part.cell), of_sets_(suite::has_sets(study)) {}

  void draw(std::uint64_t number, Drawn& drawn) const;
  /// Of the curve and the values that were drawn.
  static void find_truth(Drawn& drawn);
  static void ask(const Kernel& method, const Drawn& drawn, double tolerance, Answer& found);
  static std::vector<std::span<double>> numbers(Answer& found);
  static void judge(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& found,
                    std::uint64_t number, Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& found);

 private:
  judge::CurveSampler curves_;
  bool of_sets_;
};

}  // namespace bezierbench::studies
