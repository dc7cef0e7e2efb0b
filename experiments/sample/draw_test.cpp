// SPDX-License-Identifier: MIT
#include "experiments/sample/draw.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "experiments/failure.hpp"
#include "experiments/sample/roster.hpp"
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
}  // namespace bezierbench::sample
