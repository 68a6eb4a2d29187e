#include "bentur/files/netcdf.h"

#ifdef BENTUR_NETCDF_FILE
#include <dlfcn.h>
#endif
#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <functional>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "bentur/io/input_file.h"

namespace bentur {
namespace {

#ifdef BENTUR_NETCDF_FILE
// The library is opened when the first file is: it brings HDF5, libcurl and forty others, and most runs read and write
// none of its files. Where it was when this was built, or else where the system has one of that name.
void* opened_library() {
  if (void* library = ::dlopen(BENTUR_NETCDF_FILE, RTLD_LAZY)) return library;
  return ::dlopen(BENTUR_NETCDF_NAME, RTLD_LAZY);
}

/// @throws std::runtime_error where there is no library, or it does not have the function.
void* function_of_library(const char* name) {
  static void* const library = opened_library();
  if (library == nullptr) {
    throw std::runtime_error("results in NetCDF need the library " BENTUR_NETCDF_NAME
                             ", which is not installed or cannot be opened; everything else works without it");
  }
  if (void* const function = ::dlsym(library, name)) return function;
  throw std::runtime_error("results in NetCDF need " + std::string(name) + "(), which " BENTUR_NETCDF_NAME " lacks");
}

// Each function by its own name, which hides that of <netcdf.h>.
#define BENTUR_NETCDF(name)                                                                       \
  template <class... Arguments>                                                                   \
  auto name(Arguments... arguments) {                                                             \
    static const auto function = reinterpret_cast<decltype(&::name)>(function_of_library(#name)); \
    return function(arguments...);                                                                \
  }
BENTUR_NETCDF(nc_abort)
BENTUR_NETCDF(nc_close)
BENTUR_NETCDF(nc_create)
BENTUR_NETCDF(nc_def_dim)
BENTUR_NETCDF(nc_def_grp)
BENTUR_NETCDF(nc_def_var)
BENTUR_NETCDF(nc_def_var_chunking)
BENTUR_NETCDF(nc_def_var_fill)
BENTUR_NETCDF(nc_free_string)
BENTUR_NETCDF(nc_get_att_text)
BENTUR_NETCDF(nc_get_var_double)
BENTUR_NETCDF(nc_get_var_string)
BENTUR_NETCDF(nc_get_vara_double)
BENTUR_NETCDF(nc_inq_att)
BENTUR_NETCDF(nc_inq_dim)
BENTUR_NETCDF(nc_inq_dimids)
BENTUR_NETCDF(nc_inq_dimlen)
BENTUR_NETCDF(nc_inq_grpname)
BENTUR_NETCDF(nc_inq_grps)
BENTUR_NETCDF(nc_inq_nvars)
BENTUR_NETCDF(nc_inq_var)
BENTUR_NETCDF(nc_inq_vardimid)
BENTUR_NETCDF(nc_inq_varid)
BENTUR_NETCDF(nc_inq_varndims)
BENTUR_NETCDF(nc_inq_vartype)
BENTUR_NETCDF(nc_open)
BENTUR_NETCDF(nc_open_mem)
BENTUR_NETCDF(nc_put_att_double)
BENTUR_NETCDF(nc_put_att_schar)
BENTUR_NETCDF(nc_put_att_text)
BENTUR_NETCDF(nc_put_var)
BENTUR_NETCDF(nc_put_vara)
BENTUR_NETCDF(nc_set_var_chunk_cache)
BENTUR_NETCDF(nc_strerror)
#undef BENTUR_NETCDF

#endif

std::size_t count_of(const std::vector<std::size_t>& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

/// Whether a variable of this shape may be in a file of so many bytes: packed more than a thousand to one by none of
/// the library's ways.
bool fits(const std::vector<std::size_t>& shape, std::uintmax_t bytes) {
  const double count = std::accumulate(shape.begin(), shape.end(), 1.0, std::multiplies<>());
  return count <= 1100 * static_cast<double>(bytes);
}

/// What keeps a file from being read, in a user's words. Opening goes wrong at once where it is not NetCDF at all.
std::string in_words(int status, bool open) {
  if (status == NC_EHDFERR) return "is cut short or damaged, so that it cannot be read as NetCDF";
  if (status == NC_ENOTNC) return "is not a NetCDF file";
  return (open ? "" : "cannot be read as NetCDF: ") + std::string(nc_strerror(status));
}

/// Status of a process of its own, as waitpid() has it, that works on a file of so many bytes, which the library may
/// die of where it is damaged.
int status_of_child(const std::string& name, std::uintmax_t bytes, const std::function<int()>& work) {
  // Of a processor: damage may also make the library go round for ever. A megabyte packed as tightly as can be takes
  // some two seconds.
  constexpr ::rlim_t least_seconds = 10, seconds_a_megabyte = 10, longest = 300;
  const ::rlim_t most_seconds = std::min<::rlim_t>(longest, least_seconds + seconds_a_megabyte * (bytes >> 20U));
  const ::pid_t child = ::fork();
  if (child < 0) throw NetcdfError(name, "cannot be examined: " + std::generic_category().message(errno));
  if (child == 0) {
    const ::rlimit no_core{0, 0}, time{most_seconds, most_seconds};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::setrlimit(RLIMIT_CPU, &time);
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) ::signal(signal, SIG_DFL);
    ::signal(SIGINT, SIG_IGN);  // which ends the parent, or is its to answer
    ::close(STDERR_FILENO);     // what the C library says when it gives up
    ::_exit(work());
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// A type of the library.
nc_type type_of(const ResultValues& values) {
  static constexpr nc_type types[] = {NC_DOUBLE, NC_DOUBLE, NC_INT, NC_BYTE, NC_STRING};  // in their order
  return types[values.index()];
}

/// "time" of "exact/time".
std::string own_name(const std::string& name) { return name.substr(name.rfind('/') + 1); }

}  // namespace

void require_netcdf() {
#ifdef BENTUR_NETCDF_FILE
  function_of_library("nc_open");
#endif
}

bool NetcdfNames::has(const std::string& variable) const {
  int id = 0;
  return nc_inq_varid(file_, variable.c_str(), &id) == NC_NOERR;
}

std::string NetcdfNames::attribute(const std::string& name) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(file_, NC_GLOBAL, name.c_str(), &type, &length) != NC_NOERR || type != NC_CHAR) return "";
  std::string text(length, '\0');
  return nc_get_att_text(file_, NC_GLOBAL, name.c_str(), text.data()) == NC_NOERR ? text : "";
}

bool ask_netcdf(const std::filesystem::path& file, const std::function<bool(const NetcdfNames&)>& question) {
  if (!input_problem(file, result_input).empty()) return false;
  std::error_code unknown;
  require_netcdf();
  constexpr int yes = 42;
  const int status = status_of_child(file.string(), std::filesystem::file_size(file, unknown), [&] {
    int id = -1;
    return nc_open(file.c_str(), NC_NOWRITE, &id) == NC_NOERR && question(NetcdfNames(id)) ? yes : 0;
  });
  return WIFEXITED(status) && WEXITSTATUS(status) == yes;
}

NetcdfReader::NetcdfReader(const std::filesystem::path& file) : NetcdfReader(file, Examined::no) {}

NetcdfReader::NetcdfReader(const std::filesystem::path& file, Examined examined) : name_(file.string()) {
  const std::string problem = input_problem(file, result_input);  // the library would wait for a pipe
  if (!problem.empty()) throw NetcdfError(name_, problem);
  std::error_code unknown;
  size_ = std::filesystem::file_size(file, unknown);
  require_netcdf();  // opened once, and not in each child
  if (examined == Examined::no) examine();
  check(nc_open(name_.c_str(), NC_NOWRITE, &id_));
  list();
}

NetcdfReader::NetcdfReader(std::string bytes, std::string name)
    : name_(std::move(name)), bytes_(std::move(bytes)), size_(bytes_.size()) {
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

/// The child ends with 0 where the library has come through everything, errors of its own among it: those are met again
/// by whoever reads the file. Any other end, by a signal or a sanitizer, is damage.
void NetcdfReader::examine() const {
  const int status = status_of_child(name_, size_, [&] {
    try {
      NetcdfReader(name_, Examined::yes).read_all();
    } catch (const std::exception&) {
    }
    return 0;
  });
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw NetcdfError(name_, "is damaged, so that it cannot be read as NetCDF");
  }
}

void NetcdfReader::read_all() const {
  for (const StoredVariable& variable : variables_) {
    try {
      if (variable.text) {
        static_cast<void>(texts(variable.name));
      } else {
        static_cast<void>(numbers(variable.name));
      }
    } catch (const std::exception&) {  // one that is broken in an orderly way; on to the next
    }
  }
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
  check(nc_inq_dimids(group, &count, nullptr, 0));
  std::vector<int> own(static_cast<std::size_t>(count));
  check(nc_inq_dimids(group, &count, own.data(), 0));
  for (const int id : own) {
    char name[NC_MAX_NAME + 1] = {};
    std::size_t size = 0;
    check(nc_inq_dim(group, id, name, &size));
    dimensions_[prefix + name] = size;
  }
  check(nc_inq_nvars(group, &count));
  for (int id = 0; id < count; ++id) {
    char name[NC_MAX_NAME + 1] = {};
    nc_type type = NC_NAT;
    int rank = 0;
    int dimensions[NC_MAX_VAR_DIMS] = {};
    check(nc_inq_var(group, id, name, &type, &rank, dimensions, nullptr));
    StoredVariable variable;
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
    if (!fits(variable.shape, size_)) fail("is damaged: \"" + variable.name + "\" claims more values than it can have");
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

const StoredVariable& NetcdfReader::at(std::string_view variable) const {
  const StoredVariable* found = find(variable);
  if (found == nullptr) throw NetcdfError(name_, "has no variable \"" + std::string(variable) + "\"");
  return *found;
}

std::size_t NetcdfReader::dimension_size(std::string_view dimension) const {
  const auto found = dimensions_.find(dimension);
  return found == dimensions_.end() ? 0 : found->second;
}

NetcdfReader::Place NetcdfReader::place_of(const StoredVariable& variable) const {
  return places_.at(static_cast<std::size_t>(&variable - variables_.data()));
}

const StoredVariable& NetcdfReader::numeric(std::string_view variable) const {
  const StoredVariable& found = at(variable);
  if (found.text) throw NetcdfError(name_, "\"" + found.name + "\" holds no numbers");
  return found;
}

std::vector<double> NetcdfReader::numbers(std::string_view variable) const {
  const StoredVariable& found = numeric(variable);
  std::vector<double> values(count_of(found.shape));
  const Place place = place_of(found);
  check(nc_get_var_double(place.group, place.variable, values.data()));
  return values;
}

std::vector<double> NetcdfReader::numbers(std::string_view variable, std::size_t i) const {
  const StoredVariable& found = numeric(variable);
  std::vector<std::size_t> start(found.shape.size(), 0), count = found.shape;
  start.at(0) = i;
  count.at(0) = 1;
  std::vector<double> values(count_of(count));
  const Place place = place_of(found);
  check(nc_get_vara_double(place.group, place.variable, start.data(), count.data(), values.data()));
  return values;
}

std::vector<std::string> NetcdfReader::texts(std::string_view variable) const {
  const StoredVariable& found = at(variable);
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

NetcdfWriter::NetcdfWriter(std::string path) : name_(std::move(path)) {
  check(nc_create(name_.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
}

NetcdfWriter::~NetcdfWriter() {
  if (id_ >= 0) nc_abort(id_);
}

void NetcdfWriter::check(int status) const {
  if (status != NC_NOERR) throw std::runtime_error(name_ + ": " + nc_strerror(status));
}

int NetcdfWriter::group_of(const std::string& name) {
  const std::size_t end = name.rfind('/');
  if (end == std::string::npos) return id_;
  const auto [group, is_new] = groups_.try_emplace(name.substr(0, end), -1);
  if (is_new) check(nc_def_grp(id_, group->first.c_str(), &group->second));
  return group->second;
}

void NetcdfWriter::attribute(int group, int variable, const ResultAttribute& attribute) const {
  const char* name = attribute.name.c_str();
  if (const auto* text = std::get_if<std::string>(&attribute.value)) {
    check(nc_put_att_text(group, variable, name, text->size(), text->data()));
  } else if (const auto* number = std::get_if<double>(&attribute.value)) {
    check(nc_put_att_double(group, variable, name, NC_DOUBLE, 1, number));
  } else {
    const auto& flags = std::get<std::vector<signed char>>(attribute.value);
    check(nc_put_att_schar(group, variable, name, NC_BYTE, flags.size(), flags.data()));
  }
}

void NetcdfWriter::attribute(const ResultAttribute& attribute) { this->attribute(id_, NC_GLOBAL, attribute); }

NetcdfWriter::Variable NetcdfWriter::add(const ResultVariable& variable) {
  std::vector<int> ids;
  for (const ResultDimension& dimension : variable.dimensions) {
    const auto [known, is_new] = dimensions_.try_emplace(dimension.name, -1);
    if (is_new) {
      check(nc_def_dim(group_of(dimension.name), own_name(dimension.name).c_str(), dimension.size, &known->second));
    }
    ids.push_back(known->second);
  }
  Stored stored{group_of(variable.name), 0};
  check(nc_def_var(stored.group, own_name(variable.name).c_str(), type_of(variable.values),
                   static_cast<int>(ids.size()), ids.data(), &stored.variable));
  if (type_of(variable.values) != NC_STRING) {
    check(nc_def_var_fill(stored.group, stored.variable, NC_NOFILL, nullptr));
  }
  if (!variable.units.empty()) attribute(stored.group, stored.variable, {"units", variable.units});
  attribute(stored.group, stored.variable, {"long_name", variable.long_name});
  for (const ResultAttribute& one : variable.attributes) attribute(stored.group, stored.variable, one);
  variables_.push_back(stored);
  const Variable added{variables_.size() - 1};
  if (std::visit([](const auto& values) { return !values.empty(); }, variable.values)) put(added, variable.values);
  return added;
}

void NetcdfWriter::chunk(Variable variable, const std::vector<std::size_t>& sizes) const {
  constexpr std::size_t cache_bytes = 1U << 20, cache_slots = 101;
  constexpr float preemption = 0.75F;  // how readily pieces read or written in full leave the cache [-]
  const auto [group, id] = variables_.at(static_cast<std::size_t>(variable));
  check(nc_def_var_chunking(group, id, NC_CHUNKED, sizes.data()));
  check(nc_set_var_chunk_cache(group, id, cache_bytes, cache_slots, preemption));
}

/// How many places a block has, or all of the variable.
std::size_t NetcdfWriter::places(int group, int variable, const NetcdfBlock& block) const {
  int rank = 0;
  check(nc_inq_varndims(group, variable, &rank));
  std::vector<int> dimensions(static_cast<std::size_t>(rank));
  check(nc_inq_vardimid(group, variable, dimensions.data()));
  std::size_t count = 1;
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    std::size_t length = 0;
    if (block.start.empty()) check(nc_inq_dimlen(group, dimensions[d], &length));
    count *= block.start.empty() ? length : block.count[d];
  }
  return count;
}

void NetcdfWriter::put(Variable variable, const ResultValues& values, const NetcdfBlock& block) const {
  const void* data = std::visit([](const auto& of_one_type) -> const void* { return of_one_type.data(); }, values);
  std::vector<const char*> pointers;
  if (const auto* texts = std::get_if<std::vector<std::string>>(&values)) {
    for (const std::string& text : *texts) pointers.push_back(text.c_str());
    data = pointers.data();
  }
  const auto [group, id] = variables_.at(static_cast<std::size_t>(variable));
  const std::size_t count = std::visit([](const auto& of_one_type) { return of_one_type.size(); }, values);
  if (const std::size_t room = places(group, id, block); count != room) {  // the library would read beyond them
    throw std::logic_error(fmt::format("{}: a variable is given {} values for {} places", name_, count, room));
  }
  check(block.start.empty() ? nc_put_var(group, id, data)
                            : nc_put_vara(group, id, block.start.data(), block.count.data(), data));
}

void NetcdfWriter::finish() { check(nc_close(std::exchange(id_, -1))); }

}  // namespace bentur
