// SPDX-License-Identifier: MIT
#include "experiments/external/method.hpp"

#include <algorithm>

namespace bezierbench::external {

std::string_view name(Status status) {
  switch (status) {
    case Status::ok: return "ok";
    case Status::non_finite: return "non_finite";
    case Status::missing: return "missing";
    case Status::refused: return "refused";
    case Status::malformed: return "malformed";
    case Status::exited: return "exited";
    case Status::threw: return "threw";
    case Status::crashed: return "crashed";
    case Status::timed_out: return "timed_out";
  }
  return "";
}

const Method* find(const Methods& methods, std::string_view id) {
  const auto found = std::ranges::find_if(methods, [&](const auto& method) { return method->record().id == id; });
  return found == methods.end() ? nullptr : found->get();
}

}  // namespace bezierbench::external
