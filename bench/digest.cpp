#include "bench/digest.hpp"

#include "algorithms/outcome.hpp"
#include "bench/hash.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tribunal::bench {

bool is_deterministic(const Row& row) {
  return row.outcome != to_string(Outcome::timeout) && row.outcome != to_string(Outcome::out_of_memory);
}

std::string digest_line(const Row& row) {
  return nlohmann::json{row.key, row.outcome, row.counters, row.texts, row.digest}.dump() + '\n';
}

RunDigest digest_run(std::span<const Row> rows) {
  RunDigest run;
  std::vector<const Row*> digested;
  for (const Row& row : rows) {
    if (is_deterministic(row))
      digested.push_back(&row);
    else
      run.excluded.push_back(row.key);
  }
  std::sort(digested.begin(), digested.end(), [](const Row* a, const Row* b) { return a->key < b->key; });
  std::sort(run.excluded.begin(), run.excluded.end());
  Hash hash;
  for (const Row* row : digested) hash.add(digest_line(*row));
  run.digest = to_hex(hash.value());
  run.rows = digested.size();
  return run;
}

}  // namespace tribunal::bench
