#include "bentur/structure/frame/storey_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/structure/frame/element_stiffness.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double least_part = 0.01;  // of the storey height, between nodes and floors

double entry_of(const std::vector<double>& list, Index storey) {
  return list[list.size() == 1 ? 0 : static_cast<std::size_t>(storey)];
}

/// The columns of one side in one storey, in pieces. Sways: of the floor below, of the nodes from below, of the floor
/// above.
struct Pieces {
  std::vector<Index> nodes;     ///< in the order of StoreyColumns::nodes, from below
  std::vector<double> lengths;  ///< one more than nodes
  double rigidity = 0;          ///< E I of all columns side by side
  MatrixXd stiffness;           ///< over the sways, rotations of the nodes condensed
  MatrixXd forces;              ///< per piece four at its ends (sway and moment below, above), over the sways
};

void condense(Pieces& pieces) {
  const Index sways = std::ssize(pieces.nodes) + 2, rotations = std::ssize(pieces.nodes);
  // Sways, then rotations of the nodes; floors do not turn.
  const auto rotation = [&](Index end) { return end == 0 || end == sways - 1 ? -1 : sways + end - 1; };
  MatrixXd k = MatrixXd::Zero(sways + rotations, sways + rotations);
  MatrixXd ends = MatrixXd::Zero(4 * (sways - 1), sways + rotations);
  for (Index piece = 0; piece + 1 < sways; ++piece) {
    const Eigen::Matrix4d of = element_stiffness(pieces.rigidity, pieces.lengths[static_cast<std::size_t>(piece)]);
    const std::array<Index, 4> dofs = {piece, rotation(piece), piece + 1, rotation(piece + 1)};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        if (dofs[j] < 0) continue;
        ends(4 * piece + i, dofs[j]) += of(i, j);
        if (dofs[i] >= 0) k(dofs[i], dofs[j]) += of(i, j);
      }
    }
  }
  const MatrixXd turned =
      -Cholesky(k.bottomRightCorner(rotations, rotations)).solve(k.bottomLeftCorner(rotations, sways));
  pieces.stiffness = k.topLeftCorner(sways, sways) + k.topRightCorner(sways, rotations) * turned;
  pieces.forces = ends.leftCols(sways) + ends.rightCols(rotations) * turned;
}

/// The nodes of a storey and side, checked and sorted; nothing where there are none.
Pieces pieces_of(const StructuralModel& model, const StoreyColumns& columns, Index storey, bool left) {
  const double height = model.storey_heights[static_cast<std::size_t>(storey)];
  const double above =
      model.elevations[static_cast<std::size_t>(storey)] - model.elevations.front() + model.storey_heights.front();
  const double below = above - height;
  Pieces pieces;
  for (Index n = 0; n < std::ssize(columns.nodes); ++n) {
    const ColumnNode& node = columns.nodes[static_cast<std::size_t>(n)];
    if (node.left == left && node.elevation > below && node.elevation < above) pieces.nodes.push_back(n);
  }
  const auto at = [&](Index n) { return columns.nodes[static_cast<std::size_t>(n)].elevation; };
  std::sort(pieces.nodes.begin(), pieces.nodes.end(), [&](Index a, Index b) { return at(a) < at(b); });
  double last = below;
  for (const Index n : pieces.nodes) {
    pieces.lengths.push_back(at(n) - last);
    last = at(n);
  }
  pieces.lengths.push_back(above - last);
  for (std::size_t i = 0; i < pieces.nodes.size(); ++i) {
    if (std::min(pieces.lengths[i], pieces.lengths[i + 1]) > least_part * height) continue;
    throw InvalidParameter(indexed("columns.nodes", static_cast<std::size_t>(pieces.nodes[i])),
                           fmt::format("{}", at(pieces.nodes[i])),
                           "must be 1 % of the storey height or more from floors and other nodes");
  }
  pieces.rigidity = columns.elastic_modulus * entry_of(columns.inertia, storey) * columns.number;
  return pieces;
}

void check(const StructuralModel& model, const StoreyColumns& columns) {
  const auto floors = static_cast<std::size_t>(model.floors());
  require_positive("columns.elastic_modulus", columns.elastic_modulus);
  if (columns.number < 1)
    throw InvalidParameter("columns.number", fmt::format("{}", columns.number), "must be 1 or more");
  for (const auto& [name, list] :
       {std::pair("columns.inertia", &columns.inertia), std::pair("columns.mass", &columns.mass)}) {
    if (list->size() != 1) require_size(name, list->size(), floors);
    for (std::size_t i = 0; i < list->size(); ++i) require_positive(indexed(name, i), (*list)[i]);
  }
  const MatrixXd shears = shear_rows(model);
  for (Index storey = 0; storey < model.floors(); ++storey) {
    VectorXd drift = VectorXd::Zero(model.dofs());
    drift.segment(storey, model.floors() - storey).setOnes();
    const double height = model.storey_heights[static_cast<std::size_t>(storey)];
    const double whole =
        12 * columns.elastic_modulus * entry_of(columns.inertia, storey) * columns.number / (height * height * height);
    const double all = shears.row(storey).dot(drift);
    constexpr double round_off = 1e-9;
    if (whole > all * (1 + round_off)) {
      throw InvalidParameter("columns.inertia", fmt::format("{}", entry_of(columns.inertia, storey)),
                             fmt::format("must leave the columns' 12 E I/h³, {:.4g}, within the {:.4g} that storey {} "
                                         "has in all",
                                         whole, all, storey + 1));
    }
  }
}

}  // namespace

void add_columns(StructuralModel& model, const StoreyColumns& columns) {
  check(model, columns);
  const Index floors = model.floors(), nodes = std::ssize(columns.nodes);
  if (nodes == 0) return;
  const Index dofs = floors + nodes;
  MatrixXd stiffness = MatrixXd::Zero(dofs, dofs), forces = MatrixXd::Zero(6 * nodes, dofs);
  stiffness.topLeftCorner(floors, floors) = model.stiffness;
  VectorXd mass = VectorXd::Zero(dofs);
  Index placed = 0;
  for (Index storey = 0; storey < floors; ++storey) {
    for (const bool left : {true, false}) {
      Pieces pieces = pieces_of(model, columns, storey, left);
      if (pieces.nodes.empty()) continue;
      placed += std::ssize(pieces.nodes);
      condense(pieces);
      const double height = model.storey_heights[static_cast<std::size_t>(storey)];
      // What the pieces take beyond the whole columns.
      VectorXd drift = VectorXd::Zero(pieces.stiffness.rows());
      drift(0) = -1;
      drift(drift.size() - 1) = 1;
      const MatrixXd more =
          pieces.stiffness - 12 * pieces.rigidity / (height * height * height) * drift * drift.transpose();
      std::vector<Index> at = {storey - 1};
      for (const Index node : pieces.nodes) at.push_back(floors + node);
      at.push_back(storey);
      const auto put = [&](const auto& rows, Index row, MatrixXd& into, Index to) {
        for (std::size_t j = 0; j < at.size(); ++j) {
          if (at[j] >= 0) into(to, at[j]) += rows(row, static_cast<Index>(j));
        }
      };
      const double line = columns.number * entry_of(columns.mass, storey) / height;  // mass over length
      for (std::size_t i = 0; i < at.size(); ++i) {
        if (at[i] >= 0) put(more, static_cast<Index>(i), stiffness, at[i]);
        const double own = i == 0               ? pieces.lengths.front()
                           : i + 1 == at.size() ? pieces.lengths.back()
                                                : pieces.lengths[i - 1] + pieces.lengths[i];
        const bool is_floor = i == 0 || i + 1 == at.size();
        if (at[i] >= 0) mass(at[i]) += line / 2 * (own - (is_floor ? height : 0));
      }
      for (std::size_t i = 0; i < pieces.nodes.size(); ++i) {
        const Index below = 4 * static_cast<Index>(i), above = below + 4;
        // Shears below and above; moments at the bottom, at the node from below and from above, at the top.
        const std::array<Index, 6> ends = {below + 2, above, below + 1, below + 3, above + 1, above + 3};
        for (std::size_t k = 0; k < ends.size(); ++k) {
          put(pieces.forces, ends[k], forces, 6 * pieces.nodes[i] + static_cast<Index>(k));
        }
      }
    }
  }
  if (placed < nodes) {
    throw InvalidParameter("columns.nodes", "outside", "must be between the base and the top floor, at no floor");
  }
  model.node_elevations.clear();
  for (const ColumnNode& node : columns.nodes) {
    model.node_elevations.push_back(model.elevations.front() - model.storey_heights.front() + node.elevation);
  }
  model.node_masses.assign(mass.begin() + floors, mass.end());
  mass.head(floors) += model.load;
  for (Index f = 0; f < floors; ++f) {
    if (mass(f) > 0) continue;
    throw InvalidParameter("columns.mass", fmt::format("{}", entry_of(columns.mass, f)),
                           fmt::format("must be part of the mass of floor {}, {}", f + 1, model.load(f)));
  }
  model.mass = mass.asDiagonal();
  model.load = mass;
  model.stiffness = std::move(stiffness);
  model.column_forces = std::move(forces);
}

}  // namespace bentur
