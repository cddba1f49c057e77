// What --json prints obeys the schemas that ship with the program.
#include "tests/cli/schema.hpp"

#include "algorithms/list.hpp"
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace tribunal::cli {
namespace {

nlohmann::json schema(const std::string& name) {
  return nlohmann::json::parse(
      read(std::string(TRIBUNAL_SOURCE_DIR) + "/cli/schemas/" + name + ".schema.json"));
}

TEST(Schemas, EveryDocumentObeysItsSchema) {
  const Folder folder;
  const std::string boundary =
      folder.write("triangle.poly", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n");
  const std::string points = folder / "p.xy", mesh = folder / "m.off";
  ASSERT_EQ(tribunal({"points", "grid", "-n", "20", "-o", points}).status, 0);
  ASSERT_EQ(tribunal({"triangulate", points, "-o", mesh}).status, 0);
  const std::string plan = folder.write(
      "plan.toml", "[[cells]]\nalgorithm='*'\nbackend=['gmp','knuth']\ndataset=['grid','uniform']\nn=9\n");
  const std::vector<std::pair<std::string, std::vector<std::string>>> documents{
      {"list", {"list", "algorithms"}},
      {"list", {"list", "backends"}},
      {"list", {"list", "datasets"}},
      {"list", {"list", "claims"}},
      {"list", {"list", "formats"}},
      {"list", {"list", "peers"}},
      {"points", {"points", "circle", "-n", "5"}},
      {"points", {"points", "circle", "-n", "5", "-o", folder / "c.csv"}},
      {"sign", {"sign", "orient2d", "0", "0", "0.5", "1", "1", "0"}},
      {"bench",
       {"bench", "predicates", "--backend", "filtered", "--backend", "double", "--backend", "knuth",
        "--queries", "200", "--repetitions", "2", "--progress", "none"}},
      {"bench_algorithms",
       {"bench", "algorithms", "--order", "brio", "-n", "100", "--repetitions", "2", "--progress", "none"}},
      {"bench_algorithms",
       {"bench", "algorithms", "--algorithm", "green-sibson", "--algorithm", "constrained", "--algorithm",
        "chew", "--dataset", "comb", "-n", "100", "--repetitions", "2", "--peers", "--progress", "none"}},
      {"triangulate", {"triangulate", points}},
      {"triangulate", {"triangulate", points, "--set", "location=walk"}},
      {"triangulate", {"triangulate", points, "--algorithm", "watson", "--backend", "double"}},
      {"verify", {"verify", points, mesh}},
      {"optimize", {"optimize", points, mesh, "--criterion", "minmax"}},
      {"optimize", {"optimize", points, mesh, "--criterion", "minmax-global", "--backend", "double"}},
      {"refine", {"refine", boundary, "--set", "size=0.3"}},
      {"run", {"run", plan, "-o", folder / "run", "--progress", "none"}},
      {"claims", {"claims", "T3", "P-knuth-printed", "--progress", "none"}},
      {"claims", {"report", folder / "run", "-o", folder / "report.html"}},
      {"row", {"cell", R"({"task":"bowyer","backend":"gmp","dataset":"grid","n":9})"}},
  };
  for (auto [name, words] : documents) {
    words.push_back("--json");
    const Ended ended = tribunal(words);
    ASSERT_EQ(ended.status, 0) << words[0] << ": " << ended.err;
    EXPECT_EQ(schema_fault(schema(name), ended.json()), "") << words[0];
  }
  std::istringstream rows;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "run/rows"))
    rows.str(rows.str() + read(entry.path().string()));
  int count = 0;
  for (std::string line; std::getline(rows, line); ++count)
    EXPECT_EQ(schema_fault(schema("row"), nlohmann::json::parse(line)), "") << line;
  const auto without_data = std::ranges::count_if(
      planar_algorithms(), [](const PlanarAlgorithm& algorithm) { return !algorithm.about.reads_values; });
  EXPECT_EQ(count, without_data * 4) << "two backends, two datasets";
}

TEST(Schemas, TheValidatorFindsFaults) {
  const auto rule =
      nlohmann::json::parse(R"({"type":"object","required":["a"],"properties":{"a":{"type":"integer",
      "minimum":0},"b":{"type":"array","items":{"enum":["x"]}}},"additionalProperties":false})");
  const auto fault = [&](const char* text) { return schema_fault(rule, nlohmann::json::parse(text)); };
  EXPECT_EQ(fault(R"({"a":1,"b":["x"]})"), "");
  EXPECT_NE(fault(R"({})"), "");
  EXPECT_NE(fault(R"({"a":-1})"), "");
  EXPECT_NE(fault(R"({"a":1.5})"), "");
  EXPECT_NE(fault(R"({"a":1,"b":["y"]})"), "");
  EXPECT_NE(fault(R"({"a":1,"c":1})"), "");
  EXPECT_NE(fault(R"([])"), "");
}

}  // namespace
}  // namespace tribunal::cli
