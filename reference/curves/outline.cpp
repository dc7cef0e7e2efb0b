// SPDX-License-Identifier: MIT
#include "reference/curves/outline.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "reference/curves/big_endian.hpp"

namespace bezierbench::curves {
namespace {

constexpr std::size_t most_steps = 10 * most_curves;  // a second, about

bool coincide(Coordinates a, Coordinates b) { return a.x == b.x && a.y == b.y; }

}  // namespace

void Outline::begin_glyph(std::string id) {
  close();
  glyph_ = std::move(id);
  contours_ = 0;
}

void Outline::move_to(Coordinates to) {
  close();
  start_ = last_ = to;
  segments_ = 0;
  ++contours_;
  is_open_ = true;
}

void Outline::line_to(Coordinates to) {
  if (!coincide(last_, to)) return add(std::array{last_, to});
  if (lines_left_out_ == nullptr) lines_left_out_ = &read_->left_out["lines of zero length"];
  ++*lines_left_out_;
}

void Outline::quadratic_to(Coordinates control, Coordinates to) { add(std::array{last_, control, to}); }

void Outline::cubic_to(Coordinates first, Coordinates second, Coordinates to) {
  add(std::array{last_, first, second, to});
}

void Outline::close() {
  if (is_open_ && !coincide(last_, start_)) add(std::array{last_, start_});
  is_open_ = false;
}

void Outline::spend(std::size_t steps) {
  steps_ += steps;
  if (steps_ > most_steps) throw Malformed(fmt::format("its glyphs take more than {} steps", most_steps));
}

void Outline::add(std::span<const Coordinates> points) {
  if (read_->set.size() == most_curves) throw Malformed(fmt::format("the font has more than {} curves", most_curves));
  std::array<double, 8> numbers;
  std::size_t count = 0;
  for (const auto& [x, y] : points) {
    if (!std::isfinite(x) || !std::isfinite(y)) throw Malformed("a coordinate is too large");
    numbers[count++] = x + 0.0;  // no negative zeros
    numbers[count++] = y + 0.0;
  }
  read_->set.add(fmt::format("{}:{}:{}", glyph_, contours_ - 1, segments_),
                 {.degree = static_cast<int>(points.size()) - 1, .coefficients = std::span(numbers).first(count)},
                 segments_ == 0);
  ++segments_;
  last_ = points.back();
}

}  // namespace bezierbench::curves
