#include <algorithm>

#include "bentur/model/story/internal/story_parts.h"

namespace bentur::story {
namespace {

using Eigen::Index;
using Kind = Reason::Kind;

std::string reason_key(const Reason& reason) {
  std::string key = "reason.";
  switch (reason.kind) {
    case Kind::contact:
      key += reason.value > 0 ? "contact" : "contact_impulse";
      break;
    case Kind::unmodelled:
      key += "unmodelled";
      break;
    case Kind::need:
      key += "need";
      break;
    case Kind::rule:
      return key + "rule";
    case Kind::collapse:
      key += reason.count == 1 ? "collapse_contact" : "collapse";
      break;
    case Kind::drift:
      key += "drift";
      break;
    case Kind::capacity:
      return key + "beyond_capacity";
    case Kind::doubt:
      return key + "doubt";
    case Kind::motion_left:
      key += "motion_left";
      break;
    case Kind::not_looked_at:
      return key + "not_looked_at";
  }
  return key + (reason.way == Way::reversed ? "_reversed" : "");
}

}  // namespace

const char* judgement_word(Sufficiency value) {
  return value == Sufficiency::too_small   ? "gap.too_close"
         : value == Sufficiency::not_known ? "gap.not_known"
                                           : "gap.wide_enough";
}

std::vector<StoryValue> reason_item(const GapView& view, Index gap, const Reason& reason) {
  const GapFacts& facts = view.facts.at(static_cast<std::size_t>(gap));
  const std::string& length = view.c.units.length;
  std::vector<StoryValue> item = {word_of("why", reason_key(reason))};
  if (reason.level) {
    const FacingLevel& at = facts.levels.at(*reason.level).at;
    add_level(view, at.is_point, at.index, at.elevation, item);
  }
  const auto lengths = [&](const char* name) {
    item.push_back(value_in(name, reason.value, length));
    item.push_back(value_in("short", reason.value - reason.width, length));
  };
  switch (reason.kind) {
    case Kind::contact: {
      const ShownUnits shown = shown_units(view.c.units, *view.response);
      item.push_back(count_of("times", reason.count));
      item.push_back(value_in("force", shown.force * reason.value, shown.units.force));
      break;
    }
    case Kind::unmodelled:
      item.push_back(value_in("depth", reason.value, length));
      break;
    case Kind::need:
    case Kind::motion_left:
      lengths("needed");
      break;
    case Kind::rule:
      lengths("asked");
      item.push_back(text_of("rule", reason.subject));
      break;
    case Kind::collapse:
      item.push_back(value_in("time", reason.value, "s"));
      break;
    case Kind::drift:
      item.push_back(value_in("drift", percent * reason.value, "%"));
      break;
    case Kind::capacity:
      item.push_back(value_in("ratio", reason.value));
      break;
    case Kind::doubt:
    case Kind::not_looked_at:
      break;
  }
  if (reason.kind == Kind::collapse || reason.kind == Kind::drift || reason.kind == Kind::capacity) {
    item.push_back(text_of("building", reason.subject));
    item.push_back(count_of("storey", static_cast<long>(reason.storey)));
  }
  return item;
}

void tell_judgement(const GapView& view, Index gap, const std::function<void(Statement)>& hit,
                    std::vector<Statement>& statements) {
  const Judgement& judged = view.judged.at(static_cast<std::size_t>(gap));
  const GapFacts& facts = view.facts.at(static_cast<std::size_t>(gap));
  const auto has = [&](Kind kind) {
    return std::any_of(judged.reasons.begin(), judged.reasons.end(),
                       [&](const Reason& one) { return one.kind == kind && one.way == Way::given; });
  };
  Statement statement{.kind = "no_pounding", .gap = gap, .buildings = {gap, gap + 1}};
  statement.values = {text_of("left", facts.left), text_of("right", facts.right)};
  if (const Response* const response = view.response) {
    const double duration = response->collapse ? response->collapse->time : view.problem.duration;
    statement.values.push_back(value_in("duration", duration, "s"));
  }
  if (has(Kind::contact)) return hit(std::move(statement));
  const bool has_points = std::any_of(facts.levels.begin(), facts.levels.end(),
                                      [](const LevelFacts& level) { return level.at.is_point; });
  if (has(Kind::unmodelled)) {
    statement.kind = "no_impact";
    if (has_points) statements.push_back(std::move(statement));
    return;
  }
  if (facts.levels.empty()) return;
  if (!judged.is_enough()) {
    const bool is_small = judged.value == Sufficiency::too_small;
    statement.kind = is_small ? "too_small" : "not_known";
    statement.severity = Severity::warning;
    double width = facts.levels.front().at.width;
    for (const LevelFacts& level : facts.levels) width = std::min(width, level.at.width);
    statement.values.push_back(value_in("width", width, view.c.units.length));
    bool has_doubt = false;  // each of which has a sentence of its own
    for (const Reason& reason : judged.reasons) {
      if (says_too_small(reason.kind) != is_small || (reason.kind == Kind::doubt && has_doubt)) continue;
      has_doubt = has_doubt || reason.kind == Kind::doubt;
      statement.items.push_back(reason_item(view, gap, reason));
    }
  } else if (view.response == nullptr) {
    return;  // a mean is told as such
  }
  statements.push_back(std::move(statement));
}

}  // namespace bentur::story
