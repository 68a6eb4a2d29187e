#include "bentur/elements/bearing_laws.h"

#include "bentur/core/require.h"
#include "bentur/elements/kinematic_hardening.h"

namespace bentur {
namespace {

using Made = std::shared_ptr<const Bearings>;

LawEntryOf<Bearings> bilinear_entry() {
  return {"bilinear",
          "bilinear, or linear without a strength",
          {Key::number("stiffness", dimension::stiffness, Range::positive, {"Stiffness", "Kekakuan"},
                       "after yielding; alone, of a linear bearing"),
           Key::number("characteristic_strength", dimension::force, Range::not_negative,
                       {"Characteristic strength", "Kekuatan karakteristik"},
                       "Q: the force where the yielding branch crosses zero displacement")
               .by_default(0),
           Key::number("yield_displacement", dimension::length, Range::positive,
                       {"Displacement at yield", "Perpindahan leleh"},
                       "Δ_y, goes with Q: the stiffness before yielding is `stiffness` + Q/Δ_y")
               .optional()
               .goes_with("characteristic_strength")},
          {},
          [](const LawInput& in) -> Made {
            return std::make_shared<Bearings>(
                bilinear_bearings(in.number("stiffness"), in.optional_number("characteristic_strength").value_or(0),
                                  in.optional_number("yield_displacement").value_or(0)));
          },
          {"Bilinear", "Bilinear"}};
}

LawEntryOf<Bearings> friction_pendulum_entry() {
  return {"friction_pendulum",
          "in place of stiffness, strength and displacement: Q = μW, stiffness W/R, W all weight above, the slab's too",
          {Key::number("coefficient", dimension::none, Range::positive, {"Friction", "Koefisien gesek"}, "μ"),
           Key::number("radius", dimension::length, Range::positive, {"Radius", "Jari-jari"}, "R"),
           Key::number("yield_displacement", dimension::length, Range::positive,
                       {"Displacement at yield", "Perpindahan leleh"}, "Δ_y")},
          {},
          [](const LawInput& in) -> Made {
            const double friction = in.number("coefficient"), radius = in.number("radius");
            require_positive("coefficient", friction);
            require_positive("radius", radius);
            require_positive("weight", in.weight);
            return std::make_shared<Bearings>(
                bilinear_bearings(in.weight / radius, friction * in.weight, in.number("yield_displacement")));
          },
          {"Friction pendulum", "Pendulum gesek"}};
}

}  // namespace

Bearings bilinear_bearings(double stiffness, double strength, double yield_displacement) {
  require_positive("stiffness", stiffness);
  require_not_negative("characteristic_strength", strength);
  if (strength == 0) return {.stiffness = stiffness};
  require_positive("yield_displacement", yield_displacement);
  const double k = stiffness + strength / yield_displacement;
  const double yield = strength + stiffness * yield_displacement;
  return {.stiffness = k, .law = std::make_shared<KinematicHardening>(k, yield, stiffness / k), .strength = strength};
}

const std::vector<LawEntryOf<Bearings>>& bearing_laws() {
  static const std::vector<LawEntryOf<Bearings>> laws = {bilinear_entry(), friction_pendulum_entry()};
  return laws;
}

}  // namespace bentur
