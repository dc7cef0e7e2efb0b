// SPDX-License-Identifier: MIT
// Parts, degrees and roots by <bezierbench/roots_and_parts.hpp>, of curves whose answers are known: exit 0 where they are right.
#include <bezierbench/roots_and_parts.hpp>

namespace {

using namespace bezierbench;
using Plane = std::vector<std::array<double, 2>>;

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
  return right ? 0 : 1;
}
