/* SPDX-License-Identifier: MIT */
/* What a plug-in may export beside its method in double, here without that: the method in float, and halves. */
#include <bezierbench/plugin.h>
#include <stdlib.h>
#include <string.h>

struct prepared {
  int dimension, degree;
  float points[];
};

static void* prepare(const struct bezierbench_curve_float* curve) {
  const size_t size = sizeof(float) * (size_t)(curve->degree + 1) * (size_t)curve->dimension;
  struct prepared* p = malloc(sizeof *p + size);
  if (p == NULL) return NULL;
  p->dimension = curve->dimension;
  p->degree = curve->degree;
  memcpy(p->points, curve->points, size);
  return p;
}

static void evaluate(const void* prepared, const float* t, size_t count, float* points) {
  const struct prepared* p = prepared;
  float b[1024];
  for (size_t k = 0; k < count; ++k)
    for (int axis = 0; axis < p->dimension; ++axis) {
      for (int i = 0; i <= p->degree; ++i) b[i] = p->points[i * p->dimension + axis];
      for (int last = p->degree; last > 0; --last)
        for (int i = 0; i < last; ++i) b[i] = (1 - t[k]) * b[i] + t[k] * b[i + 1];
      points[k * (size_t)p->dimension + (size_t)axis] = b[0];
    }
}

int bezierbench_plugin_solve(enum bezierbench_problem problem, const struct bezierbench_curve* curve, const double* given,
                             double* answer) {
  if (problem != BEZIERBENCH_SUBDIVISION) return 1;
  if (curve == NULL) return 0;
  const int n = curve->degree;
  const int d = curve->dimension;
  const double t = given[0];
  double* right = answer + (n + 1) * d;
  memcpy(right, curve->points, sizeof(double) * (size_t)((n + 1) * d));
  for (int level = 0; level <= n; ++level) { /* right[0] is the next point of the left half */
    memcpy(answer + level * d, right, sizeof(double) * (size_t)d);
    for (int i = 0; i < (n - level) * d; ++i) right[i] = (1 - t) * right[i] + t * right[i + d];
  }
  return 0;
}

static const struct bezierbench_method method = {
    BEZIERBENCH_PLUGIN_VERSION, "plugin_optional", "", BEZIERBENCH_BERNSTEIN, 0, 1023, NULL, NULL, NULL};
static const struct bezierbench_method_float in_float = {prepare, evaluate, free};

const struct bezierbench_method* bezierbench_plugin(void) { return &method; }
const struct bezierbench_method_float* bezierbench_plugin_float(void) { return &in_float; }
