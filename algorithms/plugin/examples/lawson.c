/* A small triangulator: points sorted from left to right, each joined to what it sees of the hull, then
 * Lawson's flips until no edge has a vertex strictly inside its circle. Exact over integers below 2^13 in
 * size, and refuses other points; quadratic, as is good enough for an example. */
#include "tribunal_triangulator.h"

#include <stdlib.h>

typedef struct {
  int64_t x, y;
  uint32_t index;
} site;

typedef struct {
  const site* sites;
  uint32_t (*triangles)[3]; /* corners counter-clockwise, as numbers of sites */
  size_t count;
} mesh;

static int compare(const void* left, const void* right) {
  const site *a = left, *b = right;
  if (a->x != b->x) return a->x < b->x ? -1 : 1;
  return (a->y > b->y) - (a->y < b->y);
}

/* Differences are below 2^14, so that these stay below 2^29 and 6 * 2^57. */
static int64_t orient(const site* a, const site* b, const site* c) {
  return (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
}

static int64_t incircle(const site* a, const site* b, const site* c, const site* d) {
  const int64_t ax = a->x - d->x, ay = a->y - d->y, bx = b->x - d->x, by = b->y - d->y;
  const int64_t cx = c->x - d->x, cy = c->y - d->y;
  return (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
         (cx * cx + cy * cy) * (ax * by - ay * bx);
}

static int is_small_integer(double x) { return x > -0x1p13 && x < 0x1p13 && (double)(int64_t)x == x; }

/* Distinct sites from left to right; their number, or -1 when a point is outside the domain. */
static long read_sites(const double* points, size_t n, site* sites) {
  size_t distinct = 0;
  for (size_t i = 0; i < n; ++i) {
    if (!is_small_integer(points[2 * i]) || !is_small_integer(points[2 * i + 1])) return -1;
    sites[i] = (site){(int64_t)points[2 * i], (int64_t)points[2 * i + 1], (uint32_t)i};
  }
  qsort(sites, n, sizeof *sites, compare);
  for (size_t i = 0; i < n; ++i)
    if (distinct == 0 || compare(&sites[distinct - 1], &sites[i]) != 0) sites[distinct++] = sites[i];
  return (long)distinct;
}

static void add(mesh* m, uint32_t a, uint32_t b, uint32_t c) {
  uint32_t* t = m->triangles[m->count++];
  t[0] = a, t[1] = b, t[2] = c;
}

/* The lower and the upper hull of the sites so far are two chains from left to right. Joining a site to every
 * edge that it sees, from the right end leftwards, keeps them convex. `side` is 1 for the lower one, -1 for
 * the upper. */
static void join(mesh* m, uint32_t* chain, uint32_t* length, uint32_t i, int side) {
  while (*length > 1) {
    const uint32_t last = chain[*length - 1], before = chain[*length - 2];
    if (side * orient(&m->sites[before], &m->sites[last], &m->sites[i]) >= 0) break;
    if (side > 0)
      add(m, before, i, last);
    else
      add(m, before, last, i);
    --*length;
  }
  chain[(*length)++] = i;
}

/* Flips the edge across from corner i of s when it is an edge of t and its circles say so. */
static int flip(mesh* m, uint32_t* s, uint32_t* t) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const uint32_t a = s[i], b = s[(i + 1) % 3], c = s[(i + 2) % 3], d = t[j];
      if (t[(j + 1) % 3] != c || t[(j + 2) % 3] != b) continue;
      if (incircle(&m->sites[a], &m->sites[b], &m->sites[c], &m->sites[d]) <= 0) return 0;
      s[0] = a, s[1] = b, s[2] = d;
      t[0] = a, t[1] = d, t[2] = c;
      return 1;
    }
  return 0;
}

static int triangulate(const double* points, size_t n, tribunal_emit emit, void* sink) {
  site* sites = malloc(n * sizeof *sites);
  uint32_t* lower = malloc(n * sizeof *lower);
  uint32_t* upper = malloc(n * sizeof *upper);
  mesh m = {sites, malloc(2 * n * sizeof *m.triangles), 0};
  int ending = TRIBUNAL_FAILED;
  if (sites && lower && upper && m.triangles) {
    const long distinct = read_sites(points, n, sites);
    uint32_t below = 0, above = 0;
    for (long i = 0; i < distinct; ++i) {
      join(&m, lower, &below, (uint32_t)i, 1);
      join(&m, upper, &above, (uint32_t)i, -1);
    }
    for (int flipped = 1; flipped;) {
      flipped = 0;
      for (size_t s = 0; s < m.count; ++s)
        for (size_t t = s + 1; t < m.count; ++t) flipped |= flip(&m, m.triangles[s], m.triangles[t]);
    }
    for (size_t t = 0; t < m.count; ++t)
      emit(sink, sites[m.triangles[t][0]].index, sites[m.triangles[t][1]].index,
           sites[m.triangles[t][2]].index);
    ending = distinct < 0 ? TRIBUNAL_REFUSED : TRIBUNAL_DONE;
  }
  free(sites), free(lower), free(upper), free(m.triangles);
  return ending;
}

static const tribunal_triangulator offer = {
    .version = TRIBUNAL_PLUGIN_VERSION,
    .name = "lawson",
    .cites = "Lawson 1977",
    .summary = "a sweep from left to right, then flips, over integers below 2^13",
    .triangulate = triangulate,
};

const tribunal_triangulator* tribunal_triangulator_entry(void) { return &offer; }
