// SPDX-License-Identifier: MIT
// machine.json: where and with what build a bundle was made. Timings mean little without it; accuracy must not need it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace bezierbench::bundle {

/// What only the build knows. An empty string is written as "unknown".
struct BuildFacts {
  std::string compiler;  ///< id and version
  std::string flags;     ///< the exact compiler flags
  std::string build_type;
  std::string fp_flags;  ///< the floating-point contract's part of the flags
  std::string program_version;
  std::vector<std::pair<std::string, std::string>> peers =
      {};  ///< libraries compared with, and their versions; may be none
};

/// Where Linux describes the machine; another root only in tests.
struct MachineRoots {
  std::filesystem::path proc = "/proc";
  std::filesystem::path sys = "/sys";
};

/// Whether machine.json says whose machine it is.
enum class HostName { left_out, told };

/// The text of machine.json, as of now, for the first processor this process may run on: `cpu`, `caches` and `memory`
/// (bytes), `frequency`, `system`, `load_average` (1, 5 and 15 minutes), `clock` (ns), `counters` (as whoever opened
/// them found them), `build`, `peers` (if the build has any). Every value that cannot be read is the string "unknown";
/// nothing throws for it. The host's name, in `system`, only where it is to be told: it says who, not what. Takes up to
/// 20 ms, to measure the clock. schema/machine.schema.json holds for it.
[[nodiscard]] std::string machine_json(const BuildFacts& build, const std::string& counters,
                                       HostName host_name = HostName::left_out, const MachineRoots& roots = {});

/// SHA-256 of what stays the same on one machine from day to day: machine.json without the load, the measured clock and
/// the host's name. Times taken under different fingerprints do not belong together. Any text has one.
[[nodiscard]] std::string machine_fingerprint(const std::string& machine_json);

}  // namespace bezierbench::bundle
