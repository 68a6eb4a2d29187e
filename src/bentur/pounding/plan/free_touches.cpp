#include "bentur/pounding/plan/free_touches.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/pounding/plan/no_force.h"

namespace bentur {
namespace {

using Eigen::Index;

/// The meetings of which every family closes at some time.
std::set<Index> meetings_that_may_touch(const System& system, const std::vector<double>& needed) {
  std::map<std::pair<Index, Index>, bool> closes;  // by meeting and family
  std::size_t number = 0;
  const auto look = [&](const auto& contacts) {
    for (const auto& contact : contacts) {
      const bool one_closes = needed.at(number++) > contact.width;
      if (contact.place.meeting < 0) continue;
      bool& family = closes[{contact.place.meeting, contact.place.family}];
      family = family || one_closes;
    }
  };
  look(system.contacts);
  look(system.rubbing);
  std::set<Index> open, touch;
  for (const auto& [place, family] : closes) {
    touch.insert(place.first);
    if (!family) open.insert(place.first);
  }
  std::erase_if(touch, [&](Index meeting) { return open.contains(meeting); });
  return touch;
}

std::vector<char> would_touch(const System& system, const FreeSolution& free, const RunLimits& limits) {
  std::vector<char> touch(system.contacts.size() + system.rubbing.size(), 1);
  if (free.solution().status != Status::done) return touch;
  const std::vector<double>& needed = free.solution().needed;
  const std::set<Index> asked = meetings_that_may_touch(system, needed);
  std::size_t number = 0;
  // Others get so much room that they stay apart: nothing pushes, so that they change nothing and take no events.
  const auto make_room = [&](auto& contact) {
    const double need = needed[number++];
    if (!asked.contains(contact.place.meeting)) contact.width = std::max(contact.width, 2 * need);
  };
  const auto law = no_force();
  std::vector<Contact> contacts = system.contacts;
  std::vector<RubbingContact> rubbing = system.rubbing;
  for (Contact& contact : contacts) {
    contact.law = law;
    make_room(contact);
  }
  for (RubbingContact& contact : rubbing) {
    contact.law = std::make_shared<const Rubbing>(law, 0.0, 1.0);
    make_room(contact);
  }
  const Solution solution = free.solve(contacts, rubbing, {.limits = limits});
  if (solution.status != Status::done) return touch;
  touch.assign(touch.size(), 0);
  for (const Impact& impact : solution.impacts) touch[static_cast<std::size_t>(impact.point)] = 1;
  return touch;
}

}  // namespace

const std::vector<char>& FreeTouches::found() {
  if (!found_) found_ = would_touch(*system_, *free_, limits_);
  return *found_;
}

}  // namespace bentur
