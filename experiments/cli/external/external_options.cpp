// SPDX-License-Identifier: MIT
#include "experiments/cli/external/external_options.hpp"

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/external/method.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/interruption.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

double positive(std::string_view option, const std::string& text, double most) {
  const auto number = number::parse_number(text);
  if (!number || !(*number > 0 && *number <= most))
    throw Failure(Exit::usage, "{} {}: must be above 0 and at most {}", option, text, most);
  return *number;
}

}  // namespace

void ExternalOptions::add(Command& command) {
  command.option("--plugin", plugins_, "shared object with a method of your own (docs/own_method.md), judged and timed")
      .one_each_time()
      .takes(file_value);
  command.option("--program", programs_, "command that is a method of your own, judged but not timed")
      .one_each_time()
      .takes(command_value);
  command.option("--external-seconds", seconds_, "time limit of an external method per 1024 inputs; default 10")
      .takes("SECONDS");
  command.option("--external-memory", megabytes_, "memory limit of an external method; default 1024").takes("MIB");
}

external::Methods ExternalOptions::methods() const {
  constexpr double day = 86400;
  constexpr double tebibyte = 1 << 20;
  external::Limits limits;
  if (seconds_) limits.seconds = positive("--external-seconds", *seconds_, day);
  if (megabytes_) limits.megabytes = static_cast<std::uint64_t>(positive("--external-memory", *megabytes_, tebibyte));
  external::Methods methods;
  for (const auto& one : own_) methods.push_back(external::own(one, limits, run::interrupted));
  for (const auto& file : plugins_) methods.push_back(external::plugin(file, limits, run::interrupted));
  for (const auto& command : programs_) methods.push_back(external::program(command, limits, run::interrupted));
  for (const auto& method : methods)
    if (external::find(methods, method->record().id) != method.get())
      throw Failure(Exit::usage, "two external methods have the id {}; change one", method->record().id);
  return methods;
}

std::vector<std::string> ExternalOptions::arguments() const {
  std::vector<std::string> words;
  for (const auto& file : plugins_) words.insert(words.end(), {"--plugin", file});
  for (const auto& command : programs_) words.insert(words.end(), {"--program", command});
  if (seconds_) words.insert(words.end(), {"--external-seconds", *seconds_});
  if (megabytes_) words.insert(words.end(), {"--external-memory", *megabytes_});
  return words;
}

std::shared_ptr<const external::Method> read_answers(const std::string& file, const std::optional<std::string>& id) {
  const auto text = bundle::read_file(file);
  return external::answers(bundle::parse_csv(text, file), id.value_or(external::answers_id(file)),
                           bundle::sha256_hex(text));
}

void require_recorded(const std::string& suite_file, const external::Methods& given) {
  for (const auto& recorded : suite::parse_external(bundle::read_file(suite_file), suite_file))
    if (external::find(given, recorded.id) == nullptr)
      throw Failure(Exit::usage,
                    "{}: names the external method {} ({} {}); give it with --{}, or remove its [[external]] table",
                    suite_file, recorded.id, name(recorded.kind), recorded.source, name(recorded.kind));
}

}  // namespace bezierbench::cli
