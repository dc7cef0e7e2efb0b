// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/commands/kinds.hpp"
#include "experiments/cli/commands/worked.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/external/method.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/terminal.hpp"

namespace bezierbench::cli {
namespace {

/// A suite that comes with the program.
struct Shipped {
  std::string file_name;
  std::string text;
  suite::Suite suite;
};

std::vector<Shipped> all_shipped() {
  const auto known = vocabulary_of_all_builds();
  std::vector<Shipped> all;
  for (const auto& id : shipped_suites()) {
    const auto file = suite_file(id);
    auto text = bundle::read_file(file);
    auto one = suite::parse_suite(text, file.string(), known);
    all.push_back({file.filename().string(), std::move(text), std::move(one)});
  }
  return all;
}

std::string suites_csv() {
  bundle::CsvTable table({"id", "file", "seed", "studies", "seconds", "title"});
  for (const auto& [file_name, text, one] : all_shipped()) {
    const auto seconds = suite::declared_seconds(text);
    table.add_row({one.id, file_name, std::to_string(one.seed), std::to_string(one.studies.size()),
                   seconds ? std::to_string(*seconds) : "", one.title});
  }
  return table.text();
}

std::string studies_csv() {
  bundle::CsvTable table({"id", "suite", "kind", "form", "title"});
  for (const auto& shipped : all_shipped())
    for (const auto& study : shipped.suite.studies)
      table.add_row({study.id, shipped.suite.id, std::string(suite::kind_of(study).id), std::string(name(study.form)),
                     study.title});
  return table.text();
}

/// A CSV text for people, in the width of the terminal and without the columns that only programs need.
std::string fitted_csv(const std::string& csv, const std::vector<std::string>& for_programs) {
  const auto document = bundle::parse_csv(csv, "table");
  std::vector<std::vector<std::string>> lines(document.row_count() + 1);
  for (const auto& column : document.header()) {
    if (std::ranges::find(for_programs, column) != for_programs.end()) continue;
    lines.front().push_back(column);
    for (std::size_t row = 0; row < document.row_count(); ++row) lines[row + 1].push_back(document.at(row, column));
  }
  return fitted(std::move(lines), terminal_width(STDOUT_FILENO));
}

void add_topic(Command list, const std::string& topic, const std::string& help, const std::function<std::string()>& csv,
               const std::shared_ptr<std::string>& format, const std::vector<std::string>& for_programs = {}) {
  auto command = list.command(topic, help);
  command.option("--format", *format, "text fits the terminal, csv is for programs").one_of({"text", "csv"});
  command.action([csv, format, for_programs] {
    const auto text = csv();
    fmt::print("{}", *format == "csv" ? text : fitted_csv(text, for_programs));
  });
}

std::vector<std::string> ids_of_kinds() {
  std::vector<std::string> ids;
  for (const auto* kind : studies::kinds()) ids.emplace_back(kind->id);
  return ids;
}

/// A topic with its own layout, since its texts are too long for a table.
void add_kinds(Command list) {
  struct Options {
    std::optional<std::string> kind;
    bool schema = false;
  };
  auto options = std::make_shared<Options>();
  auto command = list.command("kinds", "the kinds of studies, with their keys in a suite");
  command.option("KIND", options->kind, "print this kind only, with an example").takes("KIND", ids_of_kinds);
  command.flag("--json-schema", options->schema, "print a JSON Schema of suite files instead, for editors");
  command.action([options] {
    fmt::print("{}", options->schema ? suite_schema() : options->kind ? kind_text(*options->kind) : kinds_text());
  });
}

}  // namespace

void add_list(Command program, Exit& /*exit*/, std::span<const external::OwnMethod> own) {
  auto format = std::make_shared<std::string>("text");
  auto list =
      program.command("list", "list methods, suites, studies, kinds of studies, generators, worked conversions");
  list.needs_command();
  const auto methods = [own] {
    std::vector<suite::ExternalMethod> records;
    for (const auto& method : own) records.push_back(external::own(method, {}, nullptr)->record());
    return methods_csv(records);
  };
  add_topic(list, "methods", "evaluators, converted paths and conversions", methods, format);
  add_topic(list, "suites", "the shipped suites, with the processor time that each takes in seconds", suites_csv,
            format, {"file", "seed"});
  add_topic(list, "studies", "the studies of the shipped suites", studies_csv, format);
  add_kinds(list);
  add_topic(list, "generators", "how random inputs are drawn", generators_csv, format);
  add_topic(list, "worked", "the worked conversions of the source report, judged", worked_csv, format);
}

}  // namespace bezierbench::cli
