#pragma once

#include <string>

#include "bentur/model/case.h"
#include "bentur/model/judgement/judge.h"
#include "bentur/pounding/plan/plan_problem.h"

namespace bentur {

/// Whether a gap closes by how the buildings move, or would: where one of them collapses no width is known to do.
[[nodiscard]] bool may_close(const Judgement& judgement);

/// What is known of a building in the words of the GEM Building Taxonomy 2.0, attributes that are not known left out:
/// the lateral system (LFM, LDUAL, LWAL), its storeys (HEX:n), its place in the block (BPD alone, BP1, BP2, BP3 with
/// neighbours on so many sides or more), and where it may pound the atom POP of vertical irregularity (IRIR+IRVP:POP).
/// Source: Brzev et al. (2013), GEM Building Taxonomy version 2.0, GEM Technical Report 2013-02: by memory, check the
/// text.
/// @param pounds whether a gap beside it may_close()
[[nodiscard]] std::string gem_taxonomy(const Case& c, const Problem& problem, Eigen::Index building, bool pounds);
/// The same of one in plan: its sides are those towards −x, +x, −y and +y.
[[nodiscard]] std::string gem_taxonomy(const Case& c, const PlanProblem& problem, Eigen::Index building, bool pounds);

}  // namespace bentur
