// The verbs of the program: options in, exit status out. Each has a file of its own; main.cpp parses the
// command line.
#pragma once

#include "cli/console.hpp"
#include "cli/picture.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tribunal::cli {

struct ListOptions {
  std::string what;  ///< algorithms, backends, datasets, claims, formats or peers
};
int list(const ListOptions& options, Console& console);

struct PointsOptions {
  std::string dataset;
  std::uint64_t n = 0;  ///< 0: as many as the dataset has, 1000 where it has any number
  std::uint64_t seed = 1;
  int bits = 0;  ///< 0: raw doubles
  std::string output = "-";
};
int points(const PointsOptions& options, Console& console);

struct SignOptions {
  std::string predicate;
  std::vector<std::string> numbers;   ///< decimal, hex-float or integer, as typed
  std::vector<std::string> backends;  ///< empty: all
};
int sign(const SignOptions& options, Console& console);

struct TriangulateOptions {
  std::string points;
  std::string algorithm = "green-sibson";
  std::vector<std::string> settings;  ///< of the algorithm's parameters, as "name=value"
  std::string backend = "filtered";
  std::string order;  ///< empty: the algorithm's own
  std::uint64_t seed = 1;
  std::uint64_t n = 0;  ///< where `points` is a dataset's name; 0: as in PointsOptions
  std::string mesh;     ///< output file; empty: none
  std::string stats;    ///< statistics as JSON; empty: none
  PictureOptions picture;
};
int triangulate(const TriangulateOptions& options, Console& console);

struct VerifyOptions {
  std::string points, mesh;
  std::string kind = "delaunay";
  std::string domain = "auto";         ///< with kind constrained: hull, carved, even-odd or auto
  std::string criterion = "delaunay";  ///< of the free edges, with kind constrained: delaunay or none
};
int verify(const VerifyOptions& options, Console& console);

struct OptimizeOptions {
  std::string points, mesh;
  std::string criterion = "delaunay";  ///< see cli/optimize.cpp
  std::string backend = "filtered";
  std::vector<std::string> settings;  ///< NAME=VALUE, of flips
  std::string output;                 ///< mesh file; empty: none
  std::string stats;                  ///< statistics as JSON; empty: none
  PictureOptions picture;
};
int optimize(const OptimizeOptions& options, Console& console);

struct RefineOptions {
  std::string boundary;
  std::string algorithm = "chew";
  std::string backend = "filtered";
  std::vector<std::string> settings;  ///< NAME=VALUE, of the algorithm
  std::string output;                 ///< mesh file; empty: none
  std::string stats;                  ///< statistics as JSON; empty: none
  PictureOptions picture;             ///< without a field to show
};
int refine(const RefineOptions& options, Console& console);

struct BenchOptions {
  std::string what;                               ///< predicates or algorithms
  std::vector<std::string> backends;              ///< empty: all predicates', filtered for algorithms
  std::vector<std::string> predicates, families;  ///< empty: all
  std::vector<std::string> algorithms, settings, orders, datasets;  ///< all empty: what the goals name
  std::uint64_t queries = 100'352;                                  ///< of predicates
  std::uint64_t n = 0;                                              ///< of algorithms; 0: as the goals say
  std::uint64_t seed = 1;
  std::optional<int> repetitions;  ///< none: 21 for predicates, 7 for algorithms
  double seconds = 300;            ///< that a process of one lap, or two, of algorithms may take
  bool peers = false;
};
int bench(const BenchOptions& options, Console& console);
int bench_algorithms(const BenchOptions& options, Console& console);

struct TryOptions {
  std::string plugin, command;         ///< one of them
  std::string query, points, dataset;  ///< at most one of them; none: the whole zoo
  std::uint64_t seed = 1;
  std::uint64_t n = 200;           ///< points of each dataset
  std::uint64_t queries = 10'000;  ///< of each predicate and family
  double seconds = 5;              ///< that one exercise may take
  std::string picture;             ///< folder for pictures of counterexamples; empty: none
};
int try_outsider(const TryOptions& options, Console& console);

struct FuzzOptions {
  std::vector<std::string> backends, predicates;  ///< empty: all
  std::vector<std::string> plugins;               ///< shared libraries
  std::optional<double> seconds;                  ///< neither this nor `queries`: default_fuzz_seconds
  std::optional<std::uint64_t> queries;           ///< how many are drawn
  std::uint64_t seed = 1;
  std::string oracle = "staged";  ///< or gmp
  std::string corpus;             ///< folder of *.query files; empty: none
  std::string picture;            ///< folder for pictures of counterexamples; empty: none
};
inline constexpr double default_fuzz_seconds = 10;
int fuzz(const FuzzOptions& options, Console& console);

struct RunOptions {
  std::string plan;
  std::string directory;
  int jobs = 1;
  bool resume = false;
};
int run(const RunOptions& options, Console& console);

struct CellOptions {
  std::string cell;  ///< one cell as JSON
};
int cell(const CellOptions& options, Console& console);

struct ClaimsOptions {
  std::vector<std::string> ids;  ///< empty: all
  std::string tier = "quick";
  std::string directory;  ///< where rows are kept; empty: a scratch folder
  int jobs = 1;
  bool resume = false;
};
int claims(const ClaimsOptions& options, Console& console);

struct ReportOptions {
  std::vector<std::string> directories;
  std::string output = "report.html";
};
int report(const ReportOptions& options, Console& console);

}  // namespace tribunal::cli
