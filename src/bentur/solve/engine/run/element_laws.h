#pragma once

#include <memory>
#include <vector>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/elements/coupled_law.h"
#include "bentur/solve/engine/motion/modal_system.h"

namespace bentur::engine {

/// The laws of all elements, as ModalSystem has these.
struct ElementLaws {
  std::vector<std::shared_ptr<const Law>> laws;  ///< but those that are coupled
  std::vector<double> offsets;                   ///< [length]
  /// Of contacts that rub only where these act.
  std::vector<std::shared_ptr<const CoupledLaw>> coupled = {};
  std::vector<std::shared_ptr<const Rubbing>> rubbing = {};
  std::vector<MeetingPlace> places = {};  ///< of points: contacts, then those that rub
};

/// Those of a system, with these contacts; those that rub act where there are as many of them as in the system.
[[nodiscard]] ElementLaws laws_of(const System& system, const ModalSystem& modal, const std::vector<Contact>& contacts,
                                  const std::vector<RubbingContact>& rubbing = {});

}  // namespace bentur::engine
