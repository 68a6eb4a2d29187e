#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/study/remedy/optimiser.h"
#include "bentur/study/study_runs.h"

namespace bentur {

/// The derivatives of an objective's peaks by what a remedy chooses, through the events (docs/theory/sensitivity.md):
/// of those quantities that the tangent run follows.
class ObjectiveSlopes {
 public:
  /// @param of the objective's parts of a row
  /// @param study the one with [remedy], @param axes of its choices, in the order of places
  ObjectiveSlopes(const std::vector<RowPart>& of, const Study& study, std::vector<std::size_t> axes,
                  std::shared_ptr<CaseMemo> memo)
      : of_(of), study_(study), axes_(std::move(axes)), memo_(std::move(memo)) {}

  /// Whether there may be any: the objective is the gap needed, the peak force or a displacement.
  [[nodiscard]] bool may_be() const;
  /// Of a run at places u those peaks that are more than half of the largest, a value and a slope per axis each, one
  /// after the other; none where the largest has no derivative that holds: by the reasons of docs/sensitivity.md, or
  /// because a contact before it grazes. Nothing where it was stopped.
  [[nodiscard]] RunValues at(const std::vector<double>& places) const;
  /// Those values taken apart.
  [[nodiscard]] std::vector<FunctionPart> parts(const std::vector<double>& values) const;

 private:
  [[nodiscard]] std::optional<ReadCase> read_at(const std::vector<double>& places,
                                                const std::vector<Choice>& choices) const;
  [[nodiscard]] std::optional<std::vector<double>> values_at(const std::vector<double>& places,
                                                             const std::vector<Choice>& choices,
                                                             const std::function<bool()>& go_on) const;

  const std::vector<RowPart>& of_;
  const Study& study_;
  std::vector<std::size_t> axes_;
  std::shared_ptr<CaseMemo> memo_;
};

}  // namespace bentur
