// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/this_build.hpp"

#include <utility>

#include "build_facts.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/race/counters.hpp"
#include "experiments/studies/outside/outside.hpp"
#include "experiments/studies/roster.hpp"
#include "git_facts.hpp"

namespace bezierbench::cli {

run::RunRequest request_of_this_build(const outside::Methods& outside) {
  run::RunRequest request;
  request.kinds = {
      studies::make_job, studies::tables_of,
      [outside](const suite::Study& study, const suite::OutsideMethod& method, const run::JobContext& context) {
        return studies::outside_job(study, method, outside::find(outside, method.id), context);
      },
      studies::why_unasked};
  request.counters = race::Counters().state();
  request.build = {compiler, all_flags, build_type, fp_flags, program_version, {}};
  for (const auto& peer : peers::present())
    request.build.peers.emplace_back(std::string(peer.library), std::string(peer.library_version));
  request.git_commit = git_commit;
  request.git_clean = git_clean;
  request.generators_csv = generators_csv();
  std::vector<suite::OutsideMethod> records;
  for (const auto& method : outside) records.push_back(method->record());
  record_outside(request, std::move(records));
  return request;
}

void record_outside(run::RunRequest& request, std::vector<suite::OutsideMethod> outside) {
  request.outside = std::move(outside);
  request.methods_csv = methods_csv(request.outside);
}

}  // namespace bezierbench::cli
