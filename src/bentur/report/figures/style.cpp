#include <fmt/format.h>

#include <iterator>

#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/colours.h"

namespace bentur {

Tone building_tone(std::size_t index) {
  constexpr Tone tones[] = {Tone::blue, Tone::orange, Tone::green, Tone::purple, Tone::magenta, Tone::olive};
  return tones[index % std::size(tones)];
}

std::vector<std::pair<std::string, std::string>> palette() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Colour& one : colours) all.emplace_back(one.name, one.paper);
  return all;
}

std::string figure_style(bool by_attribute) {
  std::string light, dark, rules;
  const auto add = [&](const Colour& one) {
    light += fmt::format("--{}:{};", one.name, one.paper);
    dark += fmt::format("--{}:{};", one.name, one.dark);
    rules += fmt::format(".bentur .fill-{0}{{fill:var(--{0})}}.bentur .stroke-{0}{{stroke:var(--{0})}}", one.name);
  };
  for (const Colour& one : colours) add(one);
  add(paper);
  const char* const when = by_attribute ? "screen" : "screen and (prefers-color-scheme:dark)";
  const char* const where = by_attribute ? ":root[data-theme=dark] .bentur" : ".bentur";
  return fmt::format(".bentur{{{}}}{}@media {}{{{}{{{}}}}}", light, rules, when, where, dark);
}

}  // namespace bentur
