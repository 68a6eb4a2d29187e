#include "bentur/study/gap/gap_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bentur/io/input_file.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/pounding/pounding.h"
#include "bentur/study/plan/study_check.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

/// Of records: the median plus and minus a standard deviation of a lognormal variable, and what codes and engineers ask
/// for.
constexpr double told_quantiles[] = {0.16, 0.5, 0.84, 0.9, 0.95};

/// The largest of the levels of a gap.
GapNeed need_of(const std::vector<LevelSeparation>& separations, const Gap& gap) {
  const LevelSeparation largest = largest_of(of_gap(separations, gap.left));
  GapNeed need{largest.gap_needed, largest.abs, largest.srss, largest.ddc, {}};
  for (const CodeSeparation& code : largest.codes) need.codes.push_back(code.gap);
  return need;
}

constexpr double GapNeed::*single_numbers[] = {&GapNeed::gap_needed, &GapNeed::abs, &GapNeed::srss, &GapNeed::ddc};

/// The gap that the fraction p [-] of the records does not exceed, each number by itself; p = 1: the largest.
GapNeed quantile_of_needs(const RecordNeeds& needs, Eigen::Index gap, double p) {
  const auto quantile = [&](auto number_of) {
    std::vector<double> numbers;
    for (const RecordNeed& record : needs.records) numbers.push_back(number_of(record.gaps[gap]));
    const bool known = std::none_of(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); });
    return known ? quantile_of(std::move(numbers), p) : not_known;
  };
  GapNeed result;
  for (const auto number : single_numbers) result.*number = quantile([&](const GapNeed& need) { return need.*number; });
  for (std::size_t i = 0; i < needs.records.front().gaps[gap].codes.size(); ++i) {
    result.codes.push_back(quantile([&](const GapNeed& need) { return need.codes[i]; }));
  }
  return result;
}

using Named = std::vector<std::pair<std::string, std::string>>;

class Work {
 public:
  Work(const Study& study, const StudyFacts& facts, CaseMemo& memo, GapStudy& result)
      : study_(study), facts_(facts), memo_(memo), result_(result) {}

  void run(const std::function<void(double)>& progress) {
    const std::vector<SweepAxis> axes = plan_axes(study_);
    const AxisSubset records = record_axes(study_);
    const AxisSubset widths = subset(axes, [&](std::size_t axis) { return axes[axis].inner && sets_widths(axis); });
    const AxisSubset others = subset(axes, [&](std::size_t axis) {
      const bool is_level = study_.ida && axis == study_.ida->axis;
      return !records.has(axis) && !is_level && !axes[axis].inner;
    });
    const std::size_t blocks = others.combinations(), each = records.combinations();
    for (std::size_t block = 0; block < blocks; ++block) {
      std::vector<Choice> choices(axes.size());
      others.choose(block, choices);
      RecordNeeds needs;
      needs.others = values_along(others, choices);
      for (std::size_t record = 0; record < each; ++record) {
        records.choose(record, choices);
        needs.records.push_back(need(choices, records));
        progress(static_cast<double>(block * each + record + 1) / static_cast<double>(blocks * each));
      }
      tell_quantiles(needs);
      compare_with_given(widths, choices, needs);
      result_.needs.push_back(std::move(needs));
    }
    if (blocks > 1) put_together();
  }

 private:
  /// The axes that `is_one` says true of.
  template <typename IsOne>
  static AxisSubset subset(const std::vector<SweepAxis>& axes, IsOne is_one) {
    AxisSubset result;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      if (!is_one(axis)) continue;
      result.axes.push_back(axis);
      result.sizes.push_back(axes[axis].levels);
    }
    return result;
  }

  [[nodiscard]] bool sets_widths(std::size_t axis) const {
    return std::any_of(study_.varies.begin(), study_.varies.end(), [&](const Vary& vary) {
      return vary.axis == axis && vary.path.size() >= 3 && vary.path[2] == PathStep("width");
    });
  }

  /// Name and value of what varies along some axes.
  [[nodiscard]] Named values_along(const AxisSubset& axes, const std::vector<Choice>& choices) const {
    Named result;
    for (const Vary& vary : study_.varies) {
      if (axes.has(vary.axis)) result.emplace_back(vary.name, value_text(vary, choices[vary.axis]));
    }
    return result;
  }

  void tell_quantiles(RecordNeeds& needs) const {
    for (Eigen::Index gap = 0; gap + 1 < std::ssize(facts_.problem.buildings); ++gap) {
      GapOverRecords over{quantile_of_needs(needs, gap, 1), quantile_of_needs(needs, gap, 0.5), {}, {}};
      for (const double p : told_quantiles) over.quantiles.push_back({p, quantile_of_needs(needs, gap, p)});
      needs.gaps.push_back(std::move(over));
    }
  }

  /// Of all choices of whatever else varies. Widths do not, so that those given are the same for all.
  void put_together() {
    RecordNeeds all;
    for (const RecordNeeds& one : result_.needs) {
      all.records.insert(all.records.end(), one.records.begin(), one.records.end());
    }
    tell_quantiles(all);
    for (std::size_t gap = 0; gap < all.gaps.size(); ++gap) {
      all.gaps[gap].given = result_.needs.front().gaps[gap].given;
      for (std::size_t i = 0; i < all.gaps[gap].given.size(); ++i) {
        all.gaps[gap].given[i].beyond = 0;
        for (const RecordNeeds& one : result_.needs) {
          all.gaps[gap].given[i].beyond += one.gaps[gap].given.at(i).beyond;
        }
      }
    }
    result_.together = std::move(all);
  }

  /// How many records need more than is given, for every choice of widths.
  void compare_with_given(const AxisSubset& widths, std::vector<Choice> choices, RecordNeeds& needs) {
    for (std::size_t number = 0; number < widths.combinations(); ++number) {
      widths.choose(number, choices);
      Diagnostics found;
      const ReadCase read = case_of(choices, found);
      if (!found.ok()) throw std::runtime_error(first_message(found));
      const Problem problem = read.problem();
      for (Eigen::Index gap = 0; gap < std::ssize(needs.gaps); ++gap) {
        GivenGap given;
        given.others = values_along(widths, choices);
        const Gap between = gap_at(problem, gap);
        for (const std::size_t i : between.points) given.widths.push_back(problem.points[i].width);
        if (given.widths.empty()) {
          for (const std::size_t i : between.watched) given.widths.push_back(problem.watched[i].width);
        }
        for (const RecordNeed& record : needs.records) {
          given.beyond += needs_more(record, problem, gap) ? 1 : 0;
        }
        needs.gaps[gap].given.push_back(std::move(given));
      }
    }
  }

  static bool needs_more(const RecordNeed& record, const Problem& given, Eigen::Index gap) {
    const std::vector<LevelSeparation> levels = of_gap(record.separations, gap);
    const std::vector<FacingLevel> now = facing_levels(given, gap);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (levels[i].gap_needed > now.at(i).width) return true;
    }
    return false;
  }

  [[nodiscard]] ReadCase case_of(const std::vector<Choice>& choices, Diagnostics& found) const {
    TomlValue root = chosen_case(study_, choices);
    if (study_.ida) put_intensity(facts_.intensities, choices, *result_.at, root);
    return read_chosen(study_, root, memo_, found);
  }

  /// A label without quotes, or the number.
  static std::string value_text(const Vary& vary, const Choice& choice) {
    return vary.labels.empty() ? fmt::format("{}", *chosen_number(vary, choice)) : vary.labels[choice.level];
  }

  [[nodiscard]] std::string record_name(const std::vector<Choice>& choices, const AxisSubset& records,
                                        const ReadCase& read) const {
    std::string name;
    for (const Vary& vary : study_.varies) {
      if (!records.has(vary.axis) || vary.labels.empty()) continue;
      name += (name.empty() ? "" : ", ") + value_text(vary, choices[vary.axis]);
    }
    if (!name.empty()) return name;
    return read.c.excitation.record ? std::filesystem::path(read.c.excitation.record->file).filename().string()
                                    : "ground motion";
  }

  [[nodiscard]] RecordNeed need(const std::vector<Choice>& choices, const AxisSubset& records) {
    Diagnostics found;
    const ReadCase read = case_of(choices, found);
    const std::string record = record_name(choices, records, read);
    if (!found.ok()) throw std::runtime_error(record + ": " + first_message(found));
    const Problem problem = read.problem();
    const FreeResponse free(problem, read.c.analysis.solver, {}, static_cast<long>(read.c.analysis.limits.steps), true);
    const Response& response = free.response();
    if (response.status != Status::done && response.status != Status::collapsed)
      throw std::runtime_error(record + ": " + response.message);
    RecordNeed result{record, separations(problem, response, read.c.code, read.c.units), {}};
    for (const Gap& gap : gaps_of(problem)) result.gaps.push_back(need_of(result.separations, gap));
    if (result_.title.empty() && result_.needs.empty()) {
      result_.title = read.c.title;
      result_.code = read.c.code;
    }
    return result;
  }

  const Study& study_;
  const StudyFacts& facts_;
  CaseMemo& memo_;
  GapStudy& result_;
};

}  // namespace

bool is_study(const std::filesystem::path& file) {
  Diagnostics ignored;
  const auto text = read_input(file, study_input, ignored);
  const auto root = text ? parse_toml(*text, file.string(), ignored) : std::nullopt;
  return root && root->find("case") != nullptr;
}

std::optional<GapStudy> gap_study(const std::filesystem::path& file, std::optional<double> at,
                                  const std::function<void(double)>& progress, Diagnostics& diagnostics) {
  const auto study = read_study(file, diagnostics);
  if (!study) return std::nullopt;
  const auto refuse = [&](const std::string& why) {
    diagnostics.error({file.string(), 0, 0}, why);
    return std::nullopt;
  };
  if (study->sampling.method != Sampling::Method::grid) {
    return refuse("[sampling] draws single runs: bentur gap needs a study whose runs are a grid");
  }
  if (at && !study->ida) return refuse("--at needs [ida], which says how intensity is measured");
  CaseMemo memo;
  const auto facts = check_study(*study, memo, diagnostics);
  if (!facts) return std::nullopt;
  GapStudy result;
  result.units = facts->units;
  result.problem = facts->problem;
  if (study->ida) {
    result.at = at.value_or(study->ida->levels.back());
    result.intensity = intensity_name(*study->ida);
    result.intensity_unit = study->ida->unit.empty() ? facts->units.length + "/s2" : study->ida->unit;
  }
  Work(*study, *facts, memo, result).run(progress);
  return result;
}

}  // namespace bentur
