#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
#include "bentur/pounding/pounding.h"
#include "bentur/pounding/problem.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/frame/storey_columns.h"
#include "bentur/structure/known/displacements.h"
#include "bentur/structure/known/generic.h"
#include "bentur/structure/known/modal.h"
#include "bentur/structure/stick.h"
#include "bentur/structure/support.h"

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

struct BuildingSpec {
  std::string name;
  std::variant<PlaneFrame, Stick, MatricesSpec, RigidSpec, ModalBuilding, GenericBuilding, DisplacementsSpec> structure;
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
};

/// Where columns of a building are struck; null: it has no columns that are known.
[[nodiscard]] const std::vector<ColumnNode>* column_nodes(const BuildingSpec& spec);
[[nodiscard]] std::vector<ColumnNode>* column_nodes(BuildingSpec& spec);
[[nodiscard]] bool has_column_nodes(const BuildingSpec& spec);

struct GapSpec {
  std::vector<double> widths;      ///< [length], one per point; one alone where there are no points
  std::vector<double> elevations;  ///< [length] absolute, one per point, ascending; empty: floors are watched alone
  ContactSpec contact;
  std::optional<double> level_tolerance = std::nullopt;  ///< [length] as level_floors() takes it
  bool strikes_columns = false;                          ///< floors may strike columns between floors
  /// What the column that is struck at each contact point bears; one value per point, or none: not given.
  struct ColumnCapacity {
    std::vector<double> shear = {};   ///< [force]
    std::vector<double> moment = {};  ///< [force·length]
  };
  std::optional<ColumnCapacity> column_capacity = std::nullopt;
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
  bool reversed = false;                        ///< applied the other way round, every value times −1
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
  GroundMotion motion;                        ///< scaled, in the case's units; without one NoMotion
  std::optional<RecordEcho> record;           ///< for kind = "record"
  std::optional<SpectrumSpec> spectrum = {};  ///< for kind = "spectrum" and "displacements"
  /// For kind = "suite" (suite/suite.h): many motions in place of one, which is NoMotion.
  std::shared_ptr<const SuiteSpec> suite = {};
  std::vector<double> delays;  ///< [s], one per building (from wave_velocity where that was given)
  Kinematics kinematics = Kinematics::relative;
};

struct InitialSpec {  ///< per building, per floor; empty: at rest
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
  bool both_ways = true;  ///< what the reversed motion needs is told too
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
  std::vector<GapSpec> gaps;         ///< one between each pair of neighbours
  std::vector<LinkSpec> links = {};  ///< in any order
  ExcitationSpec excitation;
  InitialSpec initial;
  AnalysisSpec analysis;
  CodeSpec code = {};  ///< without rules: none were given
  ScreeningSpec screening = {};
  std::optional<ProjectSpec> project = {};
  std::optional<CaseSource> source = {};  ///< nothing: it was read from no file
  /// What was read (io/toml), for reports; null of a case that was put together otherwise.
  std::shared_ptr<const TomlValue> given = {};
};

/// Mass, stiffness and load of one building on a fixed base, condensed and calibrated.
[[nodiscard]] StructuralModel structural_model(const BuildingSpec& spec);

/// The building with its modes, damping and storeys that yield.
/// @throws InvalidParameter when a value is out of its range, or damping is to follow the stiffness but has no such
/// part, or one below zero.
[[nodiscard]] Building make_building(const BuildingSpec& spec);
/// The same with its structural_model() made already.
[[nodiscard]] Building make_building(const BuildingSpec& spec, StructuralModel model);

/// A building as given and as assembled.
struct SpecAndModel {
  const BuildingSpec& spec;
  const StructuralModel& model;
};

/// Per contact point of the gap between two buildings the two floors that meet, or a floor and the node in a column
/// that it strikes. @throws InvalidParameter where there are none.
[[nodiscard]] std::vector<LevelPair> floors_of_points(const GapSpec& gap, const SpecAndModel& left,
                                                      const SpecAndModel& right);
/// Shear that a struck column bears [force], by column_capacity or its section, 0: unknown. @throws where they differ.
[[nodiscard]] double column_shear_capacity(const GapSpec& gap, std::size_t point, const SpecAndModel& left,
                                           const SpecAndModel& right, const LevelPair& floors);
/// The law of contact point `point`: with the numbers of that point, the axial stiffness of the two beams that meet
/// there, and m_e of its two floors, those of floors_of_points().
/// @throws InvalidParameter, naming the key at fault, when the case has no such law or its values do not go together.
[[nodiscard]] std::shared_ptr<const ContactLaw> make_contact_law(const GapSpec& gap, std::size_t point,
                                                                 const SpecAndModel& left, const SpecAndModel& right,
                                                                 const LevelPair& floors);

/// The problem a solver takes. @throws InvalidParameter when the case is not consistent, or has a spectrum, which has
/// no course in time, or a suite of records, of which case_of_record() takes one.
[[nodiscard]] Problem make_problem(const Case& c);
/// The same for what nothing is solved of: modes, gaps by a spectrum. A spectrum's problem has no motion.
[[nodiscard]] Problem make_still_problem(const Case& c);
[[nodiscard]] Problem make_still_problem(const Case& c, std::vector<Building> buildings);
/// Where one run is asked for: whether the case has no motion for it, a spectrum or many of a suite; says at its place
/// what to do.
[[nodiscard]] bool refuse_without_motion(const Case& c, Diagnostics& diagnostics);
/// Whether it has one of these two.
[[nodiscard]] bool is_without_motion(const Case& c);
/// The same with the case's buildings made already.
[[nodiscard]] Problem make_problem(const Case& c, std::vector<Building> buildings);

/// The contact points of all gaps, left to right and from the lowest up. @throws InvalidParameter as make_problem().
[[nodiscard]] std::vector<ContactPoint> contact_points(const Case& c, const std::vector<Building>& buildings);

/// Every floor that faces its neighbour between that one's base and top and has no contact point there, with widths as
/// watched_width() gives; two that are at one level are watched as one, against each other.
[[nodiscard]] std::vector<WatchedFloor> watched_floors(const Case& c, const std::vector<Building>& buildings,
                                                       const std::vector<ContactPoint>& points);

/// The width of gap `gap` at an elevation [length]: the smaller one of the contact points next above and next below, so
/// that no opening is taken for wider than it is; of the nearest point beyond them. Nothing where the gap has none.
[[nodiscard]] std::optional<double> watched_width(const std::vector<ContactPoint>& points, Eigen::Index gap,
                                                  double elevation);

/// What the case lets each response take.
[[nodiscard]] RunLimits run_limits(const AnalysisSpec& analysis);
/// What a single run of a case is asked for: levels, both ways round and the energy audit as the case says, its limits;
/// no histories.
[[nodiscard]] SolveOptions solve_options(const Case& c);
[[nodiscard]] SolveOptions solve_options(const AnalysisSpec& analysis);

/// Floor levels of a model.
[[nodiscard]] FloorLevels levels_of(const StructuralModel& model);

}  // namespace bentur
