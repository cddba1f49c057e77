// Pictures and data as users meet them.
#include "tests/cli/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace tribunal::cli {
namespace {

/// Points with a third column: a roof over a 4 x 4 grid, somewhat bent so that no four lie on a circle.
std::string roof() {
  std::string text;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      text += std::to_string(100 * i + 7 * j * j) + " " + std::to_string(100 * j + 3 * i * i) + " " +
              std::to_string(i > j ? i : j) + "\n";
  return text;
}

TEST(Pictures, OfEveryKindAreDrawn) {
  const Folder folder;
  const std::string points = folder.write("p.xy", roof()), png = folder / "p.png", svg = folder / "p.svg";
  for (const std::string colour : {"plain", "angle", "smallest-angle", "field"})
    for (const std::string& file : {png, svg}) {
      std::filesystem::remove(file);
      ASSERT_EQ(tribunal({"triangulate", points, "--picture", file, "--colour", colour, "--contours", "5",
                          "--window", "-10,-10,200,200"})
                    .status,
                0);
      EXPECT_EQ(read(file).substr(0, 4), file == png ? "\x89PNG" : "<svg") << colour;
    }
}

TEST(Pictures, FieldsComeFromTheColumnOrAFunction) {
  const Folder folder;
  const std::string with = folder.write("with.xy", roof()),
                    without = folder.write("without.xy", "0 0\n1 0\n0 1\n");
  const std::string picture = folder / "p.svg", mesh = folder / "m.off";
  const Ended refused =
      tribunal({"triangulate", without, "--picture", picture, "--contours", "3", "-o", mesh});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(refused.one_line_error()) << refused.err;
  EXPECT_NE(refused.err.find("without.xy: the picture shows the third column"), std::string::npos)
      << refused.err;
  EXPECT_FALSE(std::filesystem::exists(mesh)) << "refused before anything was written";
  ASSERT_EQ(
      tribunal({"triangulate", without, "--picture", picture, "--contours", "3", "--field", "F1"}).status, 0);
  const std::string function = read(picture);
  ASSERT_EQ(tribunal({"triangulate", with, "--picture", picture, "--contours", "3"}).status, 0);
  EXPECT_NE(read(picture), function);
  const std::string far = folder.write("far.xy", "0 -1e300\n1 0\n0 1\n");
  const Ended infinite =
      tribunal({"triangulate", far, "--picture", picture, "--contours", "3", "--field", "F1"});
  EXPECT_EQ(infinite.status, 2);
  EXPECT_NE(infinite.err.find("no finite value at point 0"), std::string::npos) << infinite.err;
}

TEST(Pictures, OptionsThatMeanNothingAreRefused) {
  const Folder folder;
  const std::string points = folder.write("p.xy", roof()), picture = folder / "p.svg";
  const std::vector<std::vector<std::string>> senseless{
      {"--colour", "angle"},
      {"--window", "0,0,1,1"},
      {"--picture", picture, "--colour", "rainbow"},
      {"--picture", picture, "--window", "0,0,1"},
      {"--picture", picture, "--window", "1,0,0,1"},
      {"--picture", picture, "--window", "0,0,1,x"},
      {"--picture", picture, "--window", "0,0,1,1,"},
      {"--picture", picture, "--contours", "101"},
      {"--picture", picture, "--field", "F7", "--contours", "3"},
      {"--picture", picture, "--field", "F1"},
      {"--picture", picture, "--against", points},
      {"--picture", folder / "p.jpg"}};
  for (const auto& options : senseless) {
    std::vector<std::string> arguments{"triangulate", points};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended ended = tribunal(arguments);
    EXPECT_EQ(ended.status, 2) << options.back();
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(Pictures, AgainstItselfNothingStandsOut) {
  const Folder folder;
  const std::string points = folder.write("p.xy", roof()), mesh = folder / "m.off",
                    picture = folder / "p.svg";
  const auto draw = [&](const std::string& algorithm) {
    EXPECT_EQ(
        tribunal({"triangulate", points, "--algorithm", algorithm, "--picture", picture, "--against", mesh})
            .status,
        0);
    return read(picture).find("#b3261e") != std::string::npos;
  };
  ASSERT_EQ(tribunal({"triangulate", points, "-o", mesh}).status, 0);
  EXPECT_FALSE(draw("bowyer"));
  EXPECT_TRUE(draw("data-dependent"));
}

TEST(Pictures, TheMeshThatTheyAreAgainstIsNotOverwritten) {
  const Folder folder;
  const std::string points = folder.write("p.xy", "0 0\n1 0\n1 1\n0 1\n"),
                    mesh =
                        folder.write("m.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"),
                    other =
                        folder.write("o.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 3\n3 1 2 3\n"),
                    before = read(other), picture = folder / "x.svg";
  for (const char* option : {"-o", "--stats"}) {
    const Ended optimized =
        tribunal({"optimize", points, mesh, "--picture", picture, "--against", other, option, other});
    EXPECT_EQ(optimized.status, 2);
    EXPECT_NE(optimized.err.find("o.off would overwrite the input"), std::string::npos) << optimized.err;
    EXPECT_EQ(
        tribunal({"triangulate", points, "--picture", picture, "--against", other, option, other}).status, 2);
  }
  EXPECT_EQ(read(other), before);
}

TEST(DataDependent, ReadsTheThirdColumn) {
  const Folder folder;
  const std::string with = folder.write("with.xy", roof()),
                    without = folder.write("without.csv", "0,0\n1,0\n0,1\n");
  const std::string mesh = folder / "m.off", better = folder / "better.off";
  ASSERT_EQ(tribunal({"triangulate", with, "--algorithm", "data-dependent", "-o", better}).status, 0);
  EXPECT_EQ(tribunal({"verify", with, better, "--kind", "triangulation"}).status, 0);
  const Ended refused = tribunal({"triangulate", without, "--algorithm", "data-dependent", "-o", mesh});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(refused.one_line_error()) << refused.err;
  EXPECT_NE(refused.err.find("without.csv: data-dependent reads data values from the third column"),
            std::string::npos)
      << refused.err;
  EXPECT_FALSE(std::filesystem::exists(mesh));
  EXPECT_EQ(tribunal({"triangulate", without, "--algorithm", "data-dependent", "--set", "data=F3"}).status,
            0);
}

/// Flipping the Delaunay mesh is what the algorithm does, so both ways end in the same mesh.
TEST(DataDependent, OptimizesAUsersMesh) {
  const Folder folder;
  const std::string points = folder.write("p.xy", roof()), bare = folder.write("bare.xy", "0 0\n1 0\n0 1\n");
  const std::string mesh = folder / "m.off", better = folder / "better.off", direct = folder / "direct.off";
  ASSERT_EQ(tribunal({"triangulate", points, "-o", mesh}).status, 0);
  for (const std::string search : {"sweeps", "shuffled", "stack", "best", "look-ahead", "annealing"}) {
    const Ended ended = tribunal({"optimize", points, mesh, "--criterion", "data-dependent", "--set",
                                  "cost=abn", "--set", "search=" + search, "-o", better, "--json"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(tribunal({"verify", points, better, "--kind", "triangulation"}).status, 0);
    const Ended same = tribunal({"triangulate", points, "--algorithm", "data-dependent", "--set", "cost=abn",
                                 "--set", "search=" + search, "-o", direct, "--json"});
    EXPECT_EQ(same.json()["digest"], ended.json()["digest"]) << search;
  }
  ASSERT_EQ(tribunal({"triangulate", bare, "-o", mesh}).status, 0);
  const Ended refused = tribunal({"optimize", bare, mesh, "--criterion", "data-dependent"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("third column"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace tribunal::cli
