// SPDX-License-Identifier: MIT
#include "reference/curves/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/curves/read.hpp"
#include "reference/number/csv_records.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::curves {
namespace {

constexpr std::size_t most_parameters = std::numeric_limits<std::uint16_t>::max();

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

/// The places of the columns in a record.
struct Columns {
  std::vector<std::size_t> axes;
  std::optional<std::size_t> curve;
  std::optional<std::size_t> index;
  std::optional<std::size_t> form;
  std::optional<std::size_t> weight;
  std::optional<std::size_t> t;
};

[[noreturn]] void refuse_header(const std::vector<std::string>& header, const CsvRecords& records,
                                std::string_view instead) {
  records.refuse(1,
                 fmt::format("header is \"{}\"; write {}", echo(fmt::format("{}", fmt::join(header, ","))), instead));
}

/// The finite number in a field of row number `row`, from 1.
double number_at(const CsvRecords& records, std::size_t row, std::size_t column, const std::string& name) {
  const auto text = records.fields()[column];
  const auto value = number::parse_number(text);
  if (!value || !std::isfinite(*value))
    records.refuse(records.line(),
                   fmt::format("row {}, column {}: \"{}\" {}", row, name, echo(text), number::fault(text)));
  return *value;
}

Columns columns_of(const std::vector<std::string>& header, const CsvRecords& records) {
  Columns columns;
  std::size_t known = 0;
  const auto place = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto found = std::ranges::find(header, name);
    if (found == header.end()) return std::nullopt;
    ++known;
    return static_cast<std::size_t>(found - header.begin());
  };
  for (const auto axis : axis_names) {
    const auto found = place(axis);
    if (!found) break;
    columns.axes.push_back(*found);
  }
  columns.curve = place("curve");
  if (!columns.curve) columns.curve = place("segment");
  columns.index = place("index");
  columns.form = place("form");
  columns.weight = place("w");
  columns.t = place("t");
  const bool several = columns.curve || columns.index || columns.form;
  if (columns.axes.empty() || known != header.size() || (several && !(columns.curve && columns.index)))
    refuse_header(
        header, records,
        "x, or x,y, or x,y,z, and w for the weights of a rational curve; before these curve,index for several "
        "curves");
  return columns;
}

/// Reads the curves of a file one after the other, row by row.
class Reader {
 public:
  Reader(CsvRecords& records, Form form)
      : records_(records), header_(records.header()), columns_(columns_of(header_, records)), form_(form) {}

  Read read() {
    while (!records_.done()) {
      records_.next_row();
      ++row_;
      add_row();
    }
    if (row_ == 0) throw Unreadable(fmt::format("{}: no coefficients; write one per row", records_.name()));
    finish_curve();
    require_distinct_ids();
    return std::move(result_);
  }

 private:
  /// The curve whose rows are being read.
  struct Pending {
    std::string id;
    std::string form;
    std::size_t rows = 0;
    std::size_t coefficients = 0;
    std::size_t dimension = 0;
    bool weighted = false;
    std::size_t first_row = 0;
    std::size_t first_line = 0;
    std::vector<double> numbers;
    std::vector<double> weights;
    std::vector<double> parameters;
  };

  [[noreturn]] void refuse(const std::string& what) const { records_.refuse(records_.line(), what); }
  [[noreturn]] void refuse_repeated(std::size_t line, std::string_view id) const {
    records_.refuse(line,
                    fmt::format("curve \"{}\" has rows above already; write the rows of a curve together", echo(id)));
  }

  [[nodiscard]] std::string_view field(std::size_t column) const { return records_.fields()[column]; }
  [[nodiscard]] bool is_empty(const std::optional<std::size_t>& column) const {
    return !column || field(*column).empty();
  }

  [[nodiscard]] double number_in(std::size_t column) const {
    return number_at(records_, row_, column, header_[column]);
  }

  void add_row() {
    const auto id = columns_.curve ? field(*columns_.curve) : std::string_view();
    if (curve_.rows == 0 || id != curve_.id) {
      finish_curve();
      begin_curve(id);
    }
    if (columns_.index && field(*columns_.index) != std::to_string(curve_.rows)) {
      for (std::size_t k = 0; k < result_.set.size() && curve_.rows == 0; ++k)
        if (result_.set.id(k) == id) refuse_repeated(records_.line(), id);
      refuse(fmt::format("index is \"{}\", here must be {}; write the rows of a curve in order, from 0",
                         echo(field(*columns_.index)), curve_.rows));
    }
    if (columns_.form && field(*columns_.form) != curve_.form)
      refuse(fmt::format("form is \"{}\", but \"{}\" above; a curve has one", echo(field(*columns_.form)),
                         echo(curve_.form)));
    if (!is_empty(columns_.t)) {
      if (curve_.parameters.size() == most_parameters)
        refuse(fmt::format("column t: more than {} parameters of one curve; leave some out", most_parameters));
      curve_.parameters.push_back(number_in(*columns_.t));
    }
    const bool parameter_alone = curve_.rows > 0 && !is_empty(columns_.t) && is_empty(columns_.weight) &&
                                 std::ranges::all_of(columns_.axes, [&](auto axis) { return field(axis).empty(); });
    if (parameter_alone)
      parameters_only_ = true;
    else
      add_coefficient();
    ++curve_.rows;
  }

  void add_coefficient() {
    if (parameters_only_) refuse("a coefficient below a row with t alone; write the coefficients first");
    if (++curve_.coefficients > static_cast<std::size_t>(max_degree) + 1) return;  // finish_curve() states the count
    for (std::size_t k = 0; k < columns_.axes.size(); ++k) {
      const auto column = columns_.axes[k];
      if (k < curve_.dimension)
        curve_.numbers.push_back(number_in(column));
      else if (!field(column).empty())
        refuse(fmt::format("row {}, column {}: the rows of this curve above have none; give all or none", row_,
                           header_[column]));
    }
    if (curve_.weighted)
      curve_.weights.push_back(number_in(*columns_.weight));
    else if (!is_empty(columns_.weight))
      refuse("column w: the rows of this curve above have no weight; give all or none");
  }

  /// What the first row of a curve decides for all.
  void begin_curve(std::string_view id) {
    curve_.id = id;
    curve_.first_row = row_;
    curve_.first_line = records_.line();
    curve_.form = columns_.form ? field(*columns_.form) : std::string_view();
    curve_.weighted = columns_.weight && !(columns_.curve && is_empty(columns_.weight));
    curve_.dimension = columns_.axes.size();
    while (columns_.curve && curve_.dimension > 1 && field(columns_.axes[curve_.dimension - 1]).empty())
      --curve_.dimension;
    if (curve_.weighted && form_ != Form::bernstein && !columns_.form)
      throw std::invalid_argument(
          fmt::format("{} has weights (column w), which belong to control points; leave "
                      "--form out, it must be bernstein",
                      records_.name()));
  }

  [[nodiscard]] Form form_of_curve() const {
    Form form = form_;
    if (columns_.form) {
      constexpr std::array forms{Form::bernstein, Form::power, Form::rational};
      const auto* const found = std::ranges::find(forms, curve_.form, [](Form one) { return name(one); });
      if (found == forms.end())
        records_.refuse(curve_.first_line,
                        fmt::format("form \"{}\": must be bernstein, power or rational", echo(curve_.form)));
      form = *found;
      if (curve_.weighted != (form == Form::rational))
        records_.refuse(curve_.first_line,
                        fmt::format("form is {}, but the curve has {} (column w); a curve is rational where it has "
                                    "weights",
                                    name(form), curve_.weighted ? "weights" : "no weights"));
    }
    return curve_.weighted ? Form::rational : form;
  }

  void finish_curve() {
    if (curve_.rows == 0) return;
    if (curve_.coefficients > static_cast<std::size_t>(max_degree) + 1)
      throw Unreadable(fmt::format("{}: {} coefficients; the largest degree is {}", records_.name(),
                                   curve_.coefficients, max_degree));
    const CurveView<double> view{form_of_curve(), static_cast<int>(curve_.dimension),
                                 static_cast<int>(curve_.coefficients) - 1, curve_.numbers, curve_.weights};
    if (curve_.weighted && std::ranges::all_of(curve_.weights, [](double weight) { return weight == 0; }))
      records_.refuse(curve_.first_line,
                      fmt::format("rows {} to {}, column w: every weight is 0; one of them must not be",
                                  curve_.first_row, curve_.first_row + curve_.coefficients - 1));
    require_room(result_.set, records_.name());
    result_.set.add(curve_.id, view, !result_.set.continues_path(curve_.id, view), curve_.parameters);
    first_lines_.push_back(static_cast<std::uint32_t>(curve_.first_line));
    curve_.rows = curve_.coefficients = 0;
    curve_.numbers.clear();
    curve_.weights.clear();
    curve_.parameters.clear();
    parameters_only_ = false;
  }

  /// Ids that ascend, as numbers do, are distinct; a set of strings would take more memory than the curves.
  void require_distinct_ids() const {
    const auto& set = result_.set;
    const auto before = [&](std::size_t a, std::size_t b) {
      return std::pair(set.id(a).size(), set.id(a)) < std::pair(set.id(b).size(), set.id(b));
    };
    std::vector<std::uint32_t> order(set.size());
    std::iota(order.begin(), order.end(), 0U);
    if (std::ranges::adjacent_find(order, [&](auto a, auto b) { return !before(a, b); }) == order.end()) return;
    std::ranges::sort(order, [&](auto a, auto b) { return before(a, b) || (!before(b, a) && a < b); });
    std::size_t first = set.size();
    for (std::size_t k = 1; k < order.size(); ++k)
      if (set.id(order[k]) == set.id(order[k - 1])) first = std::min<std::size_t>(first, order[k]);
    if (first < set.size()) refuse_repeated(first_lines_[first], set.id(first));
  }

  CsvRecords& records_;
  std::vector<std::string> header_;
  Columns columns_;
  Form form_;
  Read result_;
  Pending curve_;
  bool parameters_only_ = false;  ///< the last row of the curve has no coefficient
  std::size_t row_ = 0;           ///< from 1, the header not counted
  std::vector<std::uint32_t> first_lines_;
};

/// The records of a text that has a header.
CsvRecords records_of(std::string_view text, const std::string& name) {
  CsvRecords records(text, name);
  const auto first = records.rest().substr(0, records.rest().find('\n'));
  if (has_numbers_only(first))
    records.refuse(1, fmt::format("header is missing, the first line is data, \"{}\"; write x, or x,y, or x,y,z above "
                                  "it, and separate numbers by commas, without brackets or blanks",
                                  echo(first)));
  return records;
}

/// What `read` makes of the records of a text.
auto read_records(std::string_view text, const std::string& name, const auto& read) {
  try {
    auto records = records_of(text, name);
    return read(records);
  } catch (const CsvFault& fault) {
    throw Unreadable(fault.what());
  }
}

PointList read_points(CsvRecords& records, bool weights) {
  const auto header = records.header();
  PointList points;
  std::vector<std::size_t> columns;
  for (const auto axis : axis_names) {
    const auto found = std::ranges::find(header, axis);
    if (found == header.end()) break;
    columns.push_back(static_cast<std::size_t>(found - header.begin()));
  }
  const auto weight = weights ? std::ranges::find(header, "w") : header.end();
  if (columns.empty() || columns.size() + (weight == header.end() ? 0 : 1) != header.size())
    refuse_header(header, records,
                  weights ? "x, or x,y, or x,y,z, and w for the weights of a rational curve" : "x, or x,y, or x,y,z");
  points.dimension = static_cast<int>(columns.size());
  while (!records.done()) {
    records.next_row();
    for (const auto column : columns)
      points.coordinates.push_back(number_at(records, points.lines.size() + 1, column, header[column]));
    if (weight != header.end())
      points.weights.push_back(
          number_at(records, points.lines.size() + 1, static_cast<std::size_t>(weight - header.begin()), *weight));
    points.lines.push_back(records.line());
  }
  return points;
}

}  // namespace

Read read_csv(std::string_view text, const std::string& name, Form form) {
  return read_records(text, name, [&](CsvRecords& records) { return Reader(records, form).read(); });
}

bool PointList::ends_where_it_starts() const {
  return std::equal(coordinates.begin(), coordinates.begin() + dimension, coordinates.end() - dimension);
}

PointList read_points_csv(std::string_view text, const std::string& name, bool weights) {
  return read_records(text, name, [weights](CsvRecords& records) { return read_points(records, weights); });
}

std::string to_csv(const CurveSet& set, std::string (*number)(double)) {
  int dimension = 1;
  bool forms = false;
  bool weights = false;
  bool parameters = false;
  for (std::size_t k = 0; k < set.size(); ++k) {
    dimension = std::max(dimension, set[k].dimension);
    forms = forms || set[k].form == Form::power;
    weights = weights || set[k].form == Form::rational;
    parameters = parameters || !set.parameters(k).empty();
  }
  std::string text = fmt::format("curve,index{}", forms ? ",form" : "");
  for (int axis = 0; axis < dimension; ++axis)
    text += fmt::format(",{}", axis_names.at(static_cast<std::size_t>(axis)));
  text += fmt::format("{}{}\n", weights ? ",w" : "", parameters ? ",t" : "");
  for (std::size_t k = 0; k < set.size(); ++k) {
    const auto curve = set[k];
    const auto ts = set.parameters(k);
    const auto id = csv_field(set.id(k));
    const auto coefficients = static_cast<std::size_t>(curve.degree) + 1;
    for (std::size_t i = 0; i < std::max(coefficients, ts.size()); ++i) {
      fmt::format_to(std::back_inserter(text), "{},{}", id, i);
      if (forms) fmt::format_to(std::back_inserter(text), ",{}", name(curve.form));
      for (int axis = 0; axis < dimension; ++axis) {
        text += ',';
        if (axis < curve.dimension && i < coefficients) text += number(curve(axis, static_cast<int>(i)));
      }
      if (weights) {
        text += ',';
        if (i < curve.weights.size()) text += number(curve.weights[i]);
      }
      if (parameters) {
        text += ',';
        if (i < ts.size()) text += number(ts[i]);
      }
      text += '\n';
    }
  }
  return text;
}

}  // namespace bezierbench::curves
