// SPDX-License-Identifier: MIT
#include "reference/curves/path_data.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::curves {
namespace {

PlanePoint operator+(const PlanePoint& p, const PlanePoint& q) { return {p[0] + q[0], p[1] + q[1]}; }
PlanePoint operator-(const PlanePoint& p, const PlanePoint& q) { return {p[0] - q[0], p[1] - q[1]}; }
PlanePoint operator*(double factor, const PlanePoint& p) { return {factor * p[0], factor * p[1]}; }

/// What the square of half a chord may be off by: the coordinates of arcs are those of decimals.
constexpr double rounding = 0x1p-50;

/// Half of an arc, or the arc itself: from its start to its end in the plane in which the ellipse is the unit circle
/// and the middle of the arc's chord is the origin.
struct Piece {
  PlanePoint control;
  double weight;
  PlanePoint end;
};

/// The pieces of the arc of the unit circle from `half` to -`half` about the middle of the chord, |half|^2 = `square`
/// <= 1. `out` is the unit vector from there to the middle of the arc. Nothing cancels: differences such as 1 - sqrt(1
/// - square) are written as quotients.
std::vector<Piece> pieces_of(const PlanePoint& half, double square, const PlanePoint& out, bool large) {
  const PlanePoint none{};
  const auto back = none - half;
  const double g = std::sqrt(1 - square);  // the distance of the centre from the chord
  const double rest = square / (1 + g);    // 1 - g
  if (!large && square <= 0.5 * (1 + rounding)) return {{(square / g) * out, g, back}};
  if (!large) {
    const double weight = std::sqrt((1 + g) / 2);
    const auto middle = rest * out;
    return {{middle + (1 / (1 + g)) * half, weight, middle}, {middle + (1 / (1 + g)) * back, weight, back}};
  }
  const auto centre = g * out;
  const double norm = std::sqrt(2 * rest);
  const double cosine = std::sqrt(rest / 2);  // of a quarter of the arc
  const double weight = std::sqrt((1 + cosine) / 2);
  std::vector<Piece> pieces;
  const auto quarter = [&](const PlanePoint& from) { return (1 / norm) * (from + rest * out); };  // from the centre
  const auto control = [&](const PlanePoint& u, const PlanePoint& v) { return centre + (1 / (1 + cosine)) * (u + v); };
  const auto first = quarter(half);
  const auto last = quarter(back);
  return {{control(half - centre, first), weight, centre + first},
          {control(first, out), weight, centre + out},
          {control(out, last), weight, centre + last},
          {control(last, back - centre), weight, back}};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// The grammar of path data, which that of lists of numbers is a part of.
class Scanner {
 public:
  Scanner(std::string_view text, const Source& source, std::size_t offset)
      : text_(text), source_(source), offset_(offset) {}

  [[noreturn]] void refuse(std::string_view what) const { source_.refuse(offset_ + at_, what); }

  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  /// Blanks, and at most one comma among them.
  void skip_separator() {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != ',') return;
    ++at_;
    skip_blanks();
    after_comma_ = true;
  }
  [[nodiscard]] bool done() const { return at_ == text_.size(); }
  [[nodiscard]] char peek() const { return done() ? '\0' : text_[at_]; }
  [[nodiscard]] bool at_number() const { return is_digit(peek()) || peek() == '.' || peek() == '-' || peek() == '+'; }
  /// Whether a comma is followed by something other than a number.
  [[nodiscard]] bool after_comma() const { return after_comma_; }
  char take() { return text_[at_++]; }
  [[nodiscard]] std::string shown() const {
    return done() ? "the path ends" : fmt::format("there is \"{}\"", echo(text_.substr(at_, 20)));
  }

  double number() {
    after_comma_ = false;
    const auto begin = at_;
    auto end = at_;
    const auto peek_at = [&] { return end < text_.size() ? text_[end] : '\0'; };
    const auto digits = [&] {
      const auto from = end;
      while (is_digit(peek_at())) ++end;
      return end - from;
    };
    if (peek_at() == '-' || peek_at() == '+') ++end;
    const auto whole = digits();
    if (peek_at() == '.') {
      ++end;
      if (digits() == 0) refuse(fmt::format("{} where a number is required; write a digit after the point", shown()));
    } else if (whole == 0) {
      refuse(fmt::format("{} where a number is required; add it, or remove its command", shown()));
    }
    if (peek_at() == 'e' || peek_at() == 'E') {
      const auto before = end++;
      if (peek_at() == '-' || peek_at() == '+') ++end;
      if (digits() == 0) end = before;
    }
    const auto word = text_.substr(begin, end - begin);
    const auto value = number::parse_number(word);
    if (!value) refuse(fmt::format("\"{}\" {}", echo(word), number::fault(word)));
    at_ = end;
    return *value;
  }

  bool flag() {
    after_comma_ = false;
    if (peek() != '0' && peek() != '1')
      refuse(fmt::format("{} where a flag of an arc is required, 0 or 1; write radii, rotation, two flags, point",
                         shown()));
    return take() == '1';
  }

 private:
  std::string_view text_;
  const Source& source_;
  std::size_t offset_;
  std::size_t at_ = 0;
  bool after_comma_ = false;
};

/// Draws the commands of path data one after the other.
class Drawing {
 public:
  Drawing(Scanner scanner, Path& path) : scanner_(scanner), path_(path) {}

  void run() {
    scanner_.skip_blanks();
    if (!scanner_.done() && scanner_.peek() != 'M' && scanner_.peek() != 'm')
      scanner_.refuse(fmt::format("{} where the first command is required, M or m", scanner_.shown()));
    while (!scanner_.done()) {
      if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(scanner_.peek()) == std::string_view::npos)
        scanner_.refuse(fmt::format("{} where a command is required, one of MmLlHhVvCcSsQqTtAaZz", scanner_.shown()));
      run_command(scanner_.take());
    }
  }

 private:
  void run_command(char letter) {
    scanner_.skip_blanks();
    relative_ = letter >= 'a';
    letter_ = static_cast<char>(relative_ ? letter - 'a' + 'A' : letter);
    if (letter_ == 'Z') {
      path_.close();
      reflected_ = '\0';
      return;
    }
    do {
      draw_one();
      reflected_ = letter_;
      if (letter_ == 'M') letter_ = 'L';  // more points of a moveto are lines
      scanner_.skip_separator();
    } while (scanner_.at_number());
    if (scanner_.after_comma())
      scanner_.refuse(fmt::format("{} after a comma, where a number is required; remove the comma", scanner_.shown()));
  }

  [[nodiscard]] double next() {
    const double value = scanner_.number();
    scanner_.skip_separator();
    return value;
  }
  /// The last number of an argument; what separates it from the next one is read by run_command().
  [[nodiscard]] double last(int axis) {
    return scanner_.number() + (relative_ ? path_.current()[static_cast<std::size_t>(axis)] : 0);
  }
  [[nodiscard]] PlanePoint point() {
    const double x = next() + (relative_ ? path_.current()[0] : 0);
    return {x, last(1)};
  }
  [[nodiscard]] PlanePoint next_point() {
    const auto p = point();
    scanner_.skip_separator();
    return p;
  }
  /// The control point that a smooth command leaves out: that of the last curve mirrored, where it was of the kind.
  [[nodiscard]] PlanePoint mirrored(std::string_view kinds) const {
    const bool has = reflected_ != '\0' && kinds.find(reflected_) != std::string_view::npos;
    return has ? path_.current() + (path_.current() - control_) : path_.current();
  }

  void draw_one() {
    switch (letter_) {
      case 'M': path_.move_to(point()); break;
      case 'L': path_.line_to(point()); break;
      case 'H': path_.line_to({last(0), path_.current()[1]}); break;
      case 'V': path_.line_to({path_.current()[0], last(1)}); break;
      case 'C': draw_cubic(next_point()); break;
      case 'S': draw_cubic(mirrored("CS")); break;
      case 'Q': draw_quadratic(next_point()); break;
      case 'T': draw_quadratic(mirrored("QT")); break;
      default: draw_arc();
    }
  }

  void draw_cubic(const PlanePoint& first) {
    control_ = next_point();
    path_.cubic_to(first, control_, point());
  }

  void draw_quadratic(const PlanePoint& control) {
    control_ = control;
    path_.quadratic_to(control_, point());
  }

  void draw_arc() {
    const double rx = next();
    const double ry = next();
    const double degrees = next();
    const bool large = scanner_.flag();
    scanner_.skip_separator();
    const bool sweep = scanner_.flag();
    scanner_.skip_separator();
    path_.arc_to({rx, ry}, degrees, large, sweep, point());
  }

  Scanner scanner_;
  Path& path_;
  char letter_ = '\0';  ///< of the command, in upper case
  bool relative_ = false;
  char reflected_ = '\0';  ///< the command before, whose control point a smooth one mirrors
  PlanePoint control_{};   ///< the last one
};

}  // namespace

PlanePoint Affine::operator()(const PlanePoint& p) const {
  if (*this == Affine()) return p;  // 0 y + x would lose the sign of x = -0
  return {a * p[0] + c * p[1] + e, b * p[0] + d * p[1] + f};
}

Affine Affine::operator*(const Affine& inner) const {
  const Affine linear{a, b, c, d, 0, 0};
  const auto x = linear({inner.a, inner.b});
  const auto y = linear({inner.c, inner.d});
  const auto origin = (*this)({inner.e, inner.f});
  return {x[0], x[1], y[0], y[1], origin[0], origin[1]};
}

PlanePoint direction_of(double degrees) {
  const double within = std::remainder(degrees, 360.0);  // exact
  const double turns = std::nearbyint(within / 90);
  const auto rest = (within - 90 * turns) * (std::numbers::pi_v<long double> / 180);
  const auto cosine = static_cast<double>(std::cos(rest));
  const auto sine = static_cast<double>(std::sin(rest));
  switch (static_cast<int>(turns)) {
    case 0: return {cosine, sine};
    case 1: return {-sine, cosine};
    case -1: return {sine, -cosine};
    default: return {-cosine, -sine};
  }
}

void Path::add(std::span<const PlanePoint> points, std::span<const double> weights) {
  std::array<double, 8> numbers{};
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      numbers.at(2 * k + axis) = map_(points[k])[axis];
      if (!std::isfinite(numbers.at(2 * k + axis)))
        throw Unreadable(
            fmt::format("{}: segment {} of path {} has a coordinate beyond the largest double; scale it down", file_,
                        segment_, echo(name_)));
    }
  require_room(to_.set, file_);
  to_.set.add(fmt::format("{}:{}:{}", name_, subpath_, segment_),
              {weights.empty() ? Form::bernstein : Form::rational, 2, static_cast<int>(points.size()) - 1,
               std::span(numbers).first(2 * points.size()), weights},
              segment_ == 0);
  ++segment_;
  current_ = points.back();
}

void Path::move_to(const PlanePoint& p) {
  subpath_ += segment_ > 0 ? 1 : 0;
  segment_ = 0;
  start_ = current_ = p;
}

void Path::line_to(const PlanePoint& p) { add(std::array{current_, p}, {}); }
void Path::quadratic_to(const PlanePoint& control, const PlanePoint& p) { add(std::array{current_, control, p}, {}); }
void Path::cubic_to(const PlanePoint& first, const PlanePoint& second, const PlanePoint& p) {
  add(std::array{current_, first, second, p}, {});
}
void Path::conic_to(const PlanePoint& control, double weight, const PlanePoint& p) {
  add(std::array{current_, control, p}, std::array{1.0, weight, 1.0});
}

void Path::arc_to(const PlanePoint& radii, double degrees, bool large, bool sweep, const PlanePoint& p) {
  if (p == current_) {
    ++to_.left_out["arcs that end where they start"];
    return;
  }
  if (radii[0] == 0 || radii[1] == 0) return line_to(p);
  const auto axis = direction_of(degrees);
  double rx = std::abs(radii[0]);
  double ry = std::abs(radii[1]);
  // Half the chord in the plane in which the ellipse is the unit circle: x'/rx, y'/ry of [SVG 2, F.6.5.1].
  const auto chord = 0.5 * current_ - 0.5 * p;
  PlanePoint half{(axis[0] * chord[0] + axis[1] * chord[1]) / rx, (axis[0] * chord[1] - axis[1] * chord[0]) / ry};
  const double largest = std::max(std::abs(half[0]), std::abs(half[1]));
  if (largest == 0 || !std::isfinite(largest))
    throw Unreadable(
        fmt::format("{}: segment {} of path {} is an arc whose radii are not in the range of doubles beside "
                    "its chord; write it as a line",
                    file_, segment_, echo(name_)));
  const PlanePoint unit{half[0] / largest, half[1] / largest};  // no square of it overflows or vanishes
  const double length = std::sqrt(unit[0] * unit[0] + unit[1] * unit[1]);
  const double distance = largest * length;
  double square = distance * distance;
  if (square > 1 - rounding) {
    if (distance > 1) {  // [SVG 2, F.6.6.3]; F.6.6.2 where they suffice
      rx *= distance;
      ry *= distance;
      half = (1 / length) * unit;
    }
    square = 1;
    large = false;
  }
  const PlanePoint out = (sweep ? 1 / length : -1 / length) * PlanePoint{-unit[1], unit[0]};
  const auto middle = 0.5 * current_ + 0.5 * p;
  const auto placed = [&](const PlanePoint& q) {
    const PlanePoint scaled{rx * q[0], ry * q[1]};
    return middle + PlanePoint{axis[0] * scaled[0] - axis[1] * scaled[1], axis[1] * scaled[0] + axis[0] * scaled[1]};
  };
  const auto pieces = pieces_of(half, square, out, large);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    conic_to(placed(pieces[k].control), pieces[k].weight, k + 1 < pieces.size() ? placed(pieces[k].end) : p);
}

void Path::close() {
  if (current_ != start_)
    line_to(start_);
  else
    ++to_.left_out["closing lines of length 0"];
  move_to(start_);
}

void draw(std::string_view data, const Source& source, std::size_t offset, Path& path) {
  Drawing({data, source, offset}, path).run();
}

std::vector<double> numbers_of(std::string_view list, const Source& source, std::size_t offset) {
  Scanner scanner(list, source, offset);
  std::vector<double> numbers;
  scanner.skip_blanks();
  while (!scanner.done()) {
    numbers.push_back(scanner.number());
    scanner.skip_separator();
  }
  if (scanner.after_comma()) scanner.refuse("ends with a comma; remove it");
  return numbers;
}

Read read_path_data(std::string_view text, const std::string& name) {
  Read read;
  const Source source{text, name};
  Path path(read, "0", {}, name);
  draw(text, source, 0, path);
  return read;
}

}  // namespace bezierbench::curves
