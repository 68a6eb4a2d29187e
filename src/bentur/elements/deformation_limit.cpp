#include "bentur/elements/deformation_limit.h"

#include "bentur/core/require.h"

namespace bentur {

DeformationLimit::DeformationLimit(double limit) : limit_(limit) { require_positive("limit", limit); }

Branch DeformationLimit::branch(const LawState& state) const noexcept {
  if (state.branch != 0) return Branch{};
  return Branch{}.guarded_by({{.constant = limit_, .deformation = -1}, {.constant = limit_, .deformation = 1}});
}

LawState DeformationLimit::next(const LawState& /*state*/, std::size_t /*guard*/, double time, double /*deformation*/,
                                double /*speed*/) const noexcept {
  return {.branch = 1, .since = time};
}

}  // namespace bentur
