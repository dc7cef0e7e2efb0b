// SPDX-License-Identifier: MIT
#include "reference/curves/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace bezierbench::curves {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal_of(std::string_view text, const std::string& name) {
  try {
    (void)read(text, name);
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "read";
}

TEST(Read, TheNameOrElseTheContentsDecide) {
  for (const auto& [text, name] : {std::pair("x,y\n0,0\n1,2\n", "c.csv"),
                                   {"x,y\n0,0\n1,2\n", "-"},
                                   {"M0,0 1,2", "p.txt"},
                                   {" m 0,0 1,2", "-"},
                                   {"M.0,0 1,2", "-"},
                                   {"<svg><path d='M0,0 1,2'/></svg>", "-"},
                                   {"\xEF\xBB\xBF<?xml version='1.0'?><svg><line x2='1' y2='2'/></svg>", "A.SVG"},
                                   {"[[0,0],[1,2]]", "c.json"},
                                   {" [ [ [0,0], [1e0,2.0] ] ]", "-"},
                                   {"{\"points\": [[0,0],[1,2]]}", "-"}}) {
    const auto set = read(text, name).set;
    ASSERT_EQ(set.size(), 1) << text;
    EXPECT_THAT(set[0].coefficients, ElementsAre(0, 0, 1, 2)) << text;
  }
}

TEST(Json, CurvesOfAnyKind) {
  const auto set = read(R"([[[0,0],[1,2]], [[1,2],[3,4],[5,6]], [[5,6]],
                            {"id": "r", "points": [[1],[2]], "weights": [1, 2.5], "note": {"a": [1]}},
                            {"points": [[1,2,3]], "form": "power"}])",
                        "c.json")
                       .set;
  ASSERT_EQ(set.size(), 5);
  EXPECT_EQ(set.id(1), "1");
  EXPECT_FALSE(set.begins_path(1));
  EXPECT_THAT(set[1].coefficients, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(set.id(3), "r");
  EXPECT_THAT(set[3].weights, ElementsAre(1, 2.5));
  EXPECT_EQ(set[3].dimension, 1);
  EXPECT_EQ(set[4].form, Form::power);
  EXPECT_EQ(set[4].dimension, 3);
  EXPECT_EQ(read("[[1,2]]", "c.json", {Form::power}).set[0].form, Form::power);
  EXPECT_EQ(read("[[0.1,-0.0]]", "c.json").set[0](1, 0), 0);
  EXPECT_TRUE(std::signbit(read("[[0.1,-0.0]]", "c.json").set[0](1, 0)));
}

TEST(Json, ErrorsSayWhere) {
  for (const auto& [text, needle] : {std::pair("[[1,2],[3,NaN]]", "c.json:1:11: "),
                                     {"[[1,2],\n[3,4]", "c.json:2:6: "},
                                     {"[[1,1e999]]", "too large"},
                                     {"[1,2]", "array of points"},
                                     {"5", "array of points"},
                                     {"[]", "without points"},
                                     {"[[[1,2]],[]]", "curve 1: an array without"},
                                     {"[[1,2],[3]]", "curve 0: point 1 must be 2 numbers"},
                                     {"[[1,2],\"a\"]", "point 1"},
                                     {"[[1,2,3,4]]", "4 coordinates"},
                                     {"{}", "without points"},
                                     {R"({"points":[[1]],"weights":[0]})", "every weight is 0"},
                                     {R"({"points":[[1]],"weights":[1,2]})", "weights must be 1 number"},
                                     {R"({"points":[[1]],"form":"cubic"})", "form must be"},
                                     {R"([{"points":[[1]],"form":"rational"}])", "has weights"},
                                     {R"([{"id":0,"points":[[1]]},{"id":0,"points":[[1]]}])", "occurs above"},
                                     {R"([[[1]],5])", "array of points"}})
    EXPECT_THAT(refusal_of(text, "c.json"), HasSubstr(needle)) << text;
  EXPECT_THAT(refusal_of(std::string(100000, '['), "c.json"), HasSubstr("nested more than 256"));
  std::string flat = "[";
  for (int k = 0; k < 100000; ++k) flat += "1,";
  EXPECT_THAT(refusal_of(flat + "1]", "c.json"), HasSubstr("too long"));
}

TEST(Joined, IdsThatClashNameTheirFile) {
  const auto ids = [](std::initializer_list<std::pair<const char*, const char*>> texts) {
    std::vector<NamedRead> files;
    for (const auto& [name, text] : texts) files.push_back({name, read(text, name)});
    const auto all = joined(files);
    std::vector<std::string> found;
    for (std::size_t k = 0; k < all.set.size(); ++k) found.emplace_back(all.set.id(k));
    return found;
  };
  const char* const a = "curve,index,x\na,0,1\n0,0,2\n";
  const char* const b = "curve,index,x\nb,0,1\n";
  const char* const plain = "x\n1\n";
  EXPECT_THAT(ids({{"f/a.csv", a}, {"b.csv", b}}), ElementsAre("a", "0", "b"));
  EXPECT_THAT(ids({{"f/a.csv", a}, {"b.csv", b}, {"g/a.csv", a}}), ElementsAre("a:a", "a:0", "b:b", "a-2:a", "a-2:0"));
  EXPECT_THAT(ids({{"p.csv", plain}, {"b.csv", b}}), ElementsAre("p", "b:b"));
  EXPECT_THAT(ids({{"p.csv", plain}}), ElementsAre(""));
}

TEST(Read, LimitsAreStated) {
  EXPECT_THAT(refusal_of(std::string(most_bytes + 1, ' '), "c.csv"), HasSubstr("split the file"));
}

}  // namespace
}  // namespace bezierbench::curves
