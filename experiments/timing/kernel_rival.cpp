// SPDX-License-Identifier: MIT
#include "experiments/timing/kernel_rival.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

namespace bezierbench::timing {
namespace {

/// What a rival owns: the prepared state, the points of its last batch, and the points it must reproduce.
struct State {
  const Kernel<double>& kernel;
  const Inputs& inputs;
  std::unique_ptr<std::byte[]> memory;
  void* prepared = nullptr;
  std::vector<double> points;
  std::vector<double> judged;

  State(const Kernel<double>& k, const Inputs& in)
      : kernel(k),
        inputs(in),
        memory(new std::byte[k.prepared_size + k.prepared_alignment]),
        points(in.t.size() * static_cast<std::size_t>(in.dimension)),
        judged(points.size()) {
    void* start = memory.get();
    std::size_t room = k.prepared_size + k.prepared_alignment;
    prepared = std::align(k.prepared_alignment, k.prepared_size, start, room);
    kernel.prepare(inputs.curve(0), prepared);
  }

  [[nodiscard]] double* point(std::size_t k) { return points.data() + k * static_cast<std::size_t>(inputs.dimension); }
  void evaluate(std::size_t k, double t) { kernel.evaluate(prepared, std::span<const double>(&t, 1), point(k)); }
};

void one_shot(State& s) {
  for (std::size_t k = 0; k < s.inputs.t.size(); ++k) {
    s.kernel.prepare(s.inputs.curve(k), s.prepared);
    s.evaluate(k, s.inputs.t[k]);
  }
}

void point_by_point(State& s) {
  for (std::size_t k = 0; k < s.inputs.t.size(); ++k) s.evaluate(k, s.inputs.t[k]);
}

/// Each t waits for the last point: 0 times a finite number added changes no bit of t > 0, which no compiler can know.
void dependent_chain(State& s) {
  double last = 0;
  for (std::size_t k = 0; k < s.inputs.t.size(); ++k) {
    s.evaluate(k, s.inputs.t[k] + 0.0 * last);
    last = *s.point(k);
  }
}

void batch(State& s) { s.kernel.evaluate(s.prepared, s.inputs.t, s.points.data()); }

void (*run_of(suite::Mode mode))(State&) {
  switch (mode) {
    case suite::Mode::one_shot: return one_shot;
    case suite::Mode::point: return point_by_point;
    case suite::Mode::latency: return dependent_chain;
    case suite::Mode::batch: return batch;
  }
  return nullptr;
}

/// The points that the batch must reproduce, bit for bit: by the kernel's own functions, one at a time.
void judge(State& s, suite::Mode mode) {
  for (std::size_t k = 0; k < s.inputs.t.size(); ++k) {
    if (mode == suite::Mode::one_shot) s.kernel.prepare(s.inputs.curve(k), s.prepared);
    s.evaluate(k, s.inputs.t[k]);
  }
  s.judged = s.points;
  std::ranges::fill(s.points, std::numeric_limits<double>::quiet_NaN());
}

/// Are the points the judged ones? Spoils them, so that a batch that writes nothing cannot pass the next check.
bool check(State& s) {
  const bool same = std::memcmp(s.points.data(), s.judged.data(), s.points.size() * sizeof(double)) == 0;
  std::ranges::fill(s.points, std::numeric_limits<double>::quiet_NaN());
  return same;
}

}  // namespace

Rival kernel_rival(const Kernel<double>& kernel, suite::Mode mode, const Inputs& inputs) {
  auto state = std::make_shared<State>(kernel, inputs);
  judge(*state, mode);
  return {std::string(kernel.info->id), inputs.t.size(), [state, run = run_of(mode)] { run(*state); },
          [state] { return check(*state); }};
}

}  // namespace bezierbench::timing
