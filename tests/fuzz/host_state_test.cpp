// Law: under every rounding mode, and with subnormal numbers flushed on the way out or in, a backend answers
// rightly or refuses; it is never wrong.
#include "bench/fuzz/batch.hpp"
#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/oracle.hpp"
#include "predicates/environment.hpp"
#include "tests/fuzz/planted.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <optional>
#include <stdexcept>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace tribunal::bench::fuzz {
namespace {

struct HostState {
  const char* name;
  bool sound;
  void (*enter)();
};

const HostState states[] = {
    {"to nearest", true, [] { std::fesetround(FE_TONEAREST); }},
    {"upward", false, [] { std::fesetround(FE_UPWARD); }},
    {"downward", false, [] { std::fesetround(FE_DOWNWARD); }},
    {"toward zero", false, [] { std::fesetround(FE_TOWARDZERO); }},
#if defined(__SSE2__)
    {"flush to zero", false, [] { _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON); }},
    {"denormals are zero", false, [] { _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON); }},
#endif
};

/// Enters a state and leaves it at the end of the scope, the SSE control word included.
class Entered {
 public:
  explicit Entered(const HostState& state) {
    std::fegetenv(&saved_);
    state.enter();
  }
  Entered(const Entered&) = delete;
  Entered& operator=(const Entered&) = delete;
  ~Entered() { std::fesetenv(&saved_); }

 private:
  std::fenv_t saved_{};
};

/// What came of a batch: refused, or the signs.
std::optional<std::vector<Sign>> answers(const Subject& subject, const Batch& batch, const HostState& state) {
  std::vector<Sign> signs;
  signs.reserve(batch.cases.size());
  const Entered entered(state);
  const auto binding = bind_subject(subject, batch.cases);
  if (std::holds_alternative<Refusal>(binding)) return std::nullopt;
  for (const Case& asked : batch.cases) signs.push_back(std::get<BoundSubject>(binding).decide(asked).sign);
  return signs;
}

TEST(HostState, EveryExactBackendIsRightOrRefuses) {
  for (const BackendEntry& entry : backends()) {
    if (!entry.about->exact) continue;
    const Subject subject = subject_of(entry);
    std::uint64_t answered = 0;
    for (std::uint64_t index = 0; index < 80; ++index) {
      const Batch batch = draw_batch(21, index, all_predicates[index % 4], Pool{}, 32);
      Oracle oracle(OracleKind::gmp);  // asked here, outside
      const std::vector<Sign> truths = oracle.judge(batch.cases);
      for (const HostState& state : states) {
        const auto signs = answers(subject, batch, state);
        if (!signs) continue;
        EXPECT_EQ(*signs, truths) << entry.about->name << ", " << state.name << ", " << batch.source;
        answered += state.sound ? signs->size() : 0;
      }
    }
    EXPECT_GT(answered, 0U) << entry.about->name;
  }
}

TEST(HostState, TheFrontDoorNamesTheFault) {
  const std::vector<Point2> points{{{0, 0}}, {{1, 0}}, {{0, 1}}};
  for (const BackendEntry& entry : backends())
    for (const HostState& state : states) {
      std::string reason;
      {
        const Entered entered(state);
        const Kernel2Binding binding = entry.bind2(points);
        if (const auto* refusal = std::get_if<Refusal>(&binding)) reason = refusal->reason;
      }
      EXPECT_EQ(reason.empty(), state.sound) << entry.about->name << ", " << state.name << ": " << reason;
    }
}

/// Why the door is guarded: past it, certified filters certify wrong signs in these states.
TEST(HostState, UnguardedTheFilterWouldCertifyWrongSigns) {
  for (const HostState& state : states) {
    int wrong = 0;
    for (std::uint64_t index = 0; index < 3000 && wrong == 0; ++index) {
      const Batch batch = draw_batch(22, index, all_predicates[index % 4], Pool{}, 16);
      std::vector<Sign> certified;
      {
        const Entered entered(state);
        for (const Case& asked : batch.cases) certified.push_back(certified_sign(asked));
      }
      for (std::size_t i = 0; i < certified.size(); ++i)
        wrong += certified[i] != Sign::zero && certified[i] != exact_sign(batch.cases[i]);
    }
    EXPECT_TRUE(wrong == 0 || !state.sound) << state.name;
    if (std::string_view(state.name) == "flush to zero") {
      EXPECT_GT(wrong, 0) << state.name;
    }
  }
}

/// A kernel bound before the change is the caller's to look after; the hunt looks after every batch, and its
/// oracle refuses from the start.
TEST(HostState, TheHuntRefusesAnUnsoundOne) {
  for (const HostState& state : states) {
    const auto run = [&] {
      const Entered entered(state);
      hunt(hunt_for({listed("gmp")}, 10));
    };
    if (state.sound) {
      EXPECT_NO_THROW(run()) << state.name;
    } else {
      EXPECT_THROW(run(), std::runtime_error) << state.name;
    }
  }
  EXPECT_TRUE(witness_floating_point().sound());
}

}  // namespace
}  // namespace tribunal::bench::fuzz
