// SPDX-License-Identifier: MIT
// What the tests of all studies share: a job is done in any order, through its bytes, to the same files.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "experiments/bundle/csv.hpp"
#include "experiments/run/job.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::run {

using MakeJob = std::unique_ptr<Job> (*)(const suite::Study& study, const JobContext& context);

/// The files that a job writes, by name.
inline std::map<std::string, std::string> text_of(const Job& job) {
  tables::Tables tables;
  job.write(tables);
  std::map<std::string, std::string> texts;
  for (const auto& [file, table] : tables.all()) texts[file] = table.text();
  return texts;
}

/// Does all blocks forwards, then backwards and through their bytes; returns the files.
inline std::map<std::string, std::string> expect_order_changes_nothing(MakeJob make, const suite::Study& study) {
  const auto plain = make(study, {1});
  run_all(*plain);
  const auto backwards = make(study, {1});
  for (std::size_t block = backwards->blocks(); block-- > 0;) {
    number::ByteWriter writer;
    backwards->run_block(block)->save(writer);
    number::ByteReader reader(writer.bytes());
    backwards->add(backwards->part_of(block), backwards->read_result(reader));
    reader.finish();
  }
  EXPECT_EQ(text_of(*plain), text_of(*backwards));
  EXPECT_TRUE(
      std::ranges::equal(plain->series(), backwards->series(), {}, &tables::Series::values, &tables::Series::values));
  EXPECT_TRUE(plain->violations().empty());
  return text_of(*plain);
}

/// The number in a field that is one.
inline double number_at(const bundle::CsvDocument& csv, std::size_t row, std::string_view column) {
  return *number::parse_number(csv.at(row, column));
}

}  // namespace bezierbench::run
