#pragma once

#include <string>

#include "bentur/report/html/words.h"
#include "bentur/study/remarks.h"

namespace bentur {

/// A remark as one sentence or two: the number, what is usual, what follows. For the program, in English.
[[nodiscard]] std::string remark_text(const Remark& remark, const html::Words& say = html::Words("en"));

}  // namespace bentur
