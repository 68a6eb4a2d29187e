#include "bentur/io/exchange/e2k.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/core/units.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

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

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < line.size();) {
    if (std::isspace(static_cast<unsigned char>(line[i])) != 0) {
      ++i;
    } else if (line[i] == '"') {
      const std::size_t end = std::min(line.find('"', i + 1), line.size());
      words.push_back(line.substr(i + 1, end - i - 1));
      i = end + 1;
    } else {
      std::size_t end = i;
      while (end < line.size() && std::isspace(static_cast<unsigned char>(line[end])) == 0 && line[end] != '"') ++end;
      words.push_back(line.substr(i, end - i));
      i = end;
    }
  }
  return words;
}

struct E2kMaterial {
  double modulus = 0, weight = 0;
};

struct E2kSection {
  std::string material;
  E2kProperties properties;
  int line = 0;
};

/// A section as it is assigned to a member.
struct E2kAssignment {
  std::string section;
  int line = 0;
  E2kProperties factors{1, 1, 1};
  double angle = 0;  ///< [degrees] about the member's axis
  bool released = false;
};

struct E2kStory {
  std::string name;
  double height = 0;
};

struct E2kMember {
  std::string from, to;
};

/// Area, EI and weight per length of the members of one storey or floor, summed.
struct MemberSum {
  double area = 0, stiffness = 0, weight = 0;
  int count = 0;
  std::set<std::string> sections;
};

class E2kReader {
 public:
  E2kReader(const std::string& name, const E2kFrame& frame, Diagnostics& diagnostics)
      : name_(name), frame_(frame), diagnostics_(diagnostics) {}

  std::optional<ImportedCase> read(const std::string& text) {
    std::istringstream stream(text);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const std::size_t begin = line.find_first_not_of(" \t");
      if (begin == std::string::npos) continue;
      if (line[begin] == '$') {
        section_ = line.substr(std::min(line.find_first_not_of("$ \t", begin), line.size()));
        if (section_.rfind("END OF MODEL FILE", 0) == 0) break;
        continue;
      }
      const E2kLine one{number, words_of(line)};
      if (!take(one)) unread(one, section_.empty() ? one.words.front() : section_);
    }
    if (!diagnostics_.ok()) return std::nullopt;
    return made();
  }

 private:
  void error(int line, const std::string& message) { diagnostics_.error({name_, line, 1}, message); }

  void unread(const E2kLine& line, const std::string& what) {
    if (!result_.unread.empty() && result_.unread.back().what == what && result_.unread.back().last < line.number) {
      result_.unread.back().last = line.number;
    } else {
      result_.unread.push_back({line.number, line.number, what});
    }
  }

  /// The number behind a key; an error where it is none.
  std::optional<double> number(const E2kLine& line, std::string_view key) {
    const auto text = line.after(key);
    return text ? number_in(line, std::string(key), *text) : std::nullopt;
  }

  std::optional<double> number_in(const E2kLine& line, const std::string& key, const std::string& text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto read = from_chars(text.data(), end, value);
    if (read.ec == std::errc() && read.ptr == end && std::isfinite(value)) return value;
    error(line.number, fmt::format("{} = {}, must be a number", key, in_quotes(text)));
    return std::nullopt;
  }

  double positive(const E2kLine& line, std::string_view key) {
    const auto value = number(line, key);
    if (value && !(*value > 0)) error(line.number, fmt::format("{} = {}, must be > 0", key, *value));
    return value.value_or(0);
  }

  /// Whether the line was read.
  bool take(const E2kLine& line) {
    const std::string& word = line.words.front();
    const bool named = line.words.size() > 1;
    if (word == "UNITS" && line.words.size() > 2) return take_units(line);
    if (word == "STORY" && named) return take_story(line);
    if (word == "MATERIAL" && named) return take_material(line);
    if (word == "FRAMESECTION" && named) return take_section(line);
    if (word == "POINT" && line.words.size() > 3) {
      const auto x = number_in(line, "x", line.words[2]), y = number_in(line, "y", line.words[3]);
      points_[line.words[1]] = {x.value_or(0), y.value_or(0)};
      return line.words.size() == 4;
    }
    if (word == "LINE" && line.words.size() > 4) {
      const std::string& kind = line.words[2];
      if (kind != "COLUMN" && kind != "BEAM") return false;
      (kind == "COLUMN" ? columns_ : beams_)[line.words[1]] = {line.words[3], line.words[4]};
      return true;
    }
    if (word == "LINEASSIGN" && line.words.size() > 2) {
      return take_assignment(line);
    }
    return word == "PROGRAM" || word.rfind("TITLE", 0) == 0 || word == "GRID" || word == "GRIDSYSTEM";
  }

  bool take_units(const E2kLine& line) {
    static const std::map<std::string, std::string> forces = {{"KN", "kN"},  {"N", "N"},     {"KIP", "kip"},
                                                              {"LB", "lbf"}, {"KGF", "kgf"}, {"TONF", "tf"}};
    static const std::map<std::string, std::string> lengths = {
        {"M", "m"}, {"CM", "cm"}, {"MM", "mm"}, {"IN", "in"}, {"FT", "ft"}};
    const auto unit = [&](const std::map<std::string, std::string>& all, const std::vector<std::string>& known,
                          const std::string& given) -> std::string {
      std::string upper = given;
      for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      const auto found = all.find(upper);
      const bool has = found != all.end() && std::count(known.begin(), known.end(), found->second) > 0;
      if (!has)
        error(line.number, fmt::format("UNITS {}, must be one of {}", in_quotes(given), fmt::join(known, ", ")));
      return has ? found->second : known.front();
    };
    force_ = unit(forces, force_units(), line.words[1]);
    length_ = unit(lengths, length_units(), line.words[2]);
    return true;
  }

  bool take_story(const E2kLine& line) {
    const double height = line.after("HEIGHT") ? number(line, "HEIGHT").value_or(0) : 0;
    if (height > 0) {
      stories_.push_back({line.words[1], height});
    } else if (!line.after("ELEV") && height != 0) {
      error(line.number, fmt::format("HEIGHT = {}, must be > 0", height));
    }
    return true;
  }

  bool take_material(const E2kLine& line) {
    E2kMaterial& material = materials_[line.words[1]];
    bool read = false;
    if (line.after("E")) {
      material.modulus = positive(line, "E");
      read = true;
    }
    for (const char* const key : {"WEIGHTPERVOLUME", "W"}) {
      if (line.after(key)) {
        material.weight = number(line, key).value_or(0);
        read = true;
      }
    }
    return read;
  }

  bool take_assignment(const E2kLine& line) {
    const auto section = line.after("SECTION");
    if (!section) return false;
    E2kAssignment made{.section = *section, .line = line.number};
    const auto factor = [&](const char* key) { return line.after(key) ? positive(line, key) : 1; };
    made.factors = {factor("PROPMODA"), factor("PROPMODI33"), factor("PROPMODI22")};
    made.angle = number(line, "ANG").value_or(0);
    const std::string releases = line.after("RELEASE").value_or("");
    for (const char* const one : {"M3I", "M3J", "PINNED"}) {
      made.released = made.released || releases.find(one) != std::string::npos;
    }
    assigned_[{line.words[1], line.words[2]}] = made;
    std::string open;
    for (const char* const key : {"CARDINALPT", "LENGTHOFFI", "LENGTHOFFJ", "RIGIDZONE"}) {
      if (line.after(key)) open += (open.empty() ? "" : ", ") + std::string(key);
    }
    if (!open.empty()) unread(line, open + " of LINE ASSIGNS");
    return true;
  }

  bool take_section(const E2kLine& line) {
    const std::string& name = line.words[1];
    if (!line.after("SHAPE")) {  // modifiers stand on a line of their own
      bool read = false;
      for (const auto& [key, of] : {std::pair("AMOD", &E2kProperties::area), std::pair("I3MOD", &E2kProperties::major),
                                    std::pair("I2MOD", &E2kProperties::minor)}) {
        if (!line.after(key)) continue;
        const double factor = positive(line, key);
        if (const auto found = sections_.find(name); found != sections_.end()) found->second.properties.*of *= factor;
        read = true;
      }
      return read;
    }
    E2kSection section{.material = line.after("MATERIAL").value_or(""), .properties = {}, .line = line.number};
    const std::string shape = *line.after("SHAPE");
    std::optional<E2kProperties> properties;
    if (const auto given = frame_.sections.find(name); given != frame_.sections.end()) {
      properties = given->second;
    } else {
      properties = properties_of(shape, line);
    }
    if (!properties) unread(line, "sections known by their names alone, none of this frame");
    section.properties = properties.value_or(E2kProperties{});
    sections_[name] = section;
    return true;
  }

  /// By its sides, or as they are given; nothing where the line has a name alone.
  std::optional<E2kProperties> properties_of(const std::string& shape, const E2kLine& line) {
    const auto side = [&](const char* key) { return positive(line, key); };
    const auto of_box = [](double depth, double width) {
      return E2kProperties{depth * width, width * std::pow(depth, 3) / 12, depth * std::pow(width, 3) / 12};
    };
    const auto less = [](const E2kProperties& outer, const E2kProperties& hole) {
      return E2kProperties{outer.area - hole.area, outer.major - hole.major, outer.minor - hole.minor};
    };
    const auto of_circle = [](double depth) {
      const double radius = depth / 2, inertia = std::numbers::pi / 4 * std::pow(radius, 4);
      return E2kProperties{std::numbers::pi * radius * radius, inertia, inertia};
    };
    if (line.after("AREA") && line.after("I33")) {
      return E2kProperties{side("AREA"), side("I33"), line.after("I22") ? side("I22") : 0};
    }
    if (shape == "Concrete Rectangular" || shape == "Rectangular") return of_box(side("D"), side("B"));
    if (shape == "Concrete Circle" || shape == "Steel Rod") return of_circle(side("D"));
    if (shape == "Steel I/Wide Flange" && line.after("TW")) {
      const double depth = side("D"), width = side("B"), web = side("TW"), between = depth - 2 * side("TF");
      E2kProperties found = less(of_box(depth, width), of_box(between, width - web));
      found.minor = ((depth - between) * std::pow(width, 3) + between * std::pow(web, 3)) / 12;
      return found;
    }
    if (shape == "Steel Tube" && line.after("TW")) {
      const double depth = side("D"), width = side("B");
      return less(of_box(depth, width), of_box(depth - 2 * side("TF"), width - 2 * side("TW")));
    }
    if (shape == "Steel Pipe" && line.after("T")) {
      const double depth = side("D");
      return less(of_circle(depth), of_circle(depth - 2 * side("T")));
    }
    return std::nullopt;
  }

  /// Where a point stands along the frame, and across it.
  [[nodiscard]] std::optional<std::pair<double, double>> place(const std::string& point) const {
    const auto found = points_.find(point);
    if (found == points_.end()) return std::nullopt;
    const auto [x, y] = found->second;
    return frame_.along_x ? std::pair(x, y) : std::pair(y, x);
  }

  [[nodiscard]] static bool alike(double a, double b) {
    return std::abs(a - b) <= 1e-6 * (1 + std::abs(a) + std::abs(b));
  }

  /// The frames there are, by where they stand.
  [[nodiscard]] std::vector<double> frames() const {
    std::vector<double> found;
    for (const auto& [name, column] : columns_) {
      const auto at = place(column.from);
      if (at && std::none_of(found.begin(), found.end(), [&](double one) { return alike(one, at->second); })) {
        found.push_back(at->second);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  /// What a section of a library is still needed for, once for each.
  void ask(const E2kSection& section, const std::string& name, const char* what) {
    if (!asked_.insert(name).second) return;
    error(section.line,
          fmt::format("section {} is known by its name alone: give --section {}={}", in_quotes(name), name, what));
  }

  /// Whether a column bends about axis 2 in this frame; an error where no axis lies across it.
  std::optional<bool> bends_about_minor(const std::string& line, const E2kAssignment& as, bool is_column) {
    const double quarters = as.angle / 90, nearest = std::round(quarters);
    const bool is_turned = std::fmod(nearest, 2) != 0;
    if (std::abs(quarters - nearest) > 1e-9 || (!is_column && is_turned)) {
      error(as.line, fmt::format("ANG = {}, must leave axis 3 of line {} across the frame, or of a column axis 2",
                                 as.angle, in_quotes(line)));
      return std::nullopt;
    }
    return is_column && is_turned == frame_.along_x;
  }

  void add(const std::string& line, const std::string& story, bool is_column, MemberSum& sum) {
    const auto assigned = assigned_.find({line, story});
    if (assigned == assigned_.end()) return;
    const E2kAssignment& as = assigned->second;
    const std::string& name = as.section;
    const auto section = sections_.find(name);
    if (section == sections_.end()) {
      return error(as.line, fmt::format("section {} of line {} was not read", in_quotes(name), in_quotes(line)));
    }
    if (as.released) {
      return error(as.line, fmt::format("line {} is released at its ends (RELEASE), a frame here is rigid at its nodes",
                                        in_quotes(line)));
    }
    const std::optional<bool> about_minor = bends_about_minor(line, as, is_column);
    if (!about_minor) return;
    const E2kProperties& properties = section->second.properties;
    if (!(properties.area > 0) || (*about_minor && !(properties.minor > 0))) {
      return ask(section->second, name, *about_minor ? "AREA,I33,I22" : "AREA,I33");
    }
    const auto material = materials_.find(section->second.material);
    if (material == materials_.end() || !(material->second.modulus > 0)) {
      return error(section->second.line, fmt::format("material {} of section {} has no E",
                                                     in_quotes(section->second.material), in_quotes(name)));
    }
    const double area = properties.area * as.factors.area;
    const double inertia = *about_minor ? properties.minor * as.factors.minor : properties.major * as.factors.major;
    sum.area += area;
    sum.stiffness += inertia * material->second.modulus;
    sum.weight += area * material->second.weight;
    ++sum.count;
    sum.sections.insert(name);
    if (modulus_ == 0) modulus_ = material->second.modulus;
  }

  /// As a table of a case; what is a mean is said.
  std::string member(const MemberSum& sum, const std::string& what) {
    if (sum.sections.size() > 1) {
      result_.taken.push_back(
          fmt::format("{} are of sections {}: the mean of their areas and E·I", what, fmt::join(sum.sections, ", ")));
    }
    const double count = sum.count;
    return fmt::format("{{ area = {}, inertia = {}, unit_weight = {} }}", sum.area / count,
                       sum.stiffness / count / modulus_, sum.weight / sum.area);
  }

  std::optional<ImportedCase> made() {
    if (force_.empty()) error(1, "has no UNITS");
    if (stories_.empty()) error(1, "has no STORY with a HEIGHT");
    const std::vector<double> all = frames();
    const char* const across = frame_.along_x ? "y" : "x";
    std::optional<double> at = frame_.at;
    if (all.empty()) {
      error(1, "has no columns");
    } else if (!at && all.size() > 1) {
      error(1, fmt::format("frames stand at {} = {}: say which with --at", across, fmt::join(all, ", ")));
    } else if (at && std::none_of(all.begin(), all.end(), [&](double one) { return alike(one, *at); })) {
      error(1, fmt::format("no frame stands at {} = {}, there are {}", across, *at, fmt::join(all, ", ")));
    }
    if (!diagnostics_.ok()) return std::nullopt;
    if (!at) at = all.front();
    std::vector<std::pair<double, std::string>> lines;  // place and name of each column line of the frame
    for (const auto& [name, column] : columns_) {
      const auto foot = place(column.from);
      if (foot && alike(foot->second, *at)) lines.emplace_back(foot->first, name);
    }
    std::sort(lines.begin(), lines.end());
    std::vector<double> places;
    for (const auto& one : lines) {
      if (places.empty() || !alike(places.back(), one.first)) places.push_back(one.first);
    }
    if (places.size() < 2) error(1, fmt::format("the frame at {} = {} has no bay", across, *at));
    std::vector<std::string> columns, beams, heights, bays;
    for (auto story = stories_.rbegin(); story != stories_.rend(); ++story) {
      MemberSum of_columns, of_beams;
      for (const auto& one : lines) add(one.second, story->name, true, of_columns);
      for (const auto& [name, beam] : beams_) {
        const auto from = place(beam.from), to = place(beam.to);
        if (from && to && alike(from->second, *at) && alike(to->second, *at)) add(name, story->name, false, of_beams);
      }
      const auto expect = [&](const MemberSum& sum, std::size_t count, const char* what) {
        if (sum.count == static_cast<int>(count) || !diagnostics_.ok()) return;
        error(1, fmt::format("the frame at {} = {} has {} {} in storey {}, expected {}", across, *at, sum.count, what,
                             in_quotes(story->name), count));
      };
      expect(of_columns, places.size(), "columns");
      expect(of_beams, places.size() - 1, "beams");
      if (!diagnostics_.ok()) continue;
      heights.push_back(fmt::format("{}", story->height));
      columns.push_back(member(of_columns, fmt::format("columns of storey {}", in_quotes(story->name))));
      beams.push_back(member(of_beams, fmt::format("beams of storey {}", in_quotes(story->name))));
    }
    if (!diagnostics_.ok()) return std::nullopt;
    for (std::size_t i = 1; i < places.size(); ++i) bays.push_back(fmt::format("{}", places[i] - places[i - 1]));
    result_.text = fmt::format(
        "# Made by bentur import: the frame at {} = {}. To be completed: damping, the mass of floors, neighbour,\n"
        "# [[gap]], [excitation]. Weights below are those of the members alone.\n\n"
        "[units]\nlength = \"{}\"\nforce = \"{}\"\n\n"
        "[[building]]\nname = \"Imported\"\n# damping = 0.05\n\n"
        "[building.frame]\nelastic_modulus = {}\nstorey_heights = [{}]\nbay_widths = [{}]\n"
        "columns = [\n  {},\n]\nbeams = [\n  {},\n]\n# floor_load = {{ pressure = 5.0, width = 6.0 }}\n",
        across, *at, length_, force_, modulus_, fmt::join(heights, ", "), fmt::join(bays, ", "),
        fmt::join(columns, ",\n  "), fmt::join(beams, ",\n  "));
    return std::move(result_);
  }

  const std::string& name_;
  const E2kFrame& frame_;
  Diagnostics& diagnostics_;
  std::string section_, force_, length_;
  std::vector<E2kStory> stories_;  // from the top
  std::map<std::string, E2kMaterial> materials_;
  std::map<std::string, E2kSection> sections_;
  std::map<std::string, std::pair<double, double>> points_;
  std::map<std::string, E2kMember> columns_, beams_;
  std::map<std::pair<std::string, std::string>, E2kAssignment> assigned_;  // by line and story
  double modulus_ = 0;
  std::set<std::string> asked_;  // sections of which nothing is known
  ImportedCase result_;
};

}  // namespace

std::optional<ImportedCase> read_e2k(const std::string& text, const std::string& name, const E2kFrame& frame,
                                     Diagnostics& diagnostics) {
  return E2kReader(name, frame, diagnostics).read(text);
}

}  // namespace bentur
