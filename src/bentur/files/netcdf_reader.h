#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
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

/// long_name of a coordinate that does no more than name or number the places of its dimension.
inline constexpr std::string_view index_title = "what moves together, by its labels or numbered from 0";

/// What keeps a file from being read, without the file's name; what() has both.
struct NetcdfError : std::runtime_error {
  NetcdfError(const std::string& file, const std::string& why) : std::runtime_error(file + ": " + why), reason(why) {}
  std::string reason;
};

/// Reads what bentur has written, a variable at a time. A missing or broken file, and a variable that is not there or
/// of another type, are NetcdfError.
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
  void list();
  void check(int status) const;
  [[nodiscard]] int id_of(const NetcdfVariable& variable) const;
  [[nodiscard]] const NetcdfVariable& numeric(std::string_view variable) const;
  [[nodiscard]] std::string text_attribute(int variable, const std::string& attribute) const;

  std::string name_, bytes_;
  std::vector<NetcdfVariable> variables_;
  int id_ = -1;
};

}  // namespace bentur
