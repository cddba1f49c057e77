// What the micro benchmark times: an implementation of a predicate, bound to the queries of a cell.
#pragma once

#include "bench/micro/query_set.hpp"
#include "predicates/decision.hpp"
#include "predicates/kernel.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tribunal::bench {

/// A loop over the queries of a set, which must outlive it. One virtual call serves all of them: inside, the
/// implementation is called directly and may be inlined.
class SignLoop {
 public:
  SignLoop() = default;
  SignLoop(const SignLoop&) = delete;
  SignLoop& operator=(const SignLoop&) = delete;
  virtual ~SignLoop() = default;

  /// The signs of the first signs.size() queries. This is what is timed.
  virtual void sign(std::span<Sign> signs) const = 0;
  /// The same with the deciding stages.
  virtual void decide(std::span<Decision> decisions) const = 0;
};

/// A loop, or why there is none: the queries lie outside the domain.
using SignLoopBinding = Binding<std::unique_ptr<const SignLoop>>;

/// Something to be timed. `bind` throws nothing of its own.
struct Subject {
  std::string name;
  bool promises_exactness;
  std::function<SignLoopBinding(const QuerySet&)> bind;
};

/// Every backend, called as an engine that is a template over it calls it, not through the interface of
/// kernels. In the order of the list of backends.
std::vector<Subject> backend_subjects();

/// `filtered-batch`: the batched entry points of `filtered`, over columns of coordinates.
Subject batch_subject();

/// The predicates of a plug-in (predicates/plugin/tribunal_predicates.h) by their batched entries, so that
/// crossing the boundary costs nothing per query; what has none is refused. Nothing where the module offers
/// no predicates at all. Throws PluginError where it cannot be used.
std::optional<Subject> plugin_subject(const std::string& module_path);

}  // namespace tribunal::bench
