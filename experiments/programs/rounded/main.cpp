// SPDX-License-Identifier: MIT
// Is every result of `correctly_rounded` the number nearest to the exact value? Random points against the certified
// reference, random points and hard cases against the integers of the reference; how often each stage decided.
// bezierbench_rounded [--random N] [--integers N] [--hard N] [--threads N] [--seed N]; exit 1 where one is misrounded.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/batch/batch.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/methods/correctly_rounded.hpp"
#include "core/evaluate/methods/correctly_rounded_power.hpp"
#include "experiments/programs/pieces.hpp"
#include "experiments/studies/hard_cases/families.hpp"
#include "reference/certified_points.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"

namespace {

using namespace bezierbench;
using studies::hard::Draw;

constexpr int dimension = 2;
constexpr int largest_degree = 40;

struct Counts {
  long points = 0;  ///< coordinates, to be exact
  long misrounded = 0;
  long by_pair = 0;
  long by_p_tilde = 0;
  long by_integers = 0;
  long uncertain = 0;  ///< to the certified reference, which its integers settled

  Counts& operator+=(const Counts& more) {
    points += more.points;
    misrounded += more.misrounded;
    by_pair += more.by_pair;
    by_p_tilde += more.by_p_tilde;
    by_integers += more.by_integers;
    uncertain += more.uncertain;
    return *this;
  }
};

template <class Scalar>
constexpr reference::Format format = sizeof(Scalar) == sizeof(double) ? reference::binary64 : reference::binary32;

/// Prints the first wrong ones.
template <class Scalar>
void judge(Counts& counts, Scalar ours, double right, Form form, int degree, Scalar t) {
  ++counts.points;
  if (static_cast<double>(ours) == right) return;
  if (++counts.misrounded <= 3)
    fmt::print("MISROUNDED: {} form, degree {}, t {}: {} for {}\n", name(form), degree, number::hexadecimal(double{t}),
               number::hexadecimal(double{ours}), number::hexadecimal(right));
}

template <class E, class Scalar, class State>
void count_stage(Counts& counts, const State& prepared, Scalar t) {
  constexpr int axes = State::Coefficients::dimension;
  const auto pairs = E::template pairs<axes>(prepared, t);
  for (int axis = 0; axis < axes; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (!std::isnan(decided<Scalar>(pairs[a], prepared.rounding[a])))
      ++counts.by_pair;
    else if (!std::isnan(settled_by_p_tilde(prepared.axis(axis), t, E::info.form)))
      ++counts.by_p_tilde;
    else
      ++counts.by_integers;
  }
}

/// Many t of one curve in the plane: points by the kernel that is timed and by those for many t, which must agree.
template <class E>
class RandomCurve {
 public:
  RandomCurve(Draw<double>& draw, std::size_t points)
      : degree_(draw.between(0, largest_degree)),
        prepared_(E::prepare(instantiate::load<E::info.form, dimension>(draw_curve(draw)))) {
    for (std::size_t k = 0; k < points; ++k) t_.push_back(draw.unit());
    ours_.resize(points * dimension);
    const auto& kernel = *find_kernel<double>(E::info.id, E::info.form, dimension);
    alignas(64) thread_local std::byte memory[sizeof(State)];
    if (kernel.prepared_size > sizeof memory) throw std::logic_error("the kernel prepares another state");
    kernel.prepare(view(), memory);
    kernel.evaluate_for(degree_)(memory, t_, ours_.data());
    std::vector<double> by_axis(ours_.size());
    for (const auto* target : batch::usable_targets()) {
      batch::find(*target, kernel)(memory, t_, by_axis.data());
      for (std::size_t k = 0; k < points; ++k)
        for (std::size_t axis = 0; axis < dimension; ++axis)
          if (by_axis[axis * points + k] != ours_[k * dimension + axis]) ++batch_differs_;
    }
  }

  void against_certified(Counts& counts) {
    reference::CertifiedPoints certified(E::info.form, dimension, degree_);
    for (std::size_t first = 0; first < t_.size(); first += reference::certified_lanes) {
      for (std::size_t lane = 0; lane < reference::certified_lanes; ++lane)
        certified.load(lane, view(), t_[std::min(first + lane, t_.size() - 1)]);
      certified.evaluate();
      for (std::size_t lane = 0; lane < reference::certified_lanes && first + lane < t_.size(); ++lane)
        judge_one(counts, first + lane, certified.point(lane));
    }
    finish(counts);
  }
  void against_integers(Counts& counts) {
    for (std::size_t k = 0; k < t_.size(); ++k) judge_one(counts, k, std::nullopt);
    finish(counts);
  }

 private:
  using State = PreparedOf<E, double, dimension>;

  CurveView<double> draw_curve(Draw<double>& draw) {
    const int exponent = draw.between(-30, 30);
    for (int i = 0; i < (degree_ + 1) * dimension; ++i) drawn_.push_back(std::ldexp(draw.symmetric(), exponent));
    return view();
  }
  [[nodiscard]] CurveView<double> view() const { return {E::info.form, dimension, degree_, drawn_}; }

  /// The integers decide what the certified values leave open, or everything without certified values.
  void judge_one(Counts& counts, std::size_t k, const std::optional<reference::CertifiedPoint>& certified) {
    count_stage<E>(counts, prepared_, t_[k]);
    for (int axis = 0; axis < dimension; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double ours = ours_[k * dimension + a];
      if (certified) {
        const double error = 2 * certified->error;  // twice: the next two operations round
        const double upper = certified->high[a] + (certified->low[a] + error);
        if (upper == certified->high[a] + (certified->low[a] - error)) {
          judge(counts, ours, upper, E::info.form, degree_, t_[k]);
          continue;
        }
      }
      ++counts.uncertain;
      const auto truth = exact_.point(view(), t_[k]).coordinate(axis);
      const double right = reference::round_to(reference::binary64, truth);
      judge(counts, ours, right, E::info.form, degree_, t_[k]);
      const auto coordinate = prepared_.axis(axis).given;
      const double integers =
          E::info.form == Form::power ? rounded_power_sum(coordinate, t_[k]) : rounded_bernstein_sum(coordinate, t_[k]);
      if (integers != right) ++counts.misrounded;
    }
  }
  void finish(Counts& counts) const { counts.misrounded += batch_differs_; }

  int degree_;
  std::vector<double> drawn_;
  std::vector<double> t_;
  std::vector<double> ours_;
  long batch_differs_ = 0;
  State prepared_;
  reference::ExactCurve exact_;
};

template <class E, class Scalar>
void judge_hard_case(Counts& counts, const studies::hard::HardCase<Scalar>& hard, reference::ExactCurve& exact) {
  const int degree = static_cast<int>(hard.coefficients.size()) - 1;
  const CurveView<Scalar> given{E::info.form, 1, degree, hard.coefficients};
  const auto prepared = E::prepare(instantiate::load<E::info.form, 1>(given));
  count_stage<E>(counts, prepared, hard.t);
  const std::vector<double> widened(hard.coefficients.begin(), hard.coefficients.end());
  const auto truth = exact.point({E::info.form, 1, degree, widened}, double{hard.t}).coordinate(0);
  judge(counts, E::evaluate(prepared, hard.t)[0], reference::round_to(format<Scalar>, truth), E::info.form, degree,
        hard.t);
}

bool report(std::string_view what, const Counts& counts) {
  fmt::print("{:<42} {:>12} points  {:>4} misrounded   pair {:>12}   p~ {:>9}   integers {:>9}", what, counts.points,
             counts.misrounded, counts.by_pair, counts.by_p_tilde, counts.by_integers);
  fmt::print("{}\n", counts.uncertain > 0 ? fmt::format("   (reference: {} by integers)", counts.uncertain) : "");
  std::fflush(stdout);
  return counts.misrounded == 0;
}

struct Options {
  long random = 1'000'000'000;
  long integers = 10'000'000;
  long hard = 100'000;
  unsigned threads = std::thread::hardware_concurrency();
  std::uint64_t seed = 1;
};

template <class E>
bool check_random(const Options& options, bool certified) {
  constexpr long points_per_curve = 256;
  constexpr long curves_per_piece = 16;
  const long all = (certified ? options.random : options.integers) / 2;  // half of them in each form
  const auto pieces =
      (all + points_per_curve * curves_per_piece * dimension - 1) / (points_per_curve * curves_per_piece * dimension);
  const auto counts = programs::sum_of_pieces(pieces, options.threads, [&](long piece) {
    Draw<double> draw({options.seed, certified ? 0U : 1U, 0, static_cast<std::uint64_t>(piece)});
    Counts counts_of_piece;
    for (long k = 0; k < curves_per_piece; ++k) {
      RandomCurve<E> curve(draw, points_per_curve);
      certified ? curve.against_certified(counts_of_piece) : curve.against_integers(counts_of_piece);
    }
    return counts_of_piece;
  });
  return report(fmt::format("{}: random, against {}", name(E::info.form), certified ? "certified" : "integers"),
                counts);
}

template <class E, class Scalar>
bool check_hard(const Options& options) {
  constexpr long cases_per_piece = 1000;
  const long pieces = (options.hard + cases_per_piece - 1) / cases_per_piece;
  bool right = true;
  for (const auto& family : studies::hard::families<Scalar>) {
    const auto counts = programs::sum_of_pieces(pieces, options.threads, [&](long piece) {
      Draw<Scalar> draw({options.seed, 2, 0, static_cast<std::uint64_t>(piece)});
      reference::ExactCurve exact;
      Counts counts_of_piece;
      for (long k = 0; k < cases_per_piece; ++k)
        judge_hard_case<E, Scalar>(counts_of_piece, family.draw(draw, E::info.form), exact);
      return counts_of_piece;
    });
    const auto what =
        fmt::format("{}, {}: {}", name(E::info.form), sizeof(Scalar) == 8 ? "double" : "float", family.name);
    right = report(what, counts) && right;
  }
  return right;
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  CLI::App app("Is every result of `correctly_rounded` the number nearest to the exact value?");
  app.add_option("--random", options.random, "random coordinates against the certified reference");
  app.add_option("--integers", options.integers, "random coordinates against the integers of the reference");
  app.add_option("--hard", options.hard, "hard cases of each family");
  app.add_option("--threads", options.threads);
  app.add_option("--seed", options.seed);
  CLI11_PARSE(app, count, arguments);
  bool right = true;
  for (const bool certified : {true, false}) {
    right = check_random<CorrectlyRounded>(options, certified) && right;
    right = check_random<CorrectlyRoundedPower>(options, certified) && right;
  }
  right = check_hard<CorrectlyRounded, double>(options) && right;
  right = check_hard<CorrectlyRoundedPower, double>(options) && right;
  right = check_hard<CorrectlyRounded, float>(options) && right;
  right = check_hard<CorrectlyRoundedPower, float>(options) && right;
  fmt::print("{}\n", right ? "no misrounding" : "MISROUNDED");
  return right ? 0 : 1;
}
