/* SPDX-License-Identifier: MIT */
/* The interface of a plug-in: a shared object with a method of your own that `bezierbench run --plugin FILE.so` judges
 * and times. It is C99 and includes the standard library only. docs/own_method.md has a worked example. */
#ifndef BEZIERBENCH_PLUGIN_H
#define BEZIERBENCH_PLUGIN_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface. What is added later is a function that a plug-in may export or not. */
#define BEZIERBENCH_PLUGIN_VERSION 1

enum bezierbench_form { BEZIERBENCH_BERNSTEIN = 0, BEZIERBENCH_POWER = 1, BEZIERBENCH_RATIONAL = 2 };

/* One curve. Coefficient i (ascending) of axis a is points[i * dimension + a]; there are degree + 1 of each axis. They
 * are control points in Bernstein form and in rational form, where they are not premultiplied, else the coefficients of
 * powers of t. `weights` has degree + 1 values for a rational curve and is NULL for any other. */
struct bezierbench_curve {
  enum bezierbench_form form;
  int dimension; /* 1, 2 or 3 */
  int degree;
  const double* points;
  const double* weights;
};

struct bezierbench_method {
  unsigned version;  /* BEZIERBENCH_PLUGIN_VERSION */
  const char* id;    /* "plugin_" and lower-case letters, digits and _ */
  const char* label; /* for people */
  enum bezierbench_form form;
  int min_degree;
  int max_degree;
  /* All work that is done once for a curve. `curve` is valid during the call only. Returns what `evaluate` reads, or
   * NULL where the method cannot take this curve. */
  void* (*prepare)(const struct bezierbench_curve* curve);
  /* Writes the points at t[0] to t[count - 1]: points[k * dimension + a] is coordinate a of the point at t[k]. */
  void (*evaluate)(const void* prepared, const double* t, size_t count, double* points);
  /* Ends what `prepare` returned. May be NULL where there is nothing to do. */
  void (*destroy)(void* prepared);
};

/* The same in float. */
struct bezierbench_curve_float {
  enum bezierbench_form form;
  int dimension;
  int degree;
  const float* points;
  const float* weights;
};

struct bezierbench_method_float {
  void* (*prepare)(const struct bezierbench_curve_float* curve);
  void (*evaluate)(const void* prepared, const float* t, size_t count, float* points);
  void (*destroy)(void* prepared);
};

#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* What the shared object exports: its method, which stays valid as long as the object is loaded. */
const struct bezierbench_method* bezierbench_plugin(void);

/* Optional: the functions of the same method in float; id, form and degrees are those of bezierbench_plugin(). A method
 * without points in double has NULL for its `prepare` and `evaluate` there. */
const struct bezierbench_method_float* bezierbench_plugin_float(void);

/* Problems beside points. `given` is what comes with the curve. */
enum bezierbench_problem {
  BEZIERBENCH_ARC_LENGTH = 1, /* given: from, to, a tolerance relative to the length; answer: the length of that part */
  BEZIERBENCH_PROJECTION = 2, /* given: a point; answer: t in [0, 1] of the curve's point nearest to it, the distance */
  BEZIERBENCH_SUBDIVISION = 3 /* given: t; answer: the control points of the left half, then of the right one, point by
                                 point, each in a rational curve followed by its weight */
};

/* Optional: writes the answer and returns 0, or returns another number where the method does not solve the problem or does
 * not take the curve. `curve` is NULL where it has to tell only whether it solves the problem. */
int bezierbench_plugin_solve(enum bezierbench_problem problem, const struct bezierbench_curve* curve, const double* given,
                             double* answer);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#ifdef __cplusplus
}
#endif

#endif
