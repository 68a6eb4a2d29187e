#include "bentur/structure/frame/plane_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/structure/frame/condensation.h"
#include "bentur/structure/frame/element_stiffness.h"
#include "bentur/structure/frame/frame_dofs.h"
#include "bentur/structure/frame/frame_hinges.h"
#include "bentur/structure/frame/infill.h"

namespace bentur {
namespace {

constexpr Eigen::Index fixed = FrameDofs::fixed;

// Element consistent mass (2-50) of a member of the given whole mass.
Eigen::Matrix4d element_mass(double mass, double length) {
  const double l = length;
  Eigen::Matrix4d m;
  m << 156, 22 * l, 54, -13 * l,              //
      22 * l, 4 * l * l, 13 * l, -3 * l * l,  //
      54, 13 * l, 156, -22 * l,               //
      -13 * l, -3 * l * l, -22 * l, 4 * l * l;
  return mass / 420 * m;
}

void add(Eigen::MatrixXd& matrix, const Eigen::Matrix4d& element, const ElementDofs& dofs) {
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      const Eigen::Index row = dofs[i];
      const Eigen::Index column = dofs[j];
      if (row != fixed && column != fixed) matrix(row, column) += element(i, j);
    }
  }
}

/// `most`: entries that a list of capacities may have.
void check_sections(const std::string& name, const std::vector<Section>& sections, std::size_t expected,
                    std::size_t most) {
  require_size(name, sections.size(), expected);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    require_positive(indexed(name, i) + ".area", sections[i].area);
    require_positive(indexed(name, i) + ".inertia", sections[i].inertia);
    require_not_negative(indexed(name, i) + ".mass", sections[i].mass);
    require_not_negative(indexed(name, i) + ".line_mass", sections[i].line_mass);
    const std::vector<double>& capacity = sections[i].moment_capacity;
    const std::string of_capacity = indexed(name, i) + ".moment_capacity";
    if (capacity.size() > 1) require_size(of_capacity, capacity.size(), most);
    for (std::size_t n = 0; n < capacity.size(); ++n) {
      if (capacity[n] > 0) continue;  // may be never_yields
      throw InvalidParameter(indexed(of_capacity, n), fmt::format("{}", capacity[n]), "must be > 0");
    }
    const double hardening = sections[i].hardening;
    if (!(hardening >= 0 && hardening < 1)) {
      throw InvalidParameter(indexed(name, i) + ".hardening", fmt::format("{}", hardening), "must be in [0, 1)");
    }
    require_not_negative(indexed(name, i) + ".line_load", sections[i].line_load);
    const std::vector<double>& shear = sections[i].shear_capacity;
    const std::string of_shear = indexed(name, i) + ".shear_capacity";
    if (shear.size() > 1) require_size(of_shear, shear.size(), most);
    for (std::size_t n = 0; n < shear.size(); ++n) {
      if (!(shear[n] > 0)) throw InvalidParameter(indexed(of_shear, n), fmt::format("{}", shear[n]), "must be > 0");
    }
    const double residual = sections[i].residual_shear;
    if (!(residual >= 0 && residual < 1)) {
      throw InvalidParameter(indexed(name, i) + ".residual_shear", fmt::format("{}", residual), "must be in [0, 1)");
    }
  }
}

void check(const PlaneFrame& frame, double base_elevation) {
  const std::size_t floors = frame.storey_heights.size();
  if (floors == 0) throw InvalidParameter("storey_heights", "an empty list", "must have at least one entry");
  if (frame.bay_widths.empty()) throw InvalidParameter("bay_widths", "an empty list", "must have at least one entry");
  require_positive("elastic_modulus", frame.elastic_modulus);
  require_finite("base_elevation", base_elevation);
  for (std::size_t i = 0; i < floors; ++i) {
    require_positive(indexed("storey_heights", i), frame.storey_heights[i]);
  }
  for (std::size_t i = 0; i < frame.bay_widths.size(); ++i) {
    require_positive(indexed("bay_widths", i), frame.bay_widths[i]);
  }
  check_sections("columns", frame.columns, floors, frame.bay_widths.size() + 1);
  check_sections("beams", frame.beams, floors, 2);
  if (!frame.floor_masses.empty()) require_size("floor_masses", frame.floor_masses.size(), floors);
  for (std::size_t i = 0; i < frame.floor_masses.size(); ++i) {
    require_not_negative(indexed("floor_masses", i), frame.floor_masses[i]);
  }
}

}  // namespace

namespace {

constexpr double never_yields = std::numeric_limits<double>::infinity();

/// The shears and moments at the ends of the pieces below and above a node, as they are needed there.
struct Piece {
  ElementDofs dofs;
  Eigen::Matrix4d stiffness;
  Eigen::Index number = 0;  ///< among those that may have hinges
};

/// An end of a column or a beam of this section. H = r/(1 − r) 6EI/L of the whole member (H-3).
FrameHinges::End end_of(const PlaneFrame& frame, const Section& section, double length, const HingePlace& place,
                        Eigen::Index joint) {
  const std::vector<double>& capacity = section.moment_capacity;
  FrameHinges::End end{
      .place = place, .rotation_limits = section.rotation_limits, .backbone = section.backbone, .joint = joint};
  end.clockwise = never_yields;
  if (!capacity.empty()) end.clockwise = capacity.front();
  if (capacity.size() > 1 && place.of_beam) {
    const bool left = place.end == HingePlace::End::left;
    end.clockwise = capacity[left ? 0 : 1];
    end.anticlockwise = capacity[left ? 1 : 0];
  } else if (capacity.size() > 1) {
    end.clockwise = capacity[place.number - 1];
  }
  if (!(capacity.size() > 1 && place.of_beam)) end.anticlockwise = end.clockwise;
  end.hardening = section.hardening / (1 - section.hardening) * 6 * frame.elastic_modulus * section.inertia / length;
  return end;
}

void add_row(Eigen::MatrixXd& rows, Eigen::Index row, const Piece& piece, Eigen::Index force) {
  for (Eigen::Index j = 0; j < 4; ++j) {
    if (piece.dofs[j] != fixed) rows(row, piece.dofs[j]) += piece.stiffness(force, j);
  }
}

}  // namespace

StructuralModel assemble_plane_frame(const PlaneFrame& frame, double base_elevation) {
  check(frame, base_elevation);
  const FrameDofs freedoms(frame);
  const auto [floors, lines, nodes] = freedoms;
  const Eigen::Index sways = freedoms.sways(), dofs = freedoms.count();
  const bool consistent = frame.mass_matrix == MassMatrix::consistent;
  FrameHinges hinges;

  StructuralModel model;
  model.storey_heights = frame.storey_heights;
  model.elevations = floor_elevations(frame.storey_heights, base_elevation);
  const std::vector<double> levels = floor_elevations(frame.storey_heights);  // above the base
  model.stiffness = Eigen::MatrixXd::Zero(dofs, dofs);
  model.mass = Eigen::MatrixXd::Zero(dofs, dofs);
  model.floor_masses.assign(frame.storey_heights.size(), 0.0);   // half of the columns that meet there, and `moving`
  std::vector<double> moving(frame.storey_heights.size(), 0.0);  // beams and floor_masses of each floor [mass]
  Eigen::VectorXd base_coupling = Eigen::VectorXd::Zero(dofs);   // m_g [mass]
  StructuralModel::RigidBody& body = model.rigid_body;
  model.node_masses.assign(frame.nodes.size(), 0.0);
  for (const ColumnNode& node : frame.nodes) model.node_elevations.push_back(base_elevation + node.elevation);
  if (nodes > 0) model.column_forces = Eigen::MatrixXd::Zero(6 * nodes, dofs);

  std::vector<char> placed(frame.nodes.size(), 0);
  for (Eigen::Index floor = 0; floor < floors; ++floor) {
    const Section& column = frame.columns[floor];
    const double height = frame.storey_heights[floor];
    for (Eigen::Index line = 0; line < lines; ++line) {
      const std::vector<ColumnEnd> ends = ends_of_column(frame, freedoms, floor, line);
      std::vector<Piece> pieces;
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const ColumnEnd& bottom = ends[i];
        const ColumnEnd& top = ends[i + 1];
        const double length = ends.size() == 2 ? height : top.elevation - bottom.elevation;
        const double mass = ends.size() == 2 ? column.mass_of(height) : column.mass_of(height) * length / height;
        const ElementDofs of = {bottom.sway, bottom.rotation, top.sway, top.rotation};
        pieces.push_back({of, element_stiffness(frame.elastic_modulus * column.inertia, length)});
        add(model.stiffness, pieces.back().stiffness, of);
        // A struck node is one hinge, at the upper end of the piece below: the piece above begins rigidly.
        const bool ends_at_joint = i + 2 == ends.size();
        HingePlace place{.of_beam = false, .level = floor + 1, .number = line + 1, .end = HingePlace::End::bottom};
        std::optional<FrameHinges::End> lower;
        if (i == 0) lower = end_of(frame, column, height, place, bottom.rotation);
        place.end = ends_at_joint ? HingePlace::End::top : HingePlace::End::node;
        pieces.back().number = hinges.add(of, pieces.back().stiffness, lower,
                                          end_of(frame, column, height, place, ends_at_joint ? top.rotation : fixed));
        const double capacity = column.shear_capacity_of(line);
        if (std::isfinite(capacity)) {
          const Eigen::Index piece = ends.size() == 2 ? 0 : static_cast<Eigen::Index>(i) + 1;
          hinges.add_shear(pieces.back().number, {floor + 1, line + 1, piece, capacity}, column.residual_shear);
        }
        const bool at_base = floor == 0 && i == 0;
        const Eigen::Matrix4d inertia = element_mass(mass, length);
        if (consistent) {
          add(model.mass, inertia, of);
          if (at_base) {  // forces at the upper end for a unit acceleration of the lower one: column 1 of (2-50)
            base_coupling(of[2]) += inertia(2, 0);
            base_coupling(of[3]) += inertia(3, 0);
          }
        }
        if (at_base) {
          body.mass += consistent ? inertia(0, 0) : mass / 2;
          body.foot_mass += mass / 2;
        }
        for (const ColumnEnd* end : {&bottom, &top}) {
          if (end->node >= 0) {
            model.node_masses[end->node] += mass / 2;
          } else if (end->sway != fixed) {
            model.floor_masses[end->sway] += mass / 2;
          }
        }
      }
      for (std::size_t i = 1; i + 1 < ends.size(); ++i) {
        const Eigen::Index node = ends[i].node;
        placed[node] = 1;
        const Piece& below = pieces[i - 1];
        const Piece& above = pieces[i];
        // Shears below and above; moments at the bottom, at the node from below and from above, at the top.
        const std::pair<const Piece*, Eigen::Index> ends_of_pieces[] = {{&below, 2}, {&above, 0}, {&below, 1},
                                                                        {&below, 3}, {&above, 1}, {&above, 3}};
        Eigen::Index row = 6 * node;
        for (const auto& [piece, force] : ends_of_pieces) {
          hinges.add_column_force(row, piece->number, force);
          add_row(model.column_forces, row++, *piece, force);
        }
      }
    }
    const Section& beam = frame.beams[floor];
    for (Eigen::Index bay = 0; bay + 1 < lines; ++bay) {
      const double width = frame.bay_widths[bay];
      const ElementDofs ends = {fixed, freedoms.rotation(floor, bay), fixed, freedoms.rotation(floor, bay + 1)};
      const Eigen::Matrix4d stiffness = element_stiffness(frame.elastic_modulus * beam.inertia, width);
      add(model.stiffness, stiffness, ends);
      HingePlace place{.of_beam = true, .level = floor + 1, .number = bay + 1, .end = HingePlace::End::left};
      const FrameHinges::End left = end_of(frame, beam, width, place, ends[1]);
      place.end = HingePlace::End::right;
      hinges.add(ends, stiffness, left, end_of(frame, beam, width, place, ends[3]));
      const double fixed_end_moment = beam.line_load * width * width / 12;
      hinges.add_fixed_end_moments(-fixed_end_moment, fixed_end_moment);
      if (consistent) add(model.mass, element_mass(beam.mass_of(width), width), ends);
      moving[floor] += beam.mass_of(width);  // it moves bodily with its floor
    }
    if (!frame.floor_masses.empty()) moving[floor] += frame.floor_masses[floor];
  }
  for (Eigen::Index n = 0; n < nodes; ++n) {
    if (placed[n] != 0) continue;
    throw InvalidParameter(
        indexed("nodes", n), fmt::format("{}", frame.nodes[n].elevation),
        "must be between two floors, 1 % of the storey height or more from both: where it is nearer, "
        "the floor itself is what is struck");
  }
  for (Eigen::Index i = 0; i < floors; ++i) {
    model.floor_masses[i] += moving[i];
    if (!(model.floor_masses[i] > 0)) {
      throw InvalidParameter(indexed("floor_masses", i), "0", "must be > 0 where columns and beams have no mass");
    }
    model.mass(i, i) += consistent ? moving[i] : model.floor_masses[i];
  }
  for (Eigen::Index n = 0; n < nodes; ++n) {
    if (!(model.node_masses[n] > 0)) {
      throw InvalidParameter("columns", "no mass", "must have mass where a node is struck");
    }
    if (!consistent) model.mass(floors + n, floors + n) += model.node_masses[n];
  }

  model.hinges = hinges.hinges(model.stiffness);
  model.infills = infill_panels(frame);
  model.stiffness.topLeftCorner(floors, floors) += infill_stiffness(model.infills, floors);
  model.left_joints = model.right_joints = Eigen::MatrixXd::Zero(floors, dofs);
  for (Eigen::Index floor = 0; floor < floors; ++floor) {
    model.left_joints(floor, freedoms.rotation(floor, 0)) = 1;
    model.right_joints(floor, freedoms.rotation(floor, lines - 1)) = 1;
  }
  if (!model.stiffness.allFinite() || !model.mass.allFinite()) {
    throw InvalidParameter("elastic_modulus", fmt::format("{}", frame.elastic_modulus),
                           "must be one that numbers can hold together with these sections, lengths and masses");
  }
  Eigen::VectorXd ones = Eigen::VectorXd::Zero(dofs);
  ones.head(sways).setOnes();
  Eigen::VectorXd heights = Eigen::VectorXd::Zero(dofs);
  for (Eigen::Index f = 0; f < floors; ++f) heights(f) = levels[f];
  for (Eigen::Index n = 0; n < nodes; ++n) heights(floors + n) = frame.nodes[n].elevation;
  model.load = model.mass.leftCols(sways).rowwise().sum();  // M r
  if (frame.base_coupling) model.load += base_coupling;
  body.rocking = model.mass * heights;
  body.mass += ones.dot(model.mass.leftCols(sways).rowwise().sum()) + 2 * ones.dot(base_coupling);
  body.moment = heights.dot(model.load);
  body.inertia = heights.dot(body.rocking);
  return model;
}

namespace {

/// Reduced as its condensation says.
StructuralModel reduced(const PlaneFrame& frame, const StructuralModel& model) {
  const Eigen::Index sways = model.floors() + model.nodes();
  const Eigen::Index rotations = model.dofs() - sways;
  const bool massless = model.mass.bottomRightCorner(rotations, rotations).isZero(0);
  if (massless || frame.condensation == Condensation::static_) return condense_statically(model, sways);
  if (frame.condensation == Condensation::dynamic) {
    if (model.hinges.size() > 0) {
      throw InvalidParameter("condensation", "\"dynamic\"",
                             "must be \"static\" or \"none\" where hinges may form or columns break");
    }
    return condense_dynamically(model, sways);
  }
  if (!is_positive_definite(model.mass)) {
    throw InvalidParameter("condensation", "none", "needs a column or beam with mass at every floor");
  }
  return model;
}

}  // namespace

StructuralModel plane_frame_model(const PlaneFrame& frame, double base_elevation) {
  StructuralModel model = reduced(frame, assemble_plane_frame(frame, base_elevation));
  if (model.hinges.size() > 0) {
    model.hinges.frame_stiffness = model.stiffness;
    const Eigen::Index floors = model.floors();
    model.hinges.frame_stiffness.topLeftCorner(floors, floors) -= infill_stiffness(model.infills, floors);
    model.hinges.frame_rows = model.hinges.rows;
    model.hinges.frame_drifts = drift_rows(model);
    check_backbones(model.hinges);
  }
  return model;
}

}  // namespace bentur
