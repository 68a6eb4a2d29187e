#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/colours.h"

namespace bentur {
namespace {

/// Variables of the elements that `where` names, and what figures ask of them.
std::string style(const char* where, bool with_page) {
  std::string light, dark, rules;
  const auto add = [&](const Colour& one) {
    light += fmt::format("--{}:{};", one.name, one.paper);
    dark += fmt::format("--{}:{};", one.name, one.dark);
  };
  const auto draw_in = [&](const Colour& one) {
    add(one);
    rules += fmt::format(".bentur .fill-{0}{{fill:var(--{0})}}.bentur .stroke-{0}{{stroke:var(--{0})}}", one.name);
  };
  for (const Colour& one : colours) draw_in(one);
  draw_in(paper);
  for (const Colour& one : page_colours) {
    if (with_page) add(one);
  }
  return fmt::format("{0}{{{1}}}{2}@media screen and (prefers-color-scheme:dark){{{0}{{{3}}}}}", where, light, rules,
                     dark);
}

}  // namespace

Tone building_tone(std::size_t index, std::size_t count, const BuildingPair& struck, const BuildingPair& worst) {
  if (count <= std::size(building_tones)) return building_tones[index % std::size(building_tones)];
  if (struck && index == struck->first) return building_tones[0];
  if (struck && index == struck->second) return building_tones[1];
  const auto is_dark = [&](std::size_t b) { return (b + (struck ? struck->first : 0)) % 2 == 0; };  // as those by turns
  if (worst && (index == worst->first || index == worst->second)) {
    const bool is_first_dark = is_dark(worst->first) || !is_dark(worst->second);
    return building_tones[(index == worst->first) == is_first_dark ? 2 : 3];
  }
  return is_dark(index) ? Tone::bark : Tone::stone;
}

bool are_distinct_in_grey(Tone one, Tone other) {
  constexpr double least = 1.8;
  return contrast(colour(one).paper, colour(other).paper) >= least;
}

std::vector<std::pair<std::string, std::string>> palette() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Colour& one : colours) all.emplace_back(one.name, one.paper);
  return all;
}

std::vector<std::string> building_colours() {
  std::vector<std::string> all;
  for (const Tone tone : building_tones) all.emplace_back(colour(tone).paper);
  return all;
}

std::string figure_style() { return style(".bentur", false); }
std::string page_style() { return style(":root", true); }

double contrast(std::string_view one, std::string_view other) {
  const auto luminance = [](std::string_view colour) {
    constexpr double weights[] = {0.2126, 0.7152, 0.0722};
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double part = std::stoi(std::string(colour.substr(1 + 2 * c, 2)), nullptr, 16) / 255.0;
      sum += weights[c] * (part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
    }
    return sum;
  };
  const auto [darker, lighter] = std::minmax({luminance(one), luminance(other)});
  return (lighter + 0.05) / (darker + 0.05);
}

std::string shade(double part, bool ratio) {
  const Rgb* stops = ratio ? both_ways : one_way;
  const std::size_t last = (ratio ? std::size(both_ways) : std::size(one_way)) - 1;
  const double at = std::clamp(part, 0.0, 1.0) * static_cast<double>(last);
  const std::size_t below = std::min(static_cast<std::size_t>(at), last - 1);
  const double beyond = at - static_cast<double>(below);
  std::string text = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    text += fmt::format("{:02x}", std::lround(stops[below][c] + beyond * (stops[below + 1][c] - stops[below][c])));
  }
  return text;
}

}  // namespace bentur
