// From pieces in bins to whole shores.
#include "datasets/external/shore.hpp"
#include "datasets/files/files.hpp"

#include <map>
#include <optional>
#include <tuple>

namespace tribunal::shores {
namespace {

constexpr std::int64_t least_distance = steps_per_degree / 65535;
constexpr std::uint32_t no_side = 4;

/// What the joining needs of a piece.
struct Part {
  std::int32_t polygon;
  std::uint32_t entry, exit;
  std::vector<Place> places;
};

class Bins {
 public:
  Bins(const BinnedShores& binned, const Window& window) : binned_(binned), window_(window) {}

  std::vector<Part> parts() const {
    std::vector<Part> parts;
    const std::int64_t columns = 360 / binned_.bin_degrees, side = binned_.bin_degrees * steps_per_degree;
    for (std::size_t i = 0; i < binned_.bins.size(); ++i) {
      const auto bin = static_cast<std::int64_t>(i);
      const Place corner{bin % columns * side, 90 * steps_per_degree - (bin / columns + 1) * side};
      if (corner.x >= window_.high.x || corner.x + side <= window_.low.x || corner.y >= window_.high.y ||
          corner.y + side <= window_.low.y)
        continue;
      const auto& [first, count] = binned_.bins[i];
      for (std::int32_t k = first; k < first + count; ++k)
        if (binned_.pieces[k].level() == 1) parts.push_back(part(binned_.pieces[k], corner));
    }
    return parts;
  }

 private:
  Part part(const BinnedShores::Piece& piece, const Place& corner) const {
    Part part{piece.polygon, piece.entry(), piece.exit(), {}};
    const std::int64_t unit = binned_.bin_degrees * least_distance;
    for (std::size_t i = piece.first_point; i < piece.first_point + std::size_t{piece.size()}; ++i)
      part.places.push_back({corner.x + binned_.east[i] * unit, corner.y + binned_.north[i] * unit});
    return part;
  }

  const BinnedShores& binned_;
  const Window& window_;
};

/// Where a part begins: two of one land may begin in one place, from different sides.
using Gate = std::tuple<std::int32_t, Place, std::uint32_t>;

class Joining {
 public:
  explicit Joining(std::vector<Part> parts) : parts_(std::move(parts)) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const Part& part = parts_[i];
      if (part.entry == no_side) continue;
      if (!begins_.emplace(Gate{part.polygon, part.places.front(), part.entry}, i).second)
        throw BadInput("two shores of polygon " + std::to_string(part.polygon) + " enter a bin in one place");
    }
    follows_another_.resize(parts_.size());
    used_.resize(parts_.size());
    for (const Part& part : parts_) {
      const auto next = after(part);
      if (!next) continue;
      if (follows_another_[*next])
        throw BadInput("two shores of polygon " + std::to_string(part.polygon) + " leave a bin in one place");
      follows_another_[*next] = true;
    }
  }

  /// First those that begin at the outer border, then those that nothing begins.
  std::vector<Shore> shores() {
    std::vector<Shore> shores;
    for (const bool heads : {true, false})
      for (std::size_t i = 0; i < parts_.size(); ++i)
        if (!used_[i] && (!heads || !follows_another_[i])) shores.push_back(from(i));
    return shores;
  }

 private:
  /// What leaves by the south enters from the north, and so on.
  std::optional<std::size_t> after(const Part& part) const {
    if (part.exit == no_side) return std::nullopt;
    const auto found = begins_.find({part.polygon, part.places.back(), (part.exit + 2) % 4});
    return found == begins_.end() ? std::nullopt : std::optional(found->second);
  }

  Shore from(std::size_t first) {
    Shore shore{parts_[first].polygon, parts_[first].entry == no_side, {}};
    for (std::optional<std::size_t> at = first; at; at = after(parts_[*at])) {
      if (used_[*at]) {
        shore.closed = true;
        break;
      }
      used_[*at] = true;
      for (const Place& place : parts_[*at].places)
        if (shore.places.empty() || shore.places.back() != place) shore.places.push_back(place);
    }
    while (shore.closed && shore.places.size() > 1 && shore.places.front() == shore.places.back())
      shore.places.pop_back();
    return shore;
  }

  std::vector<Part> parts_;
  std::map<Gate, std::size_t> begins_;
  std::vector<bool> follows_another_, used_;
};

}  // namespace

Window window_of_degrees(std::int64_t west, std::int64_t east, std::int64_t south, std::int64_t north) {
  const std::int64_t half = least_distance / 2;
  return {{west * steps_per_degree + half, south * steps_per_degree + half},
          {east * steps_per_degree - half, north * steps_per_degree - half}};
}

std::vector<Shore> assemble(const BinnedShores& binned, const Window& window) {
  std::vector<Shore> shores = Joining(Bins(binned, window).parts()).shores();
  std::erase_if(shores, [](const Shore& shore) { return shore.closed && shore.places.size() < 3; });
  return shores;
}

}  // namespace tribunal::shores
