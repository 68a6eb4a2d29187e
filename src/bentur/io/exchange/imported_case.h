#pragma once

#include <string>
#include <vector>

namespace bentur {

/// Lines that say something that was not read.
struct UnreadLines {
  int first = 0, last = 0;  ///< of the file, from 1
  std::string what;
};

/// What another program's file becomes.
struct ImportedCase {
  std::string text;                 ///< of a case file
  std::vector<UnreadLines> unread;  ///< in the order of the file
  std::vector<std::string> taken;   ///< what was made of what the file does not say, sentence by sentence
};

}  // namespace bentur
