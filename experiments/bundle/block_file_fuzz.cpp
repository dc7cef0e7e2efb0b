// SPDX-License-Identifier: MIT
// Files of blocks. Their checksum would reject every changed file, so the input is the part before the checksum, and
// the checksum is computed for it.
#include "experiments/bundle/block_file.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/fuzzing/property.hpp"

namespace bezierbench::bundle {
namespace {

void check(std::string_view text) {
  (void)parse_block_file(text);
  const std::string fitting = std::string(text) + sha256_hex(text);
  const auto file = parse_block_file(fitting);
  if (!file) return;
  const std::string written = block_file_bytes(*file);
  const auto again = parse_block_file(written);
  fuzzing::require(again && block_file_bytes(*again) == written, "a file of blocks reads back");
}

}  // namespace
}  // namespace bezierbench::bundle

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  bezierbench::bundle::check(bezierbench::fuzzing::text_of(bytes, size));
  return 0;
}
