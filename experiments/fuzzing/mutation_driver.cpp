// SPDX-License-Identifier: MIT
// A fuzzer without libFuzzer, for every compiler and short runs: `FUZZER FILE...` calls the function under test with each
// file, and then with thousands of changed ones, which are the same in every run.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "experiments/fuzzing/property.hpp"

namespace {

void run(const std::string& input) {
  (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> corpus{""};
  for (int k = 1; k < argc; ++k) {
    std::ifstream file(argv[k], std::ios::binary);
    if (!file) return std::fprintf(stderr, "%s: cannot be read\n", argv[k]), 2;
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  for (const auto& input : corpus) run(input);
  constexpr int mutations = 5000;
  std::mt19937_64 words;
  const auto below = [&](std::size_t end) { return static_cast<std::size_t>(words() % end); };
  for (int k = 0; k < mutations; ++k) {
    std::string input = corpus[below(corpus.size())];
    for (auto changes = 1 + below(6); changes > 0; --changes) {
      const auto& other = corpus[below(corpus.size())];
      const auto at = below(input.size() + 1);
      switch (below(4)) {
        case 0: input.resize(at); break;
        case 1: input.erase(at, 1 + below(40)); break;
        case 2: input.insert(at, other, below(other.size() + 1), below(30)); break;
        default:
          if (at < input.size()) input[at] = static_cast<char>(words());
      }
    }
    run(input);
  }
  return 0;
}
