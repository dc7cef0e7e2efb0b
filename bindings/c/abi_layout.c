/* SPDX-License-Identifier: MIT */
/* Prints what programs compiled with the header have built in: sizes and members of structs, values of constants. */
#include <bezierbench/bezierbench.h>
#include <stdio.h>

#define STRUCT(type) printf("struct %s size %zu\n", #type, sizeof(type))
#define MEMBER(type, member) \
  printf("member %s.%s at %zu size %zu\n", #type, #member, offsetof(type, member), sizeof(((type*)0)->member))
#define VALUE(name) printf("value %s = %d\n", #name, (int)(name))

int main(void) {
  STRUCT(bb_curve);
  MEMBER(bb_curve, form);
  MEMBER(bb_curve, dimension);
  MEMBER(bb_curve, degree);
  MEMBER(bb_curve, points);
  MEMBER(bb_curve, weights);
  STRUCT(bb_method);
  MEMBER(bb_method, id);
  MEMBER(bb_method, label);
  MEMBER(bb_method, problem);
  MEMBER(bb_method, bound);
  MEMBER(bb_method, flops);
  MEMBER(bb_method, citation);
  MEMBER(bb_method, form);
  MEMBER(bb_method, min_degree);
  MEMBER(bb_method, max_degree);
  MEMBER(bb_method, max_degree_float);
  MEMBER(bb_method, unit_interval_only);
  MEMBER(bb_method, bit_stable);
  STRUCT(bb_error);
  MEMBER(bb_error, exact);
  MEMBER(bb_error, error);
  MEMBER(bb_error, error_ulp);
  MEMBER(bb_error, error_u);
  STRUCT(bb_bound);
  MEMBER(bb_bound, bound);
  MEMBER(bb_bound, bound_u);
  STRUCT(bb_length);
  MEMBER(bb_length, length);
  MEMBER(bb_length, error_estimate);
  MEMBER(bb_length, evaluations);
  MEMBER(bb_length, converged);
  STRUCT(bb_parameter);
  MEMBER(bb_parameter, t);
  MEMBER(bb_parameter, error_estimate);
  MEMBER(bb_parameter, iterations);
  MEMBER(bb_parameter, converged);
  STRUCT(bb_half);
  MEMBER(bb_half, points);
  MEMBER(bb_half, weights);
  STRUCT(bb_bspline);
  MEMBER(bb_bspline, dimension);
  MEMBER(bb_bspline, degree);
  MEMBER(bb_bspline, count);
  MEMBER(bb_bspline, points);
  MEMBER(bb_bspline, weights);
  MEMBER(bb_bspline, knots);
  STRUCT(bb_foot);
  MEMBER(bb_foot, t);
  MEMBER(bb_foot, distance);
  MEMBER(bb_foot, candidates);
  MEMBER(bb_foot, converged);
  STRUCT(bb_strides);
  MEMBER(bb_strides, curve);
  MEMBER(bb_strides, point);
  MEMBER(bb_strides, axis);
  STRUCT(bb_batch);
  MEMBER(bb_batch, form);
  MEMBER(bb_batch, dimension);
  MEMBER(bb_batch, degree);
  MEMBER(bb_batch, curves);
  MEMBER(bb_batch, count);
  MEMBER(bb_batch, points);
  MEMBER(bb_batch, t);
  MEMBER(bb_batch, out);
  STRUCT(bb_spline);
  MEMBER(bb_spline, parameters);
  MEMBER(bb_spline, ends);
  MEMBER(bb_spline, monotone);
  MEMBER(bb_spline, start_derivative);
  MEMBER(bb_spline, end_derivative);
  VALUE(BB_OK);
  VALUE(BB_ERROR_NULL);
  VALUE(BB_ERROR_METHOD);
  VALUE(BB_ERROR_FORM);
  VALUE(BB_ERROR_DIMENSION);
  VALUE(BB_ERROR_DEGREE);
  VALUE(BB_ERROR_NOT_FINITE);
  VALUE(BB_ERROR_PARAMETER);
  VALUE(BB_ERROR_TOLERANCE);
  VALUE(BB_ERROR_NO_POINT);
  VALUE(BB_ERROR_NO_BOUND);
  VALUE(BB_ERROR_NOT_CERTAIN);
  VALUE(BB_ERROR_OVERFLOW);
  VALUE(BB_ERROR_ENVIRONMENT);
  VALUE(BB_ERROR_MEMORY);
  VALUE(BB_ERROR_COUNT);
  VALUE(BB_ERROR_INTERNAL);
  VALUE(BB_ERROR_STOPPED);
  VALUE(BB_ERROR_REPEATED);
  VALUE(BB_ERROR_FILE);
  VALUE(BB_BERNSTEIN);
  VALUE(BB_POWER);
  VALUE(BB_RATIONAL);
  VALUE(BB_ROOTS_OF_VALUE);
  VALUE(BB_ROOTS_OF_DERIVATIVE);
  VALUE(BB_ROOTS_OF_CURVATURE);
  VALUE(BB_CENTRIPETAL);
  VALUE(BB_UNIFORM);
  VALUE(BB_CHORD);
  VALUE(BB_NATURAL);
  VALUE(BB_CLAMPED);
  VALUE(BB_NOT_A_KNOT);
  VALUE(BB_CLOSED);
  return 0;
}
