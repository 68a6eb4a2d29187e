#include "bentur/structure/frame/member_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/not_known.h"
#include "bentur/structure/frame/element_stiffness.h"
#include "bentur/structure/frame/frame_dofs.h"
#include "bentur/structure/frame/frame_hinges.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// A member with its freedoms and, at either end, the number of its hinge; −1: none.
struct MemberPiece {
  FrameMember member;
  ElementDofs dofs;
  Eigen::Matrix4d stiffness;
  std::array<Index, 2> hinges{-1, -1};
};

Index hinge_at(const std::vector<HingePlace>& hinges, const FrameMember& member, HingePlace::End end) {
  const auto found = std::find_if(hinges.begin(), hinges.end(), [&](const HingePlace& place) {
    return place.of_beam == member.of_beam && place.level == member.level && place.number == member.number &&
           place.end == end;
  });
  return found == hinges.end() ? -1 : found - hinges.begin();
}

std::vector<MemberPiece> pieces_of(const PlaneFrame& frame, const FrameDofs& dofs,
                                   const std::vector<HingePlace>& hinges) {
  std::vector<double> lines = {0};
  for (const double bay : frame.bay_widths) lines.push_back(lines.back() + bay);
  std::vector<MemberPiece> pieces;
  for (Index floor = 0; floor < dofs.floors; ++floor) {
    for (Index line = 0; line < dofs.lines; ++line) {
      const std::vector<ColumnEnd> ends = ends_of_column(frame, dofs, floor, line);
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const ColumnEnd &bottom = ends[i], &top = ends[i + 1];
        MemberPiece piece{.member = {false, floor + 1, line + 1, bottom.elevation, top.elevation, lines[line]},
                          .dofs = {bottom.sway, bottom.rotation, top.sway, top.rotation},
                          .stiffness = element_stiffness(frame.elastic_modulus * frame.columns[floor].inertia,
                                                         top.elevation - bottom.elevation)};
        if (bottom.node < 0) piece.hinges[0] = hinge_at(hinges, piece.member, HingePlace::End::bottom);
        piece.hinges[1] = hinge_at(hinges, piece.member, top.node < 0 ? HingePlace::End::top : HingePlace::End::node);
        pieces.push_back(piece);
      }
    }
  }
  const std::vector<double> levels = floor_elevations(frame.storey_heights);
  for (Index floor = 0; floor < dofs.floors; ++floor) {
    for (Index bay = 0; bay + 1 < dofs.lines; ++bay) {
      MemberPiece piece{
          .member = {true, floor + 1, bay + 1, lines[bay], lines[bay + 1], levels[floor]},
          .dofs = {FrameDofs::fixed, dofs.rotation(floor, bay), FrameDofs::fixed, dofs.rotation(floor, bay + 1)},
          .stiffness = element_stiffness(frame.elastic_modulus * frame.beams[floor].inertia, frame.bay_widths[bay])};
      piece.hinges = {hinge_at(hinges, piece.member, HingePlace::End::left),
                      hinge_at(hinges, piece.member, HingePlace::End::right)};
      pieces.push_back(piece);
    }
  }
  return pieces;
}

}  // namespace

bool MemberForces::knows(const PlaneFrame& frame, const std::vector<HingePlace>& hinges) {
  if (frame.mass_matrix != MassMatrix::lumped && frame.condensation != Condensation::static_) return false;
  std::set<std::tuple<Index, Index>> nodes;
  return std::all_of(hinges.begin(), hinges.end(), [&](const HingePlace& place) {
    return place.end != HingePlace::End::node || nodes.emplace(place.level, place.number).second;
  });
}

MatrixXd MemberForces::Rows::operator()(const MatrixXd& sways, const MatrixXd& turned) const {
  MatrixXd forces = of_sways * sways;
  if (of_hinges.cols() > 0) forces += of_hinges * turned;
  return forces;
}

MemberForces::MemberForces(const PlaneFrame& frame, const std::vector<HingePlace>& hinges) {
  const FrameDofs dofs(frame);
  const std::vector<MemberPiece> pieces = pieces_of(frame, dofs, hinges);
  const Index sways = dofs.sways(), all = dofs.count(), turns = std::ssize(hinges), count = std::ssize(pieces);
  // Over all freedoms and the turns of hinges: what acts on freedoms, and on the ends of members.
  MatrixXd on_dofs = MatrixXd::Zero(all, all + turns), on_ends = MatrixXd::Zero(4 * count, all + turns);
  for (Index n = 0; n < count; ++n) {
    const MemberPiece& piece = pieces[n];
    members_.push_back(piece.member);
    MatrixXd ends = MatrixXd::Zero(4, all + turns);
    for (Index j = 0; j < 4; ++j) {
      if (piece.dofs[j] != FrameDofs::fixed) ends.col(piece.dofs[j]) += piece.stiffness.col(j);
    }
    for (Index end = 0; end < 2; ++end) {  // it turns less than its joint
      if (piece.hinges[end] >= 0) ends.col(all + piece.hinges[end]) -= piece.stiffness.col(2 * end + 1);
    }
    on_ends.middleRows(4 * n, 4) = ends;
    for (Index i = 0; i < 4; ++i) {
      if (piece.dofs[i] != FrameDofs::fixed) on_dofs.row(piece.dofs[i]) += ends.row(i);
    }
  }
  // Rotations by the balance of moments on joints.
  const Index rotations = all - sways;
  const MatrixXd of_rotations = on_dofs.block(sways, sways, rotations, rotations);
  MatrixXd of_known(rotations, sways + turns);
  of_known << on_dofs.block(sways, 0, rotations, sways), on_dofs.block(sways, all, rotations, turns);
  const MatrixXd rotated = Ldlt(of_rotations).solve(of_known);
  MatrixXd known(4 * count, sways + turns);
  known << on_ends.leftCols(sways), on_ends.rightCols(turns);
  const MatrixXd ends = known - on_ends.middleCols(sways, rotations) * rotated;

  const auto columns = std::count_if(members_.begin(), members_.end(), [](const auto& one) { return !one.of_beam; });
  MatrixXd turning(2 * count, ends.cols()), axial = MatrixXd::Zero(columns, ends.cols());
  for (Index n = 0; n < count; ++n) {
    turning.middleRows(2 * n, 2) << ends.row(4 * n + 1), ends.row(4 * n + 3);
    const FrameMember& beam = members_[n];
    if (!beam.of_beam) continue;
    const Eigen::RowVectorXd lifts = (ends.row(4 * n + 1) + ends.row(4 * n + 3)) / beam.length();
    for (Index m = 0; m < columns; ++m) {
      if (beam.level < members_[m].level) continue;
      if (beam.number == members_[m].number) axial.row(m) -= lifts;
      if (beam.number + 1 == members_[m].number) axial.row(m) += lifts;
    }
  }
  for (const auto& [rows, to] : {std::pair(&turning, &ends_), {&axial, &axial_}}) {
    to->of_sways = rows->leftCols(sways);
    to->of_hinges = rows->rightCols(turns);
  }
}

MemberForces::Forces MemberForces::forces(const MatrixXd& sways, const MatrixXd& turned) const {
  constexpr Index places = std::size(stations);
  const Index count = std::ssize(members_), instants = sways.cols();
  const MatrixXd ends = ends_(sways, turned);
  Forces found{MatrixXd(places * count, instants), MatrixXd(count, instants),
               MatrixXd::Constant(count, instants, not_known)};
  for (Index t = 0; t < instants; ++t) {
    for (Index n = 0; n < count; ++n) {
      const double first = ends(2 * n, t), second = ends(2 * n + 1, t);
      for (Index k = 0; k < places; ++k) {
        found.moments(places * n + k, t) = (1 - stations[k]) * first - stations[k] * second;
      }
      found.shears(n, t) = (members_[n].of_beam ? 1 : -1) / members_[n].length() * (first + second);
    }
  }
  found.axial.topRows(axial_.of_sways.rows()) = axial_(sways, turned);
  return found;
}

}  // namespace bentur
