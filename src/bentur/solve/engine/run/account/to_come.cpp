#include "bentur/solve/engine/run/account/to_come.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <variant>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// What is left of the motion of one body.
struct Left {
  VectorXd rest;            ///< of its modes, where they come to rest
  Eigen::MatrixXcd steady;  ///< how they swing with each harmonic motion, a column each: Re(steady e^(iνt))
  VectorXd q, v;            ///< from both
  bool goes_on = false;     ///< under a harmonic motion of whose steady response nothing is known
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

/// A harmonic motion of ν as G of a_g = Re(G e^(iνt)), t from `time` after its start on.
std::complex<double> from_there(const HarmonicMotion& motion, double nu, double time) {
  const std::complex<double> of_displacement =
      motion.phase == HarmonicMotion::Phase::sine ? std::complex<double>(0, -1) : std::complex<double>(1, 0);
  return -nu * nu * motion.displacement_amplitude * of_displacement * std::polar(1.0, nu * time);
}

/// How the modes of a body swing with a harmonic motion of ν that goes on: q = Re(Q e^(iνt)),
/// (Ω² − ν² + iνD) Q = γ G.
Eigen::VectorXcd steady_of(const ModalSystem& system, const ModalSystem::Block& block, Index component,
                           const std::complex<double>& ground, double nu) {
  const auto of = [&](const VectorXd& x) { return x.segment(block.begin, block.modes); };
  const Eigen::VectorXcd pushed = ground * system.gamma.col(component).segment(block.begin, block.modes);
  const std::complex<double> speed(0, nu);
  Eigen::VectorXcd stiffness = (of(system.omega_squared).array() - nu * nu).cast<std::complex<double>>();
  if (block.damping) {
    Eigen::MatrixXcd all = speed * block.damping->topLeftCorner(block.modes, block.modes);
    all.diagonal() += stiffness;
    return all.partialPivLu().solve(pushed);
  }
  stiffness += speed * of(system.two_sigma);
  return pushed.cwiseQuotient(stiffness);
}

/// Takes off how a body swings with harmonic motions, which no later swing exceeds.
void take_steady(const System& given, const ModalSystem& system, std::size_t body, bool is_tied, Left& left) {
  const ModalSystem::Block& block = system.blocks[body];
  const Body& of = given.bodies[body];
  const bool is_alone = !is_tied && of.elements.empty() && of.coupled.empty();  // so that its motion is that of K
  left.steady = Eigen::MatrixXcd::Zero(block.modes, system.components());
  for (Index c = 0; c < system.components(); ++c) {
    const auto* const motion = std::get_if<HarmonicMotion>(&given.motions[static_cast<std::size_t>(c)]);
    if (motion == nullptr || block.modes == 0) continue;
    const double since = given.duration - given.delay(body), nu = system.nu[static_cast<std::size_t>(c)];
    if (!is_alone || since < 0) {
      left.goes_on = true;
      continue;
    }
    const Eigen::VectorXcd steady = steady_of(system, block, c, from_there(*motion, nu, since), nu);
    if (!steady.allFinite()) {
      left.goes_on = true;
      continue;
    }
    left.steady.col(c) = steady;
    left.q -= steady.real();
    left.v -= (std::complex<double>(0, nu) * steady).real();
  }
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
    take_steady(given, system, b, tied[b] != 0, left);
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
/// @param steady of δ under each component, a term of each side added
void add_side(const Left& left, const VectorXd& row, std::vector<Swing>& swings, Eigen::VectorXcd& steady, ToCome& to) {
  const VectorXd modes = row.head(left.rest.size());
  to.rest += modes.dot(left.rest);
  steady += left.steady.transpose() * modes;
  if (left.goes_on) to.fading.push_back({infinite, 0.0});
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
    Eigen::VectorXcd steady = Eigen::VectorXcd::Zero(system.components());
    add_side(bodies[at.left], at.left_row, swings, steady, to);
    if (at.right_size > 0) add_side(bodies[at.right], at.right_row, swings, steady, to);
    if (const double size = steady.cwiseAbs().sum(); size > 0) to.fading.push_back({size, 0.0});
    for (const Swing& one : swings) {
      if (one.q != 0.0 || one.v != 0.0) to.fading.push_back(one.bound());
    }
  };
  for (Index point = 0; point < system.points(); ++point) add(system.elements[system.opening(point)].relation);
  for (const ModalSystem::Relation& at : system.watched) add(at);
  return all;
}

}  // namespace bentur::engine
