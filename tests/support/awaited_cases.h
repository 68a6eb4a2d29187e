#pragma once

#include <set>
#include <string>

namespace bentur::test {

/// Reference cases whose physics are not there yet: bearings, rigid neighbours, soil, P-Δ and floors against columns.
/// They are refused with a message until they are.
inline const std::set<std::string> awaited_cases = {"friction-pendulum", "isolated-frame",    "isolated-moat",
                                                    "p-delta",           "p-delta-collapse",  "slab-column",
                                                    "soil-pair",         "soil-p-delta-yield"};

}  // namespace bentur::test
