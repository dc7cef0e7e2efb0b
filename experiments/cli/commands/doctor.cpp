// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include "build_facts.hpp"
#include "core/api/floating_point_faults.hpp"
#include "experiments/bundle/machine.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/race/counters.hpp"
#include "experiments/terminal.hpp"

namespace bezierbench::cli {
namespace {

void print(std::string_view aspect, std::string_view state, std::string_view text) {
  const auto colour = state == "fine"      ? fmt::terminal_color::green
                      : state == "warning" ? fmt::terminal_color::yellow
                                           : fmt::terminal_color::red;
  constexpr std::size_t indent = 25;
  const auto plain = wrapped(fmt::format("{:<15} {:<8} ", aspect, state), text, indent);
  const auto at = plain.find(state, aspect.size());
  fmt::print("{}{}{}", plain.substr(0, at), styled(STDOUT_FILENO, fmt::fg(colour), state),
             plain.substr(at + state.size()));
}

}  // namespace

void add_doctor(Command program, Exit& exit) {
  program.command("doctor", "check whether this machine is fit for measurements").action([&exit] {
    const auto faults = floating_point_faults();
    for (const auto& fault : faults) print("floating point", "unfit", fault);
    if (faults.empty()) print("floating point", "fine", "IEEE 754 double, to nearest, no contraction, subnormals kept");
    const auto machine =
        bundle::machine_json({compiler, all_flags, build_type, fp_flags, program_version}, race::Counters().state());
    for (const auto& concern : bundle::timing_fitness(machine))
      print(concern.aspect, concern.warning ? "warning" : "fine", concern.text);
    exit = faults.empty() ? Exit::fine : Exit::environment;
  });
}

}  // namespace bezierbench::cli
