/* SPDX-License-Identifier: MIT */
/* Plug-ins that do what a method must not, one for each value of FAULT; the tests show what becomes of each. */
#include <bezierbench/plugin.h>
#include <fenv.h>
#include <math.h>
#include <stdlib.h>

enum { WRONG, CRASH, HANG, OUT_OF_BOUNDS, ROUNDING, LEAK, GIVES_NAN, REFUSE, EXIT_EARLY };
#define TEXT2(x) #x
#define TEXT(x) TEXT2(x)

static int dimension;

static void* prepare(const struct bezierbench_curve* curve) {
  dimension = curve->dimension;
  if (FAULT == REFUSE) return NULL;
  double* first = malloc(3 * sizeof *first);
  for (int axis = 0; axis < dimension; ++axis) first[axis] = curve->points[axis];
  return first;
}

static void evaluate(const void* prepared, const double* t, size_t count, double* points) {
  const double* first = prepared;
  if (FAULT == CRASH && t[0] > 0.5) abort();
  if (FAULT == EXIT_EARLY) exit(0);
  for (volatile int spin = FAULT == HANG; spin;) continue;
  if (FAULT == ROUNDING) fesetround(FE_UPWARD);
  if (FAULT == OUT_OF_BOUNDS) points[-1] = 1;
  for (size_t k = 0; k < count; ++k)
    for (int axis = 0; axis < dimension; ++axis)
      points[k * (size_t)dimension + (size_t)axis] = FAULT == GIVES_NAN ? NAN : first[axis];
}

static void destroy(void* prepared) {
  if (FAULT != LEAK) free(prepared);
}

static const struct bezierbench_method method = {
    BEZIERBENCH_PLUGIN_VERSION, "plugin_faulty_" TEXT(FAULT), "faulty", BEZIERBENCH_BERNSTEIN, 0, 100, prepare,
    evaluate,                   destroy};

const struct bezierbench_method* bezierbench_plugin(void) { return &method; }
