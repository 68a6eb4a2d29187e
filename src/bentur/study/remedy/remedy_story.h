#pragma once

#include "bentur/model/story/story.h"
#include "bentur/study/remedy/remedy.h"

namespace bentur {

/// Of a search: what the case says and gives, the best that was found, with a limit the smallest remedy that keeps it
/// or that none does, what lies at an end of its range, what failed, whether it was stopped.
[[nodiscard]] Story remedy_story(const RemedySearch& search);

}  // namespace bentur
