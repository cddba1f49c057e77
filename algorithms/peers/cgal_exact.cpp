// A CGAL kernel over GMP's rationals: every predicate computed exactly, no filter.
#include "algorithms/peers/cgal_predicates.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

namespace {

constexpr tribunal_predicates offer =
    tribunal_peers::CgalPredicates<CGAL::Simple_cartesian<CGAL::Gmpq>>::offer(
        "cgal-exact", "CGAL " CGAL_VERSION_STR, "Simple_cartesian<Gmpq>: rationals throughout, no filter");

}  // namespace

extern "C" __attribute__((visibility("default"))) const tribunal_predicates* tribunal_predicates_entry() {
  return &offer;
}
