#include "predicates/backends/list.hpp"

#include "predicates/backends/all.hpp"
#include "predicates/symbolic/entry.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tribunal {
namespace {
template <class... B>
constexpr std::array<BackendEntry, sizeof...(B)> entries_of(BackendTypes<B...>) {
  return {backend_entry<B>()...};
}
constexpr auto all = entries_of(AllBackends{});

template <class... B>
constexpr auto symbolic_entries_of(BackendTypes<B...>) {
  std::array<BackendEntry, (std::size_t{B::about.exact} + ...)> entries{};
  auto next = entries.begin();
  const auto add = [&]<class Each>(BackendTypes<Each>) {
    if constexpr (Each::about.exact) *next++ = symbolic_entry<Each>();
  };
  (add(BackendTypes<B>{}), ...);
  return entries;
}
constexpr auto all_symbolic = symbolic_entries_of(AllBackends{});
}  // namespace

std::span<const BackendEntry> backends() { return all; }
std::span<const BackendEntry> symbolic_backends() { return all_symbolic; }

const BackendEntry* find_backend(std::string_view name) {
  for (const std::span<const BackendEntry> entries : {backends(), symbolic_backends()}) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.about->name == name; });
    if (found != entries.end()) return &*found;
  }
  return nullptr;
}

}  // namespace tribunal
