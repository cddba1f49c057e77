// Uses that once went wrong, or would go wrong silently.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace tribunal::cli {
namespace {

constexpr const char* short_plan =
    "[[cells]]\nalgorithm='*'\nbackend=['gmp','double']\ndataset='grid'\nn=[9,16]\nseed='1..5'\n";

TEST(HostileUse, ClosedStandardStreamsLeaveRowsWhole) {
  const Folder folder;
  const std::string plan = folder.write("plan.toml", short_plan), out = folder / "out";
  const std::string command =
      std::string(TRIBUNAL_PROGRAM) + " run " + plan + " -o " + out + " --progress plain";
  ASSERT_EQ(std::system((command + " >/dev/null <&- 2>&-").c_str()), 0);
  const Ended again = tribunal({"run", plan, "-o", out, "--resume", "--json"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.json()["ran"], 0);
}

TEST(HostileUse, ClosedStandardOutputIsAnError) {
  EXPECT_NE(std::system((std::string(TRIBUNAL_PROGRAM) + " list backends >&- 2>/dev/null").c_str()), 0);
  EXPECT_NE(std::system((std::string(TRIBUNAL_PROGRAM) + " list backends >/dev/full 2>/dev/null").c_str()),
            0);
}

TEST(HostileUse, DevicesThatNeverEndAreBadInput) {
  for (const char* arguments : {"triangulate -", "verify - x.ele", "run /dev/zero -o never"}) {
    const std::string command =
        std::string(TRIBUNAL_PROGRAM) + " " + arguments + " </dev/zero >/dev/null 2>/dev/null";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2) << arguments;
  }
  EXPECT_FALSE(std::filesystem::exists("never"));
}

TEST(HostileUse, AMeshOverOtherVerticesIsNotVerified) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n1 0\n0 1\n");
  const std::string moved = folder.write("moved.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n");
  const std::string longer = folder.write("longer.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 0\n3 0 1 2\n");
  for (const std::string& mesh : {moved, longer}) {
    const Ended ended = tribunal({"verify", points, mesh});
    EXPECT_EQ(ended.status, 2) << mesh;
    EXPECT_TRUE(ended.one_line_error());
    EXPECT_EQ(ended.err.rfind("tribunal: " + mesh, 0), 0U) << ended.err;
  }
}

TEST(HostileUse, TheInputIsNeverOverwritten) {
  const Folder folder;
  const std::string text = "# mine\n3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
  const std::string points = folder.write("p.node", text);
  const Ended ended = tribunal({"triangulate", points, "-o", folder / "p.ele"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(read(points), text);
}

TEST(HostileUse, NoOutputIsAnInputOrAnotherOutput) {
  const Folder folder;
  const std::string text = "0 0\n4 0\n4 3\n0 3\n", points = folder.write("p.xy", text);
  const std::string mesh = folder / "m.off";
  ASSERT_EQ(tribunal({"triangulate", points, "-o", mesh}).status, 0);
  const std::string triangles = read(mesh);
  const std::string nodes = folder.write("g.node", "3 2 1 0\n0 0 0 7\n1 4 0 8\n2 4 3 9\n");
  const std::string graph = folder.write("g.poly", "0 2 0 0\n0 0\n0\n"), attributes = read(nodes);
  std::filesystem::create_directory(folder / "f.ele");
  const std::vector<std::vector<std::string>> refused{
      {"triangulate", points, "--stats", points},
      {"optimize", points, mesh, "--stats", mesh},
      {"optimize", graph, mesh, "-o", folder / "g.ele"},
      {"triangulate", points, "-o", folder / "x.off", "--stats", folder / "x.off"},
      {"triangulate", points, "--picture", folder / "x.svg", "--stats", folder / "./x.svg"},
      {"triangulate", points, "-o", "-", "--stats", "-"},
      {"triangulate", points, "-o", folder / "f.ele"},
      {"triangulate", points, "-o", folder / "y.off", "--picture", folder / "none/p.svg"},
  };
  for (const auto& words : refused) {
    const Ended ended = tribunal(words);
    EXPECT_EQ(ended.status, 2) << testing::PrintToString(words);
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
  EXPECT_EQ(read(points), text);
  EXPECT_EQ(read(mesh), triangles);
  EXPECT_EQ(read(nodes), attributes);
  for (const char* name : {"x.off", "x.svg", "y.off", "f.node"})
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
}

TEST(HostileUse, AMeshOnStandardOutputIsAMesh) {
  const Folder folder;
  const std::string points = folder / "p.xy";
  ASSERT_EQ(tribunal({"points", "circle", "-n", "30", "-o", points}).status, 0);
  const Ended mesh = tribunal({"triangulate", points, "-o", "-"});
  ASSERT_EQ(mesh.status, 0);
  EXPECT_EQ(tribunal({"verify", points, "-"}, mesh.out).status, 0);
}

TEST(HostileUse, TwoDocumentsDoNotShareStandardOutput) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"triangulate", "grid", "-o", "-", "--json"}, {"triangulate", "grid", "--stats", "-", "--json"}}) {
    const Ended ended = tribunal(words);
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(ended.out.empty());
  }
}

TEST(HostileUse, WholeNumbersAreWhatTheyLookLike) {
  for (const char* number : {"-1", "010", "0x10", "1e3", "99999999999999999999999", "7.5", ""}) {
    const Ended ended = tribunal({"points", "uniform", "-n", "3", "--seed", number});
    EXPECT_EQ(ended.status, 2) << number;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
  EXPECT_EQ(tribunal({"points", "uniform", "-n", "3", "--seed", "18446744073709551615"}).status, 0);
}

TEST(HostileUse, CellsAreReadStrictly) {
  for (const char* cell : {R"({"task":"bowyer","backend":"gmp","dataset":"grid","n":9.5})",
                           R"({"task":"bowyer","backend":"gmp","dataset":"grid","n":9,"seed":-1})",
                           R"({"task":"bowyer","backend":"gmp","dataset":"grid","n":9,"bits":4294967298})",
                           R"({"task":"bowyer","backend":"gmp","dataset":"grid","n":9,"colour":"red"})"}) {
    const Ended ended = tribunal({"cell", cell});
    EXPECT_EQ(ended.status, 2) << cell;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
}

TEST(HostileUse, SignNamesTheWordThatIsNoNumber) {
  for (const char* word : {"abc", "+-5", "1,5"}) {
    const Ended ended = tribunal({"sign", "orient2d", "0", "0", "1", "1", "2", word});
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find(word), std::string::npos) << ended.err;
  }
}

TEST(HostileUse, BackendMayBeRepeated) {
  const Ended ended =
      tribunal({"sign", "orient2d", "0", "0", "1", "0", "0", "1", "--backend", "gmp", "--backend", "double"});
  EXPECT_EQ(ended.out, "gmp     +  exact\ndouble  +  rounded\n");
}

TEST(HostileUse, ABackendNamedTwiceAnswersOnce) {
  const Ended ended =
      tribunal({"sign", "orient2d", "0", "0", "1", "0", "0", "1", "--backend", "gmp", "--backend", "gmp"});
  EXPECT_EQ(ended.out, "gmp  +  exact\n");
}

TEST(HostileUse, OutOfEveryDomainIsStatusTwoBehindTheReasons) {
  const std::vector<std::string> query{"sign", "orient2d", "0.5", "0",         "1",
                                       "0",    "0",        "1",   "--backend", "knuth"};
  const Ended alone = tribunal(query);
  EXPECT_EQ(alone.status, 2);
  EXPECT_TRUE(alone.one_line_error()) << alone.err;
  EXPECT_EQ(alone.out.rfind("knuth  out_of_domain", 0), 0U) << alone.out;
  std::vector<std::string> both = query;
  both.insert(both.end(), {"--backend", "gmp"});
  EXPECT_EQ(tribunal(both).status, 0);
}

TEST(HostileUse, SymbolicVariantsAreMentioned) {
  EXPECT_NE(tribunal({"list", "backends"}).out.find("+sos"), std::string::npos);
}

TEST(HostileUse, HelpAndErrorsHoldNoControlCharacters) {
  const auto clean = [](const std::string& text) {
    return std::all_of(text.begin(), text.end(),
                       [](unsigned char c) { return c == '\n' || !std::iscntrl(c); });
  };
  for (const char* verb : {"list", "points", "sign", "triangulate", "verify", "optimize", "refine", "run",
                           "claims", "report", "cell"})
    EXPECT_TRUE(clean(tribunal({verb, "--help"}).out)) << verb;
  EXPECT_TRUE(clean(tribunal({"triangulate", "a\nb\x1b[31m.xy"}).err));
  EXPECT_TRUE(tribunal({"triangulate", "a\nb.xy"}).one_line_error());
}

TEST(HostileUse, AnUnknownVerbIsNamed) {
  EXPECT_NE(tribunal({"dance"}).err.find("'dance'"), std::string::npos);
}

TEST(HostileUse, ALuckyEndingOfDoublesIsChecked) {
  int failed = 0;
  for (const char* seed : {"1", "2", "3", "4", "5", "6"}) {
    const Ended ended = tribunal({"triangulate", "kettner", "-n", "200", "--algorithm", "bowyer", "--backend",
                                  "double", "--seed", seed, "--json"});
    EXPECT_EQ(ended.status, ended.json()["outcome"] == "ok" ? 0 : 1);
    failed += ended.status;
  }
  EXPECT_GT(failed, 0);
}

TEST(HostileUse, PicturesOfTinyAndHugeBoxesHaveFiniteSizes) {
  const Folder folder;
  for (const char* points : {"0 0\n5e-323 0\n0 1e-322\n", "-1.7e308 0\n1.7e308 0\n0 1.7e308\n", "3 3\n"}) {
    const std::string picture = folder / "p.svg";
    ASSERT_EQ(tribunal({"triangulate", "-", "--picture", picture}, points).status, 0);
    const std::string svg = read(picture);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
}

TEST(HostileUse, ARefusalIsInTheStatistics) {
  const Folder folder;
  const std::string stats = folder / "s.json";
  EXPECT_EQ(tribunal({"triangulate", "counties", "--backend", "knuth", "--stats", stats}).status, 2);
  EXPECT_EQ(nlohmann::json::parse(read(stats))["outcome"], "out_of_domain");
}

TEST(HostileUse, FoldersThatContradictEachOtherAreRefused) {
  const Folder folder;
  const std::string plan = folder.write("plan.toml", short_plan);
  for (const char* run : {"a", "b"})
    ASSERT_EQ(tribunal({"run", plan, "-o", folder / run, "--jobs", "1"}).status, 0);
  const std::string rows = folder / "b/rows/local.jsonl";
  std::string text = read(rows);
  const std::size_t tau = text.find("\"tau\":") + 6;
  text[tau] = text[tau] == '9' ? '8' : '9';
  folder.write("b/rows/local.jsonl", text);
  const Ended ended = tribunal({"report", folder / "a", folder / "b", "-o", folder / "report.html"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
}

}  // namespace
}  // namespace tribunal::cli
