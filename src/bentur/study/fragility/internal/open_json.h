#pragma once

#include <nlohmann/json.hpp>

#include "bentur/model/judgement/open_needs.h"
#include "bentur/study/fragility/ida_results.h"

namespace bentur {

/// Of how many runs it is not known what gap they need, and why.
[[nodiscard]] inline nlohmann::ordered_json open_json(const IdaResults& results) {
  nlohmann::ordered_json reasons = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < results.open.in.size(); ++i) {
    if (results.open.in[i] > 0) reasons[std::string(open_need_keys()[i])] = results.open.in[i];
  }
  return {{"runs", results.open.runs}, {"of", results.done}, {"reasons", reasons}};
}

}  // namespace bentur
