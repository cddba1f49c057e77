#include "predicates/backends/list.hpp"

#include "predicates/backends/double.hpp"
#include "predicates/backends/double_fma.hpp"
#include "predicates/backends/filtered.hpp"
#include "predicates/backends/fortune_van_wyk.hpp"
#include "predicates/backends/gmp.hpp"
#include "predicates/backends/knuth.hpp"
#include "predicates/backends/knuth_as_printed.hpp"

#include <algorithm>
#include <array>

namespace tribunal {
namespace {
constexpr std::array all{
    backend_entry<Double>(),        backend_entry<DoubleFma>(),
    backend_entry<Knuth>(),         backend_entry<KnuthAsPrinted>(),
    backend_entry<FortuneVanWyk>(), backend_entry<Filtered>(),
    backend_entry<Gmp>(),
};
}  // namespace

std::span<const BackendEntry> backends() { return all; }

const BackendEntry* find_backend(std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.about->name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribunal
