/* SPDX-License-Identifier: MIT */
/* Plug-ins that work for 3000 calls and then show a fault, one for each value of FAULT. A block of trials has fewer
   calls, so the fault occurs only while they are timed. */
#include <bezierbench/plugin.h>
#include <stdlib.h>

enum { EXIT_EARLY, HANG, WRONG };
#define TEXT2(x) #x
#define TEXT(x) TEXT2(x)

static int dimension;
static int calls;

static void* prepare(const struct bezierbench_curve* curve) {
  const size_t count = (size_t)(curve->degree + 1) * (size_t)curve->dimension;
  double* points = malloc((count + 1) * sizeof *points);
  dimension = curve->dimension;
  points[0] = curve->degree;
  for (size_t k = 0; k < count; ++k) points[k + 1] = curve->points[k];
  return points;
}

static void evaluate(const void* prepared, const double* t, size_t count, double* points) {
  const double* curve = prepared;
  const int is_late = ++calls > 3000;
  if (FAULT == EXIT_EARLY && is_late) exit(0);
  for (volatile int spin = FAULT == HANG && is_late; spin;) continue;
  for (size_t k = 0; k < count; ++k)
    for (int axis = 0; axis < dimension; ++axis) {
      double b[1024];
      const int n = (int)curve[0];
      for (int i = 0; i <= n; ++i) b[i] = curve[1 + i * dimension + axis];
      for (int last = n; last > 0; --last)
        for (int i = 0; i < last; ++i) b[i] = (1 - t[k]) * b[i] + t[k] * b[i + 1];
      points[k * (size_t)dimension + (size_t)axis] = FAULT == WRONG && is_late ? 0 : b[0];
    }
}

static const struct bezierbench_method method = {BEZIERBENCH_PLUGIN_VERSION,
                                                 "plugin_late_" TEXT(FAULT),
                                                 "late",
                                                 BEZIERBENCH_BERNSTEIN,
                                                 0,
                                                 1023,
                                                 prepare,
                                                 evaluate,
                                                 free};

const struct bezierbench_method* bezierbench_plugin(void) { return &method; }
