#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/kinds/figure_width.h"

namespace bentur::html {
namespace {

/// A bar of a verdict: `style`, its class in the style sheet, "given", "rule", or what is judged of it or of its gap:
/// "short", "open", "needed".
struct GapBar {
  std::string name;
  double value = 0;
  const char* style = "";
};

/// The given gap, the gap needed as recorded and reversed where a gap falls short the most, and what rules ask.
std::vector<GapBar> bars_of(const VerdictGap& gap, const Verdict& verdict, const Words& say) {
  const auto found = gap.judged != nullptr ? governing_need(gap.judged->facts) : std::nullopt;
  if (!found) return {};
  const Sufficiency value = gap.judged->judgement.value;
  const char* const level = value == Sufficiency::too_small ? "short"
                            : value == Sufficiency::unknown ? "open"
                                                            : "needed";
  std::vector<GapBar> bars = {{say("column.given"), found->at.width, "given"}};
  const auto put = [&](const char* name, const GoverningNeed::OneWay& one) {
    if (one.needed) bars.push_back({say(name), *one.needed, level});
  };
  const bool is_reversed = acts_reversed(verdict.c);
  put(verdict.by_spectrum       ? "spectral.difference"
      : !found->reversed.needed ? "column.simulated"
      : is_reversed             ? "column.reversed"
                                : "column.recorded",
      found->given);
  put(is_reversed ? "column.recorded" : "column.reversed", found->reversed);
  for (const RuleFinding& rule : gap.judged->facts.rules) {
    if (rule.at) bars.push_back({rule.title, rule.gap, rule.is_short ? "short" : "rule"});
  }
  return bars;
}

/// `largest`: what the whole width stands for.
Html drawn_bars(const std::vector<GapBar>& bars, double largest, const std::string& unit) {
  if (bars.empty() || !(largest > 0)) return {};
  std::vector<double> values;
  for (const GapBar& bar : bars) values.push_back(bar.value);
  const std::vector<std::string> numbers = column(values);
  Html rows;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const GapBar& bar = bars[i];
    const Html drawn = element(
        "svg", Html(),  // which has a width without a style, that the page's policy refuses
        fmt::format("class=\"bar {}\" width=\"{:.1f}%\" aria-hidden=\"true\"", bar.style, 100 * bar.value / largest));
    rows += element("tr", element("th", bar.name, "scope=\"row\"") + element("td", drawn, "class=\"bars\"") +
                              element("td", numbers[i] + "\u00A0" + unit));
  }
  return element("table", element("tbody", rows), "class=\"gapbars\"");
}

}  // namespace

Html paragraphs(const SaidStatement& statement, std::string& badge) {
  Html block;
  if (!statement.badge.empty() && statement.badge != badge) {
    block += element("p", statement.badge, statement.is_open ? "class=\"badge\" data-open" : "class=\"badge\"");
    badge = statement.badge;
  }
  if (statement.lead == 0) return block + element("p", statement.text);
  const Html lead = element("strong", statement.text.substr(0, statement.lead));
  return block + element("p", lead + Html::text(statement.text.substr(statement.lead)), "class=\"lead\"");
}

Html table_of(const SaidTable& table, HtmlTable::OnTelephone form, std::vector<std::string> titles,
              const std::vector<std::size_t>& in_sight) {
  HtmlTable shown;
  shown.explain(std::move(titles));
  for (const std::size_t row : in_sight) shown.keep_in_sight(row);
  for (const std::size_t row : table.marked) shown.mark(row);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const TableColumn& column = table.columns[i];
    std::vector<std::string> cells = column.cells;
    shown.add(column.label, column.unit, std::move(cells), table.are_numbers[i]);
  }
  return shown.called(table.heading).markup("", form);
}

namespace {

constexpr std::size_t most_in_sight = 3;  ///< of the gaps of a telephone's list, before the others are asked for

/// Of a list of gaps the worst; nothing of a short one. @param are_worst whether it has the worst alone, in that order
std::vector<std::size_t> worst_of(const std::vector<VerdictGap>& gaps, std::size_t rows, bool are_worst) {
  if (rows <= most_in_sight + 1) return {};
  std::vector<std::size_t> worst = {0, 1, 2};
  if (are_worst) return worst;
  std::vector<JudgedGap> judged;
  for (const VerdictGap& gap : gaps) {
    if (gap.judged != nullptr) judged.push_back(*gap.judged);
  }
  if (judged.size() != rows) return {};
  worst = worst_first(judged);
  worst.resize(most_in_sight);
  return worst;
}

/// Asks for the gaps that are not in sight; the script shows it where there are such.
Html more_gaps(std::size_t rows, const Words& say) {
  const std::string text = say("gap.show_more", {{"n", std::to_string(rows - most_in_sight)}});
  return element("p", element("button", text, "type=\"button\""), "class=\"more-gaps screen\" hidden");
}

}  // namespace

PageSection verdict_section(const Verdict& verdict, const Words& say) {
  const std::vector<SaidStatement> all = said(verdict.story.statements, say);
  const std::vector<VerdictGap>& gaps = verdict.gaps;
  const bool are_many = gaps.size() > 1;
  Html block, numbers;  // what is said, and of how much
  std::string badge;
  std::vector<Html> of_gaps(gaps.size());
  std::vector<std::string> badges(gaps.size());
  for (SaidStatement statement : all) {
    if (statement.severity == Severity::remark || statement.shown == Shown::row) continue;
    if (!statement.gap && statement.kind.starts_with("suite") && !is_grave(statement.severity))
      continue;  // its section
    if (!are_many && statement.shown == Shown::table) continue;
    if (are_many && statement.gap && statement.severity != Severity::danger) {
      // Of many gaps what each needs is folded away behind the table.
      of_gaps[*statement.gap] += paragraphs(statement, badges[*statement.gap]);
    } else {
      if (are_many && statement.gap) {
        const auto& [name, in_short, judged] = gaps[*statement.gap];
        statement = behind_gap(std::move(statement), name, in_short);
      }
      block += paragraphs(statement, badge);
    }
  }
  for (const StoryTable& table : verdict.story.tables) {
    if (!table.kind.starts_with("row")) continue;
    const SaidTable shown = said(table, say);
    const std::size_t rows = shown.columns.empty() ? 0 : shown.columns.front().cells.size();
    const std::vector<std::size_t> in_sight = worst_of(gaps, rows, table.kind == "row_worst");
    numbers += element("h3", shown.heading) + table_of(shown, HtmlTable::OnTelephone::gaps, {}, in_sight);
    if (!in_sight.empty()) numbers += more_gaps(rows, say);
    if (shown.note.empty()) continue;
    const Html link = element("a", say("gap.all_of_them", {{"section", say("heading.gaps")}}), "href=\"#gaps\"");
    numbers += element("p", Html::text(shown.note + " ") + link);
  }
  numbers += verdict.key;
  std::vector<std::string> names;
  for (const VerdictGap& gap : gaps) names.push_back(gap.in_short);
  const std::optional<SaidTable> known = known_table(names, all, say);
  std::vector<std::vector<GapBar>> bars;
  double largest = 0;  // all bars at one scale
  for (const VerdictGap& gap : gaps) {
    bars.push_back(bars_of(gap, verdict, say));
    for (const GapBar& bar : bars.back()) largest = std::max(largest, bar.value);
  }
  EachOf each;
  for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
    const Html drawn = drawn_bars(bars[gap], largest, verdict.c.units.length);
    if (are_many) {
      each.add(gaps[gap].name, of_gaps[gap] + drawn);
    } else {
      numbers += drawn;
    }
  }
  numbers += each.folded(say, "appendix.gaps");
  // Of several tables one can be parted from the others by the end of a page, so that pictures have room before it.
  const std::string box = fmt::format("class=\"verdict {}\"", verdict_tone(all));
  Html behind;
  if (known) {
    behind = element("div", element("h3", known->heading) + table_of(*known, HtmlTable::OnTelephone::said), box);
  }
  Html content = element("div", block, box);
  if (!numbers.str().empty()) content += element("div", numbers, box);
  return {"verdict", say("heading.verdict"), content, behind};
}

PageSection verdict_section(const Report& report) {
  Verdict verdict{.story = report.story, .c = report.c, .by_spectrum = report.response.buildings.empty()};
  for (std::size_t gap = 0; gap + 1 < report.problem.buildings.size(); ++gap) {
    const auto number = static_cast<Eigen::Index>(gap);
    verdict.gaps.push_back({.name = gap_name(report.problem, number),
                            .in_short = short_gap_name(report, number),
                            .judged = gap < report.judged.size() ? &report.judged[gap] : nullptr});
  }
  const std::string key = building_key(report);
  if (verdict.gaps.size() > 1 && numbers_buildings(report) && !key.empty()) {
    verdict.key = element("p", key, "class=\"note\"");
  }
  return verdict_section(verdict, report.say);
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
  std::string part;
  for (const auto& [width, name] : {std::pair(page_width, "broad"), std::pair(column_width, "slim")}) {
    options.width = width;
    Figure figure = make(options);
    bound_height(figure, width == page_width ? 7.8 : page_height);  // below a verdict there is a third of a page
    part = figure.part;
    drawn += element("div", Html::markup(figure_element(figure, caption)), fmt::format("class=\"{}\"", name));
  }
  const std::string below = caption + "." + (part.empty() ? "" : " " + part + ".");
  return element("figure", drawn + element("figcaption", below), "class=\"overview\"");
}

}  // namespace bentur::html
