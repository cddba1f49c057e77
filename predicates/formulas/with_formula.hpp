// From a predicate's name at run time to its formula at compile time.
#pragma once

#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/predicate.hpp"

#include <cstdlib>

namespace tribunal {

/// visit.operator()<Formula>(), with the formula of the predicate.
template <class Visit>
decltype(auto) with_formula(Predicate predicate, Visit visit) {
  switch (predicate) {
    case Predicate::orient2d:
      return visit.template operator()<Orient<2>>();
    case Predicate::incircle:
      return visit.template operator()<InSphere<2>>();
    case Predicate::orient3d:
      return visit.template operator()<Orient<3>>();
    case Predicate::insphere:
      return visit.template operator()<InSphere<3>>();
  }
  std::abort();
}

}  // namespace tribunal
