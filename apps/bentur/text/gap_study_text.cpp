#include "text/gap_study_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

/// A row a record, where they are to be told, and what holds over all of them.
std::string gap_table(const GapStudy& study, const RecordNeeds& needs, std::size_t gap, bool with_records) {
  std::vector<std::string> names;
  std::vector<const GapNeed*> rows;
  for (const RecordNeed& record : needs.records) {
    if (!with_records) break;
    names.push_back(record.record);
    rows.push_back(&record.gaps[gap]);
  }
  const GapOverRecords& over = needs.gaps[gap];
  if (needs.records.size() > 1) {
    names.emplace_back("◄ largest");
    rows.push_back(&over.largest);
    for (auto one = over.quantiles.rbegin(); one != over.quantiles.rend(); ++one) {
      names.push_back(one->probability == 0.5 ? "◄ median" : fmt::format("◄ {:.4g} %", 100 * one->probability));
      rows.push_back(&one->need);
    }
  }
  const auto numbers = [&](auto value) {
    std::vector<double> result;
    for (const GapNeed* row : rows) result.push_back(value(*row));
    return result;
  };
  const std::string& length = study.units.length;
  Table table;
  table.add(with_records ? "record" : "", "", names);
  table.add("simulated", length, numbers([](const GapNeed& n) { return n.gap_needed; }));
  table.add("ABS", length, numbers([](const GapNeed& n) { return n.abs; }));
  table.add("SRSS", length, numbers([](const GapNeed& n) { return n.srss; }));
  table.add("DDC", length, numbers([](const GapNeed& n) { return n.ddc; }));
  for (std::size_t i = 0; i < study.code.rules.size(); ++i) {
    table.add(std::string(find_code_rule(study.code.rules[i].rule)->title), length,
              numbers([i](const GapNeed& n) { return n.codes[i]; }));
  }
  return table.text();
}

/// How many records need more than the gap that is given, for each width that the study gives it.
std::string given_text(const GapStudy& study, const RecordNeeds& needs, std::size_t gap, const std::string& what) {
  const std::vector<GivenGap>& given = needs.gaps[gap].given;
  const std::size_t records = needs.records.size();
  const auto share = [&](const GivenGap& one) {
    return fmt::format("{:.3g} %", 100.0 * static_cast<double>(one.beyond) / static_cast<double>(records));
  };
  const auto width = [](const GivenGap& one) { return *std::min_element(one.widths.begin(), one.widths.end()); };
  if (given.size() == 1) {
    return fmt::format("\n{} of {} {} ({}) need more than the {} {} given.\n", given[0].beyond, records, what,
                       share(given[0]), number(width(given[0])), study.units.length);
  }
  std::vector<double> widths;
  std::vector<std::string> beyond, shares;
  for (const GivenGap& one : given) {
    widths.push_back(width(one));
    beyond.push_back(fmt::format("{} of {}", one.beyond, records));
    shares.push_back(share(one));
  }
  Table table;
  table.add("given", study.units.length, widths);
  table.add(what + " that need more", "", beyond);
  table.add("share", "", shares);
  return "\n" + table.text();
}

/// The gaps over everything that varies.
std::string together_text(const GapStudy& study, const RecordNeeds& together) {
  std::string text;
  for (Eigen::Index gap = 0; gap < std::ssize(together.gaps); ++gap) {
    text += fmt::format("\n{}: all {} of these together, each as likely as the others\n\n",
                        gap_name(study.problem, gap), together.records.size()) +
            gap_table(study, together, gap, false) + given_text(study, together, gap, "runs");
  }
  return text;
}

}  // namespace

std::string gap_study_text(const GapStudy& study) {
  std::string text = study.title.empty() ? "" : study.title + "\n";
  if (study.at) {
    text +=
        fmt::format("Every record scaled to {} {} of {}\n", number(*study.at), study.intensity_unit, study.intensity);
  }
  for (const RecordNeeds& needs : study.needs) {
    std::string others;
    for (const auto& [name, value] : needs.others) {
      others += fmt::format("{}{} = {}", others.empty() ? "" : ", ", name, value);
    }
    for (Eigen::Index gap = 0; gap < std::ssize(needs.gaps); ++gap) {
      text += fmt::format("\n{}{}\n\n", gap_name(study.problem, gap), others.empty() ? "" : ": " + others) +
              gap_table(study, needs, gap, true) + given_text(study, needs, gap, "records");
    }
  }
  if (study.together) text += together_text(study, *study.together);
  text += "\n" +
          wrapped(
              "Each number is the largest of all levels at which the buildings face one another, floors that face a "
              "column included. Simulated: the buildings moving freely. ABS, SRSS, DDC: sum, root of squares and "
              "double-difference combination of their peak displacements. 84 %: what 84 % of the records do not need "
              "more than, each column by itself.") +
          "\n";
  if (!study.code.rules.empty()) {
    text += "Codes: the same peaks, amplified by the factors of [code]; clauses: bentur gap with the case.\n";
  }
  return text;
}

}  // namespace bentur::cli
