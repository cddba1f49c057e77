// Given edges that cannot all be edges are refused by name; so are sites too many for a table of pairs.
#include "algorithms/abandon.hpp"
#include "tests/greedy/support.hpp"

namespace tribunal::greedy {
namespace {

const LatticeSites sites{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 0}};

void expect_refused(const std::vector<Edge>& given, const std::string& named) {
  const Plane plane(points_of(sites));
  for (const Method& method : methods) try {
      method.run({plane.problem(), given});
      ADD_FAILURE() << method.name << " accepts " << named;
    } catch (const Abandon& abandon) {
      EXPECT_EQ(abandon.outcome, Outcome::refused_input) << method.name;
      EXPECT_NE(std::string(abandon.what()).find(named), std::string::npos) << abandon.what();
    }
}

TEST(Refusals, CrossingConstraints) { expect_refused({{4, 1}, {5, 2}}, "5-2"); }
TEST(Refusals, AConstraintThroughASite) { expect_refused({{0, 2}}, "0-2"); }
TEST(Refusals, AConstraintAlongTheHullThroughASite) { expect_refused({{1, 0}}, "1-0"); }

TEST(Refusals, TooManySitesForAllPairs) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i <= most_pooled_sites; ++i)
    points.push_back({static_cast<double>(i), static_cast<double>(i % 2)});
  const Plane plane(points);
  for (const char* name : {"greedy-naive", "greedy-gilbert"}) try {
      find_planar_algorithm(name)->run(plane.problem());
      ADD_FAILURE() << name;
    } catch (const Abandon& abandon) {
      EXPECT_EQ(abandon.outcome, Outcome::refused_input);
    }
}

}  // namespace
}  // namespace tribunal::greedy
