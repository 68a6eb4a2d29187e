#pragma once

#include <optional>

#include "bentur/core/diagnostics.h"
#include "bentur/study/design/study.h"

namespace bentur {

/// Of a study whose case has a suite of records: puts one record in its place in the case, and gives those chosen as
/// one more thing that varies, with their factors as normalisation. They are those that the case as it stands chooses:
/// what else varies, such as a building's period, leaves them as they are. Nothing where the case has no suite, or an
/// error in `diagnostics`.
/// @param study its case and `suite`, where that is known already
[[nodiscard]] std::optional<Vary> take_suite(Study& study, Diagnostics& diagnostics);
/// Once what else varies is read: gives the records their axis. Something else that says which record it is is an
/// error.
void vary_records_of_suite(Vary records, Study& study, Diagnostics& diagnostics);

}  // namespace bentur
