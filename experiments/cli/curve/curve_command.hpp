// SPDX-License-Identifier: MIT
// What the `curve` commands share: their options, the choice of methods, the truth that may take long, and the table that
// they print, of one curve or of every curve of a file.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/method.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/command.hpp"
#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/pattern.hpp"
#include "reference/exact_point.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {

/// A subcommand of `curve`. `add` adds its options and its action.
struct CurveCommand {
  const char* name;
  const char* help;
  void (*add)(Command command);
};

/// The options that name a curve.
struct CurveOptions {
  std::string file;
  std::string form = "bernstein";

  void add_to(Command command);
  [[nodiscard]] std::vector<CurveFile> read() const {
    return read_curves(file, form == "bernstein" ? Form::bernstein : Form::power);
  }
};

void add_method_option(Command command, Problem problem, std::vector<std::string>& methods);

/// The finite number in the text of an option. Throws Failure(usage) that names the option.
double finite_option(const std::string& option, const std::string& text);
std::vector<double> finite_options(const std::string& option, const std::vector<std::string>& texts);

/// The finite numbers, separated by commas, in the text of an option. Throws likewise.
std::vector<double> finite_numbers(const std::string& option, const std::string& text);

/// The same for one number per axis. Throws likewise for another count; `owner` is what has the axes, with its verb.
std::vector<double> finite_coordinates(const std::string& option, const std::string& text, int dimension,
                                       const std::string& owner);

/// The tolerance in the text of --tolerance, relative to a length. Throws likewise unless it is above 0.
double relative_tolerance(const std::string& text);

// Methods that --method names

/// Whether the method takes a curve of this form and degree.
bool applies(const MethodInfo& info, const CurveFile& curve);

/// Why the method does not take the curve, for messages.
std::string why_not(const MethodInfo& info, const CurveFile& curve);

/// Throws Failure(usage) for a curve called `name` that no method takes. `any` is one of the problem's methods.
[[noreturn]] void refuse_curve(const std::string& name, const CurveFile& curve, const MethodInfo& any);

/// Throws Failure(usage) for a method `id` of the problem that does not exist or is not in this build.
[[noreturn]] void unknown_method(const std::string& id, Problem problem);

/// The entries of a table that `ids` name, in the order of the names; without names all that apply, in the order of the
/// roster. Throws Failure(usage) for a method that does not exist or does not take the curve.
template <class Kernel>
std::vector<const Kernel*> chosen(std::span<const Kernel> table, const std::vector<std::string>& ids,
                                  const CurveFile& curve, Problem problem) {
  std::vector<const Kernel*> result;
  for (const auto& id : ids) {
    const Kernel* candidate = nullptr;
    for (const auto& entry : table)  // several forms may have an entry of this id
      if (entry.info->id == id && (candidate == nullptr || applies(*entry.info, curve))) candidate = &entry;
    if (candidate == nullptr) unknown_method(id, problem);
    if (!applies(*candidate->info, curve))
      throw Failure(Exit::usage, fmt::format("--method {}: {}", id, why_not(*candidate->info, curve)));
    result.push_back(candidate);
  }
  if (!ids.empty()) return result;
  for (const auto& entry : table)
    if (applies(*entry.info, curve) && !suite::is_peer(entry.info->id)) result.push_back(&entry);
  return result;
}

/// The entry of a table for the method `id`. Throws Failure(usage) where there is none.
template <class Kernel>
const Kernel& chosen_one(std::span<const Kernel> table, const std::string& id, Problem problem) {
  for (const auto& entry : table)
    if (entry.info->id == id) return entry;
  unknown_method(id, problem);
}

/// The option --truth of the commands whose truth takes long at high degrees. Answers do not wait for it.
class TruthOption {
 public:
  void add_to(Command command);

  /// Computes the truth of the curve called `name`, of this degree. Returns false where it was stopped: above degree 20
  /// without --truth it has a second, and a line on standard error says what to do. With --truth a line says that it
  /// takes longer than some seconds.
  [[nodiscard]] bool finishes(const std::string& name, int degree, const std::function<void()>& compute) const;

 private:
  bool wanted_ = false;
};

// Tables

/// The columns of a table of judged coordinates: `first`, then axis,value,exact,error,error_ulp,error_u,bound_u.
std::vector<std::string> judged_columns(std::vector<std::string> first);

/// The fields of value,exact,error,error_ulp,error_u,bound_u. Errors are infinite where `value` is not finite; error_u is
/// infinite where p~ is 0 and the error is not. bound_u is empty where no bound is proved or p~ is 0.
std::vector<std::string> judged_coordinate(double value, const reference::Rational& truth,
                                           const reference::Rational& p_tilde, std::optional<double> bound);

/// A table whose rows begin with the id of their curve if there are several.
class CurveTable {
 public:
  CurveTable(bool several, std::vector<std::string> columns)
      : several_(several), table_(begun_with("curve", std::move(columns))) {}

  /// Rows that are added from now on are those of the curve `id`.
  void begin(const std::string& id) { id_ = id; }
  void add_row(std::vector<std::string> fields) { table_.add_row(begun_with(id_, std::move(fields))); }

  /// Adds a row of judged_columns() for each axis of a point. `first` are the fields before that of the axis; `bound` of
  /// an axis is in coordinate units, empty where none is proved.
  void add_point(const std::vector<std::string>& first, std::span<const double> point,
                 const reference::ExactPoint& truth, const reference::ExactPoint& p_tilde,
                 const std::function<std::optional<double>(int axis)>& bound);

  void print() const { fmt::print("{}", table_.text()); }

 private:
  [[nodiscard]] std::vector<std::string> begun_with(const std::string& first, std::vector<std::string> fields) const {
    if (several_) fields.insert(fields.begin(), first);
    return fields;
  }

  bool several_;
  std::string id_;
  bundle::CsvTable table_;
};

/// A curve, and the methods that a command asks about it.
template <class Kernel>
struct CurveCase {
  const CurveFile& curve;
  std::string name;  ///< for messages: the file, with the curve's id where it has several
  std::vector<const Kernel*> methods;
  bool named;  ///< by --method; otherwise they are all that apply
};

/// The command that adds rows for every curve of a file. `Task` has `problem`, `columns()` and `kernels(dimension)`, holds
/// the values of its own options, and may have the option `truth`.
template <class Task>
void add_curve_command(Command command) {
  struct Options {
    CurveOptions curve;
    Task task;
    std::vector<std::string> methods;
  };
  const auto options = std::make_shared<Options>();
  options->curve.add_to(command);
  options->task.add_to(command);
  add_method_option(command, Task::problem, options->methods);
  if constexpr (requires(Task task) { task.truth; }) options->task.truth.add_to(command);
  command.action([options] {
    const auto curves = options->curve.read();
    CurveTable table(curves.size() > 1, Task::columns());
    for (const auto& curve : curves) {
      const auto name =
          curves.size() > 1 ? fmt::format("{}#{}", options->curve.file, echo(curve.id)) : options->curve.file;
      const auto kernels = Task::kernels(curve.dimension);
      auto methods = chosen(kernels, options->methods, curve, Task::problem);
      if (methods.empty()) refuse_curve(name, curve, *kernels.front().info);
      table.begin(curve.id);
      options->task.add_rows({curve, name, std::move(methods), !options->methods.empty()}, table);
    }
    table.print();
  });
}

}  // namespace bezierbench::cli
