#include "bentur/io/results/result_variable.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "bentur/model/case.h"

namespace bentur {

std::vector<ResultAttribute> file_attributes(const std::string& title, const std::string& source,
                                             std::string_view version) {
  return {{"Conventions", "CF-1.8"},
          {"title", title},
          {"source", source},
          {"history", fmt::format("{} {}", result_history, version)},
          {"bentur_version", std::string(version)}};
}

std::vector<ResultAttribute> run_attributes(const Case& c, const std::string& source, std::string_view version) {
  std::vector<ResultAttribute> all =
      file_attributes(c.title, fmt::format("{}, solver {}", source, name(c.analysis.solver)), version);
  if (!c.source) return all;
  all.push_back({"case_file", c.source->file});
  all.push_back({"case_sha256", c.source->sha256});
  if (c.source->text.size() <= longest_text) all.push_back({"case", c.source->text});
  return all;
}

void name_coordinates(ResultVariable& variable, const std::string& more) {
  std::string names = more;
  for (const ResultDimension& dimension : variable.dimensions) {
    if (!dimension.coordinates.empty()) names += (names.empty() ? "" : " ") + dimension.coordinates;
  }
  std::istringstream words(names);
  for (std::string word; words >> word;) {
    if (word == variable.name) return;  // is one itself
  }
  if (!names.empty()) variable.attributes.push_back({"coordinates", names});
}

const StoredVariable* ResultSource::find(std::string_view variable) const noexcept {
  const std::vector<StoredVariable>& all = variables();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == variable; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace bentur
