#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/io/results/result_variable.h"
#include "bentur/model/story/study_story.h"
#include "bentur/study/fragility/ida_fragility.h"

namespace bentur {

inline constexpr const char* pounding_event = "impacts > 0";
inline constexpr const char* collapse_event = "collapsed > 0";
inline constexpr const char* gap_needed_event = "gap_needed > 0";  ///< whose demands are the gaps that runs need

/// "peak_force > 20": a run has the event where any value of the quantity (point, floor, gap) compares so.
struct EventRule {
  enum class Comparison { more, at_least, less, at_most };

  std::string quantity;
  Comparison comparison = Comparison::more;
  double threshold = 0;  ///< [the quantity's unit in the results]

  [[nodiscard]] bool holds(double value) const;  ///< never for NaN
};

/// @return nothing where it is not well formed; `error` then says why.
[[nodiscard]] std::optional<EventRule> parse_event(const std::string& text, std::string& error);

/// The number that stands behind a word in a text, as "period 0.5 s" has it.
[[nodiscard]] std::optional<double> number_after(const std::string& text, const std::string& word);

/// long_name of a coordinate that does no more than name or number the places of its dimension.
inline constexpr std::string_view index_title = "what moves together, by its labels or numbered from 0";

/// Values along a dimension of the results: numbers, or texts.
struct ResultCoordinate {
  std::string name, units;
  std::string parameter;  ///< key of the case that it is; empty for factors
  std::vector<double> numbers;
  std::vector<std::string> texts;

  /// Whether it is the width of a gap, or of a point of one.
  [[nodiscard]] bool is_gap_width() const;
};

struct ResultAxis {
  std::string name;
  std::size_t size = 0;
  std::vector<ResultCoordinate> coordinates;
};

/// What `bentur ida` has written, as far as one event goes.
struct IdaResults {
  std::string title;
  std::string intensity, units;      ///< "peak ground acceleration"; as UDUNITS reads it
  std::string study_unit;            ///< of the intensities as a study names it: g, cm/s2
  std::string quantity_units;        ///< of the event's quantity, as UDUNITS reads them
  std::vector<ResultAxis> axes;      ///< of the cases, the last one fastest; none: a single case
  std::vector<std::string> records;  ///< what users call them, each once, in whichever direction it is applied
  OutcomeTable table;
  OpenNeeds open;  ///< runs of which it is not known what gap they need
  long done = 0;   ///< of so many, which make a case

  /// Of spectral acceleration [s]; nothing: the levels are of the peak ground acceleration.
  [[nodiscard]] std::optional<double> period() const;
  /// Which value of each axis a case has.
  [[nodiscard]] std::vector<std::size_t> places(std::size_t c) const;
};

/// Whether runs are compared by |value| of a variable, which can have either sign (Quantity::by_size).
[[nodiscard]] bool is_compared_by_size(const ResultSource& file, const std::string& variable);

/// Reads the results of an incremental dynamic analysis. The quantity of the event is a variable's name; of those with
/// a building's number also the name without it, for all buildings; `drift` is peak_drift_ratio. The file fails when
/// there is no such quantity, or it does not hold such results.
[[nodiscard]] IdaResults read_ida_results(const ResultSource& file, const EventRule& event);

}  // namespace bentur
