// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/this_build.hpp"

#include "build_facts.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/race/counters.hpp"
#include "experiments/studies/roster.hpp"
#include "git_facts.hpp"

namespace bezierbench::cli {

run::RunRequest request_of_this_build() {
  run::RunRequest request;
  request.kinds = {studies::make_job, studies::tables_of};
  request.counters = race::Counters().state();
  request.build = {compiler, all_flags, build_type, fp_flags, program_version, {}};
  for (const auto& peer : peers::present())
    request.build.peers.emplace_back(std::string(peer.library), std::string(peer.library_version));
  request.git_commit = git_commit;
  request.git_clean = git_clean;
  request.methods_csv = methods_csv();
  request.generators_csv = generators_csv();
  return request;
}

}  // namespace bezierbench::cli
