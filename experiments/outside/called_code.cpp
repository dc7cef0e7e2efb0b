// SPDX-License-Identifier: MIT
#include "experiments/outside/called_code.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <string_view>

namespace bezierbench::outside {
namespace {

/// Doubles between two ends that nobody may write to.
class Guarded {
 public:
  explicit Guarded(std::size_t size) : values_(size + 2 * guard, untouched()) {}
  [[nodiscard]] double* data() { return values_.data() + guard; }
  [[nodiscard]] std::size_t size() const { return values_.size() - 2 * guard; }
  [[nodiscard]] bool intact() const {
    for (std::size_t k = 0; k < guard; ++k)
      if (!is_untouched(values_[k]) || !is_untouched(values_[values_.size() - 1 - k])) return false;
    return true;
  }

 private:
  static constexpr std::size_t guard = 64;
  /// A NaN, so that a point that was not written counts as not finite.
  static constexpr std::uint64_t pattern = 0x7ff8'5eed'0bad'f00dU;
  static double untouched() { return std::bit_cast<double>(pattern); }
  static bool is_untouched(double value) { return std::bit_cast<std::uint64_t>(value) == pattern; }

  std::vector<double> values_;
};

std::size_t allocated_bytes() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Memory that grows in each of the last quarters of a batch; the first may fill what a method keeps for good.
class Growth {
 public:
  explicit Growth(std::size_t count) : quarter_(count / 4) {}
  void after(std::size_t done) {
    if (quarter_ == 0 || done % quarter_ != 0) return;
    const auto now = allocated_bytes();
    if (done > quarter_ && done <= 4 * quarter_ && now > last_) ++grown_;
    last_ = now;
  }
  [[nodiscard]] bool found() const { return grown_ == 3; }

 private:
  std::size_t quarter_;
  std::size_t last_ = 0;
  int grown_ = 0;
};

void evaluate_each(const Kernel<double>& kernel, const Batch& batch, double* points, Growth& growth) {
  const auto alignment = std::align_val_t{std::max(kernel.prepared_alignment, alignof(std::max_align_t))};
  void* const prepared = ::operator new(kernel.prepared_size, alignment);
  const auto evaluate = kernel.evaluate_for(batch.degree);
  for (std::size_t k = 0; k < batch.count(); ++k) {
    kernel.prepare(batch.curve(k), prepared);
    evaluate(prepared, std::span(&batch.t[k], 1), points + k * static_cast<std::size_t>(batch.dimension));
    if (kernel.destroy != nullptr) kernel.destroy(prepared);
    growth.after(k + 1);
  }
  ::operator delete(prepared, alignment);
}

Status evaluate_watched(const OpenKernel& open, const Batch& batch, Guarded& points) {
  const auto* kernel = open(batch.dimension);
  if (kernel == nullptr) return Status::exited;
  Batch given = batch;  // what the method sees, so that a change shows
  Growth growth(batch.count());
  try {
    evaluate_each(*kernel, given, points.data(), growth);
  } catch (const CurveRefused&) {
    return Status::refused;
  } catch (...) {
    return Status::threw;
  }
  const auto same = [](const std::vector<double>& a, const std::vector<double>& b) {
    return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;  // there may be no weights
  };
  if (!points.intact() || !same(given.t, batch.t) || !same(given.coefficients, batch.coefficients) ||
      !same(given.weights, batch.weights))
    return Status::wrote_out_of_bounds;
  if (!has_usual_arithmetic()) return Status::changed_rounding;
  return growth.found() ? Status::leaked : Status::ok;
}

std::string_view last_line(std::string_view text) {
  const auto end = text.find_last_not_of(" \n\r\t");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

bool has_usual_arithmetic() {
  volatile double smallest = std::numeric_limits<double>::min();
  volatile double two = 2;
  return std::fegetround() == FE_TONEAREST && smallest / two != 0;
}

Answer failed(const Ended& ended) {
  const auto said = last_line(ended.errors);
  const auto with = [&](const std::string& how) { return said.empty() ? how : fmt::format("{}: {}", how, said); };
  switch (ended.end) {
    case End::exited: {
      const auto* const when = ended.code == 0 ? " before it had answered" : "";
      return {Status::exited, {}, with(fmt::format("the process ended with code {}{}", ended.code, when))};
    }
    case End::signalled:
      return {Status::crashed, {}, with(fmt::format("signal {} ({})", ended.code, strsignal(ended.code)))};
    case End::timed_out: return {Status::timed_out, {}, with("it did not end within the limit of time")};
    case End::interrupted: break;
  }
  return {Status::timed_out, {}, "interrupted"};
}

Answer ask_code(const OpenKernel& open, const Batch& batch, const Limits& limits, bool (*stop)()) {
  const std::size_t numbers = batch.count() * static_cast<std::size_t>(batch.dimension);
  const auto work = [&] {
    const int answer = keep_output_for_answer();
    Guarded points(numbers);
    const Status status = evaluate_watched(open, batch, points);
    write_all(answer, {reinterpret_cast<const char*>(&status), sizeof status});
    write_all(answer, {reinterpret_cast<const char*>(points.data()), numbers * sizeof(double)});
  };
  constexpr std::size_t room_for_errors = 1U << 20U;
  const auto size = sizeof(Status) + numbers * sizeof(double);
  const auto ended = run_in_child(work, {}, size + room_for_errors, limits, stop);
  if (ended.end != End::exited || ended.code != 0 || ended.output.size() != size) return failed(ended);
  Answer answer;
  std::memcpy(&answer.status, ended.output.data(), sizeof answer.status);
  answer.points.resize(numbers);
  std::memcpy(answer.points.data(), ended.output.data() + sizeof answer.status, numbers * sizeof(double));
  if (answer.status != Status::ok) answer.detail = last_line(ended.errors);
  return answer;
}

}  // namespace bezierbench::outside
