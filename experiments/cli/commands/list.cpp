// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/aligned.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/commands/kinds.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/suite/kinds.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/reader.hpp"
#include "shipped_suites.hpp"

namespace bezierbench::cli {
namespace {

std::string suites_csv() {
  const auto known = vocabulary_of_all_builds();
  bundle::CsvTable table({"id", "file", "seed", "studies", "seconds", "title"});
  for (const auto& [file_name, text] : shipped_suites)
    for (const auto& one : suite::parse_suites(text, file_name, known)) {
      const auto seconds = suite::declared_seconds(text);
      table.add_row({one.id, std::string(file_name), std::to_string(one.seed), std::to_string(one.studies.size()),
                     seconds ? std::to_string(*seconds) : "", one.title});
    }
  return table.text();
}

std::string studies_csv() {
  const auto known = vocabulary_of_all_builds();
  bundle::CsvTable table({"id", "suite", "kind", "curve", "title"});
  for (const auto& [file_name, text] : shipped_suites)
    for (const auto& one : suite::parse_suites(text, file_name, known))
      for (const auto& study : one.studies)
        table.add_row({study.id, one.id, std::string(suite::kind_of(study).id), std::string(suite::name(study.curve)),
                       study.title});
  return table.text();
}

void add_topic(Command list, const std::string& topic, const std::string& help, const std::function<std::string()>& csv,
               const std::shared_ptr<std::string>& format) {
  auto command = list.command(topic, help);
  command.takes_options_of_its_parent();
  command.action([csv, format] {
    const auto text = csv();
    fmt::print("{}", *format == "csv" ? text : aligned_csv(text));
  });
}

/// A topic with its own layout, since its texts are too long for a table.
void add_kinds(Command list) {
  struct Options {
    std::optional<std::string> kind;
    bool schema = false;
  };
  auto options = std::make_shared<Options>();
  auto command = list.command("kinds", "the kinds of studies and the keys that each of them has in a suite");
  command.option("kind", options->kind, "only this kind, with an example");
  command.flag("--json-schema", options->schema, "a JSON Schema of suite files instead, for editors");
  command.action([options] {
    fmt::print("{}", options->schema ? suite_schema() : options->kind ? kind_text(*options->kind) : kinds_text());
  });
}

}  // namespace

void add_list(Command program, Exit& /*exit*/, std::span<const outside::OwnMethod> own) {
  auto format = std::make_shared<std::string>("text");
  auto list = program.command("list", "what there is to run");
  list.option("--format", *format, "text or csv").one_of({"text", "csv"});
  list.needs_command();
  const auto methods = [own] {
    std::vector<suite::OutsideMethod> records;
    for (const auto& method : own) records.push_back(outside::own(method, {}, nullptr)->record());
    return methods_csv(records);
  };
  add_topic(list, "methods", "evaluators, converted paths and conversions", methods, format);
  add_topic(list, "suites", "the suites that come with the program, and the processor time that each takes, in seconds",
            suites_csv, format);
  add_topic(list, "studies", "their studies", studies_csv, format);
  add_kinds(list);
  add_topic(list, "generators", "how random inputs are drawn", generators_csv, format);
}

}  // namespace bezierbench::cli
