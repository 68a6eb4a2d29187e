#pragma once

#include <cstddef>
#include <vector>

#include "bentur/model/quantities.h"

namespace bentur {

/// The column of a quantity in a table for people; values in the case's units, NaN: there is none.
[[nodiscard]] TableColumn column_of(const Quantity& quantity, std::vector<double> values, const ShownUnits& shown,
                                    std::size_t language);

}  // namespace bentur
