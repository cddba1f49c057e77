#include "bench/sandbox.hpp"

#include "bench/frame.hpp"
#include "bench/sandbox_child.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <signal.h>
#include <string>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace tribunal::bench {
namespace {

// Longer than any result there is: a child that writes more is writing garbage.
constexpr std::size_t longest_result = std::size_t{256} << 20;

// How long a child that has closed its pipe may take to exit.
constexpr int exit_grace_milliseconds = 1000;

// How often the resident size is looked at, where it must be.
constexpr std::chrono::milliseconds watch_interval{20};

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

std::uint64_t resident_bytes(pid_t pid) {
  std::ifstream statm("/proc/" + std::to_string(pid) + "/statm");
  std::uint64_t size = 0, resident = 0;
  statm >> size >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::string cap_text(double seconds) {
  std::string text = std::to_string(seconds);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

// True when the process has exited, or does so within the grace.
bool exits_by_itself(pid_t pid) {
  const int process = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
  if (process < 0) return false;
  pollfd polled{process, POLLIN, 0};
  const bool exited = poll(&polled, 1, exit_grace_milliseconds) == 1;
  close(process);
  return exited;
}

}  // namespace

Child::Child(const std::function<std::string()>& work, const Limits& limits) : limits_(limits) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_errno("pipe");
  start_ = Clock::now();
  deadline_ =
      start_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.seconds));
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) run_child(work, limits, ends[1], parent);
  close(ends[1]);
  if (pid_ < 0) {
    close(ends[0]);
    throw_errno("fork");
  }
  setpgid(pid_, pid_);  // in both processes: whoever comes first, the group is there for kill
  pipe_ = ends[0];
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      pipe_(std::exchange(other.pipe_, -1)),
      limits_(other.limits_),
      start_(other.start_),
      deadline_(other.deadline_),
      received_(std::move(other.received_)),
      ending_(std::move(other.ending_)) {}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(pipe_, other.pipe_);
  std::swap(limits_, other.limits_);
  std::swap(start_, other.start_);
  std::swap(deadline_, other.deadline_);
  std::swap(received_, other.received_);
  std::swap(ending_, other.ending_);
  return *this;
}

Child::~Child() {
  if (pid_ > 0) reap();
}

// Kills what is left of the child's process group and collects its status. The group goes first: while its
// leader is not yet reaped, no other process can have that number.
int Child::reap() {
  kill(-pid_, SIGKILL);
  kill(pid_, SIGKILL);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  close(std::exchange(pipe_, -1));
  ending_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  return status;
}

void Child::end(Outcome outcome, std::string reason) {
  reap();
  ending_.outcome = outcome;
  ending_.reason = std::move(reason);
}

// The pipe is closed at the other end: what the child said and how it exited decide.
void Child::conclude() {
  const bool exited = exits_by_itself(pid_);
  const int status = reap();
  const std::optional<Frame> frame = decode_frame(received_);
  if (frame && frame->kind == Message::result) {
    ending_.outcome = Outcome::ok;
    ending_.result = frame->text;
  } else if (frame && frame->kind == Message::exception) {
    ending_.reason = "exception: " + frame->text;
  } else if (!exited) {
    ending_.reason = "closed its result pipe and ran on";
  } else if (WIFEXITED(status) && WEXITSTATUS(status) == out_of_memory_status) {
    ending_.outcome = Outcome::out_of_memory;
    ending_.reason = "more than " + std::to_string(limits_.memory_mib) + " MiB";
  } else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    ending_.outcome = Outcome::timeout;
    ending_.reason = "processor time beyond " + cap_text(limits_.seconds);
  } else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) {
    ending_.outcome = Outcome::out_of_memory;
    ending_.reason = "killed from outside, as the system does when memory runs out";
  } else if (WIFSIGNALED(status)) {
    ending_.reason = std::string("signal: ") + strsignal(WTERMSIG(status));
  } else {
    ending_.reason = "exit status " + std::to_string(WEXITSTATUS(status)) + " without a result";
  }
}

bool Child::advance() {
  if (pid_ < 0) return true;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = read(pipe_, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) break;  // nothing more for now
    if (count == 0) {
      conclude();
      return true;
    }
    received_.append(buffer.data(), static_cast<std::size_t>(count));
    if (received_.size() > longest_result) {
      end(Outcome::crash, "wrote garbage instead of a result");
      return true;
    }
  }
  if (Clock::now() >= deadline_) {
    end(Outcome::timeout, "more than " + cap_text(limits_.seconds));
  } else if (watch_resident_size && resident_bytes(pid_) > limits_.memory_mib << 20) {
    end(Outcome::out_of_memory, "more than " + std::to_string(limits_.memory_mib) + " MiB resident");
  }
  return pid_ < 0;
}

void wait(std::span<const Child> children, int wake) {
  using std::chrono::milliseconds;
  std::vector<pollfd> polled;
  milliseconds patience = milliseconds::max();
  if (watch_resident_size && !children.empty()) patience = watch_interval;
  const auto now = Child::Clock::now();
  for (const Child& child : children) {
    if (child.descriptor() < 0) return;  // it has already ended
    polled.push_back({child.descriptor(), POLLIN, 0});
    patience = std::min(patience, std::chrono::ceil<milliseconds>(child.deadline() - now));
  }
  if (wake >= 0) polled.push_back({wake, POLLIN, 0});
  if (polled.empty()) return;
  const auto longest = milliseconds(60'000);
  poll(polled.data(), polled.size(),
       static_cast<int>(std::clamp(patience, milliseconds(0), longest).count()));
}

Ending run_sandboxed(const std::function<std::string()>& work, const Limits& limits) {
  Child child(work, limits);
  while (!child.advance()) wait({&child, 1});
  return child.ending();
}

}  // namespace tribunal::bench
