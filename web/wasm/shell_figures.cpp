#include <emscripten/val.h>

#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/kinds/figure_width.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"
#include "shell.h"

namespace bentur::web {
namespace {

using emscripten::val;

/// A copy: memory of WebAssembly moves when it grows.
val array(const std::vector<double>& values) {
  return val::global("Float64Array").new_(val(emscripten::typed_memory_view(values.size(), values.data())));
}

/// One array for each row.
val rows(const Eigen::MatrixXd& matrix) {
  val list = val::array();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    std::vector<double> values(static_cast<std::size_t>(matrix.cols()));
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) values[static_cast<std::size_t>(k)] = matrix(row, k);
    list.call<void>("push", array(values));
  }
  return list;
}

std::vector<double> numbers(const val& given) { return emscripten::convertJSArrayToNumberVector<double>(given); }

std::optional<double> number(const val& given) {
  return given.isNumber() ? std::optional(given.as<double>()) : std::nullopt;
}

FigureOptions options_of(const std::string& language, const val& wanted) {
  FigureOptions options;
  options.say = figure_words(language);
  options.language = language;
  options.choose = true;
  options.width = number(wanted["width"]).value_or(column_width);
  options.narrow = wanted["narrow"].isTrue();
  options.from = number(wanted["from"]);
  options.to = number(wanted["to"]);
  options.elevation = number(wanted["elevation"]);
  if (const auto gap = number(wanted["gap"])) options.gap = static_cast<std::size_t>(*gap);
  return options;
}

GapCurve gap_curve(const RunResults& run, const val& given) {
  const auto gap = static_cast<Eigen::Index>(given["gap"].as<double>());
  const GapOutcome found = gap_outcome(run.problem, run.response, gap);
  return {.name = gap_name(run.problem, gap),
          .widths = numbers(given["widths"]),
          .forces = numbers(given["forces"]),
          .amplifications = numbers(given["amplifications"]),
          .given = found.governing.width,
          .needed = found.governing.gap_needed,
          .length = run.c.units.length,
          .force_unit = run.c.units.force};
}

Figure figure_of(const RunResults& run, const std::string& kind, const FigureOptions& options, const val& wanted) {
  if (kind == "gap-curve") return gap_curve_figure(gap_curve(run, wanted["curve"]), options);
  return make_figure(run, kind, options);
}

val axis(const std::string& label, const std::pair<double, double>& ends, bool logarithmic) {
  val one = val::object();
  one.set("label", label);
  one.set("from", ends.first);
  one.set("to", ends.second);
  one.set("logarithmic", logarithmic);
  return one;
}

val panel_of(const Panel& panel, const PanelPlace& place) {
  val one = val::object();
  one.set("left", place.left);
  one.set("top", place.top);
  one.set("width", place.width);
  one.set("height", place.height);
  one.set("x", axis(panel.x.label, place.x, place.x_logarithmic));
  one.set("y", axis(panel.y.label, place.y, place.y_logarithmic));
  val curves = val::array();
  for (const Curve& curve : panel.curves) {
    if (!curve.top.empty()) continue;  // an area
    val drawn = val::object();
    drawn.set("label", curve.label);
    drawn.set("x", array(curve.x));
    drawn.set("y", array(curve.y));
    curves.call<void>("push", drawn);
  }
  one.set("curves", curves);
  return one;
}

}  // namespace

val Studio::draw(const std::string& kind, const std::string& language, const val& wanted) const {
  val drawn = val::object();
  try {
    if (!run_ && !plan_run_ && !suite_run_) return drawn;
    const FigureOptions options = options_of(language, wanted);
    const MakeFigure make = [&](const FigureOptions& with) {
      return plan_run_    ? make_figure(*plan_run_, kind, with)
             : suite_run_ ? make_figure(*suite_run_, *suite_gaps_, kind, with)
                          : figure_of(*run_, kind, with, wanted);
    };
    const Figure figure = options.narrow ? narrow_figure(make, options) : make(options);
    const std::string key = caption_key(kind, plan_run_.has_value());
    std::string caption = Words(language)(key + (figure.lacks.empty() ? "" : ".without_" + figure.lacks));
    if (!figure.part.empty()) caption += ". " + figure.part;
    const PlacedFigure placed = placed_figure(figure, caption);
    drawn.set("svg", placed.svg);
    drawn.set("caption", caption);
    drawn.set("width", figure.width);
    val panels = val::array();
    for (std::size_t i = 0; i < placed.panels.size(); ++i) {
      panels.call<void>("push", panel_of(figure.panels[i], placed.panels[i]));
    }
    drawn.set("panels", panels);
  } catch (const std::exception& error) {
    drawn.set("error", std::string(error.what()));
  }
  return drawn;
}

std::string Studio::figure_file(const std::string& kind, const std::string& language, const val& wanted) const {
  try {
    const FigureOptions options = options_of(language, wanted);
    if (plan_run_) return figure_svg(make_figure(*plan_run_, kind, options));
    if (suite_run_) return figure_svg(make_figure(*suite_run_, *suite_gaps_, kind, options));
    return run_ ? figure_svg(figure_of(*run_, kind, options, wanted)) : "";
  } catch (const std::exception&) {
    return "";
  }
}

namespace {

val histories_of(const PlanHistories& histories) {
  val all = val::object();
  all.set("time", array(histories.time));
  all.set("ground", rows(histories.ground_acceleration));
  all.set("opening", rows(histories.opening));
  all.set("force", rows(histories.force));
  val buildings = val::array();
  for (std::size_t b = 0; b < histories.x.size(); ++b) {
    val one = val::object();
    one.set("displacement_x", rows(histories.x[b]));
    one.set("displacement_y", rows(histories.y[b]));
    one.set("rotation", rows(histories.rotation[b]));
    buildings.call<void>("push", one);
  }
  all.set("buildings", buildings);
  return all;
}

}  // namespace

val Studio::histories() const {
  val all = val::object();
  if (plan_run_) return histories_of(plan_run_->response.histories);
  if (!run_) return all;
  const Histories& histories = run_->response.histories;
  all.set("time", array(histories.time));
  val ground = val::array();
  ground.call<void>("push", array(histories.ground_acceleration));
  all.set("ground", ground);
  all.set("opening", rows(histories.opening));
  all.set("force", rows(histories.force));
  val buildings = val::array();
  for (std::size_t b = 0; b < histories.displacement.size(); ++b) {
    val one = val::object();
    one.set("displacement", rows(histories.displacement[b]));
    one.set("drift", rows(histories.drift_ratio[b]));
    one.set("shear", rows(histories.storey_shear[b]));
    buildings.call<void>("push", one);
  }
  all.set("buildings", buildings);
  return all;
}

}  // namespace bentur::web
