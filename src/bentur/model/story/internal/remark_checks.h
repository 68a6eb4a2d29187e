#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/model/case.h"
#include "bentur/model/story/internal/remark_list.h"
#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/problem.h"

// What is looked at of what a case gives, of rows and plans alike.
namespace bentur::remarking {

/// Heights, width and frames of a building. @param masses of its floors
void check_given(const BuildingSpec& spec, const std::vector<double>& heights, const std::vector<double>& masses,
                 List& list);
/// The depth of the beams at a floor [length], in plan of the deepest of its frames; nothing where it is not known.
[[nodiscard]] std::optional<double> beam_depth(const Case& c, Eigen::Index building, Eigen::Index floor);

/// Strengths, bearings and dashpots over the weight that they are there for, by which a wrong unit shows.
void check_strengths(const Case& c, const Problem& problem, List& list);
void check_strengths(const Case& c, const PlanProblem& problem, List& list);

/// One component of the ground's motion. @param subject "" where there is one alone
void check_motion(const GroundMotion& motion, const ExcitationSpec& excitation, const std::string& subject,
                  double duration, List& list);
/// Whether the times of a record are those of an earthquake in seconds.
void check_record(const RecordEcho& record, const std::string& subject, List& list);
/// Factors of codes that amplify displacements under reduced forces, beside a motion.
void check_codes(const CodeSpec& code, List& list);
/// Elastic stiffness of a contact; nothing where its law has none that is constant. @param law its name in the case
[[nodiscard]] std::optional<double> stiffness_of(const std::string& law, const LawParameters& parameters);

}  // namespace bentur::remarking
