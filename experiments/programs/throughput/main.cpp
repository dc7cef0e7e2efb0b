// SPDX-License-Identifier: MIT
// How fast the harness judges, in ratios of one run: bezierbench_throughput LADDER.toml. Exit 1 where a goal is missed.
#include <fmt/core.h>

#include <algorithm>
#include <exception>

#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/failure.hpp"
#include "experiments/programs/throughput/reference_cost.hpp"
#include "experiments/programs/throughput/sweep_cost.hpp"
#include "experiments/suite/text/reader.hpp"

namespace {

using namespace bezierbench;

constexpr int degree = 20;
constexpr int trials = 256;

/// A study of the ladder cut down to one cell.
suite::Study one_cell(suite::Study study) {
  study.degree = {degree};
  study.generator.resize(1);
  study.trials = trials;
  return study;
}

bool print(const throughput::Comparison& one) {
  fmt::print("{:<38} {:>10.0f} ns   {:<38} {:>10.0f} ns   {:>7.2f} times   goal {} {:g}   {}\n", one.what, one.ns,
             one.than, one.than_ns, one.at_least ? one.ratio : 1 / one.ratio, one.at_least ? ">=" : "<=", one.goal,
             one.met() ? "met" : "MISSED");
  return one.met();
}

int measure(const char* ladder) {
  bool met = true;
  for (const auto& one : throughput::reference_costs(degree)) met = print(one) && met;
  const auto suite = suite::read_suite(ladder, cli::vocabulary());
  for (const auto& study : suite.studies) met = print(throughput::sweep_cost(one_cell(study))) && met;
  return static_cast<int>(met ? Exit::fine : Exit::finding);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: bezierbench_throughput LADDER.toml\n");
    return static_cast<int>(Exit::usage);
  }
  try {
    return measure(argv[1]);
  } catch (const Failure& failure) {
    fmt::print(stderr, "bezierbench_throughput: {}\n", failure.what());
    return static_cast<int>(failure.exit());
  } catch (const std::exception& error) {
    fmt::print(stderr, "bezierbench_throughput: {}\n", error.what());
    return static_cast<int>(Exit::input_output);
  }
}
