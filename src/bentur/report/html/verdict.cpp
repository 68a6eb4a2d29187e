#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

/// The impact of a point with its peak force, or its fastest where no force is known.
const Impact* hardest_impact(const Response& response, std::size_t point) {
  const Impact* hardest = nullptr;
  for (const Impact& impact : response.impacts) {
    if (impact.point == static_cast<int>(point) && (hardest == nullptr || is_harder(impact, *hardest))) {
      hardest = &impact;
    }
  }
  return hardest;
}

std::string collision_text(const Report& report, Eigen::Index gap, const GapOutcome& found, std::size_t points) {
  const Words& say = report.say;
  const std::string left = report.problem.buildings[gap].name;
  const std::string right = report.problem.buildings[gap + 1].name;
  const std::string duration = prose(report.problem.duration, "s");
  if (found.impacts == 0 && !found.unmodelled.empty()) return points > 0 ? say("verdict.no_impact") : "";
  if (found.impacts == 0) return say("verdict.apart", {{"left", left}, {"right", right}, {"duration", duration}});
  std::string text = say(points == 1 ? "verdict.collide.one_level" : "verdict.collide",
                         {{"left", left},
                          {"right", right},
                          {"times", say.count("verdict.times", found.impacts)},
                          {"duration", duration},
                          {"touched", std::to_string(found.touched)},
                          {"points", std::to_string(points)}});
  const std::string elevation = prose(report.problem.points[*found.hardest].elevation, report.c.units.length);
  if (const Impact* const impact = hardest_impact(report.response, *found.hardest)) {
    if (impact->peak_force > 0) {
      text += " " + say("verdict.hardest", {{"force", prose(impact->peak_force, report.c.units.force)},
                                            {"time", prose(impact->peak_force_time, "s")},
                                            {"elevation", elevation},
                                            {"contact", prose(1e3 * (impact->end - impact->start), "ms")}});
    } else {
      text += " " + say("verdict.fastest", {{"speed", prose(impact->closing_speed, report.c.units.length + "/s")},
                                            {"time", prose(impact->start, "s")},
                                            {"elevation", elevation}});
    }
  }
  return text;
}

const std::string& faced(const Report& report, const WatchedFloor& floor) {
  return report.problem.buildings[static_cast<std::size_t>(2 * floor.left + 1 - floor.floor_of)].name;
}

/// "the column of B".
std::string faced_place(const Report& report, const WatchedFloor& floor) {
  return report.say(floor.facing_floor ? "verdict.the_floor_of" : "verdict.the_column_of",
                    {{"building", faced(report, floor)}});
}

std::string remedy(const Report& report, const WatchedFloor& floor) {
  const Remedy remedy = remedy_for(report.problem, floor);
  const std::string level = prose(remedy.level, report.c.units.length);
  switch (remedy.kind) {
    case Remedy::Kind::name_elevation:
      return report.say("verdict.remedy.elevation", {{"level", level}});
    case Remedy::Kind::raise_tolerance:
      return report.say("verdict.remedy.tolerance",
                        {{"tolerance", number(remedy.tolerance)}, {"other", faced(report, floor)}, {"level", level}});
    case Remedy::Kind::strike_column:
      return report.say("verdict.remedy.strike", {{"other", faced(report, floor)}, {"level", number(remedy.level)}});
    case Remedy::Kind::give_columns:
      break;
  }
  return report.say("verdict.remedy.columns", {{"other", faced(report, floor)}, {"level", level}});
}

}  // namespace

std::string unmodelled_text(const Report& report, const std::vector<Eigen::Index>& floors) {
  const WatchedFloor& deepest = report.problem.watched[floors.front()];
  const WatchedSummary& summary = report.response.watched[floors.front()];
  const std::string& length = report.c.units.length;
  std::string text = report.say("verdict.unmodelled.lead", {{"building", floor_owner(report, deepest)},
                                                            {"elevation", prose(deepest.elevation, length)},
                                                            {"depth", prose(-summary.least_opening, length)},
                                                            {"faced", faced_place(report, deepest)},
                                                            {"time", prose(summary.least_time, "s")}});
  if (floors.size() > 1)
    text += " " + report.say.count("verdict.unmodelled.more", static_cast<long>(floors.size()) - 1);
  return text + " " + remedy(report, deepest);
}

namespace {

std::string needed_text(const Report& report, const GapOutcome& found) {
  const std::string& length = report.c.units.length;
  const GoverningLevel& level = found.governing;
  if (level.width == 0 && level.needed == 0) return report.say("verdict.touch");
  std::string text = report.say(!level.is_short() ? "verdict.enough" : "verdict.short",
                                {{"needed", prose(level.needed, length)},
                                 {"elevation", prose(level.elevation, length)},
                                 {"width", prose(level.width, length)},
                                 {"difference", prose(std::abs(level.needed - level.width), length)}});
  if (level.watched) {
    const WatchedFloor& floor = report.problem.watched[*level.watched];
    text += " " + report.say("verdict.faces",
                             {{"building", floor_owner(report, floor)}, {"faced", faced_place(report, floor)}});
  }
  return text;
}

/// One rule against what is simulated, each at its worst level.
struct RuleFinding {
  std::string name;
  double gap = 0;
  bool falls_short = false;  ///< of the simulated gap, at some level
  bool known = true;
};

/// Of every rule; none without contact points.
std::vector<RuleFinding> findings_of(const Report& report, const std::vector<Eigen::Index>& points) {
  if (points.empty()) return {};
  const double scale = displacement_scale(report.problem, report.response, report.problem.points[points.front()].left);
  std::vector<RuleFinding> found;
  const auto add = [&](const std::string& name, const auto& gap_of) {
    RuleFinding rule{.name = name};
    for (const Eigen::Index i : points) {
      const PointSeparation& s = report.separations.at(i);
      if (bentur::falls_short(0, gap_of(s), scale)) rule.gap = std::max(rule.gap, gap_of(s));
      rule.falls_short = rule.falls_short || bentur::falls_short(gap_of(s), s.simulated, scale);
      rule.known = rule.known && !std::isnan(gap_of(s));
    }
    if (rule.known) found.push_back(rule);
  };
  add("ABS", [](const PointSeparation& s) { return s.abs; });
  add("SRSS", [](const PointSeparation& s) { return s.srss; });
  add("DDC", [](const PointSeparation& s) { return s.ddc; });
  const std::vector<CodeSeparation>& codes = report.separations.at(points.front()).codes;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    add(std::string(find_code_rule(codes[k].rule)->title), [k](const PointSeparation& s) { return s.codes[k].gap; });
  }
  return found;
}

std::string joined(const std::vector<std::string>& parts, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += i == 0 ? "" : i + 1 == parts.size() ? " " + last + " " : ", ";
    text += parts[i];
  }
  return text;
}

std::string rules_text(const Report& report, const std::vector<RuleFinding>& found) {
  std::vector<std::string> gaps, unsafe;
  for (const RuleFinding& rule : found) {
    gaps.push_back(prose(rule.gap, report.c.units.length) + " (" + rule.name + ")");
    if (rule.falls_short) unsafe.push_back(rule.name);
  }
  const std::string conjunction = report.say("word.and");
  std::string text = report.say("verdict.rules", {{"rules", joined(gaps, conjunction)}});
  if (!unsafe.empty()) text += " " + report.say("verdict.rules_short", {{"rules", joined(unsafe, conjunction)}});
  return text;
}

/// Where contact raises floor acceleration and storey shear the most; empty where nothing is hit or nothing is known.
std::string more_force_text(const Report& report) {
  if (report.response.impacts.empty()) return "";
  std::string text;
  for (const char* const key : {"acceleration_ratio", "storey_shear_ratio"}) {
    const Quantity& ratio = quantity_named(key, Owner::floor);
    double most = 0;
    QuantityPlace place;
    for (Eigen::Index b = 0; b < std::ssize(report.problem.buildings); ++b) {
      for (const QuantityPlace& at : floors_of(report.problem, b)) {
        const double value = value_of(ratio, report.run, at);
        if (value > most) {
          most = value;
          place = at;
        }
      }
    }
    if (!(most > 0)) continue;
    constexpr double seen = 1.005;  // with three digits
    if (most < seen) {
      text += report.say(std::string("verdict.") + key + ".none") + " ";
      continue;
    }
    const Building& building = report.problem.buildings[place.item];
    text += report.say(std::string("verdict.") + key,
                       {{"factor", rounded(most)},
                        {"building", building.name},
                        {"elevation", prose(building.model.elevations[place.floor], report.c.units.length)}}) +
            " ";
  }
  return text;
}

/// What contact does to the buildings, over all of them.
std::string effect_text(const Report& report) {
  const auto& buildings = report.response.buildings;
  struct Place {
    Eigen::Index building = 0;
    Eigen::Index floor = 0;
    double value = 0;
  };
  const auto largest = [&](const auto& value_of) {
    Place found;
    for (Eigen::Index b = 0; b < std::ssize(buildings); ++b) {
      for (Eigen::Index floor = 0; floor < buildings[b].displacement.size(); ++floor) {
        const double value = value_of(buildings[b], floor);
        if (value > found.value) found = {b, floor, value};
      }
    }
    return found;
  };
  const auto level = [&](const Place& place) {
    return prose(report.problem.buildings[place.building].model.elevations[place.floor], report.c.units.length);
  };
  std::string text;
  if (!report.response.impacts.empty()) {
    const Place most = largest([](const BuildingPeaks& peaks, Eigen::Index floor) {
      const double free = peaks.displacement_no_contact(floor);
      return free > 0 ? peaks.displacement(floor) / free : 0;
    });
    const BuildingPeaks& peaks = buildings[most.building];
    text = most.value > 1 + 1e-9
               ? report.say("verdict.amplified",
                            {{"building", report.problem.buildings[most.building].name},
                             {"elevation", level(most)},
                             {"factor", rounded(most.value)},
                             {"with", prose(peaks.displacement(most.floor), report.c.units.length)},
                             {"without", prose(peaks.displacement_no_contact(most.floor), report.c.units.length)}})
               : report.say("verdict.not_amplified");
    text += " ";
  }
  const Place fastest =
      largest([](const BuildingPeaks& peaks, Eigen::Index floor) { return peaks.acceleration(floor); });
  text += more_force_text(report);
  return text + report.say("verdict.acceleration", {{"acceleration", prose(fastest.value, acceleration_unit(report.c))},
                                                    {"g", rounded(fastest.value / report.c.units.gravity)},
                                                    {"building", report.problem.buildings[fastest.building].name},
                                                    {"elevation", level(fastest)}});
}

/// Whether a building collapses, in the run or without contact; empty where none does.
Html collapse_block(const Report& report) {
  const auto& with = report.response.collapse;
  const auto& without = report.response.collapse_no_contact;
  if (!with && !without) return {};
  const auto text = [&](const std::string& key, const Collapse& collapse) {
    const Building& building = report.problem.buildings[collapse.building];
    return report.say(key, {{"building", building.name},
                            {"storey", std::to_string(building.model.storey_number(collapse.storey))},
                            {"time", prose(collapse.time, "s")},
                            {"limit", number(100 * report.problem.collapse_drift)}});
  };
  if (!with) return element("p", text("verdict.collapse_only_no_contact", *without), "class=\"effect\"");
  const std::string second =
      without ? text("verdict.collapse_no_contact", *without) : report.say("verdict.no_collapse_no_contact");
  return element("div",
                 element("p", report.say("verdict.collapse"), "class=\"badge\"") +
                     element("p", text("verdict.collapse.lead", *with), "class=\"lead\"") + element("p", second),
                 verdict_class(true));
}

/// Bars of the given gap, the gap needed and those of the rules, all at one scale.
Html gap_bars(const Report& report, const GoverningLevel& level, const std::vector<RuleFinding>& rules) {
  struct Bar {
    std::string name;
    double value;
    const char* style;
  };
  std::vector<Bar> bars = {{report.say("column.given"), level.width, "given"},
                           {report.say("column.simulated"), level.needed, level.is_short() ? "short" : "needed"}};
  for (const RuleFinding& rule : rules) bars.push_back({rule.name, rule.gap, "rule"});
  double largest = 0;
  for (const Bar& bar : bars) largest = std::max(largest, bar.value);
  if (!(largest > 0)) return {};
  Html rows;
  for (const Bar& bar : bars) {
    const Html drawn = element(
        "span", Html(), fmt::format("class=\"bar {}\" style=\"width:{:.1f}%\"", bar.style, 100 * bar.value / largest));
    rows += element("tr", element("th", bar.name, "scope=\"row\"") + element("td", drawn, "class=\"bars\"") +
                              element("td", prose(bar.value, report.c.units.length)));
  }
  return element("table", element("tbody", rows), "class=\"gapbars\"");
}

/// What is told of one gap.
Html gap_block(const Report& report, const GapOutcome& found, const std::vector<Eigen::Index>& points) {
  Html block;
  if (!found.unmodelled.empty()) {
    block += element("p", unmodelled_text(report, found.unmodelled), "class=\"lead\"");
  }
  const std::string collision = collision_text(report, found.gap.left, found, points.size());
  if (!collision.empty()) block += element("p", collision, "class=\"lead\"");
  block += element("p", needed_text(report, found));
  const std::vector<RuleFinding> rules = findings_of(report, points);
  if (!points.empty()) block += element("p", rules_text(report, rules));
  return block + gap_bars(report, found.governing, rules);
}

const char* badge_of(bool unmodelled, bool pounding) {
  return unmodelled ? "verdict.unmodelled" : pounding ? "verdict.pounding" : "verdict.no_pounding";
}

/// A row of buildings: one sentence on all gaps, one table, and what is told of each gap folded away.
Html row_block(const Report& report, const std::vector<GapOutcome>& all) {
  const Words& say = report.say;
  const std::string& length = report.c.units.length;
  const GapOutcome* worst = &all.front();
  std::size_t tight = 0;
  long impacts = 0;
  bool unmodelled = false;
  const auto lacks = [](const GapOutcome& one) { return one.governing.needed - one.governing.width; };
  for (const GapOutcome& one : all) {
    tight += one.governing.is_short() ? 1 : 0;
    impacts += one.impacts;
    unmodelled = unmodelled || !one.unmodelled.empty();
    if (lacks(one) > lacks(*worst)) worst = &one;
  }
  const std::string count = std::to_string(all.size());
  const std::string sentence = tight == 0 ? say("verdict.row.none", {{"count", count}})
                                          : say(tight == all.size() ? "verdict.row.all" : "verdict.row.some",
                                                {{"count", count},
                                                 {"tight", std::to_string(tight)},
                                                 {"gap", gap_name(report.problem, worst->gap.left)},
                                                 {"needed", prose(worst->governing.needed, length)},
                                                 {"width", prose(worst->governing.width, length)}});
  HtmlTable table;
  std::vector<std::string> names, verdicts, counts, hardest;
  std::vector<double> given, needed, lacking;
  Html details;
  for (const GapOutcome& one : all) {
    const std::vector<Eigen::Index> points = points_of(report.problem, one.gap.left);
    names.push_back(short_gap_name(report, one.gap.left));
    verdicts.push_back(say(one.governing.is_short() ? "gap.too_close" : "gap.wide_enough"));
    if (one.governing.is_short()) table.mark(given.size());
    given.push_back(one.governing.width);
    needed.push_back(one.governing.needed);
    lacking.push_back(one.governing.is_short() ? lacks(one) : std::numeric_limits<double>::quiet_NaN());
    counts.push_back(std::to_string(one.impacts));
    const PointSummary* const hit = one.hardest ? &report.response.points[*one.hardest] : nullptr;
    hardest.push_back(hit != nullptr && hit->peak_force > 0 ? prose(hit->peak_force, report.c.units.force) : "–");
    details += element("details",
                       element("summary", gap_name(report.problem, one.gap.left)) + gap_block(report, one, points)) +
               Html::markup("\n");
  }
  table.add(say("column.gap"), "", names, false);
  table.add(say("gap.given_is"), "", verdicts, false);
  table.add(say("column.given"), length, given);
  table.add(say("column.simulated"), length, needed);
  table.add(say("column.short_by"), length, lacking);
  table.add(say("column.impacts"), "", counts);
  table.add(say("column.hardest"), "", hardest);
  const bool pounding = impacts > 0 || unmodelled;
  Html block = element("p", say(badge_of(unmodelled, pounding)), "class=\"badge\"") +
               element("p", sentence, "class=\"lead\"") + table.markup();
  if (numbers_buildings(report)) block += element("p", building_key(report), "class=\"note\"");
  return element("div", block + details, verdict_class(pounding));
}

}  // namespace

PageSection verdict_section(const Report& report) {
  std::vector<GapOutcome> all;
  for (Eigen::Index gap = 0; gap + 1 < std::ssize(report.problem.buildings); ++gap) {
    all.push_back(gap_outcome(report.problem, report.response, gap));
  }
  Html blocks = collapse_block(report);
  if (all.size() > 1) {
    blocks += row_block(report, all);
  } else {
    const GapOutcome& found = all.front();
    const bool pounding = found.impacts > 0 || !found.unmodelled.empty();
    blocks += element("div",
                      element("p", report.say(badge_of(!found.unmodelled.empty(), pounding)), "class=\"badge\"") +
                          gap_block(report, found, points_of(report.problem, found.gap.left)),
                      verdict_class(pounding));
  }
  return {"verdict", report.say("heading.verdict"), blocks + element("p", effect_text(report), "class=\"effect\"")};
}

}  // namespace bentur::html
