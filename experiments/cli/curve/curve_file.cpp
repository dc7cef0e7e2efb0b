// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/curve_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <unordered_set>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

/// Whether a line has numbers only, separated in any way that data are found in.
bool has_numbers_only(std::string_view line) {
  constexpr std::string_view separators = ",; \t\r()[]{}";
  auto begin = line.find_first_not_of(separators);
  const bool any = begin != std::string_view::npos;
  while (begin != std::string_view::npos) {
    const auto end = std::min(line.find_first_of(separators, begin), line.size());
    if (!number::parse_number(line.substr(begin, end - begin))) return false;
    begin = line.find_first_not_of(separators, end);
  }
  return any;
}

/// Throws Failure(input_output) as bundle::parse_csv() does, and where the first line has numbers instead of the names of
/// columns.
bundle::CsvDocument parse_coordinates(std::string_view text, const std::string& file_name) {
  const auto first = text.substr(0, text.find('\n'));
  if (has_numbers_only(first))
    throw Failure(
        Exit::input_output,
        fmt::format("{}:1: header is missing, the first line is data, \"{}\"; write x, or x,y, or x,y,z above "
                    "it, and separate numbers by commas, without brackets or blanks",
                    file_name, echo(first)));
  return bundle::parse_csv(text, file_name);
}

/// The indices of the columns x, y, z, up to the first that is missing. They may stand in any order.
std::vector<std::size_t> axis_columns(const bundle::CsvDocument& csv) {
  std::vector<std::size_t> columns;
  for (const auto axis : axes) {
    const auto found = std::ranges::find(csv.header(), axis);
    if (found == csv.header().end()) break;
    columns.push_back(static_cast<std::size_t>(found - csv.header().begin()));
  }
  return columns;
}

/// Shows the header and a correct one.
[[noreturn]] void refuse_header(const bundle::CsvDocument& csv, const std::string& instead) {
  throw Failure(Exit::input_output, fmt::format("{}:1: header is \"{}\"; write {}", csv.file_name(),
                                                echo(fmt::format("{}", fmt::join(csv.header(), ","))), instead));
}

/// The finite number in a field.
double number_at(const bundle::CsvDocument& csv, std::size_t row, std::size_t column) {
  const auto& text = csv.row(row)[column];
  const auto value = number::parse_number(text);
  if (!value || !std::isfinite(*value))
    throw Failure(Exit::input_output, fmt::format("{}:{}: row {}, column {}: \"{}\" {}", csv.file_name(), csv.line(row),
                                                  row + 1, csv.header()[column], echo(text), number::fault(text)));
  return *value;
}

/// The indices of a file's columns.
struct Columns {
  std::vector<std::size_t> axes;
  std::optional<std::size_t> weight;
  std::optional<std::size_t> curve;
  std::optional<std::size_t> index;
  std::optional<std::size_t> form;
};

Columns columns_of(const bundle::CsvDocument& csv) {
  Columns columns{axis_columns(csv), {}, {}, {}, {}};
  std::size_t known = columns.axes.size();
  const auto find = [&](std::string_view name, std::optional<std::size_t>& column) {
    if (column || !csv.has_column(name)) return;
    column = csv.column(name);
    ++known;
  };
  find("w", columns.weight);
  find("curve", columns.curve);
  find("segment", columns.curve);
  find("index", columns.index);
  find("form", columns.form);
  const bool several = columns.curve || columns.index || columns.form;
  if (columns.axes.empty() || known != csv.header().size() || (several && !(columns.curve && columns.index)))
    refuse_header(
        csv,
        "x, or x,y, or x,y,z, and w for the weights of a rational curve; before these curve,index for several "
        "curves");
  return columns;
}

/// Reads the curves of a file one after the other.
class Reader {
 public:
  Reader(const bundle::CsvDocument& csv, Form form) : csv_(csv), columns_(columns_of(csv)), form_(form) {}

  std::vector<CurveFile> curves() {
    std::vector<CurveFile> result;
    if (csv_.row_count() == 0)
      throw Failure(Exit::input_output, fmt::format("{}: no coefficients; write one per row", csv_.file_name()));
    for (std::size_t row = 0; row < csv_.row_count();) {
      const std::size_t end = end_of(row);
      result.push_back(curve(row, end));
      row = end;
    }
    return result;
  }

 private:
  [[noreturn]] void refuse(std::size_t row, const std::string& what) const {
    throw Failure(Exit::input_output, fmt::format("{}:{}: {}", csv_.file_name(), csv_.line(row), what));
  }

  /// The row after the last one of the curve that begins at `first`.
  std::size_t end_of(std::size_t first) {
    if (!columns_.curve) return csv_.row_count();
    const auto& id = csv_.row(first)[*columns_.curve];
    if (!seen_.insert(id).second)
      refuse(first, fmt::format("curve \"{}\" has rows above already; write the rows of a curve together", echo(id)));
    std::size_t row = first;
    for (; row < csv_.row_count() && csv_.row(row)[*columns_.curve] == id; ++row)
      if (csv_.row(row)[*columns_.index] != std::to_string(row - first))
        refuse(row, fmt::format("index is \"{}\", here must be {}; write the rows of a curve in order, from 0",
                                echo(csv_.row(row)[*columns_.index]), row - first));
    return row;
  }

  /// The form that the rows of one curve state, or that of the option.
  Form form_of(std::size_t first, std::size_t end) const {
    if (!columns_.form) return form_;
    const auto& word = csv_.row(first)[*columns_.form];
    for (std::size_t row = first; row < end; ++row)
      if (csv_.row(row)[*columns_.form] != word)
        refuse(row, fmt::format("form is \"{}\", but \"{}\" above; a curve has one",
                                echo(csv_.row(row)[*columns_.form]), echo(word)));
    for (const Form form : {Form::bernstein, Form::power, Form::rational})
      if (word == name(form)) return form;
    refuse(first, fmt::format("form \"{}\": must be bernstein, power or rational", echo(word)));
  }

  CurveFile curve(std::size_t first, std::size_t end) const {
    if (end - first > static_cast<std::size_t>(max_degree) + 1)
      throw Failure(Exit::input_output, fmt::format("{}: {} coefficients; the largest degree is {}", csv_.file_name(),
                                                    end - first, max_degree));
    const bool weighted =
        columns_.weight && !(columns_.curve && csv_.row(first)[*columns_.weight].empty());  // the first row decides
    CurveFile curve{columns_.curve ? csv_.row(first)[*columns_.curve] : std::string(),
                    form_of(first, end),
                    static_cast<int>(columns_.axes.size()),
                    {},
                    {}};
    if (weighted && form_ != Form::bernstein && !columns_.form)
      throw Failure(Exit::usage,
                    fmt::format("--form {}: {} has weights (column w), which belong to control points; leave "
                                "--form out, it must be bernstein",
                                name(form_), csv_.file_name()));
    if (columns_.form && weighted != (curve.form == Form::rational))
      refuse(first, fmt::format("form is {}, but the curve has {} (column w); a curve is rational where it has weights",
                                name(curve.form), weighted ? "weights" : "no weights"));
    if (weighted) curve.form = Form::rational;
    for (std::size_t row = first; row < end; ++row) {
      for (const auto column : columns_.axes) curve.coefficients.push_back(number_at(csv_, row, column));
      if (weighted)
        curve.weights.push_back(number_at(csv_, row, *columns_.weight));
      else if (columns_.weight && !csv_.row(row)[*columns_.weight].empty())
        refuse(row, "column w: the rows of this curve above have no weight; give all or none");
    }
    if (weighted && std::ranges::all_of(curve.weights, [](double weight) { return weight == 0; }))
      refuse(first, fmt::format("rows {} to {}, column w: every weight is 0; one of them must not be", first + 1, end));
    return curve;
  }

  const bundle::CsvDocument& csv_;
  Columns columns_;
  Form form_;
  std::unordered_set<std::string> seen_;
};

}  // namespace

std::string axis_name(int axis) { return std::string(axes.at(static_cast<std::size_t>(axis))); }

CurveFile CurveFile::along(int axis) const {
  CurveFile one{id, form, 1, {}, weights};
  for (int i = 0; i <= degree(); ++i) one.coefficients.push_back(view()(axis, i));
  return one;
}

std::vector<CurveFile> parse_curves(std::string_view text, const std::string& file_name, Form form) {
  return Reader(parse_coordinates(text, file_name), form).curves();
}

std::vector<CurveFile> read_curves(const std::string& name, Form form) {
  const auto mark = name.rfind('#');
  if (mark == std::string::npos || std::filesystem::exists(name))
    return parse_curves(bundle::read_file(name), name, form);
  const auto file = name.substr(0, mark);
  const auto id = name.substr(mark + 1);
  auto curves = parse_curves(bundle::read_file(file), file, form);
  auto found = std::ranges::find(curves, id, &CurveFile::id);
  if (const auto number = number::parse_integer(id);
      found == curves.end() && number && *number >= 0 && *number < static_cast<std::int64_t>(curves.size()))
    found = curves.begin() + *number;
  if (found == curves.end())
    throw Failure(Exit::usage,
                  fmt::format("--curve {}: {} has no such curve; it has {}, write an id of its column curve, "
                              "or a number from 0",
                              echo(name), file, curves.size()));
  return {std::move(*found)};
}

std::string curves_csv(std::span<const CurveFile> curves) {
  const bool several = curves.size() > 1;
  std::vector<std::string> header;
  if (several) header = {"curve", "index"};
  for (int axis = 0; axis < curves.front().dimension; ++axis) header.push_back(axis_name(axis));
  bundle::CsvTable table(header);
  for (const auto& curve : curves)
    for (int i = 0; i <= curve.degree(); ++i) {
      std::vector<std::string> row;
      if (several) row = {curve.id, std::to_string(i)};
      for (int axis = 0; axis < curve.dimension; ++axis) row.push_back(number::decimal(curve.view()(axis, i)));
      table.add_row(std::move(row));
    }
  return table.text();
}

bool PointFile::ends_where_it_starts() const {
  return std::equal(coordinates.begin(), coordinates.begin() + dimension, coordinates.end() - dimension);
}

PointFile read_points(const std::string& file) {
  const auto csv = parse_coordinates(bundle::read_file(file), file);
  const auto columns = axis_columns(csv);
  if (columns.empty() || columns.size() != csv.header().size()) refuse_header(csv, "x, or x,y, or x,y,z");
  if (csv.row_count() < 2)
    throw Failure(Exit::input_output, fmt::format("{}: {} point{}; write 2 or more, one per row", file, csv.row_count(),
                                                  csv.row_count() == 1 ? "" : "s"));
  PointFile points{static_cast<int>(columns.size()), {}, {}};
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    for (const auto column : columns) points.coordinates.push_back(number_at(csv, row, column));
    points.lines.push_back(csv.line(row));
  }
  return points;
}

std::string segments_csv(std::span<const double> segments, int dimension) {
  std::string text = "segment,index";
  for (int axis = 0; axis < dimension; ++axis) text += "," + axis_name(axis);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (k % d == 0) fmt::format_to(std::back_inserter(text), "\n{},{}", k / d / 4, k / d % 4);
    text += "," + number::decimal(segments[k]);
  }
  return text + "\n";
}

}  // namespace bezierbench::cli
