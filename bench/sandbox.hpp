// A function run in a process of its own, with caps on memory and time: whatever it does, the caller gets an
// ending.
#pragma once

#include "algorithms/outcome.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <sys/types.h>
#include <utility>

namespace tribunal::bench {

struct Limits {
  double seconds = 60;  ///< wall clock, enforced from outside by kill
  std::uint64_t memory_mib =
      4096;  ///< address space (resident size where a sanitizer needs the address space)
};

/// How a child ended.
struct Ending {
  Outcome outcome = Outcome::crash;  ///< ok, crash, timeout or out_of_memory
  std::string reason;                ///< one line where the outcome is not ok
  std::string result;                ///< what the function returned, where the outcome is ok
  double seconds = 0;                ///< wall clock from start to end
};

/// A forked child at work. It owns no descriptor but its result pipe, reads and prints nothing, leaves no
/// core file, never flushes what the parent had buffered, and dies with the parent. Its result passes through
/// the pipe in one checked frame: garbage or half a frame is a crash.
///
/// The parent drives it without threads or signal handlers: wait(), then advance() whatever child can. To be
/// used from one thread.
class Child {
 public:
  using Clock = std::chrono::steady_clock;

  /// Forks and runs `work`. Throws std::system_error when there is no process or pipe to be had.
  Child(const std::function<std::string()>& work, const Limits& limits);
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();  ///< kills and reaps a child that still runs

  /// Takes what has arrived and enforces the caps, without blocking. True once the child has ended, is reaped
  /// and ending() can be asked.
  bool advance();

  const Ending& ending() const { return ending_; }
  int descriptor() const { return pipe_; }  ///< readable when advance() has something to do
  Clock::time_point deadline() const { return deadline_; }

 private:
  void end(Outcome outcome, std::string reason);
  void conclude();
  int reap();

  pid_t pid_ = -1;
  int pipe_ = -1;
  Limits limits_;
  Clock::time_point start_, deadline_;
  std::string received_;
  Ending ending_;
};

/// Sleeps until a child has something to advance, or until `wake` (a descriptor, or -1) is readable. Nothing
/// to do with no children and no `wake`: returns at once.
void wait(std::span<const Child> children, int wake = -1);

/// Runs one function to its end.
Ending run_sandboxed(const std::function<std::string()>& work, const Limits& limits);

}  // namespace tribunal::bench
