// SPDX-License-Identifier: MIT
// The printed values of others, as the CSV files of this folder, each row with its source. report_tables.csv has the
// tables of [Report 001]; SOURCES.md lists the sources.
#pragma once

#include <span>
#include <string_view>

namespace bezierbench::reference {

struct PublishedTable {
  std::string_view file_name;
  std::string_view text;
};

/// Every CSV file of reference/published.
std::span<const PublishedTable> published_tables();

}  // namespace bezierbench::reference
