#pragma once

#include <memory>
#include <string>
#include <utility>

#include "bentur/contact/laws.h"

namespace bentur {

/// A law that is not listed: whoever calls the library brings it along where a case has a law's name. An entry for each
/// place that it can stand in, null for the others; they take no keys of a case.
struct OwnLaw {
  explicit OwnLaw(std::string of) : name(std::move(of)) {}
  virtual ~OwnLaw() = default;
  OwnLaw(const OwnLaw&) = delete;
  OwnLaw& operator=(const OwnLaw&) = delete;

  const std::string name;
  std::shared_ptr<const LawEntry> contact;
  std::shared_ptr<const LawEntryOf<Law>> link;
  std::shared_ptr<const LawEntryOf<HystereticLaw>> storey;  ///< made as hysteretic_laws() are
};

}  // namespace bentur
