// tribunal bench algorithms: whole runs side by side, from points to triangles.
#include "bench/manifest.hpp"
#include "bench/whole/goals.hpp"
#include "bench/whole/race.hpp"
#include "cli/bench_document.hpp"
#include "cli/lookup.hpp"
#include "cli/peers.hpp"
#include "cli/progress.hpp"
#include "cli/verbs.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <ostream>

namespace tribunal::cli {
namespace {
using bench::Course;
using bench::Method;
using bench::RaceGoal;
using bench::Standing;
using nlohmann::json;

/// One comparison that was made or aimed at.
struct Comparison {
  std::string subject, rival;
  Course course;
  std::optional<bench::Ratio> ratio;
  std::optional<double> at_most;

  std::string verdict() const {
    if (!ratio) return "not_measured";
    if (!at_most) return "no_goal";
    return ratio->median <= *at_most ? "met" : "missed";
  }
};

template <class T>
void add_once(std::vector<T>& all, const T& one) {
  if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

/// Every way to choose one of the values given for each name: "a=1", "b=1", "b=2" are two.
std::vector<std::vector<std::string>> combinations(const std::vector<std::string>& settings) {
  std::map<std::string, std::vector<std::string>> by_name;
  for (const std::string& text : settings) by_name[text.substr(0, text.find('='))].push_back(text);
  std::vector<std::vector<std::string>> all{{}};
  for (const auto& [name, texts] : by_name) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& chosen : all)
      for (const std::string& text : texts) {
        longer.push_back(chosen);
        longer.back().push_back(text);
      }
    all = std::move(longer);
  }
  return all;
}

/// The product of what the user named, each with its default.
std::vector<Method> chosen_methods(const BenchOptions& options) {
  const auto or_else = [](const std::vector<std::string>& given, const char* standard) {
    return given.empty() ? std::vector<std::string>{standard} : given;
  };
  std::vector<Method> methods;
  for (const std::string& name : or_else(options.algorithms, "green-sibson"))
    for (const auto& texts : combinations(options.settings))
      for (const std::string& backend : or_else(options.backends, "filtered"))
        for (const std::string& order : or_else(options.orders, "random")) {
          const PlanarAlgorithm& algorithm = algorithm_named(name);
          const auto& parameters = algorithm.parameters;
          const Settings settings =
              without_defaults(parameters, settings_for(algorithm.about.name, parameters, texts));
          backend_named(backend);
          add_once(methods, {name, settings, backend, order_named(order)});
        }
  return methods;
}

bool chooses(const BenchOptions& options) {
  return !(options.algorithms.empty() && options.settings.empty() && options.backends.empty() &&
           options.orders.empty() && options.datasets.empty());
}

/// Who runs where.
struct Heat {
  Course course;
  std::vector<Method> methods;
};

/// What the user named; or what the goals name, over as many points as the user says.
std::vector<Heat> heats_of(const BenchOptions& options) {
  std::vector<Heat> heats;
  if (chooses(options)) {
    const std::vector<std::string> standard{"uniform"};
    const std::vector<Method> methods = chosen_methods(options);
    for (const std::string& dataset : options.datasets.empty() ? standard : options.datasets)
      heats.push_back({{dataset_named(dataset).about.name.data(), options.n ? options.n : 100'000}, methods});
    return heats;
  }
  for (const RaceGoal& goal : bench::race_goals()) {
    const Course course{goal.course.dataset, options.n ? options.n : goal.course.n};
    const auto same = [&](const Heat& heat) { return heat.course == course; };
    auto heat = std::find_if(heats.begin(), heats.end(), same);
    if (heat == heats.end()) heat = heats.insert(heats.end(), {course, {}});
    add_once(heat->methods, goal.subject);
    if (goal.rival_method) add_once(heat->methods, *goal.rival_method);
  }
  return heats;
}

std::vector<bench::Contestant> chosen_peers(const BenchOptions& options, Console& console) {
  std::vector<bench::Contestant> peers;
  if (!options.peers) return peers;
  for (const auto& [name, module] : built_peers())
    if (auto peer = bench::peer_contestant(module.string())) peers.push_back(std::move(*peer));
  if (peers.empty()) console.log << "no peers that triangulate: none was built beside the program\n";
  return peers;
}

/// Each contestant of ours against each peer, and the goals of this course.
std::vector<Comparison> compare(const std::vector<Standing>& standings, std::size_t ours) {
  const std::vector<RaceGoal> goals = bench::race_goals();
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < ours; ++i)
    for (std::size_t j = 0; j < standings.size(); ++j) {
      const Standing &subject = standings[i], &rival = standings[j];
      const auto goal = std::find_if(goals.begin(), goals.end(), [&](const RaceGoal& g) {
        return describe(g.subject) == subject.contestant && g.rival_name() == rival.contestant &&
               g.course == subject.course;
      });
      if (j < ours && goal == goals.end()) continue;
      auto& made = comparisons.emplace_back(Comparison{subject.contestant, rival.contestant, subject.course,
                                                       ratio_of(subject, rival), std::nullopt});
      if (goal != goals.end()) made.at_most = goal->at_most;
    }
  return comparisons;
}

json standing_document(const Standing& standing) {
  json document{{"contestant", standing.contestant},
                {"dataset", standing.course.dataset},
                {"n", standing.course.n},
                {"outcome", to_string(standing.outcome)}};
  if (standing.seconds.empty()) {
    document["reason"] = standing.reason;
  } else {
    const bench::Interval interval = bench::bootstrap_median(standing.seconds, 1);
    document["seconds"] = bench::median(standing.seconds);
    document["interval"] = {interval.low, interval.high};
  }
  return document;
}

json comparison_document(const Comparison& comparison) {
  json document{
      {"subject", comparison.subject},  {"rival", comparison.rival}, {"dataset", comparison.course.dataset},
      {"n", comparison.course.n},       {"ratio", nullptr},          {"goal", nullptr},
      {"verdict", comparison.verdict()}};
  if (comparison.ratio) {
    document["ratio"] = comparison.ratio->median;
    document["interval"] = {comparison.ratio->interval.low, comparison.ratio->interval.high};
  }
  if (comparison.at_most) document["goal"] = *comparison.at_most;
  return document;
}

std::string span_text(const bench::Interval& interval) {
  return three_digits(interval.low) + " to " + three_digits(interval.high);
}

void print_races(Console& console, const std::vector<Standing>& standings,
                 const std::vector<Comparison>& comparisons) {
  std::vector<std::vector<std::string>> times{{"contestant", "dataset", "n", "us per point", "95 %"}};
  for (const Standing& standing : standings) {
    auto& row = times.emplace_back(std::vector<std::string>{standing.contestant, standing.course.dataset,
                                                            std::to_string(standing.course.n)});
    if (standing.seconds.empty()) {
      row.insert(row.end(), {std::string(to_string(standing.outcome)), standing.reason});
      continue;
    }
    const double scale = 1e6 / static_cast<double>(standing.course.n);
    const auto [low, high] = bench::bootstrap_median(standing.seconds, 1);
    row.insert(row.end(), {three_digits(bench::median(standing.seconds) * scale),
                           span_text({low * scale, high * scale})});
  }
  print_table(console, times);
  if (comparisons.empty()) return;
  std::vector<std::vector<std::string>> ratios{{"ratio", "rival", "measured", "95 %", "goal", "verdict"}};
  for (const Comparison& c : comparisons)
    ratios.push_back({c.subject, c.rival, c.ratio ? three_digits(c.ratio->median) : "-",
                      c.ratio ? span_text(c.ratio->interval) : "-",
                      c.at_most ? "<= " + three_digits(*c.at_most) : "-", c.at_most ? c.verdict() : ""});
  console.out << '\n';
  print_table(console, ratios);
}

}  // namespace

int bench_algorithms(const BenchOptions& options, Console& console) {
  const std::vector<Heat> heats = heats_of(options);
  const std::vector<bench::Contestant> peers = chosen_peers(options, console);
  std::vector<Standing> standings;
  std::vector<Comparison> comparisons;
  for (const auto& [course, methods] : heats) {
    bench::RaceOptions plan;
    plan.course = course;
    plan.seed = options.seed;
    plan.progress = progress_printer(console);
    if (options.repetitions) plan.rounds = *options.repetitions;
    for (const Method& method : methods) plan.contestants.push_back(contestant_of(method, options.seed));
    plan.contestants.insert(plan.contestants.end(), peers.begin(), peers.end());
    const std::vector<Standing> heat = race(plan);
    const std::vector<Comparison> made = compare(heat, methods.size());
    standings.insert(standings.end(), heat.begin(), heat.end());
    comparisons.insert(comparisons.end(), made.begin(), made.end());
  }
  if (console.json) {
    const json manifest = bench::make_manifest({});
    json document{{"build", manifest.at("build")},
                  {"machine", manifest.at("machine")},
                  {"seed", options.seed},
                  {"times", json::array()},
                  {"ratios", json::array()}};
    for (const Standing& standing : standings) document["times"].push_back(standing_document(standing));
    for (const Comparison& made : comparisons) document["ratios"].push_back(comparison_document(made));
    print_json(console, document);
  } else {
    print_races(console, standings, comparisons);
  }
  const bool sound = std::all_of(standings.begin(), standings.end(),
                                 [](const Standing& s) { return s.outcome == Outcome::ok; });
  return sound ? good : judged_bad;
}

}  // namespace tribunal::cli
