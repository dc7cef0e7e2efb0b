// SPDX-License-Identifier: MIT
// Studies of kind `guarantees`: what methods keep of a curve's properties, proved or refuted by an input.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <variant>
#include <vector>

#include "core/evaluate/guarantee.hpp"
#include "experiments/judge/input_fields.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/run/blocks/trial_blocks.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/guarantees/search_for_counterexample.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

/// One statement about one method in one cell.
template <class ScalarT>
struct Question {
  using Scalar = ScalarT;
  const guarantees::Statement<Scalar>* statement;
  const Kernel<Scalar>* kernel;
  sample::Cell cell;

  [[nodiscard]] const MethodInfo& method() const { return *kernel->info; }
  [[nodiscard]] bool proved() const { return is_proved(method(), statement->property, cell.degree); }
  [[nodiscard]] std::string_view verdict(const Refutation& found) const {
    return found.smallest ? "refuted" : proved() ? "proved" : "not_refuted";
  }
};

class GuaranteesJob final : public run::JobOf<Refutation> {
 public:
  GuaranteesJob(const suite::Study& study, std::uint64_t seed)
      : study_(study), seed_(seed), blocks_(study.trials, 1, block_trials) {
    check_properties();
    for (const auto& cell : sample::cells(study_))
      for (const auto scalar : study_.scalar)
        judge::with_scalar(scalar, [&]<class Scalar>(Scalar /*zero*/) { add<Scalar>(cell); });
  }

  [[nodiscard]] std::size_t parts() const override { return questions_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return blocks_.count(); }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = cell(part).degree + 1.0;
    const auto inputs = static_cast<double>(study_.trials + budget()) / static_cast<double>(blocks_per_part());
    return inputs * (300 + 60 * n + 4 * n * n);
  }
  [[nodiscard]] bool is_estimable() const override { return false; }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (std::size_t part = 0; part < parts(); ++part)
      sum += {1, 1, static_cast<std::uint64_t>(study_.trials + budget())};
    return sum;
  }
  void write(tables::Tables& tables) const override {
    for (std::size_t part = 0; part < parts(); ++part)
      std::visit([&](const auto& question) { write(question, state(part), tables); }, questions_[part]);
  }
  [[nodiscard]] std::vector<run::Violation> violations() const override {
    std::vector<run::Violation> all;
    for (std::size_t part = 0; part < parts(); ++part)
      std::visit(
          [&](const auto& question) {
            if (question.proved() && state(part).smallest)
              all.push_back(
                  {fmt::format("study {}, {} of method {} in {}, degree {}, is stated as proved; see guarantees.csv",
                               study_.id, name(question.statement->property), question.method().id,
                               suite::name(scalar_of(question)), question.cell.degree),
                   1, run::Broken::proof});
          },
          questions_[part]);
    return all;
  }

 protected:
  [[nodiscard]] Refutation work(std::size_t block) const override {
    const auto trials = blocks_[block % blocks_per_part()];
    return std::visit([&](const auto& question) { return block_of(question, trials); }, questions_[part_of(block)]);
  }

 private:
  template <class Scalar>
  static suite::ScalarKind scalar_of(const Question<Scalar>& /*question*/) {
    return judge::ScalarFacts<Scalar>::kind;
  }
  [[nodiscard]] std::int64_t budget() const { return study_.budget; }
  [[nodiscard]] const std::vector<std::string>& asked() const { return study_.properties; }
  [[nodiscard]] bool is_asked(Property property) const {
    return asked().empty() || std::ranges::find(asked(), name(property)) != asked().end();
  }
  void check_properties() const {
    std::vector<std::string_view> known;
    for (const Property property : properties) known.push_back(name(property));
    for (std::size_t k = 0; k < asked().size(); ++k)
      if (std::ranges::find(known, asked()[k]) == known.end())
        suite::refuse(study_,
                      {"properties",
                       k,
                       {},
                       fmt::format("unknown property \"{}\"; known are {}", echo(asked()[k]), fmt::join(known, ", "))});
  }

  [[nodiscard]] const sample::Cell& cell(std::size_t part) const {
    return std::visit([](const auto& question) -> const sample::Cell& { return question.cell; }, questions_[part]);
  }

  template <class Scalar>
  void add(const sample::Cell& cell) {
    for (const auto* kernel : judge::chosen_kernels<Scalar>(study_, cell))
      if (kernel->info->template supports<Scalar>(cell.degree))
        for (const auto& statement : guarantees::statements<Scalar>)
          if (statement.concerns(cell.dimension) && is_asked(statement.property))
            questions_.push_back(Question<Scalar>{&statement, kernel, cell});
  }

  /// All methods get the same random inputs; the search takes words of its own for each, and its share of the budget.
  template <class Scalar>
  Refutation block_of(const Question<Scalar>& question, const run::TrialBlock& trials) const {
    const auto property = fmt::format("{}/{}", study_.id, name(question.statement->property));
    const auto cell = sample::key(question.cell);
    CounterexampleSearch<Scalar> search(*question.statement, *question.kernel, question.cell.degree);
    const sample::Sampler sampler(seed_, study_.id, question.cell);
    sample::Trial given;
    run::each_trial(trials, [&](std::int64_t trial) {
      sample::Words words(seed_, sample::key(property), cell, static_cast<std::uint64_t>(trial));
      if (question.cell.slice) sampler.draw(static_cast<std::uint64_t>(trial), given);
      search.add_trial(words, given.coefficients);
    });
    const auto scalar = suite::name(judge::ScalarFacts<Scalar>::kind);
    sample::Words words(seed_, sample::key(fmt::format("{}/{}/{}", property, question.method().id, scalar)), cell,
                        static_cast<std::uint64_t>(trials.first));
    search.search(words, budget() / static_cast<std::int64_t>(blocks_per_part()));
    return std::move(search).result();
  }

  template <class Scalar>
  void write(const Question<Scalar>& question, const Refutation& found, tables::Tables& tables) const {
    const auto& statement = *question.statement;
    tables::Row row(question.method().bit_stable ? "guarantees.csv" : "guarantees_unstable.csv");
    if (question.cell.slice) row.set("curves", question.cell.slice->set().id);
    row.set("study", study_.id)
        .set("method", question.method().id)
        .set("scalar", suite::name(scalar_of(question)))
        .set("dimension", question.cell.dimension)
        .set("degree", question.cell.degree)
        .set("property", name(statement.property))
        .set("guarantee_id", fmt::format("g{}", rows_of(tables) + 1))
        .set("verdict", question.verdict(found))
        .set("trials", found.trials)
        .set("broken", found.broken)
        .set("searched", found.searched);
    if (found.nearest) row.set("largest", found.nearest->measure);
    const auto& shown = found.smallest ? found.smallest : question.proved() ? std::nullopt : found.nearest;
    if (shown) {
      row.set_each({"t", "coefficients"}, input_of(*shown, question.cell.dimension));
      if (statement.uses_t_next) row.set("t_next", tables::Hexadecimal{shown->t_next});
      if (statement.uses_offset) row.set("offset", tables::Hexadecimal{shown->offset});
    }
    tables.add(row);
  }

  /// The rows of both tables, so that no id occurs twice in a bundle.
  static std::size_t rows_of(const tables::Tables& tables) {
    std::size_t rows = 0;
    for (const auto* file : {"guarantees.csv", "guarantees_unstable.csv"})
      if (const auto* table = tables.find(file)) rows += table->row_count();
    return rows;
  }

  static std::vector<std::string> input_of(const RecordedCase& shown, int dimension) {
    auto fields = judge::input_fields({shown.coefficients, shown.t, {}}, dimension);
    fields.pop_back();  // weights
    return fields;
  }

  static constexpr std::int64_t block_trials = 1 << 16;

  suite::Study study_;
  std::uint64_t seed_;
  run::TrialBlocks blocks_;
  std::vector<std::variant<Question<double>, Question<float>>> questions_;
};

std::unique_ptr<run::Job> guarantees_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<GuaranteesJob>(study, context.seed);
}

constexpr std::array guarantees_fields{
    suite::field<&suite::Study::budget>(suite::budget_key(
        "how many inputs the search for a counterexample may try per cell, method and property, after the "
        "random trials")),
    suite::field<&suite::Study::properties>({.key = "properties",
                                             .meaning = "which statements, by the names of experiments/guarantees",
                                             .example = "[\"ends_exact\", \"in_hull\"]",
                                             .left_out = "all"})};

constexpr std::array<std::string_view, 5> undrawn{"coordinate_range", "t_interval", "generator", "parameters_from",
                                                  "placement"};

}  // namespace

extern constexpr StudyKind guarantees_kind{
    .asks = {.id = "guarantees",
             .about = "what methods keep of a curve's properties: proved, refuted by an input, or neither",
             .own = guarantees_fields,
             .methods_example = "[\"de_casteljau*\"]",
             .inputs = {.forms = suite::bernstein_form,
                        .forms_reason = "the properties are of control points",
                        .least_degree = 1,
                        .least_degree_reason = "a curve of degree 0 is a point"},
             .without = undrawn,
             .without_reason = "the statements are about all control points, and each says which t it is about"},
    .make = guarantees_job};

}  // namespace bezierbench::studies
