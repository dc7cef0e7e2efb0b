// SPDX-License-Identifier: MIT
// `curves`: what files of curves hold, and the same curves as one set.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/metric/curve_statistics.hpp"
#include "experiments/terminal.hpp"
#include "reference/curves/read.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

struct CurvesOptions {
  std::vector<std::string> files;
  std::optional<std::string> out;
  std::string format = "text";
};

const std::vector<std::string> group_columns{
    "form",         "dimension",        "degree",   "curves",          "low",
    "high",         "size_median",      "size_p99", "size_largest",    "distance_median",
    "distance_p99", "distance_largest", "points",   "coincident_ends", "coincident_neighbours",
    "collinear",    "monotone"};

/// The fields of a group. Numbers have all digits in CSV and four in text; what a group does not have is empty.
std::vector<std::string> group_fields(const metric::CurveGroup& group, bool short_numbers) {
  std::vector<std::string> fields{std::string(name(group.form)), std::to_string(group.dimension),
                                  std::to_string(group.degree), std::to_string(group.curves)};
  const auto add = [&](double value) {
    fields.push_back(std::isnan(value) ? "" : short_numbers ? fmt::format("{:.4g}", value) : number::decimal(value));
  };
  add(group.low);
  add(group.high);
  for (const auto& of : {group.size, group.distance})
    for (const double value : {of.median, of.p99, of.largest}) add(value);
  for (const auto count :
       {group.points, group.coincident_ends, group.coincident_neighbours, group.collinear, group.monotone})
    fields.push_back(group.form == Form::power ? "" : std::to_string(count));
  return fields;
}

std::string left_out_line(const std::string& why, std::size_t count) {
  return fmt::format("left out: {} ({})", printable(why), count);
}

void print_groups(const curves::Read& read, const std::vector<metric::CurveGroup>& groups) {
  std::size_t paths = 0;
  for (std::size_t k = 0; k < read.set.size(); ++k) paths += read.set.begins_path(k) ? 1 : 0;
  fmt::print("{} curve{} in {} path{}\n", read.set.size(), read.set.size() == 1 ? "" : "s", paths,
             paths == 1 ? "" : "s");
  if (!groups.empty()) {
    std::vector<std::vector<std::string>> lines{group_columns};
    for (auto& word : lines.front())
      for (char& c : word) c = c == '_' ? ' ' : c;
    for (const auto& group : groups) lines.push_back(group_fields(group, true));
    fmt::print("{}", fitted(std::move(lines), terminal_width(STDOUT_FILENO)));
  }
  for (const auto& [why, count] : read.left_out) fmt::print("{}\n", left_out_line(why, count));
}

void print_groups_csv(const curves::Read& read, const std::vector<metric::CurveGroup>& groups) {
  bundle::CsvTable table(group_columns);
  for (const auto& group : groups) table.add_row(group_fields(group, false));
  fmt::print("{}", table.text());
  for (const auto& [why, count] : read.left_out) say(left_out_line(why, count));
}

void describe_curves(const CurvesOptions& options) {
  std::vector<curves::NamedRead> files;
  for (const auto& file : options.files) files.push_back({file, read_set(file, Form::bernstein)});
  const auto all = curves::joined(files);
  const auto groups = metric::curve_statistics(all.set);
  if (options.out) bundle::write_file(*options.out, curves::to_csv(all.set));
  options.format == "csv" ? print_groups_csv(all, groups) : print_groups(all, groups);
}

}  // namespace

void add_curves(Command program, Exit& /*exit*/) {
  auto options = std::make_shared<CurvesOptions>();
  auto command = program.command("curves",
                                 "say what curves are in files: CSV, SVG, path data, JSON, fonts; with other "
                                 "libraries (docs/peers.md) also STEP and IGES");
  command.option("FILE", options->files, "file of curves; - is standard input").required();
  command.option("--out", options->out, "write them as one set, with hexadecimal numbers").takes("SET.csv");
  command.option("--format", options->format, "csv has all digits").one_of({"text", "csv"});
  command.footer(
      "size is the largest extent of the control points along an axis, distance the largest magnitude of a coordinate "
      "over the size. Points, coincident ends and neighbours, collinear and monotone curves are counted by their "
      "control points. Of SVG, viewBox, style sheets and CSS transforms are not applied.");
  command.action([options] { describe_curves(*options); });
}

}  // namespace bezierbench::cli
