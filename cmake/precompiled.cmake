# The headers that most sources include are read once and not a hundred times: a third of the time of a build. Every source
# still includes what it uses: preset debug and clang-tidy build without.
file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
add_library(bentur_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
target_link_libraries(bentur_precompiled PRIVATE Eigen3::Eigen fmt::fmt)
target_compile_features(bentur_precompiled PUBLIC cxx_std_20)
bentur_compile_options(bentur_precompiled)
target_precompile_headers(bentur_precompiled PRIVATE
  <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers> <numeric>
  <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>
  <Eigen/Core> <fmt/format.h>)
