#include "bentur/io/exchange/internal/e2k_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

#include "bentur/core/number_text.h"
#include "bentur/core/units.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

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

class E2kTextReader {
 public:
  E2kTextReader(const std::string& name, const E2kFrame& frame, Diagnostics& diagnostics)
      : name_(name), frame_(frame), diagnostics_(diagnostics) {}

  E2kModel read(const std::string& text) {
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
      if (one.words.empty()) continue;  // a form feed
      if (!take(one)) unread(one, section_.empty() ? one.words.front() : section_);
    }
    if (comma_line_ > 0 && point_line_ > 0) {
      error(comma_line_,
            fmt::format("has a decimal comma, line {} a decimal point: one or the other is a slip", point_line_));
    }
    return std::move(model_);
  }

 private:
  void error(int line, const std::string& message) { diagnostics_.error({name_, line, 1}, message); }

  void unread(const E2kLine& line, const std::string& what) { add_unread(line.number, what, model_.unread); }

  /// The number behind a key; an error where it is none.
  std::optional<double> number(const E2kLine& line, std::string_view key) {
    const auto text = line.after(key);
    return text ? number_in(line, std::string(key), *text) : std::nullopt;
  }

  std::optional<double> number_in(const E2kLine& line, const std::string& key, const std::string& text) {
    const auto value = e2k_number(text);
    if (!value) {
      error(line.number, fmt::format("{} = {}, must be a number", key, in_quotes(text)));
      return std::nullopt;
    }
    if (comma_line_ == 0 && text.find(',') != std::string::npos) comma_line_ = line.number;
    if (point_line_ == 0 && text.find('.') != std::string::npos) point_line_ = line.number;
    return value;
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
      model_.points[line.words[1]] = {x.value_or(0), y.value_or(0)};
      return line.words.size() == 4;
    }
    if (word == "LINE" && line.words.size() > 4) {
      const std::string& kind = line.words[2];
      if (kind != "COLUMN" && kind != "BEAM") {
        unread(line, fmt::format("{} of LINE CONNECTIVITIES", kind));
        return true;
      }
      (kind == "COLUMN" ? model_.columns : model_.beams)[line.words[1]] = {line.words[3], line.words[4]};
      return true;
    }
    if (word == "LINEASSIGN" && line.words.size() > 2) {
      return take_assignment(line);
    }
    if (word == "POINTASSIGN" && line.words.size() > 2) {
      model_.joints.push_back({line.words[1], line.words[2], line});
      return true;
    }
    return word == "PROGRAM" || word == "END" || word.rfind("TITLE", 0) == 0 || word == "GRID" || word == "GRIDSYSTEM";
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
    model_.force = unit(forces, force_units(), line.words[1]);
    model_.length = unit(lengths, length_units(), line.words[2]);
    return true;
  }

  bool take_story(const E2kLine& line) {
    const double height = line.after("HEIGHT") ? number(line, "HEIGHT").value_or(0) : 0;
    if (height > 0) {
      model_.stories.push_back({line.words[1], height});
    } else if (!line.after("ELEV") && height != 0) {
      error(line.number, fmt::format("HEIGHT = {}, must be > 0", height));
    }
    return true;
  }

  bool take_material(const E2kLine& line) {
    E2kMaterial& material = model_.materials[line.words[1]];
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
    made.releases = line.after("RELEASE").value_or("");
    made.mass = not_negative(line, "PROPMODM");
    model_.assigned[{line.words[1], line.words[2]}] = made;
    // What does nothing to the stiffness and the mass of a plane frame.
    static const std::set<std::string_view> harmless = {
        "SECTION",    "ANG",        "PROPMODA",    "PROPMODI22", "PROPMODI33", "PROPMODM", "PROPMODW",
        "PROPMODJ",   "PROPMODT",   "RELEASE",     "MINNUMSTA",  "MAXSTASPC",  "AUTOMESH", "MESHATINTERSECTIONS",
        "DESIGNTYPE", "TRANSSTIFF", "MESHATJOINTS"};
    std::string open;
    for (std::size_t i = 3; i < line.words.size(); i += 2) {
      if (harmless.count(line.words[i]) == 0) open += (open.empty() ? "" : ", ") + line.words[i];
    }
    if (!open.empty()) unread(line, open + " of LINE ASSIGNS");
    return true;
  }

  /// A factor of masses; 1 where the line has none.
  double not_negative(const E2kLine& line, std::string_view key) {
    const double value = number(line, key).value_or(1);
    if (value < 0) error(line.number, fmt::format("{} = {}, must be >= 0", key, value));
    return value;
  }

  bool take_section(const E2kLine& line) {
    const std::string& name = line.words[1];
    if (!line.after("SHAPE")) {  // modifiers stand on a line of their own
      bool read = line.after("MMOD").has_value();
      if (const auto found = model_.sections.find(name); found != model_.sections.end()) {
        found->second.mass *= not_negative(line, "MMOD");
      }
      for (const auto& [key, of] :
           {std::pair("AMOD", &E2kProperties::area), std::pair("I3MOD", &E2kProperties::major),
            std::pair("I2MOD", &E2kProperties::minor), std::pair("AMODIFIER", &E2kProperties::area),
            std::pair("I33MODIFIER", &E2kProperties::major), std::pair("I22MODIFIER", &E2kProperties::minor)}) {
        if (!line.after(key)) continue;
        const double factor = positive(line, key);
        if (const auto found = model_.sections.find(name); found != model_.sections.end())
          found->second.properties.*of *= factor;
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
    if (!properties && line.after("D")) {
      section.shape = shape;
      unread(line, fmt::format("section {} of shape {}, none of this frame", in_quotes(name), in_quotes(shape)));
    } else if (!properties) {
      unread(line, "sections known by their names alone, none of this frame");
    }
    section.properties = properties.value_or(E2kProperties{});
    model_.sections[name] = section;
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
    if ((shape == "Concrete Tee" || shape == "Tee" || shape == "Steel Tee") && line.after("TW")) {
      const double depth = side("D"), width = side("B"), flange = side("TF"), web = side("TW");
      if (!(flange < depth) || !(web <= width)) {
        error(line.number, fmt::format("TF = {}, TW = {}, must be less than D and B", flange, web));
      }
      const double of_flange = width * flange, stem = depth - flange, of_stem = stem * web;
      const double up = (of_stem * stem / 2 + of_flange * (stem + flange / 2)) / (of_stem + of_flange);
      const auto about = [&](double area, double b, double h, double centre) {
        return b * std::pow(h, 3) / 12 + area * std::pow(centre - up, 2);
      };
      return E2kProperties{of_stem + of_flange,
                           about(of_stem, web, stem, stem / 2) + about(of_flange, width, flange, stem + flange / 2),
                           (flange * std::pow(width, 3) + stem * std::pow(web, 3)) / 12};
    }
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

  const std::string& name_;
  const E2kFrame& frame_;
  Diagnostics& diagnostics_;
  std::string section_;
  int comma_line_ = 0, point_line_ = 0;  // the first with a decimal comma, a decimal point
  E2kModel model_;
};

}  // namespace

std::optional<double> e2k_number(const std::string& text) {
  std::string with_point = text;
  const std::size_t comma = with_point.find(',');
  if (comma != std::string::npos && text.find('.') == std::string::npos) with_point[comma] = '.';
  double value = 0;
  const char* const end = with_point.data() + with_point.size();
  const auto read = from_chars(with_point.data(), end, value);
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void add_unread(int line, const std::string& what, std::vector<UnreadLines>& unread) {
  if (!unread.empty() && unread.back().what == what && unread.back().last < line) {
    unread.back().last = line;
  } else {
    unread.push_back({line, line, what});
  }
}

E2kModel read_e2k_text(const std::string& text, const std::string& name, const E2kFrame& frame,
                       Diagnostics& diagnostics) {
  return E2kTextReader(name, frame, diagnostics).read(text);
}

}  // namespace bentur
