#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "bentur/elements/law.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/structure/body.h"

namespace bentur {

/// A length of one body: row · x over its degrees of freedom, and so many times the displacement of its ground in each
/// component.
struct BodyRow {
  Eigen::Index body = -1;  ///< index into System::bodies; −1: none
  Eigen::VectorXd row = {};
  Eigen::VectorXd ground = {};  ///< per component [-]; empty: none of it
  /// Which of the first Outputs of its body is this length; −1: none. How far that goes tells how well it is known.
  Eigen::Index output = -1;
};

/// The deformation δ of an element: of one body, or of two, left + right. A force F of the element pushes both against
/// it, and moves no ground.
struct Interface {
  BodyRow left, right = {};
};

/// What acts by one deformation beside the bodies' own elements.
struct Element {
  Interface at;
  std::shared_ptr<const Law> law;
};

/// Where a contact stands in a meeting: several families of contacts by which two bodies may touch one another. They do
/// so in the family that closes last, and only as long as all families of the meeting are closed. One is closed where
/// one of its contacts is, δ > 0.
struct MeetingPlace {
  Eigen::Index meeting = -1;  ///< its number; −1: none, bodies touch here whatever they do elsewhere
  Eigen::Index family = 0;    ///< of the meeting
  bool seam = false;          ///< bodies never touch here: it says alone whether the family is closed
};

/// Bodies that may touch: δ is the interface's less the width.
struct Contact {
  Interface at;
  std::shared_ptr<const Law> law;
  double width = 0;         ///< w [length] ≥ 0; in a meeting also below zero, of a family that is closed at rest
  MeetingPlace place = {};  ///< those of a meeting all have a restitution, or none has
};

class Rubbing;

/// Bodies that may touch and rub along one another: δ as of a Contact, s the slip. Both are of the same bodies.
struct RubbingContact {
  Interface at, along;
  std::shared_ptr<const Rubbing> law;
  double width = 0;         ///< as a Contact's
  MeetingPlace place = {};  ///< likewise
};

/// Ways in which the ground moves at most.
inline constexpr std::size_t most_components = 3;

/// What a solver is given: bodies, what acts between them and on them, what is watched, and how the ground moves.
struct System {
  std::vector<Body> bodies;
  std::vector<Contact> contacts;             ///< switched off in the free response
  std::vector<RubbingContact> rubbing = {};  ///< likewise
  std::vector<Element> joints;               ///< which act in the free response too
  std::vector<Element> limits;               ///< whose passing ends a run
  std::vector<Interface> watched;            ///< how far their δ go is asked for
  std::vector<Interface> watched_free = {};  ///< of the free response alone
  /// One per component of the ground's motion, 1 … most_components of them: what the columns of Body::load are for.
  std::vector<GroundMotion> motions;
  std::vector<double> delays = {};                    ///< [s] ≥ 0, one per body, of all components; empty: all zero
  std::vector<Eigen::VectorXd> initial_displacement;  ///< per body, over its degrees of freedom; empty: at rest
  std::vector<Eigen::VectorXd> initial_velocity;      ///< likewise
  double duration = 0;                                ///< [s] > 0

  /// τ_b [s] of a body: 0 where no delays are given.
  [[nodiscard]] double delay(std::size_t body) const { return delays.empty() ? 0.0 : delays.at(body); }
};

/// Whether the ground moves.
[[nodiscard]] bool is_shaken(const System& system);

/// Whether the free response to the ground motions times −1 is the free response times −1: the bodies start from rest
/// and every law of an element or joint is odd. What acts in one direction alone, as cables do, makes another one.
[[nodiscard]] bool is_mirrored(const System& system);

/// Whether `factor` > 0 times the ground motions and all widths give `factor` times the response, whatever widths and
/// homogeneous laws the contacts have: the bodies are elastic and start from rest, no limit ends a run, and joints have
/// no length or force of their own.
[[nodiscard]] bool is_homogeneous(const System& system);

/// Whether all laws of contacts are, of those that rub of what pushes.
[[nodiscard]] bool are_homogeneous(const std::vector<Contact>& contacts, const std::vector<RubbingContact>& rubbing);

/// How many times these motions are the others, one by one, > 0; nothing where they are not, or are not all sampled.
[[nodiscard]] std::optional<double> times(const std::vector<GroundMotion>& motions,
                                          const std::vector<GroundMotion>& others);

}  // namespace bentur
