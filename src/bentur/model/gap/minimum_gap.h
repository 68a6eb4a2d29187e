#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/units.h"
#include "bentur/model/gap/code_rules.h"
#include "bentur/model/gap/facing_levels.h"
#include "bentur/model/gap/separation_rules.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// What rules combine at one level, wherever it comes from [length]. NaN: not known.
struct LevelPeaks {
  double left = 0, right = 0;                    ///< peak displacements of both faces
  double left_of_codes = 0, right_of_codes = 0;  ///< those that rules of codes amplify
  double gap_needed = 0;  ///< the peak of left less right, not below 0; of peaks that are given their sum
  std::optional<double> gap_needed_reversed = {};
};

/// The gap that one level needs: simulated or by a spectrum, and by the rules [length]. NaN where a rule has nothing to
/// go by.
struct LevelSeparation {
  FacingLevel level;
  double gap_needed = 0;
  std::optional<double> gap_needed_reversed = {};
  double abs = 0, srss = 0, ddc = 0;
  std::vector<CodeSeparation> codes = {};  ///< one per rule of the case's [code], in its order
};

/// How two neighbours stand at a level, without displacements.
[[nodiscard]] CodePair code_pair(const Problem& problem, const FacingLevel& level, const CodeSpec& code,
                                 const Units& units);

/// One entry per facing level of the problem, as facing_levels() has them. `units` are those of the problem. DDC is not
/// known of buildings whose damping is not, as results read back have them, nor where links tie the two together.
/// @throws InvalidParameter when a code rule lacks something.
[[nodiscard]] std::vector<LevelSeparation> separations(const Problem& problem,
                                                       const std::function<LevelPeaks(const FacingLevel&)>& peaks_at,
                                                       const CodeSpec& code, const Units& units);

/// The same from the free response, which has been asked for SolveOptions::levels.
/// @throws InvalidParameter when the response is not that of the problem, or a code rule lacks something.
[[nodiscard]] std::vector<LevelSeparation> separations(const Problem& problem, const Response& response,
                                                       const CodeSpec& code = {}, const Units& units = {});

/// Those of one gap.
[[nodiscard]] std::vector<LevelSeparation> of_gap(const std::vector<LevelSeparation>& all, Eigen::Index gap);

/// Each number the largest of all levels that are given, as a width of the whole gap: where edges are not parallel,
/// places that are further apart than the gap is wide need as much less of it. 0 where there are none, NaN where it is
/// not known of one.
[[nodiscard]] LevelSeparation largest_of(const std::vector<LevelSeparation>& levels);

/// What one rule asks of a gap, at the level where it falls short the most or has least to spare.
struct RuleFinding {
  /// Why a rule says nothing.
  enum class Silence {
    none,           ///< it does
    no_level,       ///< the neighbours face one another nowhere
    collapsed,      ///< falls_without_contact()
    linked,         ///< links tie the buildings, so that they have no periods of their own
    unknown,        ///< what it combines is not known at some level
    property_line,  ///< a property line stands in the gap, of which its clause does not speak
    displacements,  ///< heights alone do not say
    turning,        ///< it needs a period of each building across the gap: floors that turn have none
    periods,        ///< it needs the periods of both, and of one alone peak displacements are given
    public_way,     ///< at a line in common with a public way its clause asks for nothing
  };
  std::string rule;                    ///< "abs", "srss", "ddc", or a name of code_rules()
  std::string title;                   ///< as people call it
  std::optional<std::size_t> at = {};  ///< that level, an index into the separations; nothing where the rule is silent
  double gap = 0;                      ///< asked for there [length]
  std::optional<double> to_left = {}, to_right = {};  ///< from the left, right building to a line [length]
  bool is_short = false;                              ///< more than is given, beyond round-off
  /// By how much a gap of one width by this rule, what it asks for at most, is less than the motion needs in either
  /// direction [length]; nothing where it is not less beyond round-off, or not known
  std::optional<double> lacks = {};
  double most = 0;  ///< what it asks for at most, as the width of the whole gap [length]
  Silence silence = Silence::none;
};

/// Of ABS, SRSS, DDC and each rule of [code]. A rule that is short somewhere says so whatever is not known elsewhere;
/// nothing is "wide enough" that was not looked at on every level.
/// @param levels of one gap
/// @param scale displacement_scale() [length], for round-off
/// @param falls falls_without_contact()
/// @param in_plan of a pair of buildings in plan
[[nodiscard]] std::vector<RuleFinding> rule_findings(const Problem& problem, const std::vector<LevelSeparation>& levels,
                                                     const CodeSpec& code, double scale, bool falls, bool in_plan);

/// Whether one of the two is known by its peak displacements alone: how they move together is not known.
[[nodiscard]] bool is_known_by_peaks(const Problem& problem, Eigen::Index gap);

/// Whether a link ties the two buildings of a gap, or one of them to a third.
[[nodiscard]] bool is_linked(const Problem& problem, Eigen::Index gap);

}  // namespace bentur
