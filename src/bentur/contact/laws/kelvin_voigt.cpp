#include "bentur/contact/laws/kelvin_voigt.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "bentur/contact/restitution_relations.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

using Release = KelvinVoigt::Release;

const Key& release_choice() {
  static const Key choice =
      Key::choice("release", {"zero-force", "separation", "creep"}, {"End of contact", "Akhir kontak"},
                  "when a contact ends: when its force is zero; when the floors separate; or when its force is zero, "
                  "after which the surface recovers slowly")
          .called({{"zero force", "saat gaya nol"},
                   {"separation", "saat memisah"},
                   {"zero force, then the surface recovers", "saat gaya nol, lalu permukaan pulih"}})
          .optional();
  return choice;
}

Release release_of(const LawInput& in) {
  const auto word = in.word(release_choice());
  return word == "separation" ? Release::separation : word == "creep" ? Release::creep : Release::zero_force;
}

double calibrated_ratio(double restitution, const LawInput& in) {
  if (in.word(exact_or_published()) == "published") return published::anagnostopoulos_damping_ratio(restitution);
  if (release_of(in) == Release::separation) return exact_separation_damping_ratio(restitution);
  return exact_zero_force_damping_ratio(restitution);
}

/// c of ξ = 1.
double critical_damping(double stiffness, double effective_mass) {
  return 2 * std::sqrt(stiffness) * std::sqrt(effective_mass);
}

double ratio_of_damping(double damping, const LawInput& in) {
  require_positive("effective_mass", in.effective_mass);
  require_not_negative("damping", damping);
  const double critical = critical_damping(in.number("stiffness"), in.effective_mass);
  if (release_of(in) == Release::separation && !(damping < critical)) {
    throw InvalidParameter("damping", fmt::format("{}", damping),
                           fmt::format("must be in [0, {:.6g}) with release = \"separation\"", critical));
  }
  return damping / critical;
}

}  // namespace

KelvinVoigt::KelvinVoigt(double stiffness, double damping_ratio, double effective_mass, Release release,
                         std::optional<double> restitution)
    : stiffness_(stiffness), damping_ratio_(damping_ratio), release_(release), restitution_(restitution) {
  require_positive("stiffness", stiffness);
  require_not_negative("damping_ratio", damping_ratio);
  require_positive("effective_mass", effective_mass);
  if (release == Release::separation && damping_ratio >= 1) {
    throw InvalidParameter("damping_ratio", fmt::format("{}", damping_ratio),
                           "must be in [0, 1) with release = \"separation\"");
  }
  damping_ = damping_ratio * critical_damping(stiffness, effective_mass);
}

LawEntry KelvinVoigt::entry() {
  return {"kelvin-voigt",
          "k δ + c δ̇, c = 2ξ√(k m_e)",
          {spring_stiffness(), asked_restitution(), asked_damping_ratio(),
           Key::number("damping", dimension::dashpot, Range::not_negative, {"Damping", "Redaman"},
                       "c; below the critical 2√(k m_e) with `release = \"separation\"`")
               .for_each("one per contact point")
               .one_of("damping of the contact")},
          {release_choice(), exact_or_published()},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            const auto asked = in.optional_number("restitution");
            const auto damping = in.optional_number("damping");
            const double ratio = asked     ? calibrated_ratio(*asked, in)
                                 : damping ? ratio_of_damping(*damping, in)
                                           : in.number("damping_ratio");
            return std::make_shared<KelvinVoigt>(in.number("stiffness"), ratio, in.effective_mass, release_of(in),
                                                 asked);
          }};
}

LawParameters KelvinVoigt::parameters() const {
  LawParameters list = {{"stiffness", stiffness_}};
  if (restitution_) list.emplace_back("restitution", *restitution_);
  list.emplace_back("damping_ratio", damping_ratio_);
  list.emplace_back("damping", damping_);
  return list;
}

Branch KelvinVoigt::touching() const noexcept {
  const Branch closed = {.bodies = Bodies::touching, .stiffness = stiffness_, .damping = damping_};
  const Guard surface = {.deformation = 1};
  const Guard push = {.deformation = stiffness_, .speed = damping_};
  if (damping_ == 0 || release_ == Release::separation) return closed.guarded_by({surface});
  if (release_ == Release::zero_force) return closed.guarded_by({surface, push});
  return closed.guarded_by({push});
}

Branch KelvinVoigt::branch(const LawState& state) const noexcept {
  const Guard no_push = {.deformation = -stiffness_, .speed = -damping_};
  switch (state.branch) {
    case apart:
      return Branch::apart();
    case in_contact:
      return touching();
    case released:
      if (release_ == Release::zero_force) return Branch{}.guarded_by({{.deformation = 1}, no_push});
      return Branch{}.guarded_by({no_push});
    default:
      return Branch{}.guarded_by({{.deformation = -1, .decaying = state.memory[0], .rate = stiffness_ / damping_},
                                  {.deformation = stiffness_, .speed = damping_}});
  }
}

LawState KelvinVoigt::next(const LawState& state, std::size_t guard, double time, double penetration,
                           double closing_speed) const noexcept {
  if (state.branch == apart) return {.branch = in_contact, .since = time, .closing_speed = closing_speed};
  if (state.branch == in_contact) {
    const bool push_ended = damping_ > 0 && (release_ == Release::creep || guard == 1);
    if (!push_ended || !(penetration > 0)) return {.since = time};
    return {.branch = released, .since = time, .memory = {release_ == Release::creep ? penetration : 0}};
  }
  if (release_ == Release::creep) return off_the_surface(state, guard, time, closing_speed);
  if (guard == 0) return {.since = time};
  return {.branch = in_contact, .since = time, .closing_speed = closing_speed};
}

LawState KelvinVoigt::off_the_surface(const LawState& state, std::size_t guard, double time,
                                      double closing_speed) const noexcept {
  if (state.branch == nearing && guard == 0) {
    return {.branch = in_contact, .since = time, .closing_speed = closing_speed};
  }
  const double left = std::exp(-stiffness_ / damping_ * (time - state.since));
  if (left < std::numeric_limits<double>::epsilon()) return {.since = time};
  return {.branch = state.branch == nearing ? released : nearing, .since = time, .memory = {state.memory[0] * left}};
}

double KelvinVoigt::stored_energy(const LawState& state, double penetration) const noexcept {
  const bool released_without_memory = state.branch == released && release_ == Release::zero_force;
  const bool holds = state.branch == in_contact || released_without_memory;
  return holds ? 0.5 * stiffness_ * penetration * penetration : 0.0;
}

}  // namespace bentur
