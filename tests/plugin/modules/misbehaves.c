/* Broken in the way that the environment variable MISBEHAVIOUR names: its orientations are those of integers
 * below 2^20, and right. NAME is what it calls itself. */
#include "tribunal_predicates.h"

#include <fenv.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int does(const char* what) {
  const char* misbehaviour = getenv("MISBEHAVIOUR");
  return misbehaviour != NULL && strcmp(misbehaviour, what) == 0;
}

static void print_now(const char* text) {
  printf("%s\n", text);
  fflush(stdout);
}

static void* bind(const double* points, size_t n, int dimension, size_t* refused) {
  if (does("refuses all")) *refused = 0;
  if (does("takes all")) return NULL;
  for (size_t i = 0; i < n * (size_t)dimension; ++i)
    if (!(points[i] >= -0x1p20 && points[i] <= 0x1p20) || points[i] != (double)(int64_t)points[i]) {
      *refused = i / (size_t)dimension;
      break;
    }
  return NULL;
}

static void misbehave(void) {
  if (does("exits")) exit(0);
  if (does("crashes")) raise(SIGSEGV);
  if (does("prints")) print_now("{\"garbage\": 1}");
  if (does("prints unflushed")) printf("garbage");
  while (does("hangs")) {
  }
}

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  (void)context;
  misbehave();
  return does("is wrong") ? 1 : (area > 0) - (area < 0);
}

static void orient2d_batch(const void* context, const double* coordinates, size_t count, int8_t* signs) {
  const int unit = does("sevens") ? 7 : 1;
  for (size_t i = 0; i < count; ++i) {
    const double* p = coordinates + 6 * i;
    signs[i] = (int8_t)(unit * orient2d(context, p, p + 2, p + 4));
  }
}

__attribute__((constructor)) static void at_start(void) {
  if (does("prints when loaded")) print_now("garbage");
  if (does("exits when loaded")) exit(0);
  if (does("rounds when loaded")) fesetround(FE_UPWARD);
}

__attribute__((destructor)) static void at_end(void) {
  if (does("prints at the end")) print_now("garbage");
  if (does("crashes at the end")) raise(SIGSEGV);
}

const tribunal_predicates* tribunal_predicates_entry(void) {
  static tribunal_predicates offer;
  offer.version = TRIBUNAL_PLUGIN_VERSION;
  offer.name = getenv("NAME") != NULL ? getenv("NAME") : "misbehaves";
  offer.bind = bind;
  offer.orient2d = orient2d;
  offer.orient2d_batch = orient2d_batch;
  return &offer;
}
