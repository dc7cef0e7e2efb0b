// SPDX-License-Identifier: MIT
#include "experiments/sample/draw.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/failure.hpp"
#include "experiments/sample/bspline.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/sample/cusp.hpp"
#include "experiments/sample/roots.hpp"
#include "experiments/sample/roster.hpp"
#include "experiments/sample/thin.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::sample {

namespace {

/// The parts between separators. An empty line has none; other lines may have empty parts.
std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  if (line.ends_with(separator)) parts.emplace_back();
  return parts;
}

double number(const std::string& text) { return number::parse_number(text).value(); }

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

void expect_bits(const std::vector<double>& values, const std::vector<std::string>& texts) {
  ASSERT_EQ(values.size(), texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(bits(values[i]), bits(number(texts[i]))) << i;
}

Trial drawn(std::uint64_t seed, const char* study, const Cell& cell, std::uint64_t trial) {
  Trial out;
  Sampler(seed, study, cell).draw(trial, out);
  return out;
}

Cell cell_of(std::string_view generator, double range = 1e6, suite::Interval t = {}) {
  return {Form::bernstein, 2, 4, range, t, std::string(generator)};
}

// scripts/oracle/inputs.py, which shares no code with this program, makes this file.
TEST(Draw, AgreesWithTheIndependentImplementation) {
  std::ifstream file(BEZIERBENCH_SOURCE_DIR "/experiments/sample/first_draws.csv");
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  const std::vector<std::string> header = split(line, ',');
  std::set<std::string> seen;
  int rows = 0;
  for (; std::getline(file, line); ++rows) {
    const std::vector<std::string> fields = split(line, ',');
    ASSERT_EQ(fields.size(), header.size());
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = fields[i];
    SCOPED_TRACE(row["study"] + " " + row["generator"] + " " + row["trial"]);
    const Cell cell{suite::parse<Form>(row["form"]).value(),
                    std::stoi(row["dimension"]),
                    std::stoi(row["degree"]),
                    number(row["coordinate_range"]),
                    {number(row["t_min"]), number(row["t_max"])},
                    row["generator"]};
    Trial trial;
    draw(1, key(std::string_view(row["study"])), cell, std::stoull(row["trial"]), trial);
    EXPECT_EQ(bits(trial.t), bits(number(row["t"])));
    expect_bits(trial.coefficients, split(row["coefficients"], ' '));
    expect_bits(trial.weights, split(row["weights"], ' '));
    seen.insert(cell.generator);
  }
  EXPECT_GE(rows, 30);
  for (const GeneratorInfo& info : generators()) EXPECT_TRUE(seen.contains(std::string(info.id))) << info.id;
}

TEST(Draw, IsAPureFunctionThatReusesMemory) {
  const Cell cell = cell_of("continuous");
  const Trial first = drawn(1, "a", cell, 7);
  const Sampler sampler(1, "a", cell);
  Trial again;
  for (const std::uint64_t other : {9U, 0U, 7U}) sampler.draw(other, again);
  EXPECT_EQ(again.t, first.t);
  EXPECT_EQ(again.coefficients, first.coefficients);
  const double* memory = again.coefficients.data();
  sampler.draw(8, again);
  EXPECT_EQ(again.coefficients.data(), memory);
  EXPECT_NE(again.coefficients, first.coefficients);
}

TEST(Draw, EveryPartOfTheIdentityCounts) {
  const Cell cell = cell_of("continuous", 1, {0, 1});
  const double t = drawn(1, "a", cell, 0).t;
  EXPECT_NE(drawn(2, "a", cell, 0).t, t);
  EXPECT_NE(drawn(1, "b", cell, 0).t, t);
  EXPECT_NE(drawn(1, "a", cell, 1).t, t);
  for (const auto& change :
       std::vector<void (*)(Cell&)>{[](Cell& c) { c.form = Form::power; }, [](Cell& c) { c.dimension = 3; },
                                    [](Cell& c) { c.degree = 5; }, [](Cell& c) { c.coordinate_range = 2; },
                                    [](Cell& c) {
                                      c.t_interval = {0, 0.999};
                                    },
                                    [](Cell& c) { c.generator = "dyadic"; }}) {
    Cell other = cell;
    change(other);
    EXPECT_NE(key(other), key(cell));
    EXPECT_NE(drawn(1, "a", other, 0).t, t) << canonical(other);
  }
}

TEST(Draw, UnknownGeneratorIsAUsageError) {
  try {
    Sampler(1, "a", cell_of("gaussian"));
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::usage);
    EXPECT_THAT(failure.what(), ::testing::HasSubstr("\"gaussian\""));
  }
}

template <class G>
class GeneratorTest : public ::testing::Test {};

template <class>
struct AsTypes;
template <class... Gs>
struct AsTypes<std::tuple<Gs...>> {
  using type = ::testing::Types<Gs...>;
};
TYPED_TEST_SUITE(GeneratorTest, AsTypes<Generators>::type);

TYPED_TEST(GeneratorTest, HasWeightsForRationalCurvesWhereItSaysSo) {
  Cell cell = cell_of(TypeParam::info.id, 1);
  EXPECT_TRUE(drawn(1, "a", cell, 0).weights.empty());
  EXPECT_EQ(TypeParam::info.limits.weights, !TypeParam::info.weights.empty());
  if (!TypeParam::info.limits.weights) return;
  cell.form = Form::rational;
  EXPECT_EQ(drawn(1, "a", cell, 0).weights.size(), 5U);
}

TYPED_TEST(GeneratorTest, ReplacesTheTrialOfAnotherSampler) {
  Cell weighted = cell_of("weights_mild", 1);
  weighted.form = Form::rational;
  Trial trial = drawn(1, "a", weighted, 0);
  const Sampler sampler(1, "a", cell_of(TypeParam::info.id, 1));
  sampler.draw(0, trial);
  EXPECT_EQ(trial.coefficients, drawn(1, "a", cell_of(TypeParam::info.id, 1), 0).coefficients);
  EXPECT_TRUE(trial.weights.empty());
}

TEST(Dyadic, OneMinusTIsExact) {
  const Sampler sampler(1, "a", cell_of("dyadic", 1, {0, 1}));
  const Sampler narrow(1, "a", cell_of("dyadic", 1, {-0x1p-50, 0x1p-50}));
  Trial trial;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    for (const Sampler* s : {&sampler, &narrow}) {
      s->draw(i, trial);
      const double scaled = trial.t * 0x1p53;
      ASSERT_EQ(scaled, std::trunc(scaled));
      ASSERT_FALSE(trial.t == 0 && std::signbit(trial.t));
      // t = 1 - (1 - t) holds for every multiple of 2^-53 in [0, 1], and for none in between.
      if (trial.t >= 0) {
        ASSERT_EQ(1 - (1 - trial.t), trial.t);
      }
    }
  }
}

TEST(Draw, ARangeOfZeroGivesZeros) {
  for (const char* generator : {"continuous", "dyadic", "report"}) {
    for (const double x : drawn(1, "a", cell_of(generator, 0), 0).coefficients) EXPECT_EQ(x, 0);
  }
}

}  // namespace

namespace {

// Known answers of FNV-1a, 64 bits (Fowler, Noll, Vo; RFC 9923).
TEST(Key, IsFnv1a) {
  EXPECT_EQ(key(std::string_view("")), 0xcbf29ce484222325U);
  EXPECT_EQ(key(std::string_view("a")), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(key(std::string_view("foobar")), 0x85944171f73967e8U);
}

TEST(Cell, HasACanonicalText) {
  const Cell cell{Form::power, 2, 4, 1e6, {0.25, 1}, "dyadic"};
  const std::string text =
      "curve=polynomial;dimension=2;degree=4;coordinate_range=1e+06;t_interval=0.25:1;generator=dyadic";
  EXPECT_EQ(canonical(cell), text);
  EXPECT_EQ(key(cell), key(std::string_view(text)));
}

TEST(Cell, CellsAreTheCrossProductInOrder) {
  suite::Study study;
  study.form = Form::power;
  study.dimension = {2, 3};
  study.degree = {4, 8};
  study.coordinate_range = {1, 10};
  study.t_interval = {{0, 1}, {0, 0.2}};
  study.generator = {"report", "continuous"};
  const std::vector<Cell> all = cells(study);
  ASSERT_EQ(all.size(), 32U);
  const suite::Interval unit{0, 1};
  const suite::Interval fifth{0, 0.2};
  EXPECT_EQ(all[0], (Cell{Form::power, 2, 4, 1, unit, "report"}));
  EXPECT_EQ(all[1], (Cell{Form::power, 2, 4, 1, unit, "continuous"}));
  EXPECT_EQ(all[2], (Cell{Form::power, 2, 4, 1, fifth, "report"}));
  EXPECT_EQ(all[4], (Cell{Form::power, 2, 4, 10, unit, "report"}));
  EXPECT_EQ(all[8], (Cell{Form::power, 2, 8, 1, unit, "report"}));
  EXPECT_EQ(all[16], (Cell{Form::power, 3, 4, 1, unit, "report"}));
  std::set<std::uint64_t> keys;
  for (const Cell& cell : all) keys.insert(key(cell));
  EXPECT_EQ(keys.size(), all.size());
}

}  // namespace

// Generators of whole curves: bspline, cusp (its cusp is exactly where it should be, computed with rationals) and thin.

namespace {

Trial drawn(int degree, double range, std::uint64_t trial) {
  Trial out;
  Sampler(1, "spline", {Form::bernstein, 2, degree, range, {}, "bspline"}).draw(trial, out);
  return out;
}

TEST(BsplineGenerator, StaysInItsRange) {
  for (const int degree : {0, 1, 2, 7, 50})
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
      for (const double x : drawn(degree, 3, trial).coefficients) EXPECT_LE(std::abs(x), 3);
      for (const double x : drawn(degree, 0, trial).coefficients) EXPECT_EQ(x, 0);
    }
}

/// Neighbours in the Bernstein form are averages of the same points: sums of differences are smaller than those of
/// random points, whose mean is 2/3 of the range on each axis.
TEST(BsplineGenerator, NeighboursAreCloserThanRandomPoints) {
  double sum = 0;
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    const auto b = drawn(5, 1, trial).coefficients;
    for (std::size_t k = 2; k < b.size(); ++k) sum += std::abs(b[k] - b[k - 2]);
  }
  EXPECT_LT(sum / (200 * 10), 0.25);
}

using ExactRational = boost::multiprecision::cpp_rational;

/// C'(t) / n on one axis, by de Casteljau's algorithm.
ExactRational slope(const std::vector<double>& coordinates, std::size_t d, std::size_t axis, const ExactRational& t) {
  std::vector<ExactRational> row;
  for (std::size_t k = axis + d; k < coordinates.size(); k += d)
    row.push_back(ExactRational(coordinates[k]) - ExactRational(coordinates[k - d]));
  for (; row.size() > 1; row.pop_back())
    for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] += t * (row[i + 1] - row[i]);
  return row.front();
}

TEST(Cusp, StopsExactlyOrNearlyAtEveryDegree) {
  for (int n = 2; n <= Cusp::largest_degree; ++n) {
    std::set<int> places;
    int exact = 0;
    constexpr int trials = 400;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      const double range = trial % 2 == 0 ? 1 : 0x1p-700;
      Trial out;
      draw(1, 2, {Form::bernstein, 3, n, range, {}, "cusp"}, trial, out);
      ExactRational least = 1;
      int place = 0;
      for (int quarters = 1; quarters <= 8; ++quarters) {
        ExactRational most = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
          most = std::max(most,
                          ExactRational(abs(slope(out.coefficients, 3, axis, ExactRational(quarters, quarters + 4)))));
        most /= ExactRational(range);
        if (most < least) place = quarters;
        least = std::min(least, most);
      }
      EXPECT_LE(least, ExactRational(1, 32)) << n << " " << trial;
      places.insert(place);
      exact += least == 0 ? 1 : 0;
      for (const double x : out.coefficients) EXPECT_LE(std::abs(x), range);
    }
    EXPECT_EQ(places.size(), 8U) << n;
    EXPECT_NEAR(exact, trials / 2, 50) << n;  // five standard deviations
  }
}

TEST(Cusp, OfDegreesWithoutAnInsideIsAPoint) {
  Trial out;
  draw(1, 2, {Form::bernstein, 2, 0, 1, {}, "cusp"}, 0, out);
  EXPECT_EQ(out.coefficients.size(), 2U);
  draw(1, 2, {Form::bernstein, 1, 1, 1, {}, "cusp"}, 0, out);
  EXPECT_LE(std::abs(out.coefficients[0] - out.coefficients[1]), 1.0 / 32);
}

TEST(Thin, IsWholeOnTheFirstAxisAndNextToNothingOnOthers) {
  constexpr int trials = 400;
  int zigzags = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    Trial out;
    draw(1, 2, {Form::bernstein, 3, 5, 0x1p-700, {}, "thin"}, trial, out);
    bool zigzag = true;
    for (std::size_t k = 0; k < out.coefficients.size(); ++k) {
      const double x = std::ldexp(out.coefficients[k], 700 + 5);
      if (k % 3 == 0) {
        EXPECT_EQ(x, std::round(x)) << trial;
        EXPECT_LE(std::abs(x), 32) << trial;
        zigzag = zigzag && (k / 3 % 2 == 0 ? x <= 0 : x >= 0);
      } else {
        EXPECT_EQ(std::ldexp(x, 20), std::round(std::ldexp(x, 20))) << trial;
        EXPECT_LE(std::abs(x), 2) << trial;
      }
    }
    zigzags += zigzag ? 1 : 0;
  }
  EXPECT_NEAR(zigzags, trials / 2 + trials / 128, 55);  // one in 64 of the other curves zigzags by chance
}

TEST(Thin, OnOneAxisIsWhole) {
  Trial out;
  draw(1, 2, {Form::bernstein, 1, 40, 32, {}, "thin"}, 7, out);
  for (const double x : out.coefficients) EXPECT_EQ(x, std::round(x));
}

}  // namespace

// The generators of roots have exactly the coefficients of the intended polynomial: computed with rationals.

namespace {

using Exact = boost::multiprecision::cpp_rational;

constexpr std::array curves{Form::bernstein, Form::power};

Exact power(const Exact& base, int exponent) {
  Exact value = 1;
  for (int k = 0; k < exponent; ++k) value *= base;
  return value;
}

Exact binomial(int n, int i) {
  Exact value = 1;
  for (int k = 0; k < i; ++k) value = value * (n - k) / (k + 1);
  return value;
}

/// The value of the curve at t, from the definition of the basis functions.
Exact value_at(const Exact& t, Form curve, const std::vector<double>& coefficients) {
  const int n = static_cast<int>(coefficients.size()) - 1;
  Exact value = 0;
  for (int i = 0; i <= n; ++i) {
    const Exact basis = curve == Form::power ? power(t, i) : binomial(n, i) * power(t, i) * power(1 - t, n - i);
    value += Exact(coefficients[static_cast<std::size_t>(i)]) * basis;
  }
  return value;
}

std::vector<double> drawn(const GeneratorInfo& info, Form curve, int degree, double range, std::uint64_t trial) {
  Trial out;
  draw(1, 2, {curve, 1, degree, range, {}, std::string(info.id)}, trial, out);
  return out.coefficients;
}

int largest_degree(const GeneratorInfo& info, Form curve) {
  return curve == Form::power ? info.limits.polynomial_degree : info.limits.bezier_degree;
}

// n + 1 values determine a polynomial of degree n.
TEST(MultipleRoot, IsThatPolynomialAtEveryDegree) {
  for (const Form curve : curves) {
    for (int n = 0; n <= largest_degree(MultipleRoot::info, curve); ++n) {
      for (const double range : {1.0, 0x1p-900, 0x1p900}) {
        const auto coefficients = drawn(MultipleRoot::info, curve, n, range, 0);
        for (int k = 0; k <= n; ++k) {
          ASSERT_EQ(value_at(Exact(k), curve, coefficients), Exact(range) * power(Exact(k) - Exact(3, 4), n))
              << n << " " << range;
        }
      }
    }
  }
}

/// The factor that clears the denominators C(n,i): lcm C(n,i) = lcm(1, ..., n+1) / (n+1).
std::int64_t common_multiple(int n) {
  std::int64_t multiple = 1;
  for (std::int64_t k = 1; k <= n + 1; ++k) multiple = std::lcm(multiple, k);
  return multiple / (n + 1);
}

/// The common multiple over the next power of two, so that R remains the scale.
Exact lambda(int n) {
  Exact value = common_multiple(n);
  while (value > 1) value /= 2;
  return value;
}

// n roots and the value at 2 determine a polynomial of degree n.
TEST(ClusteredRoots, HasItsRootsOnTheLatticeAtEveryDegree) {
  for (const Form curve : curves) {
    for (int n = 0; n <= ClusteredRoots::largest_degree; ++n) {
      const Exact step = 1 / power(2, ClusteredRoots::lattice_bits(n));
      for (std::uint64_t trial = 0; trial < 20; ++trial) {
        const double range = std::ldexp(1, static_cast<int>(trial) * 90 - 900);
        const auto coefficients = drawn(ClusteredRoots::info, curve, n, range, trial);
        Exact at_two = Exact(range) * lambda(n);
        int roots = 0;
        for (int k = -n; k <= n; ++k) {
          const Exact root = Exact(1, 2) + k * step;
          if (value_at(root, curve, coefficients) != 0) continue;
          at_two *= 2 - root;
          ++roots;
        }
        ASSERT_EQ(roots, n) << trial;
        ASSERT_EQ(value_at(2, curve, coefficients), at_two) << n;
      }
    }
  }
}

TEST(RootGenerators, GiveEveryAxisTheSamePolynomial) {
  for (const GeneratorInfo& info : {MultipleRoot::info, ClusteredRoots::info}) {
    Trial trial;
    draw(1, 2, {Form::bernstein, 3, 4, 1, {}, std::string(info.id)}, 0, trial);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NE(trial.coefficients[3 * i], 0);
      EXPECT_EQ(trial.coefficients[3 * i + 1], trial.coefficients[3 * i]);
      EXPECT_EQ(trial.coefficients[3 * i + 2], trial.coefficients[3 * i]);
    }
    const std::vector<double> axis{trial.coefficients[0], trial.coefficients[3], trial.coefficients[6],
                                   trial.coefficients[9], trial.coefficients[12]};
    EXPECT_EQ(value_at(Exact(info.id == MultipleRoot::info.id ? 3 : 2, 4), Form::bernstein, axis), 0);
  }
}

}  // namespace

}  // namespace bezierbench::sample
