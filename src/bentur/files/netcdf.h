#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/io/results/result_variable.h"

namespace bentur {

/// What keeps a file from being read, without the file's name; what() has both.
struct NetcdfError : std::runtime_error {
  NetcdfError(const std::string& file, const std::string& why) : std::runtime_error(file + ": " + why), reason(why) {}
  std::string reason;
};

/// Opens the library, which else the first file does.
/// @throws std::runtime_error where it is not there, as whatever is done with a file does: better before hours of work.
void require_netcdf();

/// An open file by its names alone.
class NetcdfNames {
 public:
  explicit NetcdfNames(int file) : file_(file) {}
  /// Whether there is a variable of this name that is in no group.
  [[nodiscard]] bool has(const std::string& variable) const;
  /// A text attribute of the file; empty where there is none.
  [[nodiscard]] std::string attribute(const std::string& name) const;

 private:
  int file_;  ///< the library's number
};

/// Asks what a file is without reading it, in a process of its own. @return the answer; false of what cannot be opened
/// @throws std::runtime_error as require_netcdf(); NetcdfError where there can be no such process
[[nodiscard]] bool ask_netcdf(const std::filesystem::path& file,
                              const std::function<bool(const NetcdfNames&)>& question);

/// Reads what bentur has written, a variable at a time; those of a group are called "group/variable". A missing or
/// broken file, and a variable that is not there or of another type, are NetcdfError. The library dies of some damaged
/// files, so a file is first read in a process of its own.
class NetcdfReader final : public ResultSource {
 public:
  explicit NetcdfReader(const std::filesystem::path& file);
  /// A file that is in memory; `name` is for messages.
  NetcdfReader(std::string bytes, std::string name);
  ~NetcdfReader() override;
  NetcdfReader(const NetcdfReader&) = delete;
  NetcdfReader& operator=(const NetcdfReader&) = delete;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::vector<StoredVariable>& variables() const noexcept override { return variables_; }
  /// @throws NetcdfError where there is none of that name.
  [[nodiscard]] const StoredVariable& at(std::string_view variable) const;
  /// A group's own dimension is called "group/dimension".
  [[nodiscard]] std::size_t dimension_size(std::string_view dimension) const override;
  [[nodiscard]] std::vector<double> numbers(std::string_view variable) const override;
  [[nodiscard]] std::vector<double> numbers(std::string_view variable, std::size_t i) const override;
  [[nodiscard]] std::vector<std::string> texts(std::string_view variable) const override;
  /// A text attribute of the file; empty where there is none.
  [[nodiscard]] std::string attribute(const std::string& attribute) const override;
  /// The same of a variable.
  [[nodiscard]] std::string attribute(std::string_view variable, const std::string& attribute) const override;
  [[noreturn]] void fail(const std::string& why) const override { throw NetcdfError(name_, why); }

 private:
  /// Where the library has a variable.
  struct Place {
    int group, variable;
  };
  enum class Examined { no, yes };
  NetcdfReader(const std::filesystem::path& file, Examined examined);
  void examine() const;
  void read_all() const;
  void list();
  void list(int group, const std::string& prefix);
  void check(int status) const;
  [[nodiscard]] Place place_of(const StoredVariable& variable) const;
  [[nodiscard]] const StoredVariable& numeric(std::string_view variable) const;
  [[nodiscard]] std::string text_attribute(Place place, const std::string& attribute) const;

  std::string name_, bytes_;
  std::uintmax_t size_ = 0;  ///< of the file [bytes]
  std::vector<StoredVariable> variables_;
  std::vector<Place> places_;  ///< of each
  std::map<std::string, std::size_t, std::less<>> dimensions_;
  int id_ = -1;
};

/// Part of a variable: its first place and its size along each dimension. Empty: all of the variable.
struct NetcdfBlock {
  std::vector<std::size_t> start, count;
};

/// Writes a NetCDF-4 file on disk, block by block, which is whole once finish() has returned. The same calls give the
/// same bytes. What is in memory as a whole netcdf_image() makes sooner.
/// All functions throw std::runtime_error with the file's name and the library's reason.
class NetcdfWriter {
 public:
  enum class Variable : std::size_t {};

  explicit NetcdfWriter(std::string path);
  ~NetcdfWriter();
  NetcdfWriter(const NetcdfWriter&) = delete;
  NetcdfWriter& operator=(const NetcdfWriter&) = delete;

  void attribute(const ResultAttribute& attribute);
  /// Defines a variable, and its dimensions and group where there are none yet; a dimension has at least one place, the
  /// library takes 0 for an unlimited one. Writes the variable's values where it has any; else each must be put():
  /// numbers are not initialised.
  Variable add(const ResultVariable& variable);
  /// Stores a variable in pieces of this size along each dimension; before its first put().
  void chunk(Variable variable, const std::vector<std::size_t>& sizes) const;
  /// Writes a block of a variable. `values` are of the variable's type, and as many as the block has places.
  /// @throws std::logic_error where they are not as many.
  void put(Variable variable, const ResultValues& values, const NetcdfBlock& block = {}) const;

  /// Closes the file.
  void finish();

 private:
  void check(int status) const;
  [[nodiscard]] std::size_t places(int group, int variable, const NetcdfBlock& block) const;

  /// Number of the group that "group/name" is in, the file's own of another name.
  int group_of(const std::string& name);
  void attribute(int group, int variable, const ResultAttribute& attribute) const;

  /// Where the library has a variable.
  struct Stored {
    int group, variable;
  };
  std::string name_;
  int id_ = -1;  ///< of the file
  std::map<std::string, int> groups_, dimensions_;
  std::vector<Stored> variables_;
};

}  // namespace bentur
