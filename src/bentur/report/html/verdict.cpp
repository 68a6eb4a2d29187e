#include <fmt/format.h>

#include <algorithm>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

/// Bars of the given gap, the gap needed as given and reversed and those of the rules where one gap falls short the
/// most, all at one scale.
Html gap_bars(const Report& report, const GapFacts& facts) {
  const auto found = governing_need(facts);
  if (!found) return {};
  std::vector<GapBar> bars = {{report.say("column.given"), found->at.width, "given"}};
  const bool by_spectrum = report.response.buildings.empty();
  put_bar(report.say(by_spectrum ? "spectral.difference" : "column.simulated"), found->given, bars);
  put_bar(report.say("column.reversed"), found->reversed, bars);
  for (const RuleFinding& rule : facts.rules) {
    if (rule.at) bars.push_back({rule.title, rule.gap, "rule"});
  }
  return gap_bars(bars, report.c.units.length);
}

}  // namespace

void put_bar(const std::string& name, const GoverningNeed::OneWay& one, std::vector<GapBar>& bars) {
  if (one.needed) bars.push_back({name, *one.needed, one.is_short ? "short" : "needed"});
}

Html paragraphs(const SaidStatement& statement, std::string& badge, const std::string& gap) {
  Html block;
  if (!statement.badge.empty() && statement.badge != badge) {
    block += element("p", statement.badge, "class=\"badge\"");
    badge = statement.badge;
  }
  const bool leads = statement.severity == Severity::danger || !statement.badge.empty();
  const std::string text = gap.empty() ? statement.text : gap + ": " + statement.text;
  return block + element("p", text, leads ? "class=\"lead\"" : "");
}

Html gap_bars(const std::vector<GapBar>& bars, const std::string& unit) {
  double largest = 0;
  for (const GapBar& bar : bars) largest = std::max(largest, bar.value);
  if (!(largest > 0)) return {};
  Html rows;
  for (const GapBar& bar : bars) {
    const Html drawn = element(
        "svg", Html(),  // which has a width without a style, that the page's policy refuses
        fmt::format("class=\"bar {}\" width=\"{:.1f}%\" aria-hidden=\"true\"", bar.style, 100 * bar.value / largest));
    rows += element("tr", element("th", bar.name, "scope=\"row\"") + element("td", drawn, "class=\"bars\"") +
                              element("td", quantity(bar.value, unit)));
  }
  return element("table", element("tbody", rows), "class=\"gapbars\"");
}

Html table_of(const SaidTable& table) {
  HtmlTable shown;
  for (const std::size_t row : table.marked) shown.mark(row);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const TableColumn& column = table.columns[i];
    std::vector<std::string> cells = column.cells;
    shown.add(column.label, column.unit, std::move(cells), table.are_numbers[i]);
  }
  return shown.markup();
}

PageSection verdict_section(const Report& report) {
  const std::vector<SaidStatement> all = said(report.story.statements, report.say);
  const std::size_t gaps = report.problem.buildings.size() - 1;
  const bool is_row = gaps > 1;
  const bool grave = std::any_of(all.begin(), all.end(), [](const auto& one) { return is_grave(one.severity); });
  Html block;
  std::string badge;
  std::vector<Html> of_gaps(gaps);
  std::vector<std::string> badges(gaps);
  for (const SaidStatement& statement : all) {
    if (statement.severity == Severity::remark) continue;
    if (is_row && statement.gap && statement.severity != Severity::danger) {
      // Of a row what each gap needs is folded away behind the table.
      of_gaps[*statement.gap] += paragraphs(statement, badges[*statement.gap], "");
    } else {
      block += paragraphs(statement, badge, is_row && statement.gap ? short_gap_name(report, *statement.gap) : "");
    }
  }
  for (const StoryTable& table : report.story.tables) {
    if (table.kind == "row") block += table_of(said(table, report.say));
  }
  if (is_row && numbers_buildings(report)) block += element("p", building_key(report), "class=\"note\"");
  for (std::size_t gap = 0; gap < gaps; ++gap) {
    const auto number = static_cast<Eigen::Index>(gap);
    const Html bars = gap < report.judged.size() ? gap_bars(report, report.judged[gap].facts) : Html();
    if (is_row) {
      block += element("details", element("summary", gap_name(report.problem, number)) + of_gaps[gap] + bars) +
               Html::markup("\n");
    } else {
      block += bars;
    }
  }
  return {"verdict", report.say("heading.verdict"), element("div", block, verdict_class(grave))};
}

PageSection remarks_section(const Report& report) {
  return remarks_section(report.story, report.say, report.to_hand_in);
}

PageSection remarks_section(const Story& story, const Words& say, bool to_hand_in) {
  Html list, rest;
  for (const SaidStatement& statement : said(story.statements, say)) {
    if (statement.severity != Severity::remark) continue;
    if (to_hand_in && statement.kind.starts_with("model")) continue;  // it stands with the assumptions
    if (statement.kind.starts_with("remark.")) {
      list += element("li", Html::text(statement.text));
    } else {
      rest += element("p", Html::text(statement.text));
    }
  }
  const Html content = list.str().empty() ? rest : element("ul", list) + rest;
  return {"remarks", say("remarks.heading"), content};
}

Html opening_figure(const std::function<Figure(const FigureOptions&)>& make, const std::string& caption,
                    const std::string& language) {
  FigureOptions options;
  options.say = figure_words(language);
  options.language = language;
  Html drawn;
  std::string finding;
  for (const auto& [width, name] : {std::pair(page_width, "broad"), std::pair(column_width, "slim")}) {
    options.width = width;
    const Figure figure = make(options);
    finding = figure.finding;
    drawn += element("div", Html::markup(figure_element(figure, caption)), fmt::format("class=\"{}\"", name));
  }
  return element("figure", drawn + element("figcaption", caption + ". " + finding), "class=\"overview\"");
}

}  // namespace bentur::html
