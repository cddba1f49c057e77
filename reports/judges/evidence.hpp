// What judges share: reading rows, and stopping where rows are not what a verdict may rest on.
#pragma once

#include "bench/statistics.hpp"
#include "reports/judges/judge.hpp"

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::reports {

/// Thrown by a judge whose rows cannot carry a verdict; the trial then ends inconclusive with what() as its
/// reason.
struct Incomplete : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The counter of that name. Throws Incomplete where the row has none.
double counter(const bench::Row& row, std::string_view name);

/// Throws Incomplete unless every row ended ok: a mean over the runs that happened to finish would be a
/// biased one.
void require_finished(Rows rows);

/// "green-sibson location=walk, filtered, uniform, random order, N = 1000": a row without its seeds.
std::string describe(const bench::Row& row);

/// Rows by the number of points asked for.
std::map<std::uint64_t, std::vector<bench::Row>> by_size(Rows rows);

/// How tau (or another counter) was distributed over the runs of one kind.
struct Sample {
  std::string label;  ///< describe() of its rows
  double n = 0;
  bench::Summary summary;
};

/// The counter's distribution per kind of run, in order of first appearance. A row of an algorithm is one
/// run; a row of `tau-over-orders` already sums up many on one point set, and is a sample of its own.
std::vector<Sample> samples(Rows rows, std::string_view name);

/// The rule's parameter, or `otherwise`.
double number(const Rule& rule, std::string_view name, double otherwise);
std::string text(const Rule& rule, std::string_view name, std::string_view otherwise);
std::vector<std::string> texts(const Rule& rule, std::string_view name);

}  // namespace tribunal::reports
