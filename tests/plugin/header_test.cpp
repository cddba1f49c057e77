// The headers go together: all included here, in any order, they agree on one version.
#include "algorithms/plugin/tribunal_mesher.h"
#include "algorithms/plugin/tribunal_triangulator.h"
#include "predicates/plugin/tribunal_predicates.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <type_traits>

namespace {

TEST(Headers, AreOfOneVersionAndPlainData) {
  EXPECT_EQ(TRIBUNAL_PLUGIN_VERSION, 1);
  EXPECT_TRUE(std::is_standard_layout_v<tribunal_predicates> && std::is_trivial_v<tribunal_predicates>);
  EXPECT_TRUE(std::is_standard_layout_v<tribunal_triangulator> && std::is_trivial_v<tribunal_triangulator>);
  EXPECT_TRUE(std::is_standard_layout_v<tribunal_mesher> && std::is_trivial_v<tribunal_mesher>);
}

/// The loader reads the version of structures that it does not know: it must stay the first member.
TEST(Headers, BeginWithTheVersion) {
  EXPECT_EQ(offsetof(tribunal_predicates, version), 0U);
  EXPECT_EQ(offsetof(tribunal_triangulator, version), 0U);
  EXPECT_EQ(offsetof(tribunal_mesher, version), 0U);
}

}  // namespace
