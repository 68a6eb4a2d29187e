#include "bentur/report/studies/file_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "bentur/files/result_reading.h"
#include "bentur/io/results/run_variables.h"
#include "bentur/model/quantities.h"
#include "bentur/report/figures/internal/visible.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/studies/sweep_data.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

[[noreturn]] void refuse(const NetcdfReader& results) {
  throw NoFigure(results.name() +
                 ": is neither histories.nc of this version of bentur run nor results of bentur sweep");
}

bool some_collapse(const NetcdfReader& results) {
  if (results.find("collapsed") == nullptr) return false;
  const std::vector<double> collapsed = results.numbers("collapsed");
  return std::any_of(collapsed.begin(), collapsed.end(), [](double one) { return one > 0; });
}

bool is_in(const NetcdfReader& results, const SweepKind& kind) { return !variables_of(results, kind.quantity).empty(); }

}  // namespace

std::vector<FigureKind> figure_kinds(const NetcdfReader& results) {
  if (is_any_run(results)) {
    return std::visit([](const auto& run) { return figure_kinds(run); }, read_any_results(results));
  }
  if (results.find("status") == nullptr) refuse(results);
  std::vector<FigureKind> kinds;
  if (is_ida(results)) {
    if (is_cloud(results)) {
      if (is_in(results, {"gap-needed", "gap_needed", ""})) {
        kinds.push_back({"cloud", "gap needed of every record against its intensity, with the line of the cloud"});
      }
    } else {
      kinds.push_back({"ida", "peak contact force of every record at growing intensity, with fractiles"});
    }
    kinds.push_back({"fragility", "probability of pounding against intensity, with bounds"});
    if (some_collapse(results)) {
      kinds.push_back({"collapse", "probability of collapse against intensity, with bounds"});
    }
  }
  for (const SweepKind& kind : sweep_kinds()) {
    if (is_in(results, kind)) kinds.push_back({kind.kind, kind.label + " against what varies"});
  }
  return kinds;
}

Figure make_figure(const NetcdfReader& results, const std::string& kind, const FigureOptions& options) {
  if (is_any_run(results)) {
    return std::visit([&](const auto& run) { return make_figure(run, kind, options); }, read_any_results(results));
  }
  if (results.find("status") != nullptr) {
    const SweepData sweep(results, options.say);
    const auto titled = [&](Figure figure) {
      std::erase_if(figure.panels,
                    [](const Panel& panel) { return is_empty(panel); });  // of a choice whose every run failed
      if (figure.panels.empty()) throw NoFigure("no run has succeeded");
      figure.title = figure_title(options.language, "figure.sweep." + kind, std::move(figure.title));
      return figure;
    };
    if (is_ida(results) && !is_cloud(results) && kind == "ida") return titled(ida_figure(sweep, options));
    if (is_cloud(results) && kind == "cloud") return titled(cloud_figure(sweep, options));
    if (is_ida(results) && kind == "fragility") return titled(fragility_figure(sweep, options));
    if (is_ida(results) && kind == "event") return titled(fragility_figure(sweep, options));
    if (is_ida(results) && kind == "collapse") {
      FigureOptions of_collapse = options;
      of_collapse.event = collapse_event;
      return titled(fragility_figure(sweep, of_collapse));
    }
    for (const SweepKind& one : sweep_kinds()) {
      if (kind == one.kind && is_in(results, one)) return titled(sweep_figure(sweep, one, options));
    }
    // Any other quantity by its own name.
    const auto is_it = [&](const Quantity& one) { return file_name(one) == kind && one.owner != Owner::impact; };
    const auto quantity = std::find_if(quantities().begin(), quantities().end(), is_it);
    if (quantity != quantities().end()) {
      const SweepKind by_name{kind, kind, std::string(quantity->long_name)};
      if (is_in(results, by_name)) return sweep_figure(sweep, by_name, options);
    }
  }
  refuse_figure(kind, results.name(), figure_kinds(results));
}

}  // namespace bentur
