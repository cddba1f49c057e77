#include "bench/outsider/watched.hpp"

#include <cstdint>
#include <poll.h>

namespace tribunal::bench {
namespace {

constexpr double three_years = 1e8;  // seconds: the sandbox has no word for "no limit"
constexpr int tick_milliseconds = 100;

bool is_readable(int descriptor) {
  pollfd polled{descriptor, POLLIN, 0};
  return descriptor >= 0 && poll(&polled, 1, 0) == 1;
}

}  // namespace

Ending run_watched(const std::function<std::string()>& work, const LifeSigns& life,
                   std::chrono::milliseconds patience, const std::function<void()>& tick) {
  using Clock = Child::Clock;
  const Clock::time_point start = Clock::now();
  Child child(work, {.seconds = three_years});
  std::uint64_t last_beat = life.beats.value();
  Clock::time_point alive = start;
  while (!child.advance()) {
    pollfd result{child.descriptor(), POLLIN, 0};
    poll(&result, 1, tick_milliseconds);
    tick();
    const Clock::time_point now = Clock::now();
    if (const std::uint64_t beat = life.beats.value(); beat != last_beat) {
      last_beat = beat;
      alive = now;
    } else if (now - alive > patience) {
      return {.outcome = Outcome::timeout,
              .reason = "no answer for " + std::to_string(patience.count() / 1000) + " s",
              .result = {},
              .seconds = std::chrono::duration<double>(now - start).count()};
    }
  }
  return child.ending();
}

std::optional<Ending> run_unless_woken(const std::function<std::string()>& work, const Limits& limits,
                                       int wake) {
  Child child(work, limits);
  while (!child.advance()) {
    wait({&child, 1}, wake);
    if (is_readable(wake)) return std::nullopt;
  }
  return child.ending();
}

}  // namespace tribunal::bench
