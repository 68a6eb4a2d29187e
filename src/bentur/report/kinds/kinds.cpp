#include "bentur/report/kinds/kinds.h"

#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/diagnostics.h"
#include "bentur/model/quantities.h"
#include "bentur/report/kinds/internal/run_data.h"
#include "bentur/report/kinds/internal/sweep_data.h"

namespace bentur {
namespace {

struct RunKind {
  const char* name;
  const char* shows;
  const char* needs;  ///< a variable without which there is none
  Figure (*make)(const RunData&, const FigureOptions&);
};

const RunKind run_kinds[] = {
    {"displacement", "displacements of both buildings at one contact point, contacts marked", "opening",
     displacement_figure},
    {"opening", "opening of the gap at one contact point", "opening", opening_figure},
    {"force", "contact force at one contact point", "impact_start", force_figure},
    {"impact", "the hardest impact in close-up: shortening and force", "close_up_time", impact_figure},
    {"loop", "force against shortening in the hardest impact", "close_up_time", loop_figure},
    {"envelope", "largest displacements over the height, with and without contact", "time", envelope_figure},
    {"amplification", "largest displacement with contact over that without, over the height", "time",
     amplification_figure},
    {"modes", "mode shapes of each building", "time", modes_figure},
    {"energy", "where the energy is", "energy_input", energy_figure},
    {"spectrum", "response spectra of the ground motion, with the buildings' periods", "spectrum_period",
     run_spectrum_figure},
};

bool is_run(const NetcdfReader& results) {
  return results.find("building_name") != nullptr && results.find("displacement_1") != nullptr &&
         results.find("shape_1") != nullptr;
}

[[noreturn]] void refuse(const NetcdfReader& results) {
  throw NoFigure(results.name() +
                 ": is neither histories.nc of this version of bentur run nor results of bentur sweep");
}

bool has_impact_force(const NetcdfReader& results) {
  const std::vector<double> forces = results.numbers("impact_peak_force");
  return std::any_of(forces.begin(), forces.end(), [](double force) { return force > 0; });
}

bool can(const NetcdfReader& results, const RunKind& kind) {
  if (results.find(kind.needs) == nullptr) return false;
  return std::string(kind.name) != "force" || has_impact_force(results);
}

/// Of contact points there are none where a study models no contact.
bool has_quantity(const NetcdfReader& results, const SweepKind& kind) {
  return results.find(kind.quantity) != nullptr || results.find(kind.quantity + "_1") != nullptr;
}

}  // namespace

std::vector<FigureKind> figure_kinds(const NetcdfReader& results) {
  std::vector<FigureKind> kinds;
  if (is_run(results)) {
    for (const RunKind& kind : run_kinds) {
      if (can(results, kind)) kinds.push_back({kind.name, kind.shows});
    }
    return kinds;
  }
  if (results.find("status") == nullptr) refuse(results);
  if (is_ida(results)) {
    kinds.push_back({"ida", "peak contact force of every record at growing intensity, with fractiles"});
    kinds.push_back({"fragility", "probability of pounding against intensity, with bounds"});
  }
  for (const SweepKind& kind : sweep_kinds()) {
    if (has_quantity(results, kind)) kinds.push_back({kind.kind, kind.label + " against what varies"});
  }
  return kinds;
}

std::vector<std::string> run_figure_names() {
  std::vector<std::string> names;
  for (const RunKind& kind : run_kinds) names.emplace_back(kind.name);
  return names;
}

Figure make_figure(const NetcdfReader& results, const std::string& kind, const FigureOptions& options) {
  if (is_run(results)) {
    for (const RunKind& one : run_kinds) {
      if (kind == one.name) return one.make(RunData(results), options);
    }
  } else if (results.find("status") != nullptr) {
    const SweepData sweep(results);
    if (is_ida(results) && kind == "ida") return ida_figure(sweep, options);
    if (is_ida(results) && kind == "fragility") return fragility_figure(sweep, options);
    for (const SweepKind& one : sweep_kinds()) {
      if (kind == one.kind && has_quantity(results, one)) return sweep_figure(sweep, one, options);
    }
    // Any other quantity by its own name.
    const auto is_it = [&](const Quantity& one) { return one.key == kind && one.owner != Owner::impact; };
    const auto quantity = std::find_if(quantities().begin(), quantities().end(), is_it);
    if (quantity != quantities().end()) {
      const SweepKind by_name{kind, kind, std::string(quantity->long_name)};
      if (has_quantity(results, by_name)) return sweep_figure(sweep, by_name, options);
    }
  }
  std::vector<std::string> known;
  for (const FigureKind& one : figure_kinds(results)) known.push_back(one.name);
  const std::string near = nearest(kind, known);
  throw NoFigure(fmt::format("no figure \"{}\" of {}{} There are {}", kind, results.name(),
                             near.empty() ? "" : "; did you mean \"" + near + "\"?", fmt::join(known, ", ")));
}

}  // namespace bentur
