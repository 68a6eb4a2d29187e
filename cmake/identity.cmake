# Writes a C++ source with a hash of files, in the order given; needs nothing but CMake.
#   cmake -DOUTPUT=build_identity.cpp "-DFILES=a.cpp;b.h" -P identity.cmake
set(all "")
foreach(file IN LISTS FILES)
  file(SHA256 ${file} hash)
  string(APPEND all ${hash})
endforeach()
string(SHA256 identity "${all}")
file(WRITE ${OUTPUT} "#include \"bentur/study/build_identity.h\"\n
namespace bentur {\n
std::string_view build_identity() { return \"${identity}\"; }\n
}  // namespace bentur\n")
