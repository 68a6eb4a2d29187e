#include "bentur/contact/laws/hertz_damp.h"

#include <cmath>

#include "bentur/contact/laws/hertz.h"
#include "bentur/contact/restitution_relations.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

const Key& formula() {
  static const Key choice = [] {
    Key key = exact_or_published();
    key.words = {"exact", "muthukumar-desroches", "ye"};
    key.called({{"exact", "eksak"}, {}, {}});
    return key;
  }();
  return choice;
}

double calibrated_factor(double restitution, const LawInput& in) {
  const auto given = in.words.find("calibration");
  if (given != in.words.end() && given->second == "published") {
    throw InvalidParameter("calibration", "\"published\"",
                           "leaves two formulas open here: must be exact, muthukumar-desroches or ye");
  }
  const auto word = in.word(formula());
  if (word == "muthukumar-desroches") return published::muthukumar_desroches_damping_factor(restitution);
  if (word == "ye") return published::ye_damping_factor(restitution);
  return exact_damping_factor(restitution);
}

}  // namespace

HertzDamp::HertzDamp(double stiffness, double damping_factor, std::optional<double> restitution)
    : stiffness_(stiffness), damping_factor_(damping_factor), restitution_(restitution) {
  require_positive("stiffness", stiffness);
  require_not_negative("damping_factor", damping_factor);
}

LawEntry HertzDamp::entry() {
  return {
      "hertz-damp",
      "β δ^1.5 (1 + d δ̇/v₀)",
      {hertz_law_stiffness(), asked_restitution(),
       Key::number("damping_factor", dimension::none, Range::not_negative, {"Damping factor", "Faktor redaman"}, "d")
           .for_each("one per contact point")
           .one_of("damping of the contact")},
      {formula()},
      [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
        const auto asked = in.optional_number("restitution");
        const double factor = asked ? calibrated_factor(*asked, in) : in.number("damping_factor");
        return std::make_shared<HertzDamp>(in.number("stiffness"), factor, asked);
      }};
}

LawParameters HertzDamp::parameters() const {
  LawParameters list = {{"stiffness", stiffness_}};
  if (restitution_) list.emplace_back("restitution", *restitution_);
  list.emplace_back("damping_factor", damping_factor_);
  return list;
}

double HertzDamp::slowness(const LawState& state) const noexcept {
  const double value = damping_factor_ / state.closing_speed;
  return state.closing_speed > 0 && std::isfinite(value) ? value : 0;
}

Branch HertzDamp::branch(const LawState& state) const noexcept {
  if (state.branch == apart) return Branch::apart();
  const double slow = slowness(state);
  if (state.branch == cut) {
    return Branch{.bodies = Bodies::touching}.guarded_by({{.deformation = 1}, {.constant = -1, .speed = -slow}});
  }
  const Branch closed = {.bodies = Bodies::touching, .linear = false};
  if (slow == 0) return closed.guarded_by({{.deformation = 1}});
  return closed.guarded_by({{.deformation = 1}, {.constant = 1, .speed = slow}});
}

double HertzDamp::force(const LawState& state, double penetration, double closing_speed) const noexcept {
  if (state.branch != pushing) return ContactLaw::force(state, penetration, closing_speed);
  return hertz_force(stiffness_, penetration) * (1 + slowness(state) * closing_speed);
}

double HertzDamp::stored_energy(const LawState& state, double penetration) const noexcept {
  return state.branch == apart ? 0.0 : hertz_energy(stiffness_, penetration);
}

}  // namespace bentur
