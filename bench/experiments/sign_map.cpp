// Experiment `sign-map`: what a backend answers over a fine grid across a line.
//
// orient2d(p + (x, y) 2^-53, q, r) for 0 <= x, y < 256, after the figures of Kettner, Mehlhorn, Pion,
// Schirra, Yap, "Classroom examples of robustness problems in geometric computations" (2008); the exact
// signs beside it.
//
// Counters: `pixels`, `false_zero`, `inverted`, `false_nonzero`. Texts: `signs` and `exact`, the rows y = 0,
// 1, ... of 256 signs each as one run-length string, a sign (+, -, 0) followed by its run in brackets,
// "+[12]0[3]-[241]...".
#include "bench/experiments/listed.hpp"
#include "bench/experiments/sign_errors.hpp"
#include "bench/input.hpp"
#include "predicates/backends/list.hpp"

#include <array>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr Parameter figure_parameter{
    .name = "figure", .summary = "which of the three point triples", .standard = "2a", .choices = [] {
      return std::vector<std::string_view>{"2a", "2b", "2c"};
    }};
constexpr std::array parameters{figure_parameter};

constexpr int side = 256;
constexpr double pixel = 0x1p-53;  // the spacing of doubles in [1/2, 1)

struct Figure {
  std::string_view name;
  Point2 p, q, r;
};

constexpr Figure figures[] = {
    {"2a", {0.5, 0.5}, {12, 12}, {24, 24}},
    {"2b",
     {0.50000000000002531, 0.5000000000000171},
     {17.300000000000001, 17.300000000000001},
     {24.00000000000005, 24.0000000000000517765}},
    {"2c", {0.5, 0.5}, {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}},
};

/// q, r and then the grid, row by row.
std::vector<Point2> figure_points(const Figure& figure) {
  std::vector<Point2> points{figure.q, figure.r};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) points.push_back({figure.p[0] + x * pixel, figure.p[1] + y * pixel});
  return points;
}

std::vector<Sign> grid_signs(std::span<const Point2> points, const Kernel2& kernel) {
  std::vector<Sign> signs;
  for (const Point2& p : points.subspan(2)) signs.push_back(kernel.orient2d(p, points[0], points[1]));
  return signs;
}

std::string run_lengths(std::span<const Sign> signs) {
  std::string text;
  for (std::size_t i = 0, next = 0; i < signs.size(); i = next) {
    while (next < signs.size() && signs[next] == signs[i]) ++next;
    text.append(1, to_char(signs[i])).append("[").append(std::to_string(next - i)).append("]");
  }
  return text;
}

Finding run_sign_map(const Cell& cell) {
  const std::string name = choice(cell.parameters, figure_parameter);
  const Figure* figure = std::begin(figures);
  while (figure->name != name) ++figure;
  const std::vector<Point2> points = figure_points(*figure);
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};

  const std::vector<Sign> got = grid_signs(points, *std::get<0>(binding));
  const std::vector<Sign> exact = grid_signs(points, *std::get<0>(find_backend("gmp")->bind2(points)));
  SignErrors errors;
  for (std::size_t i = 0; i < got.size(); ++i) errors.note(got[i], exact[i]);
  Finding finding;
  finding.counters["pixels"] = static_cast<double>(got.size());
  errors.add_to(finding.counters);
  finding.texts = {{"signs", run_lengths(got)}, {"exact", run_lengths(exact)}};
  return finding;
}

}  // namespace

constinit const Experiment sign_map_experiment{
    .name = "sign-map",
    .cites = "Kettner et al. 2008",
    .summary =
        "orientation signs of a backend on a 256 x 256 grid of neighbouring doubles, against the exact ones",
    .reads = {.backend = true},
    .parameters = parameters,
    .run = run_sign_map,
};

}  // namespace tribunal::bench
