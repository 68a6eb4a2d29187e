#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/units.h"

namespace bentur {

struct Problem;

/// How strongly the ground is expected to shake, in the classes of FEMA P-154; ASCE 41 has three of them, and
/// moderately high and very high count as high there.
enum class Seismicity { low, moderate, moderately_high, high, very_high };

/// The words of a case for them, in that order.
[[nodiscard]] const std::vector<std::string>& seismicity_words();

/// [screening] of a case.
struct ScreeningSpec {
  std::optional<Seismicity> seismicity = {};
};

/// A rule that looks at how two neighbours stand, before anything is computed. None was read for this: by memory.
struct ScreeningRule {
  std::string_view name, title;
  std::string_view source;   ///< publication, and where in it
  std::string_view wording;  ///< "by memory, check the text", or "ours"
  std::string_view unit;     ///< of value and limit: "length" stands for that of the case
  bool yes_or_no = false;    ///< its value is 1 or 0
};
/// With H, n height and storeys of the shorter building above its own base, w the narrowest width of the gap:
///
///   floors-meet    the largest distance in height from a floor to the nearest floor of the neighbour, up to the lower
///                  roof: at most 2 ft                                                        FEMA P-154 (2015)  (1)
///   storeys-apart  difference of the numbers of storeys: below 2                             FEMA P-154         (2)
///   end-of-row     one of the two ends a row of three or more                                FEMA P-154         (3)
///   gap-per-storey w at least n times 2, 1½, 1, ½, ½ in of very high, high, moderately high, moderate, low
///                  seismicity                                                                FEMA P-154         (4)
///   pounding       (4) falls short and one of (1) to (3) holds                               FEMA P-154         (5)
///   gap-per-height w at least 1.5, 0.5, 0.25 % of H in high, moderate, low seismicity        ASCE 41-17, Tier 1 (6)
///   mass-ratio     mass of the heavier over that of the lighter building: below 2; no code has this limit       (7)
///   eccentricity   of buildings in plan: the largest distance between a floor's centre of mass and the centre of
///                  rigidity of the storey below, along x or y over the side there: below 20 %
///                                                                                            ASCE 41-17, Tier 1 (8)
[[nodiscard]] const std::vector<ScreeningRule>& screening_rules();

struct ScreeningFinding {
  enum class Verdict { fine, attention, needs_seismicity, not_applicable };
  const ScreeningRule* rule = nullptr;
  double value = 0;                  ///< in the rule's unit
  std::optional<double> limit = {};  ///< nothing: needs [screening] seismicity, or the rule has none
  Verdict verdict = Verdict::fine;
};
/// "no concern", "attention", "needs screening.seismicity", "does not apply".
[[nodiscard]] std::string_view verdict_text(ScreeningFinding::Verdict verdict);

/// A building as the rules look at it.
struct StandingBuilding {
  std::vector<double> floors;  ///< elevations [length], without a slab on bearings
  double height = 0;           ///< [length]
  double mass = 0;             ///< [mass]
  bool is_backed = false;      ///< a building that moves stands on its other side, along the line of the gap
  std::optional<double> eccentricity = {};  ///< of (8) [%]; nothing: of a row, or not known
};

/// Every rule for two buildings with a gap between them. @param width narrowest [length]; infinite where no floors face
/// one another
[[nodiscard]] std::vector<ScreeningFinding> screening(const StandingBuilding& left, const StandingBuilding& right,
                                                      double width, const ScreeningSpec& spec, const Units& units);
/// Every rule for the gap to the right of building `gap`; none where one of the two moves with the ground.
[[nodiscard]] std::vector<ScreeningFinding> screening(const Problem& problem, Eigen::Index gap,
                                                      const ScreeningSpec& spec, const Units& units);

}  // namespace bentur
