// Programs on trial: what they write is read as a hostile file is.
#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

namespace tribunal::plugin_tests {
namespace {

cli::Ended try_command(const std::string& command, std::vector<std::string> more = {"-n", "30"}) {
  std::vector<std::string> words{"--command", command};
  words.insert(words.end(), more.begin(), more.end());
  return run_try(words);
}

const std::string program = std::string("'") + TRIBUNAL_PROGRAM + "'";

TEST(Commands, OurOwnProgramPassesInEveryFormat) {
  for (const char* files :
       {"{points} -o {mesh}", "{points.node} -o {mesh.ele}", "{points.csv} -o {mesh.off}"}) {
    const cli::Ended ended = try_command(program + " triangulate " + files, {"-n", "20"});
    EXPECT_EQ(ended.status, 0) << files << ended.out << ended.err;
    EXPECT_EQ(count(ended.json(), "right"), static_cast<long>(ended.json()["exercises"].size())) << files;
  }
}

TEST(Commands, APipeIsAShellCommand) {
  const cli::Ended ended = try_command("cat {points} | " + program + " triangulate - -o - >{mesh}",
                                       {"--dataset", "grid", "-n", "25"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
}

struct Hostile {
  const char* command;
  const char* outcome;
  const char* says;  ///< in some reason
};

TEST(Commands, HostileProgramsAreOutcomes) {
  const Hostile all[] = {
      {"echo garbage >{mesh}; : {points}", "wrong", "OFF expected"},
      {": {points} {mesh}", "wrong", "wrote no mesh"},
      {": {points}; : >{mesh}", "wrong", "mesh.off"},
      {": {points}; echo '1 3 0 0 0 1 99999' >{mesh.ele}", "wrong", "mesh.ele"},
      {": {points}; printf '1 3 0\\n0 0 1 99999\\n' >{mesh.ele}", "wrong", "99999"},
      {": {points}; printf '1 3 0\\n0 0 1 -7\\n' >{mesh.ele}", "wrong", "-7"},
      {": {points}; printf '1 3 0\\n0 0 0 0\\n' >{mesh.ele}", "wrong", "repeated_corner"},
      {": {points}; printf 'OFF\\n1 0 0\\n123 456 0\\n' >{mesh}", "wrong", "not the points"},
      {": {points}; printf 'OFF\\n4000000000 4000000000 0\\n' >{mesh}", "wrong", "mesh.off"},
      {": {points} {mesh}; mkdir {mesh}", "wrong", "mesh.off"},
      {": {points} {mesh}; echo no idea >&2; exit 3", "refused", "exit status 3: no idea"},
      {": {points} {mesh}; kill -SEGV $$", "crash", "signal: Segmentation fault"},
      {": {points} {mesh}; sh -c 'kill -ABRT $$'", "crash", "signal: Aborted"},
  };
  for (const auto& [command, outcome, says] : all) {
    const cli::Ended ended = try_command(command, {"--dataset", "uniform", "-n", "8"});
    EXPECT_EQ(ended.status, 1) << command << ": " << ended.err;
    EXPECT_EQ(count(ended.json(), outcome), 1) << command << ended.out;
    EXPECT_NE(ended.out.find(says), std::string::npos) << command << ended.out;
  }
}

TEST(Commands, WhatRunsOnIsStopped) {
  const cli::Ended ended =
      try_command("sleep 1000 & while :; do :; done; : {points} {mesh}", {"--seconds", "0.3", "-n", "5"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_EQ(count(ended.json(), "hang"), 3);
}

TEST(Commands, BadUsageIsOneLine) {
  const std::vector<std::vector<std::string>> all{
      {"--command", "prog {points}"},
      {"--command", "prog {mesh}"},
      {"--command", "prog {points.xyzzy} {mesh}"},
      {"--command", "prog {points} {mesh.xy}"},
      {"--command", "/nowhere/prog {points} {mesh}"},
      {"--command", "no_such_program_at_all {points} {mesh}"},
      {"--command", "true {points} {mesh}", "--plugin", "x.so"},
      {"--command", "true {points} {mesh}", "--query", "orient2d 0 0 1 1 2 2"},
      {"--command", "true {points} {mesh}", "--dataset", "nonesuch"},
      {"--command", "true {points} {mesh}", "--points", "/nowhere/points.xy"},
      {"--command", "true {points} {mesh}", "--seconds", "0"},
      {},
  };
  for (const auto& words : all) {
    const cli::Ended ended = run_try(words);
    EXPECT_EQ(ended.status, 2) << ::testing::PrintToString(words) << ended.err;
    EXPECT_TRUE(ended.one_line_error()) << ended.err;
  }
}

}  // namespace
}  // namespace tribunal::plugin_tests
