// SPDX-License-Identifier: MIT
// The C library by its headers for C++: points have the bits of those of the methods' headers; parts, degrees and roots are those of
// curves whose answers are known. Exit 0 where all is right.
#include <bezierbench/batch.hpp>
#include <bezierbench/evaluate.hpp>
#include <bezierbench/roots_and_parts.hpp>
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

bool batches_are_right() {
  const std::array<std::array<double, 1>, 2> line{{{1}, {2}}};
  const std::array<double, 1> half{0.5};
  std::array<std::array<double, 1>, 1> out{};
  const bool refuses = refused([&] { evaluate_batch(line, half, out, "no_such_method"); }) &&
                       refused([&] { evaluate_curves(line, 2, half, out); });
  evaluate_batch(line, half, out);
  const bool right = out[0][0] == 1.5 && agree<DeCasteljau, double>() && agree<CompensatedDeCasteljau, float>();
  return refuses && right;
}

using Plane = std::vector<std::array<double, 2>>;

bool roots_and_parts_are_right() {
  const Plane arch{{0, 0}, {1, 2}, {2, 0}};  // y = x (2 - x)
  bool right = part(arch, 0.5, 1).points == Plane{{1, 1}, {1.5, 1}, {2, 0}};
  right = right && part(arch, 1, 0).points == Plane{{2, 0}, {1, 2}, {0, 0}};
  right = right && elevate(arch, 2).points == arch && elevate(arch, 3).points.size() == 4;
  const Plane circle{{1, 0}, {1, 1}, {0, 1}};  // (1 - t^2, 2t) / (1 + t^2)
  const std::vector<double> weights{1, 1, 2};
  const auto half = part(circle, 0, 0.5, weights);
  right =
      right && half.points == Plane{{1, 0}, {1, 0.5}, {0.6, 0.8}} && half.weights == std::vector<double>{1, 1, 1.25};
  const auto top = extrema(arch, 1);
  right = right && top.size() == 1 && top[0].t == 0.5 && top[0].multiplicity == 1;
  const auto touching = roots(arch, 1, 1);
  right = right && touching.size() == 1 && touching[0].t == 0.5 && touching[0].multiplicity == 2;
  right = right && roots(circle, 0, 0.6, weights).size() == 1;
  right = right && inflections(Plane{{0, 0}, {1, 1}, {2, -1}, {3, 0}}).size() == 1 && inflections(arch).empty();
  const std::vector<std::array<double, 5>> line{{0, 1, 2, 3, 4}, {2, 3, 4, 5, 6}};
  right = right && part(line, 0.5, 1).points.front() == std::array<double, 5>{1, 2, 3, 4, 5};
  right = right && refused([&] { (void)elevate(arch, 1); }) && refused([&] { (void)roots(arch, 2); });
  right = right && refused([&] {
            (void)roots(Plane{{0, 0}, {1, 0}}, 1);
          }) &&
          refused([&] { (void)part(Plane{}, 0, 1); });
  right = right && refused([&] { (void)part(arch, 0, 1, weights.size() == 3 ? std::vector<double>{1} : weights); });
  return right;
}

}  // namespace

int main() { return batches_are_right() && roots_and_parts_are_right() ? 0 : 1; }
