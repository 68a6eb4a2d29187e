#pragma once

#include <string>

#include "bentur/io/results/result_variable.h"

namespace bentur {

/// The bytes of a NetCDF-4 file that holds these variables, for the library of NetCDF and all that read HDF5. It is
/// made without that library, which takes a hundred microseconds a variable: a block of a thousand houses has forty
/// thousand.
///
/// NetCDF-4 is HDF5 with dimension scales (NetCDF User's Guide, appendix "File Format Specifications"; HDF5 File Format
/// Specification 3.0, of which superblock 0, groups as symbol tables, object headers 1 and contiguous layouts are
/// used). Names are in alphabetical order, dimensions have the numbers of their first use, and what HDF5 keeps for
/// scales that are taken away again (REFERENCE_LIST) is left out. The same variables give the same bytes.
///
/// A dimension has at least one place. @throws std::invalid_argument where a variable has not as many values as places,
/// or an attribute is longer than HDF5 allows (64 kB).
[[nodiscard]] std::string netcdf_image(const ResultFile& file);

}  // namespace bentur
