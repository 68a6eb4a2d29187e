#include <fmt/format.h>

#include <cmath>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

constexpr double percent = 100;
constexpr double darkest = 8;  // ductility of the darkest fill

bool yields(const Report& report, Eigen::Index b) { return report.response.buildings[b].yielding.ductility.size() > 0; }

/// Of a slab: its bearings are there to yield, which is no damage.
bool is_slab(const Report& report, Eigen::Index b, Eigen::Index storey) {
  return report.problem.buildings[b].model.slab == storey;
}

/// "2"; the bearings below a slab have no number.
std::string name_of(const Report& report, Eigen::Index b, Eigen::Index storey) {
  if (is_slab(report, b, storey)) return report.say("word.bearings");
  return std::to_string(report.problem.buildings[b].model.storey_number(storey));
}

/// Nothing up to first yield, from there on the darker the more, as a map of ratios above 1, on paper and on a dark
/// screen alike; and the letters on it, of black and white the one that stands out more.
std::string fill_of(double share) { return share > 0 ? shade(0.5 + 0.5 * share, true) : "none"; }
const char* ink_on(const std::string& fill) {
  if (fill == "none") return "currentColor";
  const char* const black = colour(Tone::black).paper;
  return contrast(fill, black) > contrast(fill, paper.paper) ? black : paper.paper;
}

/// The building, each storey a box of two halves: without contact and with it.
Html drawing(const Report& report, Eigen::Index b) {
  constexpr double half = 48;    // width of a half
  constexpr double height = 30;  // of a storey
  constexpr double margin = 8;
  const BuildingPeaks& peaks = report.response.buildings[b];
  const Eigen::Index storeys = peaks.yielding.ductility.size();
  std::string boxes;
  for (Eigen::Index f = 0; f < storeys; ++f) {
    const double y = margin + height * static_cast<double>(storeys - 1 - f);
    const auto box = [&](double x, double ductility) {
      const std::string fill = fill_of(is_slab(report, b, f) ? 0 : std::log(ductility) / std::log(darkest));
      boxes += fmt::format(
          "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"currentColor\" stroke-width=\".7\"/>"
          "<text x=\"{}\" y=\"{}\" font-size=\"11\" text-anchor=\"middle\" fill=\"{}\">{}</text>",
          x, y, half, height, fill, x + 0.5 * half, y + 0.5 * height + 4, ink_on(fill),
          std::isfinite(ductility) ? number(ductility) : "–");
    };
    const Eigen::VectorXd& without = peaks.yielding_no_contact.ductility;
    box(margin, f < without.size() ? without(f) : not_known);
    box(margin + half, peaks.yielding.ductility(f));
  }
  const double ground = margin + height * static_cast<double>(storeys);
  boxes += fmt::format("<line x1=\"0\" x2=\"{}\" y1=\"{}\" y2=\"{}\" stroke=\"currentColor\" stroke-width=\"2\"/>",
                       2 * (margin + half), ground, ground);
  const std::string box = fmt::format("0 0 {} {}", 2 * (margin + half), ground + margin);
  const Html svg = element(
      "svg", Html::markup(boxes),
      "viewBox=\"" + box + "\" role=\"img\" aria-label=\"" + Html::text(report.problem.buildings[b].name).str() + "\"");
  return element("figure", svg + element("figcaption", Html::text(report.problem.buildings[b].name)));
}

Html lead(const Report& report) {
  int all = 0;
  int yielded = 0;
  int yielded_without = 0;
  Eigen::Index worst_building = -1;
  Eigen::Index worst = 0;
  double most = 1;
  for (Eigen::Index b = 0; b < std::ssize(report.response.buildings); ++b) {
    if (!yields(report, b)) continue;
    const BuildingPeaks& peaks = report.response.buildings[b];
    const Eigen::VectorXd& with = peaks.yielding.ductility;
    const Eigen::VectorXd& without = peaks.yielding_no_contact.ductility;
    for (Eigen::Index f = 0; f < with.size(); ++f) {
      if (std::isnan(with(f)) || is_slab(report, b, f)) continue;
      ++all;
      yielded += with(f) > 1 ? 1 : 0;
      yielded_without += f < without.size() && without(f) > 1 ? 1 : 0;
      if (!(with(f) > most)) continue;
      most = with(f);
      worst_building = b;
      worst = f;
    }
  }
  const Words& say = report.say;
  if (all == 0) return {};
  Html content = element("p",
                         Html::text(say("damage.lead", {{"yielded", std::to_string(yielded)},
                                                        {"all", std::to_string(all)},
                                                        {"without", std::to_string(yielded_without)}})),
                         "class=\"lead\"");
  if (worst_building < 0) return content;
  const BuildingPeaks& peaks = report.response.buildings[worst_building];
  const Eigen::VectorXd& without = peaks.yielding_no_contact.ductility;
  content += element(
      "p", Html::text(say("damage.worst",
                          {{"building", report.problem.buildings[worst_building].name},
                           {"storey", name_of(report, worst_building, worst)},
                           {"with", number(most)},
                           {"without", worst < without.size() ? number(without(worst)) : "–"},
                           {"residual", number(percent * std::abs(peaks.yielding.residual_drift_ratio(worst)))}})));
  return content;
}

}  // namespace

PageSection damage_section(const Report& report) {
  Html drawings;
  for (Eigen::Index b = 0; b < std::ssize(report.response.buildings); ++b) {
    if (yields(report, b)) drawings += drawing(report, b);
  }
  if (drawings.str().empty()) return {};
  const Words& say = report.say;
  return {"damage", say("heading.damage"),
          lead(report) + element("div", drawings, "class=\"damage\"") +
              element("p", Html::text(say("damage.drawing")), "class=\"note\"")};
}

}  // namespace bentur::html
