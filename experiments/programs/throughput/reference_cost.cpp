// SPDX-License-Identifier: MIT
#include "experiments/programs/throughput/reference_cost.hpp"

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "experiments/judge/trial_inputs.hpp"
#include "experiments/sample/draw.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::throughput {
namespace {

using Digits50 = boost::multiprecision::cpp_bin_float_50;
using Inputs = judge::TrialInputs<double>;

constexpr int dimension = 2;
constexpr std::size_t certified_points = 1024;
constexpr std::size_t exact_points = 64;
constexpr std::size_t digits50_points = 16;
constexpr double certified_gain_over_digits50 = 80;
constexpr double certified_gain_over_exact = 20;
constexpr std::array<double, dimension> computed{0.25, -0.125};  // the point whose distance is asked for

std::vector<Inputs> draw(int degree) {
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

}  // namespace

std::vector<Comparison> reference_costs(int degree) {
  const auto inputs = draw(degree);
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
  const auto laps = race::race("reference", rivals, {});
  auto over_exact = compare(rivals[0], laps[0], rivals[1], laps[1]);
  over_exact.goal = certified_gain_over_exact;
  auto over_digits50 = compare(rivals[0], laps[0], rivals[2], laps[2]);
  over_digits50.goal = certified_gain_over_digits50;
  return {over_exact, over_digits50};
}

}  // namespace bezierbench::throughput
