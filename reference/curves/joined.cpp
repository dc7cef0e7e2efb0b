// SPDX-License-Identifier: MIT
#include "reference/curves/joined.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "reference/curves/place.hpp"

namespace bezierbench::curves {
namespace {

/// Whether the ids of all files do not suffice to tell their curves apart.
bool clash(std::span<const NamedRead> files) {
  std::unordered_set<std::string_view> ids;
  for (const auto& file : files)
    for (std::size_t k = 0; k < file.read.set.size(); ++k)
      if (const auto id = file.read.set.id(k); id.empty() || !ids.insert(id).second) return true;
  return false;
}

}  // namespace

Read joined(std::span<const NamedRead> files) {
  const bool prefixed = files.size() > 1 && clash(files);
  std::unordered_set<std::string> stems;
  Read all;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const auto& [name, read] = files[f];
    auto stem = std::filesystem::path(name).stem().string();
    for (int number = 2; !stems.insert(stem).second; ++number)
      stem = fmt::format("{}-{}", std::filesystem::path(name).stem().string(), number);
    for (std::size_t k = 0; k < read.set.size(); ++k) {
      require_room(all.set, name);
      const auto id = read.set.id(k);
      const auto unique = id.empty() ? stem : fmt::format("{}:{}", stem, id);
      all.set.add(prefixed ? unique : id, read.set[k], read.set.begins_path(k), read.set.parameters(k));
    }
    for (const auto& [why, count] : read.left_out) all.left_out[why] += count;
  }
  return all;
}

}  // namespace bezierbench::curves
