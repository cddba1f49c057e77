// tribunal sign: one query, every backend.
#include "cli/lookup.hpp"
#include "cli/numbers.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "predicates/backends/list.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace tribunal::cli {
namespace {

struct Query {
  std::string_view name;
  std::size_t dimension, points;
};
constexpr std::array queries{Query{"orient2d", 2, 3}, Query{"incircle", 2, 4}, Query{"orient3d", 3, 4},
                             Query{"insphere", 3, 5}};

template <int D>
std::vector<Point<D>> to_points(const std::vector<double>& numbers) {
  std::vector<Point<D>> points(numbers.size() / D);
  for (std::size_t i = 0; i < numbers.size(); ++i) points[i / D][i % D] = numbers[i];
  return points;
}

/// Nothing: the backend has no such predicate or refuses the points (`refusal` says why).
std::optional<Decision> decide(const BackendEntry& backend, const Query& query,
                               const std::vector<double>& numbers, std::string& refusal) {
  if (query.dimension == 2) {
    const auto p = to_points<2>(numbers);
    const Kernel2Binding bound = backend.bind2(p);
    if (const auto* why = std::get_if<Refusal>(&bound)) return refusal = why->reason, std::nullopt;
    const Kernel2& kernel = *std::get<0>(bound);
    return query.points == 3 ? kernel.decide_orient2d(p[0], p[1], p[2])
                             : kernel.decide_incircle(p[0], p[1], p[2], p[3]);
  }
  if (!backend.bind3) return refusal = "it has no predicates in space", std::nullopt;
  const auto p = to_points<3>(numbers);
  const Kernel3Binding bound = backend.bind3(p);
  if (const auto* why = std::get_if<Refusal>(&bound)) return refusal = why->reason, std::nullopt;
  const Kernel3& kernel = *std::get<0>(bound);
  return query.points == 4 ? kernel.decide_orient3d(p[0], p[1], p[2], p[3])
                           : kernel.decide_insphere(p[0], p[1], p[2], p[3], p[4]);
}

const Query& query_named(const std::string& name) {
  for (const Query& query : queries)
    if (query.name == name) return query;
  throw BadUsage("there is no predicate '" + name + "'; there are orient2d, incircle, orient3d, insphere");
}

}  // namespace

int sign(const SignOptions& options, Console& console) {
  const Query& query = query_named(options.predicate);
  std::vector<double> numbers;
  for (const std::string& text : options.numbers) numbers.push_back(parse_number(text));
  if (options.numbers.size() != query.dimension * query.points)
    throw BadUsage(options.predicate + " takes " + std::to_string(query.points) + " points, " +
                   std::to_string(query.dimension * query.points) + " numbers; " +
                   std::to_string(options.numbers.size()) + " given");

  std::vector<const BackendEntry*> asked;
  for (const std::string& name : each_once(options.backends)) asked.push_back(&backend_named(name));
  if (asked.empty())
    for (const BackendEntry& entry : backends()) asked.push_back(&entry);

  nlohmann::json signs = nlohmann::json::array();
  std::vector<std::vector<std::string>> table;
  for (const BackendEntry* backend : asked) {
    const std::string name(backend->about->name);
    std::string refusal;
    if (const auto decision = decide(*backend, query, numbers, refusal)) {
      const std::string answer(1, to_char(decision->sign)), stage(to_string(decision->stage));
      signs.push_back({{"backend", name}, {"sign", answer}, {"stage", stage}});
      table.push_back({name, answer, stage});
    } else {
      signs.push_back(
          {{"backend", name}, {"sign", "out_of_domain"}, {"stage", nullptr}, {"reason", refusal}});
      table.push_back({name, "out_of_domain", refusal});
    }
  }
  if (console.json)
    print_json(console, {{"predicate", options.predicate}, {"signs", signs}});
  else
    print_table(console, table);
  // Printed first: the reasons are the answer.
  if (std::ranges::all_of(signs, [](const auto& answer) { return answer["sign"] == "out_of_domain"; }))
    throw BadUsage(options.predicate + ": out of the domain of every backend that was asked");
  return good;
}

}  // namespace tribunal::cli
