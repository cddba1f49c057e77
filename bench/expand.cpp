// The cells of a campaign: each [[cells]] block is a list of axes, and their product the cells.
#include "algorithms/list.hpp"
#include "bench/cell.hpp"
#include "bench/experiments/experiment.hpp"
#include "bench/plan.hpp"
#include "bench/toml_reader.hpp"
#include "datasets/dataset.hpp"
#include "datasets/external/external.hpp"
#include "predicates/backends/list.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>

namespace tribunal::bench {
namespace {

constexpr std::uint64_t most_repeats = 100'000;

/// One key of a block: how many values it has, and how the i-th is put into a cell.
struct Axis {
  std::size_t size;
  std::function<void(Cell&, std::size_t)> set;
};

template <class T>
Axis axis(std::vector<T> values, T Cell::*field) {
  const std::size_t size = values.size();
  return {size, [values = std::move(values), field](Cell& cell, std::size_t i) { cell.*field = values[i]; }};
}

/// What a key may name, and words that stand for several names.
struct Known {
  std::vector<std::string> names;
  std::map<std::string, std::vector<std::string>> words;
};

Known all_of(std::vector<std::string> names) { return {names, {{"*", names}}}; }

/// No dataset has data by point: what reads them needs a setting of its own, and "*" leaves it out.
Known all_tasks() {
  Known known;
  for (const PlanarAlgorithm& algorithm : planar_algorithms()) {
    known.names.emplace_back(algorithm.about.name);
    if (!algorithm.about.reads_values) known.words["*"].push_back(known.names.back());
  }
  return known;
}

Known all_experiments() {
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments()) names.emplace_back(experiment.name);
  return all_of(std::move(names));
}

Known all_backends() {
  Known known;
  for (const BackendEntry& backend : backends()) {
    known.names.emplace_back(backend.about->name);
    known.words["*"].push_back(known.names.back());
    if (backend.about->exact) known.words["exact"].push_back(known.names.back());
  }
  for (const BackendEntry& backend : symbolic_backends()) {
    known.names.emplace_back(backend.about->name);
    known.words["exact+sos"].push_back(known.names.back());
  }
  return known;
}

/// "*" is the same everywhere: what is read from the user's system is named or left out.
Known all_datasets() {
  std::vector<std::string> names;
  for (const Dataset& dataset : datasets()) names.emplace_back(dataset.about.name);
  Known known = all_of(std::move(names));
  for (const ExternalDataset& external : external_datasets())
    known.names.emplace_back(external.dataset.about.name);
  return known;
}

Known all_orders() { return all_of({order_names().begin(), order_names().end()}); }

/// Which keys a task takes, beside order_seed, measure and repeats.
Reads reads_of(const std::string& task) {
  const Experiment* experiment = find_experiment(task);
  if (experiment != nullptr) return experiment->reads;
  return {.backend = true, .dataset = true, .bits = true, .seed = true, .order = true};
}

std::span<const Parameter> parameters_of(const std::string& task) {
  const Experiment* experiment = find_experiment(task);
  return experiment != nullptr ? experiment->parameters : find_planar_algorithm(task)->parameters;
}

/// One spelling of each variant: of an experiment every parameter, of an algorithm those that are not
/// standard.
void normalise_parameters(Cell& cell) {
  const auto parameters = parameters_of(cell.task);
  if (find_experiment(cell.task) != nullptr)
    for (const Parameter& parameter : parameters) cell.parameters.emplace(parameter.name, parameter.standard);
  else
    cell.parameters = without_defaults(parameters, cell.parameters);
}

/// Turns one [[cells]] block into axes and multiplies them out.
class Block {
 public:
  Block(const TomlReader& reader, const toml::table& table) : reader_(reader), table_(table) {
    reader_.allow_only(table_, {"algorithm", "experiment", "backend", "dataset", "n", "bits", "seed",
                                "order_seed", "order", "measure", "repeats", "parameters"});
    read_tasks();
    read_datasets();
    check_keys();
    build_axes();
  }

  void append_to(std::vector<Cell>& cells, std::unordered_set<std::string>& keys) const {
    std::uint64_t count = 1;
    for (const Axis& axis : axes_) {
      count *= axis.size;
      if (count > most_cells) reader_.fail(table_, "more than " + std::to_string(most_cells) + " cells");
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      const Cell cell = cell_at(i);
      if (keys.insert(cell_key(cell)).second) cells.push_back(cell);
    }
    if (cells.size() > most_cells) reader_.fail(table_, "more than " + std::to_string(most_cells) + " cells");
  }

 private:
  const toml::node* find(std::string_view key) const { return table_.get(key); }

  /// The values of a key that are names, or words for several.
  std::vector<std::string> names(std::string_view key, const Known& known) const {
    std::vector<std::string> chosen;
    for (const toml::node* value : reader_.values(*find(key))) {
      const std::string name = reader_.text(*value, key);
      const auto word = known.words.find(name);
      if (word != known.words.end())
        chosen.insert(chosen.end(), word->second.begin(), word->second.end());
      else if (std::ranges::find(known.names, name) != known.names.end())
        chosen.push_back(name);
      else
        reader_.fail(*value, "no " + std::string(key) + " is named \"" + name + "\"");
    }
    return chosen;
  }

  std::vector<std::uint64_t> wholes(std::string_view key, std::uint64_t least, std::uint64_t most) const {
    std::vector<std::uint64_t> numbers;
    for (const toml::node* value : reader_.values(*find(key)))
      numbers.push_back(reader_.whole(*value, key, least, most));
    return numbers;
  }

  std::vector<std::uint64_t> seeds(std::string_view key) const {
    std::vector<std::uint64_t> numbers;
    for (const toml::node* value : reader_.values(*find(key))) {
      const std::vector<std::uint64_t> some = reader_.range(*value, key, most_cells);
      numbers.insert(numbers.end(), some.begin(), some.end());
      if (numbers.size() > most_cells)
        reader_.fail(*value, std::string(key) + " has more than " + std::to_string(most_cells) + " values");
    }
    return numbers;
  }

  void read_tasks() {
    const toml::node* algorithm = find("algorithm");
    const toml::node* experiment = find("experiment");
    if ((algorithm == nullptr) == (experiment == nullptr))
      reader_.fail(table_, "cells need either an algorithm or an experiment");
    tasks_ = algorithm != nullptr ? names("algorithm", all_tasks()) : names("experiment", all_experiments());
  }

  void read_datasets() {
    const toml::node* node = find("dataset");
    if (node == nullptr) return;
    datasets_ = names("dataset", all_datasets());
    for (const std::string& name : datasets_)
      if (const std::string missing = missing_for(name); !missing.empty())
        reader_.fail(*node, name + ": " + missing);
  }

  bool needs_n(const Reads& reads) const {
    return reads.n || std::any_of(datasets_.begin(), datasets_.end(), [](const std::string& name) {
             return find_dataset(name)->about.fixed_size == 0;
           });
  }

  /// Every task must be given what it reads and nothing else.
  void check_keys() const {
    for (const std::string& task : tasks_) {
      const Reads reads = reads_of(task);
      check_key(task, "backend", reads.backend, reads.backend);
      check_key(task, "dataset", reads.dataset, reads.dataset);
      check_key(task, "n", needs_n(reads), reads.n || reads.dataset);
      check_key(task, "bits", false, reads.bits);
      check_key(task, "seed", false, reads.seed);
      check_key(task, "order", false, reads.order);
      check_key(task, "order_seed", false, reads.order);
      const bool experiment = find_experiment(task) != nullptr;
      check_key(task, "measure", false, !experiment);
      check_key(task, "repeats", false, !experiment);
      check_key(task, "parameters", false, !parameters_of(task).empty());
    }
  }

  void check_key(const std::string& task, std::string_view key, bool needed, bool taken) const {
    const toml::node* node = find(key);
    if (needed && node == nullptr) reader_.fail(table_, task + " needs a value of " + std::string(key));
    if (!taken && node != nullptr) reader_.fail(*node, task + " takes no " + std::string(key));
  }

  void build_axes() {
    if (find("n") != nullptr) axes_.push_back(axis(wholes("n", 1, most_points), &Cell::n));
    if (!datasets_.empty()) axes_.push_back(axis(datasets_, &Cell::dataset));
    if (find("bits") != nullptr) {
      const auto bits = wholes("bits", 0, 53);
      axes_.push_back(axis(std::vector<int>(bits.begin(), bits.end()), &Cell::bits));
    }
    if (find("order") != nullptr) axes_.push_back(axis(names("order", all_orders()), &Cell::order));
    add_seeds();
    if (find("measure") != nullptr) axes_.push_back(axis(measures(), &Cell::measure));
    if (find("repeats") != nullptr) {
      const auto repeats = wholes("repeats", 1, most_repeats);
      axes_.push_back(axis(std::vector<int>(repeats.begin(), repeats.end()), &Cell::repeats));
    }
    add_parameters();
    axes_.push_back(axis(tasks_, &Cell::task));
    if (find("backend") != nullptr) axes_.push_back(axis(names("backend", all_backends()), &Cell::backend));
  }

  std::vector<Measure> measures() const {
    std::vector<Measure> chosen;
    for (const std::string& name : names("measure", all_of({"counts", "time"})))
      chosen.push_back(name == "time" ? Measure::time : Measure::counts);
    return chosen;
  }

  /// Without an order_seed of its own a cell's order follows its dataset's seed.
  void add_seeds() {
    if (find("seed") != nullptr) {
      axes_.push_back(axis(seeds("seed"), &Cell::seed));
      const auto set_seed = axes_.back().set;
      axes_.back().set = [set_seed](Cell& cell, std::size_t i) {
        set_seed(cell, i);
        cell.order_seed = cell.seed;
      };
    }
    if (find("order_seed") != nullptr) axes_.push_back(axis(seeds("order_seed"), &Cell::order_seed));
  }

  void add_parameters() {
    const toml::node* node = find("parameters");
    if (node == nullptr) return;
    for (const auto& [key, value] : reader_.table(*node, "parameters")) {
      const std::string name(key.str());
      std::vector<std::string> texts;
      for (const toml::node* element : reader_.values(value)) texts.push_back(parameter_value(key, *element));
      const std::size_t size = texts.size();
      axes_.push_back({size, [name, texts = std::move(texts)](Cell& cell, std::size_t i) {
                         cell.parameters[name] = texts[i];
                       }});
    }
  }

  /// A parameter's value as text, which every task of the block must accept.
  std::string parameter_value(const toml::key& key, const toml::node& node) const {
    std::string text =
        node.is_integer() ? std::to_string(node.as_integer()->get()) : reader_.text(node, key.str());
    for (const std::string& task : tasks_) {
      const auto parameters = parameters_of(task);
      const Parameter* parameter = find_parameter(parameters, key.str());
      if (parameter == nullptr) reader_.fail(key.source(), describe_unknown(task, parameters, key.str()));
      if (const std::string reason = refuse(*parameter, text); !reason.empty()) reader_.fail(node, reason);
    }
    return text;
  }

  /// The i-th cell of the product, the last axis counting fastest; fields that make no difference get one
  /// value, so that equal work has equal keys.
  Cell cell_at(std::uint64_t i) const {
    Cell cell;
    std::vector<std::size_t> digits(axes_.size());
    for (std::size_t a = axes_.size(); a-- > 0; i /= axes_[a].size) digits[a] = i % axes_[a].size;
    for (std::size_t a = 0; a < axes_.size(); ++a) axes_[a].set(cell, digits[a]);
    const Dataset* dataset = find_dataset(cell.dataset);
    if (dataset != nullptr && dataset->about.fixed_size > 0)
      cell.n = cell.n == 0 ? dataset->about.fixed_size : std::min(cell.n, dataset->about.fixed_size);
    if (cell.measure == Measure::counts) cell.repeats = 1;
    normalise_parameters(cell);
    return cell;
  }

  const TomlReader& reader_;
  const toml::table& table_;
  std::vector<std::string> tasks_, datasets_;
  std::vector<Axis> axes_;
};

}  // namespace

std::vector<Cell> expand(const toml::table& table, const std::string& filename) {
  const TomlReader reader(filename);
  const toml::node* blocks = table.get("cells");
  if (blocks == nullptr) reader.fail(table, "there are no [[cells]]");
  const toml::array* array = blocks->as_array();
  if (array == nullptr || array->empty()) reader.fail(*blocks, "cells are tables [[cells]]");
  std::vector<Cell> cells;
  std::unordered_set<std::string> keys;
  for (const toml::node& block : *array) Block(reader, reader.table(block, "cells")).append_to(cells, keys);
  return cells;
}

}  // namespace tribunal::bench
