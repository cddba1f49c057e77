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
  ASSERT_GE(peers.size(), 2U);
  EXPECT_EQ(peers[0]["name"], "cgal_epick");
  EXPECT_EQ(peers[0]["offers"].size(), 5U) << "four predicates and a triangulation: " << peers;
  EXPECT_EQ(peers[1]["offers"].size(), 4U) << peers;
}

#else

TEST(Peers, CgalIsLeftOutBecauseItIsNotInstalled) { GTEST_SKIP() << "no CGAL peer: install libcgal-dev"; }

#endif

TEST(Peers, ThatStandBesideTheProgramCanBeTried) {
  const auto peers = cli::tribunal({"list", "peers", "--json"}).json()["peers"];
  for (const auto& peer : peers)
    EXPECT_EQ(run_try({"--plugin", peer["file"], "--queries", "50", "-n", "10"}).status, 0) << peer;
}

}  // namespace
}  // namespace tribunal::plugin_tests
