#pragma once

#include "bentur/core/key.h"

// Every key of a case, table by table, in the order in which documents and messages name them. What a key is, which
// values it takes and what is without it is said here and nowhere else; what several keys must be together is said by
// their readers (io/case).
namespace bentur {

[[nodiscard]] const KeyTable& case_keys();  ///< the whole file
[[nodiscard]] const KeyTable& unit_keys();

// keys_of_building.cpp
[[nodiscard]] const KeyTable& building_keys();
[[nodiscard]] const KeyTable& damping_keys();
[[nodiscard]] const KeyTable& rayleigh_keys();
[[nodiscard]] const KeyTable& frame_keys();
[[nodiscard]] const KeyTable& section_keys();
[[nodiscard]] const KeyTable& floor_load_keys();
[[nodiscard]] const KeyTable& stick_keys();
[[nodiscard]] const KeyTable& storey_columns_keys();
[[nodiscard]] const KeyTable& backbone_keys();
[[nodiscard]] const KeyTable& hinge_backbone_keys();
[[nodiscard]] const KeyTable& infill_keys();
[[nodiscard]] const KeyTable& backbone_side_keys();
[[nodiscard]] const KeyTable& matrices_keys();
[[nodiscard]] const KeyTable& modal_keys();
[[nodiscard]] const KeyTable& generic_keys();
[[nodiscard]] const KeyTable& displacements_keys();
[[nodiscard]] const KeyTable& period_formula_keys();

// keys_of_plan.cpp
[[nodiscard]] const KeyTable& plan_keys();
[[nodiscard]] const KeyTable& building_plan_keys();
[[nodiscard]] const KeyTable& court_keys();
[[nodiscard]] const KeyTable& wall_plan_keys();
[[nodiscard]] const KeyTable& plane_keys();
[[nodiscard]] const KeyTable& plane_frame_keys();
[[nodiscard]] const KeyTable& plane_section_keys();
[[nodiscard]] const KeyTable& rigidity_keys();

// keys_of_support.cpp
[[nodiscard]] const KeyTable& isolation_keys();
[[nodiscard]] const KeyTable& bearing_keys();
[[nodiscard]] const KeyTable& soil_keys();
[[nodiscard]] const KeyTable& sway_keys();
[[nodiscard]] const KeyTable& rocking_keys();
[[nodiscard]] const KeyTable& twist_keys();
[[nodiscard]] const KeyTable& half_space_keys();
[[nodiscard]] const KeyTable& foundation_keys();

// keys_of_gap.cpp
[[nodiscard]] const KeyTable& gap_keys();
[[nodiscard]] const KeyTable& column_capacity_keys();
[[nodiscard]] const KeyTable& contact_keys();
[[nodiscard]] const KeyTable& link_keys();

// keys_of_motion.cpp
[[nodiscard]] const KeyTable& excitation_keys();
[[nodiscard]] const KeyTable& motion_along_y_keys();
[[nodiscard]] const KeyTable& suite_file_keys();
[[nodiscard]] const KeyTable& suite_factor_keys();
[[nodiscard]] const KeyTable& target_keys();
[[nodiscard]] const KeyTable& initial_keys();
[[nodiscard]] const KeyTable& analysis_keys();
[[nodiscard]] const KeyTable& limit_keys();

// keys_of_code.cpp
[[nodiscard]] const KeyTable& code_keys();
[[nodiscard]] const KeyTable& screening_keys();

// keys_of_project.cpp
[[nodiscard]] const KeyTable& project_keys();

}  // namespace bentur
