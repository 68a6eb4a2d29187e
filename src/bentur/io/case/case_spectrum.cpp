#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "bentur/core/units.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/number_table.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/model/gap/spectral_gap.h"

namespace bentur {
namespace {

/// An ordinate [length/s²]: a number in g, or a text with its unit.
std::optional<double> read_ordinate(const TableView& view, const char* key, const Units& units) {
  const auto given = view.get(key);
  return given ? read_acceleration(*given, units, units.gravity) : std::nullopt;
}

TwoPeriodSpectrum read_two_periods(const TableView& view, const Units& units) {
  TwoPeriodSpectrum shape;
  const auto short_period = read_ordinate(view, "short_period", units);
  const auto one_second = read_ordinate(view, "one_second", units);
  const auto long_period = view.number("long_period");
  shape.short_period = short_period.value_or(0);
  shape.one_second = one_second.value_or(0);
  shape.long_period = long_period.value_or(0);
  if (short_period && one_second && long_period && !(*long_period > *one_second / *short_period)) {
    view.find("long_period")
        ->error_value(
            fmt::format("must be beyond T_S = one_second/short_period = {:.4g} s", *one_second / *short_period));
  }
  return shape;
}

EurocodeSpectrum read_eurocode(const TableView& view, const Units& units) {
  const double ground = read_ordinate(view, "ground_acceleration", units).value_or(units.gravity);
  const auto type = view.whole("spectrum_type");
  const auto ground_type = view.word("ground_type");
  if (!type || !ground_type) return {};
  return eurocode_spectrum(static_cast<int>(*type), ground_type->front(), ground);
}

void check_ascending(const std::vector<double>& periods, const std::function<void(std::size_t)>& complain) {
  for (std::size_t i = 1; i < periods.size(); ++i) {
    if (!(periods[i] > periods[i - 1])) return complain(i);
  }
}

/// A table of its own file: periods in the first column.
TableSpectrum read_table_file(const TableView& view, const std::filesystem::path& folder, Diagnostics& diagnostics,
                              ShapeRead& spec) {
  TableSpectrum shape;
  const TomlView file = *view.find("file");
  const auto name = file.as_text();
  const auto column = view.whole("column");
  if (!name) return shape;
  const auto path = input_path(file, *name, folder, table_input);
  if (!path) return shape;
  spec.file = *name;
  spec.path = path->string();
  const auto table = read_number_table(*path, diagnostics);
  if (!table) return shape;
  const std::size_t count = table->columns();
  if (count < 2) {
    file.error_value("has one column: the first is that of periods, the accelerations stand in another");
    return shape;
  }
  if (count > 2 && !view.has("column")) {
    view.error_missing("column", fmt::format("{} has {} columns: in which are the accelerations?", *name, count));
    return shape;
  }
  if (column && static_cast<std::size_t>(*column) > count) {
    view.find("column")->error_value(fmt::format("{} has {} columns", *name, count));
    return shape;
  }
  const std::size_t chosen = column ? static_cast<std::size_t>(*column) - 1 : 1;
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const auto complain = [&](std::size_t cell, const char* rule) {
      diagnostics.error({path->string(), table->lines[i], 1},
                        fmt::format("column {} = {}, {}", cell + 1, table->rows[i][cell], rule));
    };
    const double period = table->rows[i][0], acceleration = table->rows[i][chosen];
    if (period < 0) complain(0, "must be >= 0");
    if (i > 0 && period <= table->rows[i - 1][0]) complain(0, "periods must ascend");
    if (acceleration < 0) complain(chosen, "must be >= 0");
    shape.periods.push_back(period);
    shape.accelerations.push_back(acceleration);
  }
  return shape;
}

TableSpectrum read_table(const TableView& view, const Units& units, const std::filesystem::path& folder,
                         Diagnostics& diagnostics, ShapeRead& spec) {
  TableSpectrum shape;
  const auto unit = view.word("unit");
  if (const auto kind = view.exactly_one("table")) {
    if (*kind == "file") {
      view.refuse({"accelerations"}, "goes with periods: a file holds both");
      shape = read_table_file(view, folder, diagnostics, spec);
    } else {
      view.refuse({"column"}, "goes with file");
      shape.periods = view.numbers("periods");
      if (!view.has("accelerations")) view.error_missing("accelerations");
      shape.accelerations = view.numbers("accelerations", shape.periods.size());
      check_ascending(shape.periods, [&](std::size_t i) { view.find("periods")->item(i).error("must ascend"); });
    }
  }
  if (unit) {
    for (double& one : shape.accelerations) one *= acceleration_factor(*unit, units);
  }
  return shape;
}

/// That a spectrum is all that the buildings need, and reaches their periods.
void check_spectrum(const TomlView& root, const ReadCase& read) {
  const SpectrumSpec& spec = *read.c.excitation.spectrum;
  const TomlView excitation = *root.find("excitation");
  if (root.has("initial")) root.find("initial")->error("is for runs: a spectrum gives peaks of buildings at rest");
  if (const auto obstacle = spectral_obstacle(read.c)) {
    const TomlView view =
        obstacle->building ? *view_of(root, read.buildings, *obstacle->building).find("isolation") : *root.find("link");
    view.error(obstacle->what);
  }
  if (spec.of_displacements) return;
  const auto* table = std::get_if<TableSpectrum>(&spec.spectrum.shape);
  for (std::size_t b = 0; table != nullptr && b < read.buildings.size(); ++b) {
    const Modes& modes = read.plan ? read.plan->buildings[b].modes : read.buildings[b].made->modes;
    if (modes.omega.size() == 0) continue;
    const double period = 2 * std::numbers::pi / modes.omega(0);
    if (period <= table->periods.back()) continue;
    excitation.find(spec.file.empty() ? "periods" : "file")
        ->error(fmt::format("ends at {:.4g} s, before the first period of \"{}\", {:.4g} s: the spectrum must reach it",
                            table->periods.back(), read.buildings[b].spec.name, period));
  }
}

}  // namespace

ShapeRead read_shape(const TableView& view, const Units& units, const std::filesystem::path& folder,
                     Diagnostics& diagnostics) {
  ShapeRead read;
  const auto shape = view.word("shape");
  read.word = shape.value_or("");
  if (shape == "en-1998-1") {
    read.shape = read_eurocode(view, units);
  } else if (shape == "table") {
    read.shape = read_table(view, units, folder, diagnostics, read);
  } else if (shape) {
    read.shape = read_two_periods(view, units);
  }
  return read;
}

SpectrumSpec read_spectrum(const TableView& view, const Units& units, std::size_t buildings,
                           const std::filesystem::path& folder, Diagnostics& diagnostics) {
  SpectrumSpec spec;
  spec.position = view.find("kind")->position();
  view.refuse({"delays", "wave_velocity", "kinematics"},
              "needs a course in time, which a spectrum has not: give a record to account for it");
  ShapeRead read = read_shape(view, units, folder, diagnostics);
  spec.shape = read.word;
  spec.spectrum.shape = std::move(read.shape);
  spec.file = std::move(read.file);
  spec.path = std::move(read.path);
  if (!spec.shape.empty() && spec.shape != "table") {
    view.refuse({"damping_ratio"}, "is for shape = \"table\": spectra of codes are for 0.05");
  } else {
    spec.spectrum.damping_ratio = view.number("damping_ratio").value_or(spec.spectrum.damping_ratio);
  }
  spec.spectrum.corrects_damping = view.word("damping_correction").value_or("en-1998-1") != "none";
  if (view.word("modal_combination") == "srss") {
    spec.combination = ModalCombination::srss;
  }
  if (view.has("reduction")) spec.reduction = view.numbers_for_each("reduction", buildings);
  return spec;
}

void settle_excitation(const TomlView& root, ReadCase& read, const Diagnostics& diagnostics,
                       const std::function<void(double)>& progress) {
  if (read.c.excitation.spectrum) check_spectrum(root, read);
  if (read.c.excitation.suite && diagnostics.ok()) settle_suite(root, read, progress);
}

ScreeningSpec read_screening(const TomlView& root) {
  ScreeningSpec spec;
  const auto view = TableView(root, case_keys()).table("screening");
  if (!view) return spec;
  if (!view->has("seismicity")) view->error_missing("seismicity");
  const auto word = view->word("seismicity");
  if (!word) return spec;
  const auto& words = seismicity_words();
  spec.seismicity = static_cast<Seismicity>(std::find(words.begin(), words.end(), *word) - words.begin());
  return spec;
}

}  // namespace bentur
