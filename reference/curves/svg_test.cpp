// SPDX-License-Identifier: MIT
// Expected values follow from [SVG 2, chapters 5, 7, 8 and 10].
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/curves/csv.hpp"
#include "reference/curves/path_data.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::curves {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

Read read_of(const std::string& elements) {
  return read_svg(
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink'>" + elements + "</svg>",
      "a.svg");
}

std::vector<std::string> ids_of(const CurveSet& set) {
  std::vector<std::string> ids;
  for (std::size_t k = 0; k < set.size(); ++k) ids.emplace_back(set.id(k));
  return ids;
}

std::string refusal_of(const std::string& text) {
  try {
    (void)read_svg(text, "a.svg");
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "read";
}

/// The elements give the same numbers as path data.
void expect_path(const std::string& elements, const std::string& data) {
  EXPECT_EQ(read_of(elements).set.canonical_bytes(), read_path_data(data, "p").set.canonical_bytes()) << elements;
}

TEST(Svg, BasicShapesAreTheirEquivalentPaths) {
  expect_path("<rect x='1' y='2' width='30' height='40'/>", "M1,2 H31 V42 H1 Z");
  expect_path("<line x1='1' y1='2' x2='3'/>", "M1,2 L3,0");
  expect_path("<polyline points='0,0 1,2 3-4'/>", "M0,0 1,2 3,-4");
  expect_path("<polygon points='0,0 1,2 3,4'/>", "M0,0 1,2 3,4 Z");
  expect_path("<polygon points='0,0 1,2 0,0'/>", "M0,0 1,2 0,0 Z");
  expect_path("<rect width='1in' height='2.54cm'/>", "M0,0 H96 V96 H0 Z");
  expect_path("<path d='none'/><path/><path d=''/><line x1='50%'/>", "");
}

TEST(Svg, RoundShapesAreQuarters) {
  const auto circle = read_of("<circle cx='1' cy='2' r='3'/>").set;
  ASSERT_EQ(circle.size(), 4);
  EXPECT_THAT(circle[0].coefficients, ElementsAre(4, 2, 4, 5, 1, 5));
  EXPECT_THAT(circle[0].weights, ElementsAre(1, std::sqrt(0.5), 1));
  EXPECT_THAT(circle[3].coefficients, ElementsAre(1, -1, 4, -1, 4, 2));
  EXPECT_EQ(read_of("<ellipse rx='2'/>").set.canonical_bytes(), read_of("<circle r='2'/>").set.canonical_bytes());
  const auto rect = read_of("<rect width='10' height='6' rx='2'/>").set;
  ASSERT_EQ(rect.size(), 8);
  EXPECT_THAT(rect[0].coefficients, ElementsAre(2, 0, 8, 0));
  EXPECT_THAT(rect[1].coefficients, ElementsAre(8, 0, 10, 0, 10, 2));
  EXPECT_THAT(rect[7].coefficients, ElementsAre(0, 2, 0, 0, 2, 0));
  EXPECT_EQ(read_of("<rect width='10' height='6' ry='9'/>").set.size(), 4);  // rx, which is auto, is 9, too
  EXPECT_EQ(read_of("<rect width='.3' height='.3' rx='.15'/>").set.size(), 4);
  EXPECT_THAT(read_of("<circle/><rect width='5'/>").left_out, ElementsAre(Pair("shapes without an extent", 2)));
}

TEST(Svg, TransformsAreApplied) {
  const auto start = [](const std::string& transform) {
    const auto set = read_of("<path transform='" + transform + "' d='M3,5 L9,9'/>").set;
    return PlanePoint{set[0](0, 0), set[0](1, 0)};
  };
  EXPECT_THAT(start("matrix(1 2 3 4 5 6)"), ElementsAre(23, 32));
  EXPECT_THAT(start("translate(10)"), ElementsAre(13, 5));
  EXPECT_THAT(start(" translate( 10 , 20 ) "), ElementsAre(13, 25));
  EXPECT_THAT(start("scale(2)"), ElementsAre(6, 10));
  EXPECT_THAT(start("scale(2 3)"), ElementsAre(6, 15));
  EXPECT_THAT(start("rotate(90)"), ElementsAre(-5, 3));
  EXPECT_THAT(start("rotate(90,1,1)"), ElementsAre(-3, 3));
  EXPECT_THAT(start("skewX(45)"), ElementsAre(8, 5));
  EXPECT_THAT(start("skewY(45)"), ElementsAre(3, 8));
  EXPECT_THAT(start("translate(10),scale(2)"), ElementsAre(16, 10));  // the last one first
  EXPECT_THAT(start("none"), ElementsAre(3, 5));
  expect_path("<g transform='scale(2)'><g transform='translate(1,2)'><path d='M1,1 L2,2'/></g></g>", "M4,6 L6,8");
  expect_path("<svg x='5' y='6'><path d='M1,1 L2,2'/></svg>", "M6,7 L7,8");
  EXPECT_EQ(read_of("<g style='transform:scale(2)'/>").left_out.at("transforms in CSS"), 1);
}

TEST(Svg, UsedElementsAreExpanded) {
  expect_path(
      "<defs><path id='a' d='M0,0 L1,1'/></defs><use href='#a' x='5'/><use xlink:href='#a' y='6' "
      "transform='scale(2)'/>",
      "M5,0 L6,1 M0,12 L2,14");
  expect_path("<symbol id='s'><path d='M0,0 L1,1'/></symbol><use href='#s'/>", "M0,0 L1,1");
  expect_path("<symbol><path d='M0,0 L1,1'/></symbol><clipPath><path d='M0,0 L1,1'/></clipPath><mask><rect/></mask>",
              "");
  expect_path("<g display='none'><path d='M0,0 L1,1'/></g><path style='fill:red; display : none' d='M0,0 L1,1'/>", "");
  expect_path(
      "<path style='display:none;display:inline' d='M0,0 L1,1'/><path display='none' style='display:block' d='M1,1 "
      "2,2'/>",
      "M0,0 L1,1 M1,1 2,2");
  EXPECT_THAT(read_of("<use href='#b'/><use href='x.svg#b'/><text/>").left_out,
              ElementsAre(Pair("elements text", 1), Pair("use elements of what is not in the file", 2)));
}

TEST(Svg, IdsNameElementsOrNumbers) {
  EXPECT_THAT(
      ids_of(
          read_of("<line x2='1'/><line id='logo' x2='1'/><line id='logo' x2='1'/><line id='4' x2='1'/><line x2='1'/>")
              .set),
      ElementsAre("0:0:0", "logo:0:0", "2:0:0", "4:0:0", "4':0:0"));
  EXPECT_THAT(ids_of(read_of("<line id='" + std::string(999, 'a') + "' x2='1'/><line id='a&#10;b' x2='1'/>").set),
              ElementsAre("0:0:0", "1:0:0"));
}

TEST(Svg, PathsSurviveCsv) {
  const auto set = read_of("<path id='a' d='M0,0 L1,0 L1,1 z L5,5 M5,5 8,8'/><circle r='1'/><path d='M1,0 L2,0'/>").set;
  const auto again = read_csv(to_csv(set), "c.csv", Form::bernstein).set;
  ASSERT_EQ(again.canonical_bytes(), set.canonical_bytes());
  for (std::size_t k = 0; k < set.size(); ++k) EXPECT_EQ(again.begins_path(k), set.begins_path(k)) << set.id(k);
}

TEST(Svg, ErrorsNameTheirPlace) {
  for (const auto& [text, needle] : {std::pair("<svg>\n<path id='d' d = 'M1,1\n L x'/></svg>", "a.svg:3:4: "),
                                     {"<svg><path d='M0,0 &amp;'/></svg>", "a.svg:1:20: "},
                                     {"<svg><rect rx='1x'/></svg>", "read"},
                                     {"<svg><rect width='wide'/></svg>", "a.svg:1:19: width=\"wide\""},
                                     {"<svg><rect width='1e999'/></svg>", "too large"},
                                     {"<svg><polygon points='1 2 3'/></svg>", "a.svg:1:23: points has 3"},
                                     {"<svg><g transform='scale(1 2 3)'/></svg>", "a.svg:1:20: \"scale(1 2 3)\""},
                                     {"<svg><g transform='scale'/></svg>", "a.svg:1:20: "},
                                     {"<svg><g transform='scale(x)'/></svg>", "a.svg:1:26: "},
                                     {"<svg><g>", "is not XML"},
                                     {"<html/>", "\"html\", not svg"},
                                     {"", "is not XML"},
                                     {"\xFF\xFE<", "UTF-8"},
                                     {"\x1F\x8B", "gunzip"},
                                     {"<svg><path d='M0,0 C'/></svg>", "the path ends"}})
    EXPECT_THAT(refusal_of(text), HasSubstr(needle)) << text;
}

TEST(Svg, HostileDocumentsEnd) {
  // Entities are not expanded, so what names them is not a path.
  EXPECT_THAT(refusal_of("<!DOCTYPE svg [<!ENTITY a 'M0,0'><!ENTITY b '&a;&a;&a;'>]><svg><path d='&b;'/></svg>"),
              HasSubstr("\"&b;\""));
  std::string deep;
  for (int k = 0; k < 300000; ++k) deep += "<g>";
  EXPECT_THAT(refusal_of("<svg>" + deep + "</svg>"), HasSubstr("is not XML"));
  std::string closed = deep;
  for (int k = 0; k < 300000; ++k) closed += "</g>";
  EXPECT_THAT(refusal_of("<svg>" + closed + "</svg>"), HasSubstr("nested more than 256"));
  EXPECT_THAT(refusal_of("<svg><g id='a'><use href='#a'/></g></svg>"), HasSubstr("nested more than 256"));
  std::string doubling = "<g id='n0'/>";  // 2^60 elements, none of which draws
  for (int k = 1; k < 60; ++k)
    doubling += fmt::format("<g id='n{0}'><use href='#n{1}'/><use href='#n{1}'/></g>", k, k - 1);
  EXPECT_THAT(refusal_of("<svg><defs>" + doubling + "</defs><use href='#n59'/></svg>"),
              HasSubstr("more than 10000000 elements"));
  std::string moves = "<path id='p' d='";
  for (int k = 0; k < 100000; ++k) moves += "M0,0 ";
  moves += "'/>";
  for (int k = 0; k < 200; ++k) moves += "<use href='#p'/>";
  EXPECT_THAT(refusal_of("<svg>" + moves + "</svg>"), HasSubstr("use elements repeat more than"));
}

}  // namespace
}  // namespace bezierbench::curves
