#include "bentur/core/require.h"

#include <fmt/format.h>

#include <cmath>

#include "bentur/core/errors.h"

namespace bentur {

void require_positive(const std::string& name, double value) {
  if (!(std::isfinite(value) && value > 0)) throw InvalidParameter(name, fmt::format("{}", value), "must be > 0");
}

void require_not_negative(const std::string& name, double value) {
  if (!(std::isfinite(value) && value >= 0)) throw InvalidParameter(name, fmt::format("{}", value), "must be >= 0");
}

void require_finite(const std::string& name, double value) {
  if (!std::isfinite(value)) throw InvalidParameter(name, fmt::format("{}", value), "must be finite");
}

void require_size(const std::string& name, std::size_t size, std::size_t expected) {
  if (size != expected) {
    throw InvalidParameter(name, fmt::format("a list of {}", size), fmt::format("must have {} entries", expected));
  }
}

std::string indexed(const std::string& name, std::size_t index) { return fmt::format("{}[{}]", name, index); }

}  // namespace bentur
