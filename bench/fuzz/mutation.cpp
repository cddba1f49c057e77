#include "bench/fuzz/mutation.hpp"

#include "bench/fuzz/ulps.hpp"

#include <bit>
#include <cmath>

namespace tribunal::bench::fuzz {
namespace {

double without_low_bits(double x, int bits) {
  const std::uint64_t kept = ~std::uint64_t{0} << bits;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & kept);
}

template <class Change>
void change_axis(Case& asked, int axis, Change change) {
  for (int i = 0; i < asked.points(); ++i) {
    double& c = asked.point(i)[axis];
    c = made_finite(change(c));
  }
}

}  // namespace

Mutation draw_mutation(Random& random) {
  Mutation mutation{};
  mutation.kind = static_cast<Mutation::Kind>(random.below(Mutation::kinds));
  mutation.first = static_cast<std::uint8_t>(random.below(Case::most_numbers));
  mutation.second = static_cast<std::uint8_t>(random.below(Case::most_numbers));
  const std::uint64_t most = random.below(4) == 0 ? 600 : 4;
  mutation.amount =
      static_cast<std::int16_t>(static_cast<int>(random.below(2 * most + 1)) - static_cast<int>(most));
  return mutation;
}

void apply(const Mutation& mutation, Case& asked) {
  const auto numbers = asked.numbers();
  double& number = numbers[mutation.first % numbers.size()];
  double& other = numbers[mutation.second % numbers.size()];
  const int point = mutation.first % asked.points(), other_point = mutation.second % asked.points();
  const int axis = mutation.first % asked.dimension(), amount = mutation.amount;
  const auto scaled = [&](double c) { return std::ldexp(c, amount); };
  switch (mutation.kind) {
    case Mutation::Kind::step:
      number = moved_by_ulps(number, amount);
      return;
    case Mutation::Kind::copy_number:
      other = number;
      return;
    case Mutation::Kind::copy_point:
      return asked.copy_point(point, other_point);
    case Mutation::Kind::swap_points:
      return asked.swap_points(point, other_point);
    case Mutation::Kind::scale_number:
      number = made_finite(scaled(number));
      return;
    case Mutation::Kind::scale_axis:
      return change_axis(asked, axis, scaled);
    case Mutation::Kind::scale_all:
      for (double& c : numbers) c = made_finite(scaled(c));
      return;
    case Mutation::Kind::translate:
      return change_axis(asked, axis, [by = other](double c) { return c + by; });
    case Mutation::Kind::move_to_origin:
      for (int j = 0; j < asked.dimension(); ++j)
        change_axis(asked, j, [by = asked.point(point)[j]](double c) { return c - by; });
      return;
    case Mutation::Kind::snap:
      number = without_low_bits(number, std::abs(amount) % 53);
      return;
    case Mutation::Kind::negate:
      number = -number;
      return;
    case Mutation::Kind::zero:
      number = 0;
      return;
  }
}

}  // namespace tribunal::bench::fuzz
