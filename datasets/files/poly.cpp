// .poly, the planar straight-line graphs of Triangle: a list of points as in .node (0 points: they are in the
// .node file beside), a list of segments (number, two ends, marker), a list of holes (number, x, y), and
// perhaps a list of regions, which is passed over.
#include "datasets/files/format.hpp"
#include "datasets/files/node_list.hpp"
#include "datasets/files/numerals.hpp"
#include "datasets/files/text.hpp"

namespace tribunal::files {
namespace {

constexpr std::string_view domain_line = "# domain ";

NodeList read_sites(Scanner& scanner, const std::filesystem::path& path) {
  if (!scanner.next_line()) scanner.refuse_file("no points");
  NodeList list = read_node_list(scanner, true);
  if (list.announced.count() > 0) return list;
  if (path == "-")
    scanner.refuse_line(scanner.line(), "no points, and standard input has no .node file beside");
  const std::filesystem::path beside = std::filesystem::path(path).replace_extension(node.about.name);
  const std::string text = read_text(beside);
  Scanner nodes(name_of(beside), text);
  if (!nodes.next_line()) nodes.refuse_file("no points");
  list = read_node_list(nodes);
  list.announced.expect_end(nodes);
  return list;
}

void read_segments(Scanner& scanner, std::uint64_t base, PslgFile& pslg) {
  if (!scanner.next_line()) return;
  const Announced announced(scanner, "segments");
  const std::uint64_t markers = scanner.at_end_of_line() ? 0 : scanner.count("the number of markers");
  if (markers > 1) scanner.refuse("the number of markers must be 0 or 1");
  scanner.expect_end_of_line();
  const auto& points = pslg.sites.points;
  std::uint64_t first = base;
  for (std::uint64_t i = 0; i < announced.count(); ++i) {
    announced.next_line(scanner, i);
    take_number(scanner, i, first);
    const std::uint32_t a = take_vertex(scanner, base, points.size());
    const std::uint32_t b = take_vertex(scanner, base, points.size());
    if (a == b || points[a] == points[b])
      scanner.refuse("a segment without length: both ends are the same point");
    if (markers == 1 && !scanner.at_end_of_line()) (void)scanner.integer("the marker");
    scanner.expect_end_of_line();
    pslg.segments.push_back({a, b});
    pslg.segment_lines.push_back(scanner.line());
  }
}

void read_holes(Scanner& scanner, PslgFile& pslg) {
  if (!scanner.next_line()) return;
  const Announced announced(scanner, "holes");
  scanner.expect_end_of_line();
  std::uint64_t first = 0;
  for (std::uint64_t i = 0; i < announced.count(); ++i) {
    announced.next_line(scanner, i);
    take_number(scanner, i, first);
    const double x = scanner.number("x");
    const double y = scanner.number("y");
    scanner.expect_end_of_line();
    pslg.holes.push_back({{x, y}});
    pslg.hole_lines.push_back(scanner.line());
  }
}

void pass_over_regions(Scanner& scanner) {
  if (!scanner.next_line()) return;
  const Announced announced(scanner, "regions");
  for (std::uint64_t i = 0; i < announced.count(); ++i) announced.next_line(scanner, i);
  announced.expect_end(scanner);
}

/// What a first line of our own says, else what is carved by holes.
std::string domain_of(std::string_view text) {
  if (!text.starts_with(domain_line)) return "carved";
  text.remove_prefix(domain_line.size());
  const std::string name(text.substr(0, text.find_first_of("\r\n")));
  return name == "hull" || name == "even-odd" ? name : "carved";
}

PslgFile read_pslg(const std::filesystem::path& path, std::string_view text) {
  Scanner scanner(name_of(path), text);
  NodeList sites = read_sites(scanner, path);
  PslgFile pslg;
  pslg.domain = domain_of(text);
  pslg.sites = std::move(sites.file);
  read_segments(scanner, sites.base, pslg);
  read_holes(scanner, pslg);
  pass_over_regions(scanner);
  return pslg;
}

std::string write_points(std::span<const Point2> points) { return node.write_points(points) + "0 0\n0\n"; }

}  // namespace

std::string poly_text(const PolyBoundary& boundary) {
  const auto& [segments, holes, domain] = boundary;
  std::string text;
  if (domain != "carved") text.append(domain_line).append(domain).append("\n");
  text += "0 2 0 0\n";
  append_number(text, segments.size());
  text += " 0\n";
  for (std::size_t i = 0; i < segments.size(); ++i) {
    append_number(text, i);
    text += ' ';
    append_number(text, segments[i][0]);
    text += ' ';
    append_number(text, segments[i][1]);
    text += '\n';
  }
  append_number(text, holes.size());
  text += '\n';
  for (std::size_t i = 0; i < holes.size(); ++i) {
    append_number(text, i);
    text += ' ';
    append_number(text, holes[i][0]);
    text += ' ';
    append_number(text, holes[i][1]);
    text += '\n';
  }
  return text;
}

constinit const Format poly{
    .about = {".poly", "points, segments",
              "planar straight-line graphs of Triangle: points, segments, holes"},
    .write_points = write_points,
    .read_pslg = read_pslg,
};

}  // namespace tribunal::files
