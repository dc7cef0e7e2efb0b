// SPDX-License-Identifier: MIT
// Does an input refute the evaluators that are said to keep ends_exact, constant_reproduced, in_hull, monotone, reversal
// and finite? Each curve is tried at many t, which batch kernels evaluate together.
// bezierbench_kept [--inputs N] [--threads N] [--seed N] [--method ID]; exit 1 where one is refuted.
// N inputs (10^9) for each of these properties are shared by degrees 1, 2, 3, 5 and 10 in double and float, half of them
// on curves of full significands and half on the special ones of experiments/guarantees/draws.hpp.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/batch/batch.hpp"
#include "core/evaluate/guarantee.hpp"
#include "experiments/guarantees/draws.hpp"
#include "experiments/guarantees/statements.hpp"
#include "experiments/programs/pieces.hpp"
#include "reference/number/number.hpp"

namespace {

using namespace bezierbench;
using guarantees::Case;

constexpr std::array kept{Property::ends_exact, Property::constant_reproduced,
                          Property::in_hull,    Property::monotone,
                          Property::reversal,   Property::finite};
constexpr std::array degrees{1, 2, 3, 5, 10};

struct Counts {
  long inputs = 0;
  long broken = 0;

  Counts& operator+=(const Counts& more) {
    inputs += more.inputs;
    broken += more.broken;
    return *this;
  }
};

/// Prints the first few inputs that break a property.
template <class Scalar>
void print_broken(const MethodInfo& method, Property property, const Case<Scalar>& input) {
  static std::mutex mutex;
  static int printed = 0;
  const std::scoped_lock lock(mutex);
  if (++printed > 8) return;
  fmt::print("REFUTED: {} of {} in {}, t {} and {}, points", name(property), method.id,
             sizeof(Scalar) == sizeof(float) ? "float" : "double", number::hexadecimal(double{input.t}),
             number::hexadecimal(double{input.t_next}));
  for (const Scalar value : input.coefficients) fmt::print(" {}", number::hexadecimal(double{value}));
  fmt::print("\n");
}

/// The values of a curve on one axis at many t.
template <class Scalar>
class Values {
 public:
  explicit Values(const Kernel<Scalar>& kernel) : kernel_(kernel) {
    for (const auto* target : batch::usable_targets())
      if (!batch_) batch_ = batch::find(*target, kernel);
  }
  const std::vector<Scalar>& at(const std::vector<Scalar>& coefficients, const std::vector<Scalar>& t) {
    void* prepared = storage_.reserve(kernel_.prepared_size);
    const int degree = static_cast<int>(coefficients.size()) - 1;
    kernel_.prepare({Form::bernstein, 1, degree, coefficients}, prepared);
    values_.resize(t.size());
    if (batch_)
      batch_(prepared, t, values_.data());
    else
      kernel_.evaluate_for(degree)(prepared, t, values_.data());
    if (kernel_.destroy != nullptr) kernel_.destroy(prepared);
    return values_;
  }

 private:
  const Kernel<Scalar>& kernel_;
  batch::BatchKernel<Scalar> batch_;
  judge::PreparedStorage storage_;
  std::vector<Scalar> values_;
};

/// One property of one method at one degree. Values that pass here keep the property; the statement decides the others.
template <class Scalar>
class Trials {
 public:
  Trials(const Kernel<Scalar>& kernel, Property property, int degree)
      : kernel_(kernel),
        statement_(
            *std::ranges::find(guarantees::statements<Scalar>, property, &guarantees::Statement<Scalar>::property)),
        values_(kernel),
        backwards_(kernel),
        method_(kernel) {
    input_.coefficients.resize(static_cast<std::size_t>(degree) + 1);
  }

  /// Another curve at many t.
  void add_curve(guarantees::Draws<Scalar>& draws, bool special, Counts& counts) {
    if (special)
      draws.special(input_, 1);
    else
      draws.full(input_, 1);
    statement_.fit(input_);
    draw_parameters(draws);
    const auto& values = values_.at(input_.coefficients, t_);
    const auto [low, high] = std::ranges::minmax(input_.coefficients);
    const std::size_t step = statement_.uses_t_next ? 2 : 1;
    const std::vector<Scalar>* reversed = nullptr;
    if (statement_.property == Property::reversal) reversed = &at_other_ends();
    const Scalar first = input_.coefficients.front();
    const Scalar last = input_.coefficients.back();
    for (std::size_t k = 0; k < values.size(); k += step) {
      ++counts.inputs;
      const Scalar value = values[k];
      bool keeps = false;
      switch (statement_.property) {
        case Property::ends_exact: keeps = value == (t_[k] == 0 ? first : last); break;
        case Property::monotone:
          keeps = (first > last || value <= values[k + 1]) && (first < last || value >= values[k + 1]);
          break;
        case Property::reversal: keeps = value == (*reversed)[k]; break;
        case Property::finite: keeps = std::isfinite(value); break;
        default: keeps = low <= value && value <= high;  // of a constant this is equality
      }
      if (!keeps) decide(k, counts);
    }
  }

 private:
  static constexpr std::size_t at_once = 256;

  void draw_parameters(guarantees::Draws<Scalar>& draws) {
    t_.clear();
    if (statement_.property == Property::ends_exact) {
      t_ = {Scalar(0), Scalar(1)};
      return;
    }
    while (t_.size() < at_once) {
      Scalar t = guarantees::into_unit_interval(draws.any_parameter());
      if (statement_.property == Property::reversal) t = 1 - (1 - t);
      if (statement_.uses_t_next && t == 1) continue;
      t_.push_back(t);
      if (statement_.uses_t_next) t_.push_back(std::nextafter(t, Scalar(1)));
    }
  }

  const std::vector<Scalar>& at_other_ends() {
    const std::vector<Scalar> points(input_.coefficients.rbegin(), input_.coefficients.rend());
    std::vector<Scalar> complements(t_.size());
    std::ranges::transform(t_, complements.begin(), [](Scalar t) { return 1 - t; });
    return backwards_.at(points, complements);
  }

  void decide(std::size_t k, Counts& counts) {
    Case<Scalar> one = input_;
    one.t = t_[k];
    one.t_next = statement_.uses_t_next ? t_[k + 1] : Scalar(0);
    const auto excess = statement_.excess(method_, one);
    if (!excess || !(*excess > 0)) return;
    ++counts.broken;
    print_broken(*kernel_.info, statement_.property, one);
  }

  const Kernel<Scalar>& kernel_;
  const guarantees::Statement<Scalar>& statement_;
  Values<Scalar> values_;
  Values<Scalar> backwards_;
  guarantees::Evaluation<Scalar> method_;
  Case<Scalar> input_;
  std::vector<Scalar> t_;
};

struct Options {
  long inputs = 1'000'000'000;
  unsigned threads = std::thread::hardware_concurrency();
  std::uint64_t seed = 1;
  std::string method;  ///< empty: all that are said to keep the six
};

template <class Scalar>
Counts tried(const Kernel<Scalar>& kernel, Property property, int degree, long inputs, const Options& options) {
  constexpr long inputs_per_piece = 1 << 14;
  const long pieces = (inputs + inputs_per_piece - 1) / inputs_per_piece;
  return programs::sum_of_pieces(pieces, options.threads, [&](long piece) {
    sample::Words words(options.seed, static_cast<std::uint64_t>(property),
                        static_cast<std::uint64_t>(degree) * 2 + (sizeof(Scalar) == sizeof(float) ? 1 : 0),
                        static_cast<std::uint64_t>(piece));
    guarantees::Draws<Scalar> draws(words);
    Trials<Scalar> trials(kernel, property, degree);
    Counts counts;
    const long end = std::min(inputs_per_piece, inputs - piece * inputs_per_piece);
    for (bool special = false; counts.inputs < end; special = !special) trials.add_curve(draws, special, counts);
    return counts;
  });
}

bool is_said_to_keep(const MethodInfo& method) {
  return std::ranges::all_of(kept, [&](Property property) { return is_proved(method, property, degrees.back()); });
}

template <class Scalar>
void try_methods(const Options& options, Property property,
                 std::vector<std::pair<std::string_view, Counts>>& by_method) {
  const long each = std::max(1L, options.inputs / static_cast<long>(2 * degrees.size()));
  for (const auto& kernel : kernels<Scalar>(1)) {
    if (kernel.info->form != Form::bernstein) continue;
    if (options.method.empty() ? !is_said_to_keep(*kernel.info) : kernel.info->id != options.method) continue;
    auto found = std::ranges::find(by_method, kernel.info->id, [](const auto& one) { return one.first; });
    if (found == by_method.end()) found = by_method.insert(found, {kernel.info->id, Counts()});
    for (const int degree : degrees) found->second += tried<Scalar>(kernel, property, degree, each, options);
  }
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  CLI::App app("Does an input refute the evaluators that are said to keep six properties?");
  app.add_option("--inputs", options.inputs, "inputs of each property")->check(CLI::PositiveNumber);
  app.add_option("--threads", options.threads)->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed);
  app.add_option("--method", options.method, "id of an evaluator; default: all that are said to keep the six");
  CLI11_PARSE(app, count, arguments);
  bool refuted = false;
  bool tried_any = false;
  for (const Property property : kept) {
    std::vector<std::pair<std::string_view, Counts>> by_method;
    try_methods<double>(options, property, by_method);
    try_methods<float>(options, property, by_method);
    for (const auto& [id, counts] : by_method) {
      fmt::print("{}: {}: {} of {} inputs break it\n", id, name(property), counts.broken, counts.inputs);
      std::fflush(stdout);
      refuted = refuted || counts.broken > 0;
      tried_any = true;
    }
  }
  if (!tried_any) {
    fmt::print(stderr, "no evaluator is said to keep all six, or has this id\n");
    return 1;
  }
  fmt::print("{}\n", refuted ? "REFUTED" : "not refuted");
  return refuted ? 1 : 0;
}
