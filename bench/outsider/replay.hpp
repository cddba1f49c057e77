// Command lines that show a counterexample again.
#pragma once

#include "bench/fuzz/case.hpp"
#include "predicates/point.hpp"

#include <span>
#include <string>
#include <string_view>

namespace tribunal::bench {

/// A word as a POSIX shell reads it: in single quotes unless nothing in it needs them.
std::string shell_word(std::string_view text);

/// tribunal try OUTSIDER --query 'orient2d 0x1p-1 ...'. `outsider` is "--plugin x.so" or "--command ...",
/// ready for a shell; so below.
std::string replay_query(const std::string& outsider, const fuzz::Case& asked);

/// printf 'x y\n...' | tribunal try OUTSIDER --points -
std::string replay_points(const std::string& outsider, std::span<const Point2> points);

/// tribunal try OUTSIDER --dataset grid -n 200 --seed 1
std::string replay_dataset(const std::string& outsider, std::string_view dataset, std::uint64_t n,
                           std::uint64_t seed);

}  // namespace tribunal::bench
