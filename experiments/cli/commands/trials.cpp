// SPDX-License-Identifier: MIT
// `trials`: draws every trial of one cell of a bundle again from the seed and judges it again, one by one.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "experiments/bundle/bundle.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/judge/input_fields.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/point_judge.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/overrides.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct TrialsOptions {
  std::string bundle;
  std::string study;
  std::string method;
  std::vector<std::string> set;
};

/// Selects the study that the options name, with the values of `set`.
suite::Overrides narrowing(const TrialsOptions& options, std::vector<std::string> set) {
  return {.seed = {}, .trials = {}, .set = std::move(set), .only = options.study, .only_option = "--study"};
}

/// Refuses settings that do not choose a cell: trials are judged against the exact reference, as in the run.
void check_that_cells_are_set(const std::vector<std::string>& settings) {
  std::vector<std::string> axes;
  for (const auto& field : suite::shared_fields())
    if (field.axis == suite::Axis::of_cells) axes.emplace_back(field.key);
  for (const auto& setting : settings) {
    const auto key = setting.substr(0, setting.find('='));
    if (std::ranges::find(axes, key) == axes.end())
      throw Failure(Exit::usage, "--set {}: {} is not an axis that distinguishes cells{}", setting, key,
                    suite::suggestion(key, axes));
  }
}

/// A cell in one scalar type: the key of a row of accuracy.csv without the method.
struct ScalarCell {
  sample::Cell cell;
  suite::ScalarKind scalar;
  friend bool operator==(const ScalarCell&, const ScalarCell&) = default;
};

std::vector<ScalarCell> scalar_cells(const suite::Study& study) {
  std::vector<ScalarCell> all;
  for (const auto& cell : sample::cells(study))
    for (const auto scalar : study.scalar) all.push_back({cell, scalar});
  return all;
}

/// The columns in which cells differ, with their values: "degree (4, 8), t_min (0, 0.5)".
std::string choices(const suite::Study& study, const std::vector<ScalarCell>& cells) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < tables::cell_columns().size(); ++k) {
    std::vector<std::string> values;
    for (const auto& [cell, scalar] : cells) {
      const auto value = tables::text(tables::cell_fields(study, cell, "", scalar).at(k));
      if (std::ranges::find(values, value) == values.end()) values.push_back(value);
    }
    if (values.size() > 1) words.push_back(fmt::format("{} ({})", tables::cell_columns()[k], fmt::join(values, ", ")));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

/// A study of a bundle, restricted to one cell.
struct Chosen {
  suite::Study study;
  std::uint64_t seed;
  ScalarCell cell;
};

/// The study that --study names, or the only one.
const suite::Study& only_study(const std::vector<suite::Suite>& suites, const std::string& wanted) {
  if (suites.size() > 1 || suites.front().studies.size() > 1)
    throw Failure(Exit::usage, "--study {}: matches more than one study; name one", wanted);
  const auto& study = suites.front().studies.front();
  if (!studies::is_kind(study, studies::accuracy_kind))
    throw Failure(Exit::usage, "--study {}: is of another kind; name one of kind accuracy", study.id);
  return study;
}

Chosen chosen(const TrialsOptions& options) {
  check_that_cells_are_set(options.set);
  const auto bundle = bundle::BundleDirectory::open(options.bundle);
  const auto known = vocabulary();
  constexpr const char* name = "suite.toml";
  auto suites = suite::parse_suites(bundle.read_listed(name), bundle.place(name), known);
  load_curves(suites);
  suite::apply(narrowing(options, {}), suites, known);
  const auto there = scalar_cells(only_study(suites, options.study));
  suite::apply(narrowing(options, options.set), suites, known);
  const auto& study = suites.front().studies.front();
  const auto cells = scalar_cells(study);
  if (cells.size() > 1)
    throw Failure(Exit::usage,
                  "study {}: has {} such cells; choose one with --set axis=value (t_interval=0:1), they differ in {}",
                  study.id, cells.size(), choices(study, cells));
  if (std::ranges::find(there, cells.front()) == there.end())
    throw Failure(Exit::usage, "study {}: has no such cell in {}; its cells differ in {}", study.id, options.bundle,
                  choices(study, there));
  return {study, suites.front().seed, cells.front()};
}

template <class Scalar>
const Kernel<Scalar>& chosen_kernel(const Chosen& from, const std::string& method) {
  suite::Study study = from.study;
  study.methods = {method};
  const auto kernels = judge::chosen_kernels<Scalar>(study, from.cell.cell);
  if (kernels.size() > 1)
    throw Failure(Exit::usage, "--method {}: matches {} methods; name one", method, kernels.size());
  if (kernels.empty())
    throw Failure(Exit::usage, "--method {}: takes t in [0,1] only, the cell's t are in [{},{}]", method,
                  number::decimal(from.cell.cell.t_interval.min), number::decimal(from.cell.cell.t_interval.max));
  if (!kernels.front()->info->template supports<Scalar>(from.cell.cell.degree))
    throw Failure(Exit::usage, "--method {}: does not take degree {}; see `list methods`", method,
                  from.cell.cell.degree);
  return *kernels.front();
}

std::string point_field(std::span<const double> point) {
  std::vector<std::string> coordinates;
  for (const double x : point) coordinates.push_back(number::hexadecimal(x));
  return fmt::format("{}", fmt::join(coordinates, " "));
}

std::string exact_field(const reference::ExactPoint& truth) {
  if (!truth.exists()) return "";
  std::vector<double> point(static_cast<std::size_t>(truth.dimension));
  for (int axis = 0; axis < truth.dimension; ++axis)
    point[static_cast<std::size_t>(axis)] = reference::round_to(reference::binary64, truth.coordinate(axis));
  return point_field(point);
}

template <class Scalar>
void print_trials(const Chosen& from, const std::string& method) {
  const auto& kernel = chosen_kernel<Scalar>(from, method);
  const auto& cell = from.cell.cell;
  const sample::Sampler sampler(from.seed, from.study.id, cell);
  judge::TrialInputs<Scalar> inputs(cell.form, cell);
  judge::PointJudge<Scalar> judge;
  fmt::print("trial,{},value,exact,error,error_u,bound_u\n", fmt::join(judge::input_columns(), ","));
  const auto trials = static_cast<std::uint64_t>(from.study.trials * from.study.replicates);
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    inputs.draw(sampler, trial);
    const auto verdict = judge.judge(kernel, inputs);
    const std::span<const double> value(verdict.point.data(), static_cast<std::size_t>(cell.dimension));
    fmt::print("{},{},{},{},{},{},{}\n", trial, fmt::join(judge::input_fields(inputs.values(), cell.dimension), ","),
               point_field(value), exact_field(judge.truth(inputs)),
               verdict.finite ? number::decimal(verdict.error) : "",
               verdict.finite ? number::decimal(verdict.error_u) : "",
               verdict.bound_u ? number::decimal(*verdict.bound_u) : "");
  }
}

}  // namespace

void add_trials(Command program, Exit& exit) {
  auto options = std::make_shared<TrialsOptions>();
  auto command = program.command("trials", "recompute every trial of one cell of a bundle, as CSV");
  command.option("BUNDLE", options->bundle, "folder of the bundle").required();
  command.option("--study", options->study, "id of a study of kind accuracy").required();
  command.option("--method", options->method, "id of a method of the study")
      .required()
      .takes("METHOD", methods_of(Problem::evaluation));
  command.option("--set", options->set, "the value of an axis that has several; an interval is written 0:0.2")
      .takes("AXIS=VALUE", known_settings);
  command.action([options, &exit] {
    const Chosen from = chosen(*options);
    if (from.cell.scalar == suite::ScalarKind::float32)
      print_trials<float>(from, options->method);
    else
      print_trials<double>(from, options->method);
    exit = Exit::fine;
  });
}

}  // namespace bezierbench::cli
