// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/curve_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::string_view weight_name = "w";

/// The indices of a file's columns.
struct Columns {
  std::vector<std::size_t> axes;
  std::optional<std::size_t> weight;
};

/// The columns of a header x | x,y | x,y,z, with or without w, in any order.
Columns columns_of(const bundle::CsvDocument& csv) {
  Columns columns{axis_columns(csv), std::nullopt};
  if (csv.has_column(weight_name)) columns.weight = csv.column(weight_name);
  if (columns.axes.empty() || columns.axes.size() + (columns.weight ? 1 : 0) != csv.header().size())
    refuse_header(csv, "x, or x,y, or x,y,z, and w for the weights of a rational curve");
  return columns;
}

}  // namespace

CurveFile parse_curve(std::string_view text, const std::string& file_name, Form form) {
  const auto csv = bundle::parse_csv(text, file_name);
  const auto columns = columns_of(csv);
  CurveFile curve{columns.weight ? Form::rational : form, static_cast<int>(columns.axes.size()), {}, {}};
  if (columns.weight && form != Form::bernstein)
    throw Failure(Exit::usage,
                  fmt::format("--form {}: {} has weights (column w), which belong to control points; leave "
                              "--form out, it must be bernstein",
                              name(form), file_name));
  if (csv.row_count() == 0)
    throw Failure(Exit::input_output, fmt::format("{}: no coefficients; write one per row", file_name));
  if (csv.row_count() > static_cast<std::size_t>(max_degree) + 1)
    throw Failure(Exit::input_output,
                  fmt::format("{}: {} coefficients; the largest degree is {}", file_name, csv.row_count(), max_degree));
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    for (const auto column : columns.axes) curve.coefficients.push_back(number_at(csv, row, column));
    if (columns.weight) curve.weights.push_back(number_at(csv, row, *columns.weight));
  }
  if (columns.weight && std::ranges::all_of(curve.weights, [](double weight) { return weight == 0; }))
    throw Failure(Exit::input_output,
                  fmt::format("{}:{}: rows 1 to {}, column w: every weight is 0; one of them must not be", file_name,
                              csv.line(0), csv.row_count()));
  return curve;
}

CurveFile read_curve(const std::filesystem::path& file, Form form) {
  return parse_curve(bundle::read_file(file), file.string(), form);
}

std::string curve_csv(const CurveFile& curve) {
  std::vector<std::string> header;
  for (int axis = 0; axis < curve.dimension; ++axis) header.push_back(axis_name(axis));
  bundle::CsvTable table(header);
  for (int i = 0; i <= curve.degree(); ++i) {
    std::vector<std::string> row;
    for (int axis = 0; axis < curve.dimension; ++axis) row.push_back(number::decimal(curve.view()(axis, i)));
    table.add_row(std::move(row));
  }
  return table.text();
}

}  // namespace bezierbench::cli
