// SPDX-License-Identifier: MIT
#include "reference/companion/exact_control_points.hpp"

#include <algorithm>
#include <utility>

#include "reference/rational.hpp"
#include "reference/stop.hpp"

namespace bezierbench::reference {
namespace {

using Column = std::vector<Rational>;  // a number for each control point

/// The numerators w_i b_i of each axis, then of a rational curve the weights.
std::vector<Column> columns_of(const CurveView<double>& curve) {
  const bool is_rational = curve.form == Form::rational;
  std::vector<Column> columns(static_cast<std::size_t>(curve.dimension) + (is_rational ? 1 : 0));
  for (int i = 0; i <= curve.degree; ++i) {
    const Rational w = exactly(is_rational ? curve.weights[static_cast<std::size_t>(i)] : 1);
    for (int axis = 0; axis < curve.dimension; ++axis)
      columns[static_cast<std::size_t>(axis)].push_back(exactly(curve(axis, i)) * w);
    if (is_rational) columns.back().push_back(w);
  }
  return columns;
}

std::optional<RoundedControlPoints> rounded(const std::vector<Column>& columns, int dimension) {
  RoundedControlPoints result;
  const bool is_rational = columns.size() > static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    const Rational w = is_rational ? columns.back()[i] : exactly(1);
    if (round_to(binary64, w) == 0) return std::nullopt;
    for (int axis = 0; axis < dimension; ++axis)
      result.points.push_back(quotient(binary64, columns[static_cast<std::size_t>(axis)][i], w));
    if (is_rational) result.weights.push_back(round_to(binary64, w));
  }
  return result;
}

/// Replaces the first k + 1 numbers by the k of the next level of de Casteljau's triangle.
void step(Column& b, std::size_t k, const Rational& s, const Rational& t) {
  StopWhen::poll();
  for (std::size_t j = 0; j < k; ++j) b[j] = s * b[j] + t * b[j + 1];
}

Column part(Column level, const Rational& from, const Rational& to) {
  const Rational before_from = exactly(1) - from;
  const Rational before_to = exactly(1) - to;
  Column result(level.size());
  for (std::size_t i = level.size(); i-- > 0;) {  // `level` has n - i arguments `from` and i + 1 numbers
    auto b = level;
    for (std::size_t k = i; k > 0; --k) step(b, k, before_to, to);
    result[i] = std::move(b.front());
    step(level, i, before_from, from);
    level.resize(std::max<std::size_t>(i, 1));
  }
  return result;
}

Column elevated(const Column& b, int degree) {
  const auto n = static_cast<unsigned long>(b.size() - 1);
  const auto more = static_cast<unsigned long>(degree) - n;
  const auto choose = [](unsigned long of, unsigned long count) {
    mpz_class binomial;
    mpz_bin_uiui(binomial.get_mpz_t(), of, count);
    return binomial;
  };
  Column result;
  for (unsigned long i = 0; i <= n + more; ++i) {
    StopWhen::poll();
    Rational sum;
    for (unsigned long j = i > more ? i - more : 0; j <= std::min(i, n); ++j)
      sum = sum + Rational{choose(n, j) * choose(more, i - j), 1, 0} * b[j];
    sum.denominator = choose(n + more, i);
    result.push_back(sum);
  }
  return result;
}

}  // namespace

std::optional<RoundedControlPoints> control_points_of_part(const CurveView<double>& curve, double from, double to) {
  auto columns = columns_of(curve);
  for (auto& column : columns) column = part(std::move(column), exactly(from), exactly(to));
  return rounded(columns, curve.dimension);
}

std::optional<RoundedControlPoints> elevated_control_points(const CurveView<double>& curve, int degree) {
  auto columns = columns_of(curve);
  for (auto& column : columns) column = elevated(column, degree);
  return rounded(columns, curve.dimension);
}

}  // namespace bezierbench::reference
