#pragma once

#include "bentur/io/results/internal/asked_json.h"
#include "bentur/model/quantities.h"

namespace bentur {

/// What the hinges of a frame did, and its columns that can break, into the object that stands for it: each, in which
/// order they began to yield, and when the frame could first move without bending. @param b its building in the run
void put_hinges(Json& json, const RunView& run, Eigen::Index b);

}  // namespace bentur
