// SPDX-License-Identifier: MIT
// `inputs`: the inputs of accuracy studies as CSV, for methods that run elsewhere. `judge`: the errors of the
// answers, as accuracy.csv has them.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <sstream>
#include <utility>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/external/external_options.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/external/method.hpp"
#include "experiments/failure.hpp"
#include "experiments/judge/input_fields.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::size_t drawn_before_trial = 4;  ///< the others of tables::drawn_columns() come last

const std::vector<std::string>& columns_of_inputs() {
  static const auto all = [] {
    std::vector<std::string> names{"suite", "seed", "study", "trials", "form", "dimension", "degree"};
    const auto append = [&](const auto& more) { names.insert(names.end(), more.begin(), more.end()); };
    append(std::span(tables::drawn_columns()).first(drawn_before_trial));
    names.emplace_back("trial");
    append(judge::input_columns());
    append(external::answer_columns);
    append(std::span(tables::drawn_columns()).subspan(drawn_before_trial));
    return names;
  }();
  return all;
}

bool has_inputs(const suite::Study& study) {
  return studies::is_kind(study, studies::accuracy_kind) &&
         std::ranges::count(study.scalar, suite::ScalarKind::float64) > 0;
}

/// Visits the cells of a study, with those of its studies that they are of.
template <class Visit>
void each_cell(const suite::Study& study, const Visit& visit) {
  for (const auto& one : sample::studies_of(study))
    for (const auto& cell : sample::cells(one)) visit(one, cell);
}

void add_cell(const suite::Suite& of, const suite::Study& study, const sample::Cell& cell, bundle::CsvTable& table) {
  const sample::Sampler sampler(of.seed, study.id, cell);
  sample::Trial trial;
  for (std::int64_t k = 0; k < study.trials; ++k) {
    sampler.draw(static_cast<std::uint64_t>(k), trial);
    std::vector<std::string> fields{of.id,
                                    std::to_string(of.seed),
                                    study.id,
                                    std::to_string(study.trials),
                                    std::string(name(study.form)),
                                    std::to_string(cell.dimension),
                                    std::to_string(cell.degree)};
    const auto append = [&](const std::vector<std::string>& more) {
      fields.insert(fields.end(), more.begin(), more.end());
    };
    const auto drawn = tables::drawn_fields(cell);
    for (std::size_t column = 0; column < drawn_before_trial; ++column) fields.push_back(tables::text(drawn[column]));
    fields.push_back(std::to_string(k));
    append(judge::input_fields(trial, cell.dimension));
    append(std::vector<std::string>(external::answer_columns.size()));
    for (std::size_t column = drawn_before_trial; column < drawn.size(); ++column)
      fields.push_back(tables::text(drawn[column]));
    table.add_row(std::move(fields));
  }
}

template <class T>
void add_once(std::vector<T>& values, const T& value) {
  if (std::ranges::find(values, value) == values.end()) values.push_back(value);
}

template <class T>
T& find_or_add(std::vector<T>& all, const std::string& id) {
  const auto found = std::ranges::find(all, id, &T::id);
  if (found != all.end()) return *found;
  all.emplace_back().id = id;
  return all.back();
}

/// The inputs of rows that are of curve sets, by set: each row is a curve with its parameter.
using GivenSets = std::map<std::string, curves::CurveSet>;

/// Adds the values of one row to the axes of its study, or its input to `given`.
void add_row(const bundle::CsvDocument& table, std::size_t row, const std::string& method,
             std::vector<suite::Suite>& suites, GivenSets& given) {
  const auto read = [&](std::string_view column, auto parse, std::string_view what) {
    if (const auto value = parse(table.at(row, column))) return *value;
    throw Failure(Exit::input_output, "{}:{}: {} is not {}; leave the columns of `bezierbench inputs` as they are",
                  table.file_name(), table.line(row), column, what);
  };
  const auto number = [&](std::string_view column) { return read(column, number::parse_number, "a number"); };
  const auto whole = [&](std::string_view column) { return read(column, number::parse_integer, "a whole number"); };
  auto& of = find_or_add(suites, table.at(row, "suite"));
  of.title = "Inputs answered elsewhere";
  of.seed = static_cast<std::uint64_t>(whole("seed"));
  const bool is_new = std::ranges::find(of.studies, table.at(row, "study"), &suite::Study::id) == of.studies.end();
  auto& study = find_or_add(of.studies, table.at(row, "study"));
  if (is_new) {
    study.kind = &studies::accuracy_kind.asks;
    study.title = "Inputs answered elsewhere";
    study.coordinate_range.clear();
    study.t_interval.clear();
    study.generator.clear();
    study.dimension.clear();
    study.methods = {method};
    study.trials = whole("trials");
  }
  const auto small = [&](std::string_view column) {
    return static_cast<int>(
        std::clamp<std::int64_t>(whole(column), -1, max_degree + 1));  // the checks refuse both ends
  };
  const auto form = suite::parse<Form>(table.at(row, "form"));
  if (const auto set = table.has_column("curves") ? table.at(row, "curves") : ""; !set.empty()) {
    if (given.try_emplace(set).second) study.curves.push_back(set);
    study.parameters_from = suite::ParameterSource::stored;
    study.dimension.clear();
    sample::Cell cell;
    cell.form = form.value_or(Form::bernstein);
    cell.dimension = small("dimension");
    cell.degree = small("degree");
    const auto input = read(
        "coefficients",
        [&](const std::string& coefficients) {
          const bool is_curve =
              form && cell.dimension >= 1 && cell.dimension <= 3 && cell.degree >= 0 && cell.degree <= max_degree;
          return is_curve ? judge::parse_input({table.at(row, "t"), coefficients, table.at(row, "weights")}, cell)
                          : std::nullopt;
        },
        "a curve of this form, dimension and degree");
    given[set].add(table.at(row, "trial"), {cell.form, cell.dimension, cell.degree, input.coefficients, input.weights},
                   true, std::span(&input.t, 1));
    return;
  }
  if (form) study.form = *form;
  add_once(study.dimension, small("dimension"));
  add_once(study.degree, small("degree"));
  add_once(study.coordinate_range, number("coordinate_range"));
  add_once(study.t_interval, suite::Interval{number("t_min"), number("t_max")});
  add_once(study.generator, table.at(row, "generator"));
}

/// The fields of judge::input_columns(), in the program's spelling of numbers: a file may have another.
std::vector<std::string> input_of(const bundle::CsvDocument& table, std::size_t row) {
  std::vector<std::string> fields;
  for (const auto& column : judge::input_columns()) {
    std::istringstream words(table.at(row, column));
    auto& field = fields.emplace_back();
    for (std::string word; words >> word;) {
      const auto value = number::parse_number(word);
      field += (field.empty() ? "" : " ") + (value ? number::hexadecimal(*value) : word);
    }
  }
  return fields;
}

/// The inputs of the trials of a study.
std::set<std::vector<std::string>> drawn_inputs(const suite::Suite& of, const suite::Study& study) {
  std::set<std::vector<std::string>> inputs;
  sample::Trial trial;
  each_cell(study, [&](const suite::Study& one, const sample::Cell& cell) {
    const sample::Sampler sampler(of.seed, one.id, cell);
    for (std::int64_t k = 0; k < one.trials; ++k) {
      sampler.draw(static_cast<std::uint64_t>(k), trial);
      inputs.insert(judge::input_fields(trial, cell.dimension));
    }
  });
  return inputs;
}

/// A row for each trial of the first replicate of each cell in double of the accuracy studies, with empty answers.
/// Throws Failure(usage) where there is no such study, and for more than a gigabyte of inputs.
bundle::CsvTable input_table(const std::vector<suite::Suite>& suites) {
  constexpr double largest = 1e9;
  double bytes = 0;
  for (const auto& one : suites)
    for (const auto& study : one.studies)
      if (has_inputs(study))
        each_cell(study, [&](const suite::Study& of, const sample::Cell& cell) {
          bytes += static_cast<double>(of.trials) * static_cast<double>(judge::bytes_of_input(cell));
        });
  if (bytes == 0)
    throw Failure(Exit::usage, "no study is of kind accuracy in double; choose other suites, see `list studies`");
  if (bytes > largest)
    throw Failure(Exit::usage, "the inputs would take {:.0f} GB; choose fewer with --trials, --only or --set",
                  bytes / largest);
  bundle::CsvTable table(columns_of_inputs());
  for (const auto& one : suites)
    for (const auto& study : one.studies)
      if (has_inputs(study))
        each_cell(study, [&](const suite::Study& of, const sample::Cell& cell) { add_cell(one, of, cell, table); });
  return table;
}

/// Gives a study its sets, which no file has.
void use_given(suite::Study& study, const GivenSets& given) {
  for (const auto& id : study.curves) {
    study.sets.push_back(set_of(id, given.at(id)));
    study.curves_sha256.push_back(study.sets.back()->sha256);
  }
}

/// A line for each study of which the table has inputs that the study does not draw.
std::vector<std::string> foreign_inputs(const bundle::CsvDocument& table, const std::vector<suite::Suite>& suites) {
  std::vector<std::string> findings;
  for (const auto& of : suites)
    for (const auto& study : of.studies) {
      const auto drawn = drawn_inputs(of, study);
      std::vector<std::size_t> foreign;
      std::size_t all = 0;
      for (std::size_t row = 0; row < table.row_count(); ++row) {
        if (table.at(row, "suite") != of.id || table.at(row, "study") != study.id) continue;
        ++all;
        if (!drawn.contains(input_of(table, row))) foreign.push_back(table.line(row));
      }
      if (foreign.empty()) continue;
      const auto what = foreign.size() == all
                            ? fmt::format("{}: suite {} with this seed has no study {} with these {} inputs",
                                          table.file_name(), of.id, study.id, all)
                            : fmt::format("{}:{}: {} input{} not in this suite; this is the first", table.file_name(),
                                          foreign.front(), foreign.size(), foreign.size() == 1 ? " is" : "s are");
      findings.push_back(what + "; leave the columns of `bezierbench inputs` as they are");
    }
  return findings;
}

/// The suites of a table of inputs, with one replicate of each study and `method` as its only method. Throws
/// Failure(input_output) for another table.
std::vector<suite::Suite> suites_of(const bundle::CsvDocument& table, const std::string& method) {
  std::vector<suite::Suite> suites;
  GivenSets given;
  for (std::size_t row = 0; row < table.row_count(); ++row) add_row(table, row, method, suites, given);
  if (suites.empty())
    throw Failure(Exit::input_output, "{}: has no rows; leave the columns of `bezierbench inputs` as they are",
                  table.file_name());
  auto known = vocabulary();
  known.methods.push_back(method);
  try {  // what a file says goes through the checks of a suite
    auto checked = suite::parse_suites(suite::to_toml(suites), "suite.toml", known);
    for (auto& of : checked)
      for (auto& study : of.studies) use_given(study, given);
    return checked;
  } catch (const Failure& failure) {
    throw Failure(Exit::input_output,
                  "{}: is not of a suite ({}); leave the columns of `bezierbench inputs` as they are",
                  table.file_name(), failure.what());
  }
}

struct JudgeOptions {
  std::string file;
  std::optional<std::string> id;
  std::optional<std::string> out;
};

/// Prints the rows of accuracy.csv; a status that is not ok is a finding.
Exit print_rows(const run::RunRequest& request, const external::Method& method) {
  tables::Tables tables;
  for (const auto& one : request.suites)
    for (const auto& written : one.studies)
      for (const auto& study : sample::studies_of(written)) {
        const auto job = studies::external_job(study, method.record(), &method, {one.seed, request.tier});
        if (!job) continue;
        run::run_all(*job);
        job->write(tables);
      }
  const auto& table = tables.table("accuracy.csv");
  fmt::print("{}", table.text());
  const auto is_ok = [](const tables::Row& row) { return row.field("status") == tables::field("ok"); };
  return std::ranges::all_of(table.rows(), is_ok) ? Exit::fine : Exit::finding;
}

Exit judge(const JudgeOptions& options) {
  const external::Methods methods{read_answers(options.file, options.id)};
  auto request = request_of_this_build(methods);
  const auto table = bundle::parse_csv(bundle::read_file(options.file), options.file);
  request.suites = suites_of(table, methods.front()->record().id);
  auto findings = foreign_inputs(table, request.suites);
  if (!options.out) return std::max(print_rows(request, *methods.front()), say_findings(findings));
  if (options.out->empty()) throw Failure(Exit::usage, "--out: is empty; name a folder");
  request.curve_files = curves_beside(request.suites);
  request.out = *options.out;
  request.quiet = true;
  const auto of_run = run::run(request).findings;
  findings.insert(findings.end(), of_run.begin(), of_run.end());
  return say_findings(findings);
}

}  // namespace

void add_inputs(Command program, Exit& exit) {
  struct Options {
    SuiteOptions suites;
    std::string out;
  };
  auto options = std::make_shared<Options>();
  auto command = program.command(
      "inputs", "write the inputs of a suite's accuracy studies as CSV, for methods that run elsewhere");
  options->suites.add_suites(command);
  options->suites.add_curves(command);
  command.option("--out", options->out, "output file").required().takes(file_value);
  options->suites.add_changes(command);
  command.action([options, &exit] {
    if (options->out.empty()) throw Failure(Exit::usage, "--out: is empty; name a file");
    bundle::write_file(options->out, input_table(options->suites.read(vocabulary())).text());
    exit = Exit::fine;
  });
}

void add_judge(Command program, Exit& exit) {
  auto options = std::make_shared<JudgeOptions>();
  auto command = program.command("judge", "judge answers that were computed elsewhere");
  command.option("FILE", options->file, "the file that `inputs` wrote, with the answers in the columns x, y and z")
      .required()
      .takes(file_value);
  command.option("--id", options->id, "id of the method, answers_NAME; default: from the name of the file");
  command.option("--out", options->out, "write a bundle to this folder; default: print the rows of accuracy.csv")
      .takes(folder_value);
  command.action([options, &exit] { exit = judge(*options); });
}

}  // namespace bezierbench::cli
