// SPDX-License-Identifier: MIT
// A cell: one value of each axis of a study that decides which inputs are drawn.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/suite/suite.hpp"

namespace bezierbench::sample {

class CurveSlice;

/// The scalar type and the methods are not part of a cell: all of them get the same inputs.
struct Cell {
  Form form = Form::bernstein;
  int dimension = 2;
  int degree = 0;
  double coordinate_range = 1;
  suite::Interval t_interval;
  std::string generator = "continuous";
  std::shared_ptr<const CurveSlice> slice =
      {};  ///< where the inputs are those of a curve set; the range is then theirs
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// `curve=bezier;dimension=2;degree=4;coordinate_range=1e+06;t_interval=0:1;generator=continuous`, numbers in shortest
/// decimal: the identity of the cell. Other axes of the study are not part of it.
std::string canonical(const Cell& cell);

/// 64-bit FNV-1a of canonical(cell): the second word of the Philox counter.
std::uint64_t key(const Cell& cell);

/// 64-bit FNV-1a of a study id: the first word of the Philox counter.
std::uint64_t key(std::string_view study_id);

/// The cells of a study, the cross product of its axes; outermost first: dimension, degree, coordinate range,
/// t interval, generator. A study with a slice has one cell.
std::vector<Cell> cells(const suite::Study& study);

}  // namespace bezierbench::sample
