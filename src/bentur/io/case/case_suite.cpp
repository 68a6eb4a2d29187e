#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "bentur/core/units.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/io/toml/named_files.h"
#include "bentur/model/suite/suite.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

/// Where someone without records finds some.
const std::string where_records_are =
    "; ./dev records fetches the ground motions of FEMA P-695, ground-motion databases such as PEER NGA-West2 give "
    "others as AT2 files";

/// Of a table among the files what it says of reading them; of a name alone nothing.
struct SuiteFile {
  TomlView file;          ///< where the name stands
  std::size_t entry = 0;  ///< its number
  RecordOptions options;
  std::optional<std::string> event;
};

std::optional<SuiteFile> read_suite_file(const TomlView& given) {
  if (!given.is(TomlValue::Kind::table)) return SuiteFile{.file = given, .entry = 0, .options = {}, .event = {}};
  const auto table = TableView::of(given, suite_file_keys());
  const auto file = table ? table->get("file") : std::nullopt;
  if (!file) return std::nullopt;
  SuiteFile entry{.file = *file, .entry = 0, .options = {}, .event = {}};
  const auto place = [&](const char* key) {
    const auto number = table->whole(key);
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
  };
  entry.options.format = table->word("format").value_or("auto");
  entry.options.time_step = table->number("time_step");
  entry.options.column = place("column");
  entry.options.channel = place("channel");
  entry.options.skip_lines = place("skip_lines").value_or(0);
  if (const auto component = table->find("component")) entry.options.component = component->as_line();
  entry.options.unit = table->word("unit").value_or("");
  const auto event = table->find("event");
  entry.event = event ? event->as_line() : std::nullopt;
  return entry;
}

/// One record as its file has it, in the case's units; nothing (and an error) where it cannot be had.
std::optional<SuiteRecord> read_suite_record(const SuiteFile& entry, const fs::path& path, const fs::path& folder,
                                             const Units& units, Diagnostics& diagnostics) {
  const std::string name = way_from(folder, path);
  auto record = read_record(path, entry.options, diagnostics);
  if (!record) return std::nullopt;
  const std::string unit = record->unit.empty() ? entry.options.unit : record->unit;
  if (unit.empty()) {
    entry.file.error(fmt::format("does not say the unit of {}: give it as {{ file = .., unit = \"..\" }}; one of {}",
                                 in_quotes(name), fmt::join(acceleration_units(), ", ")));
    return std::nullopt;
  }
  const std::vector<RecordContradiction> otherwise = contradictions(*record, entry.options);
  for (const RecordContradiction& one : otherwise) {
    entry.file.error(fmt::format("has {} = {}, but {} says {}", one.key, one.given, in_quotes(name), one.said));
  }
  if (!otherwise.empty()) return std::nullopt;
  SuiteRecord read{.echo = echo_of(*record, name, unit),
                   .motion = {record->time_step, std::move(record->values)},
                   .event = entry.event.value_or(record->event),
                   .entry = entry.entry};
  FileIdentity identity = identify(path);
  read.echo.path = path.string();
  read.echo.size = identity.size;
  read.echo.sha256 = std::move(identity.sha256);
  const double factor = acceleration_factor(unit, units);
  for (double& value : read.motion.acceleration) value *= factor;
  return read;
}

/// The records that `files` of a table name, in their order. @param count how many, those that cannot be read too
std::vector<SuiteRecord> read_suite_files(const TableView& view, const Units& units, const fs::path& folder,
                                          Diagnostics& diagnostics, std::size_t& count) {
  std::vector<SuiteRecord> records;
  const auto files = view.get("files");
  if (!files || !files->is_list_of("files")) return records;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < files->size(); ++i) {
    auto entry = read_suite_file(files->item(i));
    if (entry) entry->entry = i;
    const auto text = entry ? entry->file.as_text() : std::nullopt;
    if (!text) continue;
    for (const fs::path& path : named_files(entry->file, *text, folder, "the case file", where_records_are)) {
      if (!seen.insert(way_from(folder, path)).second) {
        entry->file.error(fmt::format("name {} twice", in_quotes(way_from(folder, path))));
        continue;
      }
      if (auto record = read_suite_record(*entry, path, folder, units, diagnostics)) {
        record->file = count;
        records.push_back(std::move(*record));
      }
      ++count;
    }
  }
  return records;
}

/// The components along y to those along x, one each in their order.
void read_pairs(const TableView& along_y, const Units& units, const fs::path& folder, Diagnostics& diagnostics,
                SuiteSpec& suite) {
  std::size_t count = 0;
  std::vector<SuiteRecord> others = read_suite_files(along_y, units, folder, diagnostics, count);
  const auto files = along_y.find("files");
  if (files && count != suite.files && suite.files > 0) {
    files->error_shown(fmt::format("{} files", count),
                       fmt::format("must be one per file along x: there are {}", suite.files));
  }
  if (!diagnostics.ok()) return;  // some were not read
  for (std::size_t i = 0; i < suite.records.size(); ++i) {
    SuiteRecord& record = suite.records[i];
    SuiteRecord& other = others.at(i);
    if (other.echo.file == record.echo.file) {
      files->error(fmt::format("name {} along x too", in_quotes(record.echo.file)));
    }
    if (other.motion.time_step != record.motion.time_step) {
      files->error(fmt::format("name {} with a step of {} s, but {} along x has {} s", in_quotes(other.echo.file),
                               other.motion.time_step, in_quotes(record.echo.file), record.motion.time_step));
    }
    record.along_y = SuiteComponent{std::move(other.echo), std::move(other.motion), other.entry};
  }
}

void read_suite_scale(const TableView& view, SuiteRequest& request) {
  const auto scale = view.get("scale");
  if (!scale) return;
  if (scale->is(TomlValue::Kind::table)) {
    request.scale = "factors";
    if (const auto table = view.table("scale")) request.factors = table->numbers("factors");
  } else {
    request.scale = view.word("scale").value_or("");
  }
  if (request.scale == "period") {
    if (!view.has("period")) view.error_missing("period", "scale = \"period\" needs it");
    request.period = view.number("period");
  } else if (!request.scale.empty()) {
    view.refuse({"period"}, "is for scale = \"period\"");
  }
}

SuiteRequest read_suite_request(const TableView& view) {
  SuiteRequest request;
  read_suite_scale(view, request);
  const auto count = [&](const char* key) {
    const auto number = view.whole(key);
    return number ? std::optional(static_cast<std::size_t>(*number)) : std::nullopt;
  };
  request.select = count("select");
  request.per_event = count("per_event");
  request.largest_misfit = view.number("largest_misfit");
  if (view.has("factor_bounds")) {
    if (const auto bounds = view.numbers("factor_bounds"); bounds.size() == 2) {
      if (!(bounds[0] < bounds[1])) {
        view.find("factor_bounds")->item(1).error_value(fmt::format("must be more than the one before, {}", bounds[0]));
      } else {
        request.factor_bounds = std::pair(bounds[0], bounds[1]);
      }
    }
  }
  return request;
}

std::string factor_bounds_text(const SuiteSpec& suite) {
  const auto& bounds = suite.request.factor_bounds;
  return bounds ? fmt::format("{:.4g} to {:.4g}", bounds->first, bounds->second) : "none";
}

/// A fault at the key that it is about.
void tell_fault(const SuiteFault& fault, const SuiteSpec& suite, const std::vector<std::string>& names,
                const TomlView& view) {
  using Kind = SuiteFault::Kind;
  const auto at = [&](const char* key) { return *view.find(key); };
  const auto name = [&] { return in_quotes(names.at(fault.record)); };
  switch (fault.kind) {
    case Kind::too_few: {
      const std::string counts = fmt::format(
          "{} of {} files can be had, {} have factors beyond factor_bounds, {} are beyond largest_misfit, {} "
          "more are of an event that per_event limits",
          fault.count, suite.files, fault.beyond.factor, fault.beyond.misfit, fault.beyond.event);
      const std::string nearest = fault.value > 0 ? fmt::format("; the nearest factor is {:.4g}, bounds are {}",
                                                                fault.value, factor_bounds_text(suite))
                                                  : "";
      at(view.has("select") ? "select" : "files")
          .error(fmt::format("asks for more than there is: {}{}", counts, nearest));
      return;
    }
    case Kind::factor: {
      const std::string common =
          fault.common > 1 ? fmt::format(", of which {:.4g} lifts the mean to the clause", fault.common) : "";
      at("factor_bounds")
          .error(fmt::format("of {} are broken: {} has the factor {:.4g}{}", factor_bounds_text(suite), name(),
                             fault.value, common));
      return;
    }
    case Kind::misfit:
      at("largest_misfit")
          .error_value(fmt::format("but no record fits so well: the best, {}, has {:.4g}", name(), fault.value));
      return;
    case Kind::no_amplitude:
      at("files").error(fmt::format("name {}, which is zero throughout", name()));
      return;
    case Kind::beyond_table: {
      const TomlView target = at("target");
      const auto& table = std::get<TableSpectrum>(suite.target.spectrum.shape);
      target.find(suite.target.file.empty() ? "periods" : "file")
          ->error(fmt::format("ends at {:.4g} s, before twice the longest first period of the buildings, {:.4g} s: the "
                              "target must reach it",
                              table.periods.back(), fault.value));
      return;
    }
    case Kind::no_period:
      at("kind").error_value("needs a building with a period: all of them move with the ground");
      return;
    case Kind::too_short:
      at("files").error(fmt::format("name {}, whose step is too long for a period of {:.4g} s", name(), fault.value));
      return;
    case Kind::no_target:
      at("target").error(fmt::format("is zero at {:.4g} s, within the band of the buildings' periods", fault.value));
      return;
  }
}

}  // namespace

std::shared_ptr<const SuiteSpec> read_suite(const TableView& view, const std::optional<TableView>& along_y,
                                            const Units& units, const fs::path& folder, Diagnostics& diagnostics) {
  auto suite = std::make_shared<SuiteSpec>();
  suite->position = view.find("kind")->position();
  suite->request = read_suite_request(view);
  suite->records = read_suite_files(view, units, folder, diagnostics, suite->files);
  if (along_y) read_pairs(*along_y, units, folder, diagnostics, *suite);
  if (const auto target = view.table("target")) {
    ShapeRead shape = read_shape(*target, units, folder, diagnostics);
    suite->target.spectrum.shape = std::move(shape.shape);
    suite->target.shape = std::move(shape.word);
    suite->target.file = std::move(shape.file);
    suite->target.path = std::move(shape.path);
  }
  const std::vector<double>& factors = suite->request.factors;
  if (!factors.empty() && suite->files > 0 && factors.size() != suite->files) {
    view.find("scale")->find("factors")->error_shown(fmt::format("{} numbers", factors.size()),
                                                     fmt::format("must be one per file: there are {}", suite->files));
  }
  return suite;
}

void settle_suite(const TomlView& root, ReadCase& read, const std::function<void(double)>& progress) {
  SuiteSpec suite = *read.c.excitation.suite;
  const TomlView view = *root.find("excitation");
  if (const auto analysis = root.find("analysis"); analysis && analysis->has("duration")) {
    suite.duration = read.c.analysis.duration;
  }
  std::vector<const Building*> made;
  for (const ReadBuilding& building : read.buildings) made.push_back(building.made.get());
  std::vector<std::string> names;
  for (const SuiteRecord& record : suite.records) names.push_back(record.echo.file);
  const std::vector<SuiteFault> faults =
      settle(suite, read.plan ? suite_periods(read.plan->buildings) : suite_periods(made), progress);
  for (const SuiteFault& fault : faults) tell_fault(fault, suite, names, view);
  if (!faults.empty()) return;
  name_records(suite.records);
  for (const SuiteRecord& record : suite.records) {
    if (!std::isfinite(record.echo.pga / read.c.units.gravity)) {
      view.find("scale")->error("scales a record beyond what can be computed with");
      return;
    }
  }
  read.c.excitation.suite = std::make_shared<const SuiteSpec>(std::move(suite));
}

}  // namespace bentur
