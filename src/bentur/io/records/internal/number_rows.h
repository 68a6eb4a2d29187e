#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bentur::records {

/// Rows of numbers, one behind the other: a file may have millions.
class NumberRows {
 public:
  void add(double number) { numbers_.push_back(number); }
  void end_row() { ends_.push_back(static_cast<std::uint32_t>(numbers_.size())); }
  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] std::span<const double> operator[](std::size_t row) const {
    const std::size_t begin = row == 0 ? 0 : ends_[row - 1];
    return {numbers_.data() + begin, ends_[row] - begin};
  }
  /// One number of each row; 0 where a row is too short.
  [[nodiscard]] std::vector<double> column(std::size_t index) const {
    std::vector<double> result(size());
    for (std::size_t row = 0; row < size(); ++row) {
      const std::span<const double> numbers = (*this)[row];
      result[row] = index < numbers.size() ? numbers[index] : 0;
    }
    return result;
  }
  /// All of them, row by row.
  [[nodiscard]] const std::vector<double>& all() const { return numbers_; }

 private:
  std::vector<double> numbers_;
  std::vector<std::uint32_t> ends_;  // of the rows
};

}  // namespace bentur::records
