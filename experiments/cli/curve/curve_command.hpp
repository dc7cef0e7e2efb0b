// SPDX-License-Identifier: MIT
// What the `curve` commands share: their options, the choice of methods, the truth that may take long, and the table
// that they print, of one curve or of every curve of a file.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/method.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/command.hpp"
#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/tables/table_row.hpp"
#include "reference/exact_point.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {

/// A subcommand of `curve`. `add` adds its options and its action.
struct CurveCommand {
  const char* name;
  const char* help;
  void (*add)(Command command);
};

/// The options that name curves: a file, or path data.
struct CurveOptions {
  std::optional<std::string> file;
  std::optional<std::string> path;
  std::string form = "bernstein";

  void add_to(Command command);
  /// Throws Failure(usage) unless one of the two is given, and as read_curves() and path_curves() do.
  [[nodiscard]] std::vector<CurveFile> read() const;
  /// What messages call the curves.
  [[nodiscard]] std::string name() const { return file.value_or("--path"); }
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

/// Throws Failure(usage) for the point of a rational curve called `name` at t where there is none.
void require_point(const reference::ExactPoint& point, double t, const std::string& name);

/// Throws Failure(usage) for a rational curve called `name` with a pole in [from, to].
void refuse_pole(const CurveView<double>& curve, double from, double to, const std::string& name);

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
      throw Failure(Exit::usage, "--method {}: {}", id, why_not(*candidate->info, curve));
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

/// The fields of value,exact,error,error_ulp,error_u,bound_u. Errors are infinite where `value` is not finite; error_u
/// is infinite where p~ is 0 and the error is not. bound_u is empty where no bound is proved or p~ is 0.
std::vector<std::string> judged_coordinate(double value, const reference::Rational& truth,
                                           const reference::Rational& p_tilde, std::optional<double> bound);

/// A table whose rows begin with the id of their curve if there are several, and then with the number of the question,
/// from 0, if there are several for each curve.
class CurveTable {
 public:
  CurveTable(bool several_curves, bool several_questions, std::vector<std::string> columns)
      : several_curves_(several_curves),
        several_questions_(several_questions),
        table_(begun_with("curve", "question", std::move(columns))) {}

  /// Rows that are added from now on are those of the curve `id`.
  void begin(const std::string& id) { id_ = id; }
  /// A row that answers question number `question`; `last` are fields at its end.
  void add_row(std::vector<std::string> fields, std::size_t question = 0, const std::vector<std::string>& last = {}) {
    fields.insert(fields.end(), last.begin(), last.end());
    table_.add_row(begun_with(id_, std::to_string(question), std::move(fields)));
  }

  /// Adds a row of judged_columns() for each axis of a point. `first` are the fields before that of the axis; `bound`
  /// of an axis is in coordinate units, empty where none is proved.
  void add_point(const std::vector<std::string>& first, std::span<const double> point,
                 const reference::ExactPoint& truth, const reference::ExactPoint& p_tilde,
                 const std::function<std::optional<double>(int axis)>& bound);

  void print() const { fmt::print("{}", table_.text()); }

 private:
  [[nodiscard]] std::vector<std::string> begun_with(const std::string& id, const std::string& question,
                                                    std::vector<std::string> fields) const {
    if (several_questions_) fields.insert(fields.begin(), question);
    if (several_curves_) fields.insert(fields.begin(), id);
    return fields;
  }

  bool several_curves_;
  bool several_questions_;
  std::string id_;
  bundle::CsvTable table_;
};

/// A curve, and the methods that a command asks about it.
template <class Kernel>
struct CurveCase {
  const CurveFile& curve;
  std::string name;  ///< for messages: the file, with the curve's id where it has several
  std::vector<const Kernel*> methods;
  bool named;     ///< by --method; otherwise they are all that apply
  int dimension;  ///< of the table: the largest of all curves
};

/// The fields of a point in tables of several dimensions: its coordinates, then empty fields.
std::vector<std::string> point_fields(std::span<const double> point, int dimension);

/// The fields of the point of a curve at t, each coordinate the nearest number; empty where t or the point is not
/// finite.
std::vector<std::string> point_fields_at(const CurveView<double>& curve, double t, int dimension);

/// The largest dimension of the curves.
int largest_dimension(std::span<const CurveFile> curves);

/// Says on standard error how many curves of a file were left out, since no method takes them, and why the first one
/// was.
void say_left_out(const std::string& name, std::size_t count, std::size_t all, std::string_view why);

/// `columns`, then those of the axes.
std::vector<std::string> with_axes(std::vector<std::string> columns, int dimension);

/// The segments of each path.
std::vector<std::span<const CurveFile>> paths_of(std::span<const CurveFile> curves);

/// The part of the id of a segment that names its path: logo:0 of logo:0:3; the id itself where it has no such part.
std::string path_id(const std::string& id);

/// The methods that --method names, or else all that apply, of every curve; of a path those that take all its segments,
/// in the same order for each. Throws Failure(usage) where there is none.
template <class Task>
auto cases_of(std::span<const CurveFile> curves, const std::string& name, const std::vector<std::string>& ids,
              int dimension) {
  using Kernel = std::remove_cvref_t<decltype(Task::kernels(1).front())>;
  std::vector<CurveCase<Kernel>> cases;
  for (const auto& curve : curves) {
    const auto kernels = Task::kernels(curve.dimension);
    cases.push_back({curve, name, chosen(kernels, ids, curve, Task::problem), !ids.empty(), dimension});
  }
  const auto has = [](const auto& one, std::string_view id) {
    return std::ranges::find(one.methods, id, [](const Kernel* method) { return method->info->id; }) !=
           one.methods.end();
  };
  for (auto& one : cases)
    std::erase_if(one.methods, [&](const Kernel* method) {
      return !std::ranges::all_of(cases, [&](const auto& other) { return has(other, method->info->id); });
    });
  if (cases.front().methods.empty()) refuse_curve(name, cases.front().curve, *Task::kernels(1).front().info);
  return cases;
}

/// The command that adds rows for every curve of a file. `Task` has `problem`, `columns()` or `columns(dimension)`, and
/// `kernels(dimension)`, and holds the values of its own options. It may have `prepare(whole_path)`, which checks them,
/// `questions()`, how many there are for each curve, the option `truth`, `path_columns(dimension)` with
/// `add_path_rows()`, which answers for a whole path, and the flag `control_points` with `control_points_help` and
/// `add_to_set()`, which adds curves in place of rows. Curves that no method takes are left out, unless they are all.
template <class Task>
void add_curve_command(Command command) {
  struct Options {
    CurveOptions curve;
    Task task;
    std::vector<std::string> methods;
    bool whole_path = false;
  };
  constexpr bool has_paths = requires { Task::path_columns(1); };
  constexpr bool has_set = requires(Task task) { task.control_points; };
  const auto options = std::make_shared<Options>();
  options->curve.add_to(command);
  options->task.add_to(command);
  add_method_option(command, Task::problem, options->methods);
  if constexpr (requires(Task task) { task.truth; }) options->task.truth.add_to(command);
  if constexpr (has_set) command.flag("--control-points", options->task.control_points, Task::control_points_help);
  if constexpr (has_paths)
    command.flag("--whole-path", options->whole_path, "take segments that are joined as one path");
  command.action([options] {
    auto& task = options->task;
    if constexpr (requires { task.prepare(options->whole_path); }) task.prepare(options->whole_path);
    const auto curves = options->curve.read();
    const auto dimension = largest_dimension(curves);
    std::vector<std::span<const CurveFile>> parts;
    if (options->whole_path)
      parts = paths_of(curves);
    else
      for (const auto& curve : curves) parts.emplace_back(&curve, 1);
    std::vector<std::string> columns;
    if constexpr (has_paths)
      if (options->whole_path) columns = Task::path_columns(dimension);
    if constexpr (requires { Task::columns(1); }) {
      if (!options->whole_path) columns = Task::columns(dimension);
    } else {
      if (!options->whole_path) columns = Task::columns();
    }
    bool several_questions = false;
    if constexpr (requires { task.questions(); }) several_questions = task.questions() > 1;
    CurveTable table(parts.size() > 1, several_questions, columns);
    curves::CurveSet set;
    std::size_t left_out = 0;
    std::optional<Failure> first_refusal;
    for (const auto part : parts) {
      const auto id = options->whole_path ? path_id(part.front().id) : part.front().id;
      const auto name =
          parts.size() > 1 ? fmt::format("{}#{}", options->curve.name(), echo(id)) : options->curve.name();
      decltype(cases_of<Task>(part, name, options->methods, dimension)) cases;
      try {
        cases = cases_of<Task>(part, name, options->methods, dimension);
      } catch (const Failure& failure) {
        if (left_out++ == 0) first_refusal = failure;
        continue;
      }
      if constexpr (has_set)
        if (task.control_points) {
          task.add_to_set(cases, parts.size() > 1 ? id : "", set);
          continue;
        }
      table.begin(id);
      if constexpr (has_paths)
        if (options->whole_path) task.add_path_rows(cases, table);
      if (!options->whole_path) task.add_rows(cases.front(), table);
    }
    if (left_out == parts.size()) throw Failure(*first_refusal);
    if (set.empty())
      table.print();
    else
      fmt::print("{}", curves::to_csv(set, number::decimal));
    if (left_out > 0) say_left_out(options->curve.name(), left_out, parts.size(), first_refusal->what());
  });
}

}  // namespace bezierbench::cli
