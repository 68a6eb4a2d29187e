#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/story/remarks.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

// What a run knows of how safe its gaps are, of rows and of plans alike. Whatever is said of a gap being enough or too
// small is said from these facts, by judge() (judge.h), and from nothing else.
namespace bentur {

/// The ground motion as it is given, or times −1.
enum class Way { given, reversed };
inline constexpr Way ways_of_motion[] = {Way::given, Way::reversed};

/// A storey that falls: with its drift, collapse ends a run.
struct Fall {
  std::string building;
  Eigen::Index storey = 0;  ///< its number, for people
  double time = 0;          ///< [s]
};

/// A storey that goes beyond what it may: by its drift without contact what counts as collapse, where nothing looks for
/// that; by a spectrum the force that it carries.
struct Beyond {
  std::string building;
  Eigen::Index storey = 0;  ///< its number, for people
  double ratio = 0;         ///< [-] drift over height, or force over what is borne
};

/// What happened in one way of the motion, to all buildings.
struct WayFacts {
  bool looked_at = false;                      ///< without contact
  bool contact_looked_at = true;               ///< with contact, where there may be any
  std::optional<Fall> fall = {};               ///< without contact
  std::optional<Fall> fall_with_contact = {};  ///< it ends the run, after which nothing is known of contact
  std::vector<Beyond> drifts = {};
  std::vector<Beyond> capacities = {};  ///< of elastic buildings under a spectrum
};

/// What a level of a gap needs and what happens there: a contact point or a watched floor.
struct LevelFacts {
  FacingLevel at;
  /// Of one way of the motion.
  struct OneWay {
    std::optional<double> need = {};     ///< without contact [length]; nothing: not known
    std::optional<double> at_most = {};  ///< where only peaks are known: what both at once need [length]
    std::optional<double> to_come = {};  ///< what free vibration after the end could still need [length]
    int impacts = 0;                     ///< in the run with contact
    double peak_force = 0;               ///< [force]
    double depth = 0;  ///< by which a floor goes into what it faces, where no contact is modelled [length]
  };
  OneWay given = {}, reversed = {};
  [[nodiscard]] const OneWay& in(Way way) const { return way == Way::given ? given : reversed; }
  [[nodiscard]] OneWay& in(Way way) { return way == Way::given ? given : reversed; }
};

/// All of one gap.
struct GapFacts {
  std::string left, right;         ///< the buildings
  std::vector<LevelFacts> levels;  ///< from the lowest up
  WayFacts given, reversed;
  bool has_other_way = true;  ///< the ground moves, so that it can move the other way
  bool others_close =
      false;  ///< another gap of the row or block closes, either way: its needs are of buildings that meet nobody
  std::vector<RuleFinding> rules;  ///< of ABS, SRSS, DDC and [code]
  std::vector<Remark> doubts;      ///< remarks by which what was put in may not be meant
  double scale = 0;                ///< displacement_scale(), for round-off [length]
  bool masses_moved = false;       ///< others close and masses may stand elsewhere: with these contact is not looked at
  bool lacks_rules = false;        ///< of results read back without their case: its [code] is not known
  [[nodiscard]] const WayFacts& in(Way way) const { return way == Way::given ? given : reversed; }
  /// The largest contact force of all levels [force]; 0: none.
  [[nodiscard]] double peak_force(Way way = Way::given) const;
  /// Whether the buildings touch.
  [[nodiscard]] bool touch(Way way = Way::given) const;
};

/// What all gaps of a run have in common.
struct RunFacts {
  WayFacts given, reversed;
  bool has_other_way = true;       ///< the ground moves
  std::vector<Remark> doubts;      ///< of all buildings and gaps
  std::vector<std::string> names;  ///< of all buildings and gaps: what else a doubt is about, all share
  std::vector<bool> closes;        ///< per gap, either way
  bool masses_elsewhere = false;   ///< masses of some building may stand elsewhere than expected
  bool lacks_rules = false;        ///< as GapFacts::lacks_rules

  /// Another gap than this one does.
  [[nodiscard]] bool others_close(std::size_t gap) const;
};

/// Of one gap of a row, or of the row of two that a gap in plan is.
/// @param response of the problem, with what its reversed run found
/// @param levels its levels, as separations() has them
[[nodiscard]] GapFacts gap_facts(const Problem& problem, const Response& response, Eigen::Index gap,
                                 const std::vector<LevelSeparation>& levels, std::vector<RuleFinding> rules,
                                 const RunFacts& run, bool others_close);

/// The same by a spectrum.
[[nodiscard]] GapFacts gap_facts(const Problem& problem, Eigen::Index gap, const std::vector<LevelSeparation>& levels,
                                 std::vector<RuleFinding> rules, const RunFacts& run);

/// The doubts among remarks.
[[nodiscard]] std::vector<Remark> doubts_of(const std::vector<Remark>& remarks);

/// Whether bodies touch in a gap, or would in the other way of the motion.
[[nodiscard]] bool closes_either_way(const Problem& problem, const Response& response, Eigen::Index gap);

}  // namespace bentur
