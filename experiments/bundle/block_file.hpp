// SPDX-License-Identifier: MIT
// Finished blocks of an unfinished run, as they lie in blocks/: files written whole or not at all, each with a checksum
// and with what it is of, so that nothing foreign or damaged is ever taken for a result.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/bundle/manifest.hpp"

namespace bezierbench::bundle {

/// The merged result of some blocks of one part of one job.
struct BlockRecord {
  std::uint64_t job = 0;                                        ///< its place in the resolved suites
  std::uint64_t part = 0;                                       ///< of the job
  std::vector<std::pair<std::uint64_t, std::uint64_t>> blocks;  ///< first and end of runs of blocks, ascending
  std::string result;                                           ///< the job's own bytes

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.job, self.part, self.blocks, self.result);
  }
};

struct BlockFile {
  Manifest manifest;      ///< of the run: suites, seed and build
  std::string reference;  ///< how the truth was computed
  std::string machine;    ///< where it was made: see machine_fingerprint()
  std::vector<BlockRecord> records;
};

/// The bytes of a file of blocks.
[[nodiscard]] std::string block_file_bytes(const BlockFile& file);

/// Nothing where the bytes are damaged: cut, changed, or no file of blocks at all.
[[nodiscard]] std::optional<BlockFile> parse_block_file(std::string_view bytes);

}  // namespace bezierbench::bundle
