// Law: whatever is wrong with a campaign file is said in one line that names file, line and column.
#include "datasets/files/files.hpp"
#include "tests/bench/support.hpp"

namespace tribunal::bench {
namespace {

struct Wrong {
  const char* name;
  const char* text;
  const char* message;  // after the file's name
};

std::string complaint(const std::filesystem::path& path) {
  try {
    parse_plan(path);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "no complaint";
}

class PlanErrors : public testing::TestWithParam<Wrong> {};

TEST_P(PlanErrors, NameFileLineColumnAndReason) {
  const TemporaryFolder folder;
  const auto path = folder / "plan.toml";
  write_file(path, GetParam().text);
  const std::string message = complaint(path);
  EXPECT_EQ(message.substr(0, path.string().size() + 1), path.string() + ":");
  EXPECT_EQ(message.substr(path.string().size() + 1), GetParam().message);
}

const Wrong wrongs[] = {
    {"no_cells", "name = \"x\"\n", "1:1: there are no [[cells]]"},
    {"cells_scalar", "cells = 3\n", "1:9: cells are tables [[cells]]"},
    {"cells_empty", "cells = []\n", "1:9: cells are tables [[cells]]"},
    {"cells_of_numbers", "cells = [1]\n", "1:10: cells is a table, not integer"},
    {"unknown_top_key", "nmae = \"x\"\n", "1:1: unknown key \"nmae\" (known here: name, limits, cells)"},
    {"name_type", "name = 3\n[[cells]]\n", "1:8: name is a string, not integer"},
    {"limits_type", "limits = 3\n", "1:10: limits is a table, not integer"},
    {"unknown_limit", "[limits]\nsecs = 3\n", "2:1: unknown key \"secs\" (known here: seconds, memory_mib)"},
    {"seconds_type", "[limits]\nseconds = \"60\"\n", "2:11: seconds is a number, not string"},
    {"seconds_zero", "[limits]\nseconds = 0\n", "2:11: seconds is a number from 0.001 to 604800, not 0"},
    {"seconds_nan", "[limits]\nseconds = nan\n", "2:11: seconds is a number from 0.001 to 604800, not nan"},
    {"memory_fraction", "[limits]\nmemory_mib = 1.5\n",
     "2:14: memory_mib is a whole number, not floating-point"},
    {"memory_small", "[limits]\nmemory_mib = 1\n",
     "2:14: memory_mib is a whole number from 16 to 16777216, not 1"},
    {"no_task", "[[cells]]\nbackend = \"gmp\"\n", "1:1: cells need either an algorithm or an experiment"},
    {"two_tasks", "[[cells]]\nalgorithm = \"bowyer\"\nexperiment = \"scopes\"\n",
     "1:1: cells need either an algorithm or an experiment"},
    {"unknown_algorithm", "[[cells]]\nalgorithm = \"boyer\"\n", "2:13: no algorithm is named \"boyer\""},
    {"unknown_in_list", "[[cells]]\nalgorithm = [\"bowyer\",\n  \"boyer\"]\n",
     "3:3: no algorithm is named \"boyer\""},
    {"unknown_experiment", "[[cells]]\nexperiment = \"bowyer\"\n", "2:14: no experiment is named \"bowyer\""},
    {"algorithm_type", "[[cells]]\nalgorithm = 1\n", "2:13: algorithm is a string, not integer"},
    {"empty_list", "[[cells]]\nalgorithm = []\n", "2:13: an empty list leaves no cells"},
    {"nested_list", "[[cells]]\nalgorithm = [[\"bowyer\"]]\n", "2:14: algorithm is a string, not array"},
    {"no_backend", "[[cells]]\nalgorithm = \"bowyer\"\ndataset = \"grid\"\nn = 9\n",
     "1:1: bowyer needs a value of backend"},
    {"no_dataset", "[[cells]]\nalgorithm = \"bowyer\"\nbackend = \"gmp\"\nn = 9\n",
     "1:1: bowyer needs a value of dataset"},
    {"no_n", "[[cells]]\nalgorithm = \"bowyer\"\nbackend = \"gmp\"\ndataset = \"grid\"\n",
     "1:1: bowyer needs a value of n"},
    {"experiment_takes_no_dataset",
     "[[cells]]\nexperiment = \"sign-map\"\nbackend = \"gmp\"\ndataset = \"grid\"\n",
     "4:11: sign-map takes no dataset"},
    {"experiment_takes_no_measure",
     "[[cells]]\nexperiment = \"sign-map\"\nbackend = \"gmp\"\nmeasure = \"time\"\n",
     "4:11: sign-map takes no measure"},
    {"algorithm_takes_no_parameters",
     "[[cells]]\nalgorithm = \"bowyer\"\nbackend = \"gmp\"\ndataset = \"grid\"\nn = 9\nparameters = {a = "
     "1}\n",
     "6:14: bowyer takes no parameters"},
    {"algorithms_share_parameters",
     "[[cells]]\nalgorithm = [\"green-sibson\", \"bowyer\"]\nbackend = \"gmp\"\ndataset = \"grid\"\nn = 9\n"
     "parameters = {location = \"walk\"}\n",
     "6:14: bowyer takes no parameters"},
    {"algorithm_parameter_choice",
     "[[cells]]\nalgorithm = \"green-sibson\"\nbackend = \"gmp\"\ndataset = \"grid\"\nn = 9\n"
     "parameters = {location = \"taxi\"}\n",
     "6:26: location is one of history, walk, jump-and-walk, not \"taxi\""},
    {"unknown_key", "[[cells]]\nalgorithm = \"bowyer\"\nbakend = \"gmp\"\n",
     "3:1: unknown key \"bakend\" (known here: algorithm, experiment, backend, dataset, n, bits, seed, "
     "order_seed, "
     "order, measure, repeats, parameters)"},
    {"unknown_parameter",
     "[[cells]]\nexperiment = \"sign-map\"\nbackend = \"gmp\"\nparameters = {fig = \"2a\"}\n",
     "4:15: sign-map has no parameter \"fig\" (there is figure)"},
    {"parameter_choice",
     "[[cells]]\nexperiment = \"sign-map\"\nbackend = \"gmp\"\nparameters = {figure = \"3\"}\n",
     "4:24: figure is one of 2a, 2b, 2c, not \"3\""},
    {"parameter_range",
     "[[cells]]\nexperiment = \"tau-over-orders\"\nbackend = \"gmp\"\ndataset = \"grid\"\nn = 9\n"
     "parameters = {orders = 1}\n",
     "6:24: orders is a whole number from 2 to 1000000, not \"1\""},
    {"parameter_type",
     "[[cells]]\nexperiment = \"sign-map\"\nbackend = \"gmp\"\nparameters = {figure = 2.5}\n",
     "4:24: figure is a string, not floating-point"},
    {"parameters_type", "[[cells]]\nexperiment = \"sign-map\"\nbackend = \"gmp\"\nparameters = 2\n",
     "4:14: parameters is a table, not integer"},
};

const Wrong wrong_values[] = {
    {"n_negative", "n = -1", "6:5: n is a whole number from 1 to 100000000, not -1"},
    {"n_zero", "n = 0", "6:5: n is a whole number from 1 to 100000000, not 0"},
    {"n_huge", "n = 100000001", "6:5: n is a whole number from 1 to 100000000, not 100000001"},
    {"n_text", "n = \"9\"", "6:5: n is a whole number, not string"},
    {"bits", "n = 9\nbits = 54", "7:8: bits is a whole number from 0 to 53, not 54"},
    {"seed_word", "n = 9\nseed = \"all\"", "7:8: seed: \"all\" is no range \"first..last\""},
    {"seed_open_range", "n = 9\nseed = \"1..\"", "7:8: seed: \"1..\" is no range \"first..last\""},
    {"seed_falling_range", "n = 9\nseed = \"9..1\"", "7:8: seed: \"9..1\" is no range \"first..last\""},
    {"seed_three_dots", "n = 9\nseed = \"1...9\"", "7:8: seed: \"1...9\" is no range \"first..last\""},
    {"seed_negative", "n = 9\nseed = -3",
     "7:8: seed is a whole number from 0 to 9223372036854775807, not -3"},
    {"seed_range_huge", "n = 9\nseed = \"0..1000000\"",
     "7:8: seed: \"0..1000000\" holds more than 1000000 values"},
    {"seed_ranges_huge", "n = 9\nseed = [\"1..999999\", \"1..9\"]",
     "7:22: seed has more than 1000000 values"},
    {"order", "n = 9\norder = \"sorted\"", "7:9: no order is named \"sorted\""},
    {"measure", "n = 9\nmeasure = \"speed\"", "7:11: no measure is named \"speed\""},
    {"repeats", "n = 9\nrepeats = 0", "7:11: repeats is a whole number from 1 to 100000, not 0"},
    {"product_huge", "n = [1, 2]\nseed = \"1..1000\"\norder_seed = \"1..1000\"",
     "2:1: more than 1000000 cells"},
};

INSTANTIATE_TEST_SUITE_P(Structure, PlanErrors, testing::ValuesIn(wrongs),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

class PlanValueErrors : public testing::TestWithParam<Wrong> {};

TEST_P(PlanValueErrors, NameFileLineColumnAndReason) {
  const TemporaryFolder folder;
  const auto path = folder / "plan.toml";
  const std::string block = "\n[[cells]]\nalgorithm = \"bowyer\"\nbackend = \"gmp\"\ndataset = \"grid\"\n";
  write_file(path, block + GetParam().text);
  EXPECT_EQ(complaint(path), path.string() + ":" + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(Values, PlanValueErrors, testing::ValuesIn(wrong_values),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

TEST(PlanFiles, BadTomlIsNamedByLineAndColumn) {
  const TemporaryFolder folder;
  const auto path = folder / "plan.toml";
  write_file(path, "name = \"x\"\n[[cells\n");
  const std::string message = complaint(path);
  EXPECT_EQ(message.rfind(path.string() + ":2:", 0), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(PlanFiles, BytesThatAreNoTextAreRefused) {
  const TemporaryFolder folder;
  const auto path = folder / "plan.toml";
  write_file(path, std::string("\xff\xfe\x00garbage", 10));
  EXPECT_EQ(complaint(path).rfind(path.string() + ":1:", 0), 0u) << complaint(path);
}

TEST(PlanFiles, MissingFileAndFolderCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint(folder / "none.toml"),
            (folder / "none.toml").string() + ": cannot read: No such file or directory");
  EXPECT_EQ(complaint(folder / ""), (folder / "").string() + ": cannot read: Is a directory");
}

}  // namespace
}  // namespace tribunal::bench
