#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/core/units.h"
#include "bentur/excitation/design_spectrum.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/model/contact/contact_spec.h"
#include "bentur/model/gap/code_rules.h"
#include "bentur/model/gap/levels.h"
#include "bentur/model/gap/modal_combination.h"
#include "bentur/model/gap/screening.h"
#include "bentur/model/link.h"
#include "bentur/model/project.h"
#include "bentur/model/support_spec.h"
#include "bentur/pounding/plan/faces.h"
#include "bentur/pounding/pounding.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/frame/storey_columns.h"
#include "bentur/structure/known/displacements.h"
#include "bentur/structure/known/generic.h"
#include "bentur/structure/known/modal.h"
#include "bentur/structure/plan/plan.h"
#include "bentur/structure/stick.h"

// A case as plain data: what a user asks for, of buildings in a row and in plan.
namespace bentur {

struct SuiteSpec;
struct TomlValue;

/// Matrices from another program. Elevations are above the building's own base.
struct MatricesSpec {
  std::vector<double> elevations;  ///< [length], ascending, > 0
  Eigen::MatrixXd mass;            ///< [mass]
  Eigen::MatrixXd stiffness;       ///< [force/length]
};

/// What moves with the ground: a moat wall.
struct RigidSpec {
  std::vector<double> elevations;  ///< [length] above the base, ascending
};

/// The same of buildings in plan.
struct PlanWall {
  Footprint footprint;
  std::vector<double> elevations;  ///< [length] above the base, ascending
};

struct BuildingSpec {
  std::string name;
  /// All buildings of a case stand in plan, Plan or PlanWall, or none.
  std::variant<PlaneFrame, Stick, MatricesSpec, RigidSpec, ModalBuilding, GenericBuilding, DisplacementsSpec, Plan,
               PlanWall>
      structure;
  std::optional<StoreyColumns> columns = {};  ///< of a stick or a generic building
  Damping damping;
  /// The stiffness part of damping follows the stiffness of a storey that yields, Building::tangent_damping.
  bool tangent_damping = false;
  std::optional<double> calibrate_period;  ///< [s]
  double base_elevation = 0;               ///< of the base above the ground datum [length]
  std::optional<double> width;             ///< [length] for wave_velocity; a frame's is the sum of its bays
  bool p_delta = false;                    ///< gravity loads are the floors' weights
  std::vector<double> gravity_loads = {};  ///< [force] per floor; empty: none, or as p_delta says
  double gravity = 0;                      ///< of the case [length/s²], for weights
  std::optional<IsolationSpec> isolation = {};
  std::optional<SoilSpec> soil = {};
  std::string shapes_path = {};  ///< where the shapes of a building known by its modes were read; no result holds that

  [[nodiscard]] bool is_in_plan() const;
  /// Of one in plan.
  [[nodiscard]] const Footprint& footprint() const;
  /// Whether it moves with the ground.
  [[nodiscard]] bool is_rigid() const;
};

struct GapSpec {
  std::vector<double> widths;      ///< [length], one per point; one alone where there are no points
  std::vector<double> elevations;  ///< [length] absolute, one per point, ascending; empty: floors are watched alone
  ContactSpec contact;
  std::optional<double> level_tolerance = std::nullopt;  ///< [length] as level_floors() takes it
  bool strikes_columns = false;                          ///< floors may strike columns between floors
  /// What the column that is struck at each contact point carries; one value per point, or none: not given.
  struct ColumnCapacity {
    std::vector<double> shear = {};   ///< [force]
    std::vector<double> moment = {};  ///< [force·length]
  };
  std::optional<ColumnCapacity> column_capacity = std::nullopt;
  // Of buildings in plan, in place of widths and elevations:
  Eigen::Index left = 0, right = 0;    ///< L and R of the stretch (P-6)
  Stretch stretch = {};                ///< where they face each other
  std::vector<LevelPair> levels = {};  ///< floors of L and R that meet, from the lowest up
  int points = 2;                      ///< of each level
};

/// What was read from a record file, echoed to the user.
struct RecordEcho {
  std::string file;          ///< as the case names it
  std::string path = {};     ///< where it was read; no result holds that
  std::uint64_t size = 0;    ///< bytes
  std::string sha256 = {};   ///< of them; empty where nobody has asked
  std::string format;        ///< as record_formats() of io
  std::string unit;          ///< of the file
  std::string channel = {};  ///< which of several, as "channel 2 of 3 (Chan 2: 360 Deg)"; else empty
  int header_lines = 0;      ///< passed over before the first value
  double mean_removed = 0;   ///< taken off all values, in the file's unit
  double time_step = 0;      ///< [s]
  long count = 0;
  double duration = 0;                          ///< (count − 1) · step [s]
  double pga_read = 0;                          ///< largest |a| in the file's unit
  bool reversed = false;                        ///< applied reversed, every value times −1
  double pga = 0;                               ///< largest |a| as applied, after scaling [length/s²]
  std::optional<double> pga_without_unit = {};  ///< what it was scaled to, where that was a plain number [length/s²]
};

/// A design spectrum in place of a motion, or peak displacements as given: for gaps alone (model/gap/spectral_gap.h).
struct SpectrumSpec {
  DesignSpectrum spectrum;  ///< in the case's units
  std::string shape;        ///< as the case names it
  ModalCombination combination = ModalCombination::cqc;
  std::vector<double> reduction = {};  ///< of the displacements that rules of codes amplify, one per building [-] > 0
  std::string file = {}, path = {};    ///< the table, as the case names it and where it was read; empty: none
  SourcePosition position = {};        ///< of its kind in the case file
  bool of_displacements = false;       ///< no spectrum either: all that moves is known by its displacements
};

struct ExcitationSpec {
  GroundMotion motion;               ///< scaled, in the case's units; without one NoMotion
  std::optional<RecordEcho> record;  ///< for kind = "record"
  /// What its peak is as a number where another unit may be meant: of kind = "harmonic" an acceleration without one
  /// [length/s²], of a record the largest value in a file that does not say it [the case's unit of the file].
  std::optional<double> amplitude_without_unit = {};
  std::optional<SpectrumSpec> spectrum = {};  ///< for kind = "spectrum" and "displacements"
  /// For kind = "suite" (suite/suite.h): many motions in place of one, which is NoMotion.
  std::shared_ptr<const SuiteSpec> suite = {};
  std::vector<double> delays;  ///< [s], one per building (from wave_velocity where that was given)
  Kinematics kinematics = Kinematics::relative;
};

struct InitialSpec {  ///< per building, per floor, in plan u_x, u_y, θ of each; empty: at rest
  std::vector<std::vector<double>> displacements, velocities;
};

/// What a run may take (solve/effort.h). More is refused beforehand where that is certain, else the run ends there.
struct LimitsSpec {
  double steps = 2e7;    ///< [-] minutes of a case of some floors
  double events = 1e6;   ///< [-] each takes up to 1 kB
  double seconds = 0;    ///< [s] of wall time; 0: no limit
  double memory = 1000;  ///< [MB]
};

struct AnalysisSpec {
  double duration = 0;   ///< [s]
  bool goes_on = false;  ///< that is a record's, not given: the run goes on as Problem::goes_on
  Solver solver = ExactSolver{};
  double output_step = 0.01;  ///< [s]
  bool energy_audit = false;
  bool both_ways = true;  ///< what the reversed motion needs is reported too
  LimitsSpec limits = {};
  double collapse_drift = 0.1;  ///< as Problem::collapse_drift [-]
};

/// The file a case was read from.
struct CaseSource {
  std::string file;  ///< its name, without folders
  std::string text;
  std::string sha256;   ///< of the text
  bool copied = false;  ///< a copy stands with the results
};

/// A case as plain data, validated, in its own consistent units.
struct Case {
  std::string title;
  Units units;
  std::vector<BuildingSpec> buildings;
  std::vector<GapSpec> gaps;         ///< one between each pair of neighbours; in plan of each pair that may touch
  std::vector<LinkSpec> links = {};  ///< in any order
  ExcitationSpec excitation;
  ExcitationSpec excitation_y = {};  ///< in plan, [excitation.y]; delays and kinematics are those of the first
  double angle = 0;                  ///< in plan, of both, from x and y counter-clockwise [degrees] (P-3)
  InitialSpec initial;
  AnalysisSpec analysis;
  CodeSpec code = {};  ///< without rules: none were given
  ScreeningSpec screening = {};
  std::optional<ProjectSpec> project = {};
  std::optional<CaseSource> source = {};  ///< nothing: it was read from no file
  /// What was read (io/toml), for reports; null of a case that was put together otherwise.
  std::shared_ptr<const TomlValue> given = {};

  [[nodiscard]] bool is_in_plan() const { return !buildings.empty() && buildings.front().is_in_plan(); }
  /// Of a row one, in plan also that along y.
  [[nodiscard]] std::vector<const ExcitationSpec*> excitations() const;
};

}  // namespace bentur
