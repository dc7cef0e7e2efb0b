// SPDX-License-Identifier: MIT
// Path data by the grammar of [SVG 2, section 9.3], as curves: lines (degree 1), quadratics, cubics, and elliptic arcs
// as rational quadratics, each at most a quarter of its ellipse.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "reference/curves/read.hpp"

namespace bezierbench::curves {

using PlanePoint = std::array<double, 2>;

/// The map (x, y) -> (a x + c y + e, b x + d y + f), as `matrix(a b c d e f)` of SVG.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  /// The identity leaves every bit.
  [[nodiscard]] PlanePoint operator()(const PlanePoint& p) const;
  /// The map `inner`, then this one.
  [[nodiscard]] Affine operator*(const Affine& inner) const;
  friend bool operator==(const Affine&, const Affine&) = default;
};

/// cos and sin of an angle in degrees; exact at multiples of 90, elsewhere rounded from long double.
PlanePoint direction_of(double degrees);

/// Adds the segments of one path to a set, as they are drawn. Their ids are `NAME:SUBPATH:SEGMENT`, both counted from
/// 0.
class Path {
 public:
  /// `to` receives the curves after `map`. `file` is named in messages.
  Path(Read& to, std::string name, const Affine& map, std::string file)
      : to_(to), name_(std::move(name)), map_(map), file_(std::move(file)) {}

  void move_to(const PlanePoint& p);
  void line_to(const PlanePoint& p);
  void quadratic_to(const PlanePoint& control, const PlanePoint& p);
  void cubic_to(const PlanePoint& first, const PlanePoint& second, const PlanePoint& p);
  /// A rational quadratic with the weights 1, `weight`, 1.
  void conic_to(const PlanePoint& control, double weight, const PlanePoint& p);
  /// An elliptic arc, see [SVG 2, section 9.5.1]. It is a line where a radius is 0, and nothing where it ends at its
  /// start. Radii too small to reach the end are scaled up until they do: the arc is then half an ellipse, as it is
  /// where rounding hides whether the chord is a diameter.
  void arc_to(const PlanePoint& radii, double degrees, bool large, bool sweep, const PlanePoint& p);
  /// A line back to the start of the subpath; left out, and counted, where that is the current point.
  void close();

  [[nodiscard]] const PlanePoint& current() const { return current_; }

 private:
  void add(std::span<const PlanePoint> points, std::span<const double> weights);

  Read& to_;
  std::string name_;
  Affine map_;
  std::string file_;
  PlanePoint start_{};
  PlanePoint current_{};
  std::size_t subpath_ = 0;
  std::size_t segment_ = 0;
};

/// Adds the segments of path data to `path`. `offset` is where the data begin in `source`, for messages. Throws
/// Unreadable where the data do not follow the grammar.
void draw(std::string_view data, const Source& source, std::size_t offset, Path& path);

/// Reads a list of numbers as in the attribute `points`, in the grammar of path data. Throws likewise.
std::vector<double> numbers_of(std::string_view list, const Source& source, std::size_t offset);

/// Reads a text that is path data and nothing else; the ids of its segments begin with 0, the number of the path.
Read read_path_data(std::string_view text, const std::string& name);

}  // namespace bezierbench::curves
