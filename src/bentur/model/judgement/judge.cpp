#include "bentur/model/judgement/judge.h"

#include <algorithm>
#include <utility>

#include "bentur/model/judgement/compare.h"

namespace bentur {
namespace {

using Kind = Reason::Kind;

std::string_view word_of_kind(Kind kind) {
  switch (kind) {
    case Kind::contact:
      return "contact";
    case Kind::unmodelled:
      return "unmodelled contact";
    case Kind::need:
      return "need";
    case Kind::rule:
      return "rule";
    case Kind::collapse:
      return "collapse";
    case Kind::drift:
      return "drift beyond collapse";
    case Kind::capacity:
      return "beyond capacity";
    case Kind::doubt:
      return "doubt";
    case Kind::motion_left:
      return "motion left";
    case Kind::not_looked_at:
      break;
  }
  return "not looked at";
}

/// Of one way of the motion the level that is struck hardest.
void judge_contact(const GapFacts& facts, Way way, std::vector<Reason>& reasons) {
  Reason contact{.kind = Kind::contact, .way = way};
  for (std::size_t i = 0; i < facts.levels.size(); ++i) {
    const LevelFacts::OneWay& level = facts.levels[i].in(way);
    if (level.impacts == 0) continue;
    contact.count += level.impacts;
    if (contact.level && level.peak_force < contact.value) continue;
    contact.level = i;
    contact.value = level.peak_force;
    contact.width = facts.levels[i].at.width;
  }
  if (contact.level) reasons.push_back(contact);
  Reason deepest{.kind = Kind::unmodelled, .way = way};
  for (std::size_t i = 0; i < facts.levels.size(); ++i) {
    const double depth = facts.levels[i].in(way).depth;
    if (!(depth > deepest.value)) continue;
    deepest.level = i;
    deepest.value = depth;
    deepest.width = facts.levels[i].at.width;
  }
  if (deepest.level) reasons.push_back(deepest);
}

/// The level that falls short the most without contact, and what may still come.
void judge_need(const GapFacts& facts, Way way, std::vector<Reason>& reasons) {
  Reason need{.kind = Kind::need, .way = way}, left{.kind = Kind::motion_left, .way = way};
  for (std::size_t i = 0; i < facts.levels.size(); ++i) {
    const FacingLevel& at = facts.levels[i].at;
    const auto take = [&](const std::optional<double>& asked, Reason& of) {
      if (!asked || !falls_short(at.width, *asked, facts.scale)) return;
      if (of.level && *asked - at.width <= of.value - of.width) return;
      of.level = i;
      of.value = *asked;
      of.width = at.width;
    };
    take(facts.levels[i].in(way).need, need);
    take(facts.levels[i].in(way).to_come, left);
  }
  if (need.level) {
    reasons.push_back(need);
  } else if (left.level) {
    reasons.push_back(left);
  }
}

void judge_rules(const GapFacts& facts, std::vector<Reason>& reasons) {
  for (const RuleFinding& found : facts.rules) {
    if (!found.is_short || !found.at || find_code_rule(found.rule) == nullptr) continue;
    reasons.push_back({.kind = Kind::rule,
                       .level = found.at,
                       .value = found.gap,
                       .width = facts.levels.at(*found.at).at.width,
                       .subject = found.title});
  }
}

/// What keeps the need of one way of the motion from being known.
void judge_unknown(const GapFacts& facts, Way way, std::vector<Reason>& reasons) {
  const WayFacts& of = facts.in(way);
  if (of.fall) {
    reasons.push_back(
        {.kind = Kind::collapse, .way = way, .value = of.fall->time, .subject = of.fall->building, .storey = of.fall->storey});
  }
  const auto beyond = [&](Kind kind, const std::vector<Beyond>& found) {
    for (const Beyond& one : found) {
      reasons.push_back(
          {.kind = kind, .way = way, .value = one.ratio, .subject = one.building, .storey = one.storey});
    }
  };
  if (const auto& fall = of.fall_with_contact; fall && !of.fall) {
    reasons.push_back({.kind = Kind::collapse,
                       .way = way,
                       .value = fall->time,
                       .count = 1,
                       .subject = fall->building,
                       .storey = fall->storey});
  }
  beyond(Kind::drift, of.drifts);
  beyond(Kind::capacity, of.capacities);
  const bool needed = way == Way::given || facts.has_other_way;
  if (needed && (!of.looked_at || !of.contact_looked_at)) reasons.push_back({.kind = Kind::not_looked_at, .way = way});
}

}  // namespace

bool falls_short(double given, double needed, double scale) {
  constexpr double round_off = 1e-9;
  return needed > given + round_off * std::max(scale, given);
}

std::string_view word_of(Sufficiency value) {
  return value == Sufficiency::too_small   ? "too small"
         : value == Sufficiency::not_known ? "not known"
                                           : "enough";
}

std::string word_of(const Reason& reason) {
  return std::string(word_of_kind(reason.kind)) + (reason.way == Way::reversed ? " reversed" : "");
}

bool says_too_small(Kind kind) { return kind <= Kind::rule; }

Judgement judge(const GapFacts& facts) {
  Judgement made{.alone = facts.others_close};
  std::vector<Reason>& reasons = made.reasons;
  for (const Way way : both_ways) judge_contact(facts, way, reasons);
  for (const Way way : both_ways) judge_need(facts, way, reasons);
  judge_rules(facts, reasons);
  for (const Way way : both_ways) judge_unknown(facts, way, reasons);
  for (std::size_t i = 0; i < facts.doubts.size(); ++i) {
    reasons.push_back({.kind = Kind::doubt, .count = static_cast<long>(i), .subject = facts.doubts[i].subject});
  }
  std::stable_sort(reasons.begin(), reasons.end(), [](const Reason& a, const Reason& b) { return a.kind < b.kind; });
  const bool is_known =
      std::all_of(reasons.begin(), reasons.end(), [](const Reason& one) { return says_too_small(one.kind); });
  made.levels.assign(facts.levels.size(), is_known ? Sufficiency::enough : Sufficiency::not_known);
  for (std::size_t i = 0; i < facts.levels.size(); ++i) {
    for (const Way way : both_ways) {
      const LevelFacts::OneWay& level = facts.levels[i].in(way);
      const bool is_short = level.need && falls_short(facts.levels[i].at.width, *level.need, facts.scale);
      if (is_short || level.impacts > 0 || level.depth > 0) made.levels[i] = Sufficiency::too_small;
    }
  }
  for (const Reason& one : reasons) {
    if (says_too_small(one.kind) && one.level) made.levels[*one.level] = Sufficiency::too_small;
  }
  if (!reasons.empty()) {
    made.value = says_too_small(reasons.front().kind) ? Sufficiency::too_small : Sufficiency::not_known;
  }
  return made;
}

}  // namespace bentur
