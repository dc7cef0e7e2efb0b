// SPDX-License-Identifier: MIT
// Studies of kind `search`: the largest error that a climb finds, starting from the worst inputs of a sample.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include "experiments/judge/input_fields.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/point_judge.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/search/climb.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::size_t starts = 4;        ///< of the climb: the worst of the sample
constexpr std::int64_t shared_part = 2;  ///< 1/2 of the budget goes to all starts alike, the rest to the best
constexpr double wanted_gain = 1.5;

struct Found {
  sample::Trial input;
  double error_u = -1;  ///< below every error
  double error = 0;
  std::optional<double> bound_u;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.input.coefficients, self.input.t, self.input.weights, self.error_u, self.error, self.bound_u);
  }
};

struct Outcome {
  double sampled_error_u = 0;
  Found worst;
  std::uint64_t violations = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.sampled_error_u, self.worst, self.violations);
  }
};

/// One method in one cell.
template <class Scalar>
class Search {
 public:
  Search(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell, const Kernel<Scalar>& kernel,
         reference::Tier tier)
      : study_(study), seed_(seed), cell_(cell), kernel_(kernel), tier_(tier) {}

  [[nodiscard]] Outcome run() const {
    judge::PointJudge<Scalar> judge(tier_);
    Outcome outcome;
    std::vector<Found> found = sampled(judge, outcome);
    outcome.sampled_error_u = std::max(0.0, found.front().error_u);
    // The climb takes random words that no trial takes, because its study key differs.
    sample::Words words(seed_, sample::key(fmt::format("{}/{}", study_.id, kernel_.info->id)), sample::key(cell_), 0);
    const auto each = budget() / shared_part / static_cast<std::int64_t>(found.size());
    for (auto& one : found) climb(words, each, one, judge, outcome);
    outcome.worst = *std::ranges::max_element(found, {}, &Found::error_u);
    climb(words, budget() - each * static_cast<std::int64_t>(found.size()), outcome.worst, judge, outcome);
    return outcome;
  }

  void write(const Outcome& outcome, tables::Tables& tables) const {
    tables::Row row("search.csv");
    row.set_each(tables::cell_columns(),
                 tables::cell_fields(study_, cell_, kernel_.info->id, judge::ScalarFacts<Scalar>::kind))
        .set("trials", study_.trials)
        .set("budget", budget())
        .set("search_id", fmt::format("s{}", tables.table("search.csv").row_count() + 1));
    const Found& worst = outcome.worst;
    if (worst.error_u < 0)
      row.set("status", "non_finite");
    else
      row.set("status", status(outcome))
          .set("sampled_error_u", outcome.sampled_error_u)
          .set("searched_error_u", worst.error_u)
          .set("bound_u", worst.bound_u)
          .set("error", worst.error)
          .set_each(judge::input_columns(), judge::input_fields(worst.input, cell_.dimension));
    tables.add(row);
  }

  void collect(const Outcome& outcome, std::vector<run::Violation>& violations) const {
    if (outcome.violations == 0) return;
    violations.push_back(
        {fmt::format("{}, method {}, found by the search; see search.csv",
                     tables::describe(study_, cell_, judge::ScalarFacts<Scalar>::kind), kernel_.info->id),
         outcome.violations});
  }

  [[nodiscard]] const sample::Cell& cell() const { return cell_; }

 private:
  [[nodiscard]] std::int64_t budget() const { return study_.budget; }

  /// `reached`: the climb raised the error by the required factor. `near_bound`: it cannot, because the sample is
  /// already that close to the proved bound. `short`: neither.
  [[nodiscard]] static std::string status(const Outcome& outcome) {
    if (outcome.worst.error_u >= wanted_gain * outcome.sampled_error_u) return "reached";
    const auto& bound = outcome.worst.bound_u;
    return bound && *bound <= wanted_gain * outcome.sampled_error_u ? "near_bound" : "short";
  }

  /// The worst inputs of the sample, worst first; at least one.
  std::vector<Found> sampled(judge::PointJudge<Scalar>& judge, Outcome& outcome) const {
    const sample::Sampler sampler(seed_, study_.id, cell_);
    std::vector<Found> worst;
    judge::TrialInputs<Scalar> inputs(study_.form, cell_);
    for (std::int64_t trial = 0; trial < study_.trials && !run::interrupted(); ++trial) {
      inputs.draw(sampler, static_cast<std::uint64_t>(trial));
      Found one = judged(inputs, judge, outcome);
      if (worst.size() == starts && one.error_u <= worst.back().error_u) continue;
      const auto place = std::ranges::find_if(worst, [&](const Found& other) { return other.error_u < one.error_u; });
      worst.insert(place, std::move(one));
      if (worst.size() > starts) worst.pop_back();
    }
    if (worst.empty()) worst.emplace_back();
    return worst;
  }

  Found judged(const judge::TrialInputs<Scalar>& inputs, judge::PointJudge<Scalar>& judge, Outcome& outcome) const {
    const judge::PointVerdict verdict = judge.judge(kernel_, inputs);
    Found found;
    found.input = inputs.values();
    if (verdict.violates) ++outcome.violations;
    if (!verdict.finite || !std::isfinite(verdict.error_u)) return found;  // p~ = 0 measures nothing
    found.error_u = verdict.error_u;
    found.error = verdict.error;
    found.bound_u = verdict.bound_u;
    return found;
  }

  void climb(sample::Words& words, std::int64_t steps, Found& from, judge::PointJudge<Scalar>& judge,
             Outcome& outcome) const {
    constexpr int unseen_bits = 53 - judge::ScalarFacts<Scalar>::format.precision;
    const Climb neighbours(cell_, unseen_bits);
    judge::TrialInputs<Scalar> inputs(study_.form, cell_);
    for (; steps > 0 && !run::interrupted(); --steps) {
      sample::Trial next = from.input;
      neighbours.step(words, next);
      inputs.assign(next);
      Found reached = judged(inputs, judge, outcome);
      if (reached.error_u >= from.error_u) from = std::move(reached);
    }
  }

  const suite::Study& study_;
  std::uint64_t seed_;
  sample::Cell cell_;
  const Kernel<Scalar>& kernel_;
  reference::Tier tier_;
};

class SearchJob final : public run::JobOf<Outcome> {
 public:
  SearchJob(const suite::Study& study, const run::JobContext& context) : study_(study) {
    for (const auto& cell : sample::cells(study_))
      for (const auto scalar : study_.scalar)
        judge::with_scalar(scalar, [&]<class Scalar>(Scalar /*zero*/) { add<Scalar>(context, cell); });
  }

  [[nodiscard]] std::size_t parts() const override { return searches_.size(); }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = cell(part).degree + 1.0;
    return static_cast<double>(study_.trials + budget()) * (200 + 150 * n + 4 * n * n);
  }
  [[nodiscard]] run::Extent extent() const override {
    const auto evaluations = static_cast<std::uint64_t>(study_.trials + budget());
    run::Extent sum;
    for (std::size_t part = 0; part < searches_.size(); ++part) sum += {1, 1, evaluations};
    return sum;
  }
  void write(tables::Tables& tables) const override {
    for (std::size_t part = 0; part < searches_.size(); ++part)
      std::visit([&](const auto& search) { search.write(state(part), tables); }, searches_[part]);
  }
  [[nodiscard]] std::vector<run::Violation> violations() const override {
    std::vector<run::Violation> all;
    for (std::size_t part = 0; part < searches_.size(); ++part)
      std::visit([&](const auto& search) { search.collect(state(part), all); }, searches_[part]);
    return all;
  }

 protected:
  [[nodiscard]] Outcome work(std::size_t block) const override {
    return std::visit([](const auto& search) { return search.run(); }, searches_[block]);
  }

 private:
  [[nodiscard]] std::int64_t budget() const { return study_.budget; }
  template <class Scalar>
  void add(const run::JobContext& context, const sample::Cell& cell) {
    for (const auto* kernel : judge::chosen_kernels<Scalar>(study_, cell))
      if (kernel->info->bit_stable && kernel->info->template supports<Scalar>(cell.degree))
        searches_.push_back(Search<Scalar>(study_, context.seed, cell, *kernel, context.tier));
  }

  [[nodiscard]] const sample::Cell& cell(std::size_t part) const {
    return std::visit([](const auto& search) -> const sample::Cell& { return search.cell(); }, searches_[part]);
  }

  suite::Study study_;
  std::vector<std::variant<Search<double>, Search<float>>> searches_;
};

std::unique_ptr<run::Job> search_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<SearchJob>(study, context);
}

constexpr std::array search_fields{suite::field<&suite::Study::budget>(
    suite::budget_key("how many inputs the search may try per cell and method, after the random trials"))};

}  // namespace

extern constexpr StudyKind search_kind{
    .asks = {.id = "search",
             .about = "the inputs with the largest error, sought from random ones on",
             .own = search_fields,
             .methods_example = "[\"de_casteljau\"]"},
    .make = search_job};

}  // namespace bezierbench::studies
