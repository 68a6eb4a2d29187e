#include "bentur/files/netcdf.h"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numeric>
#include <sstream>
#include <utility>

#include "bentur/io/input_file.h"

namespace bentur {
namespace {

std::size_t count_of(const std::vector<std::size_t>& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

/// What keeps a file from being read, in a user's words. Opening goes wrong at once where it is not NetCDF at all.
std::string in_words(int status, bool open) {
  if (status == NC_EHDFERR) return "is cut short or damaged, so that it cannot be read as NetCDF";
  if (status == NC_ENOTNC) return "is not a NetCDF file";
  return (open ? "" : "cannot be read as NetCDF: ") + std::string(nc_strerror(status));
}

/// By NetcdfType.
constexpr nc_type library_types[] = {NC_DOUBLE, NC_INT, NC_BYTE, NC_STRING};

const void* address(const NetcdfValues& values) {
  return std::visit([](const auto& of_one_type) -> const void* { return of_one_type.data(); }, values);
}

}  // namespace

NetcdfReader::NetcdfReader(const std::filesystem::path& file) : name_(file.string()) {
  const std::string problem = input_problem(file, result_input);  // the library would wait for a pipe
  if (!problem.empty()) throw NetcdfError(name_, problem);
  check(nc_open(name_.c_str(), NC_NOWRITE, &id_));
  list();
}

NetcdfReader::NetcdfReader(std::string bytes, std::string name) : name_(std::move(name)), bytes_(std::move(bytes)) {
  check(nc_open_mem(name_.c_str(), NC_NOWRITE, bytes_.size(), bytes_.data(), &id_));
  list();
}

NetcdfReader::~NetcdfReader() {
  if (id_ >= 0) nc_close(id_);
}

void NetcdfReader::check(int status) const {
  if (status == NC_NOERR) return;
  throw NetcdfError(name_, in_words(status, id_ >= 0));
}

std::string NetcdfReader::text_attribute(Place place, const std::string& attribute) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(place.group, place.variable, attribute.c_str(), &type, &length) != NC_NOERR || type != NC_CHAR)
    return "";
  std::string text(length, '\0');
  check(nc_get_att_text(place.group, place.variable, attribute.c_str(), text.data()));
  return text;
}

void NetcdfReader::list(int group, const std::string& prefix) {
  int count = 0;
  check(nc_inq_nvars(group, &count));
  for (int id = 0; id < count; ++id) {
    char name[NC_MAX_NAME + 1] = {};
    nc_type type = NC_NAT;
    int rank = 0;
    int dimensions[NC_MAX_VAR_DIMS] = {};
    check(nc_inq_var(group, id, name, &type, &rank, dimensions, nullptr));
    NetcdfVariable variable;
    variable.name = prefix + name;
    places_.push_back({group, id});
    variable.text = type == NC_STRING || type == NC_CHAR;
    variable.units = text_attribute({group, id}, "units");
    variable.long_name = text_attribute({group, id}, "long_name");
    std::istringstream coordinates(text_attribute({group, id}, "coordinates"));
    for (std::string word; coordinates >> word;) variable.coordinates.push_back(word);
    for (int d = 0; d < rank; ++d) {
      std::size_t length = 0;
      check(nc_inq_dim(group, dimensions[d], name, &length));
      variable.dimensions.emplace_back(name);
      variable.shape.push_back(length);
    }
    variables_.push_back(std::move(variable));
  }
}

void NetcdfReader::list() {
  try {
    list(id_, "");
    int count = 0;
    check(nc_inq_grps(id_, &count, nullptr));
    std::vector<int> groups(static_cast<std::size_t>(count));
    check(nc_inq_grps(id_, &count, groups.data()));
    for (const int group : groups) {
      char name[NC_MAX_NAME + 1] = {};
      check(nc_inq_grpname(group, name));
      list(group, std::string(name) + "/");
    }
  } catch (...) {
    nc_close(id_);  // the destructor of an object that was never whole does not run
    throw;
  }
}

const NetcdfVariable* NetcdfReader::find(std::string_view variable) const noexcept {
  const auto found = std::find_if(variables_.begin(), variables_.end(),
                                  [&](const NetcdfVariable& one) { return one.name == variable; });
  return found == variables_.end() ? nullptr : &*found;
}

const NetcdfVariable& NetcdfReader::at(std::string_view variable) const {
  const NetcdfVariable* found = find(variable);
  if (found == nullptr) throw NetcdfError(name_, "has no variable \"" + std::string(variable) + "\"");
  return *found;
}

NetcdfReader::Place NetcdfReader::place_of(const NetcdfVariable& variable) const {
  return places_.at(static_cast<std::size_t>(&variable - variables_.data()));
}

const NetcdfVariable& NetcdfReader::numeric(std::string_view variable) const {
  const NetcdfVariable& found = at(variable);
  if (found.text) throw NetcdfError(name_, "\"" + found.name + "\" holds no numbers");
  return found;
}

std::vector<double> NetcdfReader::numbers(std::string_view variable) const {
  const NetcdfVariable& found = numeric(variable);
  std::vector<double> values(count_of(found.shape));
  const Place place = place_of(found);
  check(nc_get_var_double(place.group, place.variable, values.data()));
  return values;
}

std::vector<double> NetcdfReader::numbers(std::string_view variable, std::size_t i) const {
  const NetcdfVariable& found = numeric(variable);
  std::vector<std::size_t> start(found.shape.size(), 0), count = found.shape;
  start.at(0) = i;
  count.at(0) = 1;
  std::vector<double> values(count_of(count));
  const Place place = place_of(found);
  check(nc_get_vara_double(place.group, place.variable, start.data(), count.data(), values.data()));
  return values;
}

std::vector<std::string> NetcdfReader::texts(std::string_view variable) const {
  const NetcdfVariable& found = at(variable);
  nc_type type = NC_NAT;
  const Place place = place_of(found);
  check(nc_inq_vartype(place.group, place.variable, &type));
  if (type != NC_STRING) throw NetcdfError(name_, "\"" + found.name + "\" holds no texts");
  std::vector<char*> pointers(count_of(found.shape));
  check(nc_get_var_string(place.group, place.variable, pointers.data()));
  std::vector<std::string> values;
  for (const char* text : pointers) values.emplace_back(text == nullptr ? "" : text);
  check(nc_free_string(pointers.size(), pointers.data()));
  return values;
}

std::string NetcdfReader::attribute(const std::string& attribute) const {
  return text_attribute({id_, NC_GLOBAL}, attribute);
}

std::string NetcdfReader::attribute(std::string_view variable, const std::string& attribute) const {
  return text_attribute(place_of(at(variable)), attribute);
}

NetcdfWriter::NetcdfWriter(std::string name, Place place) : name_(std::move(name)), place_(place) {
  check(place == Place::memory ? nc_create_mem(name_.c_str(), NC_NETCDF4, 0, &id_)
                               : nc_create(name_.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
  group_ = id_;
}

void NetcdfWriter::begin_group(const std::string& name) { check(nc_def_grp(id_, name.c_str(), &group_)); }

NetcdfWriter::~NetcdfWriter() {
  if (id_ >= 0) nc_abort(id_);
}

void NetcdfWriter::check(int status) const {
  if (status != NC_NOERR) throw std::runtime_error(name_ + ": " + nc_strerror(status));
}

void NetcdfWriter::describe(const std::string& title, const std::string& source, std::string_view version) const {
  attribute("Conventions", "CF-1.8");
  attribute("title", title);
  attribute("source", source);
  attribute("history", fmt::format("{} {}", netcdf_history, version));
}

NetcdfWriter::Dimension NetcdfWriter::dimension(const std::string& name, std::size_t size) const {
  int id = 0;
  check(nc_def_dim(group_, name.c_str(), size, &id));
  return Dimension{id};
}

NetcdfWriter::Variable NetcdfWriter::define(const std::string& name, NetcdfType type,
                                            const std::vector<Dimension>& dimensions, const std::string& units,
                                            const std::string& long_name) const {
  std::vector<int> ids(dimensions.size());
  std::transform(dimensions.begin(), dimensions.end(), ids.begin(),
                 [](Dimension one) { return static_cast<int>(one); });
  const nc_type library_type = library_types[static_cast<std::size_t>(type)];
  int id = 0;
  check(nc_def_var(group_, name.c_str(), library_type, static_cast<int>(ids.size()), ids.data(), &id));
  if (place_ == Place::disk && type != NetcdfType::text) check(nc_def_var_fill(group_, id, NC_NOFILL, nullptr));
  const Variable variable{id};
  if (!units.empty()) attribute(variable, "units", units);
  attribute(variable, "long_name", long_name);
  return variable;
}

void NetcdfWriter::chunk(Variable variable, const std::vector<std::size_t>& sizes) const {
  constexpr std::size_t cache_bytes = 1U << 20, cache_slots = 101;
  constexpr float preemption = 0.75F;  // how readily pieces read or written in full leave the cache [-]
  check(nc_def_var_chunking(group_, static_cast<int>(variable), NC_CHUNKED, sizes.data()));
  check(nc_set_var_chunk_cache(group_, static_cast<int>(variable), cache_bytes, cache_slots, preemption));
}

void NetcdfWriter::put(Variable variable, const NetcdfValues& values, const NetcdfBlock& block) const {
  const void* data = address(values);
  std::vector<const char*> pointers;
  if (const auto* texts = std::get_if<std::span<const std::string>>(&values)) {
    for (const std::string& text : *texts) pointers.push_back(text.c_str());
    data = pointers.data();
  }
  const int id = static_cast<int>(variable);
  check(block.start.empty() ? nc_put_var(group_, id, data)
                            : nc_put_vara(group_, id, block.start.data(), block.count.data(), data));
}

NetcdfWriter::Variable NetcdfWriter::write(const std::string& name, const std::vector<Dimension>& dimensions,
                                           const NetcdfValues& values, const std::string& units,
                                           const std::string& long_name) const {
  const Variable variable = define(name, static_cast<NetcdfType>(values.index()), dimensions, units, long_name);
  put(variable, values);
  return variable;
}

void NetcdfWriter::attribute(const char* name, const std::string& text) const {
  attribute(Variable{NC_GLOBAL}, name, text);
}

void NetcdfWriter::attribute(Variable variable, const char* name, const std::string& text) const {
  check(nc_put_att_text(group_, static_cast<int>(variable), name, text.size(), text.data()));
}

void NetcdfWriter::attribute(Variable variable, const char* name, const NetcdfValues& values) const {
  const std::size_t count = std::visit([](const auto& of_one_type) { return of_one_type.size(); }, values);
  check(nc_put_att(group_, static_cast<int>(variable), name, library_types[values.index()], count, address(values)));
}

std::string NetcdfWriter::finish() {
  const int id = std::exchange(id_, -1);
  if (place_ == Place::disk) {
    check(nc_close(id));
    return "";
  }
  NC_memio memory{};
  check(nc_close_memio(id, &memory));
  const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
  return {static_cast<const char*>(memory.memory), memory.size};
}

}  // namespace bentur
