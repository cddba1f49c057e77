#include "algorithms/constrained/channel.hpp"

#include <algorithm>
#include <span>

namespace tribunal::constrained {
namespace {

/// Of collinear a, v, b with v, b != a: whether v lies on the same side of a as b.
bool ahead(const Mesh& mesh, Index a, Index v, Index b) {
  return (mesh.point(a) < mesh.point(v)) == (mesh.point(a) < mesh.point(b));
}

Index on_segment(const Mesh& mesh, Index a, Index v, Index b) {
  if (!strictly_between(mesh.point(a), mesh.point(v), mesh.point(b)))
    throw Abandon(Outcome::inconsistent_predicate, "a vertex on the line of a segment lies beyond its end");
  return v;
}

/// The link of the triangle at a through which a -> b leaves it; `none` where it runs along an edge of a,
/// which is then the channel.
HalfEdge departure(const Mesh& mesh, Index a, Index b, Channel& channel) {
  const PlanarMesh& t = mesh.triangles();
  const HalfEdge first = mesh.link(a);
  const auto side_of = [&](Index v) { return v == infinite ? Sign::zero : mesh.side(a, b, v); };
  Sign from_side = side_of(t.from(first));
  HalfEdge h = first;
  do {
    const Index u = t.from(h), v = t.to(h);
    const Sign to_side = side_of(v);
    if (u != infinite && from_side == Sign::zero && ahead(mesh, a, u, b)) {
      channel.edge = prev(h);
      channel.end = on_segment(mesh, a, u, b);
      return PlanarMesh::none;
    }
    if (from_side == Sign::negative && to_side == Sign::positive) return h;
    from_side = to_side;
    h = mesh.next_link(h);
  } while (h != first);
  throw Abandon(Outcome::inconsistent_predicate, "a segment leaves its end through no triangle");
}

}  // namespace

Channel trace(const Mesh& mesh, Index a, Index b) {
  Channel channel{a, b};
  const PlanarMesh& t = mesh.triangles();
  channel.edge = mesh.edge(a, b);
  if (channel.edge != PlanarMesh::none) return channel;
  HalfEdge h = departure(mesh, a, b, channel);
  if (channel.edge != PlanarMesh::none) return channel;
  channel.right = {{a, t.from(h)}, {prev(h)}};
  channel.left = {{a, t.to(h)}, {next(h)}};
  channel.triangles.push_back(triangle_of(h));
  Budget budget(t.triangles(), "following a segment");
  for (;;) {
    budget.spend();
    if (mesh.held(h)) {
      channel.blocked_by = mesh.piece(h);
      return channel;
    }
    channel.crossed.push_back({t.from(h), t.to(h)});
    const HalfEdge g = t.twin(h);
    const Index w = t.corner(g);
    if (w == infinite) throw Abandon(Outcome::inconsistent_predicate, "a segment leaves the convex hull");
    channel.triangles.push_back(triangle_of(g));
    const Sign side = w == b ? Sign::zero : mesh.side(a, b, w);
    if (side != Sign::negative) {
      channel.left.side.push_back(prev(g));
      channel.left.chain.push_back(w);
    }
    if (side != Sign::positive) {
      channel.right.side.push_back(next(g));
      channel.right.chain.push_back(w);
    }
    if (side == Sign::zero) {
      channel.end = w == b ? b : on_segment(mesh, a, w, b);
      return channel;
    }
    h = side == Sign::positive ? next(g) : prev(g);
  }
}

namespace {

/// Fills one side of the channel. Its chain must lie left of the edge from its first to its last vertex.
class Filling {
 public:
  Filling(Mesh& mesh, std::span<const Index> chain, std::span<const Index> triangles)
      : mesh_(mesh), chain_(chain), unused_(triangles), sides_(chain.size() - 1, PlanarMesh::none) {}

  /// Returns the half-edge of the edge from the first vertex to the last one.
  HalfEdge run() {
    const HalfEdge base = put(0, chain_.size() - 1);
    while (!bases_.empty()) {
      const Base next_base = bases_.back();
      bases_.pop_back();
      mesh_.join(put(next_base.from, next_base.to), next_base.across);
    }
    return base;
  }
  /// The new half-edge between chain[i] and chain[i + 1].
  HalfEdge side(std::size_t i) const { return sides_[i]; }
  std::span<const Index> unused() const { return unused_; }

 private:
  struct Base {
    std::size_t from, to;  // positions in the chain, with others between
    HalfEdge across;
  };

  /// Puts a triangle on the base and notes its other two edges. Returns its half-edge of the base.
  HalfEdge put(std::size_t from, std::size_t to) {
    const std::size_t apex = find_apex(from, to);
    const Index t = unused_.front();
    unused_ = unused_.subspan(1);
    mesh_.replace(t, chain_[from], chain_[to], chain_[apex]);
    note({apex, to, 3 * t});
    note({from, apex, 3 * t + 1});
    return 3 * t + 2;
  }
  void note(const Base& base) {
    if (base.to == base.from + 1)
      sides_[base.from] = base.across;
    else
      bases_.push_back(base);
  }

  /// The vertex between whose circle through the ends of the base has none of the others inside.
  std::size_t find_apex(std::size_t from, std::size_t to) const {
    const auto point = [this](std::size_t i) { return mesh_.point(chain_[i]); };
    std::size_t apex = from + 1;
    for (std::size_t i = from + 2; i < to; ++i)
      if (mesh_.kernel().incircle(point(from), point(to), point(apex), point(i)) == Sign::positive) apex = i;
    if (mesh_.side(chain_[from], chain_[to], chain_[apex]) != Sign::positive)
      throw Abandon(Outcome::inconsistent_predicate, "a cavity has no triangle on its base");
    return apex;
  }

  Mesh& mesh_;
  std::span<const Index> chain_;
  std::span<const Index> unused_;
  std::vector<HalfEdge> sides_;
  std::vector<Base> bases_;
};

/// What lay across a side of the channel before it was filled.
struct Rim {
  HalfEdge inside, outside;
  Index piece;
};

std::vector<Rim> rim_of(const Mesh& mesh, const std::vector<HalfEdge>& sides) {
  std::vector<Rim> rim;
  rim.reserve(sides.size());
  for (const HalfEdge h : sides) rim.push_back({h, mesh.triangles().twin(h), mesh.piece(h)});
  return rim;
}

/// Glues the new triangles to what lay around the channel. An edge that sticks into it has both sides on its
/// rim.
void glue_rim(Mesh& mesh, const std::vector<Rim>& rim, const Filling& filling) {
  std::vector<std::pair<HalfEdge, std::size_t>> places;
  places.reserve(rim.size());
  for (std::size_t i = 0; i < rim.size(); ++i) places.emplace_back(rim[i].inside, i);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const auto partner =
        std::lower_bound(places.begin(), places.end(), std::pair{rim[i].outside, std::size_t{0}});
    if (partner == places.end() || partner->first != rim[i].outside) {
      mesh.attach(filling.side(i), rim[i].outside);
      continue;
    }
    mesh.join(filling.side(i), filling.side(partner->second));
    mesh.hold(filling.side(i), rim[i].piece);
  }
}

}  // namespace

void fill(Mesh& mesh, const Channel& channel) {
  std::vector<Rim> left = rim_of(mesh, channel.left.side), right = rim_of(mesh, channel.right.side);
  std::reverse(right.begin(), right.end());
  const std::vector<Index> backwards(channel.right.chain.rbegin(), channel.right.chain.rend());
  Filling upper(mesh, channel.left.chain, channel.triangles);
  const HalfEdge above = upper.run();
  Filling lower(mesh, backwards, upper.unused());
  mesh.join(above, lower.run());
  glue_rim(mesh, left, upper);
  glue_rim(mesh, right, lower);
}

}  // namespace tribunal::constrained
