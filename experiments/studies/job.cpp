// SPDX-License-Identifier: MIT
#include "experiments/studies/job.hpp"

namespace bezierbench::studies {

bundle::CsvTable& Tables::table(const std::string& file, const std::vector<std::string>& columns) {
  return tables_.try_emplace(file, columns).first->second;
}

}  // namespace bezierbench::studies
