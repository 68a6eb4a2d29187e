#include "bentur/solve/engine/run/account/to_come.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// What is left of the motion of one body.
struct Left {
  VectorXd rest;            ///< of its modes, where they come to rest
  VectorXd q, v;            ///< from there
  VectorXd omega_squared;   ///< Ω² [1/s²]
  VectorXd two_sigma = {};  ///< [1/s]; empty: modes are not apart
  double twice_energy = 0;  ///< of all of them together
};

/// A deformation, or what is added to it, that vibrates by itself: q̈ + 2σ q̇ + ω² q = 0.
struct Swing {
  double omega_squared = 0, two_sigma = 0;
  double q = 0, v = 0;

  /// |q| ≤ size e^(−rate t) from here on.
  [[nodiscard]] ToCome::Fading bound() const {
    const double sigma = 0.5 * two_sigma, swings = omega_squared - sigma * sigma;
    if (swings > 1e-6 * omega_squared) return {std::hypot(q, (v + sigma * q) / std::sqrt(swings)), sigma};
    // What creeps back has no more than its energy.
    if (omega_squared > 0.0) return {std::hypot(q, v / std::sqrt(omega_squared)), 0.0};
    return {v == 0.0 ? std::abs(q) : infinite, 0.0};
  }
};

/// Bodies that joints tie to others.
std::vector<char> tied_bodies(const System& given) {
  std::vector<char> tied(given.bodies.size(), 0);
  for (const bentur::Element& joint : given.joints) {
    for (const BodyRow* side : {&joint.at.left, &joint.at.right}) {
      if (side->body >= 0) tied[side->body] = 1;
    }
  }
  return tied;
}

/// Where forces of a body's own elements beyond those of K hold its modes.
VectorXd rest_of(const ModalSystem& system, const ModalSystem::Block& block, const State& state) {
  VectorXd pushed = VectorXd::Zero(block.modes);
  for (Index i = system.members; i < system.rubs; ++i) {
    const ModalSystem::Element& element = system.elements[i];
    if (element.relation.left_begin != block.begin || element.force < 0) continue;
    pushed += element.relation.left_push.head(block.modes) * state.q(element.force);
  }
  const VectorXd stiff = system.omega_squared.segment(block.begin, block.modes);
  return (stiff.array() > 0.0).select(pushed.array() / stiff.array(), 0.0);
}

std::vector<Left> left_of(const System& given, const ModalSystem& system, const State& state,
                          const Elements& elements) {
  const std::vector<char> tied = tied_bodies(given);
  std::vector<Left> all;
  double of_tied = 2.0 * std::max(0.0, elements.stored_in_others(state));
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const ModalSystem::Block& block = system.blocks[b];
    const auto of = [&](const VectorXd& x) { return x.segment(block.begin, block.modes); };
    Left& left = all.emplace_back();
    left.rest = tied[b] != 0 ? VectorXd(VectorXd::Zero(block.modes)) : rest_of(system, block, state);
    left.q = of(state.q) - left.rest;
    left.v = of(state.v);
    left.omega_squared = of(system.omega_squared);
    left.twice_energy = left.v.squaredNorm() + left.omega_squared.dot(left.q.cwiseAbs2());
    if (tied[b] != 0) {
      of_tied += left.twice_energy;
    } else if (!block.damping) {
      left.two_sigma = of(system.two_sigma);
    }
  }
  for (std::size_t b = 0; b < all.size(); ++b) {
    if (tied[b] != 0) all[b].twice_energy = of_tied;
  }
  return all;
}

/// Modes of both sides of a gap that swing alike, as those of two like buildings, are one.
void add_side(const Left& left, const VectorXd& row, std::vector<Swing>& swings, ToCome& to) {
  const VectorXd modes = row.head(left.rest.size());
  to.rest += modes.dot(left.rest);
  double compliance = 0.0;
  for (Index k = 0; k < modes.size(); ++k) {
    if (modes(k) == 0.0) continue;
    compliance += modes(k) * modes(k) / left.omega_squared(k);  // infinite of what nothing holds
    if (left.two_sigma.size() == 0) continue;
    Swing swing{left.omega_squared(k), left.two_sigma(k), modes(k) * left.q(k), modes(k) * left.v(k)};
    const auto like = std::find_if(swings.begin(), swings.end(), [&](const Swing& one) {
      return one.omega_squared == swing.omega_squared && one.two_sigma == swing.two_sigma;
    });
    if (like == swings.end()) {
      swings.push_back(swing);
    } else {
      like->q += swing.q;
      like->v += swing.v;
    }
  }
  if (left.two_sigma.size() > 0 || !(left.twice_energy > 0.0) || !(compliance > 0.0)) return;
  to.fading.push_back({std::sqrt(left.twice_energy * compliance), 0.0});
}

}  // namespace

std::vector<ToCome> to_come(const System& given, const ModalSystem& system, const State& state,
                            const Elements& elements) {
  const std::vector<Left> bodies = left_of(given, system, state, elements);
  std::vector<ToCome> all;
  const auto add = [&](const ModalSystem::Relation& at) {
    ToCome& to = all.emplace_back();
    const auto of_ground = [&](Index body, const VectorXd& row) {
      return !row.segment(system.blocks[body].modes, system.components()).isZero(0.0);
    };
    to.known = !of_ground(at.left, at.left_row) && (at.right_size == 0 || !of_ground(at.right, at.right_row));
    if (!to.known) return;
    std::vector<Swing> swings;
    add_side(bodies[at.left], at.left_row, swings, to);
    if (at.right_size > 0) add_side(bodies[at.right], at.right_row, swings, to);
    for (const Swing& one : swings) {
      if (one.q != 0.0 || one.v != 0.0) to.fading.push_back(one.bound());
    }
  };
  for (Index point = 0; point < system.points(); ++point) add(system.elements[system.opening(point)].relation);
  for (const ModalSystem::Relation& at : system.watched) add(at);
  return all;
}

}  // namespace bentur::engine
