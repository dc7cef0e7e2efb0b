// SPDX-License-Identifier: MIT
#include "experiments/studies/job.hpp"

namespace bezierbench::studies {

bundle::CsvTable& Tables::table(const std::string& file, const std::vector<std::string>& columns) {
  return tables_.try_emplace(file, columns).first->second;
}

double Job::total_cost() const {
  double sum = 0;
  for (std::size_t block = 0; block < blocks(); ++block) sum += cost(block);
  return sum;
}

}  // namespace bezierbench::studies
