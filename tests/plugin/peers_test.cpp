// The peers that were built pass their trial; those that were not are said to be left out.
#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

namespace tribunal::plugin_tests {
namespace {

#ifdef TRIBUNAL_HAS_CGAL

void expect_clean(const std::string& peer, const std::string& queries) {
  const cli::Ended ended = run_try(
      {"--plugin", TRIBUNAL_PEERS + peer + ".so", "--queries", queries, "-n", "200", "--seconds", "60"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const auto document = ended.json();
  EXPECT_EQ(count(document, "right"), static_cast<long>(document["exercises"].size())) << ended.out;
}

TEST(Peers, CgalEpickPasses) { expect_clean("cgal_epick", "2000"); }
TEST(Peers, CgalExactPasses) { expect_clean("cgal_exact", "500"); }

TEST(Peers, AreListed) {
  const cli::Ended ended = cli::tribunal({"list", "peers", "--json"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto peers = ended.json()["peers"];
  ASSERT_GE(peers.size(), 3U);
  EXPECT_EQ(peers[0]["name"], "cgal_epick");
  EXPECT_EQ(peers[0]["offers"].size(), 5U) << "four predicates and a triangulation: " << peers;
  EXPECT_EQ(peers[1]["offers"].size(), 4U) << peers;
  EXPECT_EQ(peers[2]["offers"], nlohmann::json({"constrained", "refinement"})) << peers;
}

TEST(Peers, CgalMeshesAreRightWhereTheyAreRaced) {
  for (const std::vector<std::string>& course :
       {std::vector<std::string>{"--dataset", "comb", "--algorithm", "constrained"},
        {"--dataset", "gulf", "--algorithm", "chew", "--set", "angle=20", "--set", "size=2000"}}) {
    std::vector<std::string> words{"bench",         "algorithms", "-n",      "200",
                                   "--repetitions", "1",          "--peers", "--json"};
    words.insert(words.end(), course.begin(), course.end());
    const cli::Ended ended = cli::tribunal(words);
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    const auto times = ended.json()["times"];
    ASSERT_EQ(times.size(), 2U);
    EXPECT_EQ(times[1]["contestant"], "cgal-mesher");
    EXPECT_EQ(times[1]["outcome"], "ok") << times[1];
  }
}

#else

TEST(Peers, CgalIsLeftOutBecauseItIsNotInstalled) { GTEST_SKIP() << "no CGAL peer: install libcgal-dev"; }

#endif

TEST(Peers, ThatStandBesideTheProgramCanBeTriedUnlessTheyAreMeshersAlone) {
  const auto peers = cli::tribunal({"list", "peers", "--json"}).json()["peers"];
  for (const auto& peer : peers) {
    const cli::Ended ended = run_try({"--plugin", peer["file"], "--queries", "50", "-n", "10"});
    const bool mesher = peer["offers"][0] == "constrained";
    EXPECT_EQ(ended.status, mesher ? 2 : 0) << peer;
    if (mesher) {
      EXPECT_TRUE(ended.one_line_error()) << ended.err;
    }
  }
}

}  // namespace
}  // namespace tribunal::plugin_tests
