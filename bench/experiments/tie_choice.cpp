// Experiment `tie-choice`: what an algorithm builds when ties are decided arbitrarily.
//
// The backend under trial, with every zero of one predicate replaced by a sign drawn from a hash of the
// query: a fixed answer to each ordered query, consistent with nothing. Run on one dataset, the result is
// checked exactly as a triangulation (not as a Delaunay one).
//
// Counters: `runs` (1), `valid` (a triangulation of the sites), `unfinished` (the algorithm gave up), `ties`
// (zeros replaced), `delaunay` (valid as that, too).
#include "algorithms/triangulate.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/experiments/name_parameters.hpp"
#include "bench/input.hpp"
#include "datasets/random.hpp"

#include <array>
#include <bit>
#include <initializer_list>

namespace tribunal::bench {
namespace {

constexpr Parameter ties_parameter{
    .name = "ties", .summary = "which predicate's zeros are replaced", .standard = "circles", .choices = [] {
      return std::vector<std::string_view>{"circles", "lines"};
    }};
constexpr std::array parameters{algorithm_parameter, ties_parameter};

class ArbitraryTies final : public Kernel2 {
 public:
  ArbitraryTies(const Kernel2& kernel, bool circles, std::uint64_t seed)
      : kernel_(kernel), circles_(circles), seed_(seed) {}
  Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const override {
    const Decision decision = kernel_.decide_orient2d(a, b, c);
    return circles_ ? decision : broken(decision, {a, b, c});
  }
  Decision decide_incircle(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    const Decision decision = kernel_.decide_incircle(a, b, c, d);
    return circles_ ? broken(decision, {a, b, c, d}) : decision;
  }
  Decision decide_compare_length(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return kernel_.decide_compare_length(a, b, c, d);
  }
  Decision decide_compare_angle(const Angle<2>& p, const Angle<2>& q) const override {
    return kernel_.decide_compare_angle(p, q);
  }
  bool admits(Point2 p) const override { return kernel_.admits(p); }
  std::uint64_t ties() const { return ties_; }

 private:
  Decision broken(Decision decision, std::initializer_list<Point2> query) const {
    if (decision.sign != Sign::zero) return decision;
    ++ties_;
    std::uint64_t hash = seed_;
    for (const Point2& p : query)
      for (const double c : p.coordinate) {
        hash ^= std::bit_cast<std::uint64_t>(c + 0.0);  // -0 is 0
        hash = Random::splitmix64(hash);
      }
    return {hash % 2 == 0 ? Sign::positive : Sign::negative, Stage::symbolic};
  }
  const Kernel2& kernel_;
  bool circles_;
  std::uint64_t seed_;
  mutable std::uint64_t ties_ = 0;  // one thread asks
};

bool is_valid(std::span<const Point2> points, const Triangulation& t, verify::Kind kind) {
  return verify::verify_planar(points, {.triangles = t.triangles}, {.kind = kind, .max_faults = 1}).valid();
}

Finding run_tie_choice(const Cell& cell) {
  const PlanarAlgorithm& algorithm = chosen_algorithm(cell);
  const std::vector<Point2> points = cell_points(cell);
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const ArbitraryTies kernel(*std::get<0>(binding), choice(cell.parameters, ties_parameter) == "circles",
                             cell.order_seed);
  const Triangulation t = triangulate(points, cell_order(points, cell, cell.order_seed), kernel, algorithm);
  const bool finished = t.outcome == Outcome::ok;
  return {.counters = {{"runs", 1},
                       {"ties", static_cast<double>(kernel.ties())},
                       {"unfinished", finished ? 0 : 1},
                       {"valid", finished && is_valid(points, t, verify::Kind::triangulation)},
                       {"delaunay", finished && is_valid(points, t, verify::Kind::delaunay)}}};
}

}  // namespace

constinit const Experiment tie_choice_experiment{
    .name = "tie-choice",
    .cites = "Barth, section 3.7",
    .summary = "whether a triangulation stays valid when the zeros of one predicate are decided arbitrarily",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true, .order = true},
    .parameters = parameters,
    .run = run_tie_choice,
};

}  // namespace tribunal::bench
