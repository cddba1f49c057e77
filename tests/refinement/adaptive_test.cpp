// Refinement that follows a field.
#include "algorithms/refinement/adaptive_parameters.hpp"
#include "algorithms/verify/verify.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace tribunal::refinement {
namespace {

/// A square of side 1 with a square hole.
struct Frame {
  std::vector<Point2> points{{{0, 0}},     {{1, 0}},     {{1, 1}},     {{0, 1}},
                             {{0.4, 0.4}}, {{0.6, 0.4}}, {{0.6, 0.6}}, {{0.4, 0.6}}};
  std::vector<Edge> segments{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  std::vector<Point2> holes{{{0.5, 0.5}}};
  std::vector<Index> order{0, 1, 2, 3, 4, 5, 6, 7};
  std::unique_ptr<const Kernel2> kernel = std::move(std::get<0>(find_backend("filtered")->bind2(points)));
  Graph graph() const { return {points, segments, holes, Domain::carved}; }
};

Adapted adapt(const Frame& frame, Field& field, double tolerance) {
  return refine_by_solution(frame.graph(), frame.order, *frame.kernel, field, {{}, tolerance});
}

TEST(Adaptive, EveryTriangleMeetsTheTolerance) {
  const Frame frame;
  for (const char* name : {"shock", "slip-line", "x*x + y"})
    for (const double tolerance : {0.1, 0.01}) {
      const auto field = formula_field(name);
      const Adapted adapted = adapt(frame, *field, tolerance);
      ASSERT_EQ(adapted.refinement.report.mesh.outcome, Outcome::ok) << adapted.refinement.report.mesh.reason;
      EXPECT_LE(adapted.after, tolerance) << name;
      EXPECT_GT(adapted.before, adapted.after) << name;
      const Refined& mesh = adapted.refinement.mesh;
      double worst = 0;
      for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
          const Point2 &a = mesh.points[t[i]], &b = mesh.points[t[(i + 1) % 3]];
          worst =
              std::max(worst, std::abs(field->at(a) - field->at(b)) * std::hypot(a[0] - b[0], a[1] - b[1]));
        }
      EXPECT_NEAR(worst, adapted.after, 1e-15);
      std::vector<Edge> segments;
      for (const Subsegment& part : mesh.subsegments) segments.push_back(part.ends);
      EXPECT_TRUE(verify::verify_constrained(mesh.points, {mesh.triangles},
                                             {segments, frame.holes, verify::Domain::carved})
                      .valid());
    }
}

TEST(Adaptive, FinerTolerancesTakeMoreVertices) {
  const Frame frame;
  std::size_t before = 0;
  for (const double tolerance : {0.3, 0.03, 0.003}) {
    const auto field = formula_field("shock");
    const std::size_t vertices = adapt(frame, *field, tolerance).refinement.mesh.points.size();
    EXPECT_GT(vertices, before);
    before = vertices;
  }
}

TEST(Adaptive, AConstantFieldAsksForNothing) {
  const Frame frame;
  const auto constant = formula_field("3");
  const Refinement plain = refine_by_circumcentres(frame.graph(), frame.order, *frame.kernel, {});
  EXPECT_EQ(adapt(frame, *constant, 1e-9).refinement.mesh.triangles, plain.mesh.triangles);
}

/// Linear on all triangles because linear everywhere.
TEST(LinearField, InterpolatesWhatIsLinear) {
  const Frame frame;
  std::vector<double> values;
  for (const Point2& p : frame.points) values.push_back(2 + 3 * p[0] - p[1]);
  const auto field = linear_field(frame.graph(), frame.order, *frame.kernel, values);
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j)
      EXPECT_NEAR(field->at({{i / 20.0, j / 20.0}}), 2 + 3 * i / 20.0 - j / 20.0, 1e-14) << i << ' ' << j;
}

TEST(LinearField, TakesItsValuesAtItsPoints) {
  const auto points = find_dataset("uniform")->generate(200, 1);
  std::vector<double> values(points.size());
  std::iota(values.begin(), values.end(), 0.0);
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto kernel = std::move(std::get<0>(find_backend("filtered")->bind2(points)));
  const Graph graph{points, {}, {}, Domain::hull};
  const auto field = linear_field(graph, order, *kernel, values);
  for (Index v = 0; v < points.size(); ++v) EXPECT_DOUBLE_EQ(field->at(points[v]), v);
}

/// A square of side `side`, and two of its corners of the value `most`.
double halfway(double side, double most) {
  const std::vector<Point2> points{{{0, 0}}, {{side, 0}}, {{side, side}}, {{0, side}}};
  const std::vector<Edge> segments{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const std::vector<Index> order{0, 1, 2, 3};
  const auto kernel = std::move(std::get<0>(find_backend("filtered")->bind2(points)));
  const std::vector<double> values{0, most, most, 0};
  const Graph graph{points, segments, {}, Domain::carved};
  return linear_field(graph, order, *kernel, values)->at({{side / 2, side / 4}});
}

/// Areas, and their products with values, leave the range of doubles long before the result does.
TEST(LinearField, IsLinearAtEveryScale) {
  for (const double side : {1.0, 0x1p-1000, 0x1p-600, 0x1p520, 0x1p1000})
    for (const double most : {1.0, 0x1p-1000, 0x1p1000}) EXPECT_EQ(halfway(side, most), most / 2) << side;
}

TEST(Adaptive, RefusesFieldsThatAreNotFinite) {
  const Frame frame;
  for (const char* text : {"log(x - 2)", "1/(x - x)", "sqrt(-1 - x)"}) {
    const auto field = formula_field(text);
    const Triangulation report = adapt(frame, *field, 0.01).refinement.report.mesh;
    EXPECT_EQ(report.outcome, Outcome::refused_input) << text;
    EXPECT_NE(report.reason.find("not finite at x"), std::string::npos) << report.reason;
  }
  std::vector<double> values(frame.points.size(), 1);
  values[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(linear_field(frame.graph(), frame.order, *frame.kernel, values), Abandon);
}

TEST(AdaptiveParameters, RefuseWhatIsNone) {
  for (const char* field : {"shocks", "x +", "z", ""})
    EXPECT_NE(refuse_settings("adaptive", adaptive_parameters, {{"field", field}}), "") << field;
  for (const char* tolerance : {"0", "-1", "nan", "small"})
    EXPECT_NE(refuse_settings("adaptive", adaptive_parameters, {{"tolerance", tolerance}}), "") << tolerance;
  EXPECT_EQ(refuse_settings("adaptive", adaptive_parameters, {{"field", "shock"}, {"size", "0.1"}}), "");
}

}  // namespace
}  // namespace tribunal::refinement
