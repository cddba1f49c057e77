// Laws of the query families: each draws what its name promises.
#include "datasets/queries/queries.hpp"

#include "predicates/backends/exact_sign.hpp"
#include "predicates/domain.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace tribunal {
namespace {
constexpr std::size_t drawn = 2000;

/// Calls visit.operator()<Formula>(query) for `drawn` queries of the family.
template <class Formula, class Visit>
void each_query_of(const QueryFamily& family, Predicate predicate, Visit visit) {
  const auto points = [&] {
    if constexpr (Formula::dimension == 2)
      return draw_queries2(family, predicate, drawn, 1);
    else
      return draw_queries3(family, predicate, drawn, 1);
  }();
  ASSERT_EQ(points.size(), drawn * Formula::points);
  for (std::size_t i = 0; i < points.size(); i += Formula::points) {
    Query<Formula> query;
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(i), Formula::points, query.begin());
    visit.template operator()<Formula>(query);
  }
}

template <class Visit>
void each_query(const QueryFamily& family, Predicate predicate, Visit visit) {
  switch (predicate) {
    case Predicate::orient2d:
      return each_query_of<Orient<2>>(family, predicate, visit);
    case Predicate::incircle:
      return each_query_of<InSphere<2>>(family, predicate, visit);
    case Predicate::orient3d:
      return each_query_of<Orient<3>>(family, predicate, visit);
    case Predicate::insphere:
      return each_query_of<InSphere<3>>(family, predicate, visit);
  }
}

const QueryFamily& family_named(std::string_view name) {
  const QueryFamily* family = find_query_family(name);
  if (!family) throw std::runtime_error("no family " + std::string(name));
  return *family;
}

struct Shares {
  double negative = 0, zero = 0, positive = 0;
  double wrong = 0;  ///< of the determinant in plain doubles
};

Shares shares(std::string_view family, Predicate predicate) {
  Shares found;
  each_query(family_named(family), predicate, [&]<class Formula>(const Query<Formula>& query) {
    const Sign sign = exact_sign<Formula>(query);
    (sign == Sign::zero       ? found.zero
     : sign == Sign::positive ? found.positive
                              : found.negative) += 1.0 / drawn;
    found.wrong += (sign_of(Formula::determinant(query)) != sign) * 1.0 / drawn;
  });
  return found;
}

/// FNV-1a, 64 bits, of the words' bytes from the lowest.
std::uint64_t digest(const QueryFamily& family) {
  std::uint64_t value = 0xCBF29CE484222325;
  for (const Predicate predicate : all_predicates)
    each_query(family, predicate, [&]<class Formula>(const Query<Formula>& query) {
      for (const auto& p : query)
        for (const double c : p.coordinate)
          for (int byte = 0; byte < 8; ++byte)
            value = (value ^ ((std::bit_cast<std::uint64_t>(c) >> (8 * byte)) & 255)) * 0x100000001B3;
    });
  return value;
}

/// What was published with a family must stay what it was: a digest changes only together with an entry in
/// the change log.
TEST(QueryFamilies, SameSeedSameBytesForever) {
  const std::map<std::string_view, std::uint64_t> expected{
      {"uni", 0x42E3A08B719F0769},    {"int14", 0x3CC93A41DFF24637},   {"int24", 0x45E4CED6CCF7B4CE},
      {"int28", 0xB054C250360CB263},  {"int36", 0xFF4C96EB434828A1},   {"int53", 0xAF4755C7817C4775},
      {"near", 0x523D938C54B79976},   {"kettner", 0x5665C3774A3F1922}, {"tinyoff", 0x9BFB26E050880C63},
      {"degI", 0xEA1F06516A0BC1C5},   {"degF", 0x269A66EBD0107F3F},    {"mix30", 0xB1A153EF660B18C5},
      {"mix300", 0xB962F460C272CDB8}, {"tiny", 0xEC92B033A12D9771},    {"huge", 0x0B08350B3F708C57},
  };
  EXPECT_EQ(expected.size(), query_families().size());
  for (const QueryFamily& family : query_families()) {
    const auto golden = expected.find(family.name);
    const std::uint64_t pinned = golden == expected.end() ? 0 : golden->second;
    EXPECT_EQ(digest(family), pinned)
        << "{\"" << family.name << "\", 0x" << std::hex << digest(family) << "},";
  }
}

TEST(QueryFamilies, SeedsDiffer) {
  for (const QueryFamily& family : query_families()) {
    EXPECT_EQ(draw_queries2(family, Predicate::incircle, 10, 7),
              draw_queries2(family, Predicate::incircle, 10, 7));
    EXPECT_NE(draw_queries2(family, Predicate::incircle, 10, 7),
              draw_queries2(family, Predicate::incircle, 10, 8));
    EXPECT_NE(draw_queries3(family, Predicate::insphere, 10, 7),
              draw_queries3(family, Predicate::insphere, 10, 8));
  }
}

TEST(QueryFamilies, NamesFindTheirFamily) {
  std::set<std::string_view> names;
  for (const QueryFamily& family : query_families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_EQ(find_query_family(family.name), &family);
    EXPECT_FALSE(family.summary.empty()) << family.name;
  }
  EXPECT_EQ(find_query_family("nowhere"), nullptr);
  EXPECT_EQ(find_query_family(""), nullptr);
}

TEST(QueryFamilies, PointsAreFiniteAndDistinct) {
  for (const QueryFamily& family : query_families())
    for (const Predicate predicate : all_predicates) {
      std::size_t coincident = 0;
      each_query(family, predicate, [&]<class Formula>(const Query<Formula>& query) {
        for (std::size_t i = 0; i < query.size(); ++i) {
          ASSERT_TRUE(is_finite(query[i])) << family.name;
          coincident += std::find(query.begin(), query.begin() + i, query[i]) != query.begin() + i;
        }
      });
      EXPECT_LE(coincident, drawn / 1000) << family.name << ' ' << to_string(predicate);
    }
}

TEST(QueryFamilies, DegenerateOnesAreExactlyZero) {
  for (const char* family : {"degI", "degF"})
    for (const Predicate predicate : all_predicates)
      each_query(family_named(family), predicate, [&]<class Formula>(const Query<Formula>& query) {
        ASSERT_EQ(exact_sign<Formula>(query), Sign::zero) << family << ' ' << to_string(predicate);
      });
}

/// Knuth's TwoSum: what rounding took from a - b.
double rounding_error(double a, double b) {
  const double difference = a - b, b_taken = a - difference, a_kept = difference + b_taken;
  return (a - a_kept) - (b - b_taken);
}

TEST(QueryFamilies, DegFDifferencesAreInexact) {
  for (const Predicate predicate : all_predicates) {
    std::size_t inexact = 0;
    each_query(family_named("degF"), predicate, [&]<class Formula>(const Query<Formula>& query) {
      const auto rounds = [&](const auto& p, const auto& q) {
        for (int axis = 0; axis < Formula::dimension; ++axis)
          if (rounding_error(p[axis], q[axis]) != 0) return true;
        return false;
      };
      inexact += std::any_of(query.begin(), query.end(), [&](const auto& p) {
        return std::any_of(query.begin(), query.end(), [&](const auto& q) { return rounds(p, q); });
      });
    });
    EXPECT_EQ(inexact, drawn) << to_string(predicate);
  }
}

TEST(QueryFamilies, RandomOnesHoldBothSignsAlike) {
  for (const char* family : {"uni", "int14", "int24", "int28", "int36", "int53", "near", "mix30", "mix300"})
    for (const Predicate predicate : all_predicates) {
      const Shares found = shares(family, predicate);
      EXPECT_NEAR(found.positive, 0.5, 0.06) << family << ' ' << to_string(predicate);
      EXPECT_NEAR(found.negative, 0.5, 0.06) << family << ' ' << to_string(predicate);
    }
}

TEST(QueryFamilies, EasyOnesDoNotCatchDoublesAndHardOnesDo) {
  for (const Predicate predicate : all_predicates) {
    for (const char* family : {"uni", "int14", "int24", "int28", "int36", "int53"})
      EXPECT_EQ(shares(family, predicate).wrong, 0) << family << ' ' << to_string(predicate);
    for (const char* family : {"near", "kettner", "degF", "mix300", "tiny", "huge"})
      EXPECT_GE(shares(family, predicate).wrong, 0.05) << family << ' ' << to_string(predicate);
  }
}

TEST(QueryFamilies, NeighbourhoodsHoldAllThreeSigns) {
  for (const char* family : {"kettner", "tiny", "huge"})
    for (const Predicate predicate : all_predicates) {
      const Shares found = shares(family, predicate);
      EXPECT_GT(found.negative, 0.1) << family << ' ' << to_string(predicate);
      EXPECT_GT(found.zero, 0) << family << ' ' << to_string(predicate);
      EXPECT_GT(found.positive, 0.1) << family << ' ' << to_string(predicate);
    }
}

TEST(QueryFamilies, TinyoffIsHardlyEverZero) {
  for (const Predicate predicate : all_predicates) {
    const Shares found = shares("tinyoff", predicate);
    EXPECT_LT(found.zero, 0.05) << to_string(predicate);
    EXPECT_GT(std::min(found.negative, found.positive), 0.4) << to_string(predicate);
  }
}

/// Smallest and largest magnitude of the nonzero coordinates of insphere queries, and whether all are
/// integers.
struct Range {
  double smallest = HUGE_VAL, largest = 0;
  bool integers = true, negative = false;
};

Range range(std::string_view family) {
  Range found;
  for (const Point3& p : draw_queries3(family_named(family), Predicate::insphere, drawn, 1))
    for (const double c : p.coordinate) {
      if (c != 0) found.smallest = std::min(found.smallest, std::fabs(c));
      found.largest = std::max(found.largest, std::fabs(c));
      found.integers = found.integers && std::trunc(c) == c;
      found.negative = found.negative || c < 0;
    }
  return found;
}

TEST(QueryFamilies, IntegersHaveTheirBits) {
  const std::map<std::string_view, int> bits{
      {"int14", 14}, {"int24", 24}, {"int28", 28}, {"int36", 36}, {"int53", 53}};
  for (const auto& [family, b] : bits) {
    const Range found = range(family);
    EXPECT_TRUE(found.integers && !found.negative) << family;
    EXPECT_LT(found.largest, std::ldexp(1, b)) << family;
    EXPECT_GE(found.largest, std::ldexp(1, b - 1)) << family;
  }
  EXPECT_TRUE(range("degI").integers);
  EXPECT_LT(range("degI").largest, 0x1p21);
}

TEST(QueryFamilies, ExponentsReachAsFarAsPromised) {
  EXPECT_GE(range("mix30").smallest, 0x1p-100);
  EXPECT_LT(range("mix30").smallest, 0x1p-98);
  EXPECT_LT(range("mix30").largest, 0x1p101);
  EXPECT_GE(range("mix30").largest, 0x1p99);
  EXPECT_LT(range("mix300").smallest, 0x1p-990);
  EXPECT_GE(range("mix300").largest, 0x1p990);
  EXPECT_LT(range("tiny").smallest, 0x1p-1060);
  EXPECT_GE(range("huge").largest, 0x1p1023);
}

}  // namespace
}  // namespace tribunal
