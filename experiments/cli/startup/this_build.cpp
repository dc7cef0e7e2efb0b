// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/this_build.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "build_facts.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/race/counters.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/tables.hpp"
#include "git_facts.hpp"
#include "reference/published/published.hpp"

namespace bezierbench::cli {

run::RunRequest request_of_this_build(const external::Methods& external) {
  run::RunRequest request;
  request.kinds = {
      sample::studies_of, studies::make_job,
      [external](const suite::Study& study, const suite::ExternalMethod& method, const run::JobContext& context) {
        return studies::external_job(study, method, external::find(external, method.id), context);
      },
      studies::why_unasked};
  request.counters = race::Counters().state();
  request.build = {compiler, all_flags, build_type, fp_flags, program_version, {}};
  for (const auto& peer : peers::present())
    request.build.peers.emplace_back(std::string(peer.library), std::string(peer.library_version));
  request.git_commit = git_commit;
  request.git_clean = git_clean;
  request.generators_csv = generators_csv();
  std::vector<suite::ExternalMethod> records;
  for (const auto& method : external) records.push_back(method->record());
  record_external(request, std::move(records));
  return request;
}

void record_external(run::RunRequest& request, std::vector<suite::ExternalMethod> external) {
  request.external = std::move(external);
  request.methods_csv = methods_csv(request.external);
}

namespace {

constexpr int any_dimension = 2;

void add_once(std::vector<std::string>& ids, std::string_view id) {
  if (std::ranges::find(ids, id) == ids.end()) ids.emplace_back(id);
}

constexpr const char* methods_name = "methods.csv";
constexpr const char* generators_name = "generators.csv";

/// `finite monotone:1`
std::string guarantees_text(const MethodInfo& info) {
  std::vector<std::string> words;
  for (const auto& one : guarantees_of(info))
    words.push_back(one.max_degree < max_degree ? fmt::format("{}:{}", name(one.property), one.max_degree)
                                                : std::string(name(one.property)));
  std::ranges::sort(words);
  return fmt::format("{}", fmt::join(words, " "));
}

tables::Row row_of(const MethodInfo& info) {
  tables::Row row(methods_name);
  row.set("id", info.id)
      .set("problem", name(info.problem))
      .set("form", name(info.form))
      .set("min_degree", info.min_degree)
      .set("max_degree", info.max_degree)
      .set("bound", info.bound ? info.bound->text : info.promise)
      .set("bit_stable", info.bit_stable ? "yes" : "no")
      .set("flops", info.flops)
      .set("citation", info.citation)
      .set("guarantees", guarantees_text(info));
  return row;
}

}  // namespace

std::vector<const MethodInfo*> every_method() {
  std::vector<const MethodInfo*> all;
  for (const auto& kernel : judge::methods<double>(any_dimension)) all.push_back(kernel.info);
  for (const auto* info : conversion_infos()) all.push_back(info);
  for (const auto* info : studies::companion_infos()) all.push_back(info);
  return all;
}

suite::Vocabulary vocabulary() {
  suite::Vocabulary known;
  known.kinds = studies::kinds();
  for (const auto& kernel : judge::methods<double>(any_dimension)) add_once(known.methods, kernel.info->id);
  for (const auto* info : studies::companion_infos()) add_once(known.methods, info->id);
  for (const auto& peer : peers::absent())
    known.absent_methods.push_back({std::string(peer.id), std::string(peer.remedy)});
  for (const auto& kernel : conversion_kernels<double>(any_dimension)) add_once(known.conversions, kernel.info->id);
  for (const auto& generator : sample::generators())
    known.generators.push_back({std::string(generator.id), generator.limits});
  for (const auto& table : reference::published_tables())
    if (table.text.starts_with("table,"))
      known.published_files.emplace_back(table.file_name);  // the others have no cells
  return known;
}

suite::Vocabulary vocabulary_of_all_builds() {
  auto known = vocabulary();
  for (auto& method : known.absent_methods) known.methods.push_back(std::move(method.id));
  known.absent_methods.clear();
  return known;
}

std::string methods_csv(std::span<const suite::ExternalMethod> external) {
  tables::Tables tables;
  for (const auto* info : every_method()) tables.add(row_of(*info));
  for (const auto& method : external)
    for (const auto problem : method.problems)
      tables.add(row_of({.id = method.id,
                         .label = method.label,
                         .problem = problem,
                         .form = method.form,
                         .min_degree = method.min_degree,
                         .max_degree = method.max_degree,
                         .flops = "not known",
                         .citation = bundle::external_citation}));
  return tables.table(methods_name).text();
}

std::string generators_csv() {
  tables::Tables tables;
  for (const auto& generator : sample::generators())
    tables.add(tables::Row(generators_name)
                   .set("id", generator.id)
                   .set("coordinates", generator.coordinates)
                   .set("t", generator.t)
                   .set("weights", generator.weights));
  return tables.table(generators_name).text();
}

std::string version_line() {
  return fmt::format("bezierbench {} ({}, {}{})", program_version, compiler, git_commit, git_clean ? "" : ", modified");
}

namespace {

template <class Wanted>
std::vector<std::string> ids_where(Wanted wanted) {
  std::vector<std::string> ids;
  for (const auto* info : every_method())
    if (wanted(*info) && std::ranges::find(ids, info->id) == ids.end()) ids.emplace_back(info->id);
  return ids;
}

/// The values that a key takes where they are words; empty where they are numbers or texts.
std::vector<std::string> words_of(std::string_view key) {
  const auto known = vocabulary();
  if (key == "methods") return known.methods;
  if (key == "scalar") return suite::all_words<suite::ScalarKind>();
  if (key == "modes") return suite::all_words<suite::Mode>();
  if (key == "curve") return suite::all_words<Form>();
  std::vector<std::string> generators;
  if (key == "generator")
    for (const auto& generator : known.generators) generators.push_back(generator.id);
  return generators;
}

}  // namespace

KnownValues methods_of(Problem problem) {
  return [problem] { return ids_where([problem](const MethodInfo& info) { return info.problem == problem; }); };
}

KnownValues all_methods() {
  return [] { return ids_where([](const MethodInfo& /*info*/) { return true; }); };
}

std::vector<std::string> known_settings() {
  std::vector<std::string> settings;
  std::vector<std::string_view> keys;
  for (const auto* kind : studies::kinds())
    for (const auto* field : suite::fields_of(*kind))
      if (field->settable && std::ranges::find(keys, field->key) == keys.end()) keys.push_back(field->key);
  for (const auto key : keys) {
    const auto values = words_of(key);
    if (values.empty()) settings.push_back(std::string(key) + '=');
    for (const auto& value : values) settings.push_back(std::string(key) + '=' + value);
  }
  return settings;
}

}  // namespace bezierbench::cli
