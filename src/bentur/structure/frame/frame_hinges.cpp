#include "bentur/structure/frame/frame_hinges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double least_margin = 0.01;  // of its stiffness, that a member has to hold what loses strength by

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

/// "columns[0].backbone".
std::string place_of(const HingePlace& place) {
  return fmt::format("{}[{}].backbone", place.of_beam ? "beams" : "columns", place.level - 1);
}

}  // namespace

std::string name_of(const HingePlace& place) {
  const std::string_view end = word_of(place.end);
  return place.of_beam ? fmt::format("{} end of the beam of bay {}, floor {}", end, place.number, place.level)
                       : fmt::format("{} of the column of line {}, storey {}", end, place.number, place.level);
}

std::string name_of(const BreakingColumn& column) {
  const std::string whole = fmt::format("column of line {}, storey {}", column.line, column.storey);
  return column.piece == 0 ? whole : fmt::format("piece {} of the {}", column.piece, whole);
}

void check_backbones(const Hinges& hinges) {
  for (Index h = 0; h < std::ssize(hinges.places); ++h) {
    if (hinges.backbones.empty() || !hinges.backbones[h].loses_strength()) continue;
    const HingeBackbone& of = hinges.backbones[h];
    const double hardens = hinges.hardening(h) * of.plastic, least = std::min(of.clockwise, of.anticlockwise);
    if (!(hardens < least)) {
      throw InvalidParameter(place_of(hinges.places[h]) + ".plastic_rotation", fmt::format("{:.6g}", of.plastic),
                             fmt::format("must not let a member harden to twice its capacity: {}, {:.4g} beyond {:.4g}",
                                         name_of(hinges.places[h]), hardens, least));
    }
    double falls = 0;
    for (const double capacity : {of.clockwise, of.anticlockwise}) {
      if (std::isfinite(capacity)) falls = std::max(falls, (capacity + hardens) / of.softening);
    }
    const double most = (1 - least_margin) * hinges.stiffness(h, h);
    if (falls < most) continue;
    throw InvalidParameter(
        place_of(hinges.places[h]) + ".softening_rotation", fmt::format("{:.6g}", of.softening),
        fmt::format("must lose less than what the member unloads by: {}, {:.4g} of {:.4g} per rad; at least {:.4g}",
                    name_of(hinges.places[h]), falls, hinges.stiffness(h, h), of.softening * falls / most));
  }
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

void FrameHinges::add_shear(Index piece, const BreakingColumn& column, double kept) {
  pieces_[piece].shear = std::ssize(shears_);
  shears_.push_back({column, kept});
}

std::vector<std::pair<Index, Index>> FrameHinges::places_of(const Piece& piece) const {
  std::vector<std::pair<Index, Index>> places;
  if (piece.first >= 0) places.emplace_back(piece.first, 1);
  if (piece.second >= 0) places.emplace_back(piece.second, 3);
  if (piece.shear >= 0) places.emplace_back(std::ssize(ends_) + piece.shear, 2);
  return places;
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
  if (shears_.empty() && std::none_of(ends_.begin(), ends_.end(), yields)) return all;
  const Index ends_count = std::ssize(ends_), count = ends_count + std::ssize(shears_);
  all.rows = MatrixXd::Zero(count, stiffness.rows());
  all.stiffness = MatrixXd::Zero(count, count);
  for (const Piece& piece : pieces_) {
    const auto places = places_of(piece);
    for (const auto& [place, force] : places) {
      for (Index j = 0; j < 4; ++j) {
        if (piece.dofs[j] >= 0) all.rows(place, piece.dofs[j]) += piece.stiffness(force, j);
      }
      for (const auto& [other, freedom] : places) all.stiffness(place, other) += piece.stiffness(force, freedom);
    }
  }
  all.column_forces = MatrixXd::Zero(std::ssize(column_forces_), count);
  for (const ColumnForce& of : column_forces_) {
    const Piece& piece = pieces_[of.piece];
    for (const auto& [place, freedom] : places_of(piece)) {
      all.column_forces(of.row, place) -= piece.stiffness(of.force, freedom);
    }
  }
  // M₀ = G u + M_F, K u = −(moments that fixed ends put on joints). (H-9)
  VectorXd at_rest = VectorXd::Zero(count);
  at_rest.head(ends_count) = Eigen::Map<const VectorXd>(fixed_end_moments_.data(), ends_count);
  if (!at_rest.isZero(0.0)) {
    VectorXd on_joints = VectorXd::Zero(stiffness.rows());
    for (Index end = 0; end < ends_count; ++end) {
      if (ends_[end].joint >= 0) on_joints(ends_[end].joint) += at_rest(end);
    }
    at_rest -= all.rows * Cholesky(stiffness).solve(on_joints);
  }
  std::vector<End> ends = ends_;
  hold_ends_that_never_flow(ends);
  std::vector<Index> kept;
  for (Index end = 0; end < ends_count; ++end) {
    if (yields(ends_[end])) kept.push_back(end);
  }
  const Index hinges = std::ssize(kept);
  for (Index shear = ends_count; shear < count; ++shear) kept.push_back(shear);
  all.rows = all.rows(kept, Eigen::all).eval();
  all.stiffness = all.stiffness(kept, kept).eval();
  all.column_forces = all.column_forces(Eigen::all, kept).eval();
  all.at_rest = at_rest(kept);
  all.rotation_limits.setConstant(hinges, 3, not_known);
  all.hardening.setZero(std::ssize(kept));
  for (VectorXd* list : {&all.clockwise, &all.anticlockwise}) list->resize(std::ssize(kept));
  if (!shears_.empty()) all.kept.setOnes(std::ssize(kept));
  std::string worst;
  double worst_moment = 0, worst_share = 0;
  const auto bears = [&](double moment, double most, const std::string& where) {
    const double share = std::abs(moment) / most;
    if (!(share > worst_share * (1 + 1e-9))) return;  // of equals the first
    worst_share = share;
    worst_moment = std::abs(moment);
    worst = where;
  };
  for (Index h = 0; h < hinges; ++h) {
    const End& end = ends[kept[h]];
    all.places.push_back(end.place);
    all.hardening(h) = end.hardening;
    for (std::size_t n = 0; n < end.rotation_limits.size(); ++n) {
      all.rotation_limits(h, static_cast<Index>(n)) = end.rotation_limits[n];
    }
    HingeBackbone& backbone = all.backbones.emplace_back(end.backbone);
    backbone.clockwise = ends_[kept[h]].clockwise;
    backbone.anticlockwise = ends_[kept[h]].anticlockwise;
    backbone.at_rest = all.at_rest(h);
    all.clockwise(h) = end.clockwise;
    all.anticlockwise(h) = end.anticlockwise;
    const double moment = all.at_rest(h);
    bears(moment, moment > 0 ? ends_[kept[h]].clockwise : ends_[kept[h]].anticlockwise, name_of(all.places[h]));
  }
  for (const Shear& shear : shears_) {
    const Index h = hinges + std::ssize(all.columns);
    all.columns.push_back(shear.column);
    all.kept(h) = shear.kept;
    all.clockwise(h) = all.anticlockwise(h) = shear.column.capacity;
    bears(all.at_rest(h), shear.column.capacity, name_of(shear.column));
  }
  const auto loses = [](const HingeBackbone& of) { return of.loses_strength(); };
  if (std::none_of(all.backbones.begin(), all.backbones.end(), loses)) all.backbones.clear();
  if (!all.backbones.empty()) all.backbones.resize(kept.size());
  if (worst_share >= 1) {
    throw InvalidParameter("line_load", "loads on beams",
                           fmt::format("must not bring a member to yield by itself: {}, {:.4g} of {:.4g}", worst,
                                       worst_moment, worst_moment / worst_share));
  }
  return all;
}

}  // namespace bentur
