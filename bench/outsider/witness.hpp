// A number that a child leaves behind whatever becomes of it.
#pragma once

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <sys/mman.h>
#include <system_error>

namespace tribunal::bench {

/// A counter in memory shared with the processes forked after its construction: a sandboxed child sets it
/// before each step, and its parent reads in it where the child died or hung.
class Witness {
 public:
  explicit Witness(std::uint64_t value)
      : page_(mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (page_ == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
    counter_ = new (page_) Counter(value);
  }
  Witness(const Witness&) = delete;
  Witness& operator=(const Witness&) = delete;
  ~Witness() { munmap(page_, sizeof(Counter)); }

  void set(std::uint64_t value) const { counter_->store(value, std::memory_order_relaxed); }
  std::uint64_t value() const { return counter_->load(std::memory_order_relaxed); }

 private:
  using Counter = std::atomic<std::uint64_t>;
  static_assert(Counter::is_always_lock_free, "locks do not reach across processes");

  void* page_;
  Counter* counter_;
};

}  // namespace tribunal::bench
