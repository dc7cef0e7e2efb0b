// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/replay_property.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/cli/commands/replay_text.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/echo.hpp"
#include "experiments/guarantees/statements.hpp"
#include "experiments/judge/methods.hpp"

namespace bezierbench::cli {
namespace {

/// A field that some properties have; 0 where it is empty.
double optional_number(const WorstRecord& record, std::string_view column) {
  return record.text(column).empty() ? 0 : record.number(column);
}

template <class Scalar>
guarantees::Case<Scalar> input_of(const WorstRecord& record, const sample::Cell& cell) {
  const auto input = record.input(cell);
  return {cell.dimension,
          {input.coefficients.begin(), input.coefficients.end()},
          static_cast<Scalar>(input.t),
          static_cast<Scalar>(optional_number(record, "t_next")),
          static_cast<Scalar>(optional_number(record, "offset"))};
}

template <class Scalar>
void print_point(std::string_view at, const guarantees::Values<Scalar>& point, int dimension) {
  for (int axis = 0; axis < dimension; ++axis)
    fmt::print("  {}({}){:<5}{}\n", axis_name(axis), at, "",
               both(static_cast<double>(point[static_cast<std::size_t>(axis)])));
}

template <class Scalar>
Exit asked_again(const std::string& id, const WorstRecord& record, const sample::Cell& cell) {
  const auto* kernel = judge::find_method<Scalar>(record.text("method"), cell.curve, cell.dimension);
  if (kernel == nullptr) record.malformed("method", "is not one that this program knows");
  const auto& all = guarantees::statements<Scalar>;
  const auto statement =
      std::ranges::find(all, record.text("property"), [](const auto& one) { return name(one.property); });
  if (statement == all.end()) record.malformed("property", "is not one that this program knows");
  const auto input = input_of<Scalar>(record, cell);

  fmt::print("{}\n\ninput\n  t          {}\n",
             printable(fmt::format("{}: study {}, method {}, {}, degree {}, {}", id, record.text("study"),
                                   record.text("method"), record.text("scalar"), cell.degree, record.text("property"))),
             both(static_cast<double>(input.t)));
  if (statement->uses_t_next) fmt::print("  t'         {}\n", both(static_cast<double>(input.t_next)));
  if (statement->uses_offset) fmt::print("  offset     {}\n", both(static_cast<double>(input.offset)));
  print_points(CurveView<Scalar>{cell.curve, cell.dimension, cell.degree, input.coefficients});

  guarantees::Evaluation<Scalar> method(*kernel);
  fmt::print("\nresult\n");
  print_point<Scalar>("t", method.point(input.coefficients, input.t), cell.dimension);
  if (statement->uses_t_next) print_point<Scalar>("t'", method.point(input.coefficients, input.t_next), cell.dimension);
  const auto excess = statement->excess(method, input);
  const bool broken = excess && *excess > 0;
  fmt::print("  excess     {}: {}\n", excess ? number::decimal(*excess) : "none, the statement is not about this input",
             broken ? "it breaks the property" : "it does not break the property");

  const bool was_broken = record.text("verdict") == "refuted";
  const bool same = was_broken ? broken : excess && *excess == record.number("largest");
  fmt::print("  recorded   {}: {}\n", printable(record.text("verdict")), same ? "the same" : "DIFFERENT");
  if (!same) say("what is recorded is not what this program computes; compare the builds with `bezierbench --version`");
  return same ? Exit::fine : Exit::finding;
}

}  // namespace

Exit replay_property(const std::string& id, const WorstRecord& record, const sample::Cell& cell) {
  if (record.text("t").empty())
    throw Failure(Exit::usage, fmt::format("{}: is proved, so that there is no input; see docs/guarantees.md", id));
  return record.scalar() == suite::ScalarKind::float32 ? asked_again<float>(id, record, cell)
                                                       : asked_again<double>(id, record, cell);
}

}  // namespace bezierbench::cli
