#include "bentur/solve/engine/run/element_laws.h"

namespace bentur::engine {

ElementLaws laws_of(const System& system, const ModalSystem& modal, const std::vector<Contact>& contacts,
                    const std::vector<RubbingContact>& rubbing) {
  ElementLaws result{{}, std::vector<double>(modal.elements.size(), 0.0)};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    result.laws.push_back(contacts[i].law);
    result.offsets[i] = -contacts[i].width;
    result.places.push_back(contacts[i].place);
  }
  for (const auto* list : {&system.joints, &system.limits}) {
    for (const bentur::Element& element : *list) result.laws.push_back(element.law);
  }
  for (const Body& body : system.bodies) {
    for (const BuildingElement& element : body.elements) result.laws.push_back(element.law);
    for (const CoupledElement& element : body.coupled) result.coupled.push_back(element.law);
  }
  for (const RubbingContact& contact : rubbing) {
    result.offsets[modal.opening(modal.switched + std::ssize(result.rubbing))] = -contact.width;
    result.coupled.push_back(contact.law);
    result.rubbing.push_back(contact.law);
    result.places.push_back(contact.place);
  }
  return result;
}

}  // namespace bentur::engine
