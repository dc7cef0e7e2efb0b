// SPDX-License-Identifier: MIT
#include "experiments/race/kernel_rival.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/race/counts.hpp"
#include "experiments/race/rounds.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::race {

namespace {

constexpr std::size_t third_of_page = 1344;  // in whole cache lines
constexpr std::size_t place_of_state = 960;  // in its first third, behind all but the largest prepared states

/// The memory of a rival: the prepared state, the parameters, the points of its last batch, and the points it must
/// reproduce. State, parameters and points lie in different thirds of a page, at the same offsets for every rival.
template <class Scalar>
struct State {
  static constexpr Scalar spoilt = std::numeric_limits<Scalar>::quiet_NaN();

  const Kernel<Scalar>& kernel;
  const Inputs<Scalar>& inputs;
  const EvaluatePoints<Scalar> evaluate;  ///< for the degree of the inputs
  PageVector<std::byte, 0> prepared;
  PageVector<Scalar, third_of_page> t;
  PageVector<Scalar, 2 * third_of_page> points;
  std::vector<Scalar> judged;

  State(const Kernel<Scalar>& k, const Inputs<Scalar>& in, std::vector<Scalar> right)
      : kernel(k),
        inputs(in),
        evaluate(k.evaluate_for(in.degree)),
        prepared(k.prepared_size),
        t(in.t.begin(), in.t.end()),
        points(right.size(), spoilt),
        judged(std::move(right)) {
    if (kernel.prepared_alignment > page) throw std::invalid_argument("a prepared state aligned to more than a page");
    kernel.prepare(inputs.curve(0), prepared.data());
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  State(State&&) = delete;
  State& operator=(State&&) = delete;
  ~State() { destroy(); }

  /// Prepares another curve. Destroying the state of the last one is part of the cost of a curve.
  void prepare(std::size_t k) {
    destroy();
    kernel.prepare(inputs.curve(k), prepared.data());
  }

  /// Drops all inputs but the first `count`.
  void keep(std::size_t count) {
    t.resize(count);
    points.resize(count * static_cast<std::size_t>(inputs.dimension));
    judged.resize(points.size());
  }

  /// True where the points are the judged ones. Overwrites them, so that a batch that writes nothing fails the next
  /// check.
  bool check() {
    const bool same = std::memcmp(points.data(), judged.data(), points.size() * sizeof(Scalar)) == 0;
    spoil();
    return same;
  }
  void spoil() { std::ranges::fill(points, spoilt); }

 private:
  void destroy() {
    if (kernel.destroy != nullptr) kernel.destroy(prepared.data());
  }
};

/// Evaluates one t at a time. The members are copied before the loop, so that the loop reads registers, the stack, and
/// the vectors of the state only.
template <class Scalar>
struct PointByPoint {
  explicit PointByPoint(State<Scalar>& s)
      : function(s.evaluate),
        prepared(s.prepared.data()),
        t(s.t),
        points(s.points.data()),
        dimension(static_cast<std::size_t>(s.inputs.dimension)) {}

  EvaluatePoints<Scalar> function;
  const void* prepared;
  std::span<const Scalar> t;
  Scalar* points;
  std::size_t dimension;

  [[nodiscard]] Scalar* point(std::size_t k) const { return points + k * dimension; }
  void evaluate(std::size_t k, Scalar at) const { function(prepared, std::span<const Scalar>(&at, 1), point(k)); }
};

/// Prepares a curve, chooses the function for its degree, and evaluates one point.
template <class Scalar>
void one_shot(State<Scalar>& s, PointByPoint<Scalar>& points, std::size_t k) {
  s.prepare(k);
  points.function = s.kernel.evaluate_for(s.inputs.degree);
  points.evaluate(k, points.t[k]);
}

template <class Scalar>
void one_shots(State<Scalar>& s) {
  PointByPoint<Scalar> points(s);
  for (std::size_t k = 0; k < points.t.size(); ++k) one_shot(s, points, k);
}

constexpr std::size_t min_one_shots = 8;
constexpr double max_one_shots_seconds = 4 * min_round_seconds;

/// The time of one of the first inputs in mode one_shot: the fastest of three attempts, because a preemption may
/// disturb one.
template <class Scalar>
double one_shot_seconds(State<Scalar>& s) {
  PointByPoint<Scalar> points(s);
  std::int64_t fastest = std::numeric_limits<std::int64_t>::max();
  for (int attempt = 0; attempt < 3; ++attempt) {
    const std::int64_t start = steady_ns();
    for (std::size_t k = 0; k < min_one_shots; ++k) one_shot(s, points, k);
    fastest = std::min(fastest, steady_ns() - start);
  }
  s.spoil();
  return 1e-9 * static_cast<double>(fastest) / min_one_shots;
}

/// Where one batch would take longer than several rounds, keeps as many inputs as fill one round.
template <class Scalar>
void shorten_one_shots(State<Scalar>& s) {
  if (s.t.size() <= min_one_shots || runs_under_valgrind()) return;  // counts must not depend on times
  const double seconds = one_shot_seconds(s);
  if (seconds * static_cast<double>(s.t.size()) <= max_one_shots_seconds) return;
  s.keep(std::max(min_one_shots, static_cast<std::size_t>(min_round_seconds / seconds)));
}

template <class Scalar>
void point_by_point(State<Scalar>& s) {
  const PointByPoint<Scalar> points(s);
  for (std::size_t k = 0; k < points.t.size(); ++k) points.evaluate(k, points.t[k]);
}

/// Each t waits for every coordinate of the last point: their bits, masked by a zero that the compiler cannot know, are
/// or-ed into its own. No bit of t changes, whatever the point is; adding 0 times the point would make t NaN after an
/// infinity. Points and t go through memory anyway, so that this costs two operations on integers.
template <class Scalar>
void dependent_chain(State<Scalar>& s) {
  using Bits = std::conditional_t<sizeof(Scalar) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  const PointByPoint<Scalar> points(s);
  volatile Bits hidden = 0;
  const Bits zero = hidden;
  Bits last = 0;
  for (std::size_t k = 0; k < points.t.size(); ++k) {
    points.evaluate(k, std::bit_cast<Scalar>(std::bit_cast<Bits>(points.t[k]) | (last & zero)));
    for (std::size_t axis = 0; axis < points.dimension; ++axis) last |= std::bit_cast<Bits>(points.point(k)[axis]);
  }
}

template <class Scalar>
void all_at_once(State<Scalar>& s) {
  s.evaluate(s.prepared.data(), s.t, s.points.data());
}

template <class Scalar>
void (*run_of(suite::Mode mode))(State<Scalar>&) {
  switch (mode) {
    case suite::Mode::one_shot: return one_shots<Scalar>;
    case suite::Mode::point: return point_by_point<Scalar>;
    case suite::Mode::latency: return dependent_chain<Scalar>;
    case suite::Mode::batch: return all_at_once<Scalar>;
  }
  return nullptr;
}

template <class Scalar>
std::shared_ptr<State<Scalar>> state_of(const Kernel<Scalar>& kernel, const Inputs<Scalar>& inputs,
                                        std::vector<Scalar> judged) {
  return std::allocate_shared<State<Scalar>>(AtPagePlace<State<Scalar>, place_of_state>(), kernel, inputs,
                                             std::move(judged));
}

template <class Scalar>
Rival rival_of(const std::shared_ptr<State<Scalar>>& state, std::function<void()> run) {
  return {std::string(state->kernel.info->id), state->t.size(), std::move(run), [state] { return state->check(); }};
}

/// Reorders points: from point by point to axis by axis.
template <class Scalar>
std::vector<Scalar> by_axis(const std::vector<Scalar>& points, std::size_t dimension) {
  std::vector<Scalar> sorted;
  for (std::size_t axis = 0; axis < dimension; ++axis)
    for (std::size_t k = axis; k < points.size(); k += dimension) sorted.push_back(points[k]);
  return sorted;
}

template <class Scalar>
Rival vector_rival(const batch::Target& target, const Kernel<Scalar>& kernel, const Inputs<Scalar>& inputs,
                   const std::vector<Scalar>& judged) {
  auto state = state_of(kernel, inputs, by_axis(judged, static_cast<std::size_t>(inputs.dimension)));
  const auto vectors = batch::find(target, kernel);
  auto rival = rival_of(state, [state, vectors] { vectors(state->prepared.data(), state->t, state->points.data()); });
  rival.target = target.name;
  return rival;
}

constexpr MethodInfo empty_method{.id = "call", .label = "empty kernel", .flops = "0", .citation = ""};

/// Evaluates no point but the first.
template <class Scalar, int Dimension>
void evaluate_first(const void* /*prepared*/, std::span<const Scalar> t, Scalar* points) {
  for (int axis = 0; axis < Dimension; ++axis) points[axis] = t[0];
}

/// Prepares nothing.
template <class Scalar, int Dimension>
constexpr Kernel<Scalar> empty_kernel{.info = &empty_method,
                                      .dimension = Dimension,
                                      .prepared_size = 1,
                                      .prepared_alignment = 1,
                                      .prepare = [](const CurveView<Scalar>& /*curve*/, void* /*prepared*/) {},
                                      .evaluate_for = for_every_degree<Scalar, evaluate_first<Scalar, Dimension>>,
                                      .evaluator = &empty_method,
                                      .conversion = nullptr,
                                      .evaluated_form = Form::bernstein,
                                      .converted = nullptr};

template <class Scalar>
const Kernel<Scalar>& empty_kernel_of(int dimension) {
  static constexpr std::array<const Kernel<Scalar>*, 3> all{&empty_kernel<Scalar, 1>, &empty_kernel<Scalar, 2>,
                                                            &empty_kernel<Scalar, 3>};
  return *all.at(static_cast<std::size_t>(dimension) - 1);
}

}  // namespace

template <class Scalar>
Rival call_rival(suite::Mode mode, const Inputs<Scalar>& inputs) {
  const auto dimension = static_cast<std::size_t>(inputs.dimension);
  std::vector<Scalar> judged(inputs.t.size() * dimension, State<Scalar>::spoilt);
  const std::size_t written = mode == suite::Mode::batch ? 1 : inputs.t.size();
  for (std::size_t k = 0; k < written; ++k)
    std::fill_n(judged.begin() + static_cast<std::ptrdiff_t>(k * dimension), dimension, inputs.t[k]);
  return kernel_rival(empty_kernel_of<Scalar>(inputs.dimension), mode, inputs, std::move(judged));
}

template Rival call_rival<float>(suite::Mode, const Inputs<float>&);
template Rival call_rival<double>(suite::Mode, const Inputs<double>&);

template <class Scalar>
Rival kernel_rival(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs,
                   std::vector<Scalar> judged) {
  if (mode == suite::Mode::batch)
    for (const auto* target : batch::usable_targets())
      if (batch::find(*target, kernel)) return vector_rival(*target, kernel, inputs, judged);
  auto state = state_of(kernel, inputs, std::move(judged));
  if (mode == suite::Mode::one_shot) shorten_one_shots(*state);
  return rival_of<Scalar>(state, [state, run = run_of<Scalar>(mode)] { run(*state); });
}

template Rival kernel_rival<float>(const Kernel<float>&, suite::Mode, const Inputs<float>&, std::vector<float>);
template Rival kernel_rival<double>(const Kernel<double>&, suite::Mode, const Inputs<double>&, std::vector<double>);

namespace {

/// The given curve in double, exactly.
std::vector<double> widened(std::span<const float> values) { return {values.begin(), values.end()}; }
std::span<const double> widened(std::span<const double> values) { return values; }

}  // namespace

template <class Scalar>
JudgedPoints<Scalar> judge_points(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs) {
  constexpr auto arithmetic = judge::ScalarFacts<Scalar>::arithmetic;
  reference::ExactCurve exact;
  reference::TrialScale scale;
  const auto dimension = static_cast<std::size_t>(inputs.dimension);
  JudgedPoints<Scalar> judged{std::vector<Scalar>(inputs.t.size() * dimension), true, std::nullopt};
  const auto& proved = kernel.info->bound;
  for (std::size_t k = 0; k < inputs.t.size(); ++k) {
    const auto curve = inputs.curve_of(k, mode);
    const auto point = std::span(judged.points).subspan(k * dimension, dimension);
    PreparedState<Scalar>(kernel, curve).evaluate({&inputs.t[k], 1}, point.data());

    const auto coefficients = widened(curve.coefficients);
    const auto weights = widened(curve.weights);
    const CurveView<double> given{curve.form, curve.dimension, curve.degree, coefficients, weights};
    const auto t = static_cast<double>(inputs.t[k]);
    scale.set(given, t);
    const double error = reference::Distance(exact.point(given, t)).to(widened(std::span<const Scalar>(point)));
    judged.right = judged.right && std::isfinite(error);
    const double bound = proved ? scale.bound(*proved, arithmetic) : std::numeric_limits<double>::infinity();
    if (std::isfinite(bound))
      judged.right = judged.right && !reference::TrialScale::violates(error, bound);
    else
      judged.max_error_u = std::max(judged.max_error_u.value_or(0), scale.in_bound_units(error, arithmetic));
  }
  return judged;
}

template JudgedPoints<float> judge_points<float>(const Kernel<float>&, suite::Mode, const Inputs<float>&);
template JudgedPoints<double> judge_points<double>(const Kernel<double>&, suite::Mode, const Inputs<double>&);

}  // namespace bezierbench::race
