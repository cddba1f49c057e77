// Planar straight-line graphs: what the readers accept, what they make of it, and what they refuse.
#include "datasets/files/pslg.hpp"

#include "tests/datasets/support.hpp"

namespace tribunal {
namespace {

using Segments = std::vector<std::array<std::uint32_t, 2>>;
using Points = std::vector<Point2>;
using Lines = std::vector<std::uint64_t>;

PslgFile pslg_of(std::string_view name, std::string_view content) {
  const test::Folder folder;
  const auto pslg = read_pslg(folder.write(name, content));
  EXPECT_TRUE(pslg.has_value());
  return pslg.value_or(PslgFile{});
}

TEST(Pslg, PolyCountsFromZeroOrOne) {
  for (const std::string_view content : {"3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n3 0\n0 0 1\n1 1 2\n2 2 0\n1\n0 1 1\n",
                                         "# head\n3 2 1 1\n1 0 0 9 1\n2 4 0 9 1\n3 0 4 9 1\n3 1\n1 1 2 5\n2 "
                                         "2 3 -5\n3 3 1 0\n1\n1 1 1\n1\n1 2 2 7 0.5\n"}) {
    const PslgFile pslg = pslg_of("a.poly", content);
    EXPECT_EQ(pslg.sites.points, (Points{{{0, 0}}, {{4, 0}}, {{0, 4}}})) << content;
    EXPECT_EQ(pslg.segments, (Segments{{0, 1}, {1, 2}, {2, 0}})) << content;
    EXPECT_EQ(pslg.holes, (Points{{{1, 1}}})) << content;
    EXPECT_EQ(pslg.domain, "carved");
  }
}

TEST(Pslg, PolyWithoutPointsTakesThemFromTheNodeFileBeside) {
  const test::Folder folder;
  (void)folder.write("a.node", "3 2 0 0\n1 0 0\n2 4 0\n3 0 4\n");
  const auto pslg = read_pslg(folder.write("a.poly", "0 2 0 0\n1 0\n1 1 3\n0\n"));
  ASSERT_TRUE(pslg.has_value());
  EXPECT_EQ(pslg->sites.points.size(), 3U);
  EXPECT_EQ(pslg->segments, (Segments{{0, 2}}));
  EXPECT_EQ(pslg->segment_lines, (Lines{3}));
}

TEST(Pslg, PolyReadsBackAsItWasWritten) {
  const test::Folder folder;
  const Points points{{{0.1, -0.0}}, {{1e300, 5e-324}}, {{-3, 1.0 / 3}}}, holes{{{0.5, 0.25}}};
  const Segments segments{{2, 0}, {1, 2}};
  for (const std::string domain : {"carved", "even-odd", "hull"}) {
    write_poly(folder / "a.poly", points, {segments, holes, domain});
    const auto pslg = read_pslg(folder / "a.poly");
    ASSERT_TRUE(pslg.has_value());
    EXPECT_EQ(pslg->sites.points, points);
    EXPECT_EQ(pslg->segments, segments);
    EXPECT_EQ(pslg->holes, holes);
    EXPECT_EQ(pslg->domain, domain);
  }
}

// Two rings and their lines, in every spelling of the two formats that nest polygons.
TEST(Pslg, RingsBecomeClosedLoops) {
  const Points points{{{0, 0}}, {{9, 0}}, {{0, 9}}, {{1, 1}}, {{2, 1}}, {{1, 2}}};
  const Segments segments{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}};
  const std::string rings = "[[[0,0],[9,0],[0,9],[0,0]],[[1,1],[2,1, 7],[1,2],[1,1]]]";
  const std::string polygon = R"({"type":"Polygon","coordinates":)" + rings + "}";
  const std::string reversed = R"({"coordinates": )" + rings + R"( , "type" : "Polygon", "bbox":[0,0,9,9]})";
  const std::string feature =
      R"({"type":"Feature","properties":{"a":[1,{"b":"]}\""}],"type":null},"geometry":)" + reversed + "}";
  for (const auto& [name, content] : std::vector<std::pair<std::string, std::string>>{
           {"a.geojson", polygon},
           {"a.geojson", reversed},
           {"a.geojson", feature},
           {"a.geojson", R"({"type":"FeatureCollection","features":[)" + feature + "]}"},
           {"a.geojson", R"({"type":"MultiPolygon","coordinates":[)" + rings + "]}"},
           {"a.geojson", R"({"geometries":[)" + polygon + R"(],"type":"GeometryCollection"})"},
           {"a.wkt", "POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1))"},
           {"a.wkt", "SRID=4326; polygon z((0 0 5,9 0 5,0 9 5,0 0 5),(1 1 1,2 1 1,1 2 1,1 1 1));"},
           {"a.wkt", "MULTIPOLYGON(((0 0,9 0,0 9,0 0)),EMPTY,((1 1,2 1,1 2,1 1)))"},
           {"a.wkt", "POLYGON((0 0,9 0,0 9,0 0))\nPOLYGON((1 1,2 1,1 2,1 1))\nPOINT EMPTY"},
           {"a.wkt",
            "GEOMETRYCOLLECTION(GEOMETRYCOLLECTION(POLYGON((0 0,9 0,0 9,0 0))),"
            "POLYGON((1 1,2 1,1 2,1 1)))"}}) {
    const PslgFile pslg = pslg_of(name, content);
    EXPECT_EQ(pslg.sites.points, points) << content;
    EXPECT_EQ(pslg.segments, segments) << content;
    EXPECT_EQ(pslg.domain, "even-odd") << content;
    EXPECT_EQ(pslg.sites.lines.size(), 6U);
    EXPECT_EQ(pslg.segment_lines.size(), 6U);
  }
}

TEST(Pslg, LinesStayOpenAndPointsAlone) {
  for (const auto& [name, content] : std::vector<std::pair<std::string, std::string>>{
           {"a.geojson", R"({"type":"GeometryCollection","geometries":[{"type":"LineString","coordinates":
              [[0,0],[1,0],[1,1]]},{"type":"MultiPoint","coordinates":[[5,5],[6,6]]}]})"},
           {"a.wkt", "LINESTRING(0 0,1 0,1 1) MULTIPOINT((5 5),6 6)"}}) {
    const PslgFile pslg = pslg_of(name, content);
    EXPECT_EQ(pslg.sites.points, (Points{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{5, 5}}, {{6, 6}}})) << content;
    EXPECT_EQ(pslg.segments, (Segments{{0, 1}, {1, 2}})) << content;
    EXPECT_EQ(pslg.domain, "hull");
  }
}

TEST(Pslg, CommentsMayStandBetweenTokens) {
  const PslgFile wkt = pslg_of("a.wkt", "# a map\n#\nLINESTRING(0 0, # from\n 1 0#to\n)\n# end");
  EXPECT_EQ(wkt.sites.points, (Points{{{0, 0}}, {{1, 0}}}));
  EXPECT_EQ(wkt.sites.lines, (Lines{3, 4}));
  const PslgFile json = pslg_of(
      "a.geojson", "# a map\n{\"type\": \"LineString\", # \"no\"\n\"coordinates\": [[0, 0], [1, 0]]}");
  EXPECT_EQ(json.sites.points, (Points{{{0, 0}}, {{1, 0}}}));
}

TEST(Pslg, LinesAreThoseOfTheFile) {
  const PslgFile pslg = pslg_of("a.wkt", "LINESTRING(\n0 0,\n\n1 0,\n1 1)");
  EXPECT_EQ(pslg.sites.lines, (Lines{2, 4, 5}));
  EXPECT_EQ(pslg.segment_lines, (Lines{4, 5}));
}

TEST(Pslg, OtherFormatsHoldNoSegments) {
  const test::Folder folder;
  EXPECT_FALSE(read_pslg(folder.write("a.xy", "0 0\n")).has_value());
  EXPECT_FALSE(read_pslg("-").has_value());
}

TEST(Pslg, PointsCanBeReadAlone) {
  const test::Folder folder;
  const auto file = read_points(folder.write("a.wkt", "LINESTRING(0 0,1 0)"));
  EXPECT_EQ(file.points, (Points{{{0, 0}}, {{1, 0}}}));
  EXPECT_EQ(file.lines, (Lines{1, 1}));
}

struct Bad {
  std::string name, content, expected;
};
std::ostream& operator<<(std::ostream& out, const Bad& bad) { return out << bad.expected; }
class BadPslg : public ::testing::TestWithParam<Bad> {};

TEST_P(BadPslg, IsRefusedWithItsPlace) {
  const test::Folder folder;
  const auto path = folder.write(GetParam().name, GetParam().content);
  std::string found = "accepted";
  try {
    (void)read_pslg(path);
  } catch (const BadInput& error) {
    found = error.what();
  }
  EXPECT_EQ(found, (folder / GetParam().expected).string());
}

const std::string three = "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n";

INSTANTIATE_TEST_SUITE_P(
    Poly, BadPslg,
    ::testing::ValuesIn(std::vector<Bad>{
        {"a.poly", "", "a.poly: no points"},
        {"a.poly", "0 2 0 0\n", "a.node: cannot read: No such file or directory"},
        {"a.poly", "2 2 0 0\n0 0 0\n1 nan 0\n", "a.poly:3:3: x is \"nan\", not finite"},
        {"a.poly", three + "1 0\n0 0 3\n", "a.poly:6:5: vertex 3 is outside 0..2"},
        {"a.poly", three + "1 0\n0 1 1\n",
         "a.poly:6:5: a segment without length: both ends are the same point"},
        {"a.poly", "2 2 0 0\n0 0 0\n1 -0 0\n1 0\n0 0 1\n",
         "a.poly:5:5: a segment without length: both ends are the same point"},
        {"a.poly", three + "2 0\n0 0 1\n", "a.poly:5: 2 segments announced, 1 found"},
        {"a.poly", three + "2000000000 0\n0 0 1\n", "a.poly:5: 2000000000 segments announced, 1 found"},
        {"a.poly", three + "0 0\n1\n", "a.poly:6: 1 holes announced, 0 found"},
        {"a.poly", three + "0 0\n1\n0 1 inf\n", "a.poly:7:5: y is \"inf\", not finite"},
        {"a.poly", three + "0 0\n0\n0\n7\n", "a.poly:8: more than the 0 regions announced in line 7"},
        {"a.poly", three + "-1 0\n", "a.poly:5:1: the number of segments is \"-1\", not a count"},
    }));

INSTANTIATE_TEST_SUITE_P(
    Wkt, BadPslg,
    ::testing::ValuesIn(std::vector<Bad>{
        {"a.wkt", " \n", "a.wkt: no points"},
        {"a.wkt", "POINT EMPTY", "a.wkt: no points"},
        {"a.wkt", "CIRCLE(0 0)", "a.wkt:1:1: \"CIRCLE\" is no geometry that is read here"},
        {"a.wkt", "POLYGON((0 0,1 0,1 1,0 1))",
         "a.wkt:1:9: an open ring: it begins at (0, 0) in line 1 and ends at (0, 1)"},
        {"a.wkt", "POLYGON((0 0,1 0,0 0))", "a.wkt:1:9: a ring of less than three points"},
        {"a.wkt", "POLYGON((0 0,1 0,\n1 0,1 1,0 0))",
         "a.wkt:2:1: a segment without length: (1, 0) follows itself"},
        {"a.wkt", "LINESTRING(0 0)", "a.wkt:1:11: a line of one point"},
        {"a.wkt", "LINESTRING(0 0,1 nan)", "a.wkt:1:18: y is \"nan\", not finite"},
        {"a.wkt", "LINESTRING(0 0,1)", "a.wkt:1:17: y is missing, found \")\""},
        {"a.wkt", "LINESTRING(0 0,1 1", "a.wkt:1:19: ')' expected, found the end of the file"},
        {"a.wkt", "GEOMETRYCOLLECTION(POINT(0 0)", "a.wkt:1:30: ')' expected, found the end of the file"},
    }));

INSTANTIATE_TEST_SUITE_P(
    GeoJson, BadPslg,
    ::testing::ValuesIn(std::vector<Bad>{
        {"a.geojson", "", "a.geojson:1:1: '{' expected, found the end of the file"},
        {"a.geojson", "{}", "a.geojson:1:1: \"type\" is missing"},
        {"a.geojson", R"({"type":"Feature","geometry":null})", "a.geojson: no points"},
        {"a.geojson", R"({"type":"Sphere","coordinates":[1]})",
         "a.geojson:1:32: \"Sphere\" is no geometry of GeoJSON"},
        {"a.geojson", R"({"type":"Point","coordinates":[1]})", "a.geojson:1:33: ',' expected, found \"]\""},
        {"a.geojson", "{\"type\":\"Point\",\n\"coordinates\":[1,null]}",
         "a.geojson:2:18: y is \"null\", not a number"},
        {"a.geojson", R"({"type":"Point","coordinates":[1,1e999]})",
         "a.geojson:1:34: y is \"1e999\", outside the range of doubles"},
        {"a.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]})",
         "a.geojson:1:34: an open ring: it begins at (0, 0) in line 1 and ends at (1, 1)"},
        {"a.geojson", R"({"type":"Point","coordinates":[1,2]} 3)",
         "a.geojson:1:38: nothing may follow the one object of the file"},
        {"a.geojson", R"({"type":"Point)", "a.geojson:1:9: a string without end"},
        {"a.geojson", R"({"type":,"coordinates":[1,2]})", "a.geojson:1:9: '\"' expected, found \",\""},
    }));

// Nesting cannot exhaust the stack.
TEST(BadPslg, DeepNesting) {
  const test::Folder folder;
  std::string nested;
  for (int i = 0; i < 100000; ++i) nested += R"({"type":"GeometryCollection","geometries":[)";
  EXPECT_THROW((void)read_pslg(folder.write("a.geojson", nested)), BadInput);
  EXPECT_THROW((void)read_pslg(folder.write(
                   "b.geojson", "{\"type\":\"Point\",\"coordinates\":" + std::string(1000000, '[') + "1")),
               BadInput);
  std::string collections;
  for (int i = 0; i < 100000; ++i) collections += "GEOMETRYCOLLECTION(";
  EXPECT_THROW((void)read_pslg(folder.write("a.wkt", collections)), BadInput);
}

}  // namespace
}  // namespace tribunal
