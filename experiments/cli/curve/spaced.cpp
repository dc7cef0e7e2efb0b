// SPDX-License-Identifier: MIT
// `curve spaced`: points at equal lengths along a curve or a path, each the nearest double to the true one.
#include "experiments/cli/curve/curve_command.hpp"
#include "reference/length/length_truth.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using reference::LongReal;

struct SpacedOptions {
  CurveOptions curve;
  int count = 0;
  bool whole_path = false;
};

struct SpacedSegment {
  const CurveFile* curve;
  reference::LengthAlong<LongReal> lengths;
};

std::vector<SpacedSegment> spaced_segments(std::span<const CurveFile> curves, const std::string& name) {
  std::vector<SpacedSegment> segments;
  for (const auto& curve : curves) {
    if (curve.form == Form::power)
      throw Failure(Exit::usage, "{}: is in power form, whose lengths are not computed; see `curve convert`", name);
    refuse_pole(curve.view(), 0, 1, name);
    try {
      segments.push_back({&curve, reference::LengthAlong<LongReal>(curve.view())});
    } catch (const reference::NotCertain& error) {
      throw Failure(Exit::input_output, "{}: {}; choose another curve", name, error.what());
    }
  }
  return segments;
}

/// The rows of `count` points: the k-th is k/(count - 1) of the whole length from the start.
void add_spaced_points(std::span<const SpacedSegment> segments, const SpacedOptions& options, int dimension,
                       const std::string& id, bundle::CsvTable& table) {
  LongReal whole = 0;
  for (const auto& segment : segments) whole += segment.lengths.whole();
  std::size_t at = 0;
  LongReal before = 0;  // the length of the segments before this one
  for (int k = 0; k < options.count; ++k) {
    const LongReal length = whole * k / (options.count - 1);
    while (at + 1 < segments.size() && length > before + segments[at].lengths.whole())
      before += segments[at++].lengths.whole();
    const auto t = segments[at].lengths.parameter_at(length - before).convert_to<double>();
    std::vector<std::string> row{id, std::to_string(k)};
    if (options.whole_path) row.push_back(std::to_string(at));
    row.push_back(number::decimal(t));
    row.push_back(number::decimal(length.convert_to<double>()));
    for (auto& field : point_fields_at(segments[at].curve->view(), t, dimension)) row.push_back(std::move(field));
    table.add_row(std::move(row));
  }
}

void space(const SpacedOptions& options) {
  const auto curves = options.curve.read();
  const auto dimension = largest_dimension(curves);
  std::vector<std::string> columns{"curve", "index", "t", "length"};
  if (options.whole_path) columns.insert(columns.begin() + 2, "segment");
  bundle::CsvTable table(with_axes(std::move(columns), dimension));
  const auto add = [&](std::span<const CurveFile> part, const std::string& id) {
    const auto name = curves.size() > 1 ? fmt::format("{}#{}", options.curve.name(), echo(id)) : options.curve.name();
    add_spaced_points(spaced_segments(part, name), options, dimension, id, table);
  };
  if (options.whole_path)
    for (const auto path : paths_of(curves)) add(path, path_id(path.front().id));
  else
    for (const auto& curve : curves) add({&curve, 1}, curve.id);
  fmt::print("{}", table.text());
}

void add_spaced(Command command) {
  auto options = std::make_shared<SpacedOptions>();
  options->curve.add_to(command);
  command.option("--count", options->count, "number of points, with both ends").required().within(2, 1'000'000);
  command.flag("--whole-path", options->whole_path, "take segments that are joined as one path");
  command.action([options] { space(*options); });
}

}  // namespace

extern constexpr CurveCommand curve_spaced{"spaced", "find points at equal lengths along a curve", add_spaced};

}  // namespace bezierbench::cli
