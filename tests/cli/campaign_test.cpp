// run, cell and resume, as a user drives them.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace tribunal::cli {
namespace {

constexpr const char* plan_text = R"(
name = "small"
[limits]
seconds = 20
[[cells]]
algorithm = ["bowyer", "watson", "green-sibson"]
backend = ["double", "filtered", "knuth"]
dataset = ["grid", "kettner", "circle"]
n = [5, 60]
seed = "1..2"
)";

TEST(Run, DigestDoesNotDependOnTheNumberOfJobs) {
  const Folder folder;
  const std::string plan = folder.write("plan.toml", plan_text);
  const auto one =
      tribunal({"run", plan, "-o", folder / "one", "--jobs", "1", "--json", "--progress", "none"});
  const auto four =
      tribunal({"run", plan, "-o", folder / "four", "--jobs", "4", "--json", "--progress", "none"});
  ASSERT_EQ(one.status, 0) << one.err;
  ASSERT_EQ(four.status, 0) << four.err;
  EXPECT_EQ(one.json()["cells"], 3 * 3 * 3 * 2 * 2);
  EXPECT_EQ(one.json()["ran"], one.json()["cells"]);
  EXPECT_EQ(one.json()["digest"], four.json()["digest"]);
  EXPECT_EQ(one.json()["outcomes"], four.json()["outcomes"]);
}

TEST(Run, AFolderWithRowsIsRefusedUnlessResumed) {
  const Folder folder;
  const std::string plan = folder.write("plan.toml", plan_text), out = folder / "out";
  const auto first = tribunal({"run", plan, "-o", out, "--json"});
  ASSERT_EQ(first.status, 0);
  const auto again = tribunal({"run", plan, "-o", out});
  EXPECT_EQ(again.status, 2);
  EXPECT_TRUE(again.one_line_error()) << again.err;
  const auto resumed = tribunal({"run", plan, "-o", out, "--resume", "--json"});
  EXPECT_EQ(resumed.status, 0);
  EXPECT_EQ(resumed.json()["ran"], 0);
  EXPECT_EQ(resumed.json()["digest"], first.json()["digest"]);
}

TEST(Run, ProgressAsJsonIsOneObjectPerLine) {
  const Folder folder;
  const std::string plan = folder.write("plan.toml", plan_text);
  const auto ended = tribunal({"run", plan, "-o", folder / "out", "--progress", "json"});
  std::istringstream lines(ended.err);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_TRUE(nlohmann::json::parse(line).contains("done")) << line;
  EXPECT_GE(count, 108);
}

TEST(Cell, RepeatsARow) {
  const Folder folder;
  const std::string plan = folder.write("plan.toml", plan_text), out = folder / "out";
  ASSERT_EQ(tribunal({"run", plan, "-o", out}).status, 0);
  int seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out + "/rows")) {
    std::istringstream lines(read(entry.path().string()));
    for (std::string line; std::getline(lines, line) && seen < 10; ++seen) {
      const auto row = nlohmann::json::parse(line);
      const auto again = tribunal({"cell", row.at("cell").dump()}).json();
      EXPECT_EQ(again.at("key"), row.at("key"));
      EXPECT_EQ(again.at("outcome"), row.at("outcome"));
      EXPECT_EQ(again.at("counters"), row.at("counters"));
      EXPECT_EQ(again.at("digest"), row.at("digest"));
    }
  }
  EXPECT_EQ(seen, 10);
}

TEST(Claims, AClaimIsTriedAndItsVerdictIsData) {
  const auto ended = tribunal({"claims", "T5", "--json", "--progress", "none"});
  ASSERT_EQ(ended.status, 0) << ended.err << ended.out;
  const auto claim = ended.json().at("claims").at(0);
  EXPECT_EQ(claim.at("id"), "T5");
  EXPECT_EQ(claim.at("verdict"), "reproduced");
  for (const char* key : {"source", "expected", "measured", "interval", "bound", "command"})
    EXPECT_TRUE(claim.contains(key)) << key;
}

/// Who names a claim wants to know what it rests on.
TEST(Claims, ANamedOneComesWithItsEvidence) {
  const auto ended = tribunal({"claims", "G1", "--progress", "none"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const char* text :
       {"All pairs of N sites are candidates", "expected reproduced", "edges / euler_edges: 1"})
    EXPECT_NE(ended.out.find(text), std::string::npos) << text << ended.out;
}

TEST(Report, OnePageFromAFolderOfRows) {
  const Folder folder;
  const std::string plan = folder.write("plan.toml", plan_text), out = folder / "out",
                    page = folder / "report.html";
  ASSERT_EQ(tribunal({"run", plan, "-o", out}).status, 0);
  const auto ended = tribunal({"report", out, "-o", page});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string html = read(page);
  EXPECT_EQ(html.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_NE(html.find("green-sibson"), std::string::npos);
}

}  // namespace
}  // namespace tribunal::cli
