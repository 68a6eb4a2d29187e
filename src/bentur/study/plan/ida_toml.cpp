#include <fmt/format.h>

#include <algorithm>

#include "bentur/study/plan/internal/study_parts.h"
#include "bentur/study/plan/study_keys.h"

namespace bentur {
namespace {

std::vector<double> read_levels(const TableView& view) {
  const auto form = view.exactly_one("levels");
  if (form == "from") return read_steps(view);
  if (!form) return {};
  view.refuse({"to", "count", "spacing"}, "goes with from");
  const TomlView list = *view.find("levels");
  std::vector<double> levels = view.numbers("levels");
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (!(levels[i] > levels[i - 1])) {
      list.item(i).error_value(fmt::format("must be more than the one before, {}", levels[i - 1]));
    }
  }
  return levels;
}

}  // namespace

std::optional<IdaSpec> read_ida(const TomlView& root) {
  const auto given = root.find("ida");
  if (!given) return std::nullopt;
  IdaSpec spec;
  spec.position = given->position();
  const auto view = TableView::of(*given, ida_keys());
  if (!view) return spec;
  root.refuse({"sampling"}, "does not go with [ida], whose runs are a grid");
  const auto intensity = view->word("intensity");
  spec.spectral = intensity == "sa";
  if (spec.spectral) {
    spec.period = view->number("period").value_or(1);
    spec.damping = view->number("damping").value_or(spec.damping);
  }
  if (const auto component = view->word("component")) {
    const auto& words = ida_keys().at("component").words;
    spec.component = static_cast<IntensityOf>(std::find(words.begin(), words.end(), *component) - words.begin());
  }
  spec.unit = view->word("unit").value_or("");
  spec.levels = read_levels(*view);
  spec.polarity = view->word("polarity").value_or("");
  return spec;
}

}  // namespace bentur
