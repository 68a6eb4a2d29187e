#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/core/units.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/model/case_spec.h"
#include "bentur/model/story/story.h"
#include "bentur/solve/tangent/tangent.h"
#include "bentur/structure/plan/footprint.h"

namespace bentur {

/// A number that a case has; in plan also the width of a gap, which follows from the footprints.
struct CaseNumber {
  std::string path;  ///< `gap[0].width`, in plan `A | B: width`
  double value = 0;  ///< as it stands there
  /// Of a footprint's corners or size, of which a hundredth is no small part of a gap: without an elasticity.
  bool is_of_footprint = false;
};

/// A peak of a run, and its derivatives by the numbers.
struct SensitivePeak {
  /// Of buildings in plan, displacements are those of the centres of mass, along x and along y.
  enum class Kind {
    gap_needed,
    peak_force,
    displacement,
    displacement_no_contact,
    displacement_x,
    displacement_x_no_contact,
    displacement_y,
    displacement_y_no_contact
  };
  Kind kind = Kind::gap_needed;
  Eigen::Index item = 0;             ///< the gap, or the building
  Eigen::Index place = 0;            ///< the contact point, or the floor
  std::string name = {};             ///< of that gap or building
  double level = 0;                  ///< [length]
  std::optional<PlanPoint> at = {};  ///< of a contact point in plan, in the common plan [length]
  bool is_largest = false;           ///< of its kind in its gap or building
  Derivative derivative = {};
  std::string record = {};  ///< of a suite of which the largest is taken: under which record it is
};
/// "gap_needed", "peak_force", …: the quantity's key.
[[nodiscard]] std::string_view key_of(SensitivePeak::Kind kind);
/// Whether it is of a gap, and not of a building.
[[nodiscard]] bool is_of_gap(SensitivePeak::Kind kind);

/// How the peaks of a case change with its numbers.
struct Sensitivity {
  std::string title;
  Units units;
  std::vector<CaseNumber> numbers;
  std::vector<std::pair<std::string, std::string>> left_out;  ///< numbers, and why
  std::vector<SensitivePeak> peaks;                           ///< gaps left to right, then buildings
  /// Of a suite: the same under each record. `peaks` are then those that the code takes of them, each the mean of all,
  /// or the one under the record that makes it largest. `excitation.scale` is a factor, 1, of all records together, of
  /// pairs `excitation.y.scale` that of those along y.
  struct OfRecord {
    std::string record;
    std::vector<SensitivePeak> peaks;
  };
  std::vector<OfRecord> records = {};
  bool takes_mean = false;
  std::vector<std::string> scales = {};  ///< of a suite: the paths of those factors, along x and along y

  /// By what part of itself a peak changes with a number, for each part of that: p/y ∂y/∂p [-]. NaN: it is not known,
  /// or the number is of a footprint.
  [[nodiscard]] double elasticity(const SensitivePeak& peak, std::size_t number) const;
};

struct SensitivityOptions {
  std::vector<std::string> numbers = {};  ///< those wanted, as paths; empty: all of buildings, gaps, links, excitation
  std::function<bool(double)> progress = {};
};

/// The derivatives of a case's peaks by its numbers (docs/sensitivity.md).
/// @param file that messages carry, and in whose folder the files are that the case names
/// @return nothing where there was an error, or the run was stopped: then there is none in `diagnostics`.
[[nodiscard]] std::optional<Sensitivity> sensitivity_of(const TomlValue& root, const std::filesystem::path& file,
                                                        const SensitivityOptions& options, Diagnostics& diagnostics);

/// The same of a case as read, for the report of its run: nothing where there is none, or where there are so many
/// buildings that it would take longer than the rest of a report.
[[nodiscard]] std::optional<Sensitivity> sensitivity_of_report(const Case& c, const std::filesystem::path& file);
/// The same of a case whose results were read, with its text and the hashes of its records. They are looked for from
/// each of the folders; nothing where they stand at none.
[[nodiscard]] std::optional<Sensitivity> sensitivity_of_results(const Case& c,
                                                                const std::vector<std::filesystem::path>& folders);

/// What each peak changes with most, what keeps its derivatives from being known; a table of the numbers that matter.
[[nodiscard]] Story sensitivity_story(const Sensitivity& found);
/// docs/sensitivity.md
[[nodiscard]] std::string sensitivity_json(const Sensitivity& found, std::string_view version);

}  // namespace bentur
