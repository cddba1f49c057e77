#include "bench/fuzz/oracle.hpp"

#include "predicates/backends/exact_sign.hpp"
#include "predicates/filters/dynamic.hpp"
#include "predicates/formulas/with_formula.hpp"

namespace tribunal::bench::fuzz {

Sign exact_sign(const Case& asked) {
  return with_formula(asked.predicate, [&]<class Formula>() {
    return tribunal::exact_sign<Formula>(arguments_of<Formula>(asked));
  });
}

Sign certified_sign(const Case& asked) {
  return with_formula(asked.predicate,
                      [&]<class Formula>() { return filtered_sign<Formula>(arguments_of<Formula>(asked)); });
}

Sign Oracle::judge_staged(const Case& asked) {
  const Sign certified = certified_sign(asked);
  if (certified != Sign::zero && certified_++ % recheck != 0) return certified;
  ++asked_gmp_;
  const Sign exact = exact_sign(asked);
  if (certified == Sign::zero) return exact;
  ++rechecked_;
  if (exact != certified) faults_.push_back({asked, exact, certified});
  return exact;
}

std::vector<Sign> Oracle::judge(std::span<const Case> cases) {
  std::vector<Sign> signs;
  signs.reserve(cases.size());
  if (kind_ == OracleKind::staged) {
    for (const Case& asked : cases) signs.push_back(judge_staged(asked));
  } else {
    for (const Case& asked : cases) signs.push_back(exact_sign(asked));
    asked_gmp_ += cases.size();
  }
  return signs;
}

}  // namespace tribunal::bench::fuzz
