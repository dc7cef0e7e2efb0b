// SPDX-License-Identifier: MIT
// The methods that the --method options of a `curve` command name.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::cli {

/// Whether the method takes a curve of this form and degree.
bool applies(const MethodInfo& info, const CurveFile& curve);

/// Why the method does not take the curve, for messages.
std::string why_not(const MethodInfo& info, const CurveFile& curve);

/// Throws Failure(usage) for a curve in `file` that no method takes. `any` is one of the problem's methods.
[[noreturn]] void refuse_curve(const std::string& file, const CurveFile& curve, const MethodInfo& any);

/// The ids of `infos`, in their order.
std::vector<std::string> ids_of(std::span<const MethodInfo* const> infos);

/// The ids of a table's entries, in its order. Entries have an `info`.
template <class Table>
std::vector<std::string> ids_in(const Table& table) {
  std::vector<std::string> ids;
  for (const auto& entry : table) ids.emplace_back(entry.info->id);
  return ids;
}

/// Throws Failure(usage) for a method `id` that does not exist, or that this build lacks. `known` are the valid ids.
[[noreturn]] void unknown_method(const std::string& id, const std::vector<std::string>& known);

/// The finite parameter in the text of an option. Throws Failure(usage) that names the option.
double finite_option(const std::string& option, const std::string& text);

/// The finite numbers, separated by commas, in the text of an option. Throws likewise.
std::vector<double> finite_numbers(const std::string& option, const std::string& text);

/// The entries named by `ids`, in the order of the names; without names all that apply, in the order of the roster.
/// Entries have an `info`.
template <class Table>
std::vector<const typename Table::element_type*> chosen(Table table, const std::vector<std::string>& ids,
                                                        const CurveFile& curve, const std::vector<std::string>& known) {
  std::vector<const typename Table::element_type*> result;
  for (const auto& id : ids) {
    const typename Table::element_type* candidate = nullptr;
    for (const auto& entry : table)  // several forms may have an entry of this id
      if (entry.info->id == id && (candidate == nullptr || applies(*entry.info, curve))) candidate = &entry;
    if (candidate == nullptr) unknown_method(id, known);
    if (!applies(*candidate->info, curve))
      throw Failure(Exit::usage, fmt::format("--method {}: {}", id, why_not(*candidate->info, curve)));
    result.push_back(candidate);
  }
  if (!ids.empty()) return result;
  for (const auto& entry : table)
    if (applies(*entry.info, curve) && !suite::is_peer(entry.info->id)) result.push_back(&entry);
  return result;
}

}  // namespace bezierbench::cli
