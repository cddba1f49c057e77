// Law: on small integer lattices every exact backend gives the true sign of EVERY query, degenerate ones
// included. The truth comes from 64-bit integers and the homogeneous determinants, which share no code with
// the formulas.
#include "predicates/backends/list.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tribunal {
namespace {

using Row = std::vector<std::int64_t>;

/// Determinant by expansion along the first column; of 5 rows at most.
std::int64_t determinant(const std::vector<Row>& rows) {
  if (rows.size() == 1) return rows[0][0];
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i][0] == 0) continue;
    std::vector<Row> minor;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (k != i) minor.emplace_back(rows[k].begin() + 1, rows[k].end());
    sum += (i % 2 == 0 ? 1 : -1) * rows[i][0] * determinant(minor);
  }
  return sum;
}

template <int D>
Row homogeneous(const Point<D>& p) {
  Row row{1};
  for (const double c : p.coordinate) row.push_back(static_cast<std::int64_t>(c));
  return row;
}
template <int D>
Row lifted(const Point<D>& p) {
  Row row = homogeneous(p);
  std::int64_t lift = 0;
  for (int axis = 0; axis < D; ++axis) lift += row[axis + 1] * row[axis + 1];
  row.push_back(lift);
  return row;
}
Sign sign(std::int64_t value) { return static_cast<Sign>((value > 0) - (value < 0)); }

std::vector<Point2> square_lattice(int size) {
  std::vector<Point2> points;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y) points.push_back({{double(x), double(y)}});
  return points;
}
std::vector<Point3> cubic_lattice(int size) {
  std::vector<Point3> points;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      for (int z = 0; z < size; ++z) points.push_back({{double(x), double(y), double(z)}});
  return points;
}

/// The exact backends' kernels over the points, with their names.
std::vector<std::pair<std::string, std::unique_ptr<const Kernel2>>> exact_kernels(
    const std::vector<Point2>& points) {
  std::vector<std::pair<std::string, std::unique_ptr<const Kernel2>>> kernels;
  for (const BackendEntry& entry : backends())
    if (entry.about->exact) kernels.emplace_back(entry.about->name, std::get<0>(entry.bind2(points)));
  return kernels;
}
std::vector<std::pair<std::string, std::unique_ptr<const Kernel3>>> exact_kernels(
    const std::vector<Point3>& points) {
  std::vector<std::pair<std::string, std::unique_ptr<const Kernel3>>> kernels;
  for (const BackendEntry& entry : backends())
    if (entry.about->exact && entry.bind3 != nullptr)
      kernels.emplace_back(entry.about->name, std::get<0>(entry.bind3(points)));
  return kernels;
}

TEST(Lattice, Orient2dOfAllTriplesOf8x8) {
  const auto points = square_lattice(8);
  const auto kernels = exact_kernels(points);
  int zeros = 0;
  for (const auto& a : points)
    for (const auto& b : points)
      for (const auto& c : points) {
        const Sign truth = sign(determinant({homogeneous(a), homogeneous(b), homogeneous(c)}));
        zeros += truth == Sign::zero;
        for (const auto& [name, kernel] : kernels) ASSERT_EQ(kernel->orient2d(a, b, c), truth) << name;
      }
  EXPECT_GT(zeros, 10000);
}

TEST(Lattice, IncircleOfAllQuadruplesOf4x4) {
  const auto points = square_lattice(4);
  const auto kernels = exact_kernels(points);
  int zeros = 0;
  for (const auto& a : points)
    for (const auto& b : points)
      for (const auto& c : points)
        for (const auto& d : points) {
          const Sign truth = -sign(determinant({lifted(a), lifted(b), lifted(c), lifted(d)}));
          zeros += truth == Sign::zero;
          for (const auto& [name, kernel] : kernels) ASSERT_EQ(kernel->incircle(a, b, c, d), truth) << name;
        }
  EXPECT_GT(zeros, 10000);
}

TEST(Lattice, Orient3dOfAllQuadruplesOf3x3x3) {
  const auto points = cubic_lattice(3);
  const auto kernels = exact_kernels(points);
  int zeros = 0;
  for (const auto& a : points)
    for (const auto& b : points)
      for (const auto& c : points)
        for (const auto& d : points) {
          const Sign truth =
              sign(determinant({homogeneous(a), homogeneous(b), homogeneous(c), homogeneous(d)}));
          zeros += truth == Sign::zero;
          for (const auto& [name, kernel] : kernels) ASSERT_EQ(kernel->orient3d(a, b, c, d), truth) << name;
        }
  EXPECT_GT(zeros, 10000);
}

TEST(Lattice, InsphereOfAllQuintuplesOf2x2x2) {
  // All eight lie on one sphere; the centre of the doubled cube is the point off it.
  auto points = cubic_lattice(2);
  for (auto& p : points)
    for (double& c : p.coordinate) c *= 2;
  points.push_back({{1, 1, 1}});
  const auto kernels = exact_kernels(points);
  int zeros = 0, inside = 0;
  for (const auto& a : points)
    for (const auto& b : points)
      for (const auto& c : points)
        for (const auto& d : points)
          for (const auto& e : points) {
            const Sign truth = -sign(determinant({lifted(a), lifted(b), lifted(c), lifted(d), lifted(e)}));
            zeros += truth == Sign::zero;
            inside += truth == Sign::positive;
            for (const auto& [name, kernel] : kernels)
              ASSERT_EQ(kernel->insphere(a, b, c, d, e), truth) << name;
          }
  EXPECT_GT(zeros, 10000);
  EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace tribunal
