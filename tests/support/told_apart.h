#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/colours.h"

namespace bentur::test {

/// On paper without colours the entries of a legend that have the same dashes and marks differ in grey: by 1.5, of
/// which an eye sees two lines side by side as different; dashes, marks and areas it sees in any grey.
inline void expect_told_apart_in_grey(const Figure& figure, const std::string& name) {
  struct Entry {
    std::string label, look;
    std::string_view tone;
  };
  std::vector<Entry> entries;
  for (const Panel& panel : figure.panels) {
    if (!figure.shared_legend) entries.clear();
    const auto add = [&](const std::string& label, const std::string& look, Tone tone) {
      const Entry entry{label, look, colour(tone).paper};
      for (const Entry& other : entries) {
        if (other.label == entry.label || other.look != entry.look) continue;
        EXPECT_GE(contrast(other.tone, entry.tone), 1.5) << name << ": " << other.label << " and " << entry.label;
      }
      entries.push_back(entry);
    };
    const auto look = [](const char* kind, Line line, Mark mark, double size) {
      return std::string(kind) + std::to_string(static_cast<int>(line)) + "/" + std::to_string(static_cast<int>(mark)) +
             "/" + std::to_string(mark == Mark::none ? 1 : size);
    };
    for (const Curve& curve : panel.curves) {
      if (curve.label.empty() || !curve.in_legend) continue;
      const Mark mark = curve.mark == Mark::none ? curve.legend_mark : curve.mark;
      add(curve.label, look(curve.top.empty() ? "" : "area", curve.line, mark, curve.mark_size), curve.tone);
    }
    for (const RuleLine& rule : panel.rules) {
      if (!rule.label.empty()) add(rule.label, look("rule", rule.line, Mark::none, 1), rule.tone);
    }
  }
}

}  // namespace bentur::test
