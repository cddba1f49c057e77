// What came of races: as JSON and as tables.
#pragma once

#include "bench/whole/race.hpp"
#include "cli/console.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::cli {

/// One comparison that was made or aimed at.
struct Comparison {
  std::string subject, rival;
  bench::Course course;
  std::uint64_t n;
  bench::Figure figure;
  std::optional<bench::Ratio> ratio;
  std::optional<double> at_most;

  std::string_view verdict() const;  ///< met, missed, no_goal or not_measured
};

/// Each of the first `ours` contestants against all others, and the goals of this course.
std::vector<Comparison> compare(std::span<const bench::Standing> standings, std::size_t ours);

/// As cli/schemas/bench_algorithms.schema.json says.
nlohmann::json races_document(std::uint64_t seed, std::span<const bench::Standing> standings,
                              std::span<const Comparison> comparisons);

void print_races(Console& console, std::span<const bench::Standing> standings,
                 std::span<const Comparison> comparisons);

}  // namespace tribunal::cli
