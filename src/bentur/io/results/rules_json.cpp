#include "bentur/io/results/rules_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/io/results/internal/asked_json.h"
#include "bentur/io/results/internal/code_json.h"
#include "bentur/io/results/story_json.h"
#include "bentur/model/gap/codes/height_rules.h"
#include "bentur/model/story/story.h"

namespace bentur {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson or_none(const std::optional<double>& value) { return value ? OrderedJson(*value) : OrderedJson(nullptr); }

std::string_view given_is(HeightFinding::Verdict verdict) {
  constexpr std::string_view names[] = {"too_small", "enough", "as_much_as_the_least", "not_evaluated"};
  return names[static_cast<std::size_t>(verdict)];
}

OrderedJson need_json_of(const CodeSeparation& asked, const HeightNeed& need) {
  OrderedJson json = {{"elevation", need.level.elevation}, {"width", need.level.width}};
  json.update(code_separation_json(asked));
  json["at_least"] = need.asked->is_least;
  return json;
}

OrderedJson finding_json(const HeightFinding& found) {
  OrderedJson json = {{"rule", found.rule}, {"given_is", given_is(found.verdict)}};
  if (found.at) {
    const HeightNeed& need = found.needs[*found.at];
    json.update({{"gap", need.asked->asked.gap},
                 {"elevation", need.level.elevation},
                 {"width", need.level.width},
                 {"at_least", need.asked->is_least}});
  } else {
    json["reason"] = silence_name(found.silence);
  }
  OrderedJson levels = OrderedJson::array();
  for (const HeightNeed& need : found.needs) {
    if (need.asked) levels.push_back(need_json_of(need.asked->asked, need));
  }
  json["levels"] = levels;
  return json;
}

}  // namespace

OrderedJson code_separation_json(const CodeSeparation& code) {
  return {{"rule", code.rule},
          {"gap", std::isfinite(code.gap) ? OrderedJson(code.gap) : OrderedJson(nullptr)},
          {"to_property_line", {or_none(code.to_left), or_none(code.to_right)}}};
}

OrderedJson code_rules_json(const CodeSpec& code) {
  OrderedJson json = OrderedJson::array();
  for (const CodeRuleSpec& spec : code.rules) {
    const CodeRule* const rule = find_code_rule(spec.rule);
    if (rule == nullptr) continue;
    json.push_back({{"rule", rule->name},
                    {"title", rule->title},
                    {"clause", rule->clause},
                    {"wording", rule->wording},
                    {"assumes", rule->assumes},
                    {"motion", rule->motion}});
  }
  return json;
}

std::string_view silence_name(RuleFinding::Silence silence) {
  constexpr std::string_view names[] = {"",        "no_level",      "collapsed",     "linked",
                                        "unknown", "property_line", "displacements", "turning",
                                        "periods", "public_way"};
  return names[static_cast<std::size_t>(silence)];
}

OrderedJson height_gap_json(const Case& c, const Problem& problem, Eigen::Index gap) {
  OrderedJson rules = OrderedJson::array();
  for (const HeightFinding& found : height_findings(problem, gap, c.code, c.units)) {
    rules.push_back(finding_json(found));
  }
  const GapPair sides = sides_of(problem, gap);
  return {{"between", {problem.buildings[sides.left].name, problem.buildings[sides.right].name}}, {"rules", rules}};
}

std::string height_rules_json(const Case& c, const Problem& problem, std::string_view version) {
  OrderedJson gaps = OrderedJson::array();
  for (Eigen::Index gap = 0; gap < gap_count(problem); ++gap) {
    gaps.push_back(height_gap_json(c, problem, gap));
  }
  const OrderedJson json = {
      {"title", c.title},
      {"units", {{"length", c.units.length}, {"force", c.units.force}}},
      {"version", version},
      {"statements", OrderedJson::parse(statements_json(problem, height_rules_story(c, problem).statements))},
      {"code_rules", code_rules_json(c.code)},
      {"gaps", gaps}};
  return text_of(json);
}

}  // namespace bentur
