#pragma once

namespace bentur {

/// Peak ground accelerations that earthquakes have which matter [g]: what is usual, and the largest that is not
/// unusual.
struct UsualPeak {
  double from = 0.05, to = 1, most = 2.5;
};

/// Whether a number without a unit, taken in a case's length/s², is rather meant in g: in g it is usual, or where it is
/// weak in length/s² not unusual. @param in_g what it is as taken [g]
[[nodiscard]] constexpr bool is_rather_in_g(double number, double in_g) {
  constexpr UsualPeak peak;
  return number >= peak.from && number <= (in_g < peak.from ? peak.most : peak.to);
}

}  // namespace bentur
