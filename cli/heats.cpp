#include "cli/heats.hpp"

#include "algorithms/list.hpp"
#include "bench/whole/goals.hpp"
#include "cli/lookup.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace tribunal::cli {
namespace {
using bench::Course;
using bench::Method;
using bench::RaceGoal;

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

std::vector<std::string> or_else(const std::vector<std::string>& given, const char* standard) {
  return given.empty() ? std::vector<std::string>{standard} : given;
}

/// The parameters of a triangulator, or of the one refiner that is raced.
std::span<const Parameter> parameters_of(const std::string& name) {
  return name == "chew" ? refiner_named(name).parameters : algorithm_named(name).parameters;
}

/// The product of what the user named, each with its default.
std::vector<Method> chosen_methods(const BenchOptions& options) {
  std::vector<Method> methods;
  for (const std::string& name : or_else(options.algorithms, "green-sibson"))
    for (const auto& texts : combinations(options.settings))
      for (const std::string& backend : or_else(options.backends, "filtered"))
        for (const std::string& order : or_else(options.orders, "random")) {
          const auto parameters = parameters_of(name);
          const Settings settings = without_defaults(parameters, settings_for(name, parameters, texts));
          backend_named(backend);
          add_once(methods, {name, settings, backend, order_named(order)});
        }
  return methods;
}

bool chooses(const BenchOptions& options) {
  return !(options.algorithms.empty() && options.settings.empty() && options.backends.empty() &&
           options.orders.empty() && options.datasets.empty());
}

Heat& heat_over(const Course& course, std::vector<Heat>& heats) {
  const auto found = std::ranges::find(heats, course, &Heat::course);
  return found != heats.end() ? *found : heats.emplace_back(Heat{course, {}});
}

}  // namespace

std::vector<Heat> heats_of(const BenchOptions& options) {
  std::vector<Heat> heats;
  if (chooses(options)) {
    const std::vector<Method> methods = chosen_methods(options);
    for (const std::string& name : or_else(options.datasets, "uniform"))
      for (const Method& method : methods) {
        const Course course = course_of(method, dataset_named(name), options.n ? options.n : 100'000);
        add_once(heat_over(course, heats).methods, method);
      }
    return heats;
  }
  for (const RaceGoal& goal : bench::race_goals()) {
    Course course = goal.course;
    if (options.n && course.kind == bench::RaceKind::triangulation) course.n = options.n;
    Heat& heat = heat_over(course, heats);
    add_once(heat.methods, goal.subject);
    if (goal.rival_method) add_once(heat.methods, *goal.rival_method);
  }
  return heats;
}

}  // namespace tribunal::cli
