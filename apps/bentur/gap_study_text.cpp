#include "gap_study_text.h"

#include <fmt/format.h>

#include <vector>

#include "session.h"
#include "table.h"

namespace bentur::cli {
namespace {

std::string gap_table(const GapStudy& study, const RecordNeeds& needs, std::size_t gap) {
  std::vector<std::string> names;
  std::vector<const GapNeed*> rows;
  for (const RecordNeed& record : needs.records) {
    names.push_back(record.record);
    rows.push_back(&record.gaps[gap]);
  }
  if (rows.size() > 1) {
    names.emplace_back("◄ largest");
    rows.push_back(&needs.largest[gap]);
    names.emplace_back("◄ median");
    rows.push_back(&needs.median[gap]);
  }
  const auto numbers = [&](auto value) {
    std::vector<double> result;
    for (const GapNeed* row : rows) result.push_back(value(*row));
    return result;
  };
  const std::string& length = study.units.length;
  Table table;
  table.add("record", "", names);
  table.add("simulated", length, numbers([](const GapNeed& n) { return n.simulated; }));
  table.add("ABS", length, numbers([](const GapNeed& n) { return n.abs; }));
  table.add("SRSS", length, numbers([](const GapNeed& n) { return n.srss; }));
  table.add("DDC", length, numbers([](const GapNeed& n) { return n.ddc; }));
  for (std::size_t i = 0; i < study.code.rules.size(); ++i) {
    table.add(std::string(find_code_rule(study.code.rules[i].rule)->title), length,
              numbers([i](const GapNeed& n) { return n.codes[i]; }));
  }
  return table.text();
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
    for (std::size_t gap = 0; gap < needs.largest.size(); ++gap) {
      text += fmt::format("\n{}{}\n\n", gap_name(study.problem, static_cast<int>(gap)),
                          others.empty() ? "" : ": " + others) +
              gap_table(study, needs, gap);
    }
  }
  text +=
      "\nEach number is the largest of the contact points of that gap. Simulated: the buildings moving freely. ABS, "
      "SRSS,\n"
      "DDC: sum, root of squares and double-difference combination of their peak displacements.\n";
  if (!study.code.rules.empty()) {
    text += "Codes: the same peaks, amplified by the factors of [code]; clauses: bentur gap with the case.\n";
  }
  return text;
}

}  // namespace bentur::cli
