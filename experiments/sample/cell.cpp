// SPDX-License-Identifier: MIT
#include "experiments/sample/cell.hpp"

#include <fmt/format.h>

#include "experiments/sample/curve_slice.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::sample {

namespace {

// Other words would draw other inputs: those for the forms are not those of suites and tables.
std::string_view word_in_key(Form form) {
  return form == Form::bernstein ? "bezier" : form == Form::power ? "polynomial" : "rational";
}

}  // namespace

std::string canonical(const Cell& cell) {
  if (cell.slice) return cell.slice->canonical();
  return fmt::format("curve={};dimension={};degree={};coordinate_range={};t_interval={}:{};generator={}",
                     word_in_key(cell.form), cell.dimension, cell.degree, number::decimal(cell.coordinate_range),
                     number::decimal(cell.t_interval.min), number::decimal(cell.t_interval.max), cell.generator);
}

std::uint64_t key(const Cell& cell) { return key(std::string_view(canonical(cell))); }

std::uint64_t key(std::string_view study_id) {
  // Fowler, Noll, Vo: offset basis and prime of FNV-1a for 64 bits (RFC 9923).
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : study_id) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

std::vector<Cell> cells(const suite::Study& study) {
  if (study.slice)
    return {{study.form, study.dimension.front(), study.degree.front(), study.slice->range(), suite::Interval{}, "",
             study.slice}};
  std::vector<Cell> all;
  for (const int dimension : study.dimension) {
    for (const int degree : study.degree) {
      for (const double range : study.coordinate_range) {
        for (const suite::Interval& t : study.t_interval) {
          for (const std::string& generator : study.generator) {
            all.push_back({study.form, dimension, degree, range, t, generator, {}});
          }
        }
      }
    }
  }
  return all;
}

}  // namespace bezierbench::sample
