// SPDX-License-Identifier: MIT
// Parsers of bundle.json and of the facts in it and in machine.json, and the fingerprint, which any text has.
#include "experiments/bundle/machine.hpp"
#include "experiments/bundle/manifest.hpp"
#include "experiments/fuzzing/property.hpp"

namespace bezierbench::bundle {
namespace {

void check(std::string_view text) {
  (void)machine_fingerprint(std::string(text));
  (void)fuzzing::reads(Exit::input_output, [&] { (void)facts(text, fuzzing::file_name); });
  Manifest manifest;
  if (!fuzzing::reads(Exit::input_output, [&] { manifest = parse_manifest(text, fuzzing::file_name); })) return;
  const std::string written = manifest_json(manifest);
  fuzzing::require(manifest_json(parse_manifest(written, fuzzing::file_name)) == written, "a manifest reads back");
}

}  // namespace
}  // namespace bezierbench::bundle

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  bezierbench::bundle::check(bezierbench::fuzzing::text_of(bytes, size));
  return 0;
}
