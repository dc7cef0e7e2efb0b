// SPDX-License-Identifier: MIT
#include "reference/length/true_length.hpp"

#include <cmath>
#include <limits>

namespace bezierbench::reference {

TrueLength::TrueLength(const CurveView<double>& curve, double from, double to) {
  if (from == to) return;
  const auto h = hodograph<LongReal>(curve, from, to);
  if (h.polygon() == 0) return;
  const LengthPanels<LongReal> integral(h);
  const LongReal width = LongReal(to) - LongReal(from);
  value_ = width * integral.length();
  uncertainty_ = width * integral.uncertainty();
  require_certain(value_, uncertainty_);
}

std::string TrueLength::decimal(int digits) const { return value_.str(digits, std::ios_base::fmtflags{}); }

double TrueLength::error_of(double length) const {
  if (!std::isfinite(length)) return std::numeric_limits<double>::infinity();
  const LongReal error = abs(LongReal(length) - value_);
  return error <= uncertainty_ ? 0 : error.convert_to<double>();
}

}  // namespace bezierbench::reference
