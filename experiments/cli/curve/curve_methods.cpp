// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/curve_methods.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/echo.hpp"
#include "experiments/number/number.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/suite/nearest.hpp"

namespace bezierbench::cli {

std::string why_not(const MethodInfo& info, const CurveFile& curve) {
  if (info.form != curve.form && curve.form == Form::rational)
    return fmt::format(
        "takes curves in {} form, the file has weights (column w); see `list methods` for methods that "
        "take the rational form",
        name(info.form));
  if (info.form == Form::rational && curve.form != Form::rational)
    return fmt::format("takes curves in rational form, the file has no weights (column w); see `list methods`");
  if (info.form != curve.form)
    return fmt::format("takes curves in {} form, the file is in {} form; see --form and `list methods`",
                       name(info.form), name(curve.form));
  return fmt::format("supports degrees {} to {}, the curve has degree {}; see `list methods`", info.min_degree,
                     info.max_degree, curve.degree());
}

void refuse_curve(const std::string& file, const CurveFile& curve, const MethodInfo& any) {
  std::string problem(name(any.problem));
  std::ranges::replace(problem, '_', ' ');
  std::string why = why_not(any, curve);
  if (curve.form == Form::rational)
    why = fmt::format("no method for {} takes rational curves (column w); `curve eval` and `curve split` do", problem);
  else if (curve.form == Form::power)
    why = fmt::format("no method for {} takes the power form; see `curve convert`", problem);
  throw Failure(Exit::usage, fmt::format("{}: {}", file, why));
}

bool applies(const MethodInfo& info, const CurveFile& curve) {
  return info.form == curve.form && info.supports<double>(curve.degree());
}

std::vector<std::string> ids_of(std::span<const MethodInfo* const> infos) {
  std::vector<std::string> ids;
  for (const auto* info : infos) ids.emplace_back(info->id);
  return ids;
}

void unknown_method(const std::string& id, const std::vector<std::string>& known) {
  for (const auto& peer : peers::absent())
    if (peer.id == id)
      throw Failure(Exit::usage, fmt::format("--method {}: is not in this build; {}", id, peer.remedy));
  const auto guess = suite::nearest(id, known);
  throw Failure(Exit::usage, fmt::format("--method {}: no such method{}; see `list methods`", id,
                                         guess.empty() ? "" : fmt::format(", did you mean \"{}\"?", guess)));
}

double finite_option(const std::string& option, const std::string& text) {
  const auto value = number::parse_number(text);
  if (!value || !std::isfinite(*value))
    throw Failure(Exit::usage, fmt::format("{} {}: {}", option, echo(text), number::fault(text)));
  return *value;
}

std::vector<double> finite_numbers(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    numbers.push_back(finite_option(option, text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return numbers;
}

}  // namespace bezierbench::cli
