// SPDX-License-Identifier: MIT The cycles of a point on processors that are not here, as llvm-mca predicts them from
// the machine code of a kernel and from how often Callgrind saw each instruction of it.
//
// llvm-mca simulates straight lines. A kernel is cut into blocks of instructions that follow each other in memory and
// ran equally often; the cycles of a block count as often as it ran. The model leaves out caches, mispredicted
// branches, fetching and decoding, and everything between two blocks: what one waits for in another, and what overlaps.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/race/counts.hpp"

namespace bezierbench::race {

struct Processor {
  std::string_view id;    ///< in the columns of cost.csv
  const char* llvm_name;  ///< of its model in LLVM 19
};

/// Processors of which LLVM 19 has a model of its own that knows what a division costs. Those of Sapphire Rapids and
/// Alder Lake lack the latter; Zen 3 has that of Zen 4 under another name.
inline constexpr std::array<Processor, 2> processors{{{"skylake_x", "skylake-avx512"}, {"zen4", "znver4"}}};

// The programs of LLVM that are run, without the version of a model that another release may not have.
inline constexpr const char* disassembler = "llvm-objdump-19";
inline constexpr const char* simulator = "llvm-mca-19";

/// Runs one of these with the words of `command`; `input` is its standard input. Returns its standard output.
using RunProgram = std::function<std::string(const std::vector<std::string>& command, const std::string& input)>;

/// The words that run the simulator on instructions of this processor family.
std::vector<std::string> simulation(const Processor& processor, int passes);

/// Adds the predicted cycles of a point to each of Callgrind's files, for read_counts(). It adds none where the kernel
/// calls another function, or where more than a tenth of its instructions lie outside of `program`, are calls, or are
/// unknown to the simulator.
void add_cycles(std::span<std::string> files, const std::string& program, const RunProgram& run);

}  // namespace bezierbench::race
