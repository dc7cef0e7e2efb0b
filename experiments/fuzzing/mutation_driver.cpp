// SPDX-License-Identifier: MIT
// A fuzzer without libFuzzer, for every compiler and short runs: `FUZZER --mutations N --seed S FILE...` calls the
// function under test with each file, and then with N mutations. The same arguments give the same inputs. The input at
// which it crashed is left in `crash-input`.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "experiments/fuzzing/property.hpp"

namespace {

std::string current;  // read by the signal handler

extern "C" void keep_input(int signal) {
  const int file = open("crash-input", O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file != -1 && write(file, current.data(), current.size()) == static_cast<ssize_t>(current.size())) close(file);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// The handler has its own stack, because the program's may have overflowed.
void watch_for_crashes() {
  static std::array<char, 1 << 16> place;
  stack_t stack{};
  stack.ss_sp = place.data();
  stack.ss_size = place.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = keep_input;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) sigaction(signal, &action, nullptr);
}

class Mutator {
 public:
  Mutator(std::vector<std::string> corpus, std::uint64_t seed) : corpus_(std::move(corpus)), words_(seed) {}

  std::string next() {
    std::string input = any();
    for (auto changes = 1 + below(6); changes > 0; --changes) change(input);
    return input;
  }

 private:
  // The modulo's slight bias is no harm here; a standard distribution would differ between libraries.
  std::size_t below(std::size_t end) { return end == 0 ? 0 : static_cast<std::size_t>(words_() % end); }
  const std::string& any() { return corpus_[below(corpus_.size())]; }

  std::string piece(const std::string& of) {
    const auto at = below(of.size() + 1);
    return of.substr(at, below(30));
  }

  void change(std::string& input) {
    static constexpr std::array<std::string_view, 20> tokens{"\"",
                                                             "\n",
                                                             "\r\n",
                                                             ",",
                                                             "=",
                                                             "[",
                                                             "]",
                                                             "[[",
                                                             "{",
                                                             "}",
                                                             "#",
                                                             "0",
                                                             "-",
                                                             "1e999",
                                                             "nan",
                                                             "0x1p-1074",
                                                             "9223372036854775808",
                                                             "\xff",
                                                             std::string_view("\0", 1),
                                                             "\xEF\xBB\xBF"};
    const auto at = below(input.size() + 1);
    switch (below(8)) {
      case 0:
        if (at < input.size()) input[at] = static_cast<char>(input[at] ^ (1 << below(8)));
        break;
      case 1: input.insert(at, tokens[below(tokens.size())]); break;
      case 2: input.erase(at, 1 + below(40)); break;
      case 3: input.insert(at, piece(input)); break;
      case 4: input.insert(at, piece(any())); break;
      case 5: input.resize(at); break;
      case 6: repeat(input, at); break;
      default: input.replace(at, std::min<std::size_t>(below(4), input.size() - at), tokens[below(tokens.size())]);
    }
  }

  /// Inserts deep nesting where the tokens are brackets.
  void repeat(std::string& input, std::size_t at) {
    using Pair = std::pair<std::string_view, std::string_view>;
    static constexpr std::array<Pair, 6> tokens{
        {{"[", "]"}, {"{\"a\":", "}"}, {"{a=", "}"}, {"[[", "]]"}, {"a.", "a"}, {"(", ")"}}};
    const auto& [opening, closing] = tokens[below(tokens.size())];
    const auto count = std::size_t{1} << below(17);
    std::string nested;
    for (std::size_t k = 0; k < count; ++k) nested += opening;
    for (std::size_t k = 0; k < count; ++k) nested += closing;
    input.insert(at, nested);
  }

  std::vector<std::string> corpus_;
  std::mt19937_64 words_;
};

void run(const std::string& input) {
  current = input;
  (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(current.data()), current.size());
}

std::uint64_t number(const char* text) {
  std::uint64_t value = 0;
  const std::string_view digits(text);
  if (std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc()) std::abort();
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t mutations = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> corpus{""};
  for (int k = 1; k < argc; ++k) {
    const std::string_view argument = argv[k];
    if (argument == "--mutations" && k + 1 < argc) {
      mutations = number(argv[++k]);
    } else if (argument == "--seed" && k + 1 < argc) {
      seed = number(argv[++k]);
    } else {
      std::ifstream file(argv[k], std::ios::binary);
      if (!file) return std::fprintf(stderr, "%s: cannot be read\n", argv[k]), 2;
      corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
  }
  watch_for_crashes();
  for (const auto& input : corpus) run(input);
  Mutator mutator(corpus, seed);
  for (std::uint64_t k = 0; k < mutations; ++k) run(mutator.next());
  std::printf("%zu files and %llu mutations of seed %llu\n", corpus.size() - 1,
              static_cast<unsigned long long>(mutations), static_cast<unsigned long long>(seed));
  return 0;
}
