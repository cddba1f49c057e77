// How an algorithm gives up from deep inside: the one exception that the front door turns into an outcome.
#pragma once

#include "algorithms/outcome.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>

namespace tribunal {

struct Abandon : std::runtime_error {
  Abandon(Outcome why, const std::string& reason) : std::runtime_error(reason), outcome(why) {}
  Outcome outcome;
};

/// Steps that may still be taken. With right signs every walk, flip sequence and cavity ends by itself; wrong
/// ones can send them round in circles, so each loop spends from a budget.
class Budget {
 public:
  Budget(std::uint64_t steps, const char* what) : left_(steps), what_(what) {}
  void spend() {
    if (left_ == 0)
      throw Abandon(Outcome::loop, std::string(what_) + " did not end within its budget of steps");
    --left_;
  }

 private:
  std::uint64_t left_;
  const char* what_;
};

}  // namespace tribunal
