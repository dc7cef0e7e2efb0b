// SPDX-License-Identifier: MIT
// A curve whose parameter is many lanes: its coefficients stay scalars in memory and are copied to all lanes when they
// are read.
#pragma once

#include "core/batch/lanes.hpp"
#include "core/batch/target_table.hpp"
#include "core/evaluate/methods/de_casteljau_fixed_point.hpp"
#include "core/evaluate/methods/direct.hpp"
#include "core/evaluate/methods/wozny_chudy_rational.hpp"
#include "core/evaluate/schemes/barycentric.hpp"
#include "core/evaluate/schemes/correctly_rounded_pair.hpp"
#include "core/evaluate/schemes/nearer_end.hpp"

namespace bezierbench {

/// A view of one curve; coefficient i of an axis is at first[i * DimensionT + axis].
template <Form F, class S, int Count, int DimensionT, int DegreeT>
class Curve<F, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> {
 public:
  using Scalar = batch::HWY_NAMESPACE::Lanes<S, Count>;
  static constexpr Form form = F;
  static constexpr int dimension = DimensionT;
  static constexpr int fixed_degree = dynamic;

  HWY_INLINE Curve(const S* first, int degree) : first_(first), degree_(degree) {}

  [[nodiscard]] HWY_INLINE int degree() const { return degree_; }
  [[nodiscard]] HWY_INLINE Scalar operator()(int axis, int i) const {
    return Scalar(first_[static_cast<std::ptrdiff_t>(i) * DimensionT + axis]);
  }

 private:
  const S* first_;
  int degree_;
};

template <class S, int Count, int DimensionT, int DegreeT>
struct Curve<Form::power_double_double, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> {
  using Part = Curve<Form::power, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT>;

  [[nodiscard]] HWY_INLINE int degree() const { return high.degree(); }

  Part high;
  Part low;
};

namespace batch::HWY_NAMESPACE {

/// A view of one value per coefficient.
template <class S, int Count>
class Row {
 public:
  HWY_INLINE explicit Row(const S* first) : first_(first) {}
  [[nodiscard]] HWY_INLINE Lanes<S, Count> operator[](int i) const { return Lanes<S, Count>(first_[i]); }

 private:
  const S* first_;
};

}  // namespace batch::HWY_NAMESPACE

template <class S, int Count, int DimensionT, int DegreeT>
struct Curve<Form::rational, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> {
  HWY_INLINE explicit Curve(const batch::Parts<S>& parts) : points(parts.first, parts.degree), weights(parts.second) {}

  [[nodiscard]] HWY_INLINE int degree() const { return points.degree(); }

  Curve<Form::bernstein, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> points;
  batch::HWY_NAMESPACE::Row<S, Count> weights;
};

// What methods prepare that is more than a curve, for lanes: views of the arrays in the order of batch::Parts.

template <class S, int Count, int DimensionT, int DegreeT>
struct Direct::Prepared<batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> {
  HWY_INLINE explicit Prepared(const batch::Parts<S>& parts)
      : curve(parts.first, parts.degree), binomial(parts.second) {}

  Curve<Form::bernstein, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> curve;
  batch::HWY_NAMESPACE::Row<S, Count> binomial;
};

template <class S, int Count, int DimensionT, int DegreeT>
struct WoznyChudyRational::Prepared<batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> {
  HWY_INLINE explicit Prepared(const batch::Parts<S>& parts)
      : points(parts.first, parts.degree), ratios(parts.second) {}

  Curve<Form::bernstein, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> points;
  batch::HWY_NAMESPACE::Row<S, Count> ratios;
};

template <class S, int Count, int DimensionT, int DegreeT>
struct Barycentric<batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> {
  HWY_INLINE explicit Barycentric(const batch::Parts<S>& parts)
      : nodes(parts.second), weights(parts.third), values(parts.first, parts.degree) {}

  batch::HWY_NAMESPACE::Row<S, Count> nodes;
  batch::HWY_NAMESPACE::Row<S, Count> weights;
  Curve<Form::bernstein, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> values;
};

template <class S, int Count, int DimensionT>
class FixedPointFrame<batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT> {
 public:
  HWY_INLINE explicit FixedPointFrame(const S* first) : first_(first) {}
  [[nodiscard]] HWY_INLINE batch::HWY_NAMESPACE::Lanes<S, Count> operator()(int axis, FixedPointValue value) const {
    return batch::HWY_NAMESPACE::Lanes<S, Count>(
        first_[static_cast<int>(value) * FixedPointFrame<S, DimensionT>::stride + axis]);
  }

 private:
  const S* first_;
};

template <class S, int Count, int DimensionT, int DegreeT>
struct DeCasteljauFixedPoint::Prepared<batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> {
  HWY_INLINE explicit Prepared(const batch::Parts<S>& parts) : fixed(parts.first, parts.degree), frame(parts.second) {}

  Curve<Form::bernstein, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, DegreeT> fixed;
  FixedPointFrame<batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT> frame;
};

/// What `correctly_rounded` prepares, for lanes; those that are left undecided are settled one by one.
template <Form F, class S, int Count, int DimensionT>
struct RoundedState<F, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, dynamic> {
  using Coefficients = Curve<F, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, dynamic>;

  HWY_INLINE explicit RoundedState(const batch::Parts<S>& parts)
      : scaled(parts.first, parts.degree), lost(parts.second, parts.degree), rounding(parts.rounding), parts_(parts) {}

  [[nodiscard]] HWY_INLINE AxisState<S> axis(int a) const {
    const int n = parts_.degree;
    return {{parts_.first + a, DimensionT, n},
            {parts_.second + a, DimensionT, n},
            {parts_.third + a, DimensionT, n},
            rounding[a]};
  }

  Coefficients scaled;
  Coefficients lost;
  const AxisRounding<S>* rounding;

 private:
  const batch::Parts<S>& parts_;
};

namespace batch::HWY_NAMESPACE {

/// The control points of one curve, or of many curves, which lie side by side in the arrays of a Curve.
template <class S, int Count, Curves Which, int Dimension, int Degree>
using ControlPoints = Curve<Form::bernstein, Lanes<S, Count, Which>, Dimension, Degree>;

/// In each lane the coefficients of one of two curves.
template <Form F, class L, int Dimension, int Degree>
class Chosen {
 public:
  using Scalar = L;
  static constexpr int dimension = Dimension;
  static constexpr int fixed_degree = dynamic;
  using Either = Curve<F, L, Dimension, Degree>;

  HWY_INLINE Chosen(const typename L::Mask& is_first, const Either& first, const Either& second)
      : is_first_(is_first), first_(first), second_(second) {}

  [[nodiscard]] HWY_INLINE int degree() const { return first_.degree(); }
  [[nodiscard]] HWY_INLINE L operator()(int axis, int i) const {
    return select(is_first_, first_(axis, i), second_(axis, i));
  }

 private:
  typename L::Mask is_first_;
  const Either& first_;
  const Either& second_;
};

}  // namespace batch::HWY_NAMESPACE

/// The template argument `Degree` of a curve that is one of two, of a degree that is known at run time.
inline constexpr int one_of_two = -3;

template <Form F, class S, int Count, int DimensionT>
class Curve<F, batch::HWY_NAMESPACE::Lanes<S, Count, batch::HWY_NAMESPACE::Curves::one>, DimensionT, one_of_two>
    : public batch::HWY_NAMESPACE::Chosen<F, batch::HWY_NAMESPACE::Lanes<S, Count>, DimensionT, dynamic> {
 public:
  using Curve::Chosen::Chosen;
};
template <Form F, class S, int Count, int DimensionT>
class Curve<F, batch::HWY_NAMESPACE::Lanes<S, Count, batch::HWY_NAMESPACE::Curves::each>, DimensionT, one_of_two>
    : public batch::HWY_NAMESPACE::Chosen<F, batch::HWY_NAMESPACE::Lanes<S, Count, batch::HWY_NAMESPACE::Curves::each>,
                                          DimensionT, dynamic> {
 public:
  using Curve::Chosen::Chosen;
};

namespace batch::HWY_NAMESPACE {

template <Form F, class S, int Count, Curves Which, int Dimension, int Degree>
HWY_INLINE Curve<F, Lanes<S, Count, Which>, Dimension, one_of_two> chosen(
    const LaneMask<S, Count>& is_first, const Curve<F, Lanes<S, Count, Which>, Dimension, Degree>& first,
    const Curve<F, Lanes<S, Count, Which>, Dimension, Degree>& second) {
  return {is_first, first, second};
}

}  // namespace batch::HWY_NAMESPACE
}  // namespace bezierbench
