// SPDX-License-Identifier: MIT
#include "experiments/external/method.hpp"

#include <algorithm>

namespace bezierbench::external {

void Batch::add(const CurveView<double>& curve, std::span<const double> given) {
  inputs.insert(inputs.end(), given.begin(), given.end());
  coefficients.insert(coefficients.end(), curve.coefficients.begin(), curve.coefficients.end());
  weights.insert(weights.end(), curve.weights.begin(), curve.weights.end());
}

std::size_t Batch::answer_size() const {
  constexpr std::size_t t_and_distance = 2;
  const auto d = static_cast<std::size_t>(dimension);
  switch (problem) {
    case Problem::arc_length: return 1;
    case Problem::projection: return t_and_distance;
    case Problem::subdivision: return 2 * (static_cast<std::size_t>(degree) + 1) * (form == Form::rational ? d + 1 : d);
    default: return d;
  }
}

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
