#include <fmt/format.h>

#include "bentur/core/units.h"
#include "bentur/study/plan/internal/study_parts.h"

namespace bentur {
namespace {

std::vector<double> read_levels(const TomlView& view) {
  const auto form = view.exactly_one({"levels", "from"});
  if (form == "from") return read_steps(view, Rule::positive);
  if (!form) return {};
  view.refuse({"to", "count", "spacing"}, "goes with from");
  const TomlView list = *view.find("levels");
  std::vector<double> levels = list.as_numbers(Rule::positive);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (!(levels[i] > levels[i - 1])) {
      list.item(i).error_value(fmt::format("must be more than the one before, {}", levels[i - 1]));
    }
  }
  return levels;
}

}  // namespace

std::optional<IdaSpec> read_ida(const TomlView& root) {
  const auto view = root.find("ida");
  if (!view) return std::nullopt;
  IdaSpec spec;
  spec.position = view->position();
  if (!view->is_table_of(
          {"intensity", "period", "damping", "unit", "levels", "from", "to", "count", "spacing", "polarity"})) {
    return spec;
  }
  root.refuse({"sampling"}, "does not go with [ida], whose runs are a grid");
  const auto intensity = view->word("intensity", {"pga", "sa"});
  spec.spectral = intensity == "sa";
  if (spec.spectral) {
    spec.period = view->number("period", Rule::positive).value_or(1);
    spec.damping = view->number("damping", Rule::ratio, Need::optional).value_or(spec.damping);
  } else if (intensity) {
    view->refuse({"period", "damping"}, "goes with intensity = \"sa\"");
  }
  spec.unit = view->word("unit", acceleration_units(), Need::optional).value_or("");
  spec.levels = read_levels(*view);
  spec.polarity = view->word("polarity", {"as-recorded", "reversed", "both"}, Need::optional).value_or("");
  return spec;
}

}  // namespace bentur
