// SPDX-License-Identifier: MIT
#include "experiments/compare/side.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/schema/columns.hpp"

namespace bezierbench::compare {
namespace {

constexpr std::string_view unknown = "unknown";

}  // namespace

std::string Side::fact(std::string_view fact_name) const {
  const auto found = std::ranges::find(facts, fact_name, &bundle::Fact::name);
  return found == facts.end() ? std::string(unknown) : found->value;
}

const bundle::CsvDocument& Side::table(const std::string& file) const {
  static const bundle::CsvDocument none;
  const auto found = tables.find(file);
  return found == tables.end() ? none : found->second;
}

Side read_side(const std::filesystem::path& path) {
  const auto bundle = bundle::BundleDirectory::open(path);
  Side side{.name = path.string(), .manifest = bundle.manifest()};
  for (const auto file : {std::string_view("machine.json"), bundle::manifest_name})
    std::ranges::move(bundle::facts(bundle.read_listed(file), bundle.place(file)), std::back_inserter(side.facts));
  for (const auto& declared : bundle::declared_tables())
    if (declared.is_deterministic || declared.file == timing_file || declared.file == cost_file)
      if (auto table = bundle.table(declared.file)) side.tables.emplace(declared.file, std::move(*table));
  return side;
}

std::vector<FactDifference> fact_differences(const Side& a, const Side& b) {
  std::vector<FactDifference> differences;
  for (const auto& [name, value] : a.facts)
    if (const auto other = b.fact(name); other != value) differences.push_back({name, value, other});
  for (const auto& [name, value] : b.facts)
    if (std::ranges::find(a.facts, name, &bundle::Fact::name) == a.facts.end() && value != unknown)
      differences.push_back({name, std::string(unknown), value});
  return differences;
}

bool same_machine(const Side& a, const Side& b) {
  constexpr std::array<std::string_view, 3> groups{"cpu.", "caches.", "memory."};
  if (a.fact("cpu.model_name") == unknown) return false;
  return std::ranges::none_of(fact_differences(a, b), [&](const auto& difference) {
    return std::ranges::any_of(groups, [&](const auto group) { return difference.name.starts_with(group); });
  });
}

}  // namespace bezierbench::compare
