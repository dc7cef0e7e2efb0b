// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "build_facts.hpp"
#include "core/evaluate/kernel.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/judge/companions.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/sample/draw.hpp"
#include "git_facts.hpp"
#include "reference/published/published.hpp"

namespace bezierbench::cli {
namespace {

constexpr int any_dimension = 2;

void add_once(std::vector<std::string>& ids, std::string_view id) {
  if (std::ranges::find(ids, id) == ids.end()) ids.emplace_back(id);
}

void add_row(bundle::CsvTable& table, const MethodInfo& info) {
  table.add_row({std::string(info.id), std::string(name(info.problem)), std::string(name(info.form)),
                 std::to_string(info.min_degree), std::to_string(info.max_degree),
                 std::string(info.bound ? info.bound->text : info.promise), info.bit_stable ? "yes" : "no",
                 std::string(info.flops), std::string(info.citation)});
}

}  // namespace

suite::Vocabulary vocabulary() {
  suite::Vocabulary known;
  for (const auto& kernel : judge::methods<double>(any_dimension)) add_once(known.methods, kernel.info->id);
  for (const auto* info : judge::companion_infos()) add_once(known.methods, info->id);
  for (const auto& peer : peers::absent())
    known.absent_methods.push_back({std::string(peer.id), std::string(peer.remedy)});
  for (const auto& kernel : conversion_kernels<double>(any_dimension)) add_once(known.conversions, kernel.info->id);
  for (const auto& generator : sample::generators())
    known.generators.push_back({std::string(generator.id), generator.limits});
  for (const auto& table : reference::published_tables()) known.published_files.emplace_back(table.file_name);
  return known;
}

suite::Vocabulary vocabulary_of_all_builds() {
  auto known = vocabulary();
  for (auto& method : known.absent_methods) known.methods.push_back(std::move(method.id));
  known.absent_methods.clear();
  return known;
}

std::string methods_csv() {
  bundle::CsvTable table(
      {"id", "problem", "form", "min_degree", "max_degree", "bound", "bit_stable", "flops", "citation"});
  for (const auto& kernel : judge::methods<double>(any_dimension)) add_row(table, *kernel.info);
  for (const auto* info : conversion_infos()) add_row(table, *info);
  for (const auto* info : judge::companion_infos()) add_row(table, *info);
  return table.text();
}

std::string generators_csv() {
  bundle::CsvTable table({"id", "coordinates", "t", "weights"});
  for (const auto& generator : sample::generators())
    table.add_row({std::string(generator.id), std::string(generator.coordinates), std::string(generator.t),
                   std::string(generator.weights)});
  return table.text();
}

std::string version_line() {
  return fmt::format("bezierbench {} ({}, {}{})", program_version, compiler, git_commit, git_clean ? "" : ", modified");
}

}  // namespace bezierbench::cli
