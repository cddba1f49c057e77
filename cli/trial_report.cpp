#include "cli/trial_report.hpp"

#include "bench/fuzz/hex_float.hpp"
#include "datasets/files/files.hpp"
#include "datasets/files/text.hpp"
#include "datasets/pictures/picture.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <ostream>
#include <vector>

namespace tribunal::cli {
namespace {
using bench::Counterexample;
using bench::Exercise;
using bench::Finding;
using nlohmann::json;

constexpr std::string_view mesh_task = "delaunay";

/// Three significant digits.
std::string short_number(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3).ptr;
  return {text.data(), end};
}

json exercise_json(const Exercise& e) {
  const bool timed = e.seconds > 0;
  return {{"task", e.task},
          {"input", e.input},
          {"n", e.n},
          {"outcome", to_string(e.finding)},
          {"reason", e.reason},
          {"wrong", e.wrong},
          {"seconds", timed ? json(e.seconds) : json(nullptr)}};
}

json counterexample_json(const Counterexample& c) {
  json points = json::array();
  for (const auto& point : c.points)
    for (const double coordinate : point) points.push_back(bench::fuzz::hex_float(coordinate));
  return {{"task", c.task},    {"input", c.input}, {"outcome", to_string(c.finding)},
          {"points", points},  {"exact", c.exact}, {"got", c.got},
          {"replay", c.replay}};
}

json report_json(const TrialReport& report) {
  json exercises = json::array(), counterexamples = json::array();
  for (const Exercise& e : report.result.exercises) exercises.push_back(exercise_json(e));
  for (const Counterexample& c : report.result.counterexamples)
    counterexamples.push_back(counterexample_json(c));
  return {{"outsider", {{"name", report.name}, {"cites", report.cites}, {"summary", report.summary}}},
          {"clean", is_clean(report)},
          {"exercises", exercises},
          {"counterexamples", counterexamples}};
}

std::string cell_text(const Exercise& e) {
  if (e.finding == Finding::wrong && e.wrong > 0) return "wrong " + std::to_string(e.wrong);
  if (e.finding == Finding::right && e.seconds > 0) return short_number(1e9 * e.seconds) + " ns";
  return std::string(to_string(e.finding));
}

/// One line per family, one column per predicate: the time of what is right, the number of wrong signs.
void print_predicates(const std::vector<Exercise>& exercises, Console& console) {
  std::vector<std::vector<std::string>> table{{"family"}};
  std::map<std::string, std::size_t> line_of;
  for (const Exercise& e : exercises) {
    if (e.task == mesh_task) continue;
    if (table[0].back() != e.task) table[0].push_back(e.task);
    const auto [line, is_new] = line_of.emplace(e.input, table.size());
    if (is_new) table.push_back({e.input});
    table[line->second].push_back(cell_text(e));
  }
  if (table.size() == 1) return;
  console.out << "\npredicates: ns per query where every sign is right, else what came of them\n";
  print_table(console, table);
}

void print_meshes(const std::vector<Exercise>& exercises, Console& console) {
  std::vector<std::vector<std::string>> table{{"dataset", "n", "outcome", "seconds", ""}};
  for (const Exercise& e : exercises)
    if (e.task == mesh_task)
      table.push_back({e.input, std::to_string(e.n), std::string(to_string(e.finding)),
                       e.seconds > 0 ? short_number(e.seconds) : "-", e.reason});
  if (table.size() == 1) return;
  console.out << "\ntriangulations: the largest tried, or the first that failed\n";
  print_table(console, table);
}

/// Of each task and kind of failure the one that is shortest to type; the others are in the JSON document.
void print_counterexamples(const std::vector<Counterexample>& all, Console& console) {
  std::map<std::pair<std::string, Finding>, const Counterexample*> shortest;
  for (const Counterexample& c : all) {
    const Counterexample*& best = shortest[{c.task, c.finding}];
    if (best == nullptr || c.replay.size() < best->replay.size()) best = &c;
  }
  if (shortest.empty()) return;
  console.out << "\ncounterexamples: " << all.size() << " found, the shortest of each kind\n";
  for (const auto& [kind, c] : shortest)
    console.out << c->task << " on " << c->input << ": " << c->exact << " is true, got: " << c->got << "\n  "
                << c->replay << '\n';
}

/// As it was drawn, else the mesh, else the points.
void draw(const std::filesystem::path& file, const Counterexample& c) {
  if (!c.picture.empty()) return write_text(file, c.picture);
  std::vector<Point2> points;
  for (const auto& p : c.points) points.push_back({{p[0], p[1]}});
  std::vector<Triangle> triangles;
  for (const Triangle& t : c.triangles)
    if (std::ranges::all_of(t, [&](Index corner) { return corner < points.size(); })) triangles.push_back(t);
  write_picture(file, points, triangles);
}

}  // namespace

bool is_clean(const TrialReport& report) {
  const auto& all = report.result.exercises;
  return !report.interrupted &&
         std::ranges::none_of(all, [](const Exercise& e) { return failed(e.finding); }) &&
         std::ranges::any_of(all, [](const Exercise& e) { return e.finding == Finding::right; });
}

void print_trial(const TrialReport& report, Console& console) {
  if (console.json) return print_json(console, report_json(report));
  const auto& exercises = report.result.exercises;
  console.out << report.name;
  if (!report.cites.empty()) console.out << " (" << report.cites << ")";
  if (!report.summary.empty()) console.out << ": " << report.summary;
  console.out << '\n';
  print_predicates(exercises, console);
  print_meshes(exercises, console);
  print_counterexamples(report.result.counterexamples, console);
  const auto count = [&](auto test) { return std::ranges::count_if(exercises, test); };
  console.out << '\n'
              << (is_clean(report) ? "clean: " : "not clean: ")
              << count([](const Exercise& e) { return e.finding == Finding::right; }) << " right, "
              << count([](const Exercise& e) { return failed(e.finding); }) << " failed, "
              << count([](const Exercise& e) { return e.finding == Finding::refused; }) << " refused, "
              << count([](const Exercise& e) { return e.finding == Finding::untried; }) << " untried"
              << (report.interrupted ? "; interrupted" : "") << '\n';
}

void draw_counterexamples(const std::filesystem::path& folder,
                          std::span<const Counterexample> counterexamples) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw BadInput(folder.string() + ": " + error.message());
  for (const Counterexample& c : counterexamples)
    if (!c.points.empty() && c.points.front().size() == 2)
      draw(folder / (c.task + "-" + c.input + ".svg"), c);
}

}  // namespace tribunal::cli
