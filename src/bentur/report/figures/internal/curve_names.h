#pragma once

#include <string>
#include <vector>

#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/ticks.h"

namespace bentur {

/// The name of a curve where that ends.
struct CurveName {
  std::size_t curve = 0;  ///< of the panel
  std::string label;      ///< one line
  double x = 0, y = 0;    ///< the end
  PlaceText::Side side = PlaceText::Side::right;
  double up = 0;  ///< how far it is moved up from there, as others end near it [cm]
};

/// Room to the right of the frame that the names of a panel take which end there; 0 where none does [cm].
[[nodiscard]] double room_of_names(const Panel& panel);

/// The names of the curves of a panel that asks for them (Panel::names_at_ends) and that have room: those of curves
/// that end at the right edge of the frame beside it, others within it, where they lie on no curve, mark or other name,
/// and if they can on no rule. Where several end as one theirs stand where each is furthest from the others, or
/// where it comes to that height. @param x,
/// y its axes @param width, height of its frame [cm]
[[nodiscard]] std::vector<CurveName> names_at_ends(const Panel& panel, const Ticks& x, const Ticks& y, double width,
                                                   double height);

/// Whether some curve that is to be named so is not.
[[nodiscard]] bool lacks_names(const Panel& panel, const std::vector<CurveName>& names);

}  // namespace bentur
