#pragma once

#include "bentur/pounding/problem.h"

namespace bentur {

/// For valid problems. @throws InvalidParameter, naming what differs, unless `other` is `problem` but for the widths
/// and laws of its contact points. At rest is the same with and without saying so.
void require_same_but_gaps(const Problem& problem, const Problem& other);

}  // namespace bentur
