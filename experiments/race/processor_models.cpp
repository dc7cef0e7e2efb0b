// SPDX-License-Identifier: MIT
#include "experiments/race/processor_models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

namespace bezierbench::race {
namespace {

constexpr double max_outside = 0.1;  // of the instructions of a kernel
constexpr double max_calls = 0.1;    // for each point
constexpr int many_passes = 100;

using Address = std::uint64_t;

/// What Callgrind saw of a rival's batch.
struct Executed {
  double points = 0;
  std::map<Address, double> times = {};  ///< of each instruction of the program
  double elsewhere = 0;                  ///< instructions of libraries
  double calls = 0;                      ///< by functions of the kernel
};

/// Whether a function is of the loops over points that this folder has; `name` is the linker's.
bool is_of_race(std::string_view name) { return name.find("11bezierbench4race") != std::string_view::npos; }

/// Empty for a file without a rival's counts. Adds the linker's names of the functions of the program.
std::optional<Executed> executed_of(const std::string& file, const std::string& program,
                                    std::set<std::string>& functions) {
  std::optional<Executed> all;
  bool is_program = false;
  bool is_kernel = false;
  bool is_call = false;  // the next line has the counts of a called function, which its own lines have, too
  std::istringstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (const auto counted = counted_of(line)) all.emplace().points = static_cast<double>(counted->points);
    if (!all) continue;
    if (line.starts_with("ob=")) {
      is_program = line.substr(3) == program;
    } else if (line.starts_with("fn=")) {
      is_kernel = !is_of_race(line);
      if (is_program) functions.insert(line.substr(3));
    } else if (line.starts_with("calls=")) {
      is_call = true;
      if (is_kernel) all->calls += std::stod(line.substr(std::string_view("calls=").size()));
    } else if (line.starts_with("0x")) {
      Address address = 0;
      std::size_t source_line = 0;
      double times = 0;
      std::istringstream(line) >> std::hex >> address >> std::dec >> source_line >> times;
      if (!std::exchange(is_call, false)) (is_program ? all->times[address] : all->elsewhere) += times;
    }
  }
  return all;
}

/// Instructions by address, without the disassembler's remarks on addresses.
std::map<Address, std::string> instructions_of(const std::string& disassembly) {
  std::map<Address, std::string> all;
  std::istringstream lines(disassembly);
  for (std::string line; std::getline(lines, line);) {
    const auto first = line.find_first_not_of(' ');
    const auto colon = line.find(':');
    if (first == std::string::npos || colon == std::string::npos) continue;
    Address address = 0;
    const auto read = std::from_chars(line.data() + first, line.data() + colon, address, 16);
    const auto text = line.find_first_not_of(" \t", colon + 1);
    if (read.ec != std::errc() || read.ptr != line.data() + colon || text == std::string::npos) continue;
    all[address] = line.substr(text, line.find_first_of("#<", text) - text);
  }
  return all;
}

struct Block {
  std::string text;
  std::size_t instructions = 0;
  double times = 0;
};

/// The blocks of a kernel. What is in none of them is added to `executed.elsewhere`.
std::vector<Block> blocks_of(Executed& executed, const std::map<Address, std::string>& code) {
  std::vector<Block> blocks;
  auto next = code.end();
  for (const auto& [address, times] : executed.times) {
    const auto at = code.find(address);
    if (at == code.end() || at->second.starts_with("call")) {
      executed.elsewhere += times;
      next = code.end();
      continue;
    }
    if (at != next || blocks.back().times != times) blocks.push_back({.text = "", .times = times});
    blocks.back().text += at->second + '\n';
    ++blocks.back().instructions;
    next = std::next(at);
  }
  return blocks;
}

/// What the simulator says of passes through a block.
struct Simulated {
  double instructions = 0;
  double cycles = 0;
  double throughput = 0;
};

/// By number of the block; of a block without a known instruction all is 0.
std::vector<Simulated> simulated_in(const std::string& output, std::size_t blocks) {
  std::vector<Simulated> all(blocks + 1);  // one more for what stands before the first
  std::size_t block = blocks;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    constexpr std::string_view heading = "Code Region - ";
    const auto value = [&](std::string_view name) { return std::stod(line.substr(name.size())); };
    if (const auto at = line.find(heading); at != std::string::npos)
      block = std::stoul(line.substr(at + heading.size()));
    for (auto [name, field] : {std::pair{"Instructions:", &Simulated::instructions},
                               {"Total Cycles:", &Simulated::cycles},
                               {"Block RThroughput:", &Simulated::throughput}})
      if (line.starts_with(name)) all.at(block).*field = value(name);
  }
  all.pop_back();
  return all;
}

/// A block on one processor.
struct Predicted {
  double known = 0;  ///< instructions
  Cycles once = {};
  double later_pass = 0;  ///< cycles of another pass right after the first

  /// Of a block that a point runs `times` times. Passes do not wait for each other in its throughput; in its latency
  /// they wait as far as a register of one goes into the next.
  [[nodiscard]] Cycles cycles(double times) const {
    return {times * once.throughput, std::min(times, 1.0) * once.latency + std::max(times - 1, 0.0) * later_pass};
  }
};

/// `blocks` are numbers by text.
std::vector<Predicted> predicted(const Processor& processor, const std::map<std::string, std::size_t>& blocks,
                                 const RunProgram& run) {
  std::string input;
  for (const auto& [text, number] : blocks)
    input += fmt::format("# LLVM-MCA-BEGIN {}\n{}# LLVM-MCA-END\n", number, text);
  const auto first = simulated_in(run(simulation(processor, 1), input), blocks.size());
  const auto many = simulated_in(run(simulation(processor, many_passes), input), blocks.size());
  constexpr double pipeline = 3;  // cycles that the simulator adds to a pass, even to that of a nop
  std::vector<Predicted> all;
  for (std::size_t k = 0; k < blocks.size(); ++k)
    all.push_back({first[k].instructions,
                   {first[k].throughput, std::max(first[k].cycles - pipeline, 0.0)},
                   (many[k].cycles - first[k].cycles) / (many_passes - 1)});
  return all;
}

/// A kernel as its blocks, each with its number.
struct Kernel {
  Executed executed;
  std::vector<std::pair<Block, std::size_t>> blocks = {};
};

/// Of a point. Empty where too many instructions are in no block, or unknown.
std::optional<Cycles> cycles_of(const Kernel& kernel, const std::vector<Predicted>& predictions) {
  double outside = kernel.executed.elsewhere;
  double inside = 0;
  Cycles sum;
  for (const auto& [block, number] : kernel.blocks) {
    const auto& prediction = predictions[number];
    const auto cycles = prediction.cycles(block.times / kernel.executed.points);
    sum.throughput += cycles.throughput;
    sum.latency += cycles.latency;
    inside += block.times * prediction.known;
    outside += block.times * (static_cast<double>(block.instructions) - prediction.known);
  }
  if (outside > max_outside * (inside + outside)) return std::nullopt;
  return sum;
}

}  // namespace

std::vector<std::string> simulation(const Processor& processor, int passes) {
  return {simulator,
          "-mtriple=x86_64",
          fmt::format("-mcpu={}", processor.llvm_name),
          fmt::format("-iterations={}", passes),
          "-instruction-info=0",
          "-resource-pressure=0",
          "-skip-unsupported-instructions=any"};
}

void add_cycles(std::span<std::string> files, const std::string& program, const RunProgram& run) {
  std::set<std::string> functions;
  std::map<std::size_t, Kernel> kernels;  // by file
  for (std::size_t f = 0; f < files.size(); ++f)
    if (auto executed = executed_of(files[f], program, functions);
        executed && executed->calls <= max_calls * executed->points)
      kernels.try_emplace(f, Kernel{std::move(*executed)});
  // The options are a file, since a command line is too short for all names.
  const auto code = instructions_of(run({disassembler, "-d", "--no-show-raw-insn", "@/dev/stdin", program},
                                        fmt::format("--disassemble-symbols={}\n", fmt::join(functions, ","))));
  std::map<std::string, std::size_t> numbers;
  for (auto& [file, kernel] : kernels)
    for (auto& block : blocks_of(kernel.executed, code)) {
      const auto number = numbers.try_emplace(block.text, numbers.size()).first->second;
      kernel.blocks.emplace_back(std::move(block), number);
    }
  if (numbers.empty()) return;
  std::vector<std::vector<Predicted>> predictions;
  predictions.reserve(processors.size());
  for (const auto& processor : processors) predictions.push_back(predicted(processor, numbers, run));
  for (const auto& [file, kernel] : kernels) {
    std::string line(cycles_heading);
    bool is_known = true;
    for (const auto& of_processor : predictions) {
      const auto cycles = cycles_of(kernel, of_processor);
      is_known = is_known && cycles;
      if (cycles) line += fmt::format(" {} {}", cycles->throughput, cycles->latency);
    }
    if (is_known) files[file] += line + '\n';
  }
}

}  // namespace bezierbench::race
