#include <algorithm>
#include <cmath>
#include <limits>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

/// What of a rule's wording was checked, in the words of the report.
std::string wording_text(const CodeRule& rule, const Words& say) {
  std::string text(rule.wording);
  for (const auto& [english, key] : {std::pair("to check", "gap.to_check"), std::pair("checked", "gap.checked")}) {
    const std::size_t at = text.find(english);
    if (at != std::string::npos) text.replace(at, std::string_view(english).size(), say(key));
  }
  return text;
}

}  // namespace

Html code_table(const Report& report, const std::vector<Eigen::Index>& points) {
  const Words& say = report.say;
  const std::string& length = report.c.units.length;
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> titles, clauses, wordings, verdicts;
  std::vector<double> gaps, elevations, lefts, rights;
  const auto width = [&](Eigen::Index i) { return report.problem.points[i].width; };
  const std::size_t count = report.separations.at(points.front()).codes.size();
  bool property_line = false;
  for (std::size_t k = 0; k < count; ++k) {
    const auto short_by = [&](Eigen::Index i) { return report.separations[i].codes[k].gap - width(i); };
    const Eigen::Index most = *std::max_element(
        points.begin(), points.end(), [&](Eigen::Index a, Eigen::Index b) { return short_by(a) < short_by(b); });
    const CodeSeparation& code = report.separations[most].codes[k];
    const CodeRule& rule = *find_code_rule(code.rule);
    titles.emplace_back(rule.title);
    clauses.emplace_back(rule.clause);
    wordings.push_back(wording_text(rule, say));
    gaps.push_back(code.gap);
    elevations.push_back(report.problem.points[most].elevation);
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

Html screening_table(const Report& report, Eigen::Index gap) {
  const Words& say = report.say;
  const std::vector<ScreeningFinding> findings = screening(report.problem, gap, report.c.screening, report.c.units);
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
    const bool open = rule.yes_or_no && found.verdict == Verdict::needs_seismicity;
    if (found.verdict == Verdict::attention) table.mark(rules.size());
    rules.push_back(say("screening." + std::string(rule.name)));
    values.push_back(open ? "–" : rule.yes_or_no ? say(found.value > 0 ? "word.yes" : "word.no") : number(found.value));
    limits.emplace_back(found.limit ? number(*found.limit) : "–");
    units.emplace_back(rule.unit == "length" ? report.c.units.length : std::string(rule.unit));
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

namespace {

/// Whether a level stands out in its table: the governing one where it falls short, or, without one, each that does.
bool stands_out(bool is_short, bool governs, const std::optional<GoverningLevel>& governing) {
  return is_short && (governs || !governing);
}

}  // namespace

const std::string& floor_owner(const Report& report, const WatchedFloor& floor) {
  return report.problem.buildings[floor.floor_of].name;
}

Html points_table(const Report& report, const std::vector<Eigen::Index>& points, const std::string& needed_label,
                  const std::optional<GoverningLevel>& governing) {
  const Words& say = report.say;
  const std::string& length = report.c.units.length;
  const double scale = governing ? governing->scale : 0;
  HtmlTable table;
  std::vector<double> elevations, widths, needed, abs, srss, ddc;
  std::vector<std::string> marks;
  for (const Eigen::Index i : points) {
    const ContactPoint& point = report.problem.points[i];
    const PointSeparation& s = report.separations.at(i);
    const bool is_short = falls_short(point.width, s.simulated, scale);
    const bool governs = governing && !governing->watched && point.elevation == governing->elevation;
    if (stands_out(is_short, governs, governing)) table.mark(elevations.size());
    elevations.push_back(point.elevation);
    widths.push_back(point.width);
    needed.push_back(falls_short(0, s.simulated, scale) ? s.simulated : 0);
    abs.push_back(s.abs);
    srss.push_back(s.srss);
    ddc.push_back(s.ddc > 0 && !falls_short(0, s.ddc, scale) ? 0 : s.ddc);
    marks.push_back(say(is_short ? "gap.too_close" : "gap.wide_enough"));
  }
  table.add(say("column.elevation"), length, elevations);
  table.add(say("gap.given_is"), "", marks, false);
  table.add(say("column.given"), length, widths);
  table.add(needed_label, length, needed);
  table.add("ABS", length, abs);
  table.add("SRSS", length, srss);
  if (report.from_case()) table.add("DDC", length, ddc);
  return table.markup();
}

Html watched_table(const Report& report, const std::vector<Eigen::Index>& floors, const std::vector<double>& needed_at,
                   const std::string& needed_label, const std::optional<GoverningLevel>& governing) {
  if (floors.empty()) return {};
  const Words& say = report.say;
  const std::string& length = report.c.units.length;
  HtmlTable table;
  std::vector<double> elevations, widths, needed;
  std::vector<std::string> owners, faces, marks;
  for (auto i = floors.rbegin(); i != floors.rend(); ++i) {
    const WatchedFloor& floor = report.problem.watched[*i];
    const bool is_short = falls_short(floor.width, needed_at[*i], governing ? governing->scale : 0);
    if (stands_out(is_short, governing && governing->watched == *i, governing)) table.mark(elevations.size());
    elevations.push_back(floor.elevation);
    owners.push_back(floor_owner(report, floor));
    faces.push_back(say(floor.facing_floor ? "gap.floor" : "gap.column"));
    widths.push_back(floor.width);
    needed.push_back(needed_at[*i]);
    marks.push_back(say(is_short ? "gap.too_close" : "gap.wide_enough"));
  }
  table.add(say("column.elevation"), length, elevations);
  table.add(say("gap.floor_of"), "", owners, false);
  table.add(say("gap.faces"), "", faces, false);
  table.add(say("column.given"), length, widths);
  table.add(needed_label, length, needed);
  table.add(say("gap.given_is"), "", marks, false);
  return element("p", say("gap.watched")) + table.markup();
}

PageSection gap_section(const Report& report) {
  const Words& say = report.say;
  Html content;
  bool codes = false;
  std::vector<double> watched;
  for (const WatchedSummary& floor : report.response.watched) watched.push_back(floor.needed);
  for (Eigen::Index gap = 0; gap + 1 < std::ssize(report.problem.buildings); ++gap) {
    const std::vector<Eigen::Index> points = points_of(report.problem, gap);
    const GoverningLevel governing = governing_level(report.problem, report.response, gap);
    content += element("h3", gap_name(report.problem, gap));
    if (!points.empty()) content += points_table(report, points, say("column.simulated"), governing);
    content += watched_table(report, gap_at(report.problem, gap).watched, watched, say("column.simulated"), governing);
    if (!points.empty() && !report.separations.at(points.front()).codes.empty()) {
      codes = true;
      content += code_table(report, points);
    }
    if (report.from_case()) content += screening_table(report, gap);
  }
  content += element("p", say("gap.note"), "class=\"note\"");
  if (report.from_case()) content += element("p", say("screening.note"), "class=\"note\"");
  content += element("p",
                     say(!report.from_case() ? "gap.no_case"
                         : codes             ? "gap.codes_note"
                                             : "gap.no_codes"),
                     "class=\"note\"");
  return {"gaps", say("heading.gaps"), content};
}

}  // namespace bentur::html
