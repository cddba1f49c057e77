/* Triangulation and refinement of points with segments as a plug-in: what a shared library offers so that
 * `tribunal bench algorithms` can race it. Copy this header; nothing else is needed.
 *
 * The library defines one function with C linkage,
 *
 *     const tribunal_mesher* tribunal_mesher_entry(void);
 *
 * which returns a structure that lives as long as the library. Members that are not offered are NULL; one of
 * the two functions must be there. A library may also define the entries of tribunal_predicates.h and
 * tribunal_triangulator.h.
 *
 * Functions must not write to what they are given, and leave the floating-point environment as it was. They
 * run in a process of their own: a crash, or a call that does not return, is their loss alone.
 */
#ifndef TRIBUNAL_MESHER_H
#define TRIBUNAL_MESHER_H

#include <stddef.h>
#include <stdint.h>

/* One number for all headers of plug-ins; it changes when any declaration in one of them does. */
#ifndef TRIBUNAL_PLUGIN_VERSION
#define TRIBUNAL_PLUGIN_VERSION 1
#elif TRIBUNAL_PLUGIN_VERSION != 1
#error "the headers of plug-ins are of different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

#ifndef TRIBUNAL_ENDINGS
#define TRIBUNAL_ENDINGS
/* How a triangulation ended. */
enum {
  TRIBUNAL_DONE = 0,    /* all triangles were given */
  TRIBUNAL_REFUSED = 1, /* the points are outside the library's domain; triangles given are ignored */
  TRIBUNAL_FAILED = 2   /* the library gave up; so does any other number say */
};
#endif

/* A planar straight-line graph. Points may coincide, any copy may be named in their stead. Segments may share
 * ends, overlap and run through points; no two cross inside both. */
typedef struct tribunal_graph {
  const double* points;     /* x0, y0, x1, y1, ...: n of them, n >= 1, finite */
  const uint32_t* segments; /* a0, b0, a1, b1, ...: m pairs of indices of points */
  const double* holes;      /* x0, y0, ...: h points, one inside each hole */
  size_t n, m, h;
} tribunal_graph;

/* What the triangles of a refined mesh are to be like. Both bounds may be missed by rounding, no more. */
typedef struct tribunal_bounds {
  double sine_squared; /* of the smallest angle: at least this; 0.25 means 30 degrees */
  double longest_edge; /* at most this; may be infinite */
} tribunal_bounds;

/* Where a mesh goes: functions to call in any order, each with `sink` first. Points of the graph are 0 to
 * n - 1; the first new vertex that is given is n, the next n + 1. Triangles may have either orientation. */
typedef struct tribunal_receiver {
  void* sink;
  void (*vertex)(void* sink, double x, double y);
  void (*triangle)(void* sink, uint32_t a, uint32_t b, uint32_t c);
  void (*subsegment)(void* sink, uint32_t a, uint32_t b);
} tribunal_receiver;

typedef struct tribunal_mesher {
  uint32_t version;    /* TRIBUNAL_PLUGIN_VERSION */
  const char* name;    /* short, as in a table: "quad-edge" */
  const char* cites;   /* author and year, or the library and its version; may be NULL */
  const char* summary; /* one line; may be NULL */

  /* The constrained Delaunay triangulation of the whole convex hull: every position is a corner, every
   * segment a union of edges, and no triangle has inside its circle a position that can be seen from it past
   * the segments. Gives triangles alone; holes do not count. */
  int (*triangulate)(const tribunal_graph* graph, const tribunal_receiver* receiver);

  /* A mesh, with new vertices, of what neither infinity nor a hole reaches without crossing a segment:
   * constrained Delaunay, triangles as the bounds say. Gives new vertices, triangles and, as subsegments, all
   * edges that are parts of segments. A new vertex on a segment lies there as exactly as doubles can say,
   * within 2^-48 of the largest coordinate of the segment's ends. Triangles with a
   * corner on a segment that encloses less than 60 degrees with another one may be sharper than the bound. */
  int (*refine)(const tribunal_graph* graph, const tribunal_bounds* bounds,
                const tribunal_receiver* receiver);
} tribunal_mesher;

/* What the library defines. */
const tribunal_mesher* tribunal_mesher_entry(void);

#ifdef __cplusplus
}
#endif

#endif
