#include "reports/judges/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tribunal::reports {
namespace {

double tau(std::uint64_t n) { return 6 * static_cast<double>(n) - 15 * harmonic(n) + 10.5; }

double tau_with_ghosts(std::uint64_t n) { return 6 * static_cast<double>(n) - 9 * harmonic(n) + 1.5; }

double created(std::uint64_t n) { return 9 * static_cast<double>(n); }

double tau_uniform(std::uint64_t n) {
  double sum = 0;
  for (std::uint64_t i = 3; i <= n; ++i) {
    const auto sites = static_cast<double>(i);
    const double hull = 8.0 / 3 * (std::log(sites) + std::numbers::egamma - std::numbers::ln2);
    sum += 6 - (6 + 3 * std::max(3.0, hull)) / sites;
  }
  return sum;
}

constexpr std::array<Bound, 4> bounds{{
    {"tau", "6N - 15 H_N + 21/2", tau},
    {"tau-with-ghosts", "6N - 9 H_N + 3/2", tau_with_ghosts},
    {"created", "9N", created},
    {"tau-uniform", "sum over i = 3..N of 6 - (6 + 3 E h_i)/i", tau_uniform},
}};

}  // namespace

double harmonic(std::uint64_t n) {
  double sum = 0;
  for (std::uint64_t i = n; i > 0; --i) sum += 1 / static_cast<double>(i);  // small terms first
  return sum;
}

const Bound* find_bound(std::string_view name) {
  const auto found =
      std::find_if(bounds.begin(), bounds.end(), [&](const Bound& b) { return b.name == name; });
  return found == bounds.end() ? nullptr : &*found;
}

}  // namespace tribunal::reports
