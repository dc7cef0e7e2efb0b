// SPDX-License-Identifier: MIT
// Many curves, each with its id, form, degree and dimension: what a file of curves holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::curves {

/// Curves in the order of their file. Numbers are stored in one array, so that a set of ten million segments fits.
class CurveSet {
 public:
  /// Appends a curve. `parameters` are values of t that the file states for it. A curve that begins a path is not joined
  /// to the one before it.
  void add(std::string_view id, const CurveView<double>& curve, bool begins_path = true,
           std::span<const double> parameters = {});

  [[nodiscard]] std::size_t size() const { return curves_.size(); }
  [[nodiscard]] bool empty() const { return curves_.empty(); }

  /// Curve number k; the view is valid until a curve is added.
  [[nodiscard]] CurveView<double> operator[](std::size_t k) const;
  [[nodiscard]] std::string_view id(std::size_t k) const;
  [[nodiscard]] std::span<const double> parameters(std::size_t k) const;
  /// Whether curve k is the first segment of its path. A path is a sequence of segments that the file joins; the end of
  /// each is the start of the next.
  [[nodiscard]] bool begins_path(std::size_t k) const { return curves_[k].begins_path; }

  /// Whether `curve` continues the path of the last curve of the set, where only their ids say so: it starts at
  /// the point where that one ends, and the ids are equal except for a number at the end that grows by one (3 after 2,
  /// logo:0:3 after logo:0:2). Curves in power form have no such ends.
  [[nodiscard]] bool continues_path(std::string_view id, const CurveView<double>& curve) const;

  /// The curve with this id, or else with this number from 0; size() where there is none.
  [[nodiscard]] std::size_t find(std::string_view id_or_number) const;

  /// The numbers of the set as bytes, equal on every machine: form, dimension, degree, coefficients, weights and
  /// parameters of every curve in order. Sets with the same bytes give the same results, whatever their ids.
  [[nodiscard]] std::string canonical_bytes() const;

 private:
  struct Entry {
    std::uint64_t numbers;  ///< where its coefficients begin; weights and parameters follow
    std::uint64_t id;       ///< where its id begins
    std::uint32_t id_size;
    std::uint16_t degree;
    std::uint16_t parameters;
    Form form;
    std::uint8_t dimension;
    bool begins_path;
  };

  std::vector<Entry> curves_;
  std::vector<double> numbers_;
  std::string ids_;
};

}  // namespace bezierbench::curves
