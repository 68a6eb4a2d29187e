#include "bentur/report/scene/names.h"

#include <algorithm>
#include <set>

#include "bentur/report/utf8.h"

namespace bentur {

std::vector<std::string> building_names(const PlanProblem& problem) {
  std::vector<std::string> names;
  for (const PlanBuilding& building : problem.buildings) names.push_back(building.name);
  return names;
}

std::vector<std::string> short_names(const std::vector<std::string>& names) {
  constexpr std::size_t longest = 9;  // characters
  std::size_t shared = 0;             // of the names, behind a space
  if (names.size() > 1) {
    const std::string& first = names.front();
    for (std::size_t space = first.find(' '); space != std::string::npos; space = first.find(' ', space + 1)) {
      const auto begins_so = [&](const std::string& one) {
        return one.size() > space + 1 && one.compare(0, space + 1, first, 0, space + 1) == 0;
      };
      if (!std::all_of(names.begin(), names.end(), begins_so)) break;
      shared = space + 1;
    }
  }
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back(name.substr(shared));
  const auto is_long = [](const std::string& name) { return characters(name).size() > longest; };
  const bool are_distinct = std::set<std::string>(all.begin(), all.end()).size() == all.size();
  if (!are_distinct || std::any_of(all.begin(), all.end(), is_long)) {
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::to_string(i + 1);
  }
  return all;
}

bool are_parts_of(const std::vector<std::string>& in_short, const std::vector<std::string>& names) {
  return std::equal(names.begin(), names.end(), in_short.begin(), in_short.end(),
                    [](const std::string& name, const std::string& one) { return name.ends_with(one); });
}

}  // namespace bentur
