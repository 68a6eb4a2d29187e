set(BENTUR_HEADER_ONLY Boost::headers nlohmann_json::nlohmann_json)

# bentur_alone(file...): not merged with others in a unity build, where sources of a target are compiled many at a time
# (presets release and asan, clang-tidy), because helpers of theirs have the names of others' or they have compile options
# of their own.
function(bentur_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# bentur_in_batches(TARGET file...): adds sources so that in a unity build all batches are of one size, and those sources
# come first and together that include a library of many templates (or one of our headers that does): a batch reads and
# instantiates it once. Which are compiled alone has been said before.
function(bentur_in_batches target)
  set(of_templates "#include [<\"](CLI/|nlohmann/|commands|bentur/report/html/internal/motion_data)")
  set(first)
  set(rest)
  set(merged 0)
  foreach(source IN LISTS ARGN)
    file(STRINGS ${source} found LIMIT_COUNT 1 REGEX "${of_templates}")
    if(found)
      list(APPEND first ${source})
    else()
      list(APPEND rest ${source})
    endif()
    get_source_file_property(alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    if(NOT alone)
      math(EXPR merged "${merged} + 1")
    endif()
  endforeach()
  target_sources(${target} PRIVATE ${first} ${rest})
  if(CMAKE_UNITY_BUILD AND merged)
    math(EXPR batches "(${merged} + ${CMAKE_UNITY_BUILD_BATCH_SIZE} - 1) / ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
    math(EXPR size "(${merged} + ${batches} - 1) / ${batches}")
    list(LENGTH first together)
    if(together GREATER size AND NOT together GREATER CMAKE_UNITY_BUILD_BATCH_SIZE)
      set(size ${together})
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${size})
  endif()
endfunction()

# bentur_module(NAME [LIGHTLY|TEXTS] [DEPENDS target...] [PRIVATE_DEPENDS target...] [TESTS_USE target...])
# One library target per module folder, alias bentur::NAME; *_test.cpp beside the code become the executable NAME_test.
# Every header is public, and installed, but those in folders named engine or internal, which only the module itself
# includes. Its tests may use modules that need it. What it depends on is looked for, or built, for its sake: modules that others need come after them.
function(bentur_module name)
  cmake_parse_arguments(ARG "LIGHTLY;TEXTS" "" "DEPENDS;PRIVATE_DEPENDS;TESTS_USE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
  list(FILTER headers EXCLUDE REGEX "/(engine|internal)/")
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  foreach(dependency IN LISTS ARG_DEPENDS ARG_PRIVATE_DEPENDS)
    if(dependency MATCHES "^bentur::(.+)")
      set_property(GLOBAL APPEND PROPERTY BENTUR_NEEDED ${CMAKE_MATCH_1})
    else()
      bentur_find(${dependency} REQUIRED)
    endif()
    if(NOT dependency IN_LIST BENTUR_HEADER_ONLY)
      set_property(GLOBAL APPEND PROPERTY BENTUR_NEEDS_${name} ${dependency})
    endif()
  endforeach()
  add_library(bentur_${name} STATIC)
  bentur_in_batches(bentur_${name} ${sources})
  add_library(bentur::${name} ALIAS bentur_${name})
  set_target_properties(bentur_${name} PROPERTIES EXPORT_NAME ${name})
  target_sources(bentur_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${headers})
  target_link_libraries(bentur_${name} PUBLIC ${ARG_DEPENDS})
  foreach(dependency IN LISTS ARG_PRIVATE_DEPENDS)
    if(dependency IN_LIST BENTUR_HEADER_ONLY)  # nothing to link: users of the installed library need not have it
      target_link_libraries(bentur_${name} PRIVATE $<BUILD_INTERFACE:${dependency}>)
    else()
      target_link_libraries(bentur_${name} PRIVATE ${dependency})
    endif()
  endforeach()
  target_compile_features(bentur_${name} PUBLIC cxx_std_20)
  # Under the sanitizers a module whose own tests are not run is one of those that read and write, which compile faster.
  if(ARG_TEXTS OR (ARG_LIGHTLY AND sanitized AND NOT ${name}_test IN_LIST sanitized_programs))
    bentur_compile(bentur_${name} TEXTS)
  elseif(ARG_LIGHTLY)
    bentur_compile(bentur_${name} LIGHTLY)
  else()
    bentur_compile(bentur_${name})
  endif()
  set_property(GLOBAL APPEND PROPERTY BENTUR_MODULES ${name})
  if(BENTUR_BUILD_TESTS AND tests)
    bentur_test(${name}_test SOURCES ${tests} LIBRARIES ${ARG_TESTS_USE} bentur::${name} ${ARG_PRIVATE_DEPENDS})
  endif()
endfunction()

# bentur_generated(MODULE SOURCE): a source that the build writes becomes part of the module. It is compiled by a target of
# its own: where a target has such a source, CMake lets none of its other sources begin before all of its libraries are there.
function(bentur_generated module source)
  get_filename_component(name ${source} NAME_WE)
  set(target bentur_${module}_${name})
  add_library(${target} OBJECT ${source})
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../src)
  target_compile_features(${target} PRIVATE cxx_std_20)
  bentur_compile_options(${target})
  target_compile_options(${target} PRIVATE -Wno-overlength-strings)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  target_sources(bentur_${module} PRIVATE $<TARGET_OBJECTS:${target}>)
endfunction()

# bentur_embed(MODULE FUNCTION HEADER file...): the files become part of the module, so that the program needs none of
# them installed; HEADER declares std::span<const EmbeddedFile> FUNCTION().
function(bentur_embed module function header)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed.cmake)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} -DHEADER=${header} -DFUNCTION=${function} "-DFILES=${ARGN}" -P ${script}
    DEPENDS ${ARGN} ${script}
    COMMENT "Embedding files in ${module}" VERBATIM)
  bentur_generated(${module} ${source})
endfunction()

# bentur_test(NAME SOURCES file... [LIBRARIES target...]): a GoogleTest executable; CTest knows each of its cases, under the
# sanitizers the whole alone.
function(bentur_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    BENTUR_SOURCE_DIR="${PROJECT_SOURCE_DIR}" BENTUR_BINARY_DIR="${PROJECT_BINARY_DIR}")
  if(name MATCHES "^(system|pounding|solve|structure|elements|core)_test$|^allocation_count$")  # which compute by themselves, or count what is compiled
    bentur_compile(${name} TEXTS)
    target_compile_options(${name} PRIVATE $<$<PLATFORM_ID:Emscripten>:-O1>)
  else()
    bentur_compile(${name} TESTS)
  endif()
  set_target_properties(${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 10)  # helpers of more tests have one another's names
  if(sanitized AND NOT name IN_LIST sanitized_programs)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  elseif(sanitized)  # whose start takes longer than most cases
    target_compile_definitions(${name} PRIVATE BENTUR_SANITIZED)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES TIMEOUT 1500 COST 50)
    if(NOT "$ENV{BENTUR_PART}" STREQUAL "all")  # every sixth case; ./dev soak runs all of them
      set_tests_properties(${name} PROPERTIES ENVIRONMENT "GTEST_TOTAL_SHARDS=6;GTEST_SHARD_INDEX=0")
    endif()
  else()
    gtest_discover_tests(${name} TEST_PREFIX "${name}." DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
      PROPERTIES TIMEOUT 300)
  endif()
endfunction()

# In a unity build locals of one source shadow names of another's; -Wshadow then looks at locals alone.
# Everything is position-independent, the libraries for those who link them into shared ones, programs to share the
# precompiled headers; in a browser nothing is. Contraction is off so that results do not depend on whether a processor has fused multiply-add.
# g++ 12 sees copies and searches in std::string that overlap or overflow and do neither (GCC bug 105651).
function(bentur_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
    $<IF:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>,-Wshadow>
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds>
    $<$<NOT:$<PLATFORM_ID:Emscripten>>:-fPIC> -ffp-contract=off
    $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)  # as Clang: a function may be made part of its caller
endfunction()

# What reads, writes and tests spends its time in files and in other modules: the compiler's last efforts, a third of the
# time of its build, would be for nothing; under the sanitizers all of its efforts, two thirds.
function(bentur_optimise_lightly target)
  if(sanitized AND NOT BENTUR_FUZZ)  # which goes through readers a million times
    target_compile_options(${target} PRIVATE -O0)
  else()
    target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<NOT:$<PLATFORM_ID:Emscripten>>>:-O1>)
  endif()
endfunction()
