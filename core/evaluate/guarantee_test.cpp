// SPDX-License-Identifier: MIT
// What methods state as proved, over every curve of a small floating-point format and every t in [0,1]: the proofs are
// for any precision and any range of exponents.
#include "core/evaluate/guarantee.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/evaluate/roster.hpp"
#include "core/evaluate/small_float_test.hpp"

namespace bezierbench {
namespace {

using Binary16 = SmallFloat<11, -14, 15>;
using EightBits = SmallFloat<4, -6, 7>;  // 239 numbers
using SixBits = SmallFloat<3, -2, 3>;    // 55 numbers

/// Methods that state something and do not compute with the bits of a double.
template <class E>
constexpr bool states_something() {
  return requires { E::guarantees; }
  &&E::info.id != CorrectlyRounded::info.id;
}

template <class E, class Number>
class Line {
 public:
  explicit Line(const std::vector<Number>& points) : prepared_(E::prepare(curve(points))) {}
  double at(Number t) const { return E::evaluate(prepared_, t)[0].value(); }

 private:
  static auto curve(const std::vector<Number>& points) {
    Curve<Form::bernstein, Number, 1> curve(static_cast<int>(points.size()) - 1);
    for (std::size_t i = 0; i < points.size(); ++i) curve(0, static_cast<int>(i)) = points[i];
    return curve;
  }
  PreparedOf<E, Number, 1> prepared_;
};

template <class Number>
std::vector<Number> unit_interval() {
  auto numbers = Number::all();
  std::erase_if(numbers, [](Number t) { return t.value() < 0 || t.value() > 1; });
  return numbers;
}

/// Looks at one curve at every t, and keeps which properties it breaks.
template <class E, class Number>
void judge(const std::vector<Number>& points, const std::vector<Number>& ts, std::set<Property>& broken) {
  const Line<E, Number> line(points);
  const Line<E, Number> backwards({points.rbegin(), points.rend()});
  const auto [low, high] = std::ranges::minmax(points);
  const bool up = std::ranges::is_sorted(points);
  const bool down = std::ranges::is_sorted(points.rbegin(), points.rend());
  double before = std::nan("");
  for (const Number t : ts) {
    const double value = line.at(t);
    if (!std::isfinite(value)) {
      broken.insert(Property::finite);
      continue;
    }
    if (t.value() == 0 && value != points.front().value()) broken.insert(Property::ends_exact);
    if (t.value() == 1 && value != points.back().value()) broken.insert(Property::ends_exact);
    if (value < low.value() || value > high.value())
      broken.insert({Property::in_hull, low == high ? Property::constant_reproduced : Property::in_hull});
    if ((up && value < before) || (down && value > before)) broken.insert(Property::monotone);
    before = value;
    const double rest = 1 - t.value();  // exact in double
    if (Number(rest).value() != rest) continue;
    const double reversed = backwards.at(Number(rest));
    if (std::isfinite(reversed) && reversed != value) broken.insert(Property::reversal);
  }
}

/// Of all curves of a degree over the format, the properties that some break.
template <class E, class Number>
std::set<Property> broken_by_some(int degree) {
  const auto numbers = Number::all();
  const auto ts = unit_interval<Number>();
  std::set<Property> broken;
  std::vector<std::size_t> at(static_cast<std::size_t>(degree) + 1);
  std::vector<Number> points(at.size());
  while (true) {
    std::ranges::transform(at, points.begin(), [&](std::size_t k) { return numbers[k]; });
    judge<E, Number>(points, ts, broken);
    auto digit = at.begin();
    while (digit != at.end() && ++*digit == numbers.size()) *digit++ = 0;
    if (digit == at.end()) return broken;
  }
}

constexpr std::array judged{Property::ends_exact, Property::constant_reproduced,
                            Property::in_hull,    Property::monotone,
                            Property::reversal,   Property::finite};

/// At this degree every curve keeps what is proved, and some curve breaks what is not.
template <class E, class Number>
void expect_stated_is_what_holds(int degree) {
  const auto broken = broken_by_some<E, Number>(degree);
  for (const Property property : judged)
    EXPECT_NE(broken.contains(property), is_proved(E::info, property, degree))
        << E::info.id << ' ' << name(property) << ", degree " << degree;
}

template <class... Es>
void over_roster(TypeList<Es...> /*roster*/, const auto& of) {
  const auto one = [&]<class E>() {
    if constexpr (states_something<E>()) of.template operator()<E>();
  };
  (one.template operator()<Es>(), ...);
}

TEST(StatedGuarantees, AreWhatHoldsForEveryLineOfEightBits) {
  over_roster(Evaluators{}, []<class E>() { expect_stated_is_what_holds<E, EightBits>(1); });
}

TEST(StatedGuarantees, HoldForEveryQuadraticOfSixBits) {
  over_roster(Evaluators{}, []<class E>() {
    const auto broken = broken_by_some<E, SixBits>(2);
    for (const Property property : judged)
      EXPECT_FALSE(broken.contains(property) && is_proved(E::info, property, 2)) << E::info.id << ' ' << name(property);
  });
}

/// Every eighth constant of binary16 in three binades, the subnormal and the largest among them, at each of its t.
TEST(StatedGuarantees, ConstantsOfBinary16) {
  const auto ts = unit_interval<Binary16>();
  EXPECT_EQ(ts.size(), 15361U);
  over_roster(Evaluators{}, [&]<class E>() {
    if (!is_proved(E::info, Property::constant_reproduced, 1)) return;
    for (const double first : {0x1p-24, 1.0, 0x1p+15})
      for (double value = first; value < first * 1024; value += 8 * (first == 0x1p-24 ? first : first * 0x1p-10)) {
        if (first != 0x1p-24 && value >= 2 * first) break;
        const Line<E, Binary16> line({Binary16(value), Binary16(value)});
        const auto lost = std::ranges::count_if(ts, [&](Binary16 t) { return line.at(t) != value; });
        ASSERT_EQ(lost, 0) << E::info.id << ' ' << value;
      }
  });
}

TEST(SmallFloat, IsBinary16) {
  EXPECT_EQ(Binary16::all().size(), 63487U);  // 2^16 without 2^11 infinities and NaN, and one 0
  EXPECT_EQ(Binary16(2049).value(), 2048);    // ties to even
  EXPECT_EQ(Binary16(2051).value(), 2052);
  EXPECT_EQ(Binary16(65519).value(), 65504);
  EXPECT_TRUE(std::isinf(Binary16(65520).value()));
  EXPECT_EQ(Binary16(0x1p-25).value(), 0);
  EXPECT_EQ(Binary16(0x1.8p-24).value(), 0x1p-23);
  EXPECT_EQ((Binary16(1) + Binary16(0x1p-11)).value(), 1);
  // The product is 1 - 2^-20: rounded by itself it would be 1, and the sum a tie.
  EXPECT_EQ(Binary16(1 + 0x1p-10).fused(Binary16(1 - 0x1p-10), Binary16(2050)).value(), 2050);
}

}  // namespace
}  // namespace bezierbench
