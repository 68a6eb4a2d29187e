#pragma once

#include <filesystem>
#include <string>

#include "bentur/model/case.h"

namespace bentur::fuzz {

/// What a target does with its input; each target's source has its own. It must come back from any bytes: whatever is
/// wrong is a message.
void feed(const std::string& input);

/// Ends the program, as a fault found, where something does not hold.
void demand(bool holds, const std::string& what);

/// Counts an input that was no error. @return how many there were
long accepted(bool is = true);

/// Where files that inputs name are looked for, and inputs that must be files are put: a copy of the examples
/// beside one of the data that they name.
const std::filesystem::path& folder();

std::filesystem::path as_file(const std::string& input, const std::string& name);

/// A short run of a case that was read, where it is one of some buildings of some floors. The checks that every run
/// makes of itself end it with a message of their own. @return whether it ran
bool run_shortly(Case c);

/// A whole file, damaged as the input says: four bytes at a time are a place and what stands there now; the first byte
/// of the input says whether the file ends at the first of these places too.
std::string damaged(std::string whole, const std::string& input);

}  // namespace bentur::fuzz
