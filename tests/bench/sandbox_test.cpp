// Law: whatever a function does to its process, the caller gets the outcome that says so, and no process is
// left.
#include "bench/sandbox.hpp"

#include "bench/frame.hpp"
#include "tests/bench/support.hpp"

#include <gmpxx.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <memory>
#include <new>
#include <signal.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace tribunal::bench {
namespace {

/// The child's only descriptor beyond the standard three.
int result_pipe() {
  int descriptor = 3;
  while (fcntl(descriptor, F_GETFD) < 0) ++descriptor;
  return descriptor;
}

void expect_no_children() {
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

Ending run(const std::function<std::string()>& work, const Limits& limits = {}) {
  const Ending ending = run_sandboxed(work, limits);
  expect_no_children();
  return ending;
}

[[noreturn]] void spin() {
  for (std::uint64_t i = 0;; ++i) asm volatile("" : : "r"(i));  // work that no compiler may leave out
}

// Takes memory and touches it until there is none.
std::string hog() {
  std::vector<std::unique_ptr<char[]>> held;
  for (;;) {
    held.push_back(std::make_unique<char[]>(1 << 20));
    std::memset(held.back().get(), 1, 1 << 20);
  }
}

TEST(Sandbox, ResultComesBackAsItIs) {
  std::string every_byte;
  for (int i = 0; i < 256; ++i) every_byte += static_cast<char>(i);
  for (const std::string& text : {std::string(), std::string("a"), every_byte, std::string(5'000'000, 'x')}) {
    const Ending ending = run([&] { return text; });
    EXPECT_EQ(ending.outcome, Outcome::ok) << ending.reason;
    EXPECT_EQ(ending.result, text);
  }
}

TEST(Sandbox, SignalIsACrash) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGTERM, SIGPIPE}) {
    const Ending ending = run([&]() -> std::string {
      raise(signal);
      return "survived";
    });
    EXPECT_EQ(ending.outcome, Outcome::crash) << signal;
    EXPECT_EQ(ending.reason, std::string("signal: ") + strsignal(signal));
  }
}

TEST(Sandbox, BadAccessAndAbortAreCrashes) {
  EXPECT_EQ(run([]() -> std::string {
              volatile int* volatile nowhere = nullptr;
              *nowhere = 1;
              return "survived";
            }).outcome,
            Outcome::crash);
  EXPECT_EQ(run([]() -> std::string { std::abort(); }).outcome, Outcome::crash);
}

TEST(Sandbox, ExceptionIsACrashThatSaysWhich) {
  const Ending ending = run([]() -> std::string { throw std::runtime_error("such and such"); });
  EXPECT_EQ(ending.outcome, Outcome::crash);
  EXPECT_EQ(ending.reason, "exception: such and such");
  EXPECT_EQ(run([]() -> std::string { throw 3; }).outcome, Outcome::crash);
}

TEST(Sandbox, ExitWithoutAResultIsACrash) {
  EXPECT_EQ(run([]() -> std::string { _exit(0); }).reason, "exit status 0 without a result");
  EXPECT_EQ(run([]() -> std::string { _exit(7); }).reason, "exit status 7 without a result");
}

TEST(Sandbox, EndlessLoopIsATimeout) {
  const Limits limits{.seconds = 0.2};
  EXPECT_EQ(run([]() -> std::string { spin(); }, limits).outcome, Outcome::timeout);
}

TEST(Sandbox, EndlessSleepIsATimeout) {
  const Limits limits{.seconds = 0.2};
  const Ending ending = run(
      []() -> std::string {
        for (;;) pause();
      },
      limits);
  EXPECT_EQ(ending.outcome, Outcome::timeout);
  EXPECT_EQ(ending.reason, "more than 0.2 s");
}

TEST(Sandbox, IgnoredSignalsDoNotSaveALoop) {
  const Ending ending = run(
      []() -> std::string {
        for (int number = 1; number < SIGRTMIN; ++number) signal(number, SIG_IGN);
        spin();
      },
      {.seconds = 0.2});
  EXPECT_EQ(ending.outcome, Outcome::timeout);
}

TEST(Sandbox, MemoryBeyondTheCapIsOutOfMemory) {
  const Ending ending = run(hog, {.memory_mib = 512});
  EXPECT_EQ(ending.outcome, Outcome::out_of_memory) << ending.reason;
}

TEST(Sandbox, MemoryMayRunOutWhereNothingCanBeThrown) {
  const auto unthrowing = []() noexcept { return hog(); };
  EXPECT_EQ(run(unthrowing, {.memory_mib = 512}).outcome, Outcome::out_of_memory);
}

TEST(Sandbox, MemoryMayRunOutInsideGmp) {
  const Ending ending = run(
      []() -> std::string {
        mpz_class number = 1;
        number <<= 8ull << 30;  // a gigabyte
        number -= 1;
        spin();
      },
      {.memory_mib = 512});
  EXPECT_EQ(ending.outcome, Outcome::out_of_memory) << ending.reason;
}

TEST(Sandbox, KilledFromOutsideCountsAsOutOfMemory) {
  const Ending ending = run([]() -> std::string {
    raise(SIGKILL);
    return "survived";
  });
  EXPECT_EQ(ending.outcome, Outcome::out_of_memory);
}

TEST(Sandbox, GarbageIsACrash) {
  const std::string whole = encode_frame(Message::result, "right");
  std::string damaged = whole;
  damaged.back() = 'x';
  const std::string garbage[] = {
      "x",    std::string(100'000, 'g'), whole.substr(0, 10), whole.substr(0, whole.size() - 1), whole + "x",
      damaged};
  for (const std::string& bytes : garbage) {
    const Ending ending = run([&]() -> std::string {
      EXPECT_EQ(write(result_pipe(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
      _exit(0);
    });
    EXPECT_EQ(ending.outcome, Outcome::crash) << bytes.size();
    EXPECT_EQ(ending.result, "");
  }
}

TEST(Sandbox, GarbageBeforeTheResultIsACrash) {
  const Ending ending = run([]() -> std::string {
    EXPECT_EQ(write(result_pipe(), "x", 1), 1);
    return "right";
  });
  EXPECT_EQ(ending.outcome, Outcome::crash);
}

TEST(Sandbox, AChildThatHangsUpIsACrash) {
  const Ending ending = run([]() -> std::string {
    close(result_pipe());
    spin();
  });
  EXPECT_EQ(ending.outcome, Outcome::crash);
  EXPECT_EQ(ending.reason, "closed its result pipe and ran on");
}

TEST(Sandbox, WhatTheParentHasBufferedIsWrittenOnce) {
  const TemporaryFolder folder;
  FILE* file = fopen((folder / "buffered").c_str(), "w");
  fputs("once", file);
  EXPECT_EQ(run([&]() -> std::string {
              fputs("never", file);
              fflush(nullptr);
              return "";
            }).outcome,
            Outcome::ok);
  fclose(file);
  EXPECT_EQ(read_file(folder / "buffered"), "once");
}

TEST(Sandbox, ExitFlushesNothingOfTheParents) {
  const TemporaryFolder folder;
  FILE* file = fopen((folder / "buffered").c_str(), "w");
  fputs("once", file);
  EXPECT_EQ(run([]() -> std::string { std::exit(0); }).reason, "exit status 0 without a result");
  fclose(file);
  EXPECT_EQ(read_file(folder / "buffered"), "once");
}

TEST(Sandbox, WhatAChildPrintsGoesNowhere) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run([]() -> std::string {
    std::cout << "printed" << std::flush;
    std::cerr << "printed" << std::flush;
    return "";
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Sandbox, AChildHasNoDescriptorButItsPipe) {
  const Ending ending = run([]() -> std::string {
    int open_ones = 0;
    for (int descriptor = 0; descriptor < 1024; ++descriptor) open_ones += fcntl(descriptor, F_GETFD) >= 0;
    return std::to_string(open_ones);
  });
  EXPECT_EQ(ending.result, "4");
}

TEST(Sandbox, ManyAtOnceKeepTheirResultsApart) {
  std::vector<Child> children;
  for (int i = 0; i < 8; ++i) {
    const auto work = [i]() -> std::string {
      if (i % 4 == 1) std::abort();
      if (i % 4 == 2) spin();
      return std::to_string(i);
    };
    children.emplace_back(work, Limits{.seconds = 0.3});
  }
  for (std::size_t i = 0; i < children.size(); ++i) {
    while (!children[i].advance()) wait({&children[i], 1});
    const Outcome expected = i % 4 == 1 ? Outcome::crash : i % 4 == 2 ? Outcome::timeout : Outcome::ok;
    EXPECT_EQ(children[i].ending().outcome, expected) << i;
    EXPECT_EQ(children[i].ending().result, expected == Outcome::ok ? std::to_string(i) : "");
  }
  expect_no_children();
}

TEST(Sandbox, AnAbandonedChildIsKilled) {
  {
    const Child child([]() -> std::string { spin(); }, {});
  }
  expect_no_children();
}

}  // namespace
}  // namespace tribunal::bench
