#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bentur/model/case.h"

namespace bentur {

/// What was read from a record, as keys of a JSON object (docs/result-files.md).
void put_record(const RecordEcho& record, nlohmann::ordered_json& object);

}  // namespace bentur
