// Backends made for these tests: an answer for any formula, behind the interface of a subject.
#pragma once

#include "bench/fuzz/hunt.hpp"
#include "bench/fuzz/subject.hpp"
#include "predicates/backend.hpp"
#include "predicates/backends/list.hpp"
#include "predicates/domain.hpp"

#include <memory>
#include <string>

namespace tribunal::bench::fuzz {

/// A backend of all finite doubles that asks Answer, a type with `decide<Formula>(query) const`.
template <class Answer>
class Planted : public Answer {
 public:
  static constexpr BackendAbout about{
      .name = "planted", .cites = "", .summary = "", .domain = "", .exact = true};
  template <int D>
  static Binding<Planted> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return Planted{};
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return is_finite(p);
  }
};

template <class Answer>
Subject planted(std::string name) {
  Subject subject = subject_of(backend_entry<Planted<Answer>>());
  subject.name = std::move(name);
  return subject;
}

inline Subject listed(const char* name) { return subject_of(*find_backend(name)); }

/// The hunt for some subjects with a number of queries.
inline HuntOptions hunt_for(std::vector<Subject> subjects, std::uint64_t queries) {
  HuntOptions options;
  options.subjects = std::move(subjects);
  options.queries = queries;
  return options;
}

}  // namespace tribunal::bench::fuzz
