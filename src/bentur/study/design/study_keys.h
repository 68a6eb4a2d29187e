#pragma once

#include "bentur/core/key.h"

// Every key of a study, as io/schema/case_keys.h has those of a case.
namespace bentur {

[[nodiscard]] const KeyTable& study_keys();  ///< the whole file
[[nodiscard]] const KeyTable& vary_keys();
[[nodiscard]] const KeyTable& file_entry_keys();   ///< of a table among `files`
[[nodiscard]] const KeyTable& factor_file_keys();  ///< of `normalisation` that names a file
[[nodiscard]] const KeyTable& distribution_keys();
[[nodiscard]] const KeyTable& sampling_keys();
[[nodiscard]] const KeyTable& ida_keys();
[[nodiscard]] const KeyTable& remedy_keys();

}  // namespace bentur
