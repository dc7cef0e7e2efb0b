// SPDX-License-Identifier: MIT
// known_bits WORST.csv HARD_CASES.csv: does the installed package have the committed bits?
//
// WORST.csv is results/baseline/worst.csv: the error of a method at its worst input, to 24 bits, so that a result that
// differs in a bit differs in its error. HARD_CASES.csv is results/hard_cases/hard_cases.csv: correctly rounded values
// that rational arithmetic in Python confirmed. Prints how many agree; exit 1 where one does not.
#include <bezierbench/evaluate.hpp>
#include <bezierbench/exact.hpp>
#include <bezierbench/reference/exact_curve.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace bezierbench;

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);) fields.push_back(field);
  return fields;
}

std::vector<Row> read(const char* path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const auto header = split(line, ',');
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const auto fields = split(line, ',');
    for (std::size_t i = 0; i < fields.size(); ++i) (i == 0 ? rows.emplace_back() : rows.back())[header[i]] = fields[i];
  }
  return rows;
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/// The coefficients of a row, which stand axis by axis.
template <class Scalar, std::size_t Dimension>
std::vector<std::array<Scalar, Dimension>> points_of(const Row& row) {
  const auto numbers = split(row.at("coefficients"), ' ');
  const std::size_t count = numbers.size() / Dimension;
  std::vector<std::array<Scalar, Dimension>> points(count);
  for (std::size_t axis = 0; axis < Dimension; ++axis)
    for (std::size_t i = 0; i < count; ++i) points[i][axis] = static_cast<Scalar>(number(numbers[axis * count + i]));
  return points;
}

int agreed = 0;
int differ = 0;

void compare(bool same, const std::string& what) {
  ++(same ? agreed : differ);
  if (!same) std::cout << "differs: " << what << '\n';
}

template <class Method>
void judge(const Row& row) {
  const auto points = points_of<double, 2>(row);
  const double t = number(row.at("t"));
  std::vector<double> flat;
  for (const auto& point : points) flat.insert(flat.end(), point.begin(), point.end());
  reference::ExactCurve exact;
  const auto& truth = exact.point({Method::info.form, 2, static_cast<int>(points.size()) - 1, flat, {}}, t);
  const auto value = evaluate<Method>(points, t);
  compare(reference::Distance(truth).to(value) == number(row.at("error")), row.at("method") + " " + row.at("worst_id"));
}

template <class... Methods>
void judge_by_id(const Row& row, TypeList<Methods...> /*methods*/) {
  const bool found = ((Methods::info.id == row.at("method") &&
                       Methods::info.form == (row.at("form") == "bernstein" ? Form::bernstein : Form::power) &&
                       (judge<Methods>(row), true)) ||
                      ...);
  compare(found, row.at("method") + " is unknown");
}

template <class Scalar>
void judge_rounded(const Row& row) {
  const auto points = points_of<Scalar, 1>(row);
  const auto t = static_cast<Scalar>(number(row.at("t")));
  const auto expected = static_cast<Scalar>(number(row.at("rounded")));
  const bool power = row.at("form") == "power";
  const auto reference = power ? exact<Form::power>(points, t) : exact(points, t);
  const auto value = power ? evaluate<CorrectlyRoundedPower>(points, t) : evaluate<CorrectlyRounded>(points, t);
  compare(reference[0] == expected, "exact " + row.at("coefficients"));
  compare(value[0] == expected, "correctly_rounded " + row.at("coefficients"));
}

}  // namespace

int main(int /*count*/, char** arguments) {
  using Judged =
      PathsOf<Conversions, TypeList<Direct, DeCasteljau, DeCasteljauLerp, HornerBernstein, PowerSum, Horner>>;
  for (const auto& row : read(arguments[1])) judge_by_id(row, Judged::Type());
  for (const auto& row : read(arguments[2]))
    row.at("scalar") == "double" ? judge_rounded<double>(row) : judge_rounded<float>(row);
  std::cout << agreed << " agree, " << differ << " differ\n";
  return differ == 0 && agreed > 0 ? 0 : 1;
}
