// SPDX-License-Identifier: MIT
// machine.json: the machine and the build that made a bundle, and why times taken there may not be reliable. Timings
// mean little without it; accuracy must not depend on it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bezierbench::bundle {

/// Facts that only the build knows. An empty string is written as "unknown".
struct BuildFacts {
  std::string compiler;  ///< id and version
  std::string flags;     ///< the exact compiler flags
  std::string build_type;
  std::string fp_flags;  ///< the floating-point contract's part of the flags
  std::string program_version;
  std::vector<std::pair<std::string, std::string>> peers =
      {};  ///< other libraries that are compared, and their versions; may be empty
};

/// Where Linux describes the machine. Only tests use other folders.
struct MachineRoots {
  std::filesystem::path proc = "/proc";
  std::filesystem::path sys = "/sys";
};

/// Whether machine.json contains the name of the host.
enum class HostName { left_out, told };

/// The text of machine.json at this moment, for the first processor that this process may run on: `cpu`, `caches` and
/// `memory` (bytes), `frequency`, `system`, `load_average` (1, 5 and 15 minutes), `clock` (ns), `counters` (the
/// argument: what opening them gave), `build`, `peers` (if the build has any). A value that cannot be read is the
/// string "unknown" and throws nothing. The host's name is in `system` only if asked for, since it identifies the
/// machine rather than describes it. Takes up to 20 ms, to measure the clock. The text follows
/// schema/machine.schema.json.
[[nodiscard]] std::string machine_json(const BuildFacts& build, const std::string& counters,
                                       HostName host_name = HostName::left_out, const MachineRoots& roots = {});

/// SHA-256 of what stays the same on a machine from day to day: machine.json without the load, the measured clock and
/// the host's name. Times taken under different fingerprints are not comparable. Any text, also one that is not JSON,
/// has a fingerprint.
[[nodiscard]] std::string machine_fingerprint(const std::string& machine_json);

/// One aspect of a machine to know before times are relied on.
struct Concern {
  std::string aspect;  ///< clock, governor, boost, load, virtualised, counters
  std::string text;    ///< what is wrong and what to do about it
  bool warning;        ///< false: nothing is wrong, and `text` is the value found
};

/// One concern for each aspect, in a fixed order. A value that could not be read gives a warning. Throws
/// Failure(Exit::input_output) where the text is not that of a machine.json.
[[nodiscard]] std::vector<Concern> timing_fitness(std::string_view machine_json);

}  // namespace bezierbench::bundle
