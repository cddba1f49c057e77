#include "reports/judges/list.hpp"

#include "reports/judges/listed.hpp"

#include <algorithm>
#include <array>

namespace tribunal::reports {

std::span<const Judge> judges() {
  static const std::array all{
#define JUDGE(name) name##_judge,
#include "reports/judges/list.def"
#undef JUDGE
  };
  return all;
}

const Judge* find_judge(std::string_view name) {
  const auto all = judges();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Judge& judge) { return judge.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribunal::reports
