// SPDX-License-Identifier: MIT
// Suite files: a text that can be read is written, and the written text reads as equal suites.
#include "experiments/fuzzing/property.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/vocabulary_test.hpp"

namespace bezierbench::suite {
namespace {

void check(std::string_view text) {
  std::vector<Suite> suites;
  const auto& known = test_vocabulary();
  if (!fuzzing::reads(Exit::usage, [&] { suites = parse_suites(text, fuzzing::file_name, known); })) return;
  const std::string resolved = to_toml(suites) + to_toml(parse_external(text, fuzzing::file_name));
  const std::string again = to_toml(parse_suites(resolved, fuzzing::file_name, known)) +
                            to_toml(parse_external(resolved, fuzzing::file_name));
  fuzzing::require(again == resolved, "a suite reads back");
}

}  // namespace
}  // namespace bezierbench::suite

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  bezierbench::suite::check(bezierbench::fuzzing::text_of(bytes, size));
  return 0;
}
