#include "bentur/study/gap/gap_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "bentur/io/input_file.h"
#include "bentur/model/judgement/compare.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/study/design/study_check.h"
#include "bentur/study/gap/record_need.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

/// Of records: the median plus and minus a standard deviation of a lognormal variable, and what codes and engineers ask
/// for.
constexpr double told_quantiles[] = {0.16, 0.5, 0.84, 0.9, 0.95};

/// The largest of the levels of a gap.
GapNeed need_of(const std::vector<LevelSeparation>& separations, Eigen::Index gap) {
  const LevelSeparation largest = largest_of(of_gap(separations, gap));
  GapNeed need{largest.gap_needed, largest.abs, largest.srss, largest.ddc, {}};
  for (const CodeSeparation& code : largest.codes) need.codes.push_back(code.gap);
  return need;
}

/// Of a record under which a building falls without contact no gap would do, and no rule has anything to go by.
void take_as_fallen(GapNeed& need) {
  need.gap_needed = std::numeric_limits<double>::infinity();
  need.abs = need.srss = need.ddc = not_known;
  std::fill(need.codes.begin(), need.codes.end(), not_known);
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

/// Each number by itself: over the records, of the larger way of each.
GapNeed mean_of_needs(const RecordNeeds& needs, Eigen::Index gap) {
  std::map<std::size_t, GapNeed> motions;
  for (const RecordNeed& record : needs.records) {
    const GapNeed& one = record.gaps[gap];
    const auto [known, is_new] = motions.try_emplace(record.motion, one);
    if (is_new) continue;
    const auto raise = [](double& value, double other) { value = std::isnan(other) ? other : std::max(value, other); };
    for (const auto number : single_numbers) raise(known->second.*number, one.*number);
    for (std::size_t i = 0; i < one.codes.size(); ++i) raise(known->second.codes[i], one.codes[i]);
  }
  const auto count = static_cast<double>(motions.size());
  GapNeed result;
  result.codes.assign(needs.records.front().gaps[gap].codes.size(), 0.0);
  for (const auto& [motion, need] : motions) {
    for (const auto number : single_numbers) result.*number += need.*number / count;
    for (std::size_t i = 0; i < result.codes.size(); ++i) result.codes[i] += need.codes[i] / count;
  }
  if (std::isinf(result.gap_needed)) result.gap_needed = not_known;
  return result;
}

using Named = std::vector<std::pair<std::string, std::string>>;

/// A case as a row, of buildings in plan that of its gaps.
Problem row_of(const ReadCase& read) { return read.plan ? bentur::row_of(*read.plan) : read.problem(); }

class Work {
 public:
  /// @param row facts.problem, of buildings in plan row_of() theirs
  Work(const Study& study, const StudyFacts& facts, const Problem& row, CaseMemo& memo, GapStudy& result)
      : study_(study), facts_(facts), row_(row), memo_(memo), result_(result) {}

  void run(const std::function<bool(double)>& progress) {
    const std::vector<SweepAxis> axes = design_axes(study_);
    const AxisSubset records = record_axes(study_);
    const AxisSubset widths = subset(axes, [&](std::size_t axis) { return axes[axis].inner && sets_widths(axis); });
    const AxisSubset others = subset(axes, [&](std::size_t axis) {
      const bool is_level = study_.ida && axis == study_.ida->axis;
      return !records.has(axis) && !is_level && !axes[axis].inner;
    });
    const std::size_t blocks = others.combinations(), each = records.combinations();
    result_.asked = static_cast<long>(blocks * each);
    bool goes_on = true;
    for (std::size_t block = 0; block < blocks && goes_on; ++block) {
      std::vector<Choice> choices(axes.size());
      others.choose(block, choices);
      RecordNeeds needs;
      needs.others = values_along(others, choices);
      for (std::size_t record = 0; record < each && goes_on; ++record) {
        records.choose(record, choices);
        needs.records.push_back(need(choices, records));
        goes_on =
            progress(static_cast<double>(++result_.done) / static_cast<double>(result_.asked)) || result_.is_whole();
      }
      tell_quantiles(needs);
      compare_with_given(widths, choices, needs);
      const bool is_suite = study_.suite && !study_.ida && needs.records.size() == study_.suite->records.size();
      if (is_suite) tell_demand(needs);
      tell_rules(needs, is_suite ? suite_measure(*study_.suite) : SuiteMeasure());
      result_.needs.push_back(std::move(needs));
    }
    if (result_.needs.size() > 1) put_together();
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
    for (Eigen::Index gap = 0; gap < std::ssize(result_.gaps); ++gap) {
      GapOverRecords over{.largest = quantile_of_needs(needs, gap, 1),
                          .median = quantile_of_needs(needs, gap, 0.5),
                          .mean = mean_of_needs(needs, gap),
                          .quantiles = {},
                          .given = {}};
      for (const double p : told_quantiles) over.quantiles.push_back({p, quantile_of_needs(needs, gap, p)});
      needs.gaps.push_back(std::move(over));
    }
  }

  /// Of all choices of whatever else varies.
  void put_together() {
    RecordNeeds all;
    for (const RecordNeeds& one : result_.needs) {
      all.records.insert(all.records.end(), one.records.begin(), one.records.end());
    }
    tell_quantiles(all);
    for (std::size_t gap = 0; gap < all.gaps.size(); ++gap) {
      all.gaps[gap].given = result_.needs.front().gaps[gap].given;
      const auto given_alike = [&](const RecordNeeds& one) {
        return std::equal(one.gaps[gap].given.begin(), one.gaps[gap].given.end(), all.gaps[gap].given.begin(),
                          [](const GivenGap& a, const GivenGap& b) { return a.widths == b.widths; });
      };
      if (!std::all_of(result_.needs.begin(), result_.needs.end(), given_alike)) all.gaps[gap].given.clear();
      for (std::size_t i = 0; i < all.gaps[gap].given.size(); ++i) {
        GivenGap& given = all.gaps[gap].given[i];
        given.beyond = 0;
        given.open = {};
        for (const RecordNeeds& one : result_.needs) {
          given.beyond += one.gaps[gap].given.at(i).beyond;
          given.open.add(one.gaps[gap].given.at(i).open);
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
      const ReadCase chosen = case_of(choices, found);
      if (!found.ok()) throw std::runtime_error(first_message(found));
      const Problem problem = row_of(chosen);
      for (Eigen::Index gap = 0; gap < std::ssize(needs.gaps); ++gap) {
        GivenGap given;
        given.others = values_along(widths, choices);
        const Gap between = gap_at(problem, gap);
        for (const std::size_t i : between.points) given.widths.push_back(problem.points[i].width);
        if (given.widths.empty()) {
          for (const std::size_t i : between.watched) given.widths.push_back(problem.watched[i].width);
        }
        const std::vector<FacingLevel> levels = facing_levels(problem, gap);
        for (const RecordNeed& record : needs.records) {
          const bool is_beyond = !levels.empty() && (record.falls || needs_more(record, gap, levels));
          given.beyond += is_beyond ? 1 : 0;
          if (!is_beyond) given.open.add(levels.empty() ? 0 : still_open(record, gap, levels));
        }
        needs.gaps[gap].given.push_back(std::move(given));
      }
    }
  }

  /// What the code that scales the suite takes of its records.
  void tell_demand(RecordNeeds& needs) const {
    const SuiteMeasure measure = suite_measure(*study_.suite);
    if (measure.code.empty()) return;
    const auto count = static_cast<double>(needs.records.size());
    for (Eigen::Index gap = 0; gap < std::ssize(needs.gaps); ++gap) {
      if (needs.gaps[gap].given.size() != 1) continue;
      SuiteDemand demand{.measure = measure};
      const bool is_mean = measure.kind == SuiteMeasure::Kind::mean;
      const std::vector<FacingLevel> given = facing_levels(row_, gap);
      for (std::size_t level = 0; level < given.size(); ++level) {
        double mean = 0, largest = 0;
        for (const RecordNeed& record : needs.records) {
          const double need = of_gap(record.separations, gap).at(level).gap_needed;
          mean += need / count;
          largest = std::max(largest, need);
        }
        const double taken = is_mean ? mean : largest;
        if (level == 0 || taken > demand.taken()) demand.elevation = given[level].elevation;
        demand.mean = std::max(demand.mean, mean);
        demand.largest = std::max(demand.largest, largest);
        demand.is_short = demand.is_short || is_below_target(given[level].width, taken, largest);
      }
      for (std::size_t rule = 0; rule < needs.records.front().gaps[gap].codes.size(); ++rule) {
        double mean = 0, largest = 0;
        for (const RecordNeed& record : needs.records) {
          mean += record.gaps[gap].codes[rule] / count;  // NaN where one is not known
          largest = std::max(largest, record.gaps[gap].codes[rule]);
        }
        demand.codes.push_back(is_mean || std::isnan(mean) ? mean : largest);
      }
      demand.collapsed = std::count_if(needs.records.begin(), needs.records.end(),
                                       [](const RecordNeed& record) { return record.falls; });
      needs.gaps[gap].demand = std::move(demand);
    }
  }

  /// What each rule of [code] asks of all records. @param measure of the code that scales them
  void tell_rules(RecordNeeds& needs, const SuiteMeasure& measure) const {
    const bool takes_mean = measure.kind == SuiteMeasure::Kind::mean;
    const bool too_few = !measure.code.empty() && measure.kind == SuiteMeasure::Kind::too_few;
    const auto count = static_cast<double>(needs.records.size());
    for (Eigen::Index gap = 0; gap < std::ssize(needs.gaps); ++gap) {
      GapOverRecords& over = needs.gaps[gap];
      if (over.given.size() != 1 || needs.records.empty()) continue;
      const std::vector<LevelSeparation> levels = of_gap(needs.records.front().separations, gap);
      for (std::size_t rule = 0; rule < result_.code.rules.size(); ++rule) {
        const CodeRule& code = *find_code_rule(result_.code.rules[rule].rule);
        RuleOverRecords found{.rule = std::string(code.name),
                              .title = std::string(code.title),
                              .takes_mean = takes_mean,
                              .too_few = too_few};
        double most = -std::numeric_limits<double>::infinity();
        bool is_known = !levels.empty();
        for (std::size_t i = 0; i < levels.size(); ++i) {
          double asked = 0;
          for (const RecordNeed& record : needs.records) {
            const double one = record.falls ? not_known : of_gap(record.separations, gap).at(i).codes[rule].gap;
            asked = std::isnan(one) ? one : takes_mean ? asked + one / count : std::max(asked, one);
            if (std::isnan(one)) break;
          }
          const FacingLevel& level = levels[i].level;
          is_known = is_known && !std::isnan(asked);
          if (!(asked - level.width >= most)) continue;
          most = asked - level.width;
          found.asked = asked;
          found.elevation = level.elevation;
          found.width = level.width;
          found.is_short = is_below_target(level.width, asked, asked);
        }
        if (!is_known && !found.is_short) found.asked = not_known;
        over.rules.push_back(std::move(found));
      }
    }
  }

  static bool needs_more(const RecordNeed& record, Eigen::Index gap, const std::vector<FacingLevel>& given) {
    const std::vector<LevelSeparation> needed = of_gap(record.separations, gap);
    for (std::size_t i = 0; i < needed.size(); ++i) {
      if (is_below_target(given.at(i).width, needed[i].gap_needed, needed[i].gap_needed)) return true;
    }
    return false;
  }

  /// What keeps it from being known that a record needs no more than is given; bits of OpenNeed.
  static std::uint64_t still_open(const RecordNeed& record, Eigen::Index gap, const std::vector<FacingLevel>& given) {
    const auto left = static_cast<std::uint64_t>(OpenNeed::motion_left);
    const std::uint64_t others = record.open & ~left;
    std::size_t level = 0;
    for (std::size_t i = 0; i < record.separations.size(); ++i) {
      if (record.separations[i].level.gap != gap) continue;
      const double scale = record.separations[i].gap_needed;  // what may come has no end where the record goes on
      if (more_may_come(record.to_come.at(i), given.at(level++).width, scale)) return others | left;
    }
    return others;
  }

  [[nodiscard]] ReadCase case_of(const std::vector<Choice>& choices, Diagnostics& found) const {
    TomlValue root = chosen_case(study_, choices);
    if (result_.at) put_intensity(facts_.intensities, choices, *result_.at, root);
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
    for (const ExcitationSpec* const one : read.c.excitations()) {
      if (one->record) return std::filesystem::path(one->record->file).filename().string();
    }
    return "ground motion";
  }

  [[nodiscard]] RecordNeed need(const std::vector<Choice>& choices, const AxisSubset& records) {
    Diagnostics found;
    const ReadCase chosen = case_of(choices, found);
    const std::string record = record_name(choices, records, chosen);
    if (!found.ok()) throw std::runtime_error(record + ": " + first_message(found));
    RecordNeed result = need_of_record(record, chosen, takes_both_ways_ && chosen.c.analysis.both_ways);
    for (std::size_t i = 0; i < result.separations.size(); ++i) {
      // What is bounded is held against widths, still_open().
      if (comes_without_bound(result.to_come.at(i))) result.open |= static_cast<unsigned>(OpenNeed::motion_left);
    }
    result.motion = record_axes(study_, false).place(choices);
    if (study_.ida && study_.ida->is_cloud) {
      result.intensity = facts_.intensities.values[facts_.intensities.place(choices)];
    }
    for (Eigen::Index gap = 0; gap < std::ssize(result_.gaps); ++gap) {
      result.gaps.push_back(need_of(result.separations, gap));
      if (result.falls && !of_gap(result.separations, gap).empty()) take_as_fallen(result.gaps.back());
    }
    if (result_.title.empty() && result_.needs.empty()) {
      result_.title = chosen.c.title;
      result_.code = chosen.c.code;
      result_.of_either_way = takes_both_ways_ && chosen.c.analysis.both_ways;
    }
    (acts_reversed(chosen.c) ? some_reversed_ : some_as_recorded_) = true;
    result_.is_one_way =
        chosen.c.analysis.both_ways && !result_.of_either_way && !(some_reversed_ && some_as_recorded_);
    return result;
  }

  const Study& study_;
  const StudyFacts& facts_;
  const Problem& row_;
  CaseMemo& memo_;
  GapStudy& result_;
  bool some_reversed_ = false, some_as_recorded_ = false;
  /// Of the records of a suite, unless the study says which way they are applied.
  const bool takes_both_ways_ =
      study_.suite != nullptr && std::none_of(study_.varies.begin(), study_.varies.end(), [](const Vary& vary) {
        return vary.path == ParameterPath{"excitation", "polarity"};
      });
};

std::optional<GapStudy> gap_study_of(const Study& study, std::optional<double> at,
                                     const std::function<bool(double)>& progress, Diagnostics& diagnostics) {
  CaseMemo memo;
  const auto facts = check_study(study, memo, diagnostics);
  if (!facts) return std::nullopt;
  GapStudy result;
  result.units = facts->units;
  result.in_plan = facts->plan.has_value();
  result.buildings = building_names(*facts);
  const Problem row = facts->plan ? bentur::row_of(*facts->plan) : facts->problem;
  for (const Gap& gap : gaps_of(row)) result.gaps.push_back({gap_name(row, gap.number), gap.left, gap.right});
  result.suite = study.suite;
  if (study.ida) {
    if (!study.ida->is_cloud) result.at = at.value_or(study.ida->levels.back());
    result.intensity = intensity_name(*study.ida);
    result.intensity_unit = study.ida->unit.empty() ? facts->units.length + "/s2" : study.ida->unit;
  }
  Work(study, *facts, row, memo, result).run(progress);
  return result;
}

}  // namespace

bool is_study(const std::filesystem::path& file) {
  Diagnostics ignored;
  const auto text = read_input(file, study_input, ignored);
  const auto root = text ? parse_toml(*text, file.string(), ignored) : std::nullopt;
  return root && root->find("case") != nullptr;
}

std::optional<GapStudy> gap_study(const std::filesystem::path& file, std::optional<double> at,
                                  const std::function<bool(double)>& progress, Diagnostics& diagnostics) {
  auto study = read_study(file, diagnostics);
  if (!study) return std::nullopt;
  const auto refuse = [&](const std::string& why) {
    diagnostics.error({file.string(), 0, 0}, why);
    return std::nullopt;
  };
  if (study->remedy) return refuse("[remedy] is for bentur remedy: bentur gap needs a study without it");
  if (study->sampling.method != Sampling::Method::grid && !draw_together(*study)) {
    return refuse("[sampling] has no records to draw from: bentur gap needs a [[vary]] with files, or a suite");
  }
  if (at && !study->ida) return refuse("--at needs [ida], which says how intensity is measured");
  if (at && study->ida->is_cloud) return refuse("--at scales records, which are \"unscaled\" by [ida]");
  return gap_study_of(*study, at, progress, diagnostics);
}

std::optional<GapStudy> gap_study(const Case& c, const std::filesystem::path& file,
                                  const std::function<bool(double)>& progress, Diagnostics& diagnostics) {
  Study plain;
  plain.file = plain.case_file = file;
  plain.case_root = *c.given;
  plain.suite = c.excitation.suite;
  const auto study = read_study(TomlValue(), std::move(plain), diagnostics);
  return study ? gap_study_of(*study, std::nullopt, progress, diagnostics) : std::nullopt;
}

}  // namespace bentur
