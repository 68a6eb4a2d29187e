#include "bentur/model/judgement/judge.h"

#include <algorithm>
#include <utility>

#include "bentur/model/judgement/compare.h"

namespace bentur {
namespace {

/// Of one way of the motion the level that is struck hardest.
void judge_contact(const GapFacts& facts, Way way, std::vector<Reason>& reasons) {
  Reason contact{.kind = Reason::Kind::contact, .way = way};
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
  Reason deepest{.kind = Reason::Kind::unmodelled, .way = way};
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
  Reason need{.kind = Reason::Kind::need, .way = way}, left{.kind = Reason::Kind::motion_left, .way = way};
  Reason at_once{.kind = Reason::Kind::phase, .way = way};
  for (std::size_t i = 0; i < facts.levels.size(); ++i) {
    const FacingLevel& at = facts.levels[i].at;
    const auto take = [&](const std::optional<double>& asked, Reason& of) {
      if (!asked || !is_below_target(at.width, *asked, facts.scale)) return;
      if (of.level && *asked - at.width <= of.value - of.width) return;
      of.level = i;
      of.value = *asked;
      of.width = at.width;
    };
    take(facts.levels[i].in(way).need, need);
    take(facts.levels[i].in(way).to_come, left);
    take(facts.levels[i].in(way).at_most, at_once);
  }
  if (need.level) {
    reasons.push_back(need);
  } else if (left.level) {
    reasons.push_back(left);
  }
  if (at_once.level) reasons.push_back(at_once);
}

/// Whether more may come at some level than it has.
bool more_may_come_in(const GapFacts& facts) {
  return std::any_of(facts.levels.begin(), facts.levels.end(), [&](const LevelFacts& level) {
    return std::any_of(std::begin(ways_of_motion), std::end(ways_of_motion),
                       [&](Way way) { return more_may_come(level.in(way).to_come, level.at.width, facts.scale); });
  });
}

void judge_rules(const GapFacts& facts, std::vector<Reason>& reasons) {
  for (const RuleFinding& found : facts.rules) {
    if (!found.is_short || !found.at || find_code_rule(found.rule) == nullptr) continue;
    reasons.push_back({.kind = Reason::Kind::rule,
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
    reasons.push_back({.kind = Reason::Kind::collapse,
                       .way = way,
                       .value = of.fall->time,
                       .subject = of.fall->building,
                       .storey = of.fall->storey});
  }
  const auto beyond = [&](Reason::Kind kind, const std::vector<Beyond>& found) {
    for (const Beyond& one : found) {
      reasons.push_back({.kind = kind, .way = way, .value = one.ratio, .subject = one.building, .storey = one.storey});
    }
  };
  if (const auto& fall = of.fall_with_contact; fall && !of.fall) {
    reasons.push_back({.kind = Reason::Kind::collapse,
                       .way = way,
                       .value = fall->time,
                       .count = 1,
                       .subject = fall->building,
                       .storey = fall->storey});
  }
  beyond(Reason::Kind::drift, of.drifts);
  beyond(Reason::Kind::capacity, of.capacities);
  const bool needed = way == Way::given || facts.has_other_way;
  if (needed && (!of.looked_at || !of.contact_looked_at))
    reasons.push_back({.kind = Reason::Kind::not_looked_at, .way = way});
  for (const auto& [is_open, what] :
       {std::pair(facts.masses_moved, NotLookedAt::masses), {facts.lacks_rules, NotLookedAt::rules}}) {
    if (!is_open || way == Way::reversed) continue;
    reasons.push_back({.kind = Reason::Kind::not_looked_at, .way = way, .count = static_cast<long>(what)});
  }
}

}  // namespace

bool is_below_target(double given, double needed, double scale) {
  constexpr double round_off = 1e-9;
  return needed > given + round_off * std::max(scale, given);
}

std::string_view word_of(Sufficiency value) {
  return value == Sufficiency::too_small ? "too small" : value == Sufficiency::unknown ? "not known" : "enough";
}

std::string_view word_of(Reason::Kind kind) {
  switch (kind) {
    case Reason::Kind::contact:
      return "contact";
    case Reason::Kind::unmodelled:
      return "unmodelled contact";
    case Reason::Kind::need:
      return "need";
    case Reason::Kind::rule:
      return "rule";
    case Reason::Kind::collapse:
      return "collapse";
    case Reason::Kind::drift:
      return "drift beyond collapse";
    case Reason::Kind::capacity:
      return "beyond capacity";
    case Reason::Kind::phase:
      return "phase";
    case Reason::Kind::doubt:
      return "doubt";
    case Reason::Kind::motion_left:
      return "motion left";
    case Reason::Kind::not_looked_at:
      break;
  }
  return "not looked at";
}

std::string word_of(const Reason& reason) {
  return std::string(word_of(reason.kind)) + (reason.way == Way::reversed ? " reversed" : "");
}

bool says_too_small(Reason::Kind kind) { return kind <= Reason::Kind::rule; }

bool is_by_motion(Reason::Kind kind) { return kind < Reason::Kind::rule; }

Judgement judge(const GapFacts& facts) {
  Judgement made{.alone = facts.others_close};
  std::vector<Reason>& reasons = made.reasons;
  for (const Way way : ways_of_motion) judge_contact(facts, way, reasons);
  for (const Way way : ways_of_motion) judge_need(facts, way, reasons);
  judge_rules(facts, reasons);
  for (const Way way : ways_of_motion) judge_unknown(facts, way, reasons);
  for (std::size_t i = 0; i < facts.doubts.size(); ++i) {
    reasons.push_back({.kind = Reason::Kind::doubt, .count = static_cast<long>(i), .subject = facts.doubts[i].subject});
  }
  std::stable_sort(reasons.begin(), reasons.end(), [](const Reason& a, const Reason& b) { return a.kind < b.kind; });
  // More that may come is no reason beside a need that falls short now, but holds at other levels.
  const bool is_known = !made.is_open() && !more_may_come_in(facts);
  made.levels.assign(facts.levels.size(), is_known ? Sufficiency::enough : Sufficiency::unknown);
  for (std::size_t i = 0; i < facts.levels.size(); ++i) {
    for (const Way way : ways_of_motion) {
      const LevelFacts::OneWay& level = facts.levels[i].in(way);
      const bool is_short = level.need && is_below_target(facts.levels[i].at.width, *level.need, facts.scale);
      if (is_short || level.impacts > 0 || level.depth > 0) made.levels[i] = Sufficiency::too_small;
    }
  }
  for (const Reason& one : reasons) {
    if (says_too_small(one.kind) && one.level) made.levels[*one.level] = Sufficiency::too_small;
  }
  if (!reasons.empty()) {
    made.value = says_too_small(reasons.front().kind) ? Sufficiency::too_small : Sufficiency::unknown;
  }
  return made;
}

std::optional<GoverningNeed> governing_need(const GapFacts& facts) {
  const auto lacks = [&](const LevelFacts& level) {
    return std::max(level.given.need.value_or(0), level.reversed.need.value_or(0)) - level.at.width;
  };
  const auto worst = std::max_element(facts.levels.begin(), facts.levels.end(),
                                      [&](const LevelFacts& a, const LevelFacts& b) { return lacks(a) <= lacks(b); });
  if (worst == facts.levels.end()) return std::nullopt;
  const auto of = [&](const LevelFacts::OneWay& way) {
    GoverningNeed::OneWay one;
    if (!way.need) return one;
    return GoverningNeed::OneWay{without_round_off(*way.need, facts.scale),
                                 is_below_target(worst->at.width, *way.need, facts.scale)};
  };
  return GoverningNeed{worst->at, of(worst->given), of(worst->reversed)};
}

namespace {

/// Whether one reason is worse than another of its kind: what comes earlier, or is larger.
bool is_worse(const Reason& one, const Reason& other) {
  if (one.kind == Reason::Kind::collapse) return one.value < other.value;
  return one.value - one.width > other.value - other.width;
}

Sufficiency sufficiency_of(const std::vector<Reason>& reasons) {
  if (reasons.empty()) return Sufficiency::enough;
  const bool is_small =
      std::any_of(reasons.begin(), reasons.end(), [](const Reason& r) { return says_too_small(r.kind); });
  return is_small ? Sufficiency::too_small : Sufficiency::unknown;
}

}  // namespace

Sufficiency without_rules(const Judgement& judgement) {
  std::vector<Reason> reasons = judgement.reasons;
  std::erase_if(reasons, [](const Reason& one) { return one.kind == Reason::Kind::rule; });
  return sufficiency_of(reasons);
}

JudgementOfMany judge(const std::vector<Judgement>& of_runs, const std::vector<Reason>& of_rules) {
  JudgementOfMany made{.runs = static_cast<long>(of_runs.size())};
  for (std::size_t run = 0; run < of_runs.size(); ++run) {
    std::vector<Reason> reasons = of_runs[run].reasons;
    std::erase_if(reasons, [](const Reason& one) { return one.kind == Reason::Kind::rule; });
    switch (sufficiency_of(reasons)) {
      case Sufficiency::too_small:
        ++made.too_small;
        break;
      case Sufficiency::unknown:
        ++made.not_known;
        break;
      case Sufficiency::enough:
        ++made.enough;
        break;
    }
    for (auto one = reasons.begin(); one != reasons.end(); ++one) {
      const auto found = std::find_if(made.reasons.begin(), made.reasons.end(), [&](const auto& known) {
        return known.worst.kind == one->kind && known.worst.way == one->way;
      });
      if (found == made.reasons.end()) {
        made.reasons.push_back({*one, run, 1});
        continue;
      }
      const bool is_first =
          std::none_of(reasons.begin(), one, [&](const Reason& r) { return r.kind == one->kind && r.way == one->way; });
      found->runs += is_first ? 1 : 0;
      if (!is_worse(*one, found->worst)) continue;
      found->worst = *one;
      found->run = run;
    }
  }
  for (const Reason& one : of_rules) made.reasons.push_back({one, 0, made.runs});
  std::stable_sort(made.reasons.begin(), made.reasons.end(),
                   [](const auto& a, const auto& b) { return a.worst.kind < b.worst.kind; });
  made.value = !of_rules.empty() || made.too_small > 0 ? Sufficiency::too_small
               : made.not_known > 0                    ? Sufficiency::unknown
                                                       : Sufficiency::enough;
  return made;
}

}  // namespace bentur
