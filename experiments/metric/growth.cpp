// SPDX-License-Identifier: MIT
#include "experiments/metric/growth.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace bezierbench::metric {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

std::optional<Growth> growth(std::span<const double> degrees, std::span<const double> costs, double confidence) {
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    if (!(degrees[k] > 0 && costs[k] > 0 && std::isfinite(degrees[k]) && std::isfinite(costs[k]))) continue;
    x.push_back(std::log(degrees[k]));
    y.push_back(std::log(costs[k]));
  }
  if (std::set<double>(x.begin(), x.end()).size() < 3) return std::nullopt;

  const double x_mean = mean(x);
  const double y_mean = mean(y);
  double s_xx = 0;
  double s_xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    s_xx += (x[k] - x_mean) * (x[k] - x_mean);
    s_xy += (x[k] - x_mean) * (y[k] - y_mean);
  }
  const double exponent = s_xy / s_xx;
  double s_rr = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double residual = y[k] - y_mean - exponent * (x[k] - x_mean);
    s_rr += residual * residual;
  }
  const double freedom = static_cast<double>(x.size()) - 2;
  const boost::math::students_t_distribution<double> student(freedom);
  const double reach = quantile(complement(student, (1 - confidence) / 2)) * std::sqrt(s_rr / (freedom * s_xx));
  return Growth{exponent, exponent - reach, exponent + reach};
}

}  // namespace bezierbench::metric
