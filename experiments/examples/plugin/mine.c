/* SPDX-License-Identifier: MIT */
/* De Casteljau's algorithm as a plug-in: cc -O2 -ffp-contract=off -shared -fPIC mine.c -o mine.so */
#include <bezierbench/plugin.h>
#include <stdlib.h>
#include <string.h>

struct prepared {
  int dimension, degree;
  double points[];
};

static void* prepare(const struct bezierbench_curve* curve) {
  const size_t size = sizeof(double) * (size_t)(curve->degree + 1) * (size_t)curve->dimension;
  struct prepared* p = malloc(sizeof *p + size);
  if (p == NULL) return NULL;
  p->dimension = curve->dimension;
  p->degree = curve->degree;
  memcpy(p->points, curve->points, size);
  return p;
}

static void evaluate(const void* prepared, const double* t, size_t count, double* points) {
  const struct prepared* p = prepared;
  double b[1024];
  for (size_t k = 0; k < count; ++k)
    for (int axis = 0; axis < p->dimension; ++axis) {
      for (int i = 0; i <= p->degree; ++i) b[i] = p->points[i * p->dimension + axis];
      for (int last = p->degree; last > 0; --last)
        for (int i = 0; i < last; ++i) b[i] = (1 - t[k]) * b[i] + t[k] * b[i + 1];
      points[k * (size_t)p->dimension + (size_t)axis] = b[0];
    }
}

static const struct bezierbench_method mine = {BEZIERBENCH_PLUGIN_VERSION, "plugin_mine", "My de Casteljau",
                                               BEZIERBENCH_BERNSTEIN, 0, 1023, prepare, evaluate, free};

const struct bezierbench_method* bezierbench_plugin(void) { return &mine; }
