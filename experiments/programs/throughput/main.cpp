// SPDX-License-Identifier: MIT
// How fast the harness judges, in ratios of one run: bezierbench_throughput LADDER.toml. Exit 1 where a goal is missed.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/failure.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/race/race.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/text/reader.hpp"
#include "reference/true_point.hpp"

namespace {

using namespace bezierbench;

constexpr int dimension = 2;
constexpr int degree = 20;
constexpr int trials = 256;

/// Two costs of one run, with the goal for their ratio.
struct Comparison {
  std::string name;
  std::string other_name;
  double ns = 0;  ///< per point, median
  double other_ns = 0;
  double ratio = 0;  ///< other / this, median over rounds
  double goal = 0;
  bool at_least = true;  ///< the goal is a lower limit of the ratio, else of its reciprocal an upper one

  [[nodiscard]] bool met() const { return at_least ? ratio >= goal : 1 / ratio <= goal; }
};

Comparison compare(const race::Rival& rival, const race::RoundTimes& times, const race::Rival& other,
                   const race::RoundTimes& other_times) {
  return {.name = rival.name,
          .other_name = other.name,
          .ns = race::median_ns(times),
          .other_ns = race::median_ns(other_times),
          .ratio = race::median_ratio(other_times, times)};
}

// The cost of a true point: the certified tier against the exact integers and against 50 decimal digits in software.

using Digits50 = boost::multiprecision::cpp_bin_float_50;
using Inputs = judge::TrialInputs<double>;

constexpr std::size_t certified_points = 1024;
constexpr std::size_t exact_points = 64;
constexpr std::size_t digits50_points = 16;
constexpr double certified_gain_over_digits50 = 80;
constexpr double certified_gain_over_exact = 20;
constexpr std::array<double, dimension> computed{0.25, -0.125};  // the point whose distance is measured

std::vector<Inputs> draw() {
  const sample::Cell cell{.form = Form::bernstein,
                          .dimension = dimension,
                          .degree = degree,
                          .coordinate_range = 1,
                          .t_interval = {0, 1},
                          .generator = "continuous"};
  const sample::Sampler sampler(1, "throughput", cell);
  std::vector<Inputs> inputs(certified_points, Inputs(Form::bernstein, cell));
  for (std::size_t k = 0; k < inputs.size(); ++k) inputs[k].draw(sampler, k);
  return inputs;
}

/// p = (...(b_0 u + C(n,1) t b_1) u + ... ) u + t^n b_n with u = 1 - t: Farin, Curves and Surfaces for CAGD, 5th
/// ed., 5.7.
void horner_bernstein(const CurveView<double>& curve, double t, std::array<Digits50, dimension>& point) {
  const int n = curve.degree;
  const Digits50 u = Digits50(1) - t;
  for (int axis = 0; axis < dimension; ++axis) {
    Digits50 t_power = 1;
    Digits50 binomial = 1;
    Digits50 sum = u * curve(axis, 0);
    for (int i = 1; i < n; ++i) {
      t_power *= t;
      binomial = binomial * (n - i + 1) / i;
      sum = (sum + t_power * binomial * curve(axis, i)) * u;
    }
    point[static_cast<std::size_t>(axis)] = sum + t_power * t * curve(axis, n);
  }
}

/// Distances of points of a curve of `degree` in the plane from the truth, in both tiers, and the bare point by
/// Horner-Bernstein in cpp_bin_float_50: per point, of random curves in [-1, 1].
std::vector<Comparison> reference_costs() {
  const auto inputs = draw();
  double distances = 0;  // keeps the work alive
  reference::CertifiedPoints lanes(Form::bernstein, dimension, degree);
  reference::ExactCurve exact;
  reference::PointLanes case_values{};
  for (std::size_t axis = 0; axis < computed.size(); ++axis) case_values[axis].fill(computed[axis]);
  const auto certified = [&] {
    for (std::size_t first = 0; first < inputs.size(); first += reference::CertifiedPoints::lanes) {
      for (std::size_t k = 0; k < reference::CertifiedPoints::lanes; ++k)
        lanes.load(k, inputs[first + k].true_curve(), inputs[first + k].true_t());
      lanes.evaluate();
      const auto proved = lanes.points().distances(case_values);
      for (std::size_t k = 0; k < reference::CertifiedPoints::lanes; ++k) {
        if (!std::isnan(proved[k])) {
          distances += proved[k];
          continue;
        }
        const auto curve = inputs[first + k].true_curve();
        reference::TruePoint truth(exact, curve, inputs[first + k].true_t(), lanes.point(k));
        distances += truth.distance(computed);
      }
    }
  };
  const auto integers = [&] {
    for (std::size_t k = 0; k < exact_points; ++k)
      distances += reference::Distance(exact.point(inputs[k].true_curve(), inputs[k].true_t())).to(computed);
  };
  std::array<Digits50, dimension> point;
  const auto digits50 = [&] {
    for (std::size_t k = 0; k < digits50_points; ++k) {
      horner_bernstein(inputs[k].true_curve(), inputs[k].true_t(), point);
      distances += static_cast<double>(point[0]);
    }
  };
  const auto fine = [&] { return distances != -1; };
  const std::vector<race::Rival> rivals{{"certified distance", inputs.size(), certified, fine},
                                        {"exact integers, distance", exact_points, integers, fine},
                                        {"Horner-Bernstein in cpp_bin_float_50", digits50_points, digits50, fine}};
  const auto times = race::time_rounds("reference", rivals, {});
  auto over_exact = compare(rivals[0], times[0], rivals[1], times[1]);
  over_exact.goal = certified_gain_over_exact;
  auto over_digits50 = compare(rivals[0], times[0], rivals[2], times[2]);
  over_digits50.goal = certified_gain_over_digits50;
  return {over_exact, over_digits50};
}

// The cost of judging methods against the cost of running them.

constexpr double max_ratio_to_bare = 4;

/// The accuracy study on one thread, inputs drawn and judged against the certified reference, against the evaluation of
/// its methods alone, curve by curve with their scalar kernels, on as many inputs in memory. `study` has one cell.
Comparison sweep_cost(const suite::Study& study) {
  const auto cell = sample::cells(study).front();
  const Form form = study.form;
  const auto kernels = judge::chosen_kernels<double>(study, cell);
  const auto count = static_cast<std::size_t>(study.trials);
  const sample::Sampler sampler(1, study.id, cell);
  std::vector<judge::TrialInputs<double>> inputs(count, {form, cell});
  for (std::size_t k = 0; k < count; ++k) inputs[k].draw(sampler, k);

  struct alignas(64) Block {
    std::array<std::byte, 64> bytes;
  };
  std::size_t size = 0;
  for (const auto* kernel : kernels) size = std::max(size, kernel->prepared_size);
  std::vector<Block> state(size / sizeof(Block) + 1);  // of each method in turn, so that no allocation is timed

  double sum = 0;  // keeps the work alive
  const auto bare = [&] {
    std::array<double, 3> point{};
    for (const auto& one : inputs)
      for (const auto* kernel : kernels) {
        if (!kernel->info->supports<double>(cell.degree)) continue;
        const double t = one.t();
        kernel->prepare(one.curve(), state.data());
        kernel->evaluate_for(cell.degree)(state.data(), {&t, 1}, point.data());
        if (kernel->destroy != nullptr) kernel->destroy(state.data());
        sum += point[0];
      }
  };
  const auto judged = [&] {
    const auto job = studies::make_job(study, {1, reference::Tier::certified});
    run::run_all(*job);
  };
  const auto fine = [&] { return sum != -1; };
  const std::vector<race::Rival> rivals{{study.id + ", judged", count, judged, fine},
                                        {study.id + ", bare evaluation", count, bare, fine}};
  const auto times = race::time_rounds(study.id, rivals, {.rounds = 20, .min_rounds = 5, .rival_seconds = 2});
  auto comparison = compare(rivals[0], times[0], rivals[1], times[1]);
  comparison.goal = max_ratio_to_bare;
  comparison.at_least = false;
  return comparison;
}

/// A study of the ladder cut down to one cell.
suite::Study one_cell(suite::Study study) {
  study.degree = {degree};
  study.generator.resize(1);
  study.trials = trials;
  return study;
}

bool print(const Comparison& one) {
  fmt::print("{:<38} {:>10.0f} ns   {:<38} {:>10.0f} ns   {:>7.2f} times   goal {} {:g}   {}\n", one.name, one.ns,
             one.other_name, one.other_ns, one.at_least ? one.ratio : 1 / one.ratio,
             one.at_least ? ">=" : "<=", one.goal, one.met() ? "met" : "MISSED");
  return one.met();
}

int measure(const char* ladder) {
  bool met = true;
  for (const auto& one : reference_costs()) met = print(one) && met;
  const auto suite = suite::read_suites(ladder, cli::vocabulary()).front();
  for (const auto& study : suite.studies) met = print(sweep_cost(one_cell(study))) && met;
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
