#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "bentur/model/judgement/open_needs.h"
#include "bentur/study/remedy/internal/measure.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

constexpr double no_measure = std::numeric_limits<double>::infinity();

std::optional<double> largest_size(const std::vector<RowPart>& parts, const std::vector<double>& row) {
  std::optional<double> most;
  for (const RowPart& part : parts) {
    for (Eigen::Index i = 0; i < part.count; ++i) {
      const double value = std::abs(row[part.first + static_cast<std::size_t>(i)]);
      if (!std::isnan(value)) most = std::max(most.value_or(value), value);
    }
  }
  return most;
}

}  // namespace

std::vector<RowPart> parts_named(const std::vector<RowPart>& parts, const std::string& name) {
  std::vector<RowPart> found;
  for (const RowPart& part : parts) {
    if (is_quantity(part.name, name)) found.push_back(part);
  }
  return found;
}

// Needs of the free response know nothing of contacts.
Measure::Measure(const std::vector<RowPart>& parts, const std::string& objective)
    : of_(parts_named(parts, objective)), is_free_(objective.find("gap_needed") != std::string::npos) {
  for (const RowPart& part : parts) {
    if (part.name == "open_needs") open_.push_back(part);
    if (part.name == "collapsed" || (part.name == "unmodelled_contacts" && !is_free_)) refused_.push_back(part);
  }
}

double Measure::operator()(const RunResult& result) const {
  if (result.status != RunStatus::done || largest_size(refused_, result.values).value_or(0) > 0) return no_measure;
  if (is_free_ && has(open(result), OpenNeed::drift)) return no_measure;
  return largest_size(of_, result.values).value_or(no_measure);
}

std::uint64_t Measure::open(const RunResult& result) const {
  std::uint64_t bits = 0;
  if (result.status != RunStatus::done) return bits;
  for (const RowPart& part : open_) bits |= static_cast<std::uint64_t>(result.values[part.first]);
  return is_free_ ? bits : bits & static_cast<std::uint64_t>(OpenNeed::doubt);
}

}  // namespace bentur
