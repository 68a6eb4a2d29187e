#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/model/case.h"
#include "bentur/model/story/internal/remark_list.h"

// What is looked at of buildings, motions and gaps, of rows and plans alike.
namespace bentur::remarking {

/// A building that moves.
struct BuildingLook {
  const std::string& name;
  double omega = 0;          ///< ω₁ [rad/s]; 0: of a free body
  double damping_rate = 0;   ///< 2ζω₁ of its first mode [1/s]
  bool on_bearings = false;  ///< which are there to change both
  std::size_t storeys = 0;   ///< above bearings
  const std::vector<double>& heights;
  const std::vector<double>& masses;
  double width = 0;  ///< [length]; 0: not known
  std::optional<double> stiffness_factor = {};
  std::vector<const PlaneFrame*> frames = {};
};
void check_building(const BuildingLook& look, const Units& units, List& list);

/// What came out of a building, over both responses.
struct ResponseLook {
  const std::string& name;
  double drift = 0;       ///< largest over the height [-]
  double base_shear = 0;  ///< largest over the weight [-]
  bool yields = false;
  long broken_columns = 0;
};
void check_response(const ResponseLook& look, List& list);

/// One component of the ground's motion. @param subject "" where there is one alone
void check_motion(const GroundMotion& motion, const ExcitationSpec& excitation, const std::string& subject,
                  double duration, const Units& units, List& list);
void check_delays(const std::vector<std::string>& names, const std::vector<double>& delays, double duration,
                  List& list);
/// Whether the times of a record are those of an earthquake in seconds.
void check_record(const RecordEcho& record, const std::string& subject, List& list);
/// Factors of codes that amplify displacements under reduced forces, beside a motion.
void check_codes(const CodeSpec& code, List& list);
/// Of a rectangle with the area and inertia of a section [length].
[[nodiscard]] double depth_of(const Section& section);

/// The frames that a building is, or has in plan.
[[nodiscard]] std::vector<const PlaneFrame*> frames_in(const BuildingSpec& spec);
/// The width of a building, in plan the shorter side [length]; 0: not known.
[[nodiscard]] double width_of(const BuildingSpec& spec);
/// The depth of the beams at a floor [length], in plan of the deepest of its frames; nothing where it is not known.
[[nodiscard]] std::optional<double> beam_depth(const Case& c, Eigen::Index building, Eigen::Index floor);

/// Two floors that meet, or a floor and what it strikes.
struct LevelLook {
  const std::string& gap;
  double width = 0;                       ///< [length]
  double apart = 0;                       ///< one floor above the other [length]
  std::optional<double> beam_depth = {};  ///< of the upper one; nothing: not known [length]
  double overlap = 0;                     ///< at the start, > 0 [length]
  std::optional<double> stiffness = {};   ///< of their contact, where that has one [force/length]
  double compliance = 0;                  ///< 1/m of both together, of those that move [1/mass]; 0: not known
  double shorter_period = 0;              ///< of their buildings [s]; 0: none has one

  /// Takes what moves with a mass of one of the buildings, ω₁ [rad/s].
  void take(double mass, double omega);
};
void check_level(const LevelLook& look, const Units& units, List& list);
/// Elastic stiffness of a contact; nothing where its law has none that is constant. @param law its name in the case
[[nodiscard]] std::optional<double> stiffness_of(const std::string& law, const LawParameters& parameters);
/// What came out of a gap. @param penetration [length] @param slow_starts impacts
void check_impacts(const std::string& gap, double penetration, int slow_starts, List& list);
/// @param omegas ω₁ of all buildings [rad/s]
void check_output(double step, const std::vector<double>& omegas, double duration, List& list);
void check_discrepancies(const std::vector<Discrepancy>& found, List& list);

}  // namespace bentur::remarking
