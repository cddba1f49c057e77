// The user's wish to stop, as a descriptor instead of a handler.
#pragma once

#include <signal.h>

namespace tribunal::bench {

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end this thread's process but make descriptor()
/// readable. No handler and no global state; children must unblock the signals for themselves (the sandbox
/// does).
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  int descriptor() const { return descriptor_; }
  /// True from the first such signal on.
  bool requested();

 private:
  sigset_t previous_;
  int descriptor_;
  bool requested_ = false;
};

}  // namespace tribunal::bench
