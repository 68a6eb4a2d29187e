#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "bentur/core/number_text.h"
#include "bentur/study/sensitivity/sensitivity.h"

namespace bentur {
namespace {

constexpr double grazes = 1e-3;         // of the usual speed: a contact that sets in more slowly
constexpr double small_part = 0.01;     // of the largest elasticity: numbers below are not shown
constexpr std::size_t most_shown = 20;  // numbers in a table

/// The number that a peak changes with most; nothing where none has an elasticity.
std::optional<std::size_t> most_of(const Sensitivity& found, const SensitivePeak& peak) {
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < found.numbers.size(); ++i) {
    const double part = std::abs(found.elasticity(peak, i));
    if (!std::isnan(part) && (!most || part > std::abs(found.elasticity(peak, *most)))) most = i;
  }
  return most;
}

/// Three digits, no more than a reader of percentages wants.
double to_shown(double x) {
  constexpr double digits = 1e3;
  return std::round(digits * x) / digits;
}

void say_peak(const Sensitivity& found, const SensitivePeak& peak, std::vector<Statement>& statements) {
  const Derivative& of = peak.derivative;
  const bool of_force = peak.kind == SensitivePeak::Kind::peak_force;
  const bool is_mean = found.takes_mean && !found.records.empty();
  const std::string kind =
      "sensitivity_" + std::string(key_of(peak.kind)) + (of_force && is_mean ? "_mean" : "");  // at no one time
  const std::optional<std::size_t> most = most_of(found, peak);
  if (!most) return;
  const double elasticity = found.elasticity(peak, *most);
  const std::vector<StoryValue> values = {
      {"name", peak.name},
      {"value", of.value, of_force ? found.units.force : found.units.length},
      {"level", peak.level, found.units.length},
      {"time", of.time, "s"},
      {"number", found.numbers[*most].path},
      {"part", std::abs(to_shown(elasticity)), "%"},
      {"way", std::string(elasticity < 0 ? "story.sensitivity_less" : "story.sensitivity_more"), {}, true}};
  statements.push_back({.kind = kind, .values = values});
  if (!peak.record.empty()) {
    statements.push_back(
        {.kind = "sensitivity_under", .values = {{"name", peak.name}, values[1], values[2], {"record", peak.record}}});
  }
  const auto warn = [&](const char* why) {
    statements.push_back({.kind = why, .severity = Severity::warning, .values = values});
  };
  if (of.grazing < grazes) warn("sensitivity_grazing");
  if (of.is_simultaneous) warn("sensitivity_simultaneous");
  if (of.is_equalled) warn(is_mean ? "sensitivity_equalled_mean" : "sensitivity_equalled");
}

/// The numbers that matter, with what the largest peaks change by. @param shown marks them
StoryTable sensitivity_table(const Sensitivity& found, const std::vector<const SensitivePeak*>& peaks,
                             std::vector<bool>& shown) {
  std::vector<double> largest(found.numbers.size(), 0.0);
  for (const SensitivePeak* peak : peaks) {
    for (std::size_t i = 0; i < largest.size(); ++i) {
      largest[i] = std::max(largest[i], std::abs(found.elasticity(*peak, i)));
    }
  }
  std::vector<std::size_t> order(largest.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return largest[a] > largest[b]; });
  std::erase_if(order, [&](std::size_t i) { return found.numbers[i].is_of_footprint; });
  order.resize(std::min(order.size(), most_shown));
  while (!order.empty() && largest[order.back()] < small_part * largest[order.front()]) order.pop_back();
  for (const std::size_t i : order) shown[i] = true;
  StoryTable table{.kind = "sensitivity"};
  StoryColumn names{.label = "column.number"}, values{.label = "column.value"};
  for (const std::size_t i : order) {
    names.texts.push_back(found.numbers[i].path);
    values.texts.push_back(number(found.numbers[i].value));
  }
  values.are_counts = true;
  table.columns = {std::move(names), std::move(values)};
  for (const SensitivePeak* peak : peaks) {
    StoryColumn column{.label = "column.sensitivity_" + std::string(key_of(peak->kind)), .unit = "%"};
    for (const std::size_t i : order) column.numbers.push_back(to_shown(found.elasticity(*peak, i)));
    table.columns.push_back(std::move(column));
  }
  return table;
}

}  // namespace

Story sensitivity_story(const Sensitivity& found) {
  Story story;
  std::vector<const SensitivePeak*> largest;
  for (const SensitivePeak& peak : found.peaks) {
    if (peak.is_largest && !found.numbers.empty()) largest.push_back(&peak);
  }
  if (!found.records.empty()) {
    std::string scales;
    for (const std::string& scale : found.scales) scales += (scales.empty() ? "" : ", ") + scale;
    story.statements.push_back({.kind = found.takes_mean ? "sensitivity_takes_mean" : "sensitivity_takes_largest",
                                .values = {{"records", static_cast<long>(found.records.size())}, {"scales", scales}}});
  }
  for (const SensitivePeak* peak : largest) say_peak(found, *peak, story.statements);
  // One table for each gap or building.
  std::vector<bool> shown(found.numbers.size(), false);
  for (auto at = largest.begin(); at != largest.end();) {
    const auto end =
        std::find_if(at, largest.end(), [&](const SensitivePeak* one) { return one->name != (*at)->name; });
    StoryTable table = sensitivity_table(found, {at, end}, shown);
    table.values = {{"name", (*at)->name}};
    story.tables.push_back(std::move(table));
    at = end;
  }
  if (largest.empty()) story.statements.push_back({.kind = "sensitivity_none", .severity = Severity::warning});
  const auto footprints = std::count_if(found.numbers.begin(), found.numbers.end(),
                                        [](const CaseNumber& number) { return number.is_of_footprint; });
  const auto rest = std::count(shown.begin(), shown.end(), false) - footprints;
  if (rest > 0 && !largest.empty()) {
    double most = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      for (const SensitivePeak* const peak : largest) {
        if (!shown[i]) most = std::max(most, std::abs(found.elasticity(*peak, i)));
      }
    }
    const long rows = static_cast<long>(most_shown);
    story.statements.push_back(
        {.kind = "sensitivity_rest",
         .values = {{"rows", rows}, {"count", static_cast<long>(rest)}, {"part", to_shown(most), "%"}}});
  }
  if (footprints > 0 && !largest.empty()) {
    story.statements.push_back({.kind = "sensitivity_footprints", .severity = Severity::remark});
  }
  if (!found.left_out.empty()) {
    std::string list;
    for (const auto& [path, why] : found.left_out) list += (list.empty() ? "" : ", ") + path;
    story.statements.push_back(
        {.kind = "sensitivity_left_out", .severity = Severity::remark, .values = {{"list", list}}});
  }
  return story;
}

}  // namespace bentur
