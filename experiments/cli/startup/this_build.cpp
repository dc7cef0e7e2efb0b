// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/this_build.hpp"

#include <utility>

#include "build_facts.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/race/counters.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/studies/roster.hpp"
#include "git_facts.hpp"

namespace bezierbench::cli {

run::RunRequest request_of_this_build(const external::Methods& external) {
  run::RunRequest request;
  request.kinds = {
      sample::studies_of, studies::make_job,
      [external](const suite::Study& study, const suite::ExternalMethod& method, const run::JobContext& context) {
        return studies::external_job(study, method, external::find(external, method.id), context);
      },
      studies::why_unasked};
  request.counters = race::Counters().state();
  request.build = {compiler, all_flags, build_type, fp_flags, program_version, {}};
  for (const auto& peer : peers::present())
    request.build.peers.emplace_back(std::string(peer.library), std::string(peer.library_version));
  request.git_commit = git_commit;
  request.git_clean = git_clean;
  request.generators_csv = generators_csv();
  std::vector<suite::ExternalMethod> records;
  for (const auto& method : external) records.push_back(method->record());
  record_external(request, std::move(records));
  return request;
}

void record_external(run::RunRequest& request, std::vector<suite::ExternalMethod> external) {
  request.external = std::move(external);
  request.methods_csv = methods_csv(request.external);
}

}  // namespace bezierbench::cli
