// The predicates of a CGAL kernel behind the plug-in interface.
#pragma once

#include "predicates/plugin/tribunal_predicates.h"

namespace tribunal_peers {

/// Functions of the interface for kernel K, whose points are made of doubles without rounding. CGAL's signs
/// are those of the interface.
template <class K>
struct CgalPredicates {
  static typename K::Point_2 plane(const double* p) { return {p[0], p[1]}; }
  static typename K::Point_3 space(const double* p) { return {p[0], p[1], p[2]}; }

  static int orient2d(const void*, const double* a, const double* b, const double* c) {
    return typename K::Orientation_2()(plane(a), plane(b), plane(c));
  }
  static int incircle(const void*, const double* a, const double* b, const double* c, const double* d) {
    return typename K::Side_of_oriented_circle_2()(plane(a), plane(b), plane(c), plane(d));
  }
  static int orient3d(const void*, const double* a, const double* b, const double* c, const double* d) {
    return typename K::Orientation_3()(space(a), space(b), space(c), space(d));
  }
  static int insphere(const void*, const double* a, const double* b, const double* c, const double* d,
                      const double* e) {
    return typename K::Side_of_oriented_sphere_3()(space(a), space(b), space(c), space(d), space(e));
  }

  /// Points of D coordinates, N to a query.
  template <int D, int N, class Query>
  static void each(const double* coordinates, size_t count, int8_t* signs, Query query) {
    for (size_t i = 0; i < count; ++i) signs[i] = static_cast<int8_t>(query(coordinates + D * N * i));
  }
  static void orient2d_batch(const void*, const double* coordinates, size_t count, int8_t* signs) {
    each<2, 3>(coordinates, count, signs, [](const double* p) { return orient2d(nullptr, p, p + 2, p + 4); });
  }
  static void incircle_batch(const void*, const double* coordinates, size_t count, int8_t* signs) {
    each<2, 4>(coordinates, count, signs,
               [](const double* p) { return incircle(nullptr, p, p + 2, p + 4, p + 6); });
  }
  static void orient3d_batch(const void*, const double* coordinates, size_t count, int8_t* signs) {
    each<3, 4>(coordinates, count, signs,
               [](const double* p) { return orient3d(nullptr, p, p + 3, p + 6, p + 9); });
  }
  static void insphere_batch(const void*, const double* coordinates, size_t count, int8_t* signs) {
    each<3, 5>(coordinates, count, signs,
               [](const double* p) { return insphere(nullptr, p, p + 3, p + 6, p + 9, p + 12); });
  }

  static constexpr tribunal_predicates offer(const char* name, const char* cites, const char* summary) {
    tribunal_predicates all{};
    all.version = TRIBUNAL_PLUGIN_VERSION;
    all.name = name;
    all.cites = cites;
    all.summary = summary;
    all.orient2d = orient2d, all.orient2d_batch = orient2d_batch;
    all.incircle = incircle, all.incircle_batch = incircle_batch;
    all.orient3d = orient3d, all.orient3d_batch = orient3d_batch;
    all.insphere = insphere, all.insphere_batch = insphere_batch;
    return all;
  }
};

}  // namespace tribunal_peers
