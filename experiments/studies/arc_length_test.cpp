// SPDX-License-Identifier: MIT
#include "experiments/studies/arc_length.hpp"

#include <gtest/gtest.h>

#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_study() {
  suite::Study study;
  study.id = "small";
  study.kind = suite::Kind::arc_length;
  study.degree = {3};
  study.coordinate_range = {1};
  study.t_interval = {{0, 1}, {0.25, 0.75}};
  study.generator = {"continuous", "integer"};  // small whole numbers: cusps, turns, points
  study.tolerance = {1e-3, 1e-9};
  study.trials = 20;  // two blocks, the last one short
  return study;
}

std::string text_of(const Job& job) {
  Tables tables;
  job.write(tables);
  return tables.all().at("arc_length.csv").text();
}

TEST(ArcLengthStudy, OrderAndInterruptionsChangeNoByteAndPromisesAreKept) {
  const auto plain = arc_length_job(small_study(), {1});
  run_all(*plain);
  const auto backwards = arc_length_job(small_study(), {1});
  for (std::size_t block = backwards->blocks(); block-- > 0;) {
    number::ByteWriter writer;
    backwards->run_block(block)->save(writer);
    number::ByteReader reader(writer.bytes());
    backwards->add(backwards->part_of(block), backwards->read_result(reader));
    reader.finish();
  }
  EXPECT_EQ(text_of(*plain), text_of(*backwards));
  EXPECT_TRUE(plain->violations().empty());
  const auto csv = bundle::parse_csv(text_of(*plain), "arc_length.csv");
  ASSERT_EQ(csv.row_count(), 2U * 2 * 2 * 4);
  EXPECT_EQ(plain->extent().rows, csv.row_count());
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "broken_promises"), "0");
    EXPECT_EQ(csv.at(row, "non_finite"), "0");
    const double tolerance = *number::parse_number(csv.at(row, "tolerance"));
    if (csv.at(row, "non_converged") == "0") {
      EXPECT_LE(*number::parse_number(csv.at(row, "max_relative")), tolerance * 1.001);
    }
  }
}

TEST(ArcLengthStudy, RefusesWhatItCannotDo) {
  auto polynomial = small_study();
  polynomial.curve = suite::CurveKind::polynomial;
  EXPECT_THROW(arc_length_job(polynomial, {1}), Failure);
  auto single = small_study();
  single.scalar = {suite::ScalarKind::float32};
  EXPECT_THROW(arc_length_job(single, {1}), Failure);
  auto outside = small_study();
  outside.t_interval = {{-1, 1}};
  EXPECT_THROW(arc_length_job(outside, {1}), Failure);
  auto evaluator = small_study();
  evaluator.methods = {"de_casteljau"};
  EXPECT_THROW(arc_length_job(evaluator, {1}), Failure);
}

}  // namespace
}  // namespace bezierbench::studies
