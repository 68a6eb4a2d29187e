#include "bentur/report/html/sweep_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/html/internal/markup.h"
#include "bentur/report/html/internal/page.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/kinds/internal/sweep_data.h"

namespace bentur {
namespace {

using html::element;
using html::Html;
using html::Words;

/// Values of a quantity, run by run; of its points, floors or gaps the largest or the sum. NaN: the run has none.
std::vector<double> by_run(const SweepData& sweep, const std::string& quantity, bool sum) {
  if (sweep.results().find(quantity) == nullptr)
    return std::vector<double>(sweep.results().numbers("status").size(), 0.0);
  const std::vector<double> all = sweep.results().numbers(quantity);
  const std::size_t owners = sweep.owners(quantity);
  std::vector<double> values;
  for (std::size_t run = 0; run < all.size() / owners; ++run) {
    double value = all[run * owners];
    for (std::size_t i = 1; i < owners; ++i) {
      const double other = all[run * owners + i];
      value = sum ? value + other : std::max(value, other);
    }
    values.push_back(value);
  }
  return values;
}

/// ", at width = 0.2, excitation = El Centro": where a run stands, without the directions in which `values` does not
/// change.
std::string where(const SweepData& sweep, std::size_t run, const std::vector<double>& values, const Words& say) {
  std::vector<std::string> places;
  std::size_t stride = values.size();
  for (const SweepDimension& one : sweep.dimensions()) {
    stride /= one.size;
    const std::size_t at = run / stride % one.size;
    bool constant = true;
    for (std::size_t i = 0; i < one.size; ++i) {
      constant = constant && values[run - at * stride + i * stride] == values[run];
    }
    if (!constant && (one.is_text() || !one.numbers.empty())) places.push_back(one.name + " = " + one.value(at));
  }
  for (const SweepDimension& one : sweep.sample_coordinates()) {
    places.push_back(one.name + " = " + (one.is_text() ? one.texts.at(run) : number(one.numbers.at(run))));
  }
  return places.empty() ? "" : say("sweep.where", {{"where", fmt::format("{}", fmt::join(places, ", "))}});
}

std::string with_unit_of(const SweepData& sweep, double value, const std::string& variable) {
  return html::quantity(value, unit_text(sweep.results().at(variable).units));
}

Html verdict(const SweepData& sweep, const Words& say) {
  const std::vector<double> status = sweep.results().numbers("status");
  const std::vector<double> impacts = by_run(sweep, "impacts", true);
  const std::vector<double> forces = by_run(sweep, "peak_force", false);
  const std::vector<double> unmodelled = by_run(sweep, "unmodelled_contacts", true);
  // Results of earlier versions watch no floors.
  const std::string need = sweep.results().find("gap_needed") != nullptr ? "gap_needed" : "gap_minimum_no_contact";
  const std::vector<double> needed = by_run(sweep, need, false);
  const auto finished = static_cast<std::size_t>(std::count(status.begin(), status.end(), 0.0));
  std::size_t pounding = 0;
  std::size_t overlooked = 0;
  std::size_t hardest = status.size();
  std::size_t widest = status.size();
  for (std::size_t run = 0; run < status.size(); ++run) {
    if (status[run] != 0) continue;
    pounding += impacts[run] > 0 || unmodelled[run] > 0 ? 1 : 0;
    overlooked += unmodelled[run] > 0 ? 1 : 0;
    if (forces[run] > 0 && (hardest == status.size() || forces[run] > forces[hardest])) hardest = run;
    if (widest == status.size() || needed[run] > needed[widest]) widest = run;
  }
  const char* const badge = overlooked > 0 ? "verdict.unmodelled"
                            : pounding > 0 ? "verdict.pounding"
                                           : "verdict.no_pounding";
  Html block =
      element("p", say(badge), "class=\"badge\"") +
      element("p", say("sweep.pounding", {{"pounding", std::to_string(pounding)}, {"runs", std::to_string(finished)}}),
              "class=\"lead\"");
  if (overlooked > 0) {
    block += element("p", say("sweep.unmodelled", {{"runs", std::to_string(overlooked)}}), "class=\"lead\"");
  }
  if (hardest < status.size()) {
    block += element("p", say("sweep.hardest", {{"force", with_unit_of(sweep, forces[hardest], "peak_force")},
                                                {"where", where(sweep, hardest, forces, say)}}));
  }
  if (widest < status.size()) {
    block += element("p", say("sweep.needed", {{"gap", with_unit_of(sweep, needed[widest], need)},
                                               {"where", where(sweep, widest, needed, say)}}));
  }
  if (finished < status.size()) {
    block += element("p", say("sweep.failed", {{"failed", std::to_string(status.size() - finished)}}));
  }
  return html::section("verdict", say("heading.verdict"),
                       element("div", block, pounding > 0 ? "class=\"verdict pounds\"" : "class=\"verdict clear\""));
}

/// What varies, and within which bounds.
Html varied(const SweepData& sweep, const Words& say) {
  std::vector<std::string> names, counts, values;
  const auto add = [&](const SweepDimension& one) {
    names.push_back(one.label.empty() ? one.name : one.label);
    counts.push_back(std::to_string(one.size));
    if (one.numbers.empty()) {
      const auto shown = std::min<std::ptrdiff_t>(std::ssize(one.texts), 12);
      values.push_back(fmt::format("{}{}", fmt::join(one.texts.begin(), one.texts.begin() + shown, ", "),
                                   shown < std::ssize(one.texts) ? ", …" : ""));
    } else {
      const auto [least, most] = std::minmax_element(one.numbers.begin(), one.numbers.end());
      values.push_back(number(*least) + " … " + number(*most));
    }
  };
  for (const SweepDimension& one : sweep.dimensions()) add(one);
  for (const SweepDimension& one : sweep.sample_coordinates()) add(one);
  html::HtmlTable table;
  table.add(say("sweep.varies"), "", names, false);
  table.add(say("sweep.count"), "", counts);
  table.add(say("sweep.values"), "", values, false);
  return html::section("varied", say("heading.varied"), table.markup());
}

/// A file as it was given, where the results hold it.
Html source(const SweepData& sweep, const Words& say, const std::string& attribute) {
  const std::string text = sweep.results().attribute(attribute);
  if (text.empty()) return {};
  return element("h3", say("heading." + attribute)) + element("pre", text);
}

}  // namespace

std::string sweep_report_html(const NetcdfReader& results, const ReportOptions& options) {
  const Words say(options.language);
  const SweepData sweep(results);
  const std::string given = results.attribute("title");
  const std::string title = given.empty() ? say("report.untitled") : given;
  Html body = element(
      "header", element("h1", title) + element("p", say("sweep.by", {{"version", options.version}}), "class=\"note\""));
  body += verdict(sweep, say) + html::figures_section(say, options.figures) + varied(sweep, say) +
          html::section("input", say("heading.input"), source(sweep, say, "study") + source(sweep, say, "case"));
  return html::page(say, title, body, false);
}

}  // namespace bentur
