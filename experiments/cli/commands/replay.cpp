// SPDX-License-Identifier: MIT
// `replay`: recomputes a recorded input from its bits: of a worst case it splits the error into parts, of a property it
// says by how much the input breaks it, of a box on which sides points of the curve are outside.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/bundle.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/cli/external/external_options.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/guarantees/statements.hpp"
#include "experiments/judge/error_sources.hpp"
#include "experiments/judge/input_fields.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/point_judge.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/studies/bounds/problem.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/exact_point.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

// One row of a bundle that holds an input: of worst.csv, search.csv, guarantees.csv, guarantees_unstable.csv or
// bounds.csv.

/// What a row is about.
enum class Recorded { point, property, box };

/// A file of inputs.
struct WorstFile {
  std::string_view name;
  Recorded about;
  std::string_view id;       ///< name of the column; where it is empty, rows are named by the file and their line
  std::string_view error_u;  ///< name of the column, of points

  [[nodiscard]] std::string id_of(const bundle::CsvDocument& table, std::size_t row) const {
    return id.empty() ? fmt::format("{}:{}", name, table.line(row)) : table.at(row, id);
  }
};

constexpr std::array worst_files{WorstFile{"worst.csv", Recorded::point, "worst_id", "error_u"},
                                 WorstFile{"search.csv", Recorded::point, "search_id", "searched_error_u"},
                                 WorstFile{"guarantees.csv", Recorded::property, "guarantee_id", ""},
                                 WorstFile{"guarantees_unstable.csv", Recorded::property, "guarantee_id", ""},
                                 WorstFile{"bounds.csv", Recorded::box, "", ""}};

/// A row whose fields are checked when they are used: all functions throw Failure(input_output) that names file, line
/// and column.
class WorstRecord {
 public:
  WorstRecord(bundle::CsvDocument table, std::size_t row, const WorstFile& file)
      : table_(std::move(table)), row_(row), file_(file) {}

  [[nodiscard]] const std::string& text(std::string_view column) const { return table_.at(row_, column); }
  [[nodiscard]] double number(std::string_view column) const {
    const auto value = number::parse_number(text(column));
    if (!value) malformed(column, "is not a number");
    return *value;
  }
  [[nodiscard]] suite::ScalarKind scalar() const { return word<suite::ScalarKind>("scalar"); }
  /// The cell of the input, with curve kind, dimension and degree only: a single input does not need the other axes.
  [[nodiscard]] sample::Cell cell() const {
    sample::Cell cell;
    if (about() != Recorded::property) cell.form = word<Form>("form");  // properties are of Bernstein form
    cell.dimension = count("dimension", 1, reference::max_dimension);
    cell.degree = count("degree", 0, max_degree);
    return cell;
  }
  [[nodiscard]] sample::Trial input(const sample::Cell& cell) const {
    const std::string_view weights = about() == Recorded::property ? std::string_view() : text("weights");
    const std::string_view t = about() == Recorded::box ? std::string_view("0") : text("t");
    const auto trial = judge::parse_input({t, text("coefficients"), weights}, cell);
    if (!trial) malformed("coefficients", "weights and t are not the numbers of a curve of this degree and dimension");
    return *trial;
  }
  [[nodiscard]] double error_u() const { return number(file_.error_u); }
  [[nodiscard]] Recorded about() const { return file_.about; }

  [[noreturn]] void malformed(std::string_view column, std::string_view what) const {
    throw Failure(Exit::input_output, "{}:{}: {} {}; restore the file or run the suite again", table_.file_name(),
                  table_.line(row_), column, what);
  }

 private:
  template <class Word>
  [[nodiscard]] Word word(std::string_view column) const {
    const auto value = suite::parse<Word>(text(column));
    if (!value) malformed(column, "is not a known word");
    return *value;
  }
  [[nodiscard]] int count(std::string_view column, int least, int most) const {
    const auto value = number::parse_integer(text(column));
    if (!value || *value < least || *value > most)
      malformed(column, fmt::format("is not a whole number from {} to {}", least, most));
    return static_cast<int>(*value);
  }

  bundle::CsvDocument table_;
  std::size_t row_;
  WorstFile file_;
};

/// The row with this id. Throws Failure(usage) that lists the ids where there is none.
WorstRecord find_worst_record(const bundle::BundleDirectory& bundle, const std::string& id) {
  std::vector<std::string> there;
  for (const WorstFile& file : worst_files) {
    auto table = bundle.table(file.name);
    const std::size_t rows = table ? table->row_count() : 0;
    for (std::size_t row = 0; row < rows; ++row)
      if (file.id_of(*table, row) == id) return {std::move(*table), row, file};
    if (rows > 0)
      there.push_back(fmt::format("{} to {} in {}", file.id_of(*table, 0), file.id_of(*table, rows - 1), file.name));
  }
  if (there.empty())
    throw Failure(
        Exit::usage,
        "{}: has no inputs with an id (worst.csv, search.csv, guarantees.csv, bounds.csv); name a bundle that has",
        bundle.path().string());
  throw Failure(Exit::usage, "{}: no such id in {}; there are {}, see worst_id, search_id and guarantee_id", id,
                bundle.path().string(), fmt::join(there, ", "));
}

/// The number in hexadecimal, which keeps all bits, and in decimal.
std::string both(double value) { return fmt::format("{} ({})", number::hexadecimal(value), number::decimal(value)); }

/// A line for each coordinate of each coefficient, and for each weight.
template <class Scalar>
void print_points(const CurveView<Scalar>& curve) {
  for (int i = 0; i <= curve.degree; ++i)
    for (int axis = 0; axis < curve.dimension; ++axis)
      fmt::print("  {}[{}]{:<7}{}\n", axis_name(axis), i, "", both(static_cast<double>(curve(axis, i))));
  for (std::size_t i = 0; i < curve.weights.size(); ++i)
    fmt::print("  w[{}]{:<7}{}\n", i, "", both(static_cast<double>(curve.weights[i])));
}

template <class Scalar>
void print_input(const judge::TrialInputs<Scalar>& inputs) {
  const auto curve = inputs.curve();
  fmt::print("\ninput\n  t          {}\n", both(inputs.true_t()));
  print_points(curve);
}

template <class Scalar>
void print_converted(const Kernel<Scalar>& kernel, const judge::TrialInputs<Scalar>& inputs) {
  if (kernel.converted == nullptr) return;
  std::vector<Scalar> coefficients;
  kernel.converted(inputs.curve(), coefficients);
  fmt::print("\nconverted to {} form, point by point\n", name(kernel.evaluated_form));
  for (const Scalar value : coefficients) fmt::print("  {}\n", both(static_cast<double>(value)));
}

void print_sources(const judge::ErrorSources& sources) {
  fmt::print(
      "\nwhere the error comes from, distances between exact points\n  conversion         {}\n  rounding of 1-t    {}\n"
      "  evaluation         {}\n",
      number::decimal(sources.conversion), number::decimal(sources.one_minus_t), number::decimal(sources.evaluation));
}

void print_result(const judge::PointVerdict& verdict, const reference::ExactPoint& truth) {
  fmt::print("\nresult\n");
  for (int axis = 0; axis < truth.dimension; ++axis)
    fmt::print("  {} computed {}\n    exact    {}\n", axis_name(axis),
               both(verdict.point[static_cast<std::size_t>(axis)]),
               both(reference::round_to(reference::binary64, truth.coordinate(axis))));
  fmt::print("  error      {}\n  in u p~    {}\n", number::decimal(verdict.error), number::decimal(verdict.error_u));
  if (verdict.bound_u) fmt::print("  bound      {}\n", number::decimal(*verdict.bound_u));
}

/// Prints what is found of the record and of the point that was computed again.
template <class Scalar>
Exit print_replay(const std::string& id, const WorstRecord& record, const sample::Cell& cell,
                  const Kernel<Scalar>* kernel, const judge::TrialInputs<Scalar>& inputs,
                  judge::PointJudge<Scalar>& judge, const judge::PointVerdict& verdict) {
  const double recorded = record.number("error");
  const double recorded_u = record.error_u();
  const auto& truth = judge.truth(inputs);
  fmt::print("{}\n",
             printable(fmt::format("{}: study {}, method {}, {} {}, degree {}", id, record.text("study"),
                                   record.text("method"), record.text("scalar"), record.text("form"), cell.degree)));
  print_input(inputs);
  print_converted(*kernel, inputs);
  if (verdict.finite) {
    judge::SourceMeter<Scalar> meter;
    const std::span<const double> point(verdict.point.data(), static_cast<std::size_t>(cell.dimension));
    if (const auto sources = meter.measure(*kernel, inputs.curve(), inputs.t(), point, truth)) print_sources(*sources);
  }
  print_result(verdict, truth);
  const bool same = verdict.finite && verdict.error == recorded && verdict.error_u == recorded_u;
  fmt::print("  recorded   {}, {} u p~: {}\n", number::decimal(recorded), number::decimal(recorded_u),
             same ? "the same" : "DIFFERENT");
  if (!same)
    say("the recorded error is not what this program computes; compare the builds with `bezierbench --version`");
  return same ? Exit::fine : Exit::finding;
}

template <class Scalar>
Exit replay(const std::string& id, const WorstRecord& record, const sample::Cell& cell) {
  const auto* kernel = judge::find_method<Scalar>(record.text("method"), cell.form, cell.dimension);
  if (kernel == nullptr) record.malformed("method", "is not one that this program knows");
  judge::TrialInputs<Scalar> inputs(cell.form, cell);
  inputs.assign(record.input(cell));
  judge::PointJudge<Scalar> judge;
  return print_replay(id, record, cell, kernel, inputs, judge, judge.judge(*kernel, inputs));
}

/// Asks an external method again.
template <class Scalar>
Exit replay_external(const std::string& id, const WorstRecord& record, const sample::Cell& cell,
                     const external::Methods& given) {
  const auto& name = record.text("method");
  const auto* method = external::find(given, name);
  if (method == nullptr)
    throw Failure(Exit::usage, "{}: {} is an external method; give it with --plugin, --program or --answers", id, name);
  judge::TrialInputs<Scalar> inputs(cell.form, cell);
  inputs.assign(record.input(cell));
  external::Batch batch{
      .scalar = record.scalar(), .form = cell.form, .dimension = cell.dimension, .degree = cell.degree};
  const double t = inputs.true_t();
  batch.add(inputs.true_curve(), std::span(&t, 1));
  const auto answer = method->ask(batch);
  if (answer.status != external::Status::ok) {
    say(fmt::format("{}: {} at this input: {}; see docs/own_method.md", name, external::name(answer.status),
                    answer.detail));
    return Exit::finding;
  }
  const studies::JudgedExternal judged(method->record(), cell.form, method);
  const auto& kernel = judged.described<Scalar>(cell.dimension);
  const std::vector<Scalar> point(answer.numbers.begin(), answer.numbers.end());
  judge::PointJudge<Scalar> judge;
  return print_replay(id, record, cell, &kernel, inputs, judge,
                      judge.judge(kernel, inputs, std::span<const Scalar>(point)));
}

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
  const auto* kernel = judge::find_method<Scalar>(record.text("method"), cell.form, cell.dimension);
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
  print_points(CurveView<Scalar>{cell.form, cell.dimension, cell.degree, input.coefficients});

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

/// Asks the method for the points of the recorded input again, prints them and by how much they break the property.
/// `fine` where the input breaks it, as recorded, or where none was found, is as far from that as recorded; else
/// `finding`. Throws Failure(usage) for a row without an input, Failure(input_output) for a field that is malformed.
Exit replay_property(const std::string& id, const WorstRecord& record, const sample::Cell& cell) {
  if (record.text("t").empty())
    throw Failure(Exit::usage, "{}: is proved, so that there is no input; see docs/guarantees.md", id);
  return record.scalar() == suite::ScalarKind::float32 ? asked_again<float>(id, record, cell)
                                                       : asked_again<double>(id, record, cell);
}

void print_side(std::string_view axis, std::string_view side, double computed, double tightest,
                const studies::SideError& error) {
  fmt::print("  {} {:<4} computed {}\n         tightest {}\n         {} doubles {}\n", axis, side, both(computed),
             both(tightest), number::decimal(std::abs(error.ulp)), error.ulp < 0 ? "inside" : "outside");
}

/// Asks the method for the box of the recorded curve again and prints each side beside the tightest one. `fine` where a
/// point of the curve is outside, as recorded, else `finding`. Throws Failure(usage) for a row without a curve,
/// Failure(input_output) for a field that is malformed.
Exit replay_box(const std::string& id, const WorstRecord& record, const sample::Cell& cell) {
  if (record.text("coefficients").empty())
    throw Failure(Exit::usage, "{}: has no curve with a point outside; see the rows whose column contains says refuted",
                  id);
  const auto kernels = bounds_kernels(cell.dimension);
  const auto method = std::ranges::find_if(
      kernels, [&](const auto& one) { return one.info->id == record.text("method") && one.info->form == cell.form; });
  if (method == kernels.end()) record.malformed("method", "is not one that this program knows");
  studies::BoundsProblem::Drawn drawn;
  drawn.trial = record.input(cell);
  drawn.curve = {cell.form, cell.dimension, cell.degree, drawn.trial.coefficients, drawn.trial.weights};
  studies::BoundsProblem::find_truth(drawn);
  studies::BoundsProblem::Answer box;
  studies::BoundsProblem::ask(*method, drawn, 0, box);

  fmt::print("{}\n\ninput\n",
             printable(fmt::format("{}: study {}, method {}, {} {}, degree {}", id, record.text("study"),
                                   record.text("method"), record.text("scalar"), record.text("form"), cell.degree)));
  print_points(drawn.curve);
  fmt::print("\nresult\n");
  bool is_outside = false;
  for (int axis = 0; axis < cell.dimension; ++axis) {
    const auto& tightest = drawn.truth[static_cast<std::size_t>(axis)];
    const double low = box[2 * static_cast<std::size_t>(axis)];
    const double high = box[2 * static_cast<std::size_t>(axis) + 1];
    const auto below = studies::side_error(low, tightest.low);
    const auto above = studies::side_error(-high, -tightest.high);
    print_side(axis_name(axis), "low", low, tightest.low, below);
    print_side(axis_name(axis), "high", high, tightest.high, above);
    is_outside = is_outside || below.ulp < 0 || above.ulp < 0;
  }
  fmt::print("  recorded   {}: {}\n", printable(record.text("contains")), is_outside ? "the same" : "DIFFERENT");
  if (!is_outside)
    say("what is recorded is not what this program computes; compare the builds with `bezierbench --version`");
  return is_outside ? Exit::fine : Exit::finding;
}

}  // namespace

void add_replay(Command program, Exit& exit, std::span<const external::OwnMethod> own) {
  struct Options {
    std::string bundle;
    std::string id;
    std::optional<std::string> answers;
  };
  auto options = std::make_shared<Options>();
  auto command = program.command("replay", "recompute one recorded worst case or counterexample");
  command.option("BUNDLE", options->bundle, "folder of the bundle").required();
  command.option("ID", options->id, "a worst_id, search_id or guarantee_id of the bundle, or bounds.csv:LINE")
      .required();
  auto external = std::make_shared<ExternalOptions>(own);
  external->add(command);
  command.option("--answers", options->answers, "the file that `judge` read").takes(file_value);
  command.action([options, external, &exit] {
    const WorstRecord record = find_worst_record(bundle::BundleDirectory::open(options->bundle), options->id);
    const auto cell = record.cell();
    if (record.about() != Recorded::point) {
      exit = (record.about() == Recorded::property ? replay_property : replay_box)(options->id, record, cell);
      return;
    }
    external::Methods given;
    const bool is_external = suite::is_external(record.text("method"));
    if (is_external) given = external->methods();
    if (is_external && options->answers) given.push_back(read_answers(*options->answers, record.text("method")));
    exit = judge::with_scalar(record.scalar(), [&]<class Scalar>(Scalar /*zero*/) {
      return is_external ? replay_external<Scalar>(options->id, record, cell, given)
                         : replay<Scalar>(options->id, record, cell);
    });
  });
}

}  // namespace bezierbench::cli
