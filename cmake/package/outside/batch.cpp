// SPDX-License-Identifier: MIT
// Points of the C library, by <bezierbench/batch.hpp>, against those of the headers: exit 0 where they have the same bits.
#include <bezierbench/batch.hpp>
#include <bezierbench/evaluate.hpp>
#include <span>
#include <vector>

namespace {

using namespace bezierbench;

template <class Method, class Scalar>
bool agree() {
  constexpr std::size_t degree = 3;
  constexpr std::size_t curves = 21;
  constexpr std::size_t each = 40;
  std::vector<std::array<Scalar, 2>> points;
  std::vector<Scalar> t;
  for (std::size_t k = 0; k < curves * (degree + 1); ++k)
    points.push_back({Scalar(k * k % 17) / Scalar(7), Scalar(k * k % 23) / Scalar(9)});
  for (std::size_t k = 0; k < curves * each; ++k) t.push_back(Scalar(k * k % 101) / Scalar(100));
  std::vector<std::array<Scalar, 2>> out(t.size());
  evaluate_curves(points, degree, t, out, Method::info.id.data());
  bool same = true;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const auto curve = std::span(points).subspan(k / each * (degree + 1), degree + 1);
    same = same && out[k] == evaluate<Method>(curve, t[k]);
  }
  const auto first = std::span(points).first(degree + 1);
  std::vector<std::array<Scalar, 2>> of_one(t.size());
  evaluate_batch(first, t, of_one);
  for (std::size_t k = 0; k < t.size(); ++k) same = same && of_one[k] == evaluate(first, t[k]);
  return same;
}

template <class Call>
bool refused(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument&) {
    return true;
  }
  return false;
}

}  // namespace

int main() {
  const std::array<std::array<double, 1>, 2> line{{{1}, {2}}};
  const std::array<double, 1> half{0.5};
  std::array<std::array<double, 1>, 1> out{};
  const bool refuses = refused([&] { evaluate_batch(line, half, out, "no_such_method"); }) &&
                       refused([&] { evaluate_curves(line, 2, half, out); });
  evaluate_batch(line, half, out);
  const bool right = out[0][0] == 1.5 && agree<DeCasteljau, double>() && agree<CompensatedDeCasteljau, float>();
  return refuses && right ? 0 : 1;
}
