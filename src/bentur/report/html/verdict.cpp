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

std::string collision_text(const Story& story, Eigen::Index gap, const GapOutcome& found, std::size_t points) {
  const Words& say = story.say;
  const std::string left = story.problem.buildings[gap].name;
  const std::string right = story.problem.buildings[gap + 1].name;
  const std::string duration = quantity(story.problem.duration, "s");
  if (found.impacts == 0 && !found.unmodelled.empty()) return points > 0 ? say("verdict.no_impact") : "";
  if (found.impacts == 0) return say("verdict.apart", {{"left", left}, {"right", right}, {"duration", duration}});
  std::string text = say(points == 1 ? "verdict.collide.one_level" : "verdict.collide",
                         {{"left", left},
                          {"right", right},
                          {"times", say.count("verdict.times", found.impacts)},
                          {"duration", duration},
                          {"touched", std::to_string(found.touched)},
                          {"points", std::to_string(points)}});
  const std::string elevation = quantity(story.problem.points[*found.hardest].elevation, story.c.units.length);
  if (const Impact* const impact = hardest_impact(story.response, *found.hardest)) {
    if (impact->peak_force > 0) {
      text += " " + say("verdict.hardest", {{"force", quantity(impact->peak_force, story.c.units.force)},
                                            {"time", quantity(impact->peak_force_time, "s")},
                                            {"elevation", elevation},
                                            {"contact", quantity(1e3 * (impact->end - impact->start), "ms")}});
    } else {
      text += " " + say("verdict.fastest", {{"speed", quantity(impact->closing_speed, story.c.units.length + "/s")},
                                            {"time", quantity(impact->start, "s")},
                                            {"elevation", elevation}});
    }
  }
  return text;
}

const std::string& owner(const Story& story, const WatchedFloor& floor) {
  return story.problem.buildings[static_cast<std::size_t>(floor.floor_of)].name;
}

const std::string& faced(const Story& story, const WatchedFloor& floor) {
  return story.problem.buildings[static_cast<std::size_t>(2 * floor.left + 1 - floor.floor_of)].name;
}

/// "the column of B".
std::string faced_place(const Story& story, const WatchedFloor& floor) {
  return story.say(floor.facing_floor ? "verdict.the_floor_of" : "verdict.the_column_of",
                   {{"building", faced(story, floor)}});
}

std::string remedy(const Story& story, const WatchedFloor& floor) {
  const Remedy remedy = remedy_for(story.problem, floor);
  const std::string level = quantity(remedy.level, story.c.units.length);
  switch (remedy.kind) {
    case Remedy::Kind::name_elevation:
      return story.say("verdict.remedy.elevation", {{"level", level}});
    case Remedy::Kind::raise_tolerance:
      return story.say("verdict.remedy.tolerance",
                       {{"tolerance", number(remedy.tolerance)}, {"other", faced(story, floor)}, {"level", level}});
    case Remedy::Kind::strike_column:
      return story.say("verdict.remedy.strike", {{"other", faced(story, floor)}, {"level", number(remedy.level)}});
    case Remedy::Kind::give_columns:
      break;
  }
  return story.say("verdict.remedy.columns", {{"other", faced(story, floor)}, {"level", level}});
}

/// Where a floor met something that no contact is modelled with, and what to do.
std::string unmodelled_text(const Story& story, const std::vector<Eigen::Index>& floors) {
  const WatchedFloor& deepest = story.problem.watched[floors.front()];
  const WatchedSummary& summary = story.response.watched[floors.front()];
  const std::string& length = story.c.units.length;
  std::string text = story.say("verdict.unmodelled.lead", {{"building", owner(story, deepest)},
                                                           {"elevation", quantity(deepest.elevation, length)},
                                                           {"depth", quantity(-summary.least_opening, length)},
                                                           {"faced", faced_place(story, deepest)},
                                                           {"time", quantity(summary.least_time, "s")}});
  if (floors.size() > 1) text += " " + story.say.count("verdict.unmodelled.more", static_cast<long>(floors.size()) - 1);
  return text + " " + remedy(story, deepest);
}

std::string needed_text(const Story& story, const GapOutcome& found) {
  const std::string& length = story.c.units.length;
  const GoverningLevel& level = found.governing;
  std::string text = story.say(level.needed <= level.width ? "verdict.enough" : "verdict.short",
                               {{"needed", quantity(level.needed, length)},
                                {"elevation", quantity(level.elevation, length)},
                                {"width", quantity(level.width, length)},
                                {"difference", quantity(std::abs(level.needed - level.width), length)}});
  if (level.watched) {
    const WatchedFloor& floor = story.problem.watched[*level.watched];
    text += " " + story.say("verdict.faces", {{"building", owner(story, floor)}, {"faced", faced_place(story, floor)}});
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

std::vector<RuleFinding> rules(const Story& story, const std::vector<Eigen::Index>& points) {
  std::vector<RuleFinding> found;
  const auto add = [&](const std::string& name, const auto& gap_of) {
    RuleFinding rule{.name = name};
    for (const Eigen::Index i : points) {
      const PointSeparation& s = story.separations.at(i);
      rule.gap = std::max(rule.gap, gap_of(s));
      rule.falls_short = rule.falls_short || gap_of(s) < s.simulated * (1 - 1e-9);
      rule.known = rule.known && !std::isnan(gap_of(s));
    }
    if (rule.known) found.push_back(rule);
  };
  add("ABS", [](const PointSeparation& s) { return s.abs; });
  add("SRSS", [](const PointSeparation& s) { return s.srss; });
  add("DDC", [](const PointSeparation& s) { return s.ddc; });
  const std::vector<CodeSeparation>& codes = story.separations.at(points.front()).codes;
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

std::string rules_text(const Story& story, const std::vector<Eigen::Index>& points) {
  std::vector<std::string> gaps, unsafe;
  for (const RuleFinding& rule : rules(story, points)) {
    gaps.push_back(quantity(rule.gap, story.c.units.length) + " (" + rule.name + ")");
    if (rule.falls_short) unsafe.push_back(rule.name);
  }
  const std::string conjunction = story.say("word.and");
  std::string text = story.say("verdict.rules", {{"rules", joined(gaps, conjunction)}});
  if (!unsafe.empty()) text += " " + story.say("verdict.rules_short", {{"rules", joined(unsafe, conjunction)}});
  return text;
}

/// What contact does to the buildings, over all of them.
std::string effect_text(const Story& story) {
  const auto& buildings = story.response.buildings;
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
    return quantity(story.problem.buildings[place.building].model.elevations[place.floor], story.c.units.length);
  };
  std::string text;
  if (!story.response.impacts.empty()) {
    const Place most = largest([](const BuildingPeaks& peaks, Eigen::Index floor) {
      const double free = peaks.displacement_no_contact(floor);
      return free > 0 ? peaks.displacement(floor) / free : 0;
    });
    const BuildingPeaks& peaks = buildings[most.building];
    text = most.value > 1 + 1e-9
               ? story.say("verdict.amplified",
                           {{"building", story.problem.buildings[most.building].name},
                            {"elevation", level(most)},
                            {"factor", number(most.value)},
                            {"with", quantity(peaks.displacement(most.floor), story.c.units.length)},
                            {"without", quantity(peaks.displacement_no_contact(most.floor), story.c.units.length)}})
               : story.say("verdict.not_amplified");
    text += " ";
  }
  const Place fastest =
      largest([](const BuildingPeaks& peaks, Eigen::Index floor) { return peaks.acceleration(floor); });
  return text +
         story.say("verdict.acceleration", {{"acceleration", quantity(fastest.value, acceleration_unit(story.c))},
                                            {"g", number(fastest.value / story.c.units.gravity)},
                                            {"building", story.problem.buildings[fastest.building].name},
                                            {"elevation", level(fastest)}});
}

/// What of a rule's wording was checked, in the words of the report.
std::string wording_text(const CodeRule& rule, const Words& say) {
  std::string text(rule.wording);
  for (const auto& [english, key] : {std::pair("to check", "gap.to_check"), std::pair("checked", "gap.checked")}) {
    const std::size_t at = text.find(english);
    if (at != std::string::npos) text.replace(at, std::string_view(english).size(), say(key));
  }
  return text;
}

/// The rules of codes at the level where each asks for most over what is given.
Html code_table(const Story& story, const std::vector<Eigen::Index>& points) {
  const Words& say = story.say;
  const std::string& length = story.c.units.length;
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> titles, clauses, wordings, verdicts;
  std::vector<double> gaps, elevations, lefts, rights;
  const auto width = [&](Eigen::Index i) { return story.problem.points[i].width; };
  const std::size_t count = story.separations.at(points.front()).codes.size();
  bool property_line = false;
  for (std::size_t k = 0; k < count; ++k) {
    const auto short_by = [&](Eigen::Index i) { return story.separations[i].codes[k].gap - width(i); };
    const Eigen::Index most = *std::max_element(
        points.begin(), points.end(), [&](Eigen::Index a, Eigen::Index b) { return short_by(a) < short_by(b); });
    const CodeSeparation& code = story.separations[most].codes[k];
    const CodeRule& rule = *find_code_rule(code.rule);
    titles.emplace_back(rule.title);
    clauses.emplace_back(rule.clause);
    wordings.push_back(wording_text(rule, say));
    gaps.push_back(code.gap);
    elevations.push_back(story.problem.points[most].elevation);
    lefts.push_back(code.to_left.value_or(none));
    rights.push_back(code.to_right.value_or(none));
    property_line = property_line || code.to_left || code.to_right;
    verdicts.push_back(say(short_by(most) > 0 ? "gap.too_close" : "gap.wide_enough"));
  }
  HtmlTable table;
  table.add(say("gap.code"), "", titles, false);
  table.add(say("gap.clause"), "", clauses, false);
  table.add(say("column.needed"), length, gaps);
  table.add(say("column.elevation"), length, elevations);
  table.add(say("gap.given_is"), "", verdicts, false);
  if (property_line) {
    table.add(say("gap.left_to_line"), length, lefts);
    table.add(say("gap.right_to_line"), length, rights);
  }
  table.add(say("gap.wording"), "", wordings, false);
  return table.markup();
}

/// What rules of thumb say of how the neighbours stand; nothing where one of them is a wall.
Html screening_table(const Story& story, Eigen::Index gap) {
  const Words& say = story.say;
  const std::vector<ScreeningFinding> findings = screening(story.problem, gap, story.c.screening, story.c.units);
  if (findings.empty()) return {};
  using Verdict = ScreeningFinding::Verdict;
  const auto verdict = [&](Verdict of) {
    return say(of == Verdict::fine               ? "screening.fine"
               : of == Verdict::attention        ? "screening.attention"
               : of == Verdict::needs_seismicity ? "screening.needs_seismicity"
                                                 : "screening.not_applicable");
  };
  HtmlTable table;
  std::vector<std::string> rules, values, limits, units, verdicts, sources;
  for (const ScreeningFinding& found : findings) {
    const ScreeningRule& rule = *found.rule;
    const bool yes_or_no = rule.name == "end-of-row" || rule.name == "pounding";
    const bool open = yes_or_no && found.verdict == Verdict::needs_seismicity;
    if (found.verdict == Verdict::attention) table.mark(rules.size());
    rules.push_back(say("screening." + std::string(rule.name)));
    values.push_back(open ? "–" : yes_or_no ? say(found.value > 0 ? "word.yes" : "word.no") : number(found.value));
    limits.emplace_back(found.limit ? number(*found.limit) : "–");
    units.emplace_back(rule.unit == "length" ? story.c.units.length : std::string(rule.unit));
    verdicts.push_back(verdict(found.verdict));
    sources.emplace_back(rule.wording == "ours" ? say("screening.ours") : std::string(rule.source));
  }
  table.add(say("screening.rule"), "", rules, false);
  table.add(say("screening.value"), "", values);
  table.add(say("screening.limit"), "", limits);
  table.add(say("screening.unit"), "", units, false);
  table.add(say("screening.verdict"), "", verdicts, false);
  table.add(say("screening.source"), "", sources, false);
  return element("h4", say("screening.heading")) + table.markup();
}

}  // namespace

namespace {

/// Whether a building collapses, in the run or without contact; empty where none does.
Html collapse_block(const Story& story) {
  const auto& with = story.response.collapse;
  const auto& without = story.response.collapse_no_contact;
  if (!with && !without) return {};
  const auto text = [&](const std::string& key, const Collapse& collapse) {
    const Building& building = story.problem.buildings[collapse.building];
    const Eigen::Index storey = collapse.storey + (building.model.has_slab ? 0 : 1);
    return story.say(key, {{"building", building.name},
                           {"storey", std::to_string(storey)},
                           {"time", quantity(collapse.time, "s")},
                           {"limit", number(100 * story.problem.collapse_drift)}});
  };
  if (!with) return element("p", text("verdict.collapse_only_no_contact", *without), "class=\"effect\"");
  const std::string second =
      without ? text("verdict.collapse_no_contact", *without) : story.say("verdict.no_collapse_no_contact");
  return element("div",
                 element("p", story.say("verdict.collapse"), "class=\"badge\"") +
                     element("p", text("verdict.collapse.lead", *with), "class=\"lead\"") + element("p", second),
                 "class=\"verdict pounds\"");
}

}  // namespace

Html verdict_section(const Story& story) {
  Html blocks = collapse_block(story);
  for (Eigen::Index gap = 0; gap + 1 < std::ssize(story.problem.buildings); ++gap) {
    const std::vector<Eigen::Index> points = points_of(story.problem, gap);
    const GapOutcome found = gap_outcome(story.problem, story.response, gap);
    const bool pounding = found.impacts > 0 || !found.unmodelled.empty();
    const std::string badge = !found.unmodelled.empty() ? "verdict.unmodelled"
                              : pounding                ? "verdict.pounding"
                                                        : "verdict.no_pounding";
    Html block = element("p", story.say(badge), "class=\"badge\"");
    if (!found.unmodelled.empty()) {
      block += element("p", unmodelled_text(story, found.unmodelled), "class=\"lead\"");
    }
    const std::string collision = collision_text(story, gap, found, points.size());
    if (!collision.empty()) block += element("p", collision, "class=\"lead\"");
    block += element("p", needed_text(story, found));
    if (!points.empty()) block += element("p", rules_text(story, points));
    blocks += element("div", block, pounding ? "class=\"verdict pounds\"" : "class=\"verdict clear\"");
  }
  return section("verdict", story.say("heading.verdict"),
                 blocks + element("p", effect_text(story), "class=\"effect\""));
}

namespace {

/// The floors that face their neighbour where no contact is modelled, highest first; nothing where there are none.
Html watched_table(const Story& story, Eigen::Index gap, const GoverningLevel& governing) {
  const Words& say = story.say;
  std::vector<Eigen::Index> floors = gap_at(story.problem, gap).watched;
  if (floors.empty()) return {};
  std::reverse(floors.begin(), floors.end());
  HtmlTable table;
  std::vector<double> elevations, widths, simulated;
  std::vector<std::string> owners, faces, marks;
  for (const Eigen::Index i : floors) {
    const WatchedFloor& floor = story.problem.watched[i];
    const double needed = story.response.watched.at(i).needed;
    if (governing.watched == i && needed > floor.width) table.mark(elevations.size());
    elevations.push_back(floor.elevation);
    owners.push_back(owner(story, floor));
    faces.push_back(say(floor.facing_floor ? "gap.floor" : "gap.column"));
    widths.push_back(floor.width);
    simulated.push_back(needed);
    marks.push_back(say(needed > floor.width ? "gap.too_close" : "gap.wide_enough"));
  }
  table.add(say("column.elevation"), story.c.units.length, elevations);
  table.add(say("gap.floor_of"), "", owners, false);
  table.add(say("gap.faces"), "", faces, false);
  table.add(say("column.given"), story.c.units.length, widths);
  table.add(say("column.simulated"), story.c.units.length, simulated);
  table.add(say("gap.given_is"), "", marks, false);
  return element("p", say("gap.watched")) + table.markup();
}

}  // namespace

Html gap_section(const Story& story) {
  const Words& say = story.say;
  const std::string& length = story.c.units.length;
  Html content;
  bool codes = false;
  for (Eigen::Index gap = 0; gap + 1 < std::ssize(story.problem.buildings); ++gap) {
    const std::vector<Eigen::Index> points = points_of(story.problem, gap);
    const GoverningLevel governing = governing_level(story.problem, story.response, gap);
    HtmlTable table;
    std::vector<double> elevations, widths, simulated, abs, srss, ddc;
    std::vector<std::string> marks;
    for (const Eigen::Index i : points) {
      const PointSeparation& s = story.separations.at(i);
      const bool governs = !governing.watched && story.problem.points[i].elevation == governing.elevation;
      if (governs && s.simulated > story.problem.points[i].width) table.mark(elevations.size());
      elevations.push_back(story.problem.points[i].elevation);
      widths.push_back(story.problem.points[i].width);
      simulated.push_back(s.simulated);
      abs.push_back(s.abs);
      srss.push_back(s.srss);
      ddc.push_back(s.ddc);
      marks.push_back(say(s.simulated > widths.back() ? "gap.too_close" : "gap.wide_enough"));
    }
    table.add(say("column.elevation"), length, elevations);
    table.add(say("column.given"), length, widths);
    table.add(say("column.simulated"), length, simulated);
    table.add("ABS", length, abs);
    table.add("SRSS", length, srss);
    if (story.from_case()) table.add("DDC", length, ddc);
    table.add(say("gap.given_is"), "", marks, false);
    content += element("h3", gap_name(story.problem, gap));
    if (!points.empty()) content += table.markup();
    content += watched_table(story, gap, governing);
    if (!points.empty() && !story.separations.at(points.front()).codes.empty()) {
      codes = true;
      content += code_table(story, points);
    }
    if (story.from_case()) content += screening_table(story, gap);
  }
  content += element("p", say("gap.note"), "class=\"note\"");
  if (story.from_case()) content += element("p", say("screening.note"), "class=\"note\"");
  content += element("p",
                     say(!story.from_case() ? "gap.no_case"
                         : codes            ? "gap.codes_note"
                                            : "gap.no_codes"),
                     "class=\"note\"");
  return section("gaps", say("heading.gaps"), content);
}

}  // namespace bentur::html
