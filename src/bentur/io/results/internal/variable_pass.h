#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bentur/io/results/result_variable.h"
#include "bentur/structure/building.h"

namespace bentur {

/// Takes the variables of results that are written.
class Teller {
 public:
  static constexpr bool reads = false;
  [[nodiscard]] ResultDimension dimension(ResultDimension told) const { return told; }
  [[nodiscard]] bool has(const std::string& /*variable*/, bool told) const { return told; }
  void tell(ResultVariable variable) {
    for (const ResultDimension& dimension : variable.dimensions) {
      if (dimension.size == 0) return;  // the library of NetCDF would take it for an unlimited one
    }
    if (variable.name.find('/') == std::string::npos) name_coordinates(variable);
    variables.push_back(std::move(variable));
  }

  std::vector<ResultVariable> variables;
};

/// Gives the values of results that are read: as many as the dimensions of a variable have places, and none where one
/// of these is not there.
class Giver {
 public:
  static constexpr bool reads = true;
  explicit Giver(const ResultSource& from) : source(from) {}
  [[nodiscard]] ResultDimension dimension(ResultDimension told) const {
    told.size = source.dimension_size(told.name);
    return told;
  }
  [[nodiscard]] bool has(const std::string& variable, bool /*told*/) const { return source.has(variable); }

  template <class Value>
  void give(const ResultVariable& variable, std::vector<Value>& values) const {
    values.clear();
    std::size_t size = 1;
    for (const ResultDimension& dimension : variable.dimensions) size *= dimension.size;
    if (size == 0) return;
    if constexpr (std::is_same_v<Value, std::string>) {
      values = source.texts(variable.name);
    } else {
      const std::vector<double> numbers = source.numbers(variable.name);
      values.assign(numbers.begin(), numbers.end());
    }
    if (values.size() != size) source.fail("variables disagree in size at " + variable.name);
  }
  /// The first of two dimensions goes along the columns; one alone along the rows.
  template <int rows, int columns>
  void give(const ResultVariable& variable, Eigen::Matrix<double, rows, columns>& values) const {
    std::vector<double> found;
    give(variable, found);
    const std::vector<ResultDimension>& along = variable.dimensions;
    values = Eigen::Map<const Eigen::MatrixXd>(found.data(), static_cast<Eigen::Index>(along.back().size),
                                               static_cast<Eigen::Index>(along.size() > 1 ? along[0].size : 1));
  }

  const ResultSource& source;
};

/// Hands values to a Teller, or puts those of a Giver where they stand: what is said of a variable is said once.
template <class File>
class VariablePass {
 public:
  explicit VariablePass(File& file) : file_(file) {}

 protected:
  /// Values that are there as long as what is written.
  template <class Values>
  void pass(ResultVariable variable, Values& values) const {
    if constexpr (File::reads) {
      file_.give(variable, values);
    } else {
      variable.values = std::span<const double>(values.data(), static_cast<std::size_t>(values.size()));
      file_.tell(std::move(variable));
    }
  }
  /// Values made to be written, or to be understood once given.
  template <class Value>
  void made(ResultVariable variable, std::vector<Value>& values) const {
    if constexpr (File::reads) {
      file_.give(variable, values);
    } else {
      variable.values = values;
      file_.tell(std::move(variable));
    }
  }
  void made(ResultVariable variable, Eigen::MatrixXd& values) const {
    if constexpr (File::reads) {
      file_.give(variable, values);
    } else {
      variable.values = std::vector<double>(values.data(), values.data() + values.size());
      file_.tell(std::move(variable));
    }
  }
  template <class Number>
  void single(ResultVariable variable, Number& value) const {
    std::vector values = {value};
    made(std::move(variable), values);
    if constexpr (File::reads) value = values.front();
  }
  /// A member of each of some items.
  template <class Items, class Member>
  void each(ResultVariable variable, Items& items, Member member) const {
    std::vector<std::decay_t<decltype(items[0].*member)>> values;
    for (const auto& item : items) values.push_back(item.*member);
    made(std::move(variable), values);
    if constexpr (File::reads) {
      for (std::size_t i = 0; i < values.size(); ++i) items[i].*member = values[i];
    }
  }
  /// A member of each that is the number of a building, written as its name.
  template <class Items, class Member>
  void named(ResultVariable variable, Items& items, Member member, const std::vector<Building>& buildings) const {
    std::vector<std::string> names;
    if constexpr (!File::reads) {
      for (const auto& item : items) names.push_back(buildings.at(item.*member).name);
    }
    made(variable, names);
    if constexpr (File::reads) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = std::find_if(buildings.begin(), buildings.end(),
                                        [&](const Building& building) { return building.name == names[i]; });
        items[i].*member = found - buildings.begin();
        if (found == buildings.end()) file_.source.fail(variable.name + " names no building of it");
      }
    }
  }
  /// As many items as a file has places.
  template <class Items>
  void fit(Items& items, std::size_t size) const {
    if constexpr (File::reads) items.resize(size);
  }

  File& file_;
};

}  // namespace bentur
