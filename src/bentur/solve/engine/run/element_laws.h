#pragma once

#include <memory>
#include <vector>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/elements/coupled_law.h"
#include "bentur/solve/engine/motion/modal_system.h"
#include "bentur/solve/engine/motion/sets_over_modes.h"

namespace bentur::engine {

/// The laws of all elements, as ModalSystem has these.
struct ElementLaws {
  std::vector<std::shared_ptr<const Law>> laws;  ///< but those that are coupled
  std::vector<double> offsets;                   ///< [length]
  /// Of contacts that rub only where these act.
  std::vector<std::shared_ptr<const CoupledLaw>> coupled = {};
  std::vector<std::shared_ptr<const Rubbing>> rubbing = {};
  std::vector<MeetingPlace> places = {};  ///< of points: contacts, then those that rub
  /// What runs of the system share; null: nothing.
  std::shared_ptr<SetsOverModes> sets = nullptr;
};

/// How large the numbers are whose difference δ is, and how fast they change, per point of contact.
struct ElementScales {
  std::vector<double> displacement;  ///< [length]; grows with what the run does
  std::vector<double> speed;         ///< [length/s]
};

/// What an element that is no pair of bodies has done up to the last change of its branch.
struct ElementAccount {
  double entered = 0;       ///< δ at that change [length]
  double work = 0;          ///< that its springs took in [force·length]
  double damped = 0;        ///< that its dashpot took in, up to now [force·length]
  double peak_force = 0;    ///< max F of links, up to now [force]
  double peak_tension = 0;  ///< max −F of links, up to now [force]
};

/// δ at which bodies that are apart touch, where that is a place: not 0 once their surface is crushed.
[[nodiscard]] inline double surface(const Branch& branch) {
  const Guard& guard = branch.guards[0];
  return guard.deformation == -1.0 && guard.speed == 0.0 && guard.decaying == 0.0 ? guard.constant : 0.0;
}

/// Those of a system, with these contacts; those that rub act where there are as many of them as in the system.
[[nodiscard]] ElementLaws laws_of(const System& system, const ModalSystem& modal, const std::vector<Contact>& contacts,
                                  const std::vector<RubbingContact>& rubbing = {});

}  // namespace bentur::engine
