// SPDX-License-Identifier: MIT
#include "experiments/compare/ratio.hpp"

#include <cmath>
#include <limits>

namespace bezierbench::compare {
namespace {

/// A product and quotient of independent estimates: its median, and the squared distances to its limits on the log
/// scale.
class Product {
 public:
  void multiply(const metric::Interval& x) {
    median_ *= x.median;
    below_ += square(distance(x.low, x.median));
    above_ += square(distance(x.median, x.high));
  }
  void divide(const metric::Interval& x) {
    median_ /= x.median;
    below_ += square(distance(x.median, x.high));
    above_ += square(distance(x.low, x.median));
  }
  [[nodiscard]] metric::Interval interval() const {
    return {median_, median_ * std::exp(-std::sqrt(below_)), median_ * std::exp(std::sqrt(above_))};
  }

 private:
  static double square(double x) { return x * x; }
  static double distance(double low, double high) {
    return low > 0 && low <= high ? std::log(high / low) : std::numeric_limits<double>::quiet_NaN();
  }

  double median_ = 1;
  double below_ = 0;
  double above_ = 0;
};

}  // namespace

metric::Interval ratio(const metric::Interval& b, const metric::Interval& a) {
  Product product;
  product.multiply(b);
  product.divide(a);
  return product.interval();
}

metric::Interval ratio_in_units(const metric::Interval& b, const metric::Interval& b_unit, const metric::Interval& a,
                                const metric::Interval& a_unit) {
  Product product;
  product.multiply(b);
  product.divide(b_unit);
  product.divide(a);
  product.multiply(a_unit);
  return product.interval();
}

}  // namespace bezierbench::compare
