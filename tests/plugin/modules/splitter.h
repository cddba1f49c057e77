/* orient2d by expansions in the range where nothing overflows or underflows: the six products of coordinates
 * in ax (by - cy) + bx (cy - ay) + cx (ay - by), each as two doubles by Veltkamp's splitting and Dekker's
 * product, summed exactly. SPLITTER is 2^27 + 1 where it is right. */
#ifndef TRIBUNAL_TEST_SPLITTER_H
#define TRIBUNAL_TEST_SPLITTER_H

#include "tribunal_predicates.h"

#include <math.h>

static void split(double a, double* high, double* low) {
  const double c = SPLITTER * a;
  const double big = c - a;
  *high = c - big;
  *low = a - *high;
}

/* x + y = a b, provided that the halves have at most 26 bits. */
static void two_product(double a, double b, double* x, double* y) {
  double ah, al, bh, bl;
  *x = a * b;
  split(a, &ah, &al);
  split(b, &bh, &bl);
  *y = al * bl - (((*x - ah * bh) - al * bh) - ah * bl);
}

/* Adds b to the expansion e of n components, smallest first; returns n + 1. Knuth's sum needs no order of a
 * and b. */
static int grow(double* e, int n, double b) {
  double sum = b;
  for (int i = 0; i < n; ++i) {
    const double x = sum + e[i];
    const double part = x - sum;
    e[i] = (sum - (x - part)) + (e[i] - part);
    sum = x;
  }
  e[n] = sum;
  return n + 1;
}

static void* refuse_extremes(const double* points, size_t n, int dimension, size_t* refused) {
  for (size_t i = 0; i < n * (size_t)dimension; ++i)
    if (points[i] != 0 && !(fabs(points[i]) > 0x1p-400 && fabs(points[i]) < 0x1p400)) {
      *refused = i / (size_t)dimension;
      break;
    }
  return NULL;
}

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  const double left[6] = {a[0], -a[0], b[0], -b[0], c[0], -c[0]};
  const double right[6] = {b[1], c[1], c[1], a[1], a[1], b[1]};
  double sum[12];
  int n = 0;
  (void)context;
  for (int i = 0; i < 6; ++i) {
    double high, low;
    two_product(left[i], right[i], &high, &low);
    n = grow(sum, n, low);
    n = grow(sum, n, high);
  }
  for (int i = n - 1; i >= 0; --i)
    if (sum[i] != 0) return sum[i] > 0 ? 1 : -1;
  return 0;
}

static const tribunal_predicates offer = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "expansions", .bind = refuse_extremes, .orient2d = orient2d};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }

#endif
