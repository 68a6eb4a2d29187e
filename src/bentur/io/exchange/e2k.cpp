#include "bentur/io/exchange/e2k.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

#include "bentur/io/exchange/internal/e2k_text.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

/// Area, EI and weight per length of the members of one storey or floor, summed.
struct MemberSum {
  double area = 0, stiffness = 0, weight = 0;
  int count = 0;
  std::set<std::string> sections;
  std::set<double> masses;  ///< by which masses are multiplied, where not by 1
};

/// A frame of a model.
class E2kFrameMaker {
 public:
  E2kFrameMaker(const std::string& name, const E2kFrame& frame, E2kModel model, Diagnostics& diagnostics)
      : name_(name), frame_(frame), model_(std::move(model)), diagnostics_(diagnostics) {
    result_.unread = std::move(model_.unread);
  }

  std::optional<ImportedCase> made() {
    if (model_.force.empty()) error(1, "has no UNITS");
    if (model_.stories.empty()) error(1, "has no STORY with a HEIGHT");
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
    for (const auto& [name, column] : model_.columns) {
      const auto foot = place(column.from);
      if (foot && alike(foot->second, *at)) lines.emplace_back(foot->first, name);
    }
    std::sort(lines.begin(), lines.end());
    std::vector<double> places;
    for (const auto& one : lines) {
      if (places.empty() || !alike(places.back(), one.first)) places.push_back(one.first);
    }
    if (places.size() < 2) error(1, fmt::format("the frame at {} = {} has no bay", across, *at));
    const std::string masses = take_joints(lines);
    std::vector<std::string> columns, beams, heights, bays;
    for (auto story = model_.stories.rbegin(); story != model_.stories.rend(); ++story) {
      MemberSum of_columns, of_beams;
      for (const auto& one : lines) add(one.second, story->name, true, of_columns);
      for (const auto& [name, beam] : model_.beams) {
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
        "columns = [\n  {},\n]\nbeams = [\n  {},\n]\n{}# floor_load = {{ pressure = 5.0, width = 6.0 }}\n",
        across, *at, model_.length, model_.force, modulus_, fmt::join(heights, ", "), fmt::join(bays, ", "),
        fmt::join(columns, ",\n  "), fmt::join(beams, ",\n  "), masses);
    return std::move(result_);
  }

 private:
  void error(int line, const std::string& message) { diagnostics_.error({name_, line, 1}, message); }

  /// Where a point stands along the frame, and across it.
  [[nodiscard]] std::optional<std::pair<double, double>> place(const std::string& point) const {
    const auto found = model_.points.find(point);
    if (found == model_.points.end()) return std::nullopt;
    const auto [x, y] = found->second;
    return frame_.along_x ? std::pair(x, y) : std::pair(y, x);
  }

  [[nodiscard]] static bool alike(double a, double b) {
    return std::abs(a - b) <= 1e-6 * (1 + std::abs(a) + std::abs(b));
  }

  /// The frames there are, by where they stand.
  [[nodiscard]] std::vector<double> frames() const {
    std::vector<double> found;
    for (const auto& [name, column] : model_.columns) {
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
    const std::string known = section.shape.empty()
                                  ? "is known by its name alone"
                                  : fmt::format("has the shape {}, which is not known here", in_quotes(section.shape));
    error(section.line, fmt::format("section {} {}: give --section {}={}", in_quotes(name), known, name, what));
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

  /// Whether an end of a member lets go of what bends or pushes it in the frame.
  [[nodiscard]] static bool is_released(const std::string& releases, bool about_minor) {
    for (const char* const end : {"I", "J"}) {
      for (const char* const one : {"P", about_minor ? "M2" : "M3", about_minor ? "V3" : "V2"}) {
        std::istringstream words(releases);
        for (std::string word; words >> word;) {
          if (word == std::string(one) + end) return true;
        }
      }
    }
    return releases.find("PINNED") != std::string::npos;
  }

  void add(const std::string& line, const std::string& story, bool is_column, MemberSum& sum) {
    const auto assigned = model_.assigned.find({line, story});
    if (assigned == model_.assigned.end()) return;
    const E2kAssignment& as = assigned->second;
    const std::string& name = as.section;
    const auto section = model_.sections.find(name);
    if (section == model_.sections.end()) {
      return error(as.line, fmt::format("section {} of line {} was not read", in_quotes(name), in_quotes(line)));
    }
    const std::optional<bool> about_minor = bends_about_minor(line, as, is_column);
    if (!about_minor) return;
    if (is_released(as.releases, *about_minor)) {
      return error(as.line,
                   fmt::format("line {} is released at its ends (RELEASE {}), a frame here is rigid at its nodes",
                               in_quotes(line), in_quotes(as.releases)));
    }
    const E2kProperties& properties = section->second.properties;
    if (!(properties.area > 0) || (*about_minor && !(properties.minor > 0))) {
      return ask(section->second, name, *about_minor ? "AREA,I33,I22" : "AREA,I33");
    }
    const auto material = model_.materials.find(section->second.material);
    if (material == model_.materials.end() || !(material->second.modulus > 0)) {
      return error(section->second.line, fmt::format("material {} of section {} has no E",
                                                     in_quotes(section->second.material), in_quotes(name)));
    }
    const double area = properties.area * as.factors.area;
    const double inertia = *about_minor ? properties.minor * as.factors.minor : properties.major * as.factors.major;
    sum.area += area;
    sum.stiffness += inertia * material->second.modulus;
    const double mass = as.mass * section->second.mass;
    sum.weight += area * material->second.weight * mass;
    if (mass != 1) sum.masses.insert(mass);
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
    if (!sum.masses.empty()) {
      result_.taken.push_back(
          fmt::format("the mass of {} times {}, as their modifiers say", what, fmt::join(sum.masses, ", ")));
    }
    const double count = sum.count;
    return fmt::format("{{ area = {}, inertia = {}, unit_weight = {} }}", sum.area / count,
                       sum.stiffness / count / modulus_, sum.weight / sum.area);
  }

  /// What a joint of the frame is given beside its place. Restraints that hold all columns at their feet are taken, as
  /// are masses; whatever else holds a joint or gives way is an error. @param mass where a mass is added
  void take_joint(const E2kJoint& joint, bool is_foot, double* mass) {
    const char* const along = frame_.along_x ? "UX" : "UY";
    for (std::size_t i = 3; i < joint.line.words.size(); i += 2) {
      const std::string& key = joint.line.words[i];
      const std::string value = i + 1 < joint.line.words.size() ? joint.line.words[i + 1] : "";
      const std::string where = fmt::format("point {} at {}", in_quotes(joint.point), in_quotes(joint.story));
      if (key == "RESTRAINT") {
        const auto holds = [&](const char* one) {
          return (" " + value + " ").find(" " + std::string(one) + " ") != std::string::npos;
        };
        std::string open;
        for (const char* const one : {along, "UZ", frame_.along_x ? "RY" : "RX"}) {
          if (!holds(one)) open += (open.empty() ? "" : ", ") + std::string(one);
        }
        if (is_foot && !open.empty()) {
          error(joint.line.number, fmt::format("RESTRAINT of {} leaves {} free: columns of a frame here are fixed at "
                                               "their feet, and one that is not moves more",
                                               where, open));
        } else if (!is_foot && (holds(along) || holds("UZ") || holds(frame_.along_x ? "RY" : "RX"))) {
          error(joint.line.number, fmt::format("RESTRAINT of {} holds a joint above the base", where));
        }
        if (is_foot) restrained_.insert(joint.point);
      } else if (key == "MASSUXUY" || key == "MASS" + std::string(along)) {
        const double given = e2k_number(value).value_or(-1);
        if (given < 0) {
          error(joint.line.number, fmt::format("{} = {}, must be a number >= 0", key, in_quotes(value)));
        } else if (mass != nullptr) {
          *mass += given;
        } else {
          add_unread(joint.line.number, "masses at the base, which do not sway", result_.unread);
        }
      } else if (key.rfind("MASS", 0) == 0 || key == "PANELZONE" || value == "DISCONNECTED") {
        add_unread(joint.line.number, fmt::format("{} of POINT ASSIGNS", key), result_.unread);
      } else if (key != "DIAPH" && key != "DIAPHRAGM" && key != "USERJOINT") {
        error(joint.line.number,
              fmt::format("{} of {} is not read, and may change what holds the frame: take it out of the text where it "
                          "does not",
                          key, where));
      }
    }
  }

  /// Supports and masses of the joints of a frame. @return its floor masses as a line of a case; empty: none
  std::string take_joints(const std::vector<std::pair<double, std::string>>& lines) {
    std::set<std::string> points, feet;
    for (const auto& one : lines) {
      const E2kMember& column = model_.columns.at(one.second);
      points.insert({column.from, column.to});
      feet.insert(column.from);
    }
    std::vector<double> masses(model_.stories.size(), 0);  // bottom to top
    const bool any_restraint = std::any_of(model_.joints.begin(), model_.joints.end(), [](const E2kJoint& joint) {
      return joint.line.after("RESTRAINT").has_value();
    });
    for (const E2kJoint& joint : model_.joints) {
      if (points.count(joint.point) == 0) continue;
      const auto story = std::find_if(model_.stories.rbegin(), model_.stories.rend(),
                                      [&](const E2kStory& one) { return one.name == joint.story; });
      const bool is_foot = story == model_.stories.rend();
      take_joint(joint, is_foot,
                 is_foot ? nullptr : &masses[static_cast<std::size_t>(story - model_.stories.rbegin())]);
    }
    if (!any_restraint) {
      result_.taken.push_back("no joint has a RESTRAINT: columns are taken to be fixed at their feet");
    }
    for (const std::string& foot : feet) {
      if (any_restraint && restrained_.count(foot) == 0) {
        error(1, fmt::format("point {} at the foot of a column has no RESTRAINT at the base, as others have",
                             in_quotes(foot)));
      }
    }
    const bool has_mass = std::any_of(masses.begin(), masses.end(), [](double mass) { return mass != 0; });
    if (!has_mass) return "";
    result_.taken.push_back("masses at joints of the frame are its floor_masses");
    return fmt::format("floor_masses = [{}]   # of the joints of this frame\n", fmt::join(masses, ", "));
  }

  const std::string& name_;
  const E2kFrame& frame_;
  E2kModel model_;
  Diagnostics& diagnostics_;
  double modulus_ = 0;
  std::set<std::string> asked_;       // sections of which nothing is known
  std::set<std::string> restrained_;  // points at feet of columns
  ImportedCase result_;
};

}  // namespace

std::optional<ImportedCase> read_e2k(const std::string& text, const std::string& name, const E2kFrame& frame,
                                     Diagnostics& diagnostics) {
  E2kModel model = read_e2k_text(text, name, frame, diagnostics);
  if (!diagnostics.ok()) return std::nullopt;
  return E2kFrameMaker(name, frame, std::move(model), diagnostics).made();
}

}  // namespace bentur
