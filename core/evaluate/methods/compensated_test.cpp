// SPDX-License-Identifier: MIT
// What compensation promises: the rounded truth until the condition number nears u^-(K-1), and where it ends.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/binomial.hpp"
#include "core/convert/exact.hpp"
#include "core/evaluate/methods/compensated_de_casteljau.hpp"
#include "core/evaluate/methods/compensated_horner.hpp"
#include "core/evaluate/methods/compensated_horner_k.hpp"
#include "core/evaluate/methods/compensated_volk_schumaker.hpp"
#include "core/evaluate/methods/horner_dd.hpp"
#include "core/evaluate/via.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench {
namespace {

constexpr double u = 0x1p-53;

class Inputs {
 public:
  explicit Inputs(std::uint64_t seed) : words_(seed) {}
  double symmetric() { return static_cast<double>(static_cast<std::int64_t>(words_())) * 0x1p-63; }
  double unit() { return static_cast<double>(words_() >> 11U) * 0x1p-53; }
  int up_to(int largest) { return static_cast<int>(words_() % (static_cast<std::uint64_t>(largest) + 1)); }
  std::vector<double> coefficients(int degree) {
    std::vector<double> result(static_cast<std::size_t>(degree) + 1);
    for (double& value : result) value = symmetric();
    return result;
  }

 private:
  std::mt19937_64 words_;
};

template <class E>
double value(const std::vector<double>& coefficients, double t) {
  const int n = static_cast<int>(coefficients.size()) - 1;
  Curve<E::info.form, double, 1> curve(n);
  for (int i = 0; i <= n; ++i) curve(0, i) = coefficients[static_cast<std::size_t>(i)];
  return E::evaluate(E::prepare(curve), t)[0];
}

/// What is true of one curve at one t, rounded to double.
struct Truth {
  Truth(Form form, const std::vector<double>& coefficients, double t) {
    const CurveView<double> curve{form, 1, static_cast<int>(coefficients.size()) - 1, coefficients};
    p_tilde = reference::round_to(reference::binary64, exact_.p_tilde(curve, t).coordinate(0));
    exact = exact_.point(curve, t).coordinate(0);
    p = reference::round_to(reference::binary64, exact);
  }
  [[nodiscard]] double error_of(double computed) const {
    return reference::round_to(reference::binary64, reference::abs(reference::exactly(computed) - exact));
  }
  double p = 0;
  double p_tilde = 0;
  reference::Rational exact;

 private:
  reference::ExactCurve exact_;
};

/// The multipliers of [Hermes 2019] (the table that ends section 4.2), to first order in u.
TEST(CompensatedBound, HasTheConstantsOfHermes) {
  constexpr double tiny = 0x1p-40;  // so small that higher orders vanish, so large that nothing underflows
  for (const double n : {1.0, 2.0, 3.0, 7.0, 20.0}) {
    const double c_2 = 3 * n * (3 * n + 7) / 2;
    const double c_3 = 3 * n * (3 * n * n + 36 * n + 61) / 2;
    const double pairs = n * (n - 1) / 2;
    const double triples = pairs * (n - 2) / 3;
    const double c_4 = 81 * triples * (n - 3) / 4 + 810 * triples + 2475 * pairs + 2250 * n;
    const int degree = static_cast<int>(n);
    EXPECT_NEAR(compensated_remainder<2>(degree, tiny) / std::pow(tiny, 2) / c_2, 1, 1e-8);
    EXPECT_NEAR((compensated_remainder<3>(degree, tiny) / std::pow(tiny, 3) - 64) / c_3, 1, 1e-8);
    EXPECT_NEAR((compensated_remainder<4>(degree, tiny) / std::pow(tiny, 4) - 1296) / c_4, 1, 1e-8);
  }
}

/// The multipliers that compensated_horner_parts.hpp states, to first order in u.
TEST(CompensatedBound, OfHornerHasTheConstantsThatItStates) {
  constexpr double tiny = 0x1p-40;
  for (const double n : {1.0, 2.0, 3.0, 7.0, 20.0}) {
    const double pairs = (n + 1) * n / 2;
    const double triples = pairs * (n - 1) / 3;
    const double quadruples = triples * (n - 2) / 4;
    const int degree = static_cast<int>(n);
    const auto constant = [&]<int K>() {
      return remainder_of_parts<K, HornerRoundings>(degree, tiny) / std::pow(tiny, K);
    };
    EXPECT_NEAR(constant.operator()<2>() / (2 * n * (n + 1)), 1, 1e-8);
    EXPECT_NEAR((constant.operator()<3>() - 64) / (8 * triples + 12 * pairs), 1, 1e-8);
    EXPECT_NEAR((constant.operator()<4>() - 1296) / (16 * quadruples + 56 * triples + 48 * pairs), 1, 1e-8);
    if (degree > 1) {
      EXPECT_LE((remainder_of_parts<2, HornerRoundings>(degree, u) / u),
                CompensatedHorner::info.bound->factor(degree, u));
    }
  }
}

TEST(CompensatedBound, ImpliesThoseOfTheLiteratureAndTheTexts) {
  for (int n = 1; n <= max_degree; ++n) {
    const double gamma_3n = gamma_over_u(3 * n, u);
    EXPECT_LE(CompensatedDeCasteljau::info.bound->factor(n, u), 2 * gamma_3n * gamma_3n * u)
        << n;  // [Jiang et al. 2010]
    if (n > exact_binomial_degree) continue;
    const double gamma = gamma_over_u(3 * n + 9, u);
    EXPECT_LE(CompensatedVolkSchumaker::info.bound->factor(n, u), 2 * gamma * gamma * u) << n;
  }
}

/// 280 (t-1) (4t-3)^7, the curve of [Jiang et al. 2010] and [Hermes 2019] (section 5) scaled so that its control points
/// are integers: b_i = sum_j C(i,j) / C(8,j) q_j, where 280 / C(8,j) is an integer.
std::vector<double> near_sevenfold_root() {
  std::vector<double> q{280};
  for (int k = 0; k < 8; ++k) {
    const double root = k < 7 ? 3 : 1;
    const double slope = k < 7 ? 4 : 1;
    q.push_back(0);
    for (std::size_t j = q.size() - 1; j > 0; --j) q[j] = slope * q[j - 1] - root * q[j];
    q[0] *= -root;
  }
  const std::vector<double> of_8{1, 8, 28, 56, 70, 56, 28, 8, 1};
  std::vector<double> b;
  for (int i = 0; i <= 8; ++i) {
    double sum = 0;
    double binomial = 1;
    for (int j = 0; j <= i; ++j) {
      const auto k = static_cast<std::size_t>(j);
      sum += binomial * (q[k] / of_8[k]);
      binomial = binomial * (i - j) / (j + 1);
    }
    b.push_back(sum);
  }
  return b;
}

template <int K, class E>
void expect_relative_accuracy() {
  const auto b = near_sevenfold_root();
  const int n = 8;
  const double remainder = compensated_remainder<K>(n, u);
  const double adding = K > 2 ? gamma_over_u(K - 1, u) * u : 0;
  int kept = 0;
  int lost = 0;
  for (int step = 20; step <= 480; ++step)
    for (const double side : {-1.0, 1.0}) {
      const double t = 0.75 + side * std::pow(1.3, -step / 4.0);
      const Truth truth(Form::bernstein, b, t);
      const double error = truth.error_of(value<E>(b, t));
      const double p = std::abs(truth.p);
      EXPECT_LE(error, ((u + 3 * adding * adding) * p + remainder * truth.p_tilde) * (1 + 8 * u))
          << E::info.id << " t " << t;
      const double condition = truth.p_tilde / p;
      if (condition <= u / remainder / 4) {  // c_K u^K p~ is at most u |p| / 4
        EXPECT_LE(error, 1.26 * u * p);
        if (condition > 0.01 * u / remainder) ++kept;
      }
      if (condition > 100 * std::pow(u, -K) && error > p / 2) ++lost;
    }
  EXPECT_GE(kept, 5) << E::info.id;   // near the condition number at which the bound ends
  EXPECT_GE(lost, 50) << E::info.id;  // and past it, where nothing is left
}

TEST(Compensated, EachPartBuysAFactorUOfCondition) {
  expect_relative_accuracy<2, CompensatedDeCasteljau>();
  expect_relative_accuracy<3, CompensatedDeCasteljauK3>();
  expect_relative_accuracy<4, CompensatedDeCasteljauK4>();
}

/// [Hermes 2019], the table of section 3: for (2s-1)^3 (s-1) at s = 1/2 + 1001 u the compensated algorithm gives
/// exactly 0, since u/16 - u/16 is left; the truth is -4 (1001u)^3 + 8 (1001u)^4.
TEST(Compensated, BreaksDownWhereHermesShowsIt) {
  const std::vector<double> b{1, -0.75, 0.5, -0.25, 0};
  const double x = 1001 * u;
  const double s = 0.5 + x;
  EXPECT_EQ(value<CompensatedDeCasteljau>(b, s), 0);
  const double truth = -4 * x * x * x + 8 * x * x * x * x;
  EXPECT_NEAR(value<CompensatedDeCasteljauK3>(b, s) / truth, 1, 4 * u);
  EXPECT_NEAR(value<CompensatedDeCasteljauK4>(b, s) / truth, 1, 4 * u);
}

/// (t - 1)^n expanded, the test family of [Graillat et al. 2009]: cond = ((1+t)/|1-t|)^n.
std::vector<double> expanded_root(int n) {
  std::vector<double> q{1};
  for (int k = 1; k <= n; ++k) {
    q.push_back(0);
    for (std::size_t j = q.size() - 1; j > 0; --j) q[j] = q[j - 1] - q[j];
    q[0] = -q[0];
  }
  return q;
}

TEST(Compensated, HornerKeepsItsBoundNearAMultipleRoot) {
  Inputs inputs(13);
  for (const int n : {3, 6, 12, 25, 42}) {
    const auto q = expanded_root(n);
    for (int repeat = 0; repeat < 100; ++repeat) {
      const double t = 1 + inputs.symmetric() / 2;
      const Truth truth(Form::power, q, t);
      const double gamma = gamma_over_u(2 * n, u) * u;
      EXPECT_LE(truth.error_of(value<CompensatedHorner>(q, t)),
                (u * std::abs(truth.p) + gamma * gamma * truth.p_tilde) * (1 + 4 * u))
          << n << " t " << t;
    }
  }
}

template <int K, class E>
void expect_relative_accuracy_of_horner() {
  int kept = 0;
  int lost = 0;
  for (const int n : {5, 12, 25}) {
    const auto q = expanded_root(n);
    const double remainder = remainder_of_parts<K, HornerRoundings>(n, u);
    const double adding = gamma_over_u(K - 1, u) * u;
    for (int step = 4; step <= 160; ++step)
      for (const double side : {-1.0, 1.0}) {
        const double t = 1 + side * std::pow(1.3, -step / 2.0);
        const Truth truth(Form::power, q, t);
        const double error = truth.error_of(value<E>(q, t));
        const double p = std::abs(truth.p);
        EXPECT_LE(error, ((u + 3 * adding * adding) * p + remainder * truth.p_tilde) * (1 + 8 * u))
            << E::info.id << " degree " << n << " t " << t;
        const double condition = truth.p_tilde / p;
        if (condition <= u / remainder / 4) {  // c_K u^K p~ is at most u |p| / 4
          EXPECT_LE(error, 1.26 * u * p);
          if (condition > 0.001 * u / remainder) ++kept;
        }
        if (condition > 100 * std::pow(u, -K) && error > p / 2) ++lost;
      }
  }
  EXPECT_GE(kept, 5) << E::info.id;
  EXPECT_GE(lost, 50) << E::info.id;
}

TEST(Compensated, EachPartOfHornerBuysAFactorUOfCondition) {
  expect_relative_accuracy_of_horner<3, CompensatedHornerK3>();
  expect_relative_accuracy_of_horner<4, CompensatedHornerK4>();
}

TEST(HornerDoubleDouble, IsCorrectlyRoundedInAtLeast99PercentToDegree30) {
  using Path = Via<ExactToPowerDoubleDouble, HornerDoubleDouble>;
  Inputs inputs(14);
  for (const int fixed : {-1, 30}) {  // any degree, and the last alone
    int correct = 0;
    for (int repeat = 0; repeat < 2000; ++repeat) {
      const int n = fixed < 0 ? inputs.up_to(30) : fixed;
      const auto b = inputs.coefficients(n);
      const double t = inputs.unit();
      if (value<Path>(b, t) == Truth(Form::bernstein, b, t).p) ++correct;
    }
    EXPECT_GE(correct, 1980) << fixed;
    RecordProperty(fixed < 0 ? "to_degree_30" : "at_degree_30", correct);
  }
}

TEST(BinomialPairs, AreExactOrNearlySo) {
  for (const int n : {1, 20, 54, 57, 120, 500, 1000, max_degree}) {
    const auto pairs = binomial_pairs<double, dynamic>(n);
    const auto rounded = binomials<double, dynamic>(n);
    const auto narrow = binomial_pairs<float, dynamic>(n);
    mpz_class truth = 1;
    for (int i = 0; i <= n; ++i) {
      const reference::Rational exact{truth, 1, 0};
      const auto missed = reference::exactly(pairs.high[i]) + reference::exactly(pairs.low[i]) - exact;
      EXPECT_LE(reference::quotient(reference::binary64, reference::abs(missed), exact),
                binomial_pair_roundings(n) * u * u)
          << n << " " << i;
      const auto error = reference::exactly(rounded[i]) - exact;
      EXPECT_LE(reference::quotient(reference::binary64, reference::abs(error), exact),
                gamma_over_u(binomial_roundings(n, u), u) * u)
          << n << " " << i;
      if (n <= 54) {
        const auto rest = reference::exactly(narrow.high[i]) + reference::exactly(narrow.low[i]) - exact;
        EXPECT_LE(reference::quotient(reference::binary64, reference::abs(rest), exact), 0x1p-48) << n << " " << i;
      }
      truth = truth * (n - i) / (i + 1);
    }
  }
}

}  // namespace
}  // namespace bezierbench
