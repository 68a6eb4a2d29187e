#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace bentur {

struct Case;

/// A dimension of the variables of a file of results.
struct ResultDimension {
  std::string name;
  std::size_t size = 0;
  std::string coordinates = {};  ///< names of the variables that say where its places are, but for one of its own name
};

/// Values, last dimension fastest: as a run has them, or made of it. Of no values the type alone counts.
using ResultValues = std::variant<std::span<const double>, std::vector<double>, std::vector<int>,
                                  std::vector<signed char>, std::vector<std::string>>;

/// An attribute of a variable or a file, beside units and long_name.
struct ResultAttribute {
  std::string name;
  std::variant<std::string, double, std::vector<signed char>> value;
};

/// A variable of a file of results. One of a group is called "group/variable", and so are the group's own dimensions.
struct ResultVariable {
  std::string name;
  std::vector<ResultDimension> dimensions;
  std::string units, long_name;  ///< units as UDUNITS reads them; empty: none
  std::vector<ResultAttribute> attributes = {};
  ResultValues values = {};
};

/// What a file of results holds.
struct ResultFile {
  std::vector<ResultAttribute> attributes;
  std::vector<ResultVariable> variables;
};

/// What the history of every file of ours begins with, before the version of the program.
inline constexpr std::string_view result_history = "written by bentur";

/// Of a text longer than this HDF5 makes no attribute, so that the case of such a file is left out [bytes].
inline constexpr std::size_t longest_text = 60000;

/// The attributes that all files of ours have: conventions, title, source, history and version.
[[nodiscard]] std::vector<ResultAttribute> file_attributes(const std::string& title, const std::string& source,
                                                           std::string_view version);

/// The same of a run, with its case and solver.
[[nodiscard]] std::vector<ResultAttribute> run_attributes(const Case& c, const std::string& source,
                                                          std::string_view version);

/// Names the coordinates of a variable's dimensions in its attribute "coordinates", behind `more`.
void name_coordinates(ResultVariable& variable, const std::string& more = "");

/// A variable of a file that is read, without its values.
struct StoredVariable {
  std::string name;
  std::string units, long_name;  ///< attributes; empty where there is none
  std::vector<std::string> dimensions;
  std::vector<std::size_t> shape;        ///< one size per dimension
  std::vector<std::string> coordinates;  ///< of the attribute, word by word
  bool text = false;
};

/// A file of results that is read.
class ResultSource {
 public:
  virtual ~ResultSource() = default;
  [[nodiscard]] virtual const std::vector<StoredVariable>& variables() const noexcept = 0;
  /// nullptr where there is none of that name.
  [[nodiscard]] const StoredVariable* find(std::string_view variable) const noexcept;
  [[nodiscard]] bool has(std::string_view variable) const noexcept { return find(variable) != nullptr; }
  /// 0 where there is no such dimension.
  [[nodiscard]] virtual std::size_t dimension_size(std::string_view dimension) const = 0;
  /// All values, last dimension fastest.
  [[nodiscard]] virtual std::vector<double> numbers(std::string_view variable) const = 0;
  /// Those at place `i` of the first dimension, so that memory need not hold them all.
  [[nodiscard]] virtual std::vector<double> numbers(std::string_view variable, std::size_t i) const = 0;
  [[nodiscard]] virtual std::vector<std::string> texts(std::string_view variable) const = 0;
  /// A text attribute of a variable, or of the file; empty where there is none.
  [[nodiscard]] virtual std::string attribute(std::string_view variable, const std::string& attribute) const = 0;
  [[nodiscard]] virtual std::string attribute(const std::string& attribute) const = 0;
  /// Throws what keeps the file from being read.
  [[noreturn]] virtual void fail(const std::string& why) const = 0;
};

}  // namespace bentur
