#include "bentur/files/netcdf_reader.h"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <functional>
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

std::string NetcdfReader::text_attribute(int variable, const std::string& attribute) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(id_, variable, attribute.c_str(), &type, &length) != NC_NOERR || type != NC_CHAR) return "";
  std::string text(length, '\0');
  check(nc_get_att_text(id_, variable, attribute.c_str(), text.data()));
  return text;
}

void NetcdfReader::list() {
  try {
    int count = 0;
    check(nc_inq_nvars(id_, &count));
    for (int id = 0; id < count; ++id) {
      char name[NC_MAX_NAME + 1] = {};
      nc_type type = NC_NAT;
      int rank = 0;
      int dimensions[NC_MAX_VAR_DIMS] = {};
      check(nc_inq_var(id_, id, name, &type, &rank, dimensions, nullptr));
      NetcdfVariable variable;
      variable.name = name;
      variable.text = type == NC_STRING || type == NC_CHAR;
      variable.units = text_attribute(id, "units");
      variable.long_name = text_attribute(id, "long_name");
      std::istringstream coordinates(text_attribute(id, "coordinates"));
      for (std::string word; coordinates >> word;) variable.coordinates.push_back(word);
      for (int d = 0; d < rank; ++d) {
        std::size_t length = 0;
        check(nc_inq_dim(id_, dimensions[d], name, &length));
        variable.dimensions.emplace_back(name);
        variable.shape.push_back(length);
      }
      variables_.push_back(std::move(variable));
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

int NetcdfReader::id_of(const NetcdfVariable& variable) const {
  return static_cast<int>(&variable - variables_.data());
}

const NetcdfVariable& NetcdfReader::numeric(std::string_view variable) const {
  const NetcdfVariable& found = at(variable);
  if (found.text) throw NetcdfError(name_, "\"" + found.name + "\" holds no numbers");
  return found;
}

std::vector<double> NetcdfReader::numbers(std::string_view variable) const {
  const NetcdfVariable& found = numeric(variable);
  std::vector<double> values(count_of(found.shape));
  check(nc_get_var_double(id_, id_of(found), values.data()));
  return values;
}

std::vector<double> NetcdfReader::numbers(std::string_view variable, std::size_t i) const {
  const NetcdfVariable& found = numeric(variable);
  std::vector<std::size_t> start(found.shape.size(), 0), count = found.shape;
  start.at(0) = i;
  count.at(0) = 1;
  std::vector<double> values(count_of(count));
  check(nc_get_vara_double(id_, id_of(found), start.data(), count.data(), values.data()));
  return values;
}

std::vector<std::string> NetcdfReader::texts(std::string_view variable) const {
  const NetcdfVariable& found = at(variable);
  nc_type type = NC_NAT;
  check(nc_inq_vartype(id_, id_of(found), &type));
  if (type != NC_STRING) throw NetcdfError(name_, "\"" + found.name + "\" holds no texts");
  std::vector<char*> pointers(count_of(found.shape));
  check(nc_get_var_string(id_, id_of(found), pointers.data()));
  std::vector<std::string> values;
  for (const char* text : pointers) values.emplace_back(text == nullptr ? "" : text);
  check(nc_free_string(pointers.size(), pointers.data()));
  return values;
}

std::string NetcdfReader::attribute(const std::string& attribute) const { return text_attribute(NC_GLOBAL, attribute); }

std::string NetcdfReader::attribute(std::string_view variable, const std::string& attribute) const {
  return text_attribute(id_of(at(variable)), attribute);
}

}  // namespace bentur
