#include "bench/sandbox_child.hpp"

#include "bench/frame.hpp"

#include <gmp.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fcntl.h>
#include <new>
#include <signal.h>
#include <string_view>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace tribunal::bench {
namespace {

// Exiting on the spot, unlike std::bad_alloc, also gets out of noexcept functions and of C code.
[[noreturn]] void out_of_memory() { _exit(out_of_memory_status); }

void* gmp_allocate(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) out_of_memory();
  return memory;
}

void* gmp_reallocate(void* old, std::size_t, std::size_t size) {
  void* memory = std::realloc(old, size);
  if (memory == nullptr) out_of_memory();
  return memory;
}

void gmp_free(void* memory, std::size_t) { std::free(memory); }

// Default dispositions and an empty mask: a sanitizer's handler, too, would only delay the death we want to
// see.
void reset_signals() {
  for (int number = 1; number < SIGRTMIN; ++number) signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

// Whatever the work prints goes nowhere: standard output belongs to the parent. The pipe keeps its number,
// which no stream inherited from the parent can have: flushing such a stream then fails instead of reaching
// the pipe.
void keep_only(int pipe) {
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, standard);
  const auto kept = static_cast<unsigned>(pipe);
  if (kept > 3) close_range(3, kept - 1, 0);
  close_range(kept + 1, ~0U, 0);
}

void cap_resources(const Limits& limits) {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  // The parent kills by the wall clock; this is for a child that has lost its parent's attention. SIGXCPU
  // comes at the lower limit, an anonymous SIGKILL at the upper one.
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.seconds)) + 2;
  const rlimit processor{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &processor);
  const rlimit memory{limits.memory_mib << 20, limits.memory_mib << 20};
  if (!watch_resident_size) setrlimit(RLIMIT_AS, &memory);
  std::set_new_handler(out_of_memory);
  mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free);
}

void send(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(pipe, bytes.data(), bytes.size());
    if (written < 0) _exit(EXIT_FAILURE);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

void run_child(const std::function<std::string()>& work, const Limits& limits, int pipe, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(EXIT_FAILURE);  // it died before we could ask to die with it
  reset_signals();
  keep_only(pipe);
  cap_resources(limits);
  try {
    send(pipe, encode_frame(Message::result, work()));
  } catch (const std::bad_alloc&) {
    out_of_memory();
  } catch (const std::exception& error) {
    send(pipe, encode_frame(Message::exception, error.what()));
  } catch (...) {
    send(pipe, encode_frame(Message::exception, "of unknown type"));
  }
  _exit(EXIT_SUCCESS);  // no destructors, no atexit, no flush of what the parent had buffered
}

}  // namespace tribunal::bench
