/* SPDX-License-Identifier: MIT */
/* The header and the library from C99: a point, its true value, its error and its bound. */
#include <bezierbench/bezierbench.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("wrong: %s\n", what);
  ++failures;
}

int main(void) {
  const double points[] = {0, 0, 1, 2, 3, 0.1};
  const bb_curve curve = {BB_BERNSTEIN, 2, 2, points, NULL};
  const double t[] = {0.1, 0.7};
  double computed[4], truth[4];
  bb_error errors[4];
  bb_bound bounds[4];
  int i;
  expect(bb_evaluate("de_casteljau", 2, 2, points, t, 2, computed) == BB_OK, "bb_evaluate");
  expect(bb_exact(2, 2, points, t, 2, truth) == BB_OK, "bb_exact");
  expect(bb_curve_error(&curve, t, 2, computed, errors) == BB_OK, "bb_curve_error");
  expect(bb_curve_bound("de_casteljau", &curve, t, 2, bounds) == BB_OK, "bb_curve_bound");
  for (i = 0; i < 4; ++i) {
    expect(errors[i].exact == truth[i], "the true value");
    expect(errors[i].error <= bounds[i].bound && bounds[i].bound < 1e-14, "the error is below its bound");
  }
  expect(bb_evaluate("de_castlejau", 2, 2, points, t, 2, computed) == BB_ERROR_METHOD, "a misspelt method");
  expect(strcmp(bb_strerror(BB_OK), "success") == 0, "bb_strerror");
  return failures;
}
