#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bentur/core/units.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/study/design/study.h"

namespace bentur {

/// Some of a study's axes, and how many values each has. Combinations of these values are numbered, the last axis
/// fastest.
struct AxisSubset {
  std::vector<std::size_t> axes, sizes;  ///< ascending

  [[nodiscard]] bool has(std::size_t axis) const;
  [[nodiscard]] std::size_t combinations() const;
  /// The number of the combination that `choices`, one per axis of the study, hold.
  [[nodiscard]] std::size_t place(const std::vector<Choice>& choices) const;
  /// Sets the choices along these axes to the combination with a number.
  void choose(std::size_t place, std::vector<Choice>& choices) const;
};

/// The intensities of a study's records as their files have them. Which record it is, is chosen along some axes.
struct RecordIntensities : AxisSubset {
  std::vector<double> values;         ///< [unit of the levels] per combination
  std::vector<double> normalisation;  ///< [-] per combination; empty where records are not normalised
  double median = 0;                  ///< [unit of the levels] of the normalised records, where they are
};

/// The axes along which a study chooses the record: those of `excitation`, `excitation.y` or of their keys that say
/// which file and how to read it.
/// @param with_polarity false: both ways of a record are one
[[nodiscard]] AxisSubset record_axes(const Study& study, bool with_polarity = true);

/// Peak ground acceleration or pseudo-acceleration Sa(T, ζ) of a record, in the unit of the levels.
/// @throws InvalidParameter when the period is too short for the record's step.
[[nodiscard]] double intensity_of(const IdaSpec& ida, const SampledMotion& motion, const Units& units);

/// That of a record whose components have the intensities x and y.
[[nodiscard]] double intensity_of_both(IntensityOf what, double x, double y);

/// What a record is multiplied by to have the intensity `level` [unit of the levels]: the level over its own intensity.
/// Normalised records keep their proportions and are scaled together, their median to the level [FEMAP695, A.8].
/// @param place of the record in `intensities`
[[nodiscard]] double record_factor(const RecordIntensities& intensities, std::size_t place, double level);

/// Scales the record, both components alike, of a study's case, with the choices put in, to an intensity [unit of the
/// levels].
void put_intensity(const RecordIntensities& intensities, const std::vector<Choice>& choices, double level,
                   TomlValue& root);

/// The unit of the levels as UDUNITS reads it. There g is the gram: gravity is named, or given by its value where the
/// case has its own.
[[nodiscard]] std::string intensity_units(const IdaSpec& ida, const Units& units);

/// "peak ground acceleration", or "spectral acceleration, period 1 s, damping 5 %".
[[nodiscard]] std::string intensity_name(const IdaSpec& ida);

}  // namespace bentur
