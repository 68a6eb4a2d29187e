# The headers that most sources include are read once and not a hundred times: a third of the time of a build. Every source
# still includes what it uses: preset debug and clang-tidy build without.
file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
foreach(precompiled bentur_precompiled bentur_precompiled_lightly)
  add_library(${precompiled} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${precompiled} PRIVATE Eigen3::Eigen fmt::fmt)
  target_compile_features(${precompiled} PUBLIC cxx_std_20)
  target_precompile_headers(${precompiled} PRIVATE
    <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers> <numeric>
    <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>
    <Eigen/Core> <fmt/format.h>)
endforeach()
bentur_compile_options(bentur_precompiled)
bentur_compile_options(bentur_precompiled_lightly)
bentur_optimise_lightly(bentur_precompiled_lightly)

# bentur_compile(TARGET [LIGHTLY|TEXTS]): the project's options and precompiled headers; LIGHTLY, TEXTS: see
# bentur_optimise_lightly. Under the sanitizers those that are LIGHTLY step through as much as the others.
function(bentur_compile target)
  bentur_compile_options(${target})
  if("TEXTS" IN_LIST ARGN OR ("LIGHTLY" IN_LIST ARGN AND NOT sanitized))
    bentur_optimise_lightly(${target})
    target_precompile_headers(${target} REUSE_FROM bentur_precompiled_lightly)
  else()
    target_precompile_headers(${target} REUSE_FROM bentur_precompiled)
  endif()
endfunction()
