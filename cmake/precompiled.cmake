# The headers that most sources include are read once and not a hundred times: a third of the time of a build. Every source
# still includes what it uses: preset debug and clang-tidy build without.
file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
set(BENTUR_OF_TESTS $<IF:$<PLATFORM_ID:Emscripten>,-O1,-O0>)
set(all bentur_precompiled bentur_precompiled_lightly)
if(BENTUR_BUILD_TESTS)
  list(APPEND all bentur_precompiled_tests)
endif()
foreach(precompiled IN LISTS all)
  add_library(${precompiled} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${precompiled} PRIVATE Eigen3::Eigen fmt::fmt)
  target_compile_features(${precompiled} PUBLIC cxx_std_20)
  target_precompile_headers(${precompiled} PRIVATE
    <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers> <numeric>
    <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>
    <Eigen/Core> <fmt/format.h>)
  bentur_compile_options(${precompiled})
endforeach()
bentur_optimise_lightly(bentur_precompiled_lightly)
if(BENTUR_BUILD_TESTS)
  target_compile_options(bentur_precompiled_tests PRIVATE ${BENTUR_OF_TESTS})
  target_link_libraries(bentur_precompiled_tests PRIVATE GTest::gtest_main)
  target_precompile_headers(bentur_precompiled_tests PRIVATE <gtest/gtest.h>)
endif()

# bentur_compile(TARGET [LIGHTLY|TEXTS|TESTS]): the project's options and precompiled headers; LIGHTLY, TEXTS: see
# bentur_optimise_lightly. Under the sanitizers those that are LIGHTLY step through as much as the others. TESTS call what
# they test and compare: they are not optimised.
function(bentur_compile target)
  bentur_compile_options(${target})
  if("TESTS" IN_LIST ARGN)
    target_compile_options(${target} PRIVATE ${BENTUR_OF_TESTS})
    target_precompile_headers(${target} REUSE_FROM bentur_precompiled_tests)
    return()
  endif()
  if("TEXTS" IN_LIST ARGN OR ("LIGHTLY" IN_LIST ARGN AND NOT sanitized))
    bentur_optimise_lightly(${target})
    target_precompile_headers(${target} REUSE_FROM bentur_precompiled_lightly)
  else()
    target_precompile_headers(${target} REUSE_FROM bentur_precompiled)
  endif()
endfunction()
