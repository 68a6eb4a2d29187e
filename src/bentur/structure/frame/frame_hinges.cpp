#include "bentur/structure/frame/frame_hinges.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "bentur/core/errors.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool yields(const FrameHinges::End& end) { return std::isfinite(end.clockwise) || std::isfinite(end.anticlockwise); }

/// Where all ends of a joint are perfectly plastic, one that is as strong as all others together cannot be brought to
/// flow: their moments balance. One after the other, columns before beams, so that of equals the beam yields. (H-5)
void hold_ends_that_never_flow(std::vector<FrameHinges::End>& ends) {
  const auto at_joint_of = [&](const FrameHinges::End& end) {
    std::vector<FrameHinges::End*> all;
    for (FrameHinges::End& other : ends) {
      if (other.joint == end.joint) all.push_back(&other);
    }
    return all;
  };
  for (const bool beams : {false, true}) {
    for (FrameHinges::End& end : ends) {
      if (end.joint < 0 || end.place.of_beam != beams) continue;
      const auto joint = at_joint_of(end);
      const bool hardens = std::any_of(joint.begin(), joint.end(), [](const auto* of) { return of->hardening > 0; });
      if (hardens) continue;
      double clockwise = 0, anticlockwise = 0;  // of the others
      for (const FrameHinges::End* other : joint) {
        if (other == &end) continue;
        clockwise += other->clockwise;
        anticlockwise += other->anticlockwise;
      }
      if (end.clockwise >= anticlockwise) end.clockwise = infinite;
      if (end.anticlockwise >= clockwise) end.anticlockwise = infinite;
    }
  }
}

}  // namespace

std::string name_of(const HingePlace& place) {
  const std::string_view end = word_of(place.end);
  return place.of_beam ? fmt::format("{} end of the beam of bay {}, floor {}", end, place.number, place.level)
                       : fmt::format("{} of the column of line {}, storey {}", end, place.number, place.level);
}

Index FrameHinges::add(const ElementDofs& dofs, const Eigen::Matrix4d& stiffness, const std::optional<End>& first,
                       const std::optional<End>& second) {
  Piece piece{dofs, stiffness};
  for (const auto& [end, index] : {std::pair{&first, &piece.first}, std::pair{&second, &piece.second}}) {
    if (!*end) continue;
    *index = std::ssize(ends_);
    ends_.push_back(**end);
    fixed_end_moments_.push_back(0);
  }
  pieces_.push_back(piece);
  return std::ssize(pieces_) - 1;
}

void FrameHinges::add_column_force(Index row, Index piece, Index force) {
  column_forces_.push_back({row, piece, force});
}

void FrameHinges::add_fixed_end_moments(double first, double second) {
  fixed_end_moments_[pieces_.back().first] += first;
  fixed_end_moments_[pieces_.back().second] += second;
}

Hinges FrameHinges::hinges(const MatrixXd& stiffness) const {
  Hinges all;
  if (std::none_of(ends_.begin(), ends_.end(), yields)) return all;
  const Index count = std::ssize(ends_);
  all.rows = MatrixXd::Zero(count, stiffness.rows());
  all.stiffness = MatrixXd::Zero(count, count);
  for (const Piece& piece : pieces_) {
    for (const auto& [end, moment] : {std::pair{piece.first, 1}, std::pair{piece.second, 3}}) {
      if (end < 0) continue;
      for (Index j = 0; j < 4; ++j) {
        if (piece.dofs[j] >= 0) all.rows(end, piece.dofs[j]) += piece.stiffness(moment, j);
      }
      if (piece.first >= 0) all.stiffness(end, piece.first) += piece.stiffness(moment, 1);
      if (piece.second >= 0) all.stiffness(end, piece.second) += piece.stiffness(moment, 3);
    }
  }
  all.column_forces = MatrixXd::Zero(std::ssize(column_forces_), count);
  for (const ColumnForce& of : column_forces_) {
    const Piece& piece = pieces_[of.piece];
    if (piece.first >= 0) all.column_forces(of.row, piece.first) -= piece.stiffness(of.force, 1);
    if (piece.second >= 0) all.column_forces(of.row, piece.second) -= piece.stiffness(of.force, 3);
  }
  // M₀ = G u + M_F, K u = −(moments that fixed ends put on joints). (H-9)
  VectorXd at_rest = Eigen::Map<const VectorXd>(fixed_end_moments_.data(), count);
  if (!at_rest.isZero(0.0)) {
    VectorXd on_joints = VectorXd::Zero(stiffness.rows());
    for (Index end = 0; end < count; ++end) {
      if (ends_[end].joint >= 0) on_joints(ends_[end].joint) += at_rest(end);
    }
    at_rest -= all.rows * stiffness.llt().solve(on_joints);
  }
  std::vector<End> ends = ends_;
  hold_ends_that_never_flow(ends);
  std::vector<Index> kept;
  for (Index end = 0; end < count; ++end) {
    if (yields(ends_[end])) kept.push_back(end);
  }
  all.rows = all.rows(kept, Eigen::all).eval();
  all.stiffness = all.stiffness(kept, kept).eval();
  all.column_forces = all.column_forces(Eigen::all, kept).eval();
  all.at_rest = at_rest(kept);
  const Index hinges = std::ssize(kept);
  all.rotation_limits.setConstant(hinges, 3, std::numeric_limits<double>::quiet_NaN());
  for (VectorXd* list : {&all.hardening, &all.clockwise, &all.anticlockwise}) list->resize(hinges);
  Index worst = 0;
  double worst_share = 0;
  for (Index h = 0; h < hinges; ++h) {
    const End& end = ends[kept[h]];
    all.places.push_back(end.place);
    all.hardening(h) = end.hardening;
    for (std::size_t n = 0; n < end.rotation_limits.size(); ++n) {
      all.rotation_limits(h, static_cast<Index>(n)) = end.rotation_limits[n];
    }
    all.clockwise(h) = end.clockwise;
    all.anticlockwise(h) = end.anticlockwise;
    const double moment = all.at_rest(h);
    const double share = std::abs(moment) / (moment > 0 ? ends_[kept[h]].clockwise : ends_[kept[h]].anticlockwise);
    if (share > worst_share * (1 + 1e-9)) {  // of equals the first
      worst_share = share;
      worst = h;
    }
  }
  if (worst_share >= 1) {
    const double moment = std::abs(all.at_rest(worst));
    throw InvalidParameter("line_load", "loads on beams",
                           fmt::format("must not bring a member to yield by itself: {}, {:.4g} of {:.4g}",
                                       name_of(all.places[worst]), moment, moment / worst_share));
  }
  return all;
}

}  // namespace bentur
