/* SPDX-License-Identifier: MIT */
/* Plug-ins with one fault each, by the value of FAULT, for the tests. */
#include <bezierbench/plugin.h>
#include <math.h>
#include <stdlib.h>

enum { WRONG, CRASH, HANG, GIVES_NAN, REFUSE, EXIT_EARLY };
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
  for (size_t k = 0; k < count; ++k)
    for (int axis = 0; axis < dimension; ++axis)
      points[k * (size_t)dimension + (size_t)axis] = FAULT == GIVES_NAN ? NAN : first[axis];
}

static const struct bezierbench_method method = {BEZIERBENCH_PLUGIN_VERSION,
                                                 "plugin_faulty_" TEXT(FAULT),
                                                 "faulty",
                                                 BEZIERBENCH_BERNSTEIN,
                                                 0,
                                                 100,
                                                 prepare,
                                                 evaluate,
                                                 free};

const struct bezierbench_method* bezierbench_plugin(void) { return &method; }
