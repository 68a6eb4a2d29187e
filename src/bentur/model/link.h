#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/elements/law.h"
#include "bentur/elements/law_entry.h"
#include "bentur/model/gap/levels.h"
#include "bentur/pounding/plan/faces.h"
#include "bentur/pounding/problem.h"

namespace bentur {

/// What joins two buildings at some elevations, as a case says it.
struct LinkSpec {
  std::size_t left = 0, right = 1;  ///< indices of the buildings, left < right
  std::vector<double> elevations;   ///< [length] absolute, one per point, ascending
  std::string law = "spring-dashpot";
  /// One value for all points or one each.
  std::map<std::string, std::vector<double>, std::less<>> numbers = {};
  std::optional<double> level_tolerance = std::nullopt;  ///< [length] as level_floors() takes it
  std::shared_ptr<const LawEntryOf<Law>> own = nullptr;  ///< a law that is not listed, in place of `law`
  // Of buildings in plan, L and R of the stretch in place of left and right:
  Stretch stretch = {};
  double at = 0;                             ///< on the stretch [length]
  PlanPoint direction = PlanPoint::UnitX();  ///< that it acts along, of length 1

  /// What applies at point `point` (0 the lowest): the number given, or the law's default.
  /// @throws InvalidParameter when there is neither, or a list has no such entry.
  [[nodiscard]] double number(std::string_view key, std::size_t point) const;
};

/// All laws that a link can have.
[[nodiscard]] const std::vector<LawEntryOf<Law>>& link_laws();

/// The law of one point. @throws InvalidParameter, naming the key at fault, when the case has no such law or its values
/// do not go together.
[[nodiscard]] std::shared_ptr<const Law> make_link_law(const LinkSpec& spec, std::size_t point);

/// One link per elevation of a spec between two buildings, with their names.
/// @throws InvalidParameter when they do not both have a floor there.
[[nodiscard]] std::vector<Link> links_of(const LinkSpec& spec, const FloorLevels& left, const FloorLevels& right,
                                         const std::array<std::string, 2>& names);

/// One link per elevation of each spec, in their order.
/// @throws InvalidParameter when a building does not exist or has no floor there.
[[nodiscard]] std::vector<Link> links_of(const std::vector<LinkSpec>& specs, const std::vector<Building>& buildings);

/// Of each spec its links, as indices into Problem::links, from the lowest up.
[[nodiscard]] std::vector<std::vector<Eigen::Index>> links_by_spec(const std::vector<LinkSpec>& specs);

/// "Model 1 – Model 3".
[[nodiscard]] std::string link_name(const Problem& problem, const Link& link);

}  // namespace bentur
