#pragma once

#include <string>
#include <vector>

namespace bentur {

/// [project] of a case: whose it is and what it is for, as a report says it that is handed in. Texts are as given.
struct ProjectSpec {
  std::string name, number, engineer, date, revision;  ///< empty: not given
  std::string code_basis = {};                         ///< the codes and standards that the project follows
  std::vector<std::string> assumptions = {};           ///< the engineer's own
  std::vector<std::string> sources = {};               ///< where the numbers of the case come from
  std::string logo = {};                               ///< bytes of a picture; empty: none
  std::string logo_type = {};                          ///< "image/png", "image/jpeg" or "image/svg+xml"
  std::string logo_path = {};                          ///< where it was read; no result holds that
};

}  // namespace bentur
