#pragma once

#include <string>
#include <string_view>

#include "bentur/study/remarks/remarks.h"

namespace bentur {

/// A remark as a sentence or two: the number, what is usual, what follows. @throws InvalidParameter for an unknown
/// language or a remark that the catalogue does not have.
[[nodiscard]] std::string remark_text(const Remark& remark, std::string_view language = "en");

/// What the model leaves out.
[[nodiscard]] std::string model_text(std::string_view language = "en");

}  // namespace bentur
