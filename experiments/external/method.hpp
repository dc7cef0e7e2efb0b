// SPDX-License-Identifier: MIT
// An external method: code or answers that are not part of this program, or that were compiled into a user's own
// program. Batches of inputs are handed to it, each in a child process.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/method.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/external/child.hpp"
#include "experiments/external/own_method.hpp"
#include "experiments/suite/external.hpp"

namespace bezierbench::external {

/// How many numbers a problem gives beside a curve: t; the ends of the part to be measured and the tolerance, relative
/// to the length; the point; t.
constexpr std::size_t inputs_of(Problem problem, int dimension) {
  constexpr std::size_t part_and_tolerance = 3;
  if (problem == Problem::arc_length) return part_and_tolerance;
  return problem == Problem::projection ? static_cast<std::size_t>(dimension) : 1;
}

/// Curves of one form, dimension and degree, each with what a problem gives beside it. In float all numbers are floats.
struct Batch {
  Problem problem = Problem::evaluation;
  suite::ScalarKind scalar = suite::ScalarKind::float64;
  Form form = Form::bernstein;
  int dimension = 2;
  int degree = 0;
  std::vector<double> inputs = {};        ///< curve by curve: those of inputs_of()
  std::vector<double> coefficients = {};  ///< curve by curve, each point by point
  std::vector<double> weights = {};       ///< curve by curve, of rational curves

  void add(const CurveView<double>& curve, std::span<const double> given);
  [[nodiscard]] std::size_t count() const { return inputs.size() / inputs_of(problem, dimension); }
  /// How many numbers an answer has: the point; the length of the part; t and the distance of the nearest point; the
  /// control points of the left half, then of the right one, each in a rational curve followed by its weight.
  [[nodiscard]] std::size_t answer_size() const;
  [[nodiscard]] CurveView<double> curve(std::size_t k) const { return curve<double>(k, coefficients, weights); }
  /// The same with the numbers of all curves in another type.
  template <class Scalar>
  [[nodiscard]] CurveView<Scalar> curve(std::size_t k, std::span<const Scalar> all_coefficients,
                                        std::span<const Scalar> all_weights) const {
    const std::size_t values = static_cast<std::size_t>(degree) + 1;
    const std::size_t numbers = values * static_cast<std::size_t>(dimension);
    CurveView<Scalar> view{form, dimension, degree, all_coefficients.subspan(k * numbers, numbers)};
    if (form == Form::rational) view.weights = all_weights.subspan(k * values, values);
    return view;
  }
};

/// The outcome of a batch, in the order of precedence: of several batches the last in this order is reported.
enum class Status : std::uint8_t {
  ok,
  non_finite,  ///< no point was finite
  missing,     ///< a file of answers has none for some input
  refused,     ///< the method does not take one of the curves
  malformed,   ///< its answers cannot be read, or there are too few or too many
  exited,      ///< the process ended before it had answered, or with another code than 0
  threw,       ///< an exception left it
  crashed,     ///< a signal ended the process
  timed_out    ///< it took longer than the limit
};

/// The word for a status in tables.
std::string_view name(Status status);

struct Answer {
  Status status = Status::ok;
  std::vector<double> numbers;  ///< answer by answer; of every input where the status is ok
  std::string detail;           ///< for people: the method's last line on standard error, or how it ended
};

class Method {
 public:
  Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;
  Method(Method&&) = delete;
  Method& operator=(Method&&) = delete;
  virtual ~Method() = default;

  /// The method's record in a bundle.
  [[nodiscard]] virtual const suite::ExternalMethod& record() const = 0;
  /// The answers to a batch. Safe to call from several threads.
  [[nodiscard]] virtual Answer ask(const Batch& batch) const = 0;
  /// The kernel of a method that is code in this process, for times. It may be requested and called only in a child
  /// process, which serves one method. Null where it cannot be loaded, or does not answer in this scalar type.
  [[nodiscard]] virtual const Kernel<double>* open_kernel(int /*dimension*/, double /*zero*/) const { return nullptr; }
  [[nodiscard]] virtual const Kernel<float>* open_kernel(int /*dimension*/, float /*zero*/) const { return nullptr; }
  /// The limits of each of its processes.
  [[nodiscard]] virtual Limits limits() const { return {}; }
};

/// The methods of one run, in the order in which they were given.
using Methods = std::vector<std::shared_ptr<const Method>>;

/// The method with this id; null where there is none.
const Method* find(const Methods& methods, std::string_view id);

/// A method that the user's program has compiled in. Throws Failure(usage) for an id that does not begin with own_. The
/// bound that its info states is not used, because nobody has checked its proof.
std::shared_ptr<const Method> own(const OwnMethod& method, const Limits& limits, bool (*stop)());

/// A shared object with the interface of plugin.h. It is loaded in child processes only, here to read its id, form and
/// degrees. Throws Failure(usage) for a file that is not a plug-in, Failure(input_output) for one that cannot be read.
std::shared_ptr<const Method> plugin(const std::filesystem::path& file, const Limits& limits, bool (*stop)());

/// A command, started once for each batch, which reads inputs from its standard input and writes answers to its
/// standard output; docs/own_method.md describes both. It is started here without inputs to read its id. Throws
/// Failure(usage) for a first line that is not as described there.
std::shared_ptr<const Method> program(const std::string& command, const Limits& limits, bool (*stop)());

/// The columns of the answer, one per axis: x, y, z. Those beyond the dimension of the input stay empty.
inline constexpr std::array<std::string_view, 3> answer_columns{"x", "y", "z"};

/// The default id of a file of answers: answers_ and the letters and digits of its name.
std::string answers_id(std::string_view file_name);

/// The answers of a table with the columns form, dimension, degree, t, coefficients, weights, x, y, z; an input is
/// found by its bits. Throws Failure(input_output) that names file, line and column for a field that cannot be read,
/// and Failure(usage) for an invalid id.
std::shared_ptr<const Method> answers(const bundle::CsvDocument& table, const std::string& id,
                                      const std::string& sha256);

/// The kernel's `prepare` may throw this, where the method does not take the curve.
struct CurveRefused {};

/// A method that has kernels, or solves other problems.
class Code : public Method {
 public:
  Code(const Limits& limits, bool (*stop)()) : limits_(limits), stop_(stop) {}

  [[nodiscard]] const suite::ExternalMethod& record() const final { return record_; }
  /// Each curve is prepared, evaluated and destroyed in turn.
  [[nodiscard]] Answer ask(const Batch& batch) const final;
  [[nodiscard]] Limits limits() const final { return limits_; }

 protected:
  /// The answers to a batch of another problem; called in a child process.
  virtual Status solve(const Batch& /*batch*/, std::vector<double>& /*numbers*/) const { return Status::refused; }

  suite::ExternalMethod record_;
  Limits limits_;
  bool (*stop_)();

 private:
  [[nodiscard]] Status answer(const Batch& batch, std::vector<double>& numbers) const;
};

/// The status of a child that gave no answer.
Answer failed(const Ended& ended);

}  // namespace bezierbench::external
