// Laws of the mesh: topology without coordinates.
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/mesh/planar_mesh.hpp"

#include <gtest/gtest.h>

namespace tribunal {
namespace {

TEST(PlanarMesh, TheFirstTriangleAndItsGhostsAreASphere) {
  PlanarMesh mesh;
  const Index t = add_first_triangle(mesh, 7, 8, 9);
  ASSERT_EQ(mesh.triangles(), 4U);
  EXPECT_FALSE(mesh.is_ghost(t));
  for (HalfEdge h = 0; h < 12; ++h) {
    const HalfEdge g = mesh.twin(h);
    ASSERT_NE(g, PlanarMesh::none);
    EXPECT_EQ(mesh.twin(g), h);
    EXPECT_EQ(mesh.from(h), mesh.to(g));
    EXPECT_EQ(mesh.to(h), mesh.from(g));
  }
  for (Index i = 0; i < 3; ++i) EXPECT_EQ(triangle_of(mesh.twin(3 * t + i)), t + 1 + i);
}

TEST(PlanarMesh, NextAndPrevTurnRoundOneTriangle) {
  for (HalfEdge h = 0; h < 30; ++h) {
    EXPECT_EQ(prev(next(h)), h);
    EXPECT_EQ(next(next(next(h))), h);
    EXPECT_EQ(triangle_of(next(h)), triangle_of(h));
  }
}

TEST(Canonical, RotationAndOrderOfTrianglesDoNotMatter) {
  const std::vector<Triangle> a{{2, 0, 1}, {1, 3, 2}}, b{{2, 1, 3}, {0, 1, 2}};
  EXPECT_EQ(canonical(a), canonical(b));
  EXPECT_EQ(digest(a), digest(b));
}

TEST(Canonical, OrientationMatters) {
  EXPECT_NE(digest(std::vector<Triangle>{{0, 1, 2}}), digest(std::vector<Triangle>{{0, 2, 1}}));
}

// FNV-1a of the twelve bytes 00 00 00 00 01 00 00 00 02 00 00 00, and of nothing.
TEST(Canonical, DigestIsFnv1a) {
  EXPECT_EQ(to_hex(digest({})), "cbf29ce484222325");
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const std::uint64_t byte : {0U, 0U, 0U, 0U, 1U, 0U, 0U, 0U, 2U, 0U, 0U, 0U})
    hash = (hash ^ byte) * 0x100000001B3;
  EXPECT_EQ(digest(std::vector<Triangle>{{1, 2, 0}}), hash);
}

}  // namespace
}  // namespace tribunal
