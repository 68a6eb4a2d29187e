# Which bentur this is: bentur_version(OUT). As a script, which needs nothing but CMake and, in a clone, git:
#   cmake -P version.cmake                       prints it
#   cmake -DOUTPUT=version.cpp -P version.cmake  writes the source that returns it, unless that is what stands there
# With N the version in CMakeLists.txt, in the form of PEP 440, so that Python packages can have it too:
#   N                        the commit with the tag vN; or nothing is known of commits
#   N.dev874+g2e9c731a       874 commits after the tag before N, or in all where there is no tag
#   N.post3+g2e9c731a        3 commits after the tag vN
#   N.dev20261126+g2e9c731a  an archive where there is no tag: the day of the commit
#   …+g2e9c731a.dirty        files that git tracks differ from that commit
# A clone asks git. An archive has commit.txt, which `git archive` fills in, a source distribution of Python PKG-INFO.
if(CMAKE_SCRIPT_MODE_FILE)
  cmake_minimum_required(VERSION 3.18)
endif()

function(bentur_version out)
  get_filename_component(root ${CMAKE_CURRENT_FUNCTION_LIST_DIR} DIRECTORY)
  file(STRINGS ${root}/CMakeLists.txt version REGEX "^project\\(bentur VERSION ")
  string(REGEX REPLACE ".* VERSION ([0-9.]+) .*" "\\1" version "${version}")
  foreach(variable described tag number hash dirty)
    set(${variable} "")
  endforeach()
  if(EXISTS ${root}/.git)  # a clone of its own, and not a folder within another one
    foreach(variable GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE)  # set where git has started the build, of whatever clone
      unset(ENV{${variable}})
    endforeach()
    get_filename_component(above ${root} DIRECTORY)
    set(ENV{GIT_CEILING_DIRECTORIES} ${above})
    set(ENV{GIT_OPTIONAL_LOCKS} 0)
    set(git git -C ${root})
    set(quietly OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${git} describe --tags --always --long --dirty --abbrev=8 "--match=v[0-9]*"
      OUTPUT_VARIABLE described ${quietly})
    if(described MATCHES "^([0-9a-f]+)(-dirty)?$")  # there is no tag
      set(hash ${CMAKE_MATCH_1})
      set(dirty "${CMAKE_MATCH_2}")
      execute_process(COMMAND ${git} rev-list --count HEAD OUTPUT_VARIABLE number ${quietly})
    endif()
  else()
    file(STRINGS ${root}/cmake/commit.txt stamp REGEX "^[0-9a-f]+ ")
    if(stamp MATCHES "^([0-9a-f]+) ([0-9]+)-([0-9]+)-([0-9]+) ?(.*)$")
      string(SUBSTRING ${CMAKE_MATCH_1} 0 8 hash)
      set(number ${CMAKE_MATCH_2}${CMAKE_MATCH_3}${CMAKE_MATCH_4})
      set(described "${CMAKE_MATCH_5}")
    elseif(EXISTS ${root}/PKG-INFO)
      file(STRINGS ${root}/PKG-INFO version REGEX "^Version: " LIMIT_COUNT 1)
      string(REPLACE "Version: " "" version "${version}")
    endif()
  endif()
  if(described MATCHES "^v(.+)-([0-9]+)-g([0-9a-f]+)(-dirty)?$")
    set(tag ${CMAKE_MATCH_1})
    set(number ${CMAKE_MATCH_2})
    set(hash ${CMAKE_MATCH_3})
    set(dirty "${CMAKE_MATCH_4}")
  elseif(described MATCHES "^v(.+)$")  # an archive of the very commit
    set(tag ${CMAKE_MATCH_1})
    set(number 0)
  endif()
  if("${tag}" STREQUAL "${version}")
    string(PREPEND number .post)
  else()
    string(PREPEND number .dev)
  endif()
  if("${number}" STREQUAL ".post0")
    set(number "")
  endif()
  if(NOT "${hash}" STREQUAL "" AND NOT "${number}${dirty}" STREQUAL "")
    string(REPLACE "-" "." dirty "${dirty}")
    string(APPEND version ${number}+g${hash}${dirty})
  endif()
  set(${out} ${version} PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  bentur_version(version)
  if(OUTPUT)
    set(source "#include \"bentur/core/version.h\"\n
namespace bentur {\n
std::string_view version() noexcept { return \"${version}\"; }\n
}  // namespace bentur\n")
    file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${source}" @ONLY)  # leaves alone what is the same
  else()
    execute_process(COMMAND ${CMAKE_COMMAND} -E echo ${version})
  endif()
endif()
