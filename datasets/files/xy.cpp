// .xy: x y on each line, perhaps a third column with a value. .xyz reads the same, but is written with a
// third column of zeros, since readers of that ending expect three.
#include "datasets/files/columns.hpp"
#include "datasets/files/format.hpp"

namespace tribunal::files {
namespace {
std::string write_xy(std::span<const Point2> points) { return write_columns(points, " ", "\n"); }
std::string write_xyz(std::span<const Point2> points) { return write_columns(points, " ", " 0\n"); }
}  // namespace

constinit const Format xy{
    .about = {".xy", "points", "x y per line, blanks between; an optional third column is the value"},
    .read_points = read_columns,
    .write_points = write_xy,
};

constinit const Format xyz{
    .about = {".xyz", "points", "as .xy; written with a third column of zeros"},
    .read_points = read_columns,
    .write_points = write_xyz,
};

}  // namespace tribunal::files
