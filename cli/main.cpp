// The program: parses the command line, calls the verb, turns exceptions into one line and an exit status.
#include "cli/console.hpp"
#include "cli/verbs.hpp"
#include "cli/words.hpp"
#include "datasets/files/files.hpp"
#include "predicates/environment.hpp"
#include "reports/claim.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <fcntl.h>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {
using namespace tribunal;
using namespace tribunal::cli;

/// The command line: every verb with its options, and what to run once one was given.
class CommandLine {
 public:
  explicit CommandLine(std::vector<std::string> numbers) {
    app.set_version_flag("--version", "tribunal " TRIBUNAL_VERSION);
    app.require_subcommand(1);
    app.footer(
        "tribunal <verb> --help shows a verb's options and an example.\n"
        "Exit status: 0 good, 1 the judged thing failed, 2 bad usage or input, 3 internal error.");
    add_list();
    add_points();
    add_sign(std::move(numbers));
    add_triangulate();
    add_verify();
    add_optimize();
    add_refine();
    add_try();
    add_bench();
    add_fuzz();
    add_run();
    add_claims();
    add_report();
    add_cell();
  }

  void parse(std::vector<std::string> words) {
    if (words.empty()) throw BadUsage("a verb is missing; see tribunal --help");
    if (!words[0].starts_with('-') && !has_verb(words[0]))
      throw BadUsage("there is no verb '" + words[0] + "'; see tribunal --help");
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(words);
  }
  int run() {
    const std::map<std::string, Progress> ways{{"auto", Progress::automatic},
                                               {"plain", Progress::plain},
                                               {"json", Progress::json},
                                               {"none", Progress::none}};
    console.progress = ways.at(progress);
    sign_options.numbers.insert(sign_options.numbers.end(), stray_numbers.begin(), stray_numbers.end());
    return action(console);
  }
  int exit(const CLI::ParseError& error) { return app.exit(error, std::cout, std::cerr); }

 private:
  bool has_verb(const std::string& name) {
    return !app.get_subcommands([&](const CLI::App* verb) { return verb->check_name(name); }).empty();
  }

  template <class Options>
  CLI::App* add_verb(const char* name, const char* summary, const char* example, Options& options,
                     int (*verb)(const Options&, Console&)) {
    CLI::App* command = app.add_subcommand(name, summary);
    command->footer(std::string("Example: ") + example);
    command->add_flag("--json", console.json, "one JSON document on standard output, nothing else");
    command->add_option("--progress", progress, "progress on standard error: auto, plain, json or none")
        ->check(CLI::IsMember({"auto", "plain", "json", "none"}));
    command->callback(
        [this, &options, verb] { action = [&options, verb](Console& c) { return verb(options, c); }; });
    return command;
  }

  static void add_size(CLI::App* verb, std::uint64_t& n) {
    verb->add_option("-n", n, "number of points of a dataset; default: all it has, or 1000")
        ->check(check_whole_number)
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000}));
  }

  void add_list() {
    auto* verb = add_verb("list", "what is here, with citations and domains", "tribunal list backends",
                          list_options, list);
    verb->add_option("what", list_options.what, "algorithms, backends, datasets, claims, formats or peers")
        ->required();
  }
  void add_points() {
    auto* verb = add_verb("points", "generate a dataset", "tribunal points tilted-grid -n 1000 -o grid.xy",
                          points_options, points);
    verb->add_option("dataset", points_options.dataset, "see tribunal list datasets")->required();
    add_size(verb, points_options.n);
    verb->add_option("--seed", points_options.seed, "seed of the random numbers")
        ->check(check_whole_number)
        ->capture_default_str();
    verb->add_option("--bits", points_options.bits, "quantise to integers in [0, 2^bits)")
        ->check(check_whole_number);
    verb->add_option("-o,--output", points_options.output,
                     ".xy .csv .node .off, .poly with the segments of a dataset that has any, or - for "
                     "standard output")
        ->capture_default_str();
  }
  void add_sign(std::vector<std::string> numbers) {
    sign_options.numbers = std::move(numbers);
    auto* verb = add_verb("sign", "one query, every backend", "tribunal sign orient2d 0 0  1 1  -0x1p-53 2",
                          sign_options, sign);
    verb->add_option("predicate", sign_options.predicate, "orient2d, incircle, orient3d or insphere")
        ->required();
    verb->add_option("coordinates", stray_numbers,
                     "decimal, hex-float or integer; negative ones as they are");
    verb->add_option("--backend", sign_options.backends, "only this backend; may be repeated")
        ->allow_extra_args(false);
  }
  static void add_picture(CLI::App* verb, PictureOptions& o, const char* colours) {
    verb->add_option("--picture", o.file, "picture of the mesh: .svg or .png");
    verb->add_option("--colour,--color", o.colour, std::string("of its triangles: ") + colours)
        ->capture_default_str();
    verb->add_option("--window", o.window, "show x0,y0,x1,y1 only");
  }
  /// Over the points that were given, which may have values.
  static void add_picture(CLI::App* verb, PictureOptions& o) {
    add_picture(verb, o, "plain, angle, smallest-angle or field");
    verb->add_option("--field", o.field, "what field and contours show: column or F1 to F6");
    verb->add_option("--contours", o.contours, "this many contour lines of the field")
        ->check(check_whole_number)
        ->check(CLI::Range(0, 100));
    verb->add_option("--against", o.against, "mark the edges that this mesh over the same points lacks");
  }
  static void add_method(CLI::App* verb, const char* whose, std::vector<std::string>& settings,
                         std::string& backend) {
    verb->add_option("--set", settings,
                     std::string("a parameter of the ") + whose + ", NAME=VALUE; may be repeated")
        ->allow_extra_args(false);
    verb->add_option("--backend", backend, "see tribunal list backends")->capture_default_str();
  }
  static void add_outputs(CLI::App* verb, std::string& mesh, const char* endings, std::string& stats) {
    verb->add_option("-o,--output", mesh, std::string("mesh file: ") + endings);
    verb->add_option("--stats", stats, "statistics as JSON");
  }
  void add_triangulate() {
    auto& o = triangulate_options;
    auto* verb = add_verb("triangulate", "triangulate a file of points",
                          "tribunal triangulate points.xy -o mesh.off --stats stats.json", o, triangulate);
    verb->add_option("points", o.points, "a file, - for standard input, or a dataset's name")->required();
    verb->add_option("--algorithm", o.algorithm, "see tribunal list algorithms")->capture_default_str();
    add_method(verb, "algorithm", o.settings, o.backend);
    verb->add_option("--order", o.order,
                     "insertion order: random, input, hilbert, x or brio; unless told, random, and brio for "
                     "constrained");
    verb->add_option("--seed", o.seed, "seed of the random order")
        ->check(check_whole_number)
        ->capture_default_str();
    add_size(verb, o.n);
    add_outputs(verb, o.mesh, ".off or .ele", o.stats);
    add_picture(verb, o.picture);
  }
  void add_verify() {
    auto* verb = add_verb("verify", "check a mesh exactly", "tribunal verify points.xy mesh.off",
                          verify_options, tribunal::cli::verify);
    verb->add_option("points", verify_options.points, "the points, as they were triangulated")->required();
    verb->add_option("mesh", verify_options.mesh, "the mesh: .off or .ele")->required();
    verb->add_option("--kind", verify_options.kind, "delaunay, triangulation or constrained")
        ->capture_default_str();
    verb->add_option("--domain", verify_options.domain,
                     "of kind constrained: hull, carved, even-odd, or auto: polygons even-odd, .poly carved")
        ->capture_default_str();
    verb->add_option("--criterion", verify_options.criterion,
                     "of kind constrained, what free edges satisfy: delaunay or none")
        ->capture_default_str();
  }
  void add_optimize() {
    auto& o = optimize_options;
    auto* verb = add_verb("optimize", "flip the edges of a mesh while that makes it better",
                          "tribunal optimize points.xy mesh.off --criterion minmax -o better.off", o,
                          tribunal::cli::optimize);
    verb->add_option("points", o.points, "the points of the mesh")->required();
    verb->add_option("mesh", o.mesh, "the mesh: .off or .ele")->required();
    verb->add_option("--criterion", o.criterion, "delaunay, minmax, minmax-global or data-dependent")
        ->capture_default_str();
    add_method(verb, "flips", o.settings, o.backend);
    add_outputs(verb, o.output, ".off or .ele", o.stats);
    add_picture(verb, o.picture);
  }
  void add_refine() {
    auto& o = refine_options;
    auto* verb = add_verb("refine", "mesh what a boundary encloses, with points of its own",
                          "tribunal refine gulf.poly --set angle=30 --set size=500 -o mesh.ele", o,
                          tribunal::cli::refine);
    verb->add_option("boundary", o.boundary, "segments and holes: .poly, .geojson or .wkt")->required();
    verb->add_option("--algorithm", o.algorithm, "chew, stretched or adaptive")->capture_default_str();
    add_method(verb, "algorithm", o.settings, o.backend);
    add_outputs(verb, o.output, ".ele, with .node and .poly beside it, or .off", o.stats);
    add_picture(verb, o.picture, "plain, angle or smallest-angle");
  }
  void add_bench() {
    auto& o = bench_options;
    auto* verb = add_verb("bench", "timings side by side, and the ratios aimed at",
                          "tribunal bench predicates --backend double --backend filtered --family uni", o,
                          tribunal::cli::bench);
    verb->add_option("what", o.what, "predicates or algorithms")->required();
    verb->add_option("--backend", o.backends, "only this backend; may be repeated")->allow_extra_args(false);
    verb->add_option("--predicate", o.predicates, "only this predicate; may be repeated")
        ->allow_extra_args(false);
    verb->add_option("--family", o.families, "only this family of queries; may be repeated")
        ->allow_extra_args(false);
    verb->add_option("--queries", o.queries, "queries of each predicate and family")
        ->check(check_whole_number)
        ->capture_default_str()
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{10'000'000}));
    for (const auto& [name, named, what] :
         {std::tuple{"--algorithm", &o.algorithms, "only this algorithm; may be repeated"},
          {"--set", &o.settings, "a parameter of the algorithms, NAME=VALUE; each value of a name is run"},
          {"--order", &o.orders, "only this insertion order; may be repeated"},
          {"--dataset", &o.datasets, "points for the algorithms; may be repeated"}})
      verb->add_option(name, *named, what)->allow_extra_args(false);
    add_size(verb, o.n);
    verb->add_option("--repetitions", o.repetitions,
                     "rounds in which everything compared is timed once; default 21, of algorithms 7")
        ->check(check_whole_number)
        ->check(CLI::Range(1, 10'000));
    verb->add_option("--seed", o.seed, "seed of the queries")
        ->check(check_whole_number)
        ->capture_default_str();
    verb->add_option("--seconds", o.seconds, "that a process of an algorithm, one lap or two, may take")
        ->capture_default_str()
        ->check(CLI::Range(0.001, 1e6));
    verb->add_flag("--peers", o.peers, "with the rival libraries whose modules were built");
  }
  void add_try() {
    auto& o = try_options;
    auto* verb = add_verb("try", "an outsider's predicates or triangulator over every hard input",
                          "tribunal try --plugin build/peers/cgal_epick.so", o, try_outsider);
    verb->add_option("--plugin", o.plugin, "a shared library, see docs/plugins.md")->check(check_not_empty);
    verb->add_option("--command", o.command,
                     "a shell command with {points} and {mesh}, or {points.node}, {mesh.ele} and the like")
        ->check(check_not_empty);
    verb->add_option("--query", o.query, "only this query, e.g. 'orient2d 0 0 1 1 2 2'")
        ->check(check_not_empty);
    verb->add_option("--points", o.points, "only this file of points, - for standard input")
        ->check(check_not_empty);
    verb->add_option("--dataset", o.dataset, "only this dataset")->check(check_not_empty);
    verb->add_option("-n", o.n, "points of each dataset")
        ->check(check_whole_number)
        ->capture_default_str()
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000}));
    verb->add_option("--queries", o.queries, "queries of each predicate and family")
        ->check(check_whole_number)
        ->capture_default_str()
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000}));
    verb->add_option("--seconds", o.seconds, "wall clock that one exercise may take")
        ->check(check_seconds)
        ->capture_default_str();
    verb->add_option("--seed", o.seed, "seed of the random numbers")
        ->check(check_whole_number)
        ->capture_default_str();
    verb->add_option("--picture", o.picture, "folder for pictures of counterexamples")
        ->check(check_not_empty);
  }
  void add_fuzz() {
    auto& o = fuzz_options;
    auto* verb = add_verb("fuzz", "hunt for wrong signs against exact integers",
                          "tribunal fuzz --backend double --predicate orient2d --seconds 1", o, fuzz);
    verb->add_option("--backend", o.backends, "only this backend; may be repeated")->allow_extra_args(false);
    verb->add_option("--predicate", o.predicates, "only this predicate; may be repeated")
        ->allow_extra_args(false);
    verb->add_option("--plugin", o.plugins, "a shared library's predicates; may be repeated")
        ->check(check_not_empty)
        ->allow_extra_args(false);
    verb->add_option("--seconds", o.seconds, "stop after so many; default 10 where --queries is not given")
        ->check(check_seconds);
    verb->add_option("--queries", o.queries, "stop after so many queries: the same output every time")
        ->check(check_whole_number);
    verb->add_option("--seed", o.seed, "seed of the sequence of queries")
        ->check(check_whole_number)
        ->capture_default_str();
    verb->add_option("--oracle", o.oracle, "staged (a certified filter, GMP where it fails) or gmp")
        ->capture_default_str();
    verb->add_option("--corpus", o.corpus, "folder of cases to ask first; counterexamples are added")
        ->check(check_not_empty);
    verb->add_option("--picture", o.picture, "folder for pictures of the counterexamples")
        ->check(check_not_empty);
  }
  void add_run() {
    auto& o = run_options;
    auto* verb = add_verb("run", "a campaign on this machine",
                          "tribunal run bench/plans/quick.toml -o results --jobs 2", o, tribunal::cli::run);
    verb->add_option("plan", o.plan, "campaign file (TOML)")->required();
    verb->add_option("-o,--output", o.directory, "run folder")->required();
    verb->add_option("--jobs", o.jobs, "cells at a time")
        ->check(check_whole_number)
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
    verb->add_flag("--resume", o.resume, "go on with an interrupted run");
  }
  void add_claims() {
    auto& o = claims_options;
    o.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    auto* verb =
        add_verb("claims", "try the registered claims", "tribunal claims T4 T5 --tier quick", o, claims);
    verb->add_option("ids", o.ids, "claims to try; all when none is named");
    verb->add_option("--tier", o.tier, "quick or full")
        ->capture_default_str()
        ->check(CLI::IsMember({"quick", "full"}));
    verb->add_option("-o,--output", o.directory, "run folder to keep the rows in");
    verb->add_option("--jobs", o.jobs, "cells at a time")
        ->check(check_whole_number)
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
    verb->add_flag("--resume", o.resume, "go on with an interrupted run");
  }
  void add_report() {
    auto& o = report_options;
    auto* verb = add_verb("report", "one offline page from result rows",
                          "tribunal report results -o report.html", o, report);
    verb->add_option("directories", o.directories, "run folders")->required();
    verb->add_option("-o,--output", o.output, "the page")->capture_default_str();
  }
  void add_cell() {
    auto* verb =
        add_verb("cell", "run one cell and print its row",
                 "tribunal cell '{\"task\":\"bowyer\",\"backend\":\"gmp\",\"dataset\":\"grid\",\"n\":100}'",
                 cell_options, cell);
    verb->add_option("cell", cell_options.cell, "the cell as JSON, as a row's command gives it")->required();
  }

  CLI::App app{"Tribunal puts geometric predicates and triangulation algorithms on trial."};
  Console console{std::cout, std::cerr};
  std::string progress = "auto";
  std::function<int(Console&)> action;
  ListOptions list_options;
  PointsOptions points_options;
  SignOptions sign_options;
  std::vector<std::string>
      stray_numbers;  // what take_numbers did not take for numbers, for `sign` to refuse by name
  TriangulateOptions triangulate_options;
  VerifyOptions verify_options;
  OptimizeOptions optimize_options;
  RefineOptions refine_options;
  BenchOptions bench_options;
  TryOptions try_options;
  FuzzOptions fuzz_options;
  RunOptions run_options;
  ClaimsOptions claims_options;
  ReportOptions report_options;
  CellOptions cell_options;
};

/// One line, whatever the message quotes: control characters are shown as '?'.
int fail(std::string what, int status) {
  std::cout.flush();
  for (char& c : what)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  std::cerr << "tribunal: " << what << '\n';
  return status;
}

/// A file opened where a standard stream is closed would get its number, and what is printed would go into
/// it.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  try {
    const std::string fault = describe_fault(witness_floating_point());
    if (!fault.empty())
      return fail("this floating-point environment cannot be trusted: " + fault, internal_error);
    std::vector<std::string> words(argv + 1, argv + argc);
    std::vector<std::string> numbers = take_numbers(words);
    CommandLine line(std::move(numbers));
    try {
      line.parse(std::move(words));
    } catch (const CLI::Success& help) {
      return line.exit(help);
    } catch (const CLI::ParseError& error) {
      return fail(error.what(), bad_input);
    }
    const int status = line.run();
    std::cout.flush();
    return std::cout ? status : fail("standard output cannot be written", bad_input);
  } catch (const BadUsage& error) {
    return fail(error.what(), bad_input);
  } catch (const BadInput& error) {
    return fail(error.what(), bad_input);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", internal_error);
  } catch (const std::exception& error) {
    return fail(error.what(), internal_error);
  }
}
