#include "bentur/report/figures/internal/legend.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"

namespace bentur {
namespace {

constexpr double between_entries = 0.25;  // of one line [cm]

/// Whether what follows a space is the unit of the number or of the label before it.
bool is_before_unit(const std::string& text, std::size_t space) {
  const auto is = [&](std::size_t at, int (*kind)(int)) {
    return at < text.size() && kind(static_cast<unsigned char>(text[at])) != 0;
  };
  return text.compare(space + 1, 1, "[") == 0 || (is(space - 1, std::isdigit) && is(space + 1, std::isalpha));
}

/// Where a line breaks that may end at `end` at the latest: behind a phrase, where one ends in its second half and what
/// follows still has room in `more` lines.
std::size_t phrase_end(const std::string& rest, std::size_t end, double width, std::size_t more) {
  for (std::size_t at = rest.rfind(' ', end); at != std::string::npos && at > 0; at = rest.rfind(' ', at - 1)) {
    if (text_width(rest.substr(0, at)) < width / 2) break;
    const bool ends_phrase = rest[at - 1] == ',' || rest[at - 1] == ';';
    if (ends_phrase && (more > 1 || text_width(rest.substr(at + 1)) <= width)) return at;
  }
  return end;
}

/// Places entries one behind the other, as many in a line as have room. @return how many lines they take
std::size_t arrange_in_turn(std::vector<LegendEntry>& list, double width) {
  std::size_t lines = 0;
  double end = width + 1;  // of the line so far
  for (LegendEntry& entry : list) {
    const double wide = sample_width + beside_sample + text_width(entry.label);
    if (end + wide > width) {
      ++lines;
      end = 0;
    }
    entry.x = end;
    entry.y = -(static_cast<double>(lines) - 0.5) * line_height;
    end += wide + between_entries;
  }
  return lines;
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text, double width, std::size_t most) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (!rest.empty()) {
    std::size_t end = rest.size();
    while (lines.size() + 1 < most && end != std::string::npos && end > 0 && text_width(rest.substr(0, end)) > width) {
      do end = end > 0 ? rest.rfind(' ', end - 1) : std::string::npos;
      while (end != std::string::npos && is_before_unit(rest, end));
    }
    if (end == std::string::npos || end == 0) end = std::min(rest.find(' '), rest.size());
    if (end < rest.size()) end = phrase_end(rest, end, width, most - lines.size() - 1);
    lines.push_back(cut_to(rest.substr(0, end), width));
    rest = end < rest.size() ? rest.substr(end + 1) : "";
  }
  return lines;
}

void add_entries(const PlacedPanel& placed, std::vector<LegendEntry>& list) {
  const auto add = [&](LegendEntry entry) {
    entry.label = plain_text(entry.label);
    const bool is_there = std::any_of(list.begin(), list.end(), [&](const LegendEntry& one) {
      return one.label == entry.label && one.event == entry.event;
    });
    if (!entry.label.empty() && !is_there) list.push_back(std::move(entry));
  };
  const Panel& panel = *placed.panel;
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    const auto is_of = [&](const CurveName& name) { return name.curve == c; };
    if (!curve.in_legend || std::any_of(placed.names.begin(), placed.names.end(), is_of)) continue;
    add({curve.label, curve.tone, curve.line, curve.mark == Mark::none ? curve.legend_mark : curve.mark,
         std::max(1.0, curve.width), !curve.top.empty(), false, curve.is_bar, curve.mark_size});
  }
  for (const RuleLine& rule : panel.rules) add({.label = rule.label, .tone = rule.tone, .line = rule.line});
  if (!panel.events.x.empty()) add({.label = panel.events.label, .tone = Tone::grey, .event = true});
}

double arrange(std::vector<LegendEntry>& list, double width) {
  if (list.empty()) return 0;
  const double room = std::max(0.7, width - sample_width - 0.1);
  double longest = 0;
  std::vector<LegendEntry> entries;
  for (LegendEntry& entry : list) {
    const std::vector<std::string> lines = lines_of(entry.label, room, most_lines);
    for (const std::string& line : lines) {
      longest = std::max(longest, text_width(line));
      entries.push_back({.label = line});
      if (&line != &lines.front()) continue;
      entries.back() = entry;
      entries.back().label = line;
    }
  }
  const bool is_divided = entries.size() > list.size();
  list = std::move(entries);
  const double step = sample_width + beside_sample + between_entries + longest;
  const auto fitting = std::min(static_cast<std::size_t>(std::max(1.0, (width + between_entries) / step)), list.size());
  const std::size_t rows = is_divided ? list.size() : (list.size() + fitting - 1) / fitting;
  const std::size_t columns = (list.size() + rows - 1) / rows;
  if (const std::size_t lines = is_divided ? rows : arrange_in_turn(list, width); lines + 1 < rows) {
    return static_cast<double>(lines) * line_height;
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i].x = static_cast<double>(i % columns) * step;
    const std::size_t row = i / columns;
    list[i].y = -(static_cast<double>(row) + 0.5) * line_height;
  }
  return static_cast<double>(rows) * line_height;
}

void centre(std::vector<LegendEntry>& list, double middle, double width) {
  double end = 0;
  for (const LegendEntry& entry : list) end = std::max(end, entry.x + sample_width + 0.1 + text_width(entry.label));
  const double right = std::max(0.0, std::min(middle - end / 2, width - end));
  for (LegendEntry& entry : list) entry.x += right;
}

void shift(std::vector<LegendEntry>& list, double right, double up) {
  for (LegendEntry& entry : list) {
    entry.x += right;
    entry.y += up;
  }
}

}  // namespace bentur
