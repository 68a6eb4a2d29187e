#include "bentur/runner/internal/sweep_netcdf.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/files/netcdf_reader.h"
#include "bentur/io/case/parameter_units.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

constexpr std::size_t block_bytes = 4U << 20;  // of rows held at a time
constexpr std::size_t message_chunk = 1024;    // runs; a part of the file without messages takes no room

/// Consecutive runs that are one block of the dimensions.
struct Block {
  std::size_t first = 0, runs = 0;
  std::vector<std::size_t> start, count;
};

class SweepFile {
 public:
  SweepFile(const std::filesystem::path& file, const StudyRuns& runs)
      : name_(file.string()), runs_(runs), study_(runs.study()), problem_(runs.facts().problem) {
    check(nc_create(name_.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
  }
  ~SweepFile() {
    if (id_ >= 0) nc_abort(id_);
  }
  SweepFile(const SweepFile&) = delete;
  SweepFile& operator=(const SweepFile&) = delete;

  void define(const std::string& version);
  SweepTotals write(const Journal& journal);
  void close() { check(nc_close(std::exchange(id_, -1))); }

 private:
  void check(int status) const {
    if (status != NC_NOERR) throw std::runtime_error(name_ + ": " + nc_strerror(status));
  }
  int dimension(const std::string& name, std::size_t size) const {
    int id = 0;
    check(nc_def_dim(id_, name.c_str(), size, &id));
    return id;
  }
  int variable(const std::string& name, nc_type type, const std::vector<int>& dimensions, const std::string& units,
               const std::string& long_name) const {
    int id = 0;
    check(nc_def_var(id_, name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(), &id));
    int no_fill = 1;
    if (type != NC_STRING) check(nc_def_var_fill(id_, id, no_fill, nullptr));
    if (!units.empty()) attribute(id, "units", units);
    attribute(id, "long_name", long_name);
    return id;
  }
  void attribute(int variable, const char* name, const std::string& text) const {
    check(nc_put_att_text(id_, variable, name, text.size(), text.data()));
  }
  void put(int variable, const std::vector<std::string>& texts) const {
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    check(nc_put_var_string(id_, variable, pointers.data()));
  }
  void put(int variable, const std::vector<double>& values) const {
    check(nc_put_var_double(id_, variable, values.data()));
  }

  void define_places();
  void define_points();
  void define_varies();
  void define_indices();
  void define_ida(const IdaSpec& ida);
  void define_quantities();
  void write_grid_coordinates() const;
  void write_sample_coordinates(const Block& block) const;
  [[nodiscard]] Block block_at(std::size_t first) const;

  std::string name_;
  const StudyRuns& runs_;
  const Study& study_;
  const Problem& problem_;
  int id_ = -1;
  std::vector<int> run_dimensions_;
  std::vector<std::size_t> run_sizes_;
  std::vector<int> floors_;  // dimension of each building's
  int points_ = 0, gaps_ = 0;
  static constexpr int none_ = -1;
  std::vector<int> varies_, quantities_;  // variables; none_ for what no run has
  int status_ = 0, message_ = 0;
  int normalisation_ = -1;   // of the record, where files are normalised
  std::string coordinates_;  // those of every run that are not dimensions
};

void SweepFile::define(const std::string& version) {
  attribute(NC_GLOBAL, "Conventions", "CF-1.8");
  attribute(NC_GLOBAL, "title", runs_.facts().title);
  attribute(NC_GLOBAL, "source", "seismic pounding analysis");
  attribute(NC_GLOBAL, "history", fmt::format("written by bentur {}", version));
  attribute(NC_GLOBAL, "bentur_version", version);
  attribute(NC_GLOBAL, "study", study_.text);
  attribute(NC_GLOBAL, "case", study_.case_text);
  std::string records;
  for (const auto& [name, hash] : runs_.facts().records) records += fmt::format("{}  {}\n", hash, name);
  if (!records.empty()) attribute(NC_GLOBAL, "records", records);
  if (runs_.plan().is_grid()) {
    for (std::size_t axis = 0; axis < study_.axes.size(); ++axis) {
      run_sizes_.push_back(runs_.plan().axes()[axis].levels);
      run_dimensions_.push_back(dimension(study_.axes[axis], run_sizes_.back()));
    }
  } else {
    run_sizes_.push_back(runs_.plan().runs());
    run_dimensions_.push_back(dimension("sample", run_sizes_.back()));
  }
  define_places();
  define_varies();
  if (runs_.plan().is_grid()) define_indices();
  if (study_.ida) define_ida(*study_.ida);
  define_quantities();
  check(nc_enddef(id_));
}

void SweepFile::define_places() {
  for (std::size_t b = 0; b < problem_.buildings.size(); ++b) {
    const Building& building = problem_.buildings[b];
    const std::string name = fmt::format("elevation_{}", b + 1);
    floors_.push_back(dimension(name, building.model.elevations.size()));
    const bool moves = runs_.facts().floors_move;
    const int id =
        variable(name, NC_DOUBLE, {floors_[b]}, moves ? "1" : udunit(runs_.facts().units.length),
                 fmt::format("{} of building \"{}\"",
                             moves ? "floors, whose elevations differ between runs," : "elevation of the floors",
                             building.name));
    std::vector<double> places = building.model.elevations;
    for (std::size_t i = 0; moves && i < places.size(); ++i) places[i] = static_cast<double>(i + 1);
    put(id, places);
  }
  if (!problem_.points.empty()) points_ = dimension("point", problem_.points.size());
  gaps_ = dimension("gap", problem_.buildings.size() - 1);
  define_points();
}

void SweepFile::define_points() {
  std::vector<std::string> left, right, gaps;
  std::vector<double> elevations;
  for (const ContactPoint& point : problem_.points) {
    left.push_back(problem_.buildings[static_cast<std::size_t>(point.left)].name);
    right.push_back(problem_.buildings[static_cast<std::size_t>(point.left) + 1].name);
    elevations.push_back(point.elevation);
  }
  for (std::size_t gap = 0; gap + 1 < problem_.buildings.size(); ++gap) {
    gaps.push_back(gap_name(problem_, gap));
  }
  put(variable("gap_name", NC_STRING, {gaps_}, "", "buildings on both sides of the gaps"), gaps);
  if (problem_.points.empty()) return;  // a dimension of size zero would be an unlimited one
  put(variable("point_left", NC_STRING, {points_}, "", "building to the left of the contact points"), left);
  put(variable("point_right", NC_STRING, {points_}, "", "building to the right of the contact points"), right);
  if (!runs_.facts().points_move) {
    put(variable("point_elevation", NC_DOUBLE, {points_}, udunit(runs_.facts().units.length),
                 "elevation of the contact points"),
        elevations);
  }
}

void SweepFile::define_varies() {
  for (const Vary& vary : study_.varies) {
    const std::vector<int> dimensions = {runs_.plan().is_grid() ? run_dimensions_[vary.axis] : run_dimensions_[0]};
    const bool text = !vary.labels.empty();
    const std::string units = text          ? ""
                              : vary.factor ? "1"
                                            : parameter_units(vary.path, study_.case_root, runs_.facts().units);
    varies_.push_back(variable(vary.name, text ? NC_STRING : NC_DOUBLE, dimensions, units,
                               (vary.factor ? "factor of " : "") + vary.parameter));
    if (!vary.factor) attribute(varies_.back(), "parameter", path_text(vary.path));
    if (!runs_.plan().is_grid() || vary.name != study_.axes[vary.axis]) coordinates_ += vary.name + " ";
    if (vary.normalisation.empty()) continue;
    normalisation_ = variable("normalisation", NC_DOUBLE, dimensions, "1", "factor that normalises the record");
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
      put(variable(name, NC_STRING, {run_dimensions_[axis]}, "", std::string(index_title)), labels);
      continue;
    }
    const int id = variable(name, NC_INT, {run_dimensions_[axis]}, "", std::string(index_title));
    std::vector<int> numbers(run_sizes_[axis]);
    std::iota(numbers.begin(), numbers.end(), 0);
    check(nc_put_var_int(id_, id, numbers.data()));
  }
}

/// The levels, and what they say of each record. docs/studies.md; read again by read_ida_results().
void SweepFile::define_ida(const IdaSpec& ida) {
  const std::string units = intensity_units(ida, runs_.facts().units);
  const std::string name = intensity_name(ida);
  const int intensity = variable("intensity", NC_DOUBLE, {run_dimensions_[ida.axis]}, units, name);
  attribute(intensity, "measure", ida.spectral ? "sa" : "pga");
  attribute(intensity, "study_unit", ida.unit.empty() ? runs_.facts().units.length + "/s2" : ida.unit);
  if (ida.spectral) {
    check(nc_put_att_double(id_, intensity, "period", NC_DOUBLE, 1, &ida.period));
    check(nc_put_att_double(id_, intensity, "damping", NC_DOUBLE, 1, &ida.damping));
  }
  put(intensity, ida.levels);
  const RecordIntensities& records = runs_.facts().intensities;
  std::vector<int> dimensions;
  for (const std::size_t axis : records.axes) dimensions.push_back(run_dimensions_[axis]);
  put(variable("record_intensity", NC_DOUBLE, dimensions, units, name + " of the record as its file has it"),
      records.values);
  dimensions.push_back(run_dimensions_[ida.axis]);
  std::vector<double> factors;
  for (std::size_t place = 0; place < records.values.size(); ++place) {
    for (const double level : ida.levels) factors.push_back(record_factor(records, place, level));
  }
  put(variable("scale_factor", NC_DOUBLE, dimensions, "1", "what the record is multiplied by"), factors);
  coordinates_ += "record_intensity scale_factor ";
}

void SweepFile::define_quantities() {
  const auto coordinates = [&](int id, std::string names) {
    if (!names.empty() && names.back() == ' ') names.pop_back();
    if (!names.empty()) attribute(id, "coordinates", names);
  };
  for (const RowPart& quantity : runs_.quantities()) {
    if (quantity.count == 0) {  // of contact points where there are none
      quantities_.push_back(none_);
      continue;
    }
    std::vector<int> dimensions = run_dimensions_;
    std::string names = coordinates_;
    if (quantity.owner == Owner::floors) dimensions.push_back(floors_[quantity.building]);
    if (quantity.owner == Owner::gaps) {
      dimensions.push_back(gaps_);
      names += "gap_name";
    }
    if (quantity.owner == Owner::points) {
      dimensions.push_back(points_);
      names += runs_.facts().points_move ? "point_left point_right" : "point_elevation point_left point_right";
    }
    quantities_.push_back(variable(quantity.name, NC_DOUBLE, dimensions, quantity.units, quantity.long_name));
    coordinates(quantities_.back(), names);
  }
  status_ = variable("status", NC_BYTE, run_dimensions_, "", "how the run ended");
  const signed char flags[] = {0, 1, 2};
  check(nc_put_att_schar(id_, status_, "flag_values", NC_BYTE, 3, flags));
  attribute(status_, "flag_meanings", "done numbers_failed not_a_case");
  coordinates(status_, coordinates_);
  message_ = variable("message", NC_STRING, run_dimensions_, "", "why a run failed");
  coordinates(message_, coordinates_);
  std::vector<std::size_t> chunks = run_sizes_;
  std::size_t left = message_chunk;
  for (std::size_t i = chunks.size(); i-- > 0;) {
    chunks[i] = std::clamp<std::size_t>(chunks[i], 1, std::max<std::size_t>(1, left));
    left /= chunks[i];
  }
  check(nc_def_var_chunking(id_, message_, NC_CHUNKED, chunks.data()));
  check(nc_set_var_chunk_cache(id_, message_, std::size_t{1} << 20, 101, 0.75F));
}

/// The largest block from run `first` on that fits: whole in the last dimensions, single in the first ones.
Block SweepFile::block_at(std::size_t first) const {
  const std::size_t row = row_size(runs_.quantities()) * sizeof(double);
  const std::size_t most = std::max<std::size_t>(1, block_bytes / row);
  Block block{first, 1, std::vector<std::size_t>(run_sizes_.size()), std::vector<std::size_t>(run_sizes_.size(), 1)};
  std::size_t rest = first;
  for (std::size_t i = run_sizes_.size(); i-- > 0;) {
    block.start[i] = rest % run_sizes_[i];
    rest /= run_sizes_[i];
  }
  for (std::size_t i = run_sizes_.size(); i-- > 0;) {
    block.count[i] = std::min(run_sizes_[i] - block.start[i], std::max<std::size_t>(1, most / block.runs));
    block.runs *= block.count[i];
    if (block.count[i] < run_sizes_[i]) break;
  }
  return block;
}

void SweepFile::write_grid_coordinates() const {
  for (std::size_t v = 0; v < study_.varies.size(); ++v) {
    const Vary& vary = study_.varies[v];
    if (!vary.normalisation.empty()) put(normalisation_, vary.normalisation);
    if (!vary.labels.empty()) {
      put(varies_[v], vary.labels);
      continue;
    }
    std::vector<double> values;
    for (const TomlValue& value : vary.values) values.push_back(value.real);
    put(varies_[v], values);
  }
}

void SweepFile::write_sample_coordinates(const Block& block) const {
  std::vector<std::vector<Choice>> choices;
  for (std::size_t i = 0; i < block.runs; ++i) choices.push_back(runs_.choices(block.first + i));
  if (normalisation_ >= 0) {
    std::vector<double> factors;
    for (const std::vector<Choice>& choice : choices) factors.push_back(normalisation_of(study_, choice));
    check(nc_put_vara_double(id_, normalisation_, block.start.data(), block.count.data(), factors.data()));
  }
  for (std::size_t v = 0; v < study_.varies.size(); ++v) {
    const Vary& vary = study_.varies[v];
    std::vector<const char*> texts;
    std::vector<double> values;
    for (const std::vector<Choice>& choice : choices) {
      if (vary.labels.empty()) {
        values.push_back(*chosen_number(vary, choice[vary.axis]));
      } else {
        texts.push_back(vary.labels[choice[vary.axis].level].c_str());
      }
    }
    if (vary.labels.empty()) {
      check(nc_put_vara_double(id_, varies_[v], block.start.data(), block.count.data(), values.data()));
    } else {
      check(nc_put_vara_string(id_, varies_[v], block.start.data(), block.count.data(), texts.data()));
    }
  }
}

SweepTotals SweepFile::write(const Journal& journal) {
  SweepTotals totals;
  const auto named = [&](std::string_view name) {
    return std::find_if(runs_.quantities().begin(), runs_.quantities().end(),
                        [&](const RowPart& quantity) { return quantity.name == name; });
  };
  const auto impacts = named("impacts"), unmodelled = named("unmodelled_contacts");
  if (runs_.plan().is_grid()) write_grid_coordinates();
  for (std::size_t first = 0; first < runs_.plan().runs();) {
    const Block block = block_at(first);
    first += block.runs;
    if (!runs_.plan().is_grid()) write_sample_coordinates(block);
    std::vector<RunResult> results = journal.read(block.first, block.runs);
    std::vector<signed char> status;
    for (std::size_t i = 0; i < results.size(); ++i) {
      RunResult& result = results[i];
      status.push_back(static_cast<signed char>(result.status));
      if (result.status == RunStatus::done) {
        for (std::size_t k = 0; k < impacts->count; ++k) totals.impacts += result.values[impacts->first + k];
        bool some = false;
        for (std::size_t k = 0; k < unmodelled->count; ++k) some = some || result.values[unmodelled->first + k] > 0;
        totals.unmodelled += some ? 1 : 0;
        continue;
      }
      result.values.assign(row_size(runs_.quantities()), std::numeric_limits<double>::quiet_NaN());
      if (totals.failed++ == 0) totals.first_failure = fmt::format("run {}: {}", result.run, result.message);
      std::vector<std::size_t> at(run_sizes_.size());
      std::size_t rest = result.run;
      for (std::size_t d = run_sizes_.size(); d-- > 0; rest /= run_sizes_[d]) at[d] = rest % run_sizes_[d];
      const char* text = result.message.c_str();
      check(nc_put_var1_string(id_, message_, at.data(), &text));
    }
    check(nc_put_vara_schar(id_, status_, block.start.data(), block.count.data(), status.data()));
    std::vector<double> values;
    for (std::size_t q = 0; q < quantities_.size(); ++q) {
      if (quantities_[q] == none_) continue;
      const RowPart& quantity = runs_.quantities()[q];
      values.clear();
      for (const RunResult& result : results) {
        const auto begin = result.values.begin() + static_cast<std::ptrdiff_t>(quantity.first);
        values.insert(values.end(), begin, begin + static_cast<std::ptrdiff_t>(quantity.count));
      }
      std::vector<std::size_t> start = block.start;
      std::vector<std::size_t> count = block.count;
      if (quantity.owner != Owner::run) {
        start.push_back(0);
        count.push_back(quantity.count);
      }
      check(nc_put_vara_double(id_, quantities_[q], start.data(), count.data(), values.data()));
    }
  }
  return totals;
}

}  // namespace

void check_names(const Study& study, Diagnostics& diagnostics) {
  // Whatever the case has: no name may mean one thing in one study and another in the next.
  const std::set<std::string> taken = {"point",
                                       "gap",
                                       "intensity",
                                       "record_intensity",
                                       "scale_factor",
                                       "normalisation",
                                       "sample",
                                       "status",
                                       "message",
                                       "point_left",
                                       "point_right",
                                       "gap_name",
                                       "point_elevation",
                                       "point_width",
                                       "elevation",
                                       "impacts",
                                       "contact_duration",
                                       "peak_force",
                                       "peak_force_time",
                                       "peak_penetration",
                                       "peak_closing_speed",
                                       "impulse",
                                       "energy_lost",
                                       "peak_tension",
                                       "restitution_smallest",
                                       "restitution_largest",
                                       "gap_minimum_no_contact",
                                       "gap_needed",
                                       "unmodelled_contacts",
                                       "minimum_gap_no_contact",
                                       "peak_ground_acceleration",
                                       "events",
                                       "energy_residual"};
  const auto is_taken = [&](const std::string& name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    const bool numbered = end != std::string::npos && name[end] == '_' && end + 1 < name.size();
    return taken.count(name) > 0 || numbered;
  };
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
  SweepFile output(file, runs);
  output.define(version);
  const SweepTotals totals = output.write(journal);
  output.close();
  return totals;
}

}  // namespace bentur
