// SPDX-License-Identifier: MIT
#include "experiments/bundle/block_file.hpp"

#include "experiments/bundle/digest.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/bytes.hpp"

namespace bezierbench::bundle {
namespace {

constexpr std::string_view magic = "bezierbench blocks 1\n";
constexpr std::size_t digest_size = 64;

}  // namespace

std::string block_file_bytes(const BlockFile& file) {
  number::ByteWriter writer;
  writer(manifest_json(file.manifest), file.reference, file.machine, file.records);
  std::string bytes(magic);
  bytes += writer.bytes();
  bytes += sha256_hex(bytes);
  return bytes;
}

std::optional<BlockFile> parse_block_file(std::string_view bytes) {
  if (!bytes.starts_with(magic) || bytes.size() < magic.size() + digest_size) return std::nullopt;
  const auto content = bytes.substr(0, bytes.size() - digest_size);
  if (sha256_hex(content) != bytes.substr(content.size())) return std::nullopt;
  try {
    number::ByteReader reader(content.substr(magic.size()));
    std::string manifest;
    BlockFile file;
    reader(manifest, file.reference, file.machine, file.records);
    reader.finish();
    file.manifest = parse_manifest(manifest, "");
    return file;
  } catch (const number::MalformedBytes&) {
    return std::nullopt;
  } catch (const Failure&) {  // a damaged manifest
    return std::nullopt;
  }
}

}  // namespace bezierbench::bundle
