// SPDX-License-Identifier: MIT
#include "experiments/suite/names.hpp"

#include <gtest/gtest.h>

namespace bezierbench::suite {
namespace {

template <class Enum>
void expect_round_trip() {
  for (std::size_t i = 0; i < words<Enum>.size(); ++i) {
    const auto& entry = words<Enum>[i];
    EXPECT_EQ(static_cast<std::size_t>(entry.value), i) << "a value is missing or out of order";
    EXPECT_EQ(parse<Enum>(suite::name(entry.value)), entry.value);
  }
  EXPECT_FALSE(parse<Enum>(""));
  EXPECT_FALSE(parse<Enum>("unknown"));
}

TEST(Names, EveryValueHasOneWord) {
  expect_round_trip<Form>();
  expect_round_trip<ScalarKind>();
  expect_round_trip<Mode>();
}

TEST(Names, AreTheWordsOfTheContract) {
  EXPECT_EQ(suite::name(Form::bernstein), "bernstein");
  EXPECT_EQ(suite::name(Form::power), "power");
  EXPECT_EQ(parse<Form>("bezier"), Form::bernstein);
  EXPECT_EQ(parse<Form>("polynomial"), Form::power);
  EXPECT_EQ(name(ScalarKind::float32), "float");
  EXPECT_EQ(name(ScalarKind::float64), "double");
  EXPECT_EQ(name(Mode::one_shot), "one_shot");
  EXPECT_EQ(words<Mode>.back().value, Mode::batch);
}

}  // namespace
}  // namespace bezierbench::suite
