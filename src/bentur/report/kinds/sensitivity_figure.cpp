#include "bentur/report/kinds/sensitivity_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {
namespace {

constexpr std::size_t most_bars = 8;
constexpr std::size_t most_gaps_shown = 3;
constexpr double thick = 0.2;   // of a bar, in places from row to row
constexpr double above = 0.44;  // of a row's middle, its name

/// The largest peaks of a gap, and the numbers they change most with.
struct OfGap {
  std::string name;
  const SensitivePeak *needed = nullptr, *force = nullptr;
  std::vector<std::pair<std::size_t, double>> numbers = {};  ///< and the larger of the two sizes, the largest first
};

double size_of(const Sensitivity& found, const SensitivePeak* peak, std::size_t number) {
  const double part = peak == nullptr ? 0 : std::abs(found.elasticity(*peak, number));
  return std::isnan(part) ? 0 : part;
}

std::vector<OfGap> gaps_of(const Sensitivity& found) {
  std::vector<OfGap> gaps;
  for (const SensitivePeak& peak : found.peaks) {
    const bool is_needed = peak.kind == SensitivePeak::Kind::gap_needed;
    if (!peak.is_largest || (!is_needed && peak.kind != SensitivePeak::Kind::peak_force)) continue;
    if (gaps.empty() || gaps.back().name != peak.name) gaps.push_back({peak.name});
    (is_needed ? gaps.back().needed : gaps.back().force) = &peak;
  }
  for (OfGap& gap : gaps) {
    for (std::size_t i = 0; i < found.numbers.size(); ++i) {
      const double size = std::max(size_of(found, gap.needed, i), size_of(found, gap.force, i));
      if (size > 0) gap.numbers.emplace_back(i, size);
    }
    std::stable_sort(gap.numbers.begin(), gap.numbers.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    gap.numbers.resize(std::min(gap.numbers.size(), most_bars));
  }
  std::erase_if(gaps, [](const OfGap& gap) { return gap.numbers.empty(); });
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const OfGap& a, const OfGap& b) { return a.numbers.front().second > b.numbers.front().second; });
  gaps.resize(std::min(gaps.size(), most_gaps_shown));
  return gaps;
}

/// @param room of a name above its bars [cm]
Panel panel_of(const Sensitivity& found, const OfGap& gap, double room, const FigureOptions& options) {
  Panel panel{.title = gap.name, .x = {.label = with_unit(word(options, "Change for 1 % more of the number"), "%")}};
  const std::size_t count = gap.numbers.size();
  const auto add = [&](const SensitivePeak* peak, Tone tone, const char* label, double shift) {
    if (peak == nullptr) return;
    bool is_named = false;
    for (std::size_t k = 0; k < count; ++k) {
      const double part = found.elasticity(*peak, gap.numbers[count - 1 - k].first);
      if (std::isnan(part)) continue;
      const double place = static_cast<double>(k) + shift;
      panel.curves.push_back(bar(std::min(0.0, part), std::max(0.0, part), place, thick, tone));
      if (!std::exchange(is_named, true)) panel.curves.back().label = word(options, label);
    }
  };
  const bool are_two = gap.needed != nullptr && gap.force != nullptr;
  add(gap.needed, Tone::black, "Gap needed", are_two ? thick / 2 : 0);
  add(gap.force, Tone::red, "Peak force", are_two ? -thick / 2 : 0);
  // The names stand above their bars: beside the frame there is no room for them.
  double low = 0, high = 0;
  for (const Curve& curve : panel.curves) {
    low = std::min(low, curve.x.front());
    high = std::max(high, curve.x.back());
  }
  const double margin = 0.04 * (high - low);
  panel.x.from = low - margin;
  panel.x.to = high + margin;
  panel.y = {.from = -0.5, .to = static_cast<double>(count) - 0.25, .numbers = false};
  for (std::size_t k = 0; k < count; ++k) {
    panel.texts.push_back({.x = *panel.x.from,
                           .y = static_cast<double>(k) + above,
                           .text = cut_to(found.numbers[gap.numbers[count - 1 - k].first].path, room)});
  }
  Curve zero{.width = 0.7, .complete = true, .in_legend = false};  // beside the bars alone: names stand over it
  for (std::size_t k = 0; k < count; ++k) {
    const double place = static_cast<double>(k), half = 1.2 * thick;
    zero.x.insert(zero.x.end(), {0, 0, not_known});
    zero.y.insert(zero.y.end(), {place - half, place + half, not_known});
  }
  panel.curves.push_back(std::move(zero));
  panel.height = 0.4 + 0.85 * static_cast<double>(count);
  return panel;
}

}  // namespace

Figure sensitivity_figure(const Sensitivity& found, const FigureOptions& options) {
  const std::vector<OfGap> gaps = gaps_of(found);
  if (gaps.empty()) throw NoFigure("no derivative of a gap is known");
  constexpr double wide = 12, margins = 0.9;  // [cm]
  Figure figure{.title = "By how much peaks change for 1 % more of a number",
                .columns = options.width >= wide ? static_cast<int>(gaps.size()) : 1,
                .width = options.width,
                .shared_legend = true};
  const double room = options.width / figure.columns - margins;  // of a name [cm]
  for (const OfGap& gap : gaps) figure.panels.push_back(panel_of(found, gap, room, options));
  const auto& [most, size] = gaps.front().numbers.front();
  figure.finding = word(options, "the most with {}: {} %", found.numbers[most].path, fmt::format("{:.2g}", size));
  return figure;
}

}  // namespace bentur
