#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bentur/excitation/usual_peaks.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/study/design/internal/study_parts.h"
#include "bentur/study/design/record_intensity.h"
#include "bentur/study/design/study_keys.h"
#include "bentur/study/design/sweep_design.h"

namespace bentur {
namespace {

constexpr const char* unscaled = "unscaled";

std::vector<double> read_levels(const TableView& view) {
  const auto form = view.exactly_one("levels");
  if (form == "from") return read_steps(view);
  if (!form) return {};
  view.refuse({"to", "count", "spacing"}, "goes with from");
  const TomlView list = *view.find("levels");
  if (list.is(TomlValue::Kind::text)) {
    (void)list.as_word({unscaled});
    return {};
  }
  std::vector<double> levels = view.numbers("levels");
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (!(levels[i] > levels[i - 1])) {
      list.item(i).error_value(fmt::format("must be more than the one before, {}", levels[i - 1]));
    }
  }
  return levels;
}

/// One of many by the numbers of its places; of none nothing.
template <class T>
void reorder(std::vector<T>& list, const std::vector<std::size_t>& places) {
  if (list.empty()) return;
  std::vector<T> result;
  for (const std::size_t place : places) result.push_back(list[place]);
  list = std::move(result);
}

}  // namespace

std::optional<IdaSpec> read_ida(const TomlView& root) {
  const auto given = root.find("ida");
  if (!given) return std::nullopt;
  IdaSpec spec;
  spec.position = given->position();
  const auto view = TableView::of(*given, ida_keys());
  if (!view) return spec;
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
  const auto levels = view->find("levels");
  spec.is_cloud = levels && levels->is(TomlValue::Kind::text);
  spec.polarity = view->word("polarity").value_or("");
  return spec;
}

void expect_unit_of_levels(const TomlView& root, const Study& study) {
  const IdaSpec& ida = *study.ida;
  if (!ida.unit.empty() || ida.levels.empty()) return;
  Diagnostics ignored;
  const std::string name = study.case_file.string();
  const Units units = read_units(TomlView(study.case_root, "", name, ignored));
  const double most = ida.levels.back();
  if (!is_rather_in_g(most, most / units.gravity)) return;
  const TomlView view = *root.find("ida");
  const auto levels = view.find("levels");
  (levels ? *levels : *view.find("to"))
      .error(
          fmt::format("has no unit and is in {0}/s2 of the case, up to {1:.4g} g: give unit = \"g\" if that is meant, "
                      "else unit = \"{0}/s2\"",
                      units.length, most / units.gravity));
}

void check_cloud(const TomlView& root, const Study& study) {
  const TomlView levels = *root.find("ida")->find("levels");
  if (study.suite) {
    levels.error_value("takes records as their files have them, and the case has a suite, which scales them");
  } else if (study.ida->normalised) {
    levels.error_value("takes records as their files have them, and normalisation scales them");
  } else if (record_axes(study, false).axes.empty()) {
    levels.error_value("needs records, each with an intensity of its own: a [[vary]] of excitation.file");
  }
}

void draw_with_records(const TomlView& root, Study& study) {
  if (study.sampling.method == Sampling::Method::grid || draw_together(study)) return;
  root.find("sampling")->error("needs records to draw from beside [ida]: a [[vary]] with files, or a suite");
}

bool draw_together(Study& study) {
  const auto is_polarity = [&](std::size_t axis) {
    return study.first_along(axis).path == ParameterPath{"excitation", "polarity"};
  };
  if (record_axes(study, false).axes.empty()) return false;
  // Directions in which a record is applied stay beside the draws, each of which has both.
  std::vector<SweepAxis> drawn;
  std::vector<std::size_t> numbers(study.axes.size(), 0);
  std::vector<char> polarity;
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
    polarity.push_back(is_polarity(axis) ? 1 : 0);
    if (polarity.back() != 0) continue;
    const Vary& first = study.first_along(axis);
    numbers[axis] = drawn.size();
    drawn.push_back({.levels = first.distribution ? 0 : first.values.size()});
  }
  const SweepDesign design(drawn, study.sampling);
  std::vector<std::string> axes = {"draw"};
  for (Vary& vary : study.varies) {
    const std::size_t axis = numbers[vary.axis];
    if (polarity[vary.axis] != 0) {
      vary.axis = axes.size();
      axes.push_back(vary.name);
      continue;
    }
    vary.axis = 0;
    if (vary.distribution) {
      for (std::size_t n = 0; n < design.runs(); ++n) {
        vary.values.push_back(toml_number(*chosen_number(vary, {.u = design.unit(n, axis)})));
      }
      vary.distribution.reset();
      continue;
    }
    std::vector<std::size_t> places(design.runs());
    for (std::size_t n = 0; n < places.size(); ++n) places[n] = design.level(n, axis);
    reorder(vary.values, places);
    reorder(vary.labels, places);
    reorder(vary.normalisation, places);
    for (FileKey& key : vary.file_keys) reorder(key.values, places);
    vary.ends_decide = false;
  }
  study.axes = std::move(axes);
  study.sampling = {};
  return true;
}

}  // namespace bentur
