// SPDX-License-Identifier: MIT
#include "experiments/metric/order_statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <vector>

#include "reference/rational.hpp"

namespace bezierbench::metric {
namespace {

std::vector<double> sorted(std::span<const double> sample) {
  std::vector<double> values(sample.begin(), sample.end());
  std::ranges::sort(values);
  return values;
}

double median_of_sorted(const std::vector<double>& values) {
  const std::size_t count = values.size();
  return count % 2 != 0 ? values[count / 2] : (values[count / 2 - 1] + values[count / 2]) / 2;
}

}  // namespace

double median(std::span<const double> sample) { return median_of_sorted(sorted(sample)); }

double quantile(std::span<const double> sample, double q) {
  const auto values = sorted(sample);
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

Interval median_interval(std::span<const double> sample, double confidence) {
  const auto values = sorted(sample);
  const std::size_t count = values.size();
  const boost::math::binomial_distribution<double> half(static_cast<double>(count), 0.5);
  std::size_t below = 0;  // order statistics that can be left out at each end
  while (2 * (below + 1) < count && cdf(half, static_cast<double>(below)) <= (1 - confidence) / 2) ++below;
  return {median_of_sorted(values), values[below == 0 ? 0 : below - 1], values[count - (below == 0 ? 1 : below)]};
}

Ranks quantile_ranks(std::size_t count, unsigned long part, unsigned long exceptions) {
  mpz_class total;
  mpz_ui_pow_ui(total.get_mpz_t(), part, count);
  mpz_class term;  // C(count, k) (part - 1)^(count - k): `total` times the probability that k values are below
  mpz_ui_pow_ui(term.get_mpz_t(), part - 1, count);
  mpz_class fewer = 0;  // the sum of the terms before
  Ranks ranks{0, 0};
  for (std::size_t k = 0;; ++k) {
    if (fewer * exceptions <= total) ranks.low = k;
    ranks.high = k;
    if ((total - fewer) * exceptions <= total) return ranks;
    fewer += term;
    term *= count - k;
    mpz_divexact_ui(term.get_mpz_t(), term.get_mpz_t(), (k + 1) * (part - 1));
  }
}

bool covers_median(std::size_t count, double confidence) {
  return std::ldexp(2.0, -static_cast<int>(count)) <= 1 - confidence;
}

}  // namespace bezierbench::metric
