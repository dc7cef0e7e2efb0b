// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "reference/curves/font_tables.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::curves {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Bytes from hexadecimal digits; spaces are ignored.
std::string hex(std::string_view digits) {
  std::string bytes;
  std::string pair;
  for (const char digit : digits) {
    if (digit != ' ') pair += digit;
    if (pair.size() == 2) bytes += static_cast<char>(std::stoi(std::exchange(pair, ""), nullptr, 16));
  }
  return bytes;
}

std::string big_endian(std::size_t value, int bytes) {
  std::string result;
  while (bytes-- > 0) result += static_cast<char>(value >> (8 * static_cast<unsigned>(bytes)) & 0xffU);
  return result;
}

template <class Glyphs>
Read drawn(const Glyphs& glyphs, std::size_t glyph) {
  Read read;
  Outline outline(read);
  outline.begin_glyph("g");
  glyphs.draw(glyph, outline);
  return read;
}

std::vector<std::vector<double>> segments(const Read& read) {
  std::vector<std::vector<double>> result;
  for (std::size_t k = 0; k < read.set.size(); ++k) {
    const auto numbers = read.set[k].coefficients;
    result.emplace_back(numbers.begin(), numbers.end());
  }
  return result;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::runtime_error& wrong) {
    return wrong.what();
  }
  return "nothing is wrong";
}

/// The tables of a TrueType font whose left side bearings are 0.
class TrueType {
 public:
  explicit TrueType(const std::vector<std::string>& glyphs)
      : head_(std::string(50, '\0') + hex("0001")),
        maxp_(std::string(4, '\0') + big_endian(glyphs.size(), 2)),
        hhea_(std::string(34, '\0') + hex("0001")),
        hmtx_(2 + 2 * glyphs.size(), '\0'),
        loca_(4, '\0') {
    for (const auto& glyph : glyphs) {
      glyf_ += glyph;
      loca_ += big_endian(glyf_.size(), 4);
    }
  }
  [[nodiscard]] Glyf glyf() const { return glyf(glyf_); }
  [[nodiscard]] Glyf glyf(std::string_view glyf) const {
    return Glyf({.head = head_, .maxp = maxp_, .hhea = hhea_, .hmtx = hmtx_, .glyf = glyf, .loca = loca_});
  }
  [[nodiscard]] const std::string& bytes() const { return glyf_; }

 private:
  std::string head_, maxp_, hhea_, hmtx_, glyf_, loca_;
};

// On the curve (0, 0), off it (3, 0) and (3, 3).
const std::string three_points = hex("0001 0000 0000 0003 0003  0002 0000  01 00 00  0000 0003 0000  0000 0000 0003");

TEST(Glyf, PointsBetweenControlPointsAreExactHalves) {
  const auto read = drawn(TrueType({three_points}).glyf(), 0);
  EXPECT_THAT(segments(read), ElementsAre(ElementsAre(0, 0, 3, 0, 3, 1.5), ElementsAre(3, 1.5, 3, 3, 0, 0)));
  EXPECT_EQ(read.set.id(1), "g:0:1");
  EXPECT_TRUE(read.set.begins_path(0));
  EXPECT_FALSE(read.set.begins_path(1));
}

TEST(Glyf, AContourWithoutPointsOnTheCurveBeginsBetweenItsLastAndItsFirst) {
  const auto off = hex("0001 0000 0000 0003 0003  0001 0000  08 01  0001 0002  0000 0003");
  EXPECT_THAT(segments(drawn(TrueType({off}).glyf(), 0)),
              ElementsAre(ElementsAre(2, 1.5, 1, 0, 2, 1.5), ElementsAre(2, 1.5, 3, 3, 2, 1.5)));
}

TEST(Glyf, LinesOfZeroLengthAreLeftOutAndContoursAreClosed) {
  const auto lines = hex("0001 0000 0000 0003 0003  0003 0000  31 01 31 01  0003 fffe  0000 0004");
  const auto read = drawn(TrueType({lines}).glyf(), 0);
  EXPECT_THAT(segments(read), ElementsAre(ElementsAre(0, 0, 3, 0), ElementsAre(3, 0, 1, 4), ElementsAre(1, 4, 0, 0)));
  EXPECT_EQ(read.left_out.at("lines of zero length"), 1U);
}

TEST(Glyf, ComponentsAreTransformedThenMoved) {
  // x' = x / 2 + 3/2 y + 10, y' = -x + y / 4 - 1; the second time the offset is transformed as well.
  const auto plain = hex("ffff 0000 0000 0000 0000  0083 0000 000a ffff 2000 c000 6000 1000");
  const auto scaled = hex("ffff 0000 0000 0000 0000  0883 0000 000a ffff 2000 c000 6000 1000");
  const auto font = TrueType({three_points, plain, scaled});
  EXPECT_THAT(segments(drawn(font.glyf(), 1))[0], ElementsAre(10, -1, 11.5, -4, 13.75, -3.625));
  EXPECT_THAT(segments(drawn(font.glyf(), 2))[0], ElementsAre(3.5, -10.25, 5, -13.25, 7.25, -12.875));
}

TEST(Glyf, ComponentsAreAttachedByPoints) {
  // Point 1 of the second component on point 2 of the first.
  const auto attached = hex("ffff 0000 0000 0000 0000  0022 0000 0000  0000 0000 0201");
  EXPECT_THAT(segments(drawn(TrueType({three_points, attached}).glyf(), 1))[2], ElementsAre(0, 3, 3, 3, 3, 4.5));
  const auto beyond = hex("ffff 0000 0000 0000 0000  0022 0000 0000  0000 0000 0301");
  EXPECT_THAT(message_of([&] { (void)drawn(TrueType({three_points, beyond}).glyf(), 1); }), HasSubstr("point 3 or 1"));
}

TEST(Glyf, RefusesComponentsWithoutEnd) {
  const auto itself = hex("ffff 0000 0000 0000 0000  0002 0000 0000");
  EXPECT_THAT(message_of([&] { (void)drawn(TrueType({itself}).glyf(), 0); }), HasSubstr("nested more than 256 deep"));
  std::vector<std::string> doubled{""};  // the last of these has 2^60 empty components
  for (int k = 0; k < 60; ++k)
    doubled.push_back(hex("ffff 0000 0000 0000 0000  0022") + big_endian(doubled.size() - 1, 2) + hex("0000  0002") +
                      big_endian(doubled.size() - 1, 2) + hex("0000"));
  EXPECT_THAT(message_of([&] { (void)drawn(TrueType(doubled).glyf(), 60); }), HasSubstr("more than 100000000 steps"));
}

TEST(Glyf, RefusesAGlyphThatIsCutOff) {
  const TrueType font({three_points});
  for (std::size_t size = 1; size < font.bytes().size(); ++size)
    EXPECT_THROW((void)drawn(font.glyf(std::string_view(font.bytes()).substr(0, size)), 0), Malformed) << size;
}

std::string index(const std::vector<std::string>& items) {
  if (items.empty()) return hex("0000");
  std::string offsets = big_endian(items.size(), 2) + hex("02 0001");
  std::string data;
  for (const auto& item : items) offsets += big_endian((data += item).size() + 1, 2);
  return offsets + data;
}

/// A CFF table without names and without a Private DICT.
std::string cff(const std::vector<std::string>& charstrings, const std::vector<std::string>& subroutines = {}) {
  const auto table = [&](std::size_t offset) {
    return hex("01000401") + index({"A"}) + index({hex("1d") + big_endian(offset, 4) + hex("11")}) + index({}) +
           index(subroutines);
  };
  return table(table(0).size()) + index(charstrings);
}

Read drawn_charstring(const std::string& program, const std::vector<std::string>& subroutines = {}) {
  const auto table = cff({program}, subroutines);
  return drawn(Cff(table, false), 0);
}

TEST(Cff, ReadsLinesCurvesAndFractions) {
  // Width 1, move by (0, 1.5) as 16.16; then curve by (1, 2), (3, 4), (5, 6); then a closing line.
  const auto read = drawn_charstring(hex("8c ff00018000 04  8c 8d 8e 8f 90 91 08  0e"));
  EXPECT_THAT(segments(read), ElementsAre(ElementsAre(0, 1.5, 1, 3.5, 4, 7.5, 9, 13.5), ElementsAre(9, 13.5, 0, 1.5)));
}

TEST(Cff, SkipsTheBytesOfHintMasks) {
  // Eight hints take one byte, nine take two; they would be endchar otherwise.
  const auto eight = hex("8c8c 01  8c8c8c8c8c8c8c8c 8c8c8c8c8c8c 13 0e  8b 16 8c 06 0e");
  const auto nine = hex("8c8c 01  8c8c8c8c8c8c8c8c 8c8c8c8c8c8c8c8c 13 0e0e  8b 16 8c 06 0e");
  for (const auto& program : {eight, nine})
    EXPECT_THAT(segments(drawn_charstring(program)), ElementsAre(ElementsAre(0, 0, 1, 0), ElementsAre(1, 0, 0, 0)));
}

TEST(Cff, CallsSubroutinesAndRefusesThoseWithoutEnd) {
  EXPECT_THAT(segments(drawn_charstring(hex("8b 16 20 1d 0e"), {hex("8c 06 0b")}))[0], ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(message_of([] { (void)drawn_charstring(hex("20 1d 0e"), {hex("20 1d 0b")}); }), HasSubstr("10 deep"));
  EXPECT_THAT(message_of([] { (void)drawn_charstring(hex("21 1d 0e"), {hex("0b")}); }), HasSubstr("subroutine 1,"));
  std::vector<std::string> tenfold(10);  // 10^10 calls
  for (int k = 0; k < 10; ++k)
    for (int call = 0; call < 10; ++call) tenfold[static_cast<std::size_t>(k)] += hex(k < 9 ? "" : "8b16");
  for (std::size_t k = 0; k < 9; ++k)
    for (int call = 0; call < 10; ++call) tenfold[k] += big_endian(33 + k, 1) + hex("1d");
  EXPECT_THAT(message_of([&] { (void)drawn_charstring(hex("20 1d 0e"), tenfold); }),
              HasSubstr("more than 100000000 steps"));
}

TEST(Cff, RefusesWhatCannotBeDrawn) {
  EXPECT_THAT(message_of([] { (void)drawn_charstring(hex("8c 8b 0c0c 16 8c 06")); }), HasSubstr("divides by"));
  EXPECT_THAT(message_of([] { (void)drawn_charstring(hex("8c 05")); }), HasSubstr("number of operands"));
  EXPECT_THAT(message_of([] { (void)drawn_charstring(hex("0c17")); }), HasSubstr("12 23, which is not supported"));
  EXPECT_THAT(message_of([] { (void)drawn_charstring(std::string(600, '\x8c')); }), HasSubstr("too many operands"));
  const auto table = cff({hex("8b 16 8c 06 0e")});
  for (std::size_t size = 0; size < table.size(); ++size)
    EXPECT_THROW((void)drawn(Cff(std::string_view(table).substr(0, size), false), 0), Malformed) << size;
}

std::string made(const std::string& name) {
  std::ifstream file(std::filesystem::path(BEZIERBENCH_SOURCE_DIR) / "reference/curves/fuzzed_fonts" / name,
                     std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Font, EveryContainerHasTheSameOutlines) {
  const auto bytes = read_font(made("glyf.ttf"), "glyf.ttf").set.canonical_bytes();
  EXPECT_EQ(read_font(made("glyf.woff"), "glyf.woff").set.canonical_bytes(), bytes);
  EXPECT_EQ(read_font(made("glyf.woff2"), "glyf.woff2").set.canonical_bytes(), bytes);
  const auto faces = read_font(made("faces.ttc"), "faces.ttc");  // glyf.ttf twice and cff.otf
  EXPECT_EQ(faces.set.canonical_bytes(), bytes + read_font(made("cff.otf"), "cff.otf").set.canonical_bytes());
  EXPECT_EQ(faces.left_out.at("faces with the outlines of a face before"), 1U);
  EXPECT_LT(faces.set.find("2:Aacute:1:0"), faces.set.size());
}

TEST(Font, TheLeftSideBearingIsThatOfTheMetrics) {
  // `moved` has a triangle from x = 320, a curve from x = -3 that reaches to x = -303, and a left side bearing of 12.
  const auto read = read_font(made("glyf.ttf"), "glyf.ttf");
  EXPECT_THAT(read.set[read.set.find("moved:0:0")].coefficients, ElementsAre(635, -7, 655, -7));
}

TEST(Font, OfAVariableFontTheDefaultInstanceIsRead) {
  const auto read = read_font(made("cff2.otf"), "cff2.otf");
  EXPECT_THAT(segments(read)[0], ElementsAre(10, 20, 40, 20));
  EXPECT_EQ(read.left_out.at("variations of a font, except its default instance"), 1U);
}

TEST(Font, RefusalsNameTheFileAndTheGlyph) {
  const auto refusal = [](const std::string& contents) {
    return message_of([&] { (void)read_font(contents, "a.ttf"); });
  };
  EXPECT_THAT(refusal(""), StartsWith("a.ttf: it is not a font"));
  EXPECT_THAT(refusal("wOF2" + std::string(12, '\0') + hex("ffffffff")), HasSubstr("more than 268435456 bytes"));
  auto broken = made("cff.otf");
  const auto at = broken.find(hex("8c16 8c8d8e8f909192939495969708"));  // the charstring of `curves`
  ASSERT_NE(at, std::string::npos);
  broken[at + 1] = '\x05';
  EXPECT_THAT(refusal(broken), StartsWith("a.ttf: glyph curves: an operator"));
}

TEST(Font, AFileThatIsCutOffIsReadOrRefused) {
  for (const auto* name :
       {"glyf.ttf", "cff.otf", "cff2.otf", "cid_keyed.otf", "faces.ttc", "glyf.woff", "glyf.woff2"}) {
    const auto whole = made(name);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      try {
        (void)read_font(std::string_view(whole).substr(0, size), name);
      } catch (const Unreadable& refusal) {
        EXPECT_THAT(refusal.what(), StartsWith(name));
      }
    }
  }
}

}  // namespace
}  // namespace bezierbench::curves
