// SPDX-License-Identifier: MIT
#include "experiments/compare/side.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/folder.hpp"

namespace bezierbench::compare {
namespace {

constexpr std::string_view unknown = "unknown";

void read_facts(const bundle::BundleDirectory& directory, std::string_view file, Side& side) {
  std::ranges::move(bundle::facts(directory.read(file), (directory.path() / file).string()),
                    std::back_inserter(side.facts));
}

void read_table(const bundle::BundleDirectory& directory, std::string_view file, Side& side) {
  if (!directory.has(file)) return;
  side.tables.emplace(file, bundle::parse_csv(directory.read(file), (directory.path() / file).string()));
}

}  // namespace

std::string Side::fact(std::string_view fact_name) const {
  const auto found = std::ranges::find(facts, fact_name, &bundle::Fact::name);
  return found == facts.end() ? std::string(unknown) : found->value;
}

const bundle::CsvDocument* Side::table(const std::string& file) const {
  const auto found = tables.find(file);
  return found == tables.end() ? nullptr : &found->second;
}

Side read_side(const std::filesystem::path& path) {
  const auto directory = bundle::BundleDirectory::open(path);
  Side side{.name = path.string(), .manifest = directory.manifest(), .facts = {}, .tables = {}};
  read_facts(directory, "machine.json", side);
  read_facts(directory, bundle::manifest_name, side);
  for (const auto file : bundle::deterministic_files) read_table(directory, file, side);
  read_table(directory, timing_file, side);
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
