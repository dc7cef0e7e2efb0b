// SPDX-License-Identifier: MIT
// Tables: a text that can be read is written, and the written text reads as an equal table.
#include "experiments/bundle/csv.hpp"
#include "experiments/fuzzing/property.hpp"

namespace bezierbench::bundle {
namespace {

void check(std::string_view text) {
  CsvDocument table;
  if (!fuzzing::reads(Exit::input_output, [&] { table = parse_csv(text, fuzzing::file_name); })) return;
  CsvTable written(table.header());
  for (std::size_t row = 0; row < table.row_count(); ++row) written.add_row(table.row(row));
  const CsvDocument again = parse_csv(written.text(), fuzzing::file_name);
  fuzzing::require(again.header() == table.header() && again.row_count() == table.row_count(),
                   "a table keeps its size");
  for (std::size_t row = 0; row < table.row_count(); ++row)
    fuzzing::require(again.row(row) == table.row(row) && table.line(row) > row, "a row reads back");
}

}  // namespace
}  // namespace bezierbench::bundle

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  bezierbench::bundle::check(bezierbench::fuzzing::text_of(bytes, size));
  return 0;
}
