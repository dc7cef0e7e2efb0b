/* SPDX-License-Identifier: MIT */
/*
 * bezierbench in C: Bezier evaluators by name, the exact reference, and errors and bounds of what was computed.
 *
 * Every function that returns int returns BB_OK or another bb_status, and writes its results only where that is BB_OK.
 * Points are written coordinate by coordinate: x0 y0 x1 y1 ... in the plane; results likewise, in the order of t. A
 * dimension is 1, 2 or 3; in double, bb_evaluate, bb_exact, bb_curve_evaluate, bb_curve_exact, bb_split, bb_part and
 * bb_elevate also take 4 and 5. A degree is 0 to 1023; coordinates, weights and parameters are finite. Results must not
 * overlap what is read. An evaluation takes at most 0.7 MiB of the thread's stack.
 *
 * All functions may be called by several threads at once, also with one bb_prepared, bb_fitted, bb_curves or
 * bb_bspline_made, as long as none frees it. Methods and reference compute in IEEE 754 arithmetic to nearest: in another rounding mode, or where subnormal
 * numbers are flushed to zero, a function returns BB_ERROR_ENVIRONMENT. Floating-point exception flags and traps of the
 * caller are left as they were. No C++ exception leaves the library; exhausted memory is BB_ERROR_MEMORY, except in big
 * integers of the reference, where GMP ends the process unless the caller gave it functions of its own.
 */
#ifndef BEZIERBENCH_BEZIERBENCH_H
#define BEZIERBENCH_BEZIERBENCH_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define BB_API __attribute__((visibility("default")))
#else
#define BB_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What a function returns. Values keep their meaning; later versions may add some. */
typedef enum bb_status {
  BB_OK = 0,
  BB_ERROR_NULL = 1,         /* a pointer is null that must not be */
  BB_ERROR_METHOD = 2,       /* no method for this problem has this id */
  BB_ERROR_FORM = 3,         /* no such form, or not one that the method or the function takes */
  BB_ERROR_DIMENSION = 4,    /* not one that the function takes */
  BB_ERROR_DEGREE = 5,       /* below 0, above 1023, or not one that the method takes */
  BB_ERROR_NOT_FINITE = 6,   /* a coordinate, weight or parameter is NaN or infinite */
  BB_ERROR_PARAMETER = 7,    /* a parameter is outside of the domain of the method or the function */
  BB_ERROR_TOLERANCE = 8,    /* a tolerance is out of range */
  BB_ERROR_NO_POINT = 9,     /* the weights of the rational curve sum to zero there */
  BB_ERROR_NO_BOUND = 10,    /* the method has no proved bound */
  BB_ERROR_NOT_CERTAIN = 11, /* the true length is not certain to 30 digits */
  BB_ERROR_OVERFLOW = 12,    /* a control point of the result exceeds the largest double */
  BB_ERROR_ENVIRONMENT = 13, /* the thread does not round to nearest, or flushes subnormal numbers */
  BB_ERROR_MEMORY = 14,      /* memory is exhausted */
  BB_ERROR_COUNT = 15,       /* too few points, an index beyond the end, or a buffer that is too small */
  BB_ERROR_INTERNAL = 16,    /* a defect of this library */
  BB_ERROR_STOPPED = 17,     /* the computation was stopped: see bb_stop_when() */
  BB_ERROR_REPEATED = 18,    /* a point repeats the one before it, so that a parameter takes no step */
  BB_ERROR_FILE = 19         /* a file cannot be read, or breaks a rule of its kind */
} bb_status;

/* The forms in which a curve can be given. */
typedef enum bb_form {
  BB_BERNSTEIN = 0, /* sum b_i B_i(t): control points */
  BB_POWER = 1,     /* sum q_j t^j: coefficients, ascending */
  BB_RATIONAL = 2   /* sum w_i b_i B_i(t) / sum w_i B_i(t): control points and weights */
} bb_form;

/* A curve, which owns nothing. */
typedef struct bb_curve {
  int form; /* a bb_form */
  int dimension;
  int degree;
  const double* points;  /* (degree + 1) * dimension values, not premultiplied by weights */
  const double* weights; /* degree + 1 values, not all of them 0, for BB_RATIONAL; otherwise null */
} bb_curve;

/* ---- The library ---- */

/* The version of the library: 65536 * major + 256 * minor + patch. */
BB_API unsigned bb_version(void);

/* A sentence for a bb_status; static, never null. */
BB_API const char* bb_strerror(int status);

/* True lengths and feet take minutes at degrees of several hundred. While *flag is not 0, those that this thread computes
 * end with BB_ERROR_STOPPED, within a tenth of a second or so; another thread or a handler of a signal sets it. The flag
 * is looked at until this thread names another one, or null for none. */
BB_API void bb_stop_when(const volatile int* flag);

/* ---- Methods ---- */

/* What is known of a method. Strings are static. Several methods have one id where they solve one problem for curves
 * that are given in different forms. */
typedef struct bb_method {
  const char* id;         /* for example "de_casteljau" */
  const char* label;      /* for people */
  const char* problem;    /* "evaluation", "derivative", "grid", "subdivision", "arc_length", "inverse_arc_length",
                             "projection", "fitting", "flattening", "bounds", "easing" or "bspline" */
  const char* bound;      /* the proved bound in words; empty where there is none */
  const char* flops;      /* per point, in the degree n and the dimension d */
  const char* citation;   /* the source of the method */
  int form;               /* a bb_form: what the method takes */
  int min_degree;         /* the degrees that it takes */
  int max_degree;         /* in double */
  int max_degree_float;   /* in float */
  int unit_interval_only; /* 1 where t outside of [0,1] is outside of its domain */
  int bit_stable;         /* 0 where the C library decides the last bits */
} bb_method;

/* The number of methods, and method number `index` of them. */
BB_API size_t bb_method_count(void);
BB_API int bb_method_at(size_t index, bb_method* method);

/* The evaluator that a null `method` stands for in the functions below, bb_prepare and the bounds: that of the C++ function
   evaluate(), for curves of this bb_form and degree, in float where `is_float` is not 0. Null for arguments that no curve
   has. */
BB_API const char* bb_recommended(int form, int degree, int is_float);

/* ---- Points of a Bezier curve ---- */

/* The points at t[0] to t[count - 1] by a method, and the true points, each coordinate rounded once. From 16 points on most
 * methods evaluate several of them in every instruction, with the extensions that the processor has; the bits are the same. */
BB_API int bb_evaluate(const char* method, int dimension, int degree, const double* points, const double* t,
                       size_t count, double* out);
BB_API int bb_exact(int dimension, int degree, const double* points, const double* t, size_t count, double* out);

/* The same in float; the true points are those of the float coordinates, rounded to float. */
BB_API int bb_evaluate_float(const char* method, int dimension, int degree, const float* points, const float* t,
                             size_t count, float* out);
BB_API int bb_exact_float(int dimension, int degree, const float* points, const float* t, size_t count, float* out);

/* ---- Points of a curve in any form ---- */

BB_API int bb_curve_evaluate(const char* method, const bb_curve* curve, const double* t, size_t count, double* out);
BB_API int bb_curve_exact(const bb_curve* curve, const double* t, size_t count, double* out);

/* A curve as a method prepared it, for many calls. It is independent of the arrays that it was made from. */
typedef struct bb_prepared bb_prepared;
BB_API int bb_prepare(const char* method, const bb_curve* curve, bb_prepared** prepared);
BB_API int bb_prepared_evaluate(const bb_prepared* prepared, const double* t, size_t count, double* out);
BB_API void bb_prepared_free(bb_prepared* prepared); /* null is allowed */

/* ---- Points of many curves in one call ---- */

/* How many numbers apart in an array two curves, two points (or parameters) of a curve, and two axes are. A step of 0 means
 * that all share one number. */
typedef struct bb_strides {
  ptrdiff_t curve;
  ptrdiff_t point;
  ptrdiff_t axis;
} bb_strides;

/* Curves of one form, dimension and degree, each at `count` parameters of its own. Null strides mean an array of structures:
 * curve after curve, in it point after point, in it axis after axis. {1, d * m, m} is a structure of arrays, of m numbers
 * each. */
typedef struct bb_batch {
  int form; /* a bb_form */
  int dimension;
  int degree;
  size_t curves;
  size_t count;
  const bb_strides* points;
  const bb_strides* t; /* its `axis` means nothing */
  const bb_strides* out;
} bb_batch;

/* The points of all curves, with the bits of bb_curve_evaluate; several curves go side by side. `weights` has degree + 1
 * values of each curve, curve after curve, for BB_RATIONAL, and is otherwise null. After the first call of a process no
 * memory is allocated, except by conversions in big integers. With one curve and out->point = 1 it writes one array for each
 * axis, as the kernels do, which for cubics saves a quarter of the time. */
BB_API int bb_evaluate_curves(const char* method, const bb_batch* batch, const double* points, const double* weights,
                              const double* t, double* out);
BB_API int bb_evaluate_curves_float(const char* method, const bb_batch* batch, const float* points,
                                    const float* weights, const float* t, float* out);

/* ---- Derivatives, points of a grid, chords, halves and boxes of a curve ---- */

/* The derivative of `order` >= 0 in t at t[0] to t[count - 1], `dimension` values each. Of a rational curve it is infinite
 * or not a number where the weights sum to zero, and for orders above 1023. */
BB_API int bb_derivative(const char* method, const bb_curve* curve, int order, const double* t, size_t count,
                         double* out);

/* The steps + 1 points at t = k / steps; `steps` is a power of two up to 524288. BB_ERROR_NO_POINT where a rational curve
 * has a pole in [0, 1]. */
BB_API int bb_grid(const char* method, const bb_curve* curve, int steps, double* out);

/* The curve as chords, none of which is farther than `tolerance` > 0 from its piece of the curve, as far as the method
 * promises. *ends becomes the number of their ends, one more than that of chords. Where this is at most `capacity`, the
 * parameters of the ends are written to `t` and their points, of `dimension` values each, to `points`; otherwise nothing
 * is, and both may be null for capacity 0. *complete becomes 0 where the method says that it did not keep the tolerance,
 * for example because it is finer than the roundings of coordinates, otherwise 1. BB_ERROR_NO_POINT where a rational
 * curve has a pole in [0, 1]. */
BB_API int bb_flatten(const char* method, const bb_curve* curve, double tolerance, double* t, double* points,
                      size_t capacity, size_t* ends, int* complete);

/* Where the control points of a half, a part or an elevated curve are written: (degree + 1) * dimension values, not
 * premultiplied, and degree + 1 weights for BB_RATIONAL, otherwise null. */
typedef struct bb_half {
  double* points;
  double* weights;
} bb_half;

/* Splits a curve with control points at t. The last point of the left half and the first of the right one are the point
 * at t. BB_ERROR_NO_POINT where a weight of a half would be 0. */
BB_API int bb_split(const char* method, const bb_curve* curve, double t, const bb_half* left, const bb_half* right);

/* The control points of the curve over t in [from, to], each coordinate the true one rounded once. `from` and `to` are finite,
 * may lie outside [0, 1], and may fall: from 1 to 0 is the reversed curve. Parts that meet share their end to the bit. The
 * time is cubic in the degree. BB_ERROR_NO_POINT where a weight would be 0. */
BB_API int bb_part(const bb_curve* curve, double from, double to, const bb_half* part);

/* The control points, degree + 1 of them, in a degree at least that of the curve, each coordinate rounded once.
 * BB_ERROR_NO_POINT likewise. */
BB_API int bb_elevate(const bb_curve* curve, int degree, const bb_half* elevated);

/* The lowest and the highest coordinate of each axis, 2 * dimension values, of a curve with control points over t in
 * [0, 1]. exact_box and split_box never leave a point of the curve outside; exact_box is the tightest box of doubles or
 * at most one double larger on each side. Weights of both signs give an infinite box. */
BB_API int bb_box(const char* method, const bb_curve* curve, double* out);

/* ---- Roots in [0, 1] ---- */

/* What bb_roots finds. */
typedef enum bb_roots_of {
  BB_ROOTS_OF_VALUE = 0,      /* where the coordinate `axis` is `value` */
  BB_ROOTS_OF_DERIVATIVE = 1, /* where its derivative is 0: extrema, with the ends only where they are stationary */
  BB_ROOTS_OF_CURVATURE = 2   /* where x'y'' = x''y' on a plane curve */
} bb_roots_of;

/* All true roots with their multiplicities, ascending, each rounded once; an odd multiplicity changes the sign.
 * Of BB_ROOTS_OF_CURVATURE it is an inflection at a point with a tangent, an even one a flat point; an ordinary cusp has 2. *count
 * becomes their number, SIZE_MAX where every t is one. Where this is at most `capacity` they are written; otherwise nothing
 * is, and both arrays may be null for capacity 0. A curve of degree n has at most n, 2n - 1 and 3n. `axis` and `value` mean
 * nothing where `of` does not name them. BB_ERROR_NO_POINT where a rational curve has a pole in [0, 1]. */
BB_API int bb_roots(const bb_curve* curve, int of, int axis, double value, double* t, int* multiplicities,
                    size_t capacity, size_t* count);

/* ---- True points without any rounding ---- */

/* The true coordinate `axis` of the point at t as text, "numerator" or "numerator/denominator" in lowest terms, with a
 * final zero. `required` (may be null) gets the bytes that this takes, also where the result is BB_ERROR_COUNT because
 * `size` bytes are too few. */
BB_API int bb_curve_exact_text(const bb_curve* curve, double t, int axis, char* text, size_t size, size_t* required);

/* ---- Errors and bounds ---- */

/* The error of one coordinate; infinite where the value is not finite. */
typedef struct bb_error {
  double exact;     /* the true value, rounded once */
  double error;     /* |value - true value|, rounded once */
  double error_ulp; /* over the spacing of doubles at the true value */
  double error_u;   /* over u p~, with u = 2^-53 and p~ = sum |b_i B_i(t)| on this axis; 0 for no error */
} bb_error;

/* A proved bound for the error of one coordinate; infinite where nothing is proved. */
typedef struct bb_bound {
  double bound;   /* in coordinate units */
  double bound_u; /* over u p~; infinite, too, where p~ is 0 */
} bb_bound;

/* Judges any values, one point for each t, from wherever they are; errors[k * dimension + axis]. */
BB_API int bb_curve_error(const bb_curve* curve, const double* t, size_t count, const double* values, bb_error* errors);

/* The bounds of a method for its points at each t; bounds[k * dimension + axis]. */
BB_API int bb_curve_bound(const char* method, const bb_curve* curve, const double* t, size_t count, bb_bound* bounds);

/* The same for the points of bb_evaluate_float, with u = 2^-24. */
BB_API int bb_bound_float(const char* method, int dimension, int degree, const float* points, const float* t,
                          size_t count, bb_bound* bounds);

/* ---- Arc length of a curve with control points (BB_BERNSTEIN or BB_RATIONAL) ---- */

typedef struct bb_length {
  double length;
  double error_estimate; /* of the method, absolute; NaN where it has none */
  int64_t evaluations;   /* of the speed or, for chords, of the curve */
  int converged;         /* 1 where error_estimate is at most tolerance times the length */
} bb_length;

/* The length between the parameters 0 <= from <= to <= 1, up to `tolerance` > 0 times that length. BB_ERROR_NO_POINT where
 * the weights of a rational curve sum to zero between them: its length is infinite. */
BB_API int bb_arc_length(const char* method, const bb_curve* curve, double from, double to, double tolerance,
                         bb_length* length);

/* The true length, rounded once, and the error |length - true length| of any `length`, rounded once: 0 where it is
 * within 1e-30 of the length. */
BB_API int bb_exact_arc_length(const bb_curve* curve, double from, double to, double* length);
BB_API int bb_arc_length_error(const bb_curve* curve, double from, double to, double length, double* error);

typedef struct bb_parameter {
  double t;
  double error_estimate; /* of the method, of the length up to t, absolute */
  int64_t iterations;
  int converged; /* 1 where error_estimate is at most tolerance times the length of the curve */
} bb_parameter;

/* The parameter at which the length from the beginning is `length`, up to `tolerance` > 0 times the length of the curve.
 * A length that exceeds that of the curve by no more than the tolerance, as a computed one may, is that of the curve.
 * BB_ERROR_NO_POINT where a rational curve has a pole in [0, 1]. */
BB_API int bb_at_length(const char* method, const bb_curve* curve, double length, double tolerance,
                        bb_parameter* found);

/* ---- Projection of a point on a curve with control points (BB_BERNSTEIN or BB_RATIONAL, degree at least 1) ----
 * BB_ERROR_NO_POINT where a rational curve has a pole in [0, 1]. */

typedef struct bb_foot {
  double t;        /* in [0,1] */
  double distance; /* from the point */
  int candidates;  /* parameters or pieces whose distances were compared */
  int converged;   /* 0 where the method gave up; the foot is the best that it found */
} bb_foot;

/* The nearest point of the curve to `point`, which has `dimension` coordinates. */
BB_API int bb_project(const char* method, const bb_curve* curve, const double* point, bb_foot* foot);

/* The true foot (of equally near ones the first) and its distance, each rounded once. */
BB_API int bb_exact_project(const bb_curve* curve, const double* point, double* t, double* distance);

/* The error of a foot: |distance - true distance|, or how much farther than the nearest point the curve is at t, where
 * that is more than twice as much. Infinite where t or distance is not finite. */
BB_API int bb_project_error(const bb_curve* curve, const double* point, double t, double distance, double* error);

/* ---- Easing curves: cubic-bezier(x1, y1, x2, y2) of CSS ---- */

/* y at x[0] to x[count - 1] of the curve (0,0) (x1,y1) (x2,y2) (1,1); `bezier` has x1, y1, x2 and y2, x1 and x2 in [0,1]. For
 * x outside [0,1] the curve goes on along its tangents. A null `method` stands for easing_correctly_rounded, whose y at x in
 * [0,1] is the number nearest to the true one. */
BB_API int bb_ease(const char* method, const double* bezier, const double* x, size_t count, double* y);
BB_API int bb_ease_float(const char* method, const float* bezier, const float* x, size_t count, float* y);

/* The true y, rounded once. */
BB_API int bb_exact_ease(const double* bezier, const double* x, size_t count, double* y);

/* ---- Piecewise cubics near points ---- */

/* A fit: cubic Bezier segments, of four control points each. */
typedef struct bb_fitted bb_fitted;

/* Fits two points or more, in order, so that none is farther than `tolerance` >= 0 from the curve, and the curve stays
 * near the line segments between them. Where the last point equals the first the curve is closed, smoothly unless the
 * points have a corner there. */
BB_API int bb_fit(const char* method, int dimension, const double* points, size_t count, double tolerance,
                  bb_fitted** fitted);
/* The same, with the directions in which the curve begins and ends: vectors with `dimension` coordinates, along the
 * curve; BB_ERROR_PARAMETER where all are 0. Null leaves a direction to the points. */
BB_API int bb_fit_directed(const char* method, int dimension, const double* points, size_t count, double tolerance,
                           const double* start, const double* end, bb_fitted** fitted);
BB_API size_t bb_fitted_segments(const bb_fitted* fitted);
BB_API const double* bb_fitted_points(const bb_fitted* fitted); /* 4 * dimension values a segment; valid until freed */
BB_API double bb_fitted_max_error(const bb_fitted* fitted);     /* as the method bounds it: at most the tolerance */
BB_API int bb_fitted_exact_error(const bb_fitted* fitted, double* error); /* the true one, rounded once */
BB_API void bb_fitted_free(bb_fitted* fitted);                            /* null is allowed */

/* ---- Files of curves ---- */

/* The curves of a file, in its order. */
typedef struct bb_curves bb_curves;

/* Reads a file of curves: CSV, SVG, SVG path data, JSON or a font, by its extension or else by what is in it. Lines are
 * curves of degree 1, arcs rational ones of degree 2. For BB_ERROR_FILE `message`, unless null, becomes a line of less
 * than `size` bytes that says where in the file and what to do. */
BB_API int bb_curves_read(const char* file, char* message, size_t size, bb_curves** curves);
BB_API size_t bb_curves_count(const bb_curves* curves);
/* Curve number `index` from 0. Its numbers are those of `curves`: copy them, or use them until that is freed. */
BB_API int bb_curves_at(const bb_curves* curves, size_t index, bb_curve* curve);
/* Whether it is the first segment of a path: 1 or 0. A segment that is not starts where the one before it ends. */
BB_API int bb_curves_begins_path(const bb_curves* curves, size_t index, int* begins);
/* Its id with a final zero. `required` (may be null) gets the bytes that this takes, also where the result is
 * BB_ERROR_COUNT because `size` bytes are too few. */
BB_API int bb_curves_id(const bb_curves* curves, size_t index, char* id, size_t size, size_t* required);
BB_API void bb_curves_free(bb_curves* curves); /* null is allowed */

/* ---- B-spline curves and NURBS ---- */

/* A B-spline curve of a degree from 1 on, which owns nothing, over t from knots[degree] to knots[count], of which the first is
 * less. BB_ERROR_PARAMETER where that is not so, or knots descend; BB_ERROR_NO_POINT for a weight that is not above 0. */
typedef struct bb_bspline {
  int dimension;
  int degree;
  size_t count;          /* of control points, more than `degree` */
  const double* points;  /* count * dimension values, not premultiplied by weights */
  const double* weights; /* count values, above 0, of a NURBS; otherwise null */
  const double* knots;   /* count + degree + 1 values */
} bb_bspline;

/* The points at t[0] to t[count - 1] by a method for the problem "bspline", "de_boor" for null; and the true points, each
 * coordinate rounded once. BB_ERROR_PARAMETER for a t outside of the curve. */
BB_API int bb_bspline_evaluate(const char* method, const bb_bspline* curve, const double* t, size_t count, double* out);
BB_API int bb_bspline_exact(const bb_bspline* curve, const double* t, size_t count, double* out);

/* The spans that are not empty, each over [0, 1] in Bernstein or rational form, as a set of curves, whose ids are their
 * numbers. Each coordinate is the true one rounded once, and spans that meet share their end to the bit. */
BB_API int bb_bspline_spans(const bb_bspline* curve, bb_curves** spans);

/* A B-spline curve that the library made: its coordinates and weights are the true ones, each rounded once. Control points
 * without influence on a curve are left out. BB_ERROR_NO_POINT where a weight would not be above 0. */
typedef struct bb_bspline_made bb_bspline_made;

/* With `count` knots more, from the begin of the curve to its end; at an end they clamp it. BB_ERROR_COUNT where a knot would
 * stand more than `degree` times, or degree + 1 times at an end. */
BB_API int bb_bspline_insert(const bb_bspline* curve, const double* knots, size_t count, bb_bspline_made** made);
/* Without `count` knots between the ends; BB_ERROR_COUNT where there are fewer. No point moves farther than *deviation, roundings
 * included: 0 where the knots have no effect, and coordinates are the true ones rounded once; infinite where it overflows. */
BB_API int bb_bspline_remove(const bb_bspline* curve, const double* knots, size_t count, bb_bspline_made** made,
                             double* deviation);
/* In a degree at least that of the curve and at most 64, otherwise BB_ERROR_DEGREE: time grows with its fourth power. */
BB_API int bb_bspline_elevate(const bb_bspline* curve, int degree, bb_bspline_made** made);
/* The part over t in [from, to] of the curve, from < to, clamped. */
BB_API int bb_bspline_part(const bb_bspline* curve, double from, double to, bb_bspline_made** made);
/* The derivative of an order from 0 to degree - 1 of a curve without weights; with them BB_ERROR_FORM. */
BB_API int bb_bspline_derivative(const bb_bspline* curve, int order, bb_bspline_made** made);

/* Its numbers are those of `made`: copy them, or use them until that is freed. */
BB_API int bb_bspline_get(const bb_bspline_made* made, bb_bspline* curve);
BB_API void bb_bspline_free(bb_bspline_made* made); /* null is allowed */

/* ---- Cubic splines through points ---- */

/* The steps of the parameter between points. */
typedef enum bb_parameters {
  BB_CENTRIPETAL =
      0,          /* the square root of their distance: a natural spline through a line's points does not run back */
  BB_UNIFORM = 1, /* 1 */
  BB_CHORD = 2    /* their distance */
} bb_parameters;

typedef enum bb_ends {
  BB_NATURAL = 0,    /* the second derivative is 0 */
  BB_CLAMPED = 1,    /* the derivative is given */
  BB_NOT_A_KNOT = 2, /* the first two segments are one cubic, the last two as well */
  BB_CLOSED = 3      /* there are none: a last segment goes back to the first point */
} bb_ends;

/* A spline; all zero it is the natural one at centripetal parameters. */
typedef struct bb_spline {
  int parameters; /* a bb_parameters */
  int ends;       /* a bb_ends */
  int monotone;   /* 1: each coordinate is monotone between neighbouring points, and the spline is C1 only */
  const double* start_derivative; /* for BB_CLAMPED, `dimension` values: 3 (P1 - P0) of the first segment */
  const double* end_derivative;   /* and 3 (P3 - P2) of the last one */
} bb_spline;

/* The cubic Bezier segments of a spline through two points or more, C2 in its parameter, four control points each:
 * 4 * dimension * (count - 1) values in `segments`, and 4 * dimension more for BB_CLOSED. Null means a bb_spline that is all
 * zero. At uniform parameters points may be repeated. */
BB_API int bb_interpolate(const bb_spline* spline, int dimension, const double* points, size_t count, double* segments);

#ifdef __cplusplus
}
#endif

#endif
