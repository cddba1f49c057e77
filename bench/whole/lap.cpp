#include "bench/whole/lap.hpp"

#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

namespace tribunal::bench {
namespace {

/// Values as they lie in memory: both ends of the pipe are the same program.
class Packer {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Sequence>
  void add_all(const Sequence& values) {
    add(values.size());
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof *values.data());
  }

  std::string bytes;
};

/// Reads what a Packer has written, in its order.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void take(T& value) {
    copy(&value, sizeof value);
  }
  template <class Sequence>
  void take_all(Sequence& values) {
    std::size_t size = 0;
    take(size);
    values.resize(size);
    if (size > 0) copy(values.data(), size * sizeof *values.data());
  }

 private:
  void copy(void* to, std::size_t size) {
    std::memcpy(to, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

  std::string_view bytes_;
};

std::string pack(const Lap& lap) {
  Packer packer;
  packer.add(lap.outcome);
  packer.add(lap.seconds);
  packer.add_all(lap.reason);
  packer.add_all(lap.triangles);
  packer.add_all(lap.vertices);
  packer.add_all(lap.subsegments);
  return std::move(packer.bytes);
}

Lap unpack(std::string_view bytes) {
  Lap lap;
  Unpacker unpacker(bytes);
  unpacker.take(lap.outcome);
  unpacker.take(lap.seconds);
  unpacker.take_all(lap.reason);
  unpacker.take_all(lap.triangles);
  unpacker.take_all(lap.vertices);
  unpacker.take_all(lap.subsegments);
  return lap;
}

Lap lap_of(const Ending& ending) {
  if (ending.outcome == Outcome::ok) return unpack(ending.result);
  return {.outcome = ending.outcome, .reason = ending.reason};
}

}  // namespace

Lap run_apart(const std::function<Lap()>& run, const Limits& limits) {
  return lap_of(run_sandboxed([&] { return pack(run()); }, limits));
}

Lap time_apart(const std::function<Lap()>& run, const Limits& limits) {
  const auto work = [&] {
    run();
    const Lap lap = run();
    return pack({.outcome = lap.outcome, .reason = lap.reason, .seconds = lap.seconds});
  };
  return lap_of(run_sandboxed(work, limits));
}

}  // namespace tribunal::bench
