#include "bench/fuzz/bytes.hpp"

#include "bench/fuzz/batch.hpp"
#include "bench/fuzz/hex_float.hpp"
#include "bench/fuzz/hunt.hpp"
#include "bench/fuzz/mutation.hpp"
#include "bench/fuzz/oracle.hpp"
#include "bench/fuzz/subject.hpp"
#include "bench/fuzz/ulps.hpp"
#include "predicates/backends/list.hpp"

#include <bit>

namespace tribunal::bench::fuzz {
namespace {

/// Takes bytes from the front; zeros after the end.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool at_end() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  std::uint64_t word(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= static_cast<std::uint64_t>(byte()) << (8 * i);
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

Case drawn_case(Reader& reader, Predicate predicate) {
  const std::uint64_t seed = reader.word(8);
  const std::size_t number = reader.byte() % std::size_t{16};
  const Batch batch = draw_batch(seed, 0, predicate, Pool{}, 2 * number + 1);
  return batch.cases[number];
}

Case written_case(Reader& reader, Predicate predicate) {
  Case asked{predicate};
  for (double& c : asked.numbers()) c = made_finite(std::bit_cast<double>(reader.word(8)));
  return asked;
}

}  // namespace

Case case_of_bytes(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  const Predicate predicate = all_predicates[reader.byte() % all_predicates.size()];
  Case asked = reader.byte() % 2 == 0 ? written_case(reader, predicate) : drawn_case(reader, predicate);
  while (!reader.at_end()) {
    Mutation mutation{};
    mutation.kind = static_cast<Mutation::Kind>(reader.byte() % Mutation::kinds);
    mutation.first = reader.byte();
    mutation.second = reader.byte();
    mutation.amount = static_cast<std::int16_t>(reader.word(2));
    apply(mutation, asked);
  }
  return asked;
}

std::string judge_bytes(std::span<const std::uint8_t> bytes) {
  const Case asked = case_of_bytes(bytes);
  const Sign exact = exact_sign(asked);
  for (const BackendEntry& entry : backends()) {
    if (!entry.about->exact) continue;
    const auto binding = bind_subject(subject_of(entry), std::span(&asked, 1));
    if (std::holds_alternative<Refusal>(binding)) continue;
    const auto& bound = std::get<BoundSubject>(binding);
    const Decision decision = bound.decide(asked);
    if (broken_law(bound, asked, decision, exact))
      return std::string(entry.about->name) + " says " + to_char(decision.sign) + ", exact is " +
             to_char(exact) + ": tribunal sign " + query_text(asked);
  }
  return {};
}

std::string query_text(const Case& asked) {
  std::string text(to_string(asked.predicate));
  for (const double c : asked.numbers()) text += " " + hex_float(c);
  return text;
}

}  // namespace tribunal::bench::fuzz
