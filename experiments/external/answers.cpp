// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <filesystem>
#include <unordered_map>

#include "experiments/external/method.hpp"
#include "experiments/failure.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::external {
namespace {

/// All bits of an input, coefficients point by point, as the key of its answer.
std::string key_of(Form form, int dimension, int degree, double t, std::span<const double> coefficients,
                   std::span<const double> weights) {
  std::string key{static_cast<char>(form), static_cast<char>(dimension)};
  const auto add = [&](std::uint64_t bits) { key.append(reinterpret_cast<const char*>(&bits), sizeof bits); };
  add(static_cast<std::uint64_t>(degree));
  add(std::bit_cast<std::uint64_t>(t));
  for (const auto values : {coefficients, weights})
    for (const double value : values) add(std::bit_cast<std::uint64_t>(value));
  return key;
}

/// One row of the file, with messages about its fields.
class AnswerRow {
 public:
  AnswerRow(const bundle::CsvDocument& table, std::size_t row) : table_(table), row_(row) {}

  [[nodiscard]] const std::string& text(std::string_view column) const { return table_.at(row_, column); }
  [[nodiscard]] double number(std::string_view column) const { return number_in(column, text(column)); }
  [[nodiscard]] int count(std::string_view column, int min, int max) const {
    const auto value = number::parse_integer(text(column));
    if (!value || *value < min || *value > max) malformed(column, fmt::format("is not from {} to {}", min, max));
    return static_cast<int>(*value);
  }
  [[nodiscard]] Form form() const {
    const auto form = suite::parse<Form>(text("form"));
    if (!form) malformed("form", "is not the form of a curve");
    return *form;
  }
  [[nodiscard]] std::vector<double> numbers(std::string_view column, std::size_t count) const {
    std::vector<double> values;
    std::string_view rest = text(column);
    while (!rest.empty()) {
      const auto end = std::min(rest.find(' '), rest.size());
      values.push_back(number_in(column, rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (values.size() != count) malformed(column, fmt::format("has {} numbers, not {}", values.size(), count));
    return values;
  }
  /// The answer; empty where one of its fields is empty.
  [[nodiscard]] std::vector<double> answer(int dimension) const {
    std::vector<double> point;
    for (const auto column : std::span(answer_columns).first(static_cast<std::size_t>(dimension))) {
      if (text(column).empty()) return {};
      point.push_back(number(column));
    }
    return point;
  }

 private:
  [[noreturn]] void malformed(std::string_view column, std::string_view what) const {
    throw Failure(Exit::input_output,
                  "{}:{}: {} {}; leave the columns of `bezierbench inputs` as they are and add the answers",
                  table_.file_name(), table_.line(row_), column, what);
  }
  [[nodiscard]] double number_in(std::string_view column, std::string_view word) const {
    const auto value = number::parse_number(word);
    if (!value) malformed(column, fmt::format("has \"{}\", which is not a number", echo(word)));
    return *value;
  }

  const bundle::CsvDocument& table_;
  std::size_t row_;
};

class Answers final : public Method {
 public:
  Answers(const bundle::CsvDocument& table, const std::string& id, const std::string& sha256) {
    record_.id = id;
    record_.kind = suite::ExternalKind::answers;
    record_.source = std::filesystem::path(table.file_name()).filename().string();
    record_.sha256 = sha256;
    if (const auto what = suite::external_id_problem(id, record_.kind); !what.empty())
      throw Failure(Exit::usage, what + "; choose another with --id");
    for (std::size_t row = 0; row < table.row_count(); ++row) add(AnswerRow(table, row));
  }

  [[nodiscard]] const suite::ExternalMethod& record() const override { return record_; }

  [[nodiscard]] Answer ask(const Batch& batch) const override {
    Answer answer;
    std::size_t missing = 0;
    for (std::size_t k = 0; k < batch.count(); ++k) {
      const auto curve = batch.curve(k);
      const auto found = points_.find(
          key_of(batch.form, batch.dimension, batch.degree, batch.inputs[k], curve.coefficients, curve.weights));
      if (found == points_.end() || found->second.empty())
        ++missing;
      else
        answer.numbers.insert(answer.numbers.end(), found->second.begin(), found->second.end());
    }
    if (missing > 0)
      return {Status::missing, {}, fmt::format("{} of {} inputs have no answer", missing, batch.count())};
    return answer;
  }

 private:
  void add(const AnswerRow& row) {
    const Form form = row.form();
    const int dimension = row.count("dimension", 1, 3);
    const int degree = row.count("degree", 0, max_degree);
    const auto count = static_cast<std::size_t>(degree) + 1;
    const auto d = static_cast<std::size_t>(dimension);
    const auto axis_by_axis = row.numbers("coefficients", count * d);
    std::vector<double> coefficients(count * d);
    for (std::size_t axis = 0; axis < d; ++axis)
      for (std::size_t i = 0; i < count; ++i) coefficients[i * d + axis] = axis_by_axis[axis * count + i];
    const auto weights = row.numbers("weights", form == Form::rational ? count : 0);
    points_.insert_or_assign(key_of(form, dimension, degree, row.number("t"), coefficients, weights),
                             row.answer(dimension));
  }

  suite::ExternalMethod record_;
  std::unordered_map<std::string, std::vector<double>> points_;
};

}  // namespace

std::string answers_id(std::string_view file_name) {
  std::string id = "answers_";
  for (const char c : std::filesystem::path(file_name).stem().string())
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return id;
}

std::shared_ptr<const Method> answers(const bundle::CsvDocument& table, const std::string& id,
                                      const std::string& sha256) {
  return std::make_shared<Answers>(table, id, sha256);
}

}  // namespace bezierbench::external
