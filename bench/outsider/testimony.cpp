#include "bench/outsider/testimony.hpp"

#include "bench/fuzz/oracle.hpp"
#include "bench/fuzz/picture.hpp"
#include "bench/fuzz/points_of.hpp"
#include "bench/fuzz/shrink.hpp"
#include "bench/fuzz/subject.hpp"
#include "bench/outsider/timing.hpp"
#include "bench/outsider/watched.hpp"
#include "predicates/environment.hpp"
#include "predicates/plugin/loader.hpp"

#include <nlohmann/json.hpp>

#include <bit>
#include <utility>

namespace tribunal::bench {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Testimony, refusal, breach, wrong, first, got, seconds)

namespace {
using fuzz::Case;
using nlohmann::json;

/// Where the child is; from first_query on, the query's number.
enum Place : std::uint64_t { loading, binding, batching, timing, first_query };

std::string place_name(std::uint64_t place) {
  switch (place) {
    case loading:
      return "when it is loaded";
    case binding:
      return "in bind";
    case batching:
      return "in a batch";
    case timing:
      return "when asked once more";
    default:
      return "in query " + std::to_string(place - first_query);
  }
}

PredicatePlugin load(const std::string& path) {
  const SharedLibrary library(path);
  const auto plugin = PredicatePlugin::load(library);
  if (!plugin) library.refuse("defines no tribunal_predicates_entry");
  return *plugin;
}

fuzz::Subject subject_of(const PredicatePlugin& plugin) {
  return {.name = plugin.name(),
          .exact = true,
          .bind2 = [plugin](std::span<const Point2> points) { return plugin.bind2(points); },
          .bind3 = [plugin](std::span<const Point3> points) { return plugin.bind3(points); },
          .offers = [plugin](Predicate predicate) { return plugin.offers(predicate); }};
}

template <int D>
std::size_t count_batch_differences(const PredicatePlugin& plugin, std::span<const Case> cases,
                                    const std::vector<Sign>& single) {
  const std::vector<Point<D>> points = fuzz::points_of_all<D>(cases);
  const auto bound = plugin.bind_batch<D>(cases.front().predicate, points);
  if (std::holds_alternative<Refusal>(bound)) return single.size();  // bound before, and refused now
  std::vector<std::int8_t> answers(cases.size());
  std::get<PluginBatch>(bound).answer(points.front().coordinate.data(), answers);
  std::size_t differences = 0;
  for (std::size_t i = 0; i < single.size(); ++i) differences += answers[i] != static_cast<int>(single[i]);
  return differences;
}

/// How many answers of the plug-in's batch are others than `single`, as -1, 0 or 1; 0 where it has none.
std::size_t count_batch_differences(const PredicatePlugin& plugin, std::span<const Case> cases,
                                    const std::vector<Sign>& single) {
  const Predicate predicate = cases.front().predicate;
  if (!plugin.offers_batch(predicate)) return 0;
  return dimension_of(predicate) == 2 ? count_batch_differences<2>(plugin, cases, single)
                                      : count_batch_differences<3>(plugin, cases, single);
}

/// In the child.
Testimony testify(const std::string& path, const Examination& examination, const Witness& place) {
  place.set(loading);
  const PredicatePlugin plugin = load(path);
  const fuzz::Subject subject = subject_of(plugin);
  place.set(binding);
  const auto bound = fuzz::bind_subject(subject, examination.cases);
  Testimony testimony;
  if (const auto* refusal = std::get_if<Refusal>(&bound)) {
    testimony.refusal = "point " + std::to_string(refusal->point) + ": " + refusal->reason;
    return testimony;
  }
  std::vector<Sign> signs;
  signs.reserve(examination.cases.size());
  for (std::size_t i = 0; i < examination.cases.size(); ++i) {
    place.set(first_query + i);
    signs.push_back(std::get<0>(bound).decide(examination.cases[i]).sign);
    if (signs[i] == examination.exact[i] || testimony.wrong++ > 0) continue;
    testimony.first = i;
    testimony.got = static_cast<int>(signs[i]);
  }
  place.set(batching);
  if (const auto differences = count_batch_differences(plugin, examination.cases, signs))
    testimony.breach = "its batch gives " + std::to_string(differences) + " other signs than one by one";
  if (const std::string fault = describe_fault(witness_floating_point()); !fault.empty())
    testimony.breach = "it changes the floating-point environment: " + fault;
  place.set(timing);
  if (testimony.wrong == 0) testimony.seconds = seconds_per_query(plugin, examination.cases);
  return testimony;
}

/// In the child: the numbers of the simpler case as their bits, which pass unchanged through JSON, and the
/// sign given; null when there is nothing to simplify.
json search(const std::string& path, const Case& asked) {
  const PredicatePlugin plugin = load(path);
  const fuzz::Subject subject = subject_of(plugin);
  const auto fails = [&](const Case& candidate) {
    const auto answer = fuzz::decide_alone(subject, candidate);
    return answer && answer->sign != fuzz::exact_sign(candidate);
  };
  if (!fails(asked)) return nullptr;
  const Case simpler = fuzz::shrink(asked, fails);
  json numbers = json::array();
  for (const double number : simpler.numbers()) numbers.push_back(std::bit_cast<std::uint64_t>(number));
  const Sign got = fuzz::decide_alone(subject, simpler)->sign;
  fuzz::Counterexample shown{};
  shown.backend = plugin.name();
  shown.asked = simpler;
  shown.exact = fuzz::exact_sign(simpler);
  shown.got = got;
  shown.alone = true;
  return {
      {"numbers", numbers}, {"got", static_cast<int>(got)}, {"picture", fuzz::picture_of(shown, subject)}};
}

}  // namespace

Examination examine(std::vector<Case> cases) {
  Examination examination{std::move(cases), {}};
  examination.exact.reserve(examination.cases.size());
  for (const Case& asked : examination.cases) examination.exact.push_back(fuzz::exact_sign(asked));
  return examination;
}

Hearing hear(const std::string& path, const Examination& examination, const Limits& limits, int wake) {
  const Witness place(loading);
  Hearing hearing;
  const auto ending =
      run_unless_woken([&] { return json(testify(path, examination, place)).dump(); }, limits, wake);
  hearing.interrupted = !ending;
  if (!ending) return hearing;
  hearing.ending = *ending;
  if (hearing.ending.outcome == Outcome::ok) {
    hearing.testimony = json::parse(hearing.ending.result).get<Testimony>();
  } else {
    hearing.place = place_name(place.value());
    if (place.value() >= first_query) hearing.query = place.value() - first_query;
  }
  return hearing;
}

std::optional<WrongSign> simplify(const std::string& path, const Case& asked, const Limits& limits,
                                  int wake) {
  const auto ending = run_unless_woken([&] { return search(path, asked).dump(); }, limits, wake);
  if (!ending || ending->outcome != Outcome::ok) return std::nullopt;
  const json found = json::parse(ending->result);
  if (found.is_null()) return std::nullopt;
  WrongSign wrong{.asked = {.predicate = asked.predicate},
                  .exact = {},
                  .got = static_cast<Sign>(found["got"].get<int>()),
                  .picture = found["picture"]};
  for (std::size_t i = 0; i < wrong.asked.size(); ++i)
    wrong.asked.numbers()[i] = std::bit_cast<double>(found["numbers"][i].get<std::uint64_t>());
  wrong.exact = fuzz::exact_sign(wrong.asked);
  return wrong;
}

}  // namespace tribunal::bench
