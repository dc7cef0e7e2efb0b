// SPDX-License-Identifier: MIT
#include "experiments/cli/this_build.hpp"

#include "build_facts.hpp"
#include "experiments/cli/vocabulary.hpp"
#include "experiments/peers/peers.hpp"
#include "git_facts.hpp"

namespace bezierbench::cli {

studies::RunRequest request_of_this_build() {
  studies::RunRequest request;
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
