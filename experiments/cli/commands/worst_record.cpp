// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/worst_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/failure.hpp"
#include "experiments/judge/input_fields.hpp"
#include "experiments/suite/names.hpp"
#include "reference/exact_point.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::array files{
    WorstFile{"worst.csv", "worst_id", "error_u"}, WorstFile{"search.csv", "search_id", "searched_error_u"},
    WorstFile{"guarantees.csv", "guarantee_id", ""}, WorstFile{"guarantees_unstable.csv", "guarantee_id", ""}};

}  // namespace

WorstRecord::WorstRecord(bundle::CsvDocument table, std::size_t row, const WorstFile& file)
    : table_(std::move(table)), row_(row), file_(file) {}

const std::string& WorstRecord::text(std::string_view column) const { return table_.at(row_, column); }

double WorstRecord::number(std::string_view column) const {
  const auto value = number::parse_number(text(column));
  if (!value) malformed(column, "is not a number");
  return *value;
}

template <class Word>
Word WorstRecord::word(std::string_view column) const {
  const auto value = suite::parse<Word>(text(column));
  if (!value) malformed(column, "is not a known word");
  return *value;
}

int WorstRecord::count(std::string_view column, int least, int most) const {
  const auto value = number::parse_integer(text(column));
  if (!value || *value < least || *value > most)
    malformed(column, fmt::format("is not a whole number from {} to {}", least, most));
  return static_cast<int>(*value);
}

suite::ScalarKind WorstRecord::scalar() const { return word<suite::ScalarKind>("scalar"); }

sample::Cell WorstRecord::cell() const {
  sample::Cell cell;
  if (!is_about_property()) cell.form = word<Form>("form");  // properties are of Bernstein form
  cell.dimension = count("dimension", 1, reference::max_dimension);
  cell.degree = count("degree", 0, max_degree);
  return cell;
}

sample::Trial WorstRecord::input(const sample::Cell& cell) const {
  const std::string_view weights = is_about_property() ? std::string_view() : text("weights");
  const auto trial = judge::parse_input({text("t"), text("coefficients"), weights}, cell);
  if (!trial) malformed("coefficients", "weights and t are not the numbers of a curve of this degree and dimension");
  return *trial;
}

void WorstRecord::malformed(std::string_view column, std::string_view what) const {
  throw Failure(Exit::input_output, fmt::format("{}:{}: {} {}; restore the file or run the suite again",
                                                table_.file_name(), table_.line(row_), column, what));
}

WorstRecord find_worst_record(bundle::CheckedReader& bundle, const std::string& id) {
  std::vector<std::string> there;
  for (const WorstFile& file : files) {
    if (!bundle.has(file.name)) continue;
    auto table = bundle::parse_csv(bundle.read(file.name), bundle.place(file.name));
    if (file.error_u.empty() && !table.has_column(file.id)) continue;  // of a program that gave these rows no ids
    const std::size_t rows = table.row_count();
    for (std::size_t row = 0; row < rows; ++row)
      if (table.at(row, file.id) == id) return {std::move(table), row, file};
    if (rows > 0)
      there.push_back(fmt::format("{} to {} in {}", table.at(0, file.id), table.at(rows - 1, file.id), file.name));
  }
  if (there.empty())
    throw Failure(Exit::usage,
                  fmt::format("{}: has no inputs with an id (worst.csv, search.csv, guarantees.csv); name a "
                              "bundle that has",
                              bundle.path().string()));
  throw Failure(Exit::usage, fmt::format("{}: no such id in {}; there are {}, see worst_id, search_id and guarantee_id",
                                         id, bundle.path().string(), fmt::join(there, ", ")));
}

}  // namespace bezierbench::cli
