#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bentur {

/// A variable of a NetCDF file, without its values.
struct NetcdfVariable {
  std::string name;
  std::string units, long_name;  ///< attributes; empty where there is none
  std::vector<std::string> dimensions;
  std::vector<std::size_t> shape;        ///< one size per dimension
  std::vector<std::string> coordinates;  ///< of the attribute, word by word
  bool text = false;
};

/// What the history of every file of ours begins with, before the version of the program.
inline constexpr std::string_view netcdf_history = "written by bentur";

/// What keeps a file from being read, without the file's name; what() has both.
struct NetcdfError : std::runtime_error {
  NetcdfError(const std::string& file, const std::string& why) : std::runtime_error(file + ": " + why), reason(why) {}
  std::string reason;
};

/// Reads what bentur has written, a variable at a time; those of a group are called "group/variable". A missing or
/// broken file, and a variable that is not there or of another type, are NetcdfError.
class NetcdfReader {
 public:
  explicit NetcdfReader(const std::filesystem::path& file);
  /// A file that is in memory; `name` is for messages.
  NetcdfReader(std::string bytes, std::string name);
  ~NetcdfReader();
  NetcdfReader(const NetcdfReader&) = delete;
  NetcdfReader& operator=(const NetcdfReader&) = delete;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::vector<NetcdfVariable>& variables() const noexcept { return variables_; }
  /// nullptr where there is none of that name.
  [[nodiscard]] const NetcdfVariable* find(std::string_view variable) const noexcept;
  /// @throws NetcdfError where there is none of that name.
  [[nodiscard]] const NetcdfVariable& at(std::string_view variable) const;
  /// All values, last dimension fastest.
  [[nodiscard]] std::vector<double> numbers(std::string_view variable) const;
  /// Those at place `i` of the first dimension, so that memory need not hold them all.
  [[nodiscard]] std::vector<double> numbers(std::string_view variable, std::size_t i) const;
  [[nodiscard]] std::vector<std::string> texts(std::string_view variable) const;
  /// A text attribute of the file; empty where there is none.
  [[nodiscard]] std::string attribute(const std::string& attribute) const;
  /// The same of a variable.
  [[nodiscard]] std::string attribute(std::string_view variable, const std::string& attribute) const;

 private:
  /// Where the library has a variable.
  struct Place {
    int group, variable;
  };
  void list();
  void list(int group, const std::string& prefix);
  void check(int status) const;
  [[nodiscard]] Place place_of(const NetcdfVariable& variable) const;
  [[nodiscard]] const NetcdfVariable& numeric(std::string_view variable) const;
  [[nodiscard]] std::string text_attribute(Place place, const std::string& attribute) const;

  std::string name_, bytes_;
  std::vector<NetcdfVariable> variables_;
  std::vector<Place> places_;  ///< of each
  int id_ = -1;
};

/// Type of a variable's values: double, int, signed char, std::string.
enum class NetcdfType { number, integer, byte, text };

/// Values that are stored elsewhere, last dimension fastest; the types in the order of NetcdfType.
using NetcdfValues = std::variant<std::span<const double>, std::span<const int>, std::span<const signed char>,
                                  std::span<const std::string>>;

/// Part of a variable: its first place and its size along each dimension. Empty: all of the variable.
struct NetcdfBlock {
  std::vector<std::size_t> start, count;
};

/// Writes a NetCDF-4 file, which is whole once finish() has returned. The same calls give the same bytes.
/// All functions throw std::runtime_error with the file's name and the library's reason.
class NetcdfWriter {
 public:
  enum class Place { memory, disk };
  enum class Dimension : int {};
  enum class Variable : int {};

  /// @param name path of a file on disk; for messages only where the file is in memory.
  NetcdfWriter(std::string name, Place place);
  ~NetcdfWriter();
  NetcdfWriter(const NetcdfWriter&) = delete;
  NetcdfWriter& operator=(const NetcdfWriter&) = delete;

  /// Writes the attributes that all files of ours have: conventions, title, source and history.
  void describe(const std::string& title, const std::string& source, std::string_view version) const;

  /// What follows is written into a group of that name; it may use the dimensions defined before.
  void begin_group(const std::string& name);

  /// @param size at least 1; the library takes 0 for an unlimited dimension.
  [[nodiscard]] Dimension dimension(const std::string& name, std::size_t size) const;

  /// Defines a variable. On disk its numbers are not initialised, so that each must be put().
  /// @param units may be empty, as those of texts are: then there is no such attribute.
  [[nodiscard]] Variable define(const std::string& name, NetcdfType type, const std::vector<Dimension>& dimensions,
                                const std::string& units, const std::string& long_name) const;
  /// Stores a variable in pieces of this size along each dimension; before its first put().
  void chunk(Variable variable, const std::vector<std::size_t>& sizes) const;
  /// Writes a block of a variable. `values` are of the variable's type, and as many as the block has places.
  void put(Variable variable, const NetcdfValues& values, const NetcdfBlock& block = {}) const;
  /// Defines a variable and writes all of it.
  Variable write(const std::string& name, const std::vector<Dimension>& dimensions, const NetcdfValues& values,
                 const std::string& units, const std::string& long_name) const;

  /// Writes an attribute of the file.
  void attribute(const char* name, const std::string& text) const;
  /// Writes an attribute of a variable; `values` are no texts.
  void attribute(Variable variable, const char* name, const std::string& text) const;
  void attribute(Variable variable, const char* name, const NetcdfValues& values) const;

  /// Closes the file. @return its bytes where it is in memory, else nothing.
  std::string finish();

 private:
  void check(int status) const;

  std::string name_;
  Place place_;
  int id_ = -1, group_ = -1;  ///< of the file, and of what is written now
};

}  // namespace bentur
