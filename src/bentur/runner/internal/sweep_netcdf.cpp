#include "bentur/runner/internal/sweep_netcdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "bentur/files/ida_reading.h"
#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/parameter_units.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

constexpr std::size_t block_bytes = 4U << 20;  // of rows held at a time
constexpr std::size_t message_chunk = 1024;    // runs; a part of the file without messages takes no room

using Dimension = NetcdfWriter::Dimension;
using Variable = NetcdfWriter::Variable;

/// Consecutive runs that are one block of the dimensions.
struct RunBlock {
  std::size_t first = 0, runs = 0;
  NetcdfBlock places;
};

class SweepFile {
 public:
  SweepFile(const std::filesystem::path& file, const StudyRuns& runs)
      : file_(file.string(), NetcdfWriter::Place::disk),
        runs_(runs),
        study_(runs.study()),
        problem_(runs.facts().problem) {}

  SweepTotals write(const Journal& journal, const std::string& version);

 private:
  void define(const std::string& version);
  void define_places();
  void define_points();
  void define_varies();
  void define_indices();
  void define_ida(const IdaSpec& ida);
  void define_quantities();
  void write_grid_coordinates() const;
  void write_sample_coordinates(const RunBlock& block) const;
  [[nodiscard]] std::vector<std::size_t> place_of(std::size_t run) const;
  [[nodiscard]] RunBlock block_at(std::size_t first) const;

  NetcdfWriter file_;
  const StudyRuns& runs_;
  const Study& study_;
  const Problem& problem_;
  std::vector<Dimension> run_dimensions_;
  std::vector<std::size_t> run_sizes_;
  std::vector<Dimension> floors_;  // of each building
  Dimension points_{}, gaps_{}, links_{};
  std::vector<Variable> varies_;
  std::vector<std::optional<Variable>> quantities_;  // nothing for what no run has
  Variable status_{}, message_{};
  std::optional<Variable> normalisation_;  // of the record, where files are normalised
  std::string coordinates_;                // those of every run that are not dimensions
};

void SweepFile::define(const std::string& version) {
  file_.describe(runs_.facts().title, "seismic pounding analysis", version);
  file_.attribute("bentur_version", version);
  file_.attribute("study", study_.text);
  file_.attribute("case", study_.case_text);
  std::string records;
  for (const auto& [name, hash] : runs_.facts().records) records += fmt::format("{}  {}\n", hash, name);
  if (!records.empty()) file_.attribute("records", records);
  if (runs_.plan().is_grid()) {
    for (std::size_t axis = 0; axis < study_.axes.size(); ++axis) {
      run_sizes_.push_back(runs_.plan().axes()[axis].levels);
      run_dimensions_.push_back(file_.dimension(study_.axes[axis], run_sizes_.back()));
    }
  } else {
    run_sizes_.push_back(runs_.plan().runs());
    run_dimensions_.push_back(file_.dimension("sample", run_sizes_.back()));
  }
  define_places();
  define_varies();
  if (runs_.plan().is_grid()) define_indices();
  if (study_.ida) define_ida(*study_.ida);
  define_quantities();
}

void SweepFile::define_places() {
  for (std::size_t b = 0; b < problem_.buildings.size(); ++b) {
    const Building& building = problem_.buildings[b];
    const std::string name = fmt::format("elevation_{}", b + 1);
    floors_.push_back(file_.dimension(name, building.model.elevations.size()));
    const bool moves = runs_.facts().floors_move;
    std::vector<double> places = building.model.elevations;
    for (std::size_t i = 0; moves && i < places.size(); ++i) places[i] = static_cast<double>(i + 1);
    file_.write(name, {floors_[b]}, places, moves ? "1" : udunit(runs_.facts().units.length),
                fmt::format("{} of building \"{}\"",
                            moves ? "floors, whose elevations differ between runs," : "elevation of the floors",
                            building.name));
  }
  if (!problem_.points.empty()) points_ = file_.dimension("point", problem_.points.size());
  gaps_ = file_.dimension("gap", problem_.buildings.size() - 1);
  define_points();
  if (problem_.links.empty()) return;
  links_ = file_.dimension("link", problem_.links.size());
  write_link_places(file_, links_, problem_, runs_.facts().links_move ? "" : udunit(runs_.facts().units.length));
}

void SweepFile::define_points() {
  std::vector<std::string> gaps;
  for (const Gap& gap : gaps_of(problem_)) gaps.push_back(gap_name(problem_, gap.left));
  file_.write("gap_name", {gaps_}, gaps, "", "buildings on both sides of the gaps");
  if (problem_.points.empty()) return;
  write_point_sides(file_, points_, problem_);
  if (!runs_.facts().points_move) {
    std::vector<double> elevations;
    for (const ContactPoint& point : problem_.points) elevations.push_back(point.elevation);
    file_.write("point_elevation", {points_}, elevations, udunit(runs_.facts().units.length),
                "elevation of the contact points");
  }
}

void SweepFile::define_varies() {
  for (const Vary& vary : study_.varies) {
    const std::vector<Dimension> dimensions = {runs_.plan().is_grid() ? run_dimensions_[vary.axis]
                                                                      : run_dimensions_[0]};
    const bool text = !vary.labels.empty();
    const std::string units = text          ? ""
                              : vary.factor ? "1"
                                            : parameter_units(vary.path, study_.case_root, runs_.facts().units);
    varies_.push_back(file_.define(vary.name, text ? NetcdfType::text : NetcdfType::number, dimensions, units,
                                   (vary.factor ? "factor of " : "") + vary.parameter));
    if (!vary.factor) file_.attribute(varies_.back(), "parameter", path_text(vary.path));
    if (!runs_.plan().is_grid() || vary.name != study_.axes[vary.axis]) coordinates_ += vary.name + " ";
    if (vary.normalisation.empty()) continue;
    normalisation_ =
        file_.define("normalisation", NetcdfType::number, dimensions, "1", "factor that normalises the record");
    coordinates_ += "normalisation ";
  }
}

/// What a dimension along which several move together is chosen by: the first labels among them, or numbers from 0.
void SweepFile::define_indices() {
  for (std::size_t axis = 0; axis < study_.axes.size(); ++axis) {
    const std::string& name = study_.axes[axis];
    if (study_.ida && axis == study_.ida->axis) continue;
    std::vector<std::string> labels;
    bool there = false;
    for (const Vary& vary : study_.varies) {
      if (vary.axis != axis) continue;
      there = there || vary.name == name;
      if (labels.empty()) labels = vary.labels;
    }
    if (there) continue;
    if (!labels.empty()) {
      file_.write(name, {run_dimensions_[axis]}, labels, "", std::string(index_title));
      continue;
    }
    std::vector<int> numbers(run_sizes_[axis]);
    std::iota(numbers.begin(), numbers.end(), 0);
    file_.write(name, {run_dimensions_[axis]}, numbers, "", std::string(index_title));
  }
}

/// The levels, and what they say of each record. docs/studies.md; read again by read_ida_results().
void SweepFile::define_ida(const IdaSpec& ida) {
  const std::string units = intensity_units(ida, runs_.facts().units);
  const std::string name = intensity_name(ida);
  const Variable intensity = file_.define("intensity", NetcdfType::number, {run_dimensions_[ida.axis]}, units, name);
  file_.attribute(intensity, "measure", ida.spectral ? "sa" : "pga");
  file_.attribute(intensity, "study_unit", ida.unit.empty() ? runs_.facts().units.length + "/s2" : ida.unit);
  if (ida.spectral) {
    file_.attribute(intensity, "period", std::span(&ida.period, 1));
    file_.attribute(intensity, "damping", std::span(&ida.damping, 1));
  }
  file_.put(intensity, ida.levels);
  const RecordIntensities& records = runs_.facts().intensities;
  std::vector<Dimension> dimensions;
  for (const std::size_t axis : records.axes) dimensions.push_back(run_dimensions_[axis]);
  file_.write("record_intensity", dimensions, records.values, units, name + " of the record as its file has it");
  dimensions.push_back(run_dimensions_[ida.axis]);
  std::vector<double> factors;
  for (std::size_t place = 0; place < records.values.size(); ++place) {
    for (const double level : ida.levels) factors.push_back(record_factor(records, place, level));
  }
  file_.write("scale_factor", dimensions, factors, "1", "what the record is multiplied by");
  coordinates_ += "record_intensity scale_factor ";
}

void SweepFile::define_quantities() {
  const auto coordinates = [&](Variable variable, std::string names) {
    if (!names.empty() && names.back() == ' ') names.pop_back();
    if (!names.empty()) file_.attribute(variable, "coordinates", names);
  };
  for (const RowPart& quantity : runs_.quantities()) {
    if (quantity.count == 0) {  // of contact points or links where there are none
      quantities_.emplace_back();
      continue;
    }
    std::vector<Dimension> dimensions = run_dimensions_;
    std::string names = coordinates_;
    if (quantity.owner == Owner::floor) dimensions.push_back(floors_[quantity.building]);
    if (quantity.owner == Owner::gap) {
      dimensions.push_back(gaps_);
      names += "gap_name";
    }
    if (quantity.owner == Owner::point) {
      dimensions.push_back(points_);
      names += runs_.facts().points_move ? "point_left point_right" : "point_elevation point_left point_right";
    }
    if (quantity.owner == Owner::link) {
      dimensions.push_back(links_);
      names += runs_.facts().links_move ? "link_left link_right" : "link_elevation link_left link_right";
    }
    const Variable variable =
        file_.define(quantity.name, NetcdfType::number, dimensions, quantity.units, quantity.long_name);
    file_.attribute(variable, "symbol", std::string(quantity.quantity->symbol));
    if (quantity.quantity->by_size) file_.attribute(variable, "compared_by", "size");
    coordinates(variable, names);
    quantities_.emplace_back(variable);
  }
  status_ = file_.define("status", NetcdfType::byte, run_dimensions_, "", "how the run ended");
  const signed char flags[] = {0, 1, 2};
  file_.attribute(status_, "flag_values", flags);
  file_.attribute(status_, "flag_meanings", "done numbers_failed not_a_case");
  coordinates(status_, coordinates_);
  message_ = file_.define("message", NetcdfType::text, run_dimensions_, "", "why a run failed");
  coordinates(message_, coordinates_);
  std::vector<std::size_t> chunks = run_sizes_;
  std::size_t left = message_chunk;
  for (std::size_t i = chunks.size(); i-- > 0;) {
    chunks[i] = std::clamp<std::size_t>(chunks[i], 1, std::max<std::size_t>(1, left));
    left /= chunks[i];
  }
  file_.chunk(message_, chunks);
}

/// A run's place along each dimension.
std::vector<std::size_t> SweepFile::place_of(std::size_t run) const {
  std::vector<std::size_t> place(run_sizes_.size());
  for (std::size_t i = run_sizes_.size(); i-- > 0; run /= run_sizes_[i]) place[i] = run % run_sizes_[i];
  return place;
}

/// The largest block from run `first` on that fits: whole in the last dimensions, single in the first ones.
RunBlock SweepFile::block_at(std::size_t first) const {
  const std::size_t row = row_size(runs_.quantities()) * sizeof(double);
  const std::size_t most = std::max<std::size_t>(1, block_bytes / row);
  RunBlock block{first, 1, {place_of(first), std::vector<std::size_t>(run_sizes_.size(), 1)}};
  auto& [start, count] = block.places;
  for (std::size_t i = run_sizes_.size(); i-- > 0;) {
    count[i] = std::min(run_sizes_[i] - start[i], std::max<std::size_t>(1, most / block.runs));
    block.runs *= count[i];
    if (count[i] < run_sizes_[i]) break;
  }
  return block;
}

void SweepFile::write_grid_coordinates() const {
  for (std::size_t v = 0; v < study_.varies.size(); ++v) {
    const Vary& vary = study_.varies[v];
    if (!vary.normalisation.empty()) file_.put(*normalisation_, vary.normalisation);
    if (!vary.labels.empty()) {
      file_.put(varies_[v], vary.labels);
      continue;
    }
    std::vector<double> values;
    for (const TomlValue& value : vary.values) values.push_back(value.real);
    file_.put(varies_[v], values);
  }
}

void SweepFile::write_sample_coordinates(const RunBlock& block) const {
  std::vector<std::vector<Choice>> choices;
  for (std::size_t i = 0; i < block.runs; ++i) choices.push_back(runs_.choices(block.first + i));
  if (normalisation_) {
    std::vector<double> factors;
    for (const std::vector<Choice>& choice : choices) factors.push_back(normalisation_of(study_, choice));
    file_.put(*normalisation_, factors, block.places);
  }
  for (std::size_t v = 0; v < study_.varies.size(); ++v) {
    const Vary& vary = study_.varies[v];
    std::vector<std::string> texts;
    std::vector<double> values;
    for (const std::vector<Choice>& choice : choices) {
      if (vary.labels.empty()) {
        values.push_back(*chosen_number(vary, choice[vary.axis]));
      } else {
        texts.push_back(vary.labels[choice[vary.axis].level]);
      }
    }
    if (vary.labels.empty()) {
      file_.put(varies_[v], values, block.places);
    } else {
      file_.put(varies_[v], texts, block.places);
    }
  }
}

SweepTotals SweepFile::write(const Journal& journal, const std::string& version) {
  define(version);
  SweepTotals totals;
  const auto named = [&](std::string_view name) {
    return std::find_if(runs_.quantities().begin(), runs_.quantities().end(),
                        [&](const RowPart& quantity) { return quantity.name == name; });
  };
  const auto impacts = named("impacts"), unmodelled = named("unmodelled_contacts");
  std::map<std::size_t, std::string> failures;
  if (runs_.plan().is_grid()) write_grid_coordinates();
  for (std::size_t first = 0; first < runs_.plan().runs();) {
    const RunBlock block = block_at(first);
    first += block.runs;
    if (!runs_.plan().is_grid()) write_sample_coordinates(block);
    std::vector<RunResult> results = journal.read(block.first, block.runs);
    std::vector<signed char> status;
    for (std::size_t i = 0; i < results.size(); ++i) {
      RunResult& result = results[i];
      status.push_back(static_cast<signed char>(result.status));
      if (result.status == RunStatus::done) {
        for (Eigen::Index k = 0; k < impacts->count; ++k) totals.impacts += result.values[impacts->first + k];
        bool some = false;
        for (Eigen::Index k = 0; k < unmodelled->count; ++k) some = some || result.values[unmodelled->first + k] > 0;
        totals.unmodelled += some ? 1 : 0;
        continue;
      }
      result.values.assign(row_size(runs_.quantities()), std::numeric_limits<double>::quiet_NaN());
      if (totals.failed++ == 0) totals.first_failure = fmt::format("run {}: {}", result.run, result.message);
      failures.emplace(result.run, std::move(result.message));
    }
    file_.put(status_, status, block.places);
    std::vector<double> values;
    for (std::size_t q = 0; q < quantities_.size(); ++q) {
      if (!quantities_[q]) continue;
      const RowPart& quantity = runs_.quantities()[q];
      values.clear();
      for (const RunResult& result : results) {
        const auto begin = result.values.begin() + static_cast<std::ptrdiff_t>(quantity.first);
        values.insert(values.end(), begin, begin + static_cast<std::ptrdiff_t>(quantity.count));
      }
      NetcdfBlock places = block.places;
      if (quantity.owner != Owner::run && quantity.owner != Owner::building) {
        places.start.push_back(0);
        places.count.push_back(quantity.count);
      }
      file_.put(*quantities_[q], values, places);
    }
  }
  // All or none: a variable of texts with pieces that were never written cannot be read as a whole.
  for (std::size_t first = 0; !failures.empty() && first < runs_.plan().runs();) {
    const RunBlock block = block_at(first);
    std::vector<std::string> messages(block.runs);
    for (auto one = failures.lower_bound(first); one != failures.end() && one->first < first + block.runs; ++one) {
      messages[one->first - first] = one->second;
    }
    file_.put(message_, messages, block.places);
    first += block.runs;
  }
  file_.finish();
  return totals;
}

}  // namespace

void check_names(const Study& study, Diagnostics& diagnostics) {
  // Whatever the case has: no name may mean one thing in one study and another in the next.
  std::set<std::string> taken = {"point",         "gap",        "intensity",     "record_intensity", "scale_factor",
                                 "normalisation", "sample",     "status",        "message",          "point_left",
                                 "point_right",   "gap_name",   "elevation",     "point_elevation",  "link",
                                 "link_left",     "link_right", "link_elevation"};
  for (const Quantity& quantity : quantities()) {
    if (quantity.owner != Owner::impact) taken.insert(file_name(quantity));
  }
  const auto is_taken = [&](const std::string& name) { return taken.count(name) > 0 || without_number(name) != name; };
  for (const Vary& vary : study.varies) {
    for (const std::string& name : {vary.name, study.axes[vary.axis]}) {
      if (is_taken(name)) {
        diagnostics.error(vary.parameter_position,
                          fmt::format("{} is the name of something else in the results, or like one: give another "
                                      "name = \"..\"",
                                      in_quotes(name)));
        break;
      }
    }
  }
}

SweepTotals write_sweep_netcdf(const std::filesystem::path& file, const StudyRuns& runs, const Journal& journal,
                               const std::string& version) {
  return SweepFile(file, runs).write(journal, version);
}

}  // namespace bentur
