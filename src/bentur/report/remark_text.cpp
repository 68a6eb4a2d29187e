#include "bentur/report/remark_text.h"

#include <fmt/format.h>

#include "bentur/core/number_text.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

constexpr std::size_t most_named = 4;  // buildings or gaps in one sentence

std::string value_with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

std::string usual_text(const Remark& remark, const Words& say) {
  if (remark.usual_from && remark.usual_to) {
    return say("remark.between",
               {{"from", number(*remark.usual_from)}, {"to", value_with_unit(number(*remark.usual_to), remark.unit)}});
  }
  if (remark.usual_to) return say("remark.up_to", {{"to", value_with_unit(number(*remark.usual_to), remark.unit)}});
  return say("remark.at_least", {{"from", value_with_unit(number(remark.usual_from.value_or(0)), remark.unit)}});
}

}  // namespace

std::vector<std::string> remark_texts(const std::vector<Remark>& remarks, std::string_view language) {
  const Words say(language);
  std::vector<std::string> texts;
  std::vector<char> told(remarks.size(), 0);
  for (std::size_t i = 0; i < remarks.size(); ++i) {
    const Remark& first = remarks[i];
    std::string subjects, values;
    std::size_t count = 0;
    for (std::size_t k = i; k < remarks.size(); ++k) {
      const Remark& other = remarks[k];
      if (told[k] != 0 || other.key != first.key || other.usual_from != first.usual_from ||
          other.usual_to != first.usual_to) {
        continue;
      }
      told[k] = 1;
      if (++count > most_named) continue;
      subjects += (subjects.empty() ? "" : ", ") + other.subject;
      const std::string value = number(other.value);
      if (value != values) values += (values.empty() ? "" : ", ") + value;
    }
    if (count == 0) continue;
    if (count > most_named) {
      subjects += say("remark.more", {{"n", std::to_string(count - most_named)}});
      values += ", …";
    }
    const std::string text = say("remark." + first.key, {{"value", value_with_unit(values, first.unit)},
                                                         {"usual", usual_text(first, say)},
                                                         {"from", number(first.usual_from.value_or(0))}});
    texts.push_back(subjects.empty() ? text : subjects.append(": ").append(text));
  }
  return texts;
}

std::string model_text(const Problem& problem, bool yields, std::string_view language) {
  const Words say(language);
  std::size_t counted = 0, loaded = 0, moved = 0;  // buildings, those with gravity loads, those on soil or bearings
  for (const Building& building : problem.buildings) {
    if (building.is_rigid()) continue;
    ++counted;
    loaded += building.has_gravity_loads ? 1 : 0;
    moved += building.model.has_soil || building.model.has_slab ? 1 : 0;
  }
  std::vector<std::string> left_out;
  if (loaded < counted) left_out.push_back(say(loaded == 0 ? "remarks.no_gravity" : "remarks.gravity_of"));
  left_out.push_back(say("remarks.no_torsion"));
  if (moved < counted) left_out.push_back(say(moved == 0 ? "remarks.no_soil" : "remarks.soil_of"));
  return say(yields ? "remarks.model_yielding" : "remarks.model",
             {{"left_out", fmt::format("{}", fmt::join(left_out, ", "))}});
}

}  // namespace bentur
