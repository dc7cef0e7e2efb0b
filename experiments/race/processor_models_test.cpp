// SPDX-License-Identifier: MIT
#include "experiments/race/processor_models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <stdio.h>  // NOLINT(modernize-deprecated-headers): popen is not in <cstdio>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

namespace bezierbench::race {
namespace {

/// As Callgrind writes it, shortened: ten points of a kernel that the loop over the points calls, with eight passes of
/// the loop at 206 each. `more` are lines of the kernel.
std::string file_with(const std::string& more) {
  return "desc: Trigger: Client Request: 0 0 0 10 \npositions: instr line\nevents: Ir Dr Dw Bc Bi\n"
         "ob=/p\nfn=_ZN11bezierbench4race3runEv\n0x100 0 10\ncfn=kernel\ncalls=10 0x200 0\n0x100 0 1000\n"
         "fn=kernel\n0x209 0 10\n0x200 0 10 10\n0x204 0 10\n0x206 0 80\n" +
         more + "totals: 120 10 0 0 0\n";
}

constexpr const char* disassembly =
    "/p:\tfile format elf64-x86-64\n\n0000000000000100 <_ZN11bezierbench4race3runEv>:\n     100:      \tcallq\t0x200 "
    "<kernel>\n"
    "0000000000000200 <kernel>:\n     200:      \tmulsd\t0x8(%rip), %xmm0   # 0x20a <kernel+0xa>\n     204:      "
    "\taddsd\t%xmm0, %xmm1\n"
    "     206:      \tjne\t0x206 <kernel+0x6>\n     209:      \tretq\n     20a:      \tunknown\n";

/// In place of LLVM's programs. An instruction takes half a cycle of throughput and four cycles, in later passes two;
/// on the second processor all take twice as long.
std::string answer(const std::vector<std::string>& command, const std::string& input) {
  if (command[0] == disassembler) {
    EXPECT_EQ(input, "--disassemble-symbols=_ZN11bezierbench4race3runEv,kernel\n");
    return disassembly;
  }
  const int slower = command == simulation(processors[1], 1) || command == simulation(processors[1], 100) ? 2 : 1;
  const int passes = command == simulation(processors[0], 1) || command == simulation(processors[1], 1) ? 1 : 100;
  EXPECT_EQ(input.find_first_of("<>"), std::string::npos) << "the simulator does not read remarks";
  std::string output;
  std::istringstream lines(input);
  int instructions = 0;
  std::string region;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("# LLVM-MCA-BEGIN ")) {
      region = line.substr(std::string_view("# LLVM-MCA-BEGIN ").size());
      instructions = 0;
    } else if (line != "# LLVM-MCA-END") {
      instructions += line.starts_with("unknown") ? 0 : 1;
    } else if (instructions > 0) {
      output += fmt::format("\n[9] Code Region - {}\n\nIterations: {}\nInstructions:      {}\nTotal Cycles:      {}\n",
                            region, passes, passes * instructions, 3 + instructions * slower * (4 + 2 * (passes - 1)));
      output += fmt::format("Dispatch Width:    6\nBlock RThroughput: {}\n", 0.5 * instructions * slower);
    }
  return output;
}

std::vector<Cycles> cycles_with(const std::string& more) {
  std::vector<std::string> files{file_with(more), "desc: Trigger: Program termination\n0x200 0 5\n"};
  add_cycles(files, "/p", answer);
  return read_counts(files, 0)[0][0].cycles;
}

TEST(ProcessorModels, WeightBlocksByTheirCounts) {
  const auto cycles = cycles_with("");
  ASSERT_EQ(cycles.size(), processors.size());
  EXPECT_DOUBLE_EQ(cycles[0].throughput, 1 + 8 * 0.5 + 0.5);
  EXPECT_DOUBLE_EQ(cycles[0].latency, 2 * 4 + (4 + 7 * 2) + 4);
  EXPECT_DOUBLE_EQ(cycles[1].throughput, 2 * cycles[0].throughput);
  EXPECT_DOUBLE_EQ(cycles[1].latency, 2 * cycles[0].latency);
}

TEST(ProcessorModels, PredictNothingWhereTooMuchIsLeftOut) {
  // The call of the kernel is already 10 of 120 instructions.
  EXPECT_FALSE(cycles_with("ob=/lib\nfn=memcpy\n0x206 0 2\n").empty());
  EXPECT_TRUE(cycles_with("ob=/lib\nfn=memcpy\n0x206 0 3\n").empty()) << "a library's";
  EXPECT_TRUE(cycles_with("0x20a 0 3\n").empty()) << "unknown to the simulator";
  EXPECT_TRUE(cycles_with("0x300 0 3\n").empty()) << "unknown to the disassembler";
  EXPECT_FALSE(cycles_with("cfn=other\ncalls=1 0x300 0\n0x206 0 1000\n").empty()) << "once for the batch";
  EXPECT_TRUE(cycles_with("cfn=other\ncalls=10 0x300 0\n0x206 0 1000\n").empty()) << "a call for every point";
}

/// What the simulator says of instructions whose cost differs between processors, each on its own.
std::string simulated(const char* llvm_name) {
  static constexpr std::array instructions{"vdivsd %xmm0, %xmm1, %xmm2",      "vdivpd %ymm0, %ymm1, %ymm2",
                                           "vsqrtsd %xmm0, %xmm0, %xmm1",     "vmulpd (%rdi), %ymm1, %ymm2",
                                           "vfmadd231pd %ymm0, %ymm1, %ymm2", "vmovupd %ymm0, (%rdi)",
                                           "vpermpd $27, %ymm0, %ymm1",       "imulq %rax, %rbx"};
  // Tests run in processes of their own, side by side.
  const std::string file = fmt::format("{}/bezierbench-probe-{}.s", testing::TempDir(), ::getpid());
  std::ofstream probe(file);
  for (std::size_t k = 0; k < instructions.size(); ++k)
    probe << "# LLVM-MCA-BEGIN " << k << '\n' << instructions.at(k) << "\n# LLVM-MCA-END\n";
  probe.close();
  auto* pipe = popen(fmt::format("{} < {}", fmt::join(simulation({"", llvm_name}, 100), " "), file).c_str(), "r");
  std::string output;
  for (int byte = fgetc(pipe); byte != EOF; byte = fgetc(pipe)) output += static_cast<char>(byte);
  EXPECT_EQ(pclose(pipe), 0) << llvm_name;
  return output;
}

/// The reciprocal throughput of the first instruction, a division.
double division(const std::string& output) {
  constexpr std::string_view name = "Block RThroughput:";
  return std::stod(output.substr(output.find(name) + name.size()));
}

bool has_simulator() {
  return std::system(fmt::format("command -v {} >/dev/null", simulator).c_str()) == 0;  // NOLINT(concurrency-mt-unsafe)
}

/// A name without a model of its own gets another one's, without a word.
TEST(ProcessorModels, AreModelsOfTheirOwn) {
  if (!has_simulator()) GTEST_SKIP() << simulator << " is not installed";
  std::map<std::string, std::string> names;  // by output
  const auto is_new = [&](const char* name) { return names.try_emplace(simulated(name), name).second; };
  for (const char* other : {"x86-64", "haswell", "znver2"}) EXPECT_TRUE(is_new(other)) << other;
  for (const auto& processor : processors) EXPECT_TRUE(is_new(processor.llvm_name)) << processor.id;
  EXPECT_FALSE(is_new("cascadelake")) << "whose model is that of Skylake-X";
}

TEST(ProcessorModels, KnowWhatADivisionCosts) {
  if (!has_simulator()) GTEST_SKIP() << simulator << " is not installed";
  for (const auto& processor : processors) EXPECT_GT(division(simulated(processor.llvm_name)), 2) << processor.id;
}

}  // namespace
}  // namespace bezierbench::race
