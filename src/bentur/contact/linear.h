#pragma once

#include "bentur/contact/laws/linear.h"  // IWYU pragma: export
