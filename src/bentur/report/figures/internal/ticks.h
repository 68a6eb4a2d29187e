#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bentur {

/// Of a place along an axis, of which more is cut [cm].
inline constexpr double longest_name = 3.6;

/// Where an axis begins and ends, and its numbers.
struct Ticks {
  double from = 0, to = 1;
  bool logarithmic = false;
  bool numbered = false;  ///< the numbers stand for names
  bool upright = false;   ///< texts are turned, since they are too long to stand side by side
  int lines = 1;          ///< in which texts stand by turns
  int exponent = 0;       ///< the numbers are those of value / 10^exponent
  std::vector<std::pair<double, std::string>> labels = {};
  std::vector<double> minor = {};  ///< without a number
};

/// Beside the range of its data: nearer to zero than this an end is zero, so that the last digits of numbers that
/// differ from machine to machine make no other axis.
constexpr double round_off = 1e-9;

/// An axis for data from `low` to `high`, at most about `most` numbers apart by 1, 2 or 5 times a power of ten. Ends
/// that are not given leave the data some air, but zero is an end where data end there; a logarithmic axis ends on a
/// number.
struct TickRequest {
  double low = 0, high = 1;
  std::optional<double> from = {}, to = {};
  bool logarithmic = false;
  int most = 6;
  std::optional<std::pair<double, double>> least = {};  ///< what is shown at least where no ends are given
  bool plain = false;                                   ///< no power of ten goes into the unit
};
[[nodiscard]] Ticks make_ticks(const TickRequest& request);
/// Where a value stands along an axis, 0 at its begin and 1 at its end.
[[nodiscard]] double along(const Ticks& ticks, double at);
/// The value at that part of it.
[[nodiscard]] double value_at(const Ticks& ticks, double part);
/// Puts the numbers at these places, ascending, unless two of them are nearer than a part `room` of the axis.
void put_at(Ticks& ticks, const std::vector<double>& places, double room);
/// The label of an axis with these numbers: "Force F [10⁶ N]"; where numbers stand for names, "Record (number)".
[[nodiscard]] std::string scaled(const std::string& label, const Ticks& ticks, const std::string& number = "number");
/// Places 0, 1, 2, … with names, or, where `numbered`, with every so many of the numbers from 1 on.
[[nodiscard]] Ticks named_ticks(const std::vector<std::string>& names, bool numbered, int most);

}  // namespace bentur
