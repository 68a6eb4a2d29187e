#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace bentur::test {

/// Writes a case into `folder`, and a study of it in which one parameter takes `values`. @return the study
inline std::filesystem::path study_of(const char* case_text, const std::filesystem::path& folder,
                                      const std::string& parameter, const std::string& values) {
  std::ofstream(folder / "case.toml") << case_text;
  std::filesystem::path file = folder / "study.toml";
  std::ofstream(file) << "case = 'case.toml'\n[[vary]]\nparameter = '" << parameter << "'\nname = 'varied'\nvalues = ["
                      << values << "]\n";
  return file;
}

}  // namespace bentur::test
