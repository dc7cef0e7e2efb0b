// SPDX-License-Identifier: MIT
#include "experiments/studies/companion_rivals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "experiments/failure.hpp"
#include "experiments/sample/placement.hpp"
#include "experiments/studies/companions.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/studies/projection.hpp"
#include "experiments/suite/pattern.hpp"
#include "reference/projection.hpp"
#include "reference/true_length.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::uint64_t problems_per_cell = 64;

/// Solves problem k, two numbers each: what is timed.
using Solve = std::function<void(std::size_t k, double* result)>;

/// A rival that solves `count` problems in a row, and the results that it must reproduce bit for bit.
struct Contestant {
  Solve solve;
  std::vector<double> results;
  std::vector<double> judged;

  Contestant(Solve how, std::size_t count) : solve(std::move(how)), results(2 * count, spoilt), judged(2 * count) {
    run();
    std::swap(results, judged);
  }
  void run() {
    for (std::size_t k = 0; 2 * k < results.size(); ++k) solve(k, &results[2 * k]);
  }
  /// Spoils the results, so that a run that does nothing cannot pass the next check.
  bool check() {
    const bool same = std::memcmp(results.data(), judged.data(), results.size() * sizeof(double)) == 0;
    std::ranges::fill(results, spoilt);
    return same;
  }
  static constexpr double spoilt = std::numeric_limits<double>::quiet_NaN();
};

using IsRight = std::function<bool(std::size_t k, const double* result)>;

void add(JudgedRivals& all, std::string_view id, Solve solve, const IsRight& is_right) {
  const auto contestant = std::make_shared<Contestant>(std::move(solve), problems_per_cell);
  bool right = true;
  for (std::size_t k = 0; k < problems_per_cell; ++k) right = right && is_right(k, &contestant->judged[2 * k]);
  all.right.push_back(right);
  all.rivals.push_back({std::string(id), problems_per_cell, [contestant] { contestant->run(); },
                        [contestant] { return contestant->check(); }});
}

template <class Kernel>
const Kernel& kernel_of(std::span<const Kernel> table, const MethodInfo* info) {
  return *std::ranges::find(table, info, &Kernel::info);
}

JudgedRivals length_rivals(const std::vector<const MethodInfo*>& methods, const suite::Study& study,
                           const sample::Cell& cell, std::uint64_t seed) {
  const sample::Sampler sampler(seed, study.id, cell);
  const auto curves = std::make_shared<std::vector<sample::Trial>>(problems_per_cell);
  const auto view = [curves, cell](std::size_t k) {
    return CurveView<double>{Form::bernstein, cell.dimension, cell.degree, (*curves)[k].coefficients};
  };
  const auto [from, to] = cell.t_interval;
  const double tolerance = study.tolerance.front();
  std::vector<reference::TrueLength> truths;
  for (std::size_t k = 0; k < problems_per_cell; ++k) {
    sampler.draw(k, (*curves)[k]);
    truths.emplace_back(view(k), from, to);
  }
  const auto is_right = [&](std::size_t k, const double* result) {
    return truths[k].error_of(result[0]) <= tolerance * truths[k].value().convert_to<double>() * (1 + 0x1p-20);
  };
  JudgedRivals all;
  for (const auto* info : methods) {
    const auto measure = kernel_of(arc_length_methods(cell.dimension), info).measure;
    add(
        all, info->id,
        [=, from = from, to = to](std::size_t k, double* result) {
          const auto length = measure(view(k), from, to, tolerance);
          result[0] = length.length;
          result[1] = static_cast<double>(length.evaluations);
        },
        is_right);
  }
  return all;
}

JudgedRivals projection_rivals(const std::vector<const MethodInfo*>& methods, const suite::Study& study,
                               const sample::Cell& cell, std::uint64_t seed) {
  const sample::Sampler sampler(seed, study.id, sample::with_point(cell));
  const auto problems = std::make_shared<std::vector<sample::PlacedPoint>>();
  const auto view = [problems](std::size_t k) {
    const auto& problem = (*problems)[k];
    return CurveView<double>{Form::bernstein, problem.dimension, problem.degree, problem.points};
  };
  std::vector<reference::ExactProjection> truths;
  for (std::size_t k = 0; k < problems_per_cell; ++k) {
    problems->push_back(sample::place(sample::placements().front(), sampler, cell, k));
    truths.push_back(reference::projection(view(k), (*problems)[k].point));
  }
  const auto is_right = [&](std::size_t k, const double* result) {
    const auto& squared = truths[k].foot().distance_squared;
    return reference::distance_error(reference::error_format, result[1], squared) <=
           missed_tolerance * sample::largest_coordinate((*problems)[k]);
  };
  JudgedRivals all;
  for (const auto* info : methods) {
    const auto project = kernel_of(projection_methods(cell.dimension), info).project;
    add(
        all, info->id,
        [=](std::size_t k, double* result) {
          const auto foot = project(view(k), (*problems)[k].point);
          result[0] = foot.t;
          result[1] = foot.distance;
        },
        is_right);
  }
  return all;
}

[[noreturn]] void refuse(const suite::Study& study, std::string_view what) {
  throw Failure(Exit::usage, fmt::format("study \"{}\": {}", study.id, what));
}

}  // namespace

Problem timed_problem(const suite::Study& study) {
  for (const auto& entry : study.methods)
    for (const auto* info : companion_infos())
      if (info->id == entry) return info->problem;
  return Problem::evaluation;
}

std::vector<const MethodInfo*> timed_companions(const suite::Study& study, Problem problem, const sample::Cell& cell) {
  if (problem != Problem::arc_length && problem != Problem::projection)
    refuse(study, fmt::format("methods for the problem {} are not timed; name others", name(problem)));
  check_bezier_in_double(study);
  check_independent_points(study);
  if (study.modes != std::vector{suite::Mode::one_shot})
    refuse(study, "a companion problem is timed from the control points on; write modes = [\"one_shot\"]");
  if (study.tolerance.size() != (problem == Problem::arc_length ? 1 : 0))
    refuse(study, problem == Problem::arc_length ? "arc lengths are timed at one tolerance; write one"
                                                 : "a projection has no tolerance; remove it");
  auto methods = chosen_companions(study, problem);
  std::erase_if(methods, [&](const MethodInfo* info) {
    const bool there = problem == Problem::arc_length
                           ? std::ranges::count(arc_length_methods(cell.dimension), info, &ArcLengthKernel::info) > 0
                           : std::ranges::count(projection_methods(cell.dimension), info, &ProjectionKernel::info) > 0;
    return !there || !info->supports<double>(cell.degree);
  });
  return methods;
}

JudgedRivals companion_rivals(const std::vector<const MethodInfo*>& methods, Problem problem, const suite::Study& study,
                              const sample::Cell& cell, std::uint64_t seed) {
  return problem == Problem::arc_length ? length_rivals(methods, study, cell, seed)
                                        : projection_rivals(methods, study, cell, seed);
}

}  // namespace bezierbench::studies
