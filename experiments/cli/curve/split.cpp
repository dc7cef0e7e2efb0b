// SPDX-License-Identifier: MIT
// `curve split`: the control points of both halves of one curve by any method, against the exact ones.
#include <deque>
#include <optional>

#include "experiments/cli/curve/curve_command.hpp"
#include "experiments/studies/subdivision/split_truth.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using studies::Side;

struct Split {
  static constexpr Problem problem = Problem::subdivision;
  static constexpr const char* control_points_help =
      "print the control points that the first method computes, as a set of curves";
  static std::vector<std::string> columns() {
    auto columns = judged_columns({"method", "half", "index"});
    std::erase(columns, "error_ulp");
    return columns;
  }
  static auto kernels(int dimension) { return split_kernels(dimension); }

  void add_to(Command command) {
    command.option("--t", t, "parameter at which the curve is split; may be repeated").required().takes("T");
    command.option("--segment", segment_text, "with --whole-path: number of the segment, from 0").takes("N");
  }
  static std::vector<std::string> path_columns(int /*dimension*/) {
    auto columns = Split::columns();
    columns.insert(columns.begin() + 1, "segment");
    return columns;
  }
  void prepare(bool whole_path);
  [[nodiscard]] std::size_t questions() const { return t.size(); }
  void add_rows(const CurveCase<SplitKernel>& one, CurveTable& table) const { add_halves(one, table); }
  void add_path_rows(std::span<const CurveCase<SplitKernel>> segments, CurveTable& table) const {
    add_halves(segments[chosen_segment(segments)], table);
  }
  /// Adds the curves before and after t: of a path its segments, with the halves of the one that is split.
  void add_to_set(std::span<const CurveCase<SplitKernel>> segments, const std::string& id, curves::CurveSet& set) const;

  std::vector<std::string> t;
  std::optional<std::string> segment_text;
  bool control_points = false;

 private:
  void add_halves(const CurveCase<SplitKernel>& one, CurveTable& table) const;
  [[nodiscard]] std::size_t chosen_segment(std::span<const CurveCase<SplitKernel>> segments) const;

  bool whole_path_ = false;
};

/// The truth of one axis alone, so that bounds are those of a single coordinate.
struct Axis {
  Axis(CurveFile alone, double t) : curve(std::move(alone)), truth(curve.view(), t) {}

  CurveFile curve;
  studies::SplitTruth truth;
};

/// The exact halves at one t.
struct SplitTarget {
  SplitTarget(const CurveCase<SplitKernel>& one, const std::string& text)
      : t(finite_option("--t", text)),
        exact(reference::exact_split(one.curve.view(), t)),
        p_tilde(reference::split_p_tilde(one.curve.view(), t)) {
    for (int axis = 0; axis < one.curve.dimension; ++axis) axes.emplace_back(one.curve.along(axis), t);
    for (const auto* half : {&exact.left, &exact.right})
      for (const auto& point : half->points)
        if (!point.exists())
          throw Failure(Exit::usage,
                        "--t {}: a control point of a half would have the weight zero, so {} cannot be split there; "
                        "see column w or choose another t",
                        text, one.name);
  }

  double t;
  reference::ExactHalves exact;
  reference::ExactHalves p_tilde;
  std::deque<Axis> axes;
};

void add_half(const SplitKernel& method, const SplitTarget& target, const studies::ComputedHalves& computed, Side side,
              const CurveView<double>& curve, std::size_t question, const std::optional<std::string>& segment,
              CurveTable& table) {
  const bool left = side == Side::left;
  const auto& true_half = left ? target.exact.left : target.exact.right;
  const auto& p_tilde_half = left ? target.p_tilde.left : target.p_tilde.right;
  for (int i = 0; i <= curve.degree; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto control = computed.control(side, i);
    const auto add = [&](const std::string& axis, std::vector<std::string> judged) {
      std::vector<std::string> row{std::string(method.info->id), left ? "left" : "right", std::to_string(i), axis};
      if (segment) row.insert(row.begin() + 1, *segment);
      judged.erase(judged.begin() + 3);  // the field error_ulp
      row.insert(row.end(), judged.begin(), judged.end());
      table.add_row(std::move(row), question);
    };
    for (int axis = 0; axis < curve.dimension; ++axis) {
      const auto value = control.subspan(static_cast<std::size_t>(axis), 1);
      const auto& truth = target.axes[static_cast<std::size_t>(axis)].truth;
      add(axis_name(axis),
          judged_coordinate(value[0], true_half.points[k].coordinate(axis), p_tilde_half.points[k].coordinate(axis),
                            truth.point_error(method.bound, side, i, value).bound));
    }
    if (curve.form == Form::rational)
      add("w", judged_coordinate(control.back(), true_half.weights[k], p_tilde_half.weights[k],
                                 target.axes[0].truth.weight_error(method.bound, side, i, control.back()).bound));
  }
}

void Split::prepare(bool whole_path) {
  whole_path_ = whole_path;
  if (whole_path != segment_text.has_value())
    throw Failure(Exit::usage, "--segment: goes with --whole-path; give both, or write FILE#ID for a curve alone");
  if (control_points && t.size() > 1) throw Failure(Exit::usage, "--control-points: takes one --t; give one");
}

std::size_t Split::chosen_segment(std::span<const CurveCase<SplitKernel>> segments) const {
  if (!whole_path_) return 0;
  const auto number = number::parse_integer(*segment_text);
  if (!number || *number < 0 || static_cast<std::size_t>(*number) >= segments.size())
    throw Failure(Exit::usage, "--segment {}: {} has segments 0 to {}; write one of them", echo(*segment_text),
                  segments.front().name, segments.size() - 1);
  return static_cast<std::size_t>(*number);
}

void Split::add_to_set(std::span<const CurveCase<SplitKernel>> segments, const std::string& id,
                       curves::CurveSet& set) const {
  const auto chosen = chosen_segment(segments);
  const auto& one = segments[chosen];
  const SplitTarget target(one, t.front());
  std::vector<double> numbers;
  studies::compute_halves(*one.methods.front(), one.curve.view(), target.t, numbers);
  const studies::ComputedHalves computed(one.curve.view(), std::move(numbers));
  if (!computed.all_finite())
    throw Failure(Exit::input_output,
                  "{}: a control point of a half is beyond the largest double; scale the coordinates down", one.name);
  const auto prefix = id.empty() ? "" : id + ":";
  std::size_t count = 0;
  const auto add = [&](const char* half, const CurveView<double>& curve) {
    set.add(whole_path_ ? fmt::format("{}{}:{}", prefix, half, count) : prefix + half, curve, count == 0);
    ++count;
  };
  for (std::size_t s = 0; s < chosen; ++s) add("left", segments[s].curve.view());
  add("left", computed.curve(Side::left));
  count = 0;
  add("right", computed.curve(Side::right));
  for (std::size_t s = chosen + 1; s < segments.size(); ++s) add("right", segments[s].curve.view());
}

void Split::add_halves(const CurveCase<SplitKernel>& one, CurveTable& table) const {
  const auto curve = one.curve.view();
  std::deque<SplitTarget> targets;
  for (const auto& text : t) targets.emplace_back(one, text);
  for (const auto* method : one.methods)
    for (std::size_t question = 0; question < targets.size(); ++question) {
      std::vector<double> numbers;
      studies::compute_halves(*method, curve, targets[question].t, numbers);
      const studies::ComputedHalves computed(curve, std::move(numbers));
      for (const Side side : studies::sides)
        add_half(*method, targets[question], computed, side, curve, question, segment_text, table);
    }
}

}  // namespace

extern constexpr CurveCommand curve_split{"split", "split a curve into two halves", add_curve_command<Split>};

}  // namespace bezierbench::cli
