#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/model/case.h"

namespace bentur {

/// A component of a record.
struct SuiteComponent {
  RecordEcho echo;       ///< as SuiteRecord's
  SampledMotion motion;  ///< likewise
  std::size_t entry = 0;
};

/// A record of a suite.
struct SuiteRecord {
  RecordEcho echo;         ///< `pga` as applied
  SampledMotion motion;    ///< as its file has it, in the case's units [length/s²]
  std::string event = {};  ///< the earthquake, where it is known
  std::size_t file = 0;    ///< its number among all files, from 0
  std::size_t entry = 0;   ///< of `files` that names it, from 0
  double factor = 1;       ///< that it is multiplied by [-]
  double misfit = 0;       ///< (2) [-]
  /// S_a at SuiteSpec::periods, of the record as applied [length/s²]; of a pair as pair_measure() says
  std::vector<double> spectrum = {};
  std::optional<SuiteComponent> along_y = {};  ///< of buildings in plan the other component, with the same step

  std::string called = {};  ///< by name_records()

  /// Its file; of a pair both, "A.AT2 + B.AT2".
  [[nodiscard]] std::string files() const { return along_y ? echo.file + " + " + along_y->echo.file : echo.file; }
  /// In tables and sentences.
  [[nodiscard]] std::string name() const { return called.empty() ? files() : called; }
};

/// Calls records by their files without folders and endings, "A + B"; where two of these are alike, by all of them.
void name_records(std::vector<SuiteRecord>& records);

/// What is asked of a suite.
struct SuiteRequest {
  std::string scale;                                            ///< en-1998-1, asce-7-16, period or factors
  std::optional<double> period = {};                            ///< [s] of "period"
  std::vector<double> factors = {};                             ///< of "factors", one per file [-]
  std::optional<std::size_t> select = {};                       ///< how many; nothing: all
  std::optional<std::pair<double, double>> factor_bounds = {};  ///< [-]
  std::optional<std::size_t> per_event = {};                    ///< at most so many of one earthquake
  std::optional<double> largest_misfit = {};                    ///< [-]

  /// Whether a code scales it, by fit and one common factor.
  [[nodiscard]] bool is_of_code() const { return scale == "en-1998-1" || scale == "asce-7-16"; }
};

/// How the spectra of two components are one.
enum class PairMeasure {
  geometric_mean,    ///< of both, and of their peak ground accelerations
  maximum_direction  ///< the largest over all directions, ASCE 7-16, 16.2.2
};
[[nodiscard]] PairMeasure pair_measure(const SuiteRequest& request);

/// First and second period of a building, that of a building of one floor once [s]. In plan one for each direction, "A,
/// x", with the period of the mode that has most of the mass along it alone.
struct SuitePeriods {
  std::string name;
  double first = 0;
  std::optional<double> second = {};
};
/// Of those that are not rigid.
[[nodiscard]] std::vector<SuitePeriods> suite_periods(const std::vector<const Building*>& buildings);
[[nodiscard]] std::vector<SuitePeriods> suite_periods(const std::vector<PlanBuilding>& buildings);

/// The spectrum that records are to fit, at 5 % damping, over the band from 0.2 T_min to 2 T_max: T₁ of the buildings
/// of a row, the shortest and the longest; EN 1998-1:2004, 3.2.3.1.2(4)c, and ASCE 7-16, 16.2.3.1, where 0.2 T_min is
/// the upper bound of the band's lower end.
struct SuiteTarget {
  DesignSpectrum spectrum;
  std::string shape = {}, file = {}, path = {};  ///< as the case names them, and where a table was read
  std::vector<double> periods = {};              ///< T [s], each at most 1 % longer than the one before
  std::vector<double> ordinates = {};            ///< S_a [length/s²]
  double at_zero = 0;                            ///< S_a for T → 0 [length/s²]

  [[nodiscard]] std::pair<double, double> band() const { return {periods.front(), periods.back()}; }
};

/// Records in place of one ground motion: kind = "suite".
struct SuiteSpec {
  SuiteRequest request;
  SuiteTarget target;
  std::vector<SuiteRecord> records;          ///< in the order of their files
  std::vector<SuitePeriods> buildings = {};  ///< of those that are not rigid
  std::size_t files = 0;                     ///< that they were chosen from
  double common_factor = 1;                  ///< that lifts the mean to the clause, in every factor [-]
  std::vector<double> mean = {};             ///< of the spectra as applied, at the target's periods [length/s²]
  double mean_at_zero = 0;                   ///< of the peak ground accelerations as applied [length/s²]
  std::optional<double> duration = {};       ///< [s] of [analysis]; nothing: each record's own
  SourcePosition position = {};              ///< of its kind in the case file

  /// The files that it was read from.
  [[nodiscard]] std::vector<std::string> paths() const;
  /// The least share of the target that the mean has at a period of the band [-]; infinite of no spectra.
  [[nodiscard]] double least_share() const;
  /// Whether that is less than codes ask for (EN 1998-1:2004, 3.2.3.1.2; ASCE 7-16, 16.2.3.2): then what is so under
  /// these records says nothing of the target.
  [[nodiscard]] bool is_below_target() const { return least_share() < (1 - round_off) * share_asked; }
  static constexpr double share_asked = 0.9, round_off = 1e-9;  ///< a common factor lifts the mean to just that
  /// Whether its records have two components.
  [[nodiscard]] bool is_of_pairs() const { return !records.empty() && records.front().along_y.has_value(); }
};

/// Why a suite cannot be had. Numbers are what a message needs.
struct SuiteFault {
  enum class Kind {
    too_few,       ///< fewer than asked for can be had, `count`; the others are `beyond` a rule
    factor,        ///< of `record` is `value`, outside the bounds; `common`: c in it
    misfit,        ///< that of every record is beyond the largest allowed; the least is `value`, of `record`
    no_amplitude,  ///< `record` is zero throughout
    beyond_table,  ///< the target ends before the band, which goes to `value` [s]
    no_period,     ///< no building has one: all move with the ground
    too_short,     ///< a period of the band, `value` [s], is too short for the step of `record`
    no_target,     ///< the target is zero somewhere in the band, at `value` [s]
  };
  Kind kind;
  std::size_t record = 0;  ///< a place in SuiteSpec::records as read
  std::size_t count = 0;
  double value = 0;
  double common = 1;
  /// Of too_few: how many each rule has left out; `value` the factor among those that is nearest to the bounds.
  struct Beyond {
    std::size_t factor = 0, misfit = 0, event = 0;
  } beyond = {};
};

/// Chooses and scales the records of a suite as read, and fills in the rest.
///
///   ln f = mean of ln(S_t(T)/S_a(T)) over the target's periods,                                            (1)
///   misfit² = mean of (ln(S_t(T)/S_a(T)) − ln f)²,                                                         (2)
///
/// S_t the target, S_a the record's spectrum at 5 % damping (solve/spectrum/response_spectrum.h). Of "period" f is
/// S_t/S_a at that period, and of "factors" as given; (2) holds for all. Those that fit best by (2) are taken, no more
/// of one event than allowed. Of a code all are then multiplied by the least c ≥ 1 for which
///
///   mean of S_a ≥ 0.9 S_t at every period,                                                                 (3)
///
/// EN 1998-1:2004, 3.2.3.1.2(4)c, and ASCE 7-16, 16.2.3.2; of the former also mean of the peak ground accelerations
/// ≥ S_t(0), 3.2.3.1.2(4)b. A record that c takes out of the bounds gives way to the next. Clauses from memory of the
/// codes: read yours.
/// @param progress gets the fraction of the spectra that is done
/// @param buildings suite_periods() of them
/// @return the faults, none where all went well
[[nodiscard]] std::vector<SuiteFault> settle(SuiteSpec& suite, std::vector<SuitePeriods> buildings,
                                             const std::function<void(double)>& progress = {});

/// The case with one record of its suite as ground motion, as applied, of a pair along both axes. @throws
/// InvalidParameter unless the case has a suite with such a record. @param number from 0
[[nodiscard]] Case case_of_record(const Case& c, std::size_t number);

/// What a code takes of the records' answers.
struct SuiteMeasure {
  enum class Kind { mean, largest, too_few };
  Kind kind = Kind::too_few;
  std::string_view code, clause;  ///< empty: no code scales it, and none asks
  std::size_t fewest = 0;         ///< records that the code asks for
};
/// EN 1998-1:2004, 4.3.3.4.3(3): the mean of seven or more, the largest of three to six; ASCE 7-16, 16.2.2 and 16.4:
/// the mean of eleven or more. From memory of the codes.
[[nodiscard]] SuiteMeasure suite_measure(const SuiteSpec& suite);

}  // namespace bentur
