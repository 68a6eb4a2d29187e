#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/model/quantity_row.h"
#include "bentur/study/design/record_intensity.h"
#include "bentur/study/design/study.h"
#include "bentur/study/design/sweep_design.h"

namespace bentur {

/// What trying out a study has shown.
struct StudyFacts {
  Problem problem;  ///< of the first choice along every axis; of buildings in plan empty
  std::optional<PlanProblem> plan;
  Units units;
  std::string title;
  bool energy_audit = false;
  std::map<std::string, std::string> records;  ///< file name of every record, and of factors, to its SHA-256
  std::set<std::string> record_files;          ///< where they are
  bool floors_move = false;                    ///< elevations of floors differ between runs
  bool points_move = false;                    ///< places of contact points differ between runs
  bool links_move = false;                     ///< elevations of links do
  bool bearings_move = false;                  ///< places of bearings do
  bool planes_turn = false;                    ///< directions of planes do
  RecordIntensities intensities;               ///< with [ida]
};

/// Calls with each number below a count, in any order, be it by many threads at once.
using ForEachNumber = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;
void one_after_the_other(std::size_t count, const std::function<void(std::size_t)>& work);

/// Reads a case that a study has made; what is wrong goes to `found`.
[[nodiscard]] ReadCase read_chosen(const Study& study, const TomlValue& root, CaseMemo& memo, Diagnostics& found);

/// Tries the values of a study in its case, one axis after the other with the others at their first choice: values
/// given one by one, the ends of a range, the ends of a distribution's support (extremes()). So a key that the case
/// does not know, a value out of its range and a distribution that can give one are found before anything is run.
/// @param for_each tries values where there are many; what is found does not depend on its order
/// @return nothing where there was an error; all of them are in `diagnostics`, with their place in study, case or
/// record. With [ida] the intensity of every record is found too; of a combination that makes no case it is NaN.
[[nodiscard]] std::optional<StudyFacts> check_study(const Study& study, CaseMemo& memo, Diagnostics& diagnostics,
                                                    const ForEachNumber& for_each = one_after_the_other);

/// What is kept of each of its runs, as a row or in plan.
[[nodiscard]] std::vector<RowPart> quantities_of(const StudyFacts& facts);
[[nodiscard]] std::vector<std::string> building_names(const StudyFacts& facts);

/// Whether the buildings, points and links of another problem are as many as those of the first run, so that both have
/// rows alike; where they stand elsewhere the facts say so from now on.
[[nodiscard]] bool take_places(const Problem& other, StudyFacts& facts);
[[nodiscard]] bool take_places(const PlanProblem& other, StudyFacts& facts);

/// The axes as a design takes them: runs that differ in gap widths and contacts alone share the response without
/// contact, unless delays are reckoned from the widths. @param places so may those in plan that differ in where
/// buildings stand
[[nodiscard]] std::vector<SweepAxis> design_axes(const Study& study, bool places = false);

/// The message of an error about a case made by a study, without its place in a file.
[[nodiscard]] std::string first_message(const Diagnostics& diagnostics);

}  // namespace bentur
