// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/worked.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/bundle/csv.hpp"
#include "reference/exact_curve.hpp"
#include "reference/published/published.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::string_view file_name = "worked_conversions.csv";

std::vector<double> numbers(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> values;
  for (double value = 0; stream >> value;) values.push_back(value);
  return values;
}

CurveView<double> view(Form form, const std::vector<double>& coefficients) {
  return {form, 1, static_cast<int>(coefficients.size()) - 1, coefficients};
}

/// Whether both are the same polynomial, exactly.
bool same(const std::vector<double>& control_points, const std::vector<double>& coefficients) {
  const auto exact = reference::converted(view(Form::bernstein, control_points));
  return std::ranges::equal(exact, coefficients, [](const reference::ExactPoint& point, double coefficient) {
    return (point.coordinate(0) - reference::exactly(coefficient)).numerator == 0;
  });
}

/// "6 of 7": how many conversions of this form give `to` from `from`, bit for bit.
std::string agreement(Form form, const std::vector<double>& from, const std::vector<double>& to) {
  int agree = 0;
  int all = 0;
  for (const auto& kernel : conversion_kernels<double>(1)) {
    if (kernel.info->form != form) continue;
    std::vector<double> converted(to.size());
    kernel.convert(view(form, from), converted.data());
    ++all;
    agree += converted == to ? 1 : 0;
  }
  return fmt::format("{} of {}", agree, all);
}

}  // namespace

std::string worked_csv() {
  const auto tables = reference::published_tables();
  const auto table = std::ranges::find(tables, file_name, &reference::PublishedTable::file_name);
  const auto printed = bundle::parse_csv(table->text, table->file_name);
  bundle::CsvTable judged({"example", "degree", "axis", "control_points", "coefficients", "printed_correct", "correct",
                           "to_power", "to_bernstein"});
  for (std::size_t row = 0; row < printed.row_count(); ++row) {
    const auto points = numbers(printed.at(row, "control_points"));
    const auto coefficients = numbers(printed.at(row, "coefficients"));
    judged.add_row({printed.at(row, "example"), printed.at(row, "degree"), printed.at(row, "axis"),
                    printed.at(row, "control_points"), printed.at(row, "coefficients"), printed.at(row, "correct"),
                    same(points, coefficients) ? "yes" : "no", agreement(Form::bernstein, points, coefficients),
                    agreement(Form::power, coefficients, points)});
  }
  return judged.text();
}

}  // namespace bezierbench::cli
