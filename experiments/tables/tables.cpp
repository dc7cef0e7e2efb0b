// SPDX-License-Identifier: MIT
#include "experiments/tables/tables.hpp"

namespace bezierbench::tables {

bundle::CsvTable& Tables::table(const std::string& file, const std::vector<std::string>& columns) {
  return tables_.try_emplace(file, columns).first->second;
}

}  // namespace bezierbench::tables
