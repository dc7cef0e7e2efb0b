// SPDX-License-Identifier: MIT
// Files of finished blocks of an unfinished run, in blocks/. Each is written whole or not at all, with a checksum and
// with what it belongs to, so that no foreign or damaged file is taken for a result.
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
  std::uint64_t job = 0;                                        ///< its index in the resolved suites
  std::uint64_t part = 0;                                       ///< index of the part in the job
  std::vector<std::pair<std::uint64_t, std::uint64_t>> blocks;  ///< half-open ranges [first, end), ascending
  std::string result;                                           ///< bytes that only the job can read

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.job, self.part, self.blocks, self.result);
  }
};

struct BlockFile {
  Manifest manifest;      ///< suites, seed and build of the run
  std::string reference;  ///< how the truth was computed
  std::string machine;    ///< machine_fingerprint() of the machine that computed it
  std::vector<BlockRecord> records;
};

/// The file of blocks as bytes.
[[nodiscard]] std::string block_file_bytes(const BlockFile& file);

/// The file of blocks that `bytes` hold; empty where they are damaged (cut or changed) or not a file of blocks.
[[nodiscard]] std::optional<BlockFile> parse_block_file(std::string_view bytes);

}  // namespace bezierbench::bundle
