#include "reports/page/triangulations.hpp"

#include <set>
#include <string>

namespace tribunal::reports {

std::vector<const bench::Row*> triangulations(std::span<const bench::Row> rows) {
  std::set<std::string> tasks;
  for (const bench::Row& row : rows)
    if (row.counters.contains("triangles")) tasks.insert(row.cell.task);
  std::vector<const bench::Row*> runs;
  for (const bench::Row& row : rows)
    if (tasks.contains(row.cell.task)) runs.push_back(&row);
  return runs;
}

}  // namespace tribunal::reports
