// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): NSIG is not in <csignal>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/external/method.hpp"
#include "experiments/failure.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::external {
namespace {

constexpr std::string_view blanks = " \t\r";

/// The next line without its end; no value at the end of the text.
std::optional<std::string_view> next_line(std::string_view& text) {
  if (text.empty()) return std::nullopt;
  const auto end = std::min(text.find('\n'), text.size());
  const auto line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const auto begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    words.push_back(line.substr(0, line.find_first_of(blanks)));
    line.remove_prefix(words.back().size());
  }
}

std::optional<Form> given_form(std::string_view word) {
  for (const Form form : {Form::bernstein, Form::power, Form::rational})
    if (name(form) == word) return form;
  return std::nullopt;
}

/// Reads `ID [FORM [MIN_DEGREE MAX_DEGREE]] [PRECISION...] [PROBLEM...]` into the record. Returns what is wrong with
/// the line, empty if nothing is.
std::string read_first_line(std::string_view line, suite::ExternalMethod& record) {
  const auto words = words_of(line);
  if (words.empty()) return "its first line is empty";
  record.id = words.front();
  if (auto what = suite::external_id_problem(record.id, record.kind); !what.empty()) return what;
  std::size_t next = 1;
  if (const auto form = next < words.size() ? given_form(words[next]) : std::nullopt) {
    record.form = *form;
    ++next;
  }
  if (const auto min = next > 1 && next + 1 < words.size() ? number::parse_integer(words[next]) : std::nullopt) {
    const auto max = number::parse_integer(words[next + 1]);
    if (!max || *min < 0 || *max > max_degree || *min > *max)
      return fmt::format("the degrees in its first line must be from 0 to {}", max_degree);
    record.min_degree = static_cast<int>(*min);
    record.max_degree = static_cast<int>(*max);
    next += 2;
  }
  std::vector<suite::ScalarKind> scalars;
  std::vector<Problem> problems;
  for (; next < words.size(); ++next) {
    const auto scalar = suite::parse<suite::ScalarKind>(words[next]);
    const auto problem = suite::parse<Problem>(words[next]);
    if (!scalar && !problem)
      return fmt::format(
          "\"{}\" in its first line is not the form, a degree, a precision or a problem of the line ID "
          "[FORM [MIN_DEGREE MAX_DEGREE]] [PRECISION...] [PROBLEM...]",
          echo(words[next]));
    if (scalar) scalars.push_back(*scalar);
    if (problem) problems.push_back(*problem);
  }
  if (!scalars.empty()) record.scalars = std::move(scalars);
  if (!problems.empty()) record.problems = std::move(problems);
  return {};
}

/// The numbers of each remaining line, rounded to the scalar type of the batch.
Answer read_answers(std::string_view text, const Batch& batch) {
  Answer answer;
  const auto malformed = [&](std::size_t line, std::string_view what) {
    return Answer{Status::malformed, {}, fmt::format("line {} of its answers {}", line + 2, what)};
  };
  const bool is_float = batch.scalar == suite::ScalarKind::float32;
  answer.numbers.reserve(batch.count() * batch.answer_size());
  for (std::size_t k = 0; k < batch.count(); ++k) {
    const auto line = next_line(text);
    if (!line) return malformed(k, "is missing");
    const auto words = words_of(*line);
    if (words.size() != batch.answer_size())
      return malformed(k, fmt::format("has {} numbers, not {}", words.size(), batch.answer_size()));
    for (const auto word : words) {
      const auto value = number::parse_number(word);
      if (!value) return malformed(k, fmt::format("has \"{}\", which is not a number", echo(word)));
      answer.numbers.push_back(is_float ? static_cast<double>(static_cast<float>(*value)) : *value);
    }
  }
  if (text.find_first_not_of("\n \t\r") != std::string_view::npos)
    return malformed(batch.count(), "is beyond the last input");
  return answer;
}

/// SHA-256 of the lines that sha256sum prints for the words of the command that are files; empty where none is.
std::string digest_of_files(std::string_view command) {
  std::string lines;
  for (const auto word : words_of(command)) {
    std::error_code ignored;
    const std::filesystem::path path(word);
    if (std::filesystem::is_regular_file(path, ignored))
      lines += bundle::sha256sum_line(path.filename().string(), bundle::read_file(path));
  }
  return lines.empty() ? std::string() : bundle::sha256_hex(lines);
}

/// What a program reads for a batch: a line `bezierbench-program 1 FORM DIMENSION DEGREE COUNT`, with precision and
/// problem unless the program has only points in double, then a line for each input: what the problem gives, the
/// coefficients point by point, then the weights.
std::string program_input(const suite::ExternalMethod& record, const Batch& batch) {
  auto text =
      fmt::format("bezierbench-program 1 {} {} {} {}", name(batch.form), batch.dimension, batch.degree, batch.count());
  const suite::ExternalMethod plain;
  if (record.scalars != plain.scalars || record.problems != plain.problems)
    text += fmt::format(" {} {}", suite::name(batch.scalar), name(batch.problem));
  text += '\n';
  const auto each = inputs_of(batch.problem, batch.dimension);
  for (std::size_t k = 0; k < batch.count(); ++k) {
    const auto curve = batch.curve(k);
    for (const auto values : {std::span(batch.inputs).subspan(k * each, each), curve.coefficients, curve.weights})
      for (const double value : values) text += number::hexadecimal(value) + ' ';
    text.back() = '\n';
  }
  return text;
}

class Program final : public Method {
 public:
  Program(const std::string& command, const Limits& limits, bool (*stop)()) : limits_(limits), stop_(stop) {
    record_.kind = suite::ExternalKind::program;
    record_.source = command;
    record_.sha256 = digest_of_files(command);
    const auto refuse = [&](std::string_view what) {
      throw Failure(Exit::usage, "--program {}: {}; see docs/own_method.md", echo(command), echo(what));
    };
    const auto ended = run(Batch(), to_describe(limits_));
    if (ended.end != End::exited || ended.code != 0) refuse(failed(ended).detail);
    std::string_view text = ended.output;
    const auto first = next_line(text);
    if (!first) refuse("it wrote no line");
    if (const auto what = read_first_line(*first, record_); !what.empty()) refuse(what);
  }

  [[nodiscard]] const suite::ExternalMethod& record() const override { return record_; }

  [[nodiscard]] Answer ask(const Batch& batch) const override {
    const auto ended = run(batch, limits_);
    if (ended.end != End::exited || ended.code != 0) return failed(ended);
    std::string_view text = ended.output;
    const auto first = next_line(text);
    suite::ExternalMethod again;
    std::tie(again.kind, again.source, again.sha256) = std::tie(record_.kind, record_.source, record_.sha256);
    if (!first || !read_first_line(*first, again).empty() || again != record_)
      return {Status::malformed, {}, "the first line of its answers differs from the one at the start of the run"};
    return read_answers(text, batch);
  }

 private:
  [[nodiscard]] Ended run(const Batch& batch, const Limits& limits) const {
    constexpr std::size_t longest_number = 64;
    constexpr std::size_t room = 1U << 20U;
    const auto numbers = batch.count() * batch.answer_size();
    const auto work = [this] {
      execl("/bin/sh", "sh", "-c", record_.source.c_str(), nullptr);
      constexpr int not_found = 127;
      _exit(not_found);
    };
    auto ended = run_in_child(work, program_input(record_, batch), room + longest_number * numbers, limits, stop_);
    constexpr int signalled = 128;  // the shell's code for a command that a signal ended, less its number
    if (ended.end == End::exited && ended.code > signalled && ended.code < signalled + NSIG) {
      ended.end = End::signalled;
      ended.code -= signalled;
    }
    return ended;
  }

  suite::ExternalMethod record_;
  Limits limits_;
  bool (*stop_)();
};

}  // namespace

std::shared_ptr<const Method> program(const std::string& command, const Limits& limits, bool (*stop)()) {
  return std::make_shared<Program>(command, limits, stop);
}

}  // namespace bezierbench::external
