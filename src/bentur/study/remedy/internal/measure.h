#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bentur/study/study_runs.h"

namespace bentur {

/// The quantities of a row that an objective names.
[[nodiscard]] std::vector<RowPart> parts_named(const std::vector<RowPart>& parts, const std::string& name);

/// What one run gives an objective: the largest size of its quantity [its unit]; infinite where the run does not tell
/// what happens, or ends in a collapse.
class Measure {
 public:
  Measure(const std::vector<RowPart>& parts, const std::string& objective);

  [[nodiscard]] const std::vector<RowPart>& parts() const { return of_; }
  [[nodiscard]] double operator()(const RunResult& result) const;
  /// What keeps that from being known, bits of OpenNeed; of a run that does not tell it nothing.
  [[nodiscard]] std::uint64_t open(const RunResult& result) const;

 private:
  std::vector<RowPart> of_, refused_, open_;
  bool is_free_;  ///< the objective is of needs without contact
};

}  // namespace bentur
