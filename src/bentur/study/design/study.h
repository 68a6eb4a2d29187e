#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/toml/parameter_path.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/study/design/distribution.h"
#include "bentur/study/design/sampling.h"

namespace bentur {

struct SuiteSpec;

/// A key that goes with a file that is varied, such as its unit: a value per file, or nothing where the case decides.
struct FileKey {
  ParameterPath path;
  std::vector<std::optional<TomlValue>> values;
};

/// What a study with [remedy] may choose a number from. Symbols: u [-] place in it, 0 at `from`, 1 at `to`.
struct SoughtRange {
  double from = 0, to = 0;
  bool log = false;  ///< u is linear in the logarithm

  [[nodiscard]] double at(double u) const;
  [[nodiscard]] double place(double x) const;  ///< u of x, within [0, 1]
};

/// One [[vary]] of a study: a key of the case, and what it is to be.
struct Vary {
  std::string parameter;                        ///< as the study names it
  ParameterPath path;                           ///< in the case
  std::string name;                             ///< of the coordinate in the results
  std::size_t axis = 0;                         ///< which it moves along; several move together
  bool factor = false;                          ///< values multiply what the case says
  std::vector<TomlValue> values;                ///< to choose from; empty: `distribution`
  bool ends_decide = false;                     ///< values are a range: right at both ends, right in between
  std::vector<std::string> labels;              ///< of values that are not numbers; else empty
  std::vector<FileKey> file_keys;               ///< of files
  std::string normalise_by;                     ///< of files: the rule, "pgv" or "pgv-pairs", where one is asked for
  std::vector<double> normalisation;            ///< of files [-]: what each record is multiplied by; empty: nothing
  std::filesystem::path normalisation_file;     ///< that these were read from, if they were
  std::optional<Distribution> distribution;     ///< to sample from
  std::optional<SoughtRange> sought;            ///< of [remedy]; values are its ends
  TomlValue original;                           ///< what the case says; of a factor
  SourcePosition parameter_position, position;  ///< of the parameter and of its values in the study
};

/// Of a record with two components: what of their intensities is that of both.
enum class IntensityOf : unsigned char { geometric_mean, larger, x, y };

/// [ida] of a study: an incremental dynamic analysis, in which every record is scaled to each level of intensity; or a
/// cloud, in which every record is applied as its file has it and has an intensity of its own.
struct IdaSpec {
  bool spectral = false;                 ///< Sa(period, damping), oscillator_peaks(); else the peak ground acceleration
  double period = 0;                     ///< [s], of Sa
  double damping = 0.05;                 ///< ratio [-], of Sa
  std::string unit;                      ///< of the levels, as acceleration_units(); empty: the case's length/s²
  bool is_cloud = false;                 ///< records are not scaled
  std::vector<double> levels;            ///< [unit] > 0, ascending; of a cloud none
  std::optional<IntensityOf> component;  ///< nothing: the ground moves in one direction
  std::string polarity;                  ///< as-recorded reversed both; empty: as the case says
  bool normalised = false;  ///< records keep their proportions: the median intensity of the set is each level
  std::optional<std::size_t> axis = {};  ///< along which the levels are; of a cloud none
  SourcePosition position;               ///< of the table in the study
};

/// [remedy] of a study: what is to become small by the choice of what has a range.
struct RemedySpec {
  std::string objective;          ///< a quantity of the results, its largest value
  bool mean = false;              ///< of all records; else the largest of them
  std::optional<double> limit;    ///< [the quantity's unit] that it must not exceed
  std::size_t evaluations = 200;  ///< at most
  SourcePosition position;        ///< of the objective in the study
};

/// A study as read: a case, what varies in it, and how the runs are chosen.
struct Study {
  std::filesystem::path file, case_file;
  std::string text, case_text;  ///< of the two files
  TomlValue case_root;
  std::vector<Vary> varies;
  std::vector<std::string> axes;  ///< their names: the dimensions of a grid
  Sampling sampling;
  std::optional<IdaSpec> ida;
  std::optional<RemedySpec> remedy;
  /// Of a case with a suite of records: `case_root` then has one record, and the others vary (suite/suite_study.h).
  std::shared_ptr<const SuiteSpec> suite = {};

  /// The first of what varies along an axis, which is not that of [ida].
  [[nodiscard]] const Vary& first_along(std::size_t axis) const;
};

/// Reads a study (docs/studies.md) and the case it names. Every error found goes to `diagnostics`, but the values are
/// not yet tried in the case: see check_study().
[[nodiscard]] std::optional<Study> read_study(const std::filesystem::path& file, Diagnostics& diagnostics);
/// The same of tables that are in memory. @param study its files, texts and case; messages carry no file
[[nodiscard]] std::optional<Study> read_study(const TomlValue& tables, Study study, Diagnostics& diagnostics);

/// Makes lists of what [sampling] draws, which move together along one axis, "draw", so that each draw is a record and
/// a building; the runs are then a grid. @return false, and nothing is changed, where no records vary
[[nodiscard]] bool draw_together(Study& study);

/// Whether the ground of a case moves along y too: [excitation.y].
[[nodiscard]] bool moves_along_y(const TomlValue& case_root);

/// One choice along every axis: a level where there are values, else an extreme value or the probability u.
struct Choice {
  std::size_t level = 0;
  double u = 0.5;                        ///< probability [-], of a distribution
  std::optional<bool> low_or_high = {};  ///< one of the extremes in place of u: false the low one
};

/// The number a vary has by a choice, or nothing when its values are no numbers. Of a factor it is the factor.
[[nodiscard]] std::optional<double> chosen_number(const Vary& vary, const Choice& choice);
/// What the record chosen is multiplied by before anything else: 1 unless files are normalised [-].
[[nodiscard]] double normalisation_of(const Study& study, const std::vector<Choice>& choices);
/// What a user calls the choice: a label, or the number.
[[nodiscard]] std::string chosen_text(const Vary& vary, const Choice& choice);
/// What is to stand in the case by a choice.
[[nodiscard]] TomlValue chosen_value(const Vary& vary, const Choice& choice);

/// Puts into a case what varies along any of the axes by the choices, one per axis. Each value's origin becomes 1 + its
/// number among the varies, so that an error can be distinguished from one of the case's own. With [ida] the record is
/// left as its file has it: `pga` and `scale` are taken out. Else records are multiplied by their normalisation. Both
/// components of one are treated alike.
void put_choices(const Study& study, const std::vector<Choice>& choices, TomlValue& root);
/// The study's case with the choices put in.
[[nodiscard]] TomlValue chosen_case(const Study& study, const std::vector<Choice>& choices);

}  // namespace bentur
