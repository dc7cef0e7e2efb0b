// SPDX-License-Identifier: MIT
// Boost.Math: bezier_polynomial.
//
// Computes: de Casteljau's triangle with (1-t) a + t b.
// Fails: its scratch belongs to the thread, not to the curve. Another thread than the one that built a curve has no
// scratch for it, and after a curve of higher degree the scratch is too large: version 1.81 reduces as many points as
// the scratch holds. The adapter corrects both by setting the size of the scratch before each point.
#include <array>
#include <boost/math/interpolators/bezier_polynomial.hpp>
#include <utility>
#include <vector>

#include "experiments/peers/adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

struct BoostBezier {
  static constexpr MethodInfo info{.id = "peer_boost_bezier",
                                   .label = "Boost bezier_polynomial",
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .bit_stable = false,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "4d n(n+1)/2",
                                   .cost_exponent = 2,
                                   .citation = "Boost.Math, interpolators::bezier_polynomial"};

  template <int Dimension>
  using ControlPoints = std::vector<std::array<double, Dimension>>;
  template <int Dimension>
  using Prepared = boost::math::interpolators::bezier_polynomial<ControlPoints<Dimension>>;

  template <int Dimension>
  static Prepared<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve) {
    ControlPoints<Dimension> points(static_cast<std::size_t>(curve.degree()) + 1);
    for (int i = 0; i <= curve.degree(); ++i)
      for (int axis = 0; axis < Dimension; ++axis)
        points[static_cast<std::size_t>(i)][static_cast<std::size_t>(axis)] = curve(axis, i);
    return Prepared<Dimension>(std::move(points));
  }

  template <std::size_t Dimension>
  static Point<double, static_cast<int>(Dimension)> evaluate(
      const boost::math::interpolators::bezier_polynomial<std::vector<std::array<double, Dimension>>>& curve,
      double t) {
    using Points = std::vector<std::array<double, Dimension>>;
    boost::math::interpolators::detail::get_bezier_storage<Points>().resize(curve.control_points().size() - 1);
    const std::array<double, Dimension> point = curve(t);
    return Eigen::Map<const Point<double, static_cast<int>(Dimension)>>(point.data());
  }
};

}  // namespace

std::span<const Kernel<double>> peer_boost_bezier(int dimension) { return kernels_of<BoostBezier>(dimension); }

}  // namespace bezierbench::peers
