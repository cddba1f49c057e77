// Programs on trial: what they write is read as a hostile file is.
#include "predicates/predicate.hpp"
#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

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

/// Two seconds of the program in a shell, then an interrupt.
int interrupted_status(const std::string& words) {
  const int status = std::system(("timeout --preserve-status -s INT 2 " + program + " " + words).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Commands, AnInterruptPrintsWhatThereIsAndLeavesNothingBehind) {
  const cli::Folder folder;
  const std::string out = folder / "out", pid = folder / "pid";
  const std::string command = "sleep 1000 & echo $! >" + pid + "; wait; : {points} {mesh}";
  std::filesystem::create_directory(folder / "scratch");
  setenv("TMPDIR", (folder / "scratch").c_str(), 1);
  const int status =
      interrupted_status("try --command '" + command + "' --seconds 600 --json --progress none >" + out);
  unsetenv("TMPDIR");
  EXPECT_EQ(status, 1);
  const auto document = nlohmann::json::parse(cli::read(out));
  EXPECT_FALSE(document["clean"]);
  ASSERT_EQ(document["exercises"].size(), 1U);
  EXPECT_EQ(document["exercises"][0]["reason"], "interrupted");
  EXPECT_TRUE(std::filesystem::is_empty(folder / "scratch"));
  const std::string sleeper = "/proc/" + std::to_string(std::stoi(cli::read(pid)));
  for (int tries = 0; tries < 100 && std::filesystem::exists(sleeper); ++tries)  // until it is reaped
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(std::filesystem::exists(sleeper));
}

TEST(Commands, AnInterruptedBenchPrintsWhatWasMeasured) {
  const cli::Folder folder;
  const std::string out = folder / "out";
  EXPECT_EQ(interrupted_status("bench predicates --json --repetitions 10000 --queries 20000 --progress none "
                               "--backend double --family uni 2>/dev/null >" +
                               out),
            1);
  const auto document = nlohmann::json::parse(cli::read(out));
  EXPECT_GE(document["cells"].size(), 1U);
  EXPECT_LT(document["cells"].size(), all_predicates.size());  // it did not end by itself
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
      {"--command", "true {points} {mesh}", "--seconds", "nan"},
      {"--command", "true {points} {mesh}", "--seconds", "1e300"},
      {"--command", "true {points} {mesh}", "--query", ""},
      {"--command", "true {points} {mesh}", "--picture", "/proc/nowhere"},
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
