#include "bench/interrupt.hpp"

#include <cerrno>
#include <sys/signalfd.h>
#include <system_error>
#include <unistd.h>

namespace tribunal::bench {

Interrupt::Interrupt() {
  sigset_t watched;
  sigemptyset(&watched);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&watched, number);
  descriptor_ = signalfd(-1, &watched, SFD_NONBLOCK | SFD_CLOEXEC);
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "signalfd");
  pthread_sigmask(SIG_BLOCK, &watched, &previous_);
}

// A signal still pending is taken here, or it would strike as soon as it is unblocked.
Interrupt::~Interrupt() {
  requested();
  close(descriptor_);
  pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
}

bool Interrupt::requested() {
  signalfd_siginfo signal;
  while (read(descriptor_, &signal, sizeof signal) == sizeof signal) requested_ = true;
  return requested_;
}

}  // namespace tribunal::bench
