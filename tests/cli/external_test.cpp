// Datasets that are read from the user's system, where they are not there.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tribunal::cli {
namespace {

/// No files of GSHHG, as on a machine that has none.
class WithoutShores : public ::testing::Test {
 protected:
  void SetUp() override { ::setenv("TRIBUNAL_GSHHG", (folder_ / "none").c_str(), 1); }
  void TearDown() override { ::unsetenv("TRIBUNAL_GSHHG"); }
  Folder folder_;
};

TEST_F(WithoutShores, TheDatasetSaysSoInOneLine) {
  for (const char* name : {"gulf-low", "gulf-full"}) {
    const std::string file = folder_ / "a.poly";
    for (const auto& words : {std::vector<std::string>{"points", name, "-o", file},
                              std::vector<std::string>{"triangulate", name}}) {
      const Ended ended = tribunal(words);
      EXPECT_EQ(ended.status, 2);
      EXPECT_TRUE(ended.one_line_error()) << ended.err;
      EXPECT_NE(ended.err.find(std::string(name) + ": "), std::string::npos) << ended.err;
      EXPECT_NE(ended.err.find("gmt-gshhg-"), std::string::npos) << ended.err;
      EXPECT_FALSE(std::filesystem::exists(file));
    }
  }
}

TEST_F(WithoutShores, TheListNamesWhatIsMissing) {
  const Ended ended = tribunal({"list", "datasets", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  std::size_t missing = 0;
  const auto document = ended.json();
  for (const auto& dataset : document["datasets"]) missing += dataset["missing"] != "";
  EXPECT_EQ(missing, 4U);
  EXPECT_NE(tribunal({"list", "datasets"}).out.find("gulf-high: "), std::string::npos);
}

TEST_F(WithoutShores, ACampaignThatNamesOneIsRefusedAndAllDatasetsRun) {
  const auto plan = [&](const std::string& dataset) {
    return folder_.write(
        "plan.toml",
        "name = \"p\"\n[[cells]]\nalgorithm = \"bowyer\"\nbackend = \"filtered\"\nn = 9\ndataset = " +
            dataset + "\n");
  };
  const Ended named = tribunal({"run", plan("[\"grid\", \"gulf-high\"]"), "-o", folder_ / "a"});
  EXPECT_EQ(named.status, 2);
  EXPECT_TRUE(named.one_line_error()) << named.err;
  EXPECT_NE(named.err.find("gulf-high: "), std::string::npos) << named.err;
  EXPECT_EQ(tribunal({"run", plan("\"*\""), "-o", folder_ / "b", "--progress", "none"}).status, 0);
}

TEST_F(WithoutShores, AForeignFileIsRefused) {
  ::setenv("TRIBUNAL_GSHHG",
           std::filesystem::path(folder_.write("binned_GSHHS_l.nc", "text\n")).parent_path().c_str(), 1);
  const Ended ended = tribunal({"points", "gulf-low", "-o", folder_ / "a.poly"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(ended.one_line_error()) << ended.err;
}

}  // namespace
}  // namespace tribunal::cli
