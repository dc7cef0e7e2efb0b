// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <vector>

#include "reference/curves/read.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::curves {
namespace {

using nlohmann::json;

constexpr std::string_view no_points = "is not an array of points; write [[x,y],...], or an array of these";

bool has_points(const json& value) {
  return value.is_array() && !value.empty() && value.front().is_array() && !value.front().empty() &&
         value.front().front().is_number();
}

/// Takes curves out of the tree as soon as the parser has them, so that only one of them is in memory.
class Reader {
 public:
  Reader(std::string_view text, const std::string& name, Form form) : source_{text, name}, form_(form) {}

  Read read() {
    try {
      const auto rest =
          json::parse(source_.text.begin(), source_.text.end(),
                      [this](int depth, json::parse_event_t event, json& value) { return keeps(depth, event, value); });
      // What was taken out leaves null.
      if (!rest.is_null() || read_.set.empty()) refuse(no_points);
    } catch (const json::parse_error& error) {
      source_.refuse(error.byte > 0 ? error.byte - 1 : 0, "is not JSON from here; restore the file");
    } catch (const json::out_of_range&) {
      refuse("a number is too large for a double; scale all coordinates down");
    }
    return std::move(read_);
  }

 private:
  [[noreturn]] void refuse(std::string_view what) const {
    throw Unreadable(fmt::format("{}: curve {}: {}", source_.name, read_.set.size(), what));
  }

  /// False for what need not stay in the tree.
  bool keeps(int depth, json::parse_event_t event, json& value) {
    using Event = json::parse_event_t;
    if (depth > most_nesting) refuse(fmt::format("nested more than {} deep; write [[x,y],...]", most_nesting));
    const bool is_empty = event == Event::array_end && last_event_ == Event::array_start;
    last_event_ = event;
    if (is_empty) refuse("an array without points; write [[x,y],...]");
    if (event == Event::object_start) ++objects_;
    if (event == Event::object_end) --objects_;
    if (++pending_ > most_pending)
      refuse(fmt::format("too long; the largest degree is {}, and a point has 1 to 3 coordinates", max_degree));
    if (objects_ > 0) return true;
    const bool is_curve = event == Event::array_end && has_points(value);
    if (is_curve) add(value, nullptr);
    if (event == Event::object_end) add(points_of(value), &value);
    if (event == Event::array_end && !is_curve && !is_point(value)) require_no_scalars(value);
    const bool taken = is_curve || event == Event::object_end || (event == Event::array_end && !is_point(value));
    if (taken) pending_ = 0;
    return !taken;
  }

  static bool is_point(const json& value) { return value.is_array() && !value.empty() && value.front().is_number(); }

  /// What remains after the curves were taken out.
  void require_no_scalars(const json& value) const {
    if (!value.is_array() || std::ranges::any_of(value, [](const json& one) { return !one.is_discarded(); }))
      refuse(no_points);
  }

  const json& points_of(const json& object) const {
    const auto points = object.find("points");
    if (points == object.end() || !has_points(*points))
      refuse("an object without points; write {\"points\": [[x,y],...]}");
    return *points;
  }

  void require_numbers(const json& values, std::size_t count, std::string_view what) const {
    if (!values.is_array() || values.size() != count || !std::ranges::all_of(values, &json::is_number))
      refuse(fmt::format("{} must be {} number{}", what, count, count == 1 ? "" : "s"));
  }

  void add(const json& points, const json* object) {
    if (points.size() > static_cast<std::size_t>(max_degree) + 1)
      refuse(fmt::format("{} coefficients; the largest degree is {}", points.size(), max_degree));
    const auto dimension = points.front().size();
    if (dimension > 3) refuse(fmt::format("a point has {} coordinates; write 1 to 3", dimension));
    std::vector<double> numbers;
    std::vector<double> weights;
    for (std::size_t k = 0; k < points.size(); ++k) {
      require_numbers(points[k], dimension, fmt::format("point {}", k));
      for (const auto& coordinate : points[k]) numbers.push_back(coordinate.get<double>());
    }
    Form form = form_;
    std::string id = std::to_string(read_.set.size());
    while (ids_.contains(id)) id += '\'';  // another curve may be given a number as its id
    if (object != nullptr) {
      if (const auto given = object->find("weights"); given != object->end()) {
        require_numbers(*given, points.size(), "weights");
        weights = given->get<std::vector<double>>();
        if (std::ranges::all_of(weights, [](double w) { return w == 0; })) refuse("every weight is 0; one must not be");
      }
      form = form_of(*object, weights.empty() ? form : Form::rational);
      if ((form == Form::rational) == weights.empty()) refuse("the rational form has weights, and no other form has");
      id = id_of(*object, std::move(id));
    }
    if (!ids_.insert(id).second) refuse(fmt::format("the id \"{}\" occurs above; write another", echo(id)));
    require_room(read_.set, source_.name);
    const CurveView<double> curve{form, static_cast<int>(dimension), static_cast<int>(points.size()) - 1, numbers,
                                  weights};
    read_.set.add(id, curve, !read_.set.continues_path(id, curve));
  }

  Form form_of(const json& object, Form otherwise) const {
    const auto given = object.find("form");
    if (given == object.end()) return otherwise;
    for (const Form form : {Form::bernstein, Form::power, Form::rational})
      if (*given == std::string(name(form))) return form;
    refuse("form must be \"bernstein\", \"power\" or \"rational\"");
  }

  std::string id_of(const json& object, std::string otherwise) const {
    const auto given = object.find("id");
    if (given == object.end()) return otherwise;
    auto id = given->is_string() ? given->get<std::string>() : given->dump();
    if (first_unprintable(id) != std::string_view::npos) refuse("the id has characters that are not text");
    return id;
  }

  // Values and the beginnings and ends of arrays: of the points of an object with weights, and of a few other keys.
  static constexpr std::size_t most_pending = std::size_t{16} * (max_degree + 1);

  Source source_;
  Form form_;
  Read read_;
  std::unordered_set<std::string> ids_;
  std::size_t pending_ = 0;
  int objects_ = 0;
  json::parse_event_t last_event_ = json::parse_event_t::value;
};

}  // namespace

Read read_json(std::string_view text, const std::string& name, Form form) { return Reader(text, name, form).read(); }

}  // namespace bezierbench::curves
