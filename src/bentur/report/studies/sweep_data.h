#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/report/figures/figure.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

/// One direction in which the runs of a sweep differ, with its values.
struct SweepDimension {
  std::string name;
  std::string short_name = {};  ///< in front of a value: "gap"
  std::size_t size = 0;
  std::string label, unit;           ///< for an axis, with unit; the unit
  std::vector<double> numbers = {};  ///< one per value, or
  std::vector<std::string> texts = {};
  bool is_of_records = false;  ///< the ground motion is what differs

  [[nodiscard]] bool is_text() const { return !texts.empty(); }
  /// Where value `i` stands on an axis: the number, or of a text `i` itself.
  [[nodiscard]] double place(std::size_t i) const { return is_text() ? static_cast<double>(i) : numbers[i]; }
  /// "0.2", or the text.
  [[nodiscard]] std::string value(std::size_t i) const;
  /// "gap 0.2 cm", or the text.
  [[nodiscard]] std::string choice(std::size_t i) const;
};

[[nodiscard]] std::vector<std::string> names_of(const std::vector<SweepDimension>& dimensions);

/// The results of bentur sweep or bentur ida (docs/studies.md), as figures and reports need them.
class SweepData {
 public:
  /// @param say the language of names and labels
  explicit SweepData(const NetcdfReader& results, FigureWords say = {});

  [[nodiscard]] const NetcdfReader& results() const noexcept { return results_; }
  /// Of a grid the directions that vary; of samples one, "sample", without values.
  [[nodiscard]] const std::vector<SweepDimension>& dimensions() const noexcept { return dimensions_; }
  /// Index of a dimension among dimensions(); their count where there is none of that name.
  [[nodiscard]] std::size_t index(const std::string& name) const;

  /// All values of a quantity, run by run, in the unit that people are shown: newtons are kN where the largest contact
  /// force or storey shear of the study is 10⁴ N or more, as of a run. Sizes of what can have either sign.
  [[nodiscard]] const std::vector<double>& all(const std::string& quantity) const;
  [[nodiscard]] std::string unit(const std::string& quantity) const;
  /// Values of a quantity at one combination of the dimensions' values, one per point, floor, gap or link.
  [[nodiscard]] std::vector<double> values(const std::string& quantity, const std::vector<std::size_t>& at) const;
  /// The largest of these values, or their sum; NaN where there is none.
  [[nodiscard]] double joined(const std::string& quantity, const std::vector<std::size_t>& at, bool sum) const;
  /// Whether a run ended before its time: a storey collapsed or the numbers failed.
  [[nodiscard]] bool is_cut_short(const std::vector<std::size_t>& at) const;
  /// All combinations of the values of some dimensions, each from `from` on; those chosen there stay.
  [[nodiscard]] std::vector<std::vector<std::size_t>> combinations(std::vector<std::size_t> from,
                                                                   const std::vector<std::size_t>& dimensions) const;
  /// How many points, floors, gaps or links a quantity has values for; 1 where there is one value a run.
  [[nodiscard]] std::size_t owners(const std::string& quantity) const;
  /// Their names, "z = 300 cm" or "gap 1"; one empty name where there is one value a run.
  [[nodiscard]] std::vector<std::string> owner_names(const std::string& quantity) const;

  /// The values chosen with `at`; size() of the dimension where it is left free.
  /// @throws NoFigure when a name or value is not there.
  [[nodiscard]] std::vector<std::size_t> chosen(const std::vector<std::pair<std::string, std::string>>& at) const;
  /// The levels of intensity; of a cloud the intensities of its records. @throws NoFigure where there are none.
  [[nodiscard]] SweepDimension intensities() const;
  /// The coordinates of samples.
  [[nodiscard]] std::vector<SweepDimension> sample_coordinates() const;

 private:
  [[nodiscard]] bool shows_in_kilonewtons(const std::string& quantity) const;
  [[nodiscard]] SweepDimension coordinate(const StoredVariable& variable) const;

  const NetcdfReader& results_;
  FigureWords say_;
  std::vector<SweepDimension> dimensions_;
  std::string force_ = "N";                                  // how newtons are shown
  mutable std::map<std::string, std::vector<double>> held_;  // by quantity, as they were asked for
};

/// A variable, and of which building it is, from 1; 0 where it is of none.
struct SweepVariable {
  std::string name;
  std::size_t building = 0;
};
/// The variables of a quantity: one, or one for each building that has it; none where the results have none of it, as
/// of contact points where a study models no contact.
[[nodiscard]] std::vector<SweepVariable> variables_of(const NetcdfReader& results, const std::string& quantity);

/// A quantity of a sweep as a figure shows it.
struct SweepKind {
  std::string kind, quantity;  ///< quantity without the building's number
  std::string label;           ///< for an axis, without unit
  bool sum = false;            ///< over points in place of the largest
  bool of_contact = false;     ///< 0 is: nothing touches
};
[[nodiscard]] const std::vector<SweepKind>& sweep_kinds();

[[nodiscard]] Figure sweep_figure(const SweepData& sweep, const SweepKind& kind, const FigureOptions& options);

/// Force or another quantity at growing intensity, a curve per record and the 16, 50 and 84 % fractiles.
[[nodiscard]] Figure ida_figure(const SweepData& sweep, const FigureOptions& options);
/// Probability of pounding against intensity, observed and fitted, with 95 % bounds.
[[nodiscard]] Figure fragility_figure(const SweepData& sweep, const FigureOptions& options);
[[nodiscard]] bool is_ida(const NetcdfReader& results);
/// Whether records are not scaled, each with an intensity of its own.
[[nodiscard]] bool is_cloud(const NetcdfReader& results);
/// Of a cloud the gap needed, or the quantity of another event, of every record against its intensity, and the line.
[[nodiscard]] Figure cloud_figure(const SweepData& sweep, const FigureOptions& options);

}  // namespace bentur
