#include "bench/manifest.hpp"

#include "bench/build_info.hpp"
#include "bench/hash.hpp"
#include "datasets/dataset.hpp"
#include "datasets/files/files.hpp"
#include "predicates/environment.hpp"

#include <gmp.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <sys/utsname.h>
#include <thread>

namespace tribunal::bench {
namespace {

using nlohmann::json;

json describe_build() {
  const BuildInfo& info = build_info();
  return {{"commit", info.commit}, {"dirty", info.dirty}, {"compiler", info.compiler}, {"flags", info.flags}};
}

json describe_floating_point() {
  const FloatingPointWitness witness = witness_floating_point();
  return {{"no_contraction", witness.no_contraction},
          {"round_to_nearest", witness.round_to_nearest},
          {"subnormals", witness.subnormals},
          {"double_precision", witness.double_precision}};
}

std::string version(int major, int minor, int patch) {
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

json describe_libraries() {
  return {{"gmp", gmp_version},
          {"sqlite", sqlite3_libversion()},
          {"nlohmann-json",
           version(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
          {"tomlplusplus", version(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)}};
}

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(std::min(line.find(": ") + 2, line.size()));
  return "unknown";
}

json describe_machine() {
  utsname kernel{};
  uname(&kernel);
  return {{"cpu", cpu_model()},
          {"cores", std::thread::hardware_concurrency()},
          {"kernel", std::string(kernel.sysname) + ' ' + kernel.release},
          {"architecture", kernel.machine}};
}

/// Runs of consecutive seeds as "first..last".
json describe_seeds(const std::set<std::uint64_t>& seeds) {
  json ranges = json::array();
  for (auto first = seeds.begin(); first != seeds.end();) {
    auto last = first;
    while (std::next(last) != seeds.end() && *std::next(last) == *last + 1) ++last;
    ranges.push_back(std::to_string(*first) + (first == last ? "" : ".." + std::to_string(*last)));
    first = std::next(last);
  }
  return ranges;
}

std::string digest_points(const Dataset& dataset) {
  const std::vector<Point2> points = dataset.generate(dataset.about.fixed_size, 1);
  return hash_hex({reinterpret_cast<const char*>(points.data()), points.size() * sizeof(Point2)});
}

json describe_plan(const Plan& plan) {
  std::set<std::uint64_t> seeds, order_seeds;
  std::set<std::string> names;
  for (const Cell& cell : plan.cells) {
    seeds.insert(cell.seed);
    order_seeds.insert(cell.order_seed);
    names.insert(cell.dataset);
  }
  json inputs = json::object();
  for (const std::string& name : names) {
    const Dataset* dataset = find_dataset(name);
    if (dataset != nullptr && dataset->about.fixed_size > 0) inputs[name] = digest_points(*dataset);
  }
  return {{"name", plan.name},
          {"digest", plan.input_digest},
          {"limits", {{"seconds", plan.limits.seconds}, {"memory_mib", plan.limits.memory_mib}}},
          {"cells", plan.cells.size()},
          {"seeds", describe_seeds(seeds)},
          {"order_seeds", describe_seeds(order_seeds)},
          {"inputs", inputs}};
}

/// The plans of the manifest at `path`, none where there is no file.
json earlier_plans(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) return json::array();
  try {
    const json manifest = json::parse(file);
    if (manifest.at("schema") != row_schema || manifest.at("build") != describe_build())
      throw BadInput(path.string() +
                     ": the rows are another build's (commit, compiler or flags); use a new folder");
    return manifest.at("plans");
  } catch (const json::exception& error) {
    throw BadInput(path.string() + ": " + error.what());
  }
}

}  // namespace

json make_manifest(const Plan& plan) {
  return {{"schema", row_schema},
          {"build", describe_build()},
          {"floating_point", describe_floating_point()},
          {"libraries", describe_libraries()},
          {"machine", describe_machine()},
          {"plans", json::array({describe_plan(plan)})}};
}

void update_manifest(const std::filesystem::path& folder, const Plan& plan) {
  const std::filesystem::path path = folder / "manifest.json";
  json manifest = make_manifest(plan);
  json plans = earlier_plans(path);
  const json& this_plan = manifest["plans"][0];
  if (std::find(plans.begin(), plans.end(), this_plan) == plans.end()) plans.push_back(this_plan);
  manifest["plans"] = plans;
  const std::filesystem::path unfinished = folder / "manifest.json.unfinished";
  std::ofstream file(unfinished);
  file << manifest.dump(2) << '\n';
  file.close();
  if (!file) throw BadInput(unfinished.string() + ": cannot be written");
  std::filesystem::rename(unfinished, path);
}

}  // namespace tribunal::bench
