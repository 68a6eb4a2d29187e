#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bentur/model/case_spec.h"
#include "bentur/pounding/problem.h"
#include "bentur/structure/support.h"

namespace bentur {

/// Where columns of a building are struck; null: it has no columns that are known.
[[nodiscard]] const std::vector<ColumnNode>* column_nodes(const BuildingSpec& spec);
[[nodiscard]] std::vector<ColumnNode>* column_nodes(BuildingSpec& spec);
[[nodiscard]] bool has_column_nodes(const BuildingSpec& spec);

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
/// Shear that a struck column carries [force]: what column_capacity has for the point or level, or `of_section` of its
/// storey, infinite where that has none; 0: unknown. @throws where they differ.
[[nodiscard]] double column_shear_capacity(const GapSpec& gap, std::size_t point, double of_section, std::size_t storey,
                                           const std::string& building);
/// The same of a building in a row.
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
/// What a single run of a case is asked for: levels, both directions and the energy audit as the case says, its limits;
/// no histories.
[[nodiscard]] SolveOptions solve_options(const Case& c);
[[nodiscard]] SolveOptions solve_options(const AnalysisSpec& analysis);

/// Floor levels of a model.
[[nodiscard]] FloorLevels levels_of(const StructuralModel& model);

}  // namespace bentur
