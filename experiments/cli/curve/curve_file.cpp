// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/curve_file.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/curve/model_file.hpp"
#include "experiments/failure.hpp"
#include "experiments/peers/models.hpp"
#include "reference/curves/path_data.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

/// What `reading()` gives, whose Unreadable becomes a Failure.
template <class Reading>
auto read_or_fail(Reading reading) {
  try {
    return reading();
  } catch (const curves::Unreadable& error) {
    throw Failure(Exit::input_output, error.what());
  }
}

CurveFile curve_in(const curves::CurveSet& set, std::size_t k) {
  const auto curve = set[k];
  return {std::string(set.id(k)),
          curve.form,
          curve.dimension,
          {curve.coefficients.begin(), curve.coefficients.end()},
          {curve.weights.begin(), curve.weights.end()},
          set.begins_path(k)};
}

std::vector<CurveFile> curves_in(const curves::CurveSet& set) {
  std::vector<CurveFile> curves;
  for (std::size_t k = 0; k < set.size(); ++k) curves.push_back(curve_in(set, k));
  return curves;
}

std::vector<CurveFile> not_empty(std::vector<CurveFile> curves, const std::string& name) {
  if (curves.empty()) throw Failure(Exit::input_output, "{}: no curves; see `curves {}`", name, name);
  return curves;
}

}  // namespace

std::string contents_of(const std::string& file) {
  if (file != "-") {
    std::error_code error;
    if (const auto size = std::filesystem::file_size(file, error); !error && size > curves::most_bytes)
      throw Failure(Exit::input_output, "{}: {} bytes; at most {} are read, so split the file", file, size,
                    curves::most_bytes);
    return bundle::read_file(file);
  }
  std::string text;
  std::array<char, 65536> buffer;
  while (text.size() <= curves::most_bytes && (std::cin.read(buffer.data(), buffer.size()) || std::cin.gcount() > 0))
    text.append(buffer.data(), static_cast<std::size_t>(std::cin.gcount()));
  return text;
}

std::string axis_name(int axis) { return std::string(curves::axis_names.at(static_cast<std::size_t>(axis))); }

CurveFile CurveFile::along(int axis) const {
  CurveFile one{id, form, 1, {}, weights, begins_path};
  for (int i = 0; i <= degree(); ++i) one.coefficients.push_back(view()(axis, i));
  return one;
}

curves::Read read_set(const std::string& file, Form form) {
  const auto contents = contents_of(file);
  try {
    const curves::ReadOptions options{form, peers::model_reader() == nullptr ? nullptr : read_model};
    return read_or_fail([&] { return curves::read(contents, file, options); });
  } catch (const std::invalid_argument& error) {
    throw Failure(Exit::usage, "--form {}: {}", name(form), error.what());
  }
}

std::vector<CurveFile> read_curves(const std::string& name, Form form) {
  const auto mark = name.rfind('#');
  if (mark == std::string::npos || std::filesystem::exists(name))
    return not_empty(curves_in(read_set(name, form).set), name);
  const auto file = name.substr(0, mark);
  const auto id = name.substr(mark + 1);
  const auto set = read_set(file, form).set;
  if (const auto found = set.find(id); found < set.size()) return {curve_in(set, found)};
  std::vector<CurveFile> path;
  const auto beginning = id.ends_with(':') ? id : id + ':';
  for (std::size_t k = 0; k < set.size(); ++k)
    if (set.id(k).starts_with(beginning)) path.push_back(curve_in(set, k));
  if (path.empty())
    throw Failure(Exit::usage,
                  "--curve {}: {} has no such curve; it has {}, write an id of its column curve, or a number from 0",
                  echo(name), file, set.size());
  return path;
}

std::vector<CurveFile> path_curves(const std::string& data) {
  return not_empty(curves_in(read_or_fail([&] { return curves::read_path_data(data, "--path"); }).set), "--path");
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

PointList read_points(const std::string& file, std::size_t least, bool weights) {
  const auto contents = contents_of(file);
  auto points = read_or_fail([&] { return curves::read_points_csv(contents, file, weights); });
  if (points.count() < least)
    throw Failure(Exit::input_output, "{}: {} point{}; write {} or more, one per row", file, points.count(),
                  points.count() == 1 ? "" : "s", least);
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
