#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/exchange/e2k.h"

// What the text of a model says, before a frame is made of it.
namespace bentur {

struct E2kLine {
  int number = 0;
  std::vector<std::string> words;

  [[nodiscard]] std::optional<std::string> after(std::string_view key) const {
    for (std::size_t i = 1; i + 1 < words.size(); ++i) {
      if (words[i] == key) return words[i + 1];
    }
    return std::nullopt;
  }
};

struct E2kMaterial {
  double modulus = 0, weight = 0;
};

struct E2kSection {
  std::string material;
  E2kProperties properties;
  int line = 0;
  double mass = 1;         ///< what the mass of its members counts [-]
  std::string shape = {};  ///< where its sides are given but what they mean is not known
};

/// What is said of a joint at a storey.
struct E2kJoint {
  std::string point, story;
  E2kLine line;
};

/// A section as it is assigned to a member.
struct E2kAssignment {
  std::string section;
  int line = 0;
  E2kProperties factors{1, 1, 1};
  double angle = 0;  ///< [degrees] about the member's axis
  std::string releases = {};
  double mass = 1;  ///< as of a section
};

struct E2kStory {
  std::string name;
  double height = 0;
};

struct E2kMember {
  std::string from, to;
};

/// All that is read of a text.
struct E2kModel {
  std::string force, length;      ///< its units, as a case names them
  std::vector<E2kStory> stories;  ///< from the top
  std::map<std::string, E2kMaterial> materials;
  std::map<std::string, E2kSection> sections;
  std::map<std::string, std::pair<double, double>> points;
  std::map<std::string, E2kMember> columns, beams;
  std::map<std::pair<std::string, std::string>, E2kAssignment> assigned;  ///< by line and story
  std::vector<E2kJoint> joints;
  std::vector<UnreadLines> unread;
};

/// @param name of the file, for messages @param frame whose sections are given
[[nodiscard]] E2kModel read_e2k_text(const std::string& text, const std::string& name, const E2kFrame& frame,
                                     Diagnostics& diagnostics);

/// A number, with a decimal comma too; nothing where it is none.
[[nodiscard]] std::optional<double> e2k_number(const std::string& text);
/// Lines that say something that is not read, those behind one another together.
void add_unread(int line, const std::string& what, std::vector<UnreadLines>& unread);

}  // namespace bentur
