// SPDX-License-Identifier: MIT
#include "experiments/cli/outside/outside_options.hpp"

#include <fmt/format.h>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"
#include "experiments/outside/answers.hpp"
#include "experiments/outside/plugin.hpp"
#include "experiments/outside/program.hpp"
#include "experiments/run/interruption.hpp"

namespace bezierbench::cli {
namespace {

double positive(std::string_view option, const std::string& text, double most) {
  const auto number = number::parse_number(text);
  if (!number || !(*number > 0 && *number <= most))
    throw Failure(Exit::usage, fmt::format("{} {}: must be above 0 and at most {}", option, text, most));
  return *number;
}

}  // namespace

void OutsideOptions::add(Command& command) {
  command.option("--plugin", plugins_, "shared object with a method of your own (docs/own_method.md), judged and timed")
      .one_each_time()
      .takes(file_value);
  command.option("--program", programs_, "command that is a method of your own, judged but not timed")
      .one_each_time()
      .takes(command_value);
  command.option("--outside-seconds", seconds_, "time limit of an external method per 1024 inputs; default 10")
      .takes("SECONDS");
  command.option("--outside-memory", megabytes_, "memory limit of an external method; default 1024").takes("MIB");
}

outside::Methods OutsideOptions::methods() const {
  constexpr double day = 86400;
  constexpr double tebibyte = 1 << 20;
  outside::Limits limits;
  if (seconds_) limits.seconds = positive("--outside-seconds", *seconds_, day);
  if (megabytes_) limits.megabytes = static_cast<std::uint64_t>(positive("--outside-memory", *megabytes_, tebibyte));
  outside::Methods methods;
  for (const auto& one : own_) methods.push_back(outside::own(one, limits, run::interrupted));
  for (const auto& file : plugins_) methods.push_back(outside::plugin(file, limits, run::interrupted));
  for (const auto& command : programs_) methods.push_back(outside::program(command, limits, run::interrupted));
  for (const auto& method : methods)
    if (outside::find(methods, method->record().id) != method.get())
      throw Failure(Exit::usage, fmt::format("two external methods have the id {}; change one", method->record().id));
  return methods;
}

std::shared_ptr<const outside::Method> read_answers(const std::string& file, const std::optional<std::string>& id) {
  const auto text = bundle::read_file(file);
  return outside::answers(bundle::parse_csv(text, file), id.value_or(outside::answers_id(file)),
                          bundle::sha256_hex(text));
}

void require_recorded(const std::string& suite_file, const outside::Methods& given) {
  for (const auto& recorded : suite::parse_outside(bundle::read_file(suite_file), suite_file))
    if (outside::find(given, recorded.id) == nullptr)
      throw Failure(Exit::usage,
                    fmt::format("{}: has the method {} from outside ({} {}); give it with --{}, or remove "
                                "its [[outside]] table",
                                suite_file, recorded.id, name(recorded.kind), recorded.source, name(recorded.kind)));
}

}  // namespace bezierbench::cli
