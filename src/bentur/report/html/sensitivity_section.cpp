#include <algorithm>
#include <map>
#include <variant>

#include "bentur/io/schema/case_keys.h"
#include "bentur/io/toml/parameter_path.h"
#include "bentur/report/html/internal/echo.h"
#include "bentur/report/kinds/sensitivity_figure.h"

namespace bentur::html {
namespace {

/// A number of a case in the words of its keys: "Annex, Frame: Storey heights 6" is
/// building[1].frame.storey_heights[5]. In plan the width of a gap is called as it is beside the name of the gap.
/// @param unit of its value, where it has one
std::string number_in_words(const std::string& path, const Case& c, const Words& say, std::string& unit) {
  unit.clear();
  if (constexpr std::string_view width = ": width"; path.ends_with(width)) {
    const Key* const key = case_keys().find("gap")->table->find("width");
    unit = c.units.length;
    return path.substr(0, path.size() - width.size()) + ": " + label_text(key->label, say);
  }
  std::string error, text;
  const std::optional<ParameterPath> steps = parse_path(path, error);
  const KeyTable* keys = &case_keys();
  for (std::size_t i = 0; steps && i < steps->size(); ++i) {
    if (const auto* const place = std::get_if<std::size_t>(&(*steps)[i])) {
      text += " " + std::to_string(*place + 1);
      continue;
    }
    const auto& name = std::get<std::string>((*steps)[i]);
    const auto* const place = i + 1 < steps->size() ? std::get_if<std::size_t>(&(*steps)[i + 1]) : nullptr;
    const Key* const key = keys != nullptr ? keys->find(name) : nullptr;
    const bool is_building = std::any_of(c.buildings.begin(), c.buildings.end(),
                                         [&](const auto& building) { return building.name == name; });
    if (key == nullptr && is_building) {  // of what has a table by buildings
      text += (text.empty() ? "" : ", ") + name;
      keys = nullptr;
      continue;
    }
    if (key == nullptr) return path;
    if (i == 0 && name == "building" && place != nullptr && *place < c.buildings.size()) {
      text = c.buildings[*place].name;
      ++i;
    } else {
      text += (text.empty() ? "" : i == 2 ? ", " : ": ") + label_text(key->label, say);
    }
    keys = key->table;
    if (keys == nullptr) unit = unit_of(*key, c.units);
  }
  return text.empty() ? path : text;
}

}  // namespace

PageSection sensitivity_section(const std::optional<Sensitivity>& found, const Case& c, const Words& say,
                                const std::string& language) {
  if (!found) return {"sensitivity", {}, {}};
  Sensitivity told = *found;
  std::map<std::string, std::string> paths, units;  // by their words
  std::string unit;
  for (CaseNumber& number : told.numbers) {
    const std::string words = number_in_words(number.path, c, say, unit);
    if (paths.try_emplace(words, number.path).second) number.path = words;  // two numbers have not the same
    units.try_emplace(number.path, unit);
  }
  for (auto& [path, why] : told.left_out) path = number_in_words(path, c, say, unit);
  const Story story = sensitivity_story(told);
  Html sentences;
  for (const SaidStatement& one : said(story.statements, say)) sentences += element("li", one.text);
  Html content = element("p", say("sensitivity.lead"), "class=\"lead\"") + element("ul", sentences);
  try {
    bool is_single = false;
    const auto make = [&](const FigureOptions& drawn) {
      Figure one = sensitivity_figure(told, drawn);
      is_single = one.panels.size() == 1;
      return one;
    };
    const Html figure = opening_figure(make, say("figure.sensitivity"), language);
    content += is_single ? element("div", figure, "class=\"single\"") : figure;
  } catch (const NoFigure&) {  // of buildings alone there is a table
  }
  for (const StoryTable& table : story.tables) {
    SaidTable shown = said(table, say);
    std::vector<std::string> titles;
    for (std::size_t row = 0; row < shown.columns.front().cells.size(); ++row) {
      const std::string& words = shown.columns.front().cells[row];
      const auto path = paths.find(words);
      titles.push_back(path == paths.end() ? words : path->second);
      const std::string& of_value = units[words];
      if (!of_value.empty()) shown.columns.at(1).cells[row] += " " + of_value;
    }
    content += fold("h3", shown.heading, table_of(shown, HtmlTable::OnTelephone::as_fits, std::move(titles)));
  }
  content += element("p", say("sensitivity.note"), "class=\"note\"");
  return {"sensitivity", say("heading.sensitivity"), content};
}

}  // namespace bentur::html
