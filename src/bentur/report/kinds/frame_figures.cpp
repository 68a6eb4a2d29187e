#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/free_place.h"
#include "bentur/report/kinds/internal/hinge_marks.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/scene.h"

namespace bentur {
namespace {

/// One of the three that members carry, along each member: at MemberForces::stations, or the same from end to end.
struct Carried {
  const char *form = "", *symbol = "";  ///< of its unit; what it is called in short
  bool is_moment = false, is_axial = false;
  const char* largest = "";  ///< "largest moment {}, {}"

  [[nodiscard]] std::vector<double> of(const FrameForces::Forces& forces, Eigen::Index member) const {
    if (!is_moment) return std::vector(2, (is_axial ? forces.axial : forces.shears)(member));
    const auto column = forces.moments.col(member);
    return {column.begin(), column.end()};
  }
  [[nodiscard]] std::vector<double> stations() const {
    if (!is_moment) return {0, 1};
    return {std::begin(MemberForces::stations), std::end(MemberForces::stations)};
  }
};

/// Where the largest of all is.
struct LargestForce {
  double value = 0;  ///< signed
  Eigen::Index member = -1;
  std::size_t station = 0;

  void take(const Carried& carried, const FrameForces& frame, const FrameForces::Forces& forces) {
    for (Eigen::Index n = 0; n < std::ssize(frame.members); ++n) {
      const std::vector<double> values = carried.of(forces, n);
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (!(std::abs(values[k]) > std::abs(value) * (1 + 1e-9))) continue;  // of those that are alike the first
        value = values[k];
        member = n;
        station = k;
      }
    }
  }
};

/// Those of all that are as large as it, but for round-off, itself among them; of a symmetrical frame there are more.
std::vector<LargestForce> alike_to(const LargestForce& largest, const Carried& carried, const FrameForces& frame,
                                   const std::vector<const FrameForces::Forces*>& among) {
  std::vector<LargestForce> found;
  for (const FrameForces::Forces* const forces : among) {
    for (Eigen::Index n = 0; n < std::ssize(frame.members); ++n) {
      const std::vector<double> values = carried.of(*forces, n);
      for (std::size_t k = 0; k < (carried.is_moment ? values.size() : 1); ++k) {
        const bool is_alike = std::abs(values[k]) > std::abs(largest.value) * (1 - 1e-6);
        if (is_alike) found.push_back({values[k], n, k});
      }
    }
  }
  return found;
}

/// Places of a diagram on its frame: columns to the right, beams downwards, by `scale` [length per unit].
class Diagram {
 public:
  Diagram(const Carried& carried, const FrameForces& frame, double scale)
      : carried_(&carried), frame_(&frame), scale_(scale) {}

  [[nodiscard]] std::pair<double, double> at(Eigen::Index member, double station, double value) const {
    const FrameMember& of = frame_->members[member];
    const double along = of.from + station * of.length();
    return of.of_beam ? std::pair(along, of.place - scale_ * value) : std::pair(of.place + scale_ * value, along);
  }
  /// Around the area between the members and the values, or hatches so far apart across it.
  [[nodiscard]] Curve outline(const FrameForces::Forces& forces, Curve style, double apart = 0) const {
    const std::vector<double> stations = carried_->stations();
    for (Eigen::Index n = 0; n < std::ssize(frame_->members); ++n) {
      const std::vector<double> values = carried_->of(forces, n);
      if (std::isnan(values.front())) continue;
      const auto add = [&](double station, double value) {
        const auto [x, y] = at(n, station, value);
        style.x.push_back(x);
        style.y.push_back(y);
      };
      const auto stop = [&] { style.x.push_back(not_known), style.y.push_back(not_known); };
      if (apart > 0) {
        const int hatches = std::max(2, static_cast<int>(std::lround(frame_->members[n].length() / apart)));
        for (int k = 1; k < hatches; ++k) {
          const double station = static_cast<double>(k) / hatches;
          add(station, 0);
          add(station, values.front() + station * (values.back() - values.front()));
          stop();
        }
      } else {
        add(0, 0);
        for (std::size_t k = 0; k < values.size(); ++k) add(stations[k], values[k]);
        add(1, 0);
        stop();
      }
    }
    return style;
  }

 private:
  const Carried* carried_;
  const FrameForces* frame_;
  double scale_;
};

/// What a round number is drawn as, below the frame: the largest that some force drawn to this scale reaches.
/// @param scale [length per unit shown] @param most the largest of these forces, as it is shown
void add_scale(Panel& panel, double scale, double most, double one_cm, const std::string& unit, double level) {
  if (!(scale > 0)) return;
  const double value = at_most_125(most);
  const double length = scale * value, cap = 0.1 * one_cm;
  panel.curves.push_back({.x = {0, 0, not_known, 0, length, not_known, length, length},
                          .y = {level - cap, level + cap, not_known, level, level, not_known, level - cap, level + cap},
                          .width = 0.9,
                          .complete = true});
  panel.texts.push_back({.x = length, .y = level, .text = number(value) + " " + unit});
}

/// How far the members of a frame reach from its lower left corner [length].
struct Extent {
  double right = 0, top = 0;
};
Extent extent_of(const FrameForces& frame) {
  Extent extent;
  for (const FrameMember& member : frame.members) {
    extent.right = std::max(extent.right, member.of_beam ? member.to : member.place);
    extent.top = std::max(extent.top, member.of_beam ? member.place : member.to);
  }
  return extent;
}

/// "bottom of the column of line 2, storey 1", of shears and axial forces "column of line 2, storey 1".
std::string member_text(const FigureOptions& options, const Carried& carried, const FrameForces& frame,
                        const LargestForce& largest) {
  const FrameMember& member = frame.members[largest.member];
  const std::string number = std::to_string(member.number), level = std::to_string(member.level);
  if (!carried.is_moment) {
    return member.of_beam ? word(options, "beam of bay {}, floor {}", number, level)
                          : word(options, "column of line {}, storey {}", number, level);
  }
  const bool second = largest.station > 0;
  using End = HingePlace::End;
  End end = member.of_beam ? (second ? End::right : End::left) : (second ? End::top : End::bottom);
  const auto continues = [&](const FrameMember& other) {  // another piece of the same column
    return !other.of_beam && other.level == member.level && other.number == member.number &&
           (second ? other.from == member.to : other.to == member.from);
  };
  if (!member.of_beam && std::any_of(frame.members.begin(), frame.members.end(), continues)) end = End::node;
  return hinge_name(options.say, {member.of_beam, member.level, member.number, end});
}

/// What the panels of a column show of each frame: one of the three at the instant, or the largest of the run.
struct Shown {
  Carried carried = {};
  bool at_instant = false;

  /// What is drawn of a frame; without contact where there is any.
  [[nodiscard]] std::vector<const FrameForces::Forces*> of(const FrameForces& frame, bool touches) const {
    if (at_instant) return touches ? std::vector{&frame.instant} : std::vector<const FrameForces::Forces*>{};
    if (touches) return {&frame.most, &frame.least};
    return {&frame.most_without_contact, &frame.least_without_contact};
  }
};

/// A frame and the forces that a diagram of it has to show.
struct Drawn {
  const FrameForces* frame = nullptr;
  LargestForce largest = {}, alone = {};  ///< with contact and without
  double in_columns = 0, in_beams = 0;    ///< largest of both, as sizes
  double scale = 0;                       ///< of its forces [length per unit]
  bool is_of_own_scale = false;

  [[nodiscard]] double most() const { return std::max(in_columns, in_beams); }
  /// How wide and how high it is with its diagrams, and a little beyond [length].
  [[nodiscard]] double wide() const { return extent_of(*frame).right + 2.2 * scale * in_columns; }
  [[nodiscard]] double high() const { return extent_of(*frame).top + 1.1 * scale * in_beams; }
};

/// To a scale at which diagrams of neighbouring columns, and of beams one above another, do not meet.
Drawn drawn_of(const RunResults& run, const Shown& shown, const FrameForces& frame) {
  const StructuralModel& model = run.problem.buildings[frame.building].model;
  double bay = INFINITY, storey = INFINITY;  // the shortest
  for (const FrameMember& member : frame.members) {
    if (member.of_beam) bay = std::min(bay, member.length());
  }
  for (Eigen::Index f = model.first_storey(); f < model.floors(); ++f) {
    storey = std::min(storey, model.storey_heights[f]);
  }
  bay = std::min(bay, 2 * extent_of(frame).top);
  Drawn drawn{.frame = &frame};
  for (const bool touches : {true, false}) {
    if (!touches && run.response.impacts.empty()) continue;
    for (const FrameForces::Forces* const forces : shown.of(frame, touches)) {
      (touches ? drawn.largest : drawn.alone).take(shown.carried, frame, *forces);
      for (Eigen::Index n = 0; n < std::ssize(frame.members); ++n) {
        double& most = frame.members[n].of_beam ? drawn.in_beams : drawn.in_columns;
        for (const double value : shown.carried.of(*forces, n)) most = std::fmax(most, std::abs(value));
      }
    }
  }
  constexpr double part = 0.45, least = 0.04;  // of a bay or storey; of the height of a tall frame, so that it is seen
  const double high = least * extent_of(frame).top;
  const auto of_room = [&](double room, double most) {
    return most > 0 ? std::max(part * room, high) / most : INFINITY;
  };
  drawn.scale = std::min(of_room(bay, drawn.in_columns), of_room(storey, drawn.in_beams));
  if (!(drawn.most() > 0)) drawn.scale = 0;
  return drawn;
}

/// All frames have one scale, so that they can be compared; but what would be too small to be read has its own.
/// @returns the largest force
double choose_scales(std::vector<Drawn>& drawn) {
  constexpr double too_small = 0.1;  // of the largest
  double most = 0, scale = INFINITY;
  for (const Drawn& one : drawn) most = std::max(most, one.most());
  for (Drawn& one : drawn) {
    if (!(one.most() > 0)) continue;
    one.is_of_own_scale = one.most() < too_small * most;
    if (!one.is_of_own_scale) scale = std::min(scale, one.scale);
  }
  for (Drawn& one : drawn) {
    if (one.most() > 0 && !one.is_of_own_scale) one.scale = scale;
  }
  return most;
}

std::vector<const FrameForces*> frames_shown(const RunResults& run, const FigureOptions& options) {
  const std::vector<Eigen::Index> shown = shown_buildings(run, options);
  std::vector<const FrameForces*> frames;
  for (const FrameForces& one : run.figures.frames) {
    if (std::find(shown.begin(), shown.end(), one.building) != shown.end()) frames.push_back(&one);
  }
  if (frames.empty()) {
    throw NoFigure(
        "nothing is known of members of a frame: \"bentur run --figures\" adds that of building.frame and of planes "
        "that are frames");
  }
  return frames;
}

/// The lines of the members themselves.
Curve members_of(const Diagram& diagram, const FrameForces& frame, Tone tone) {
  Curve members{.tone = tone, .width = 1.2, .complete = true};
  for (Eigen::Index n = 0; n < std::ssize(frame.members); ++n) {
    for (const double station : {0.0, 1.0}) {
      const auto [x, y] = diagram.at(n, station, 0);
      members.x.push_back(x);
      members.y.push_back(y);
    }
    members.x.push_back(not_known);
    members.y.push_back(not_known);
  }
  return members;
}

/// Writes the largest value beside its dot, of several that are alike where there is most room.
void name_largest(Panel& panel, const Diagram& diagram, const Carried& carried, const FrameForces& frame,
                  const LargestForce& force, const std::vector<const FrameForces::Forces*>& among,
                  const std::string& text, double one_cm) {
  if (force.member < 0) return;
  std::optional<Panel> best;
  double nearest = INFINITY;
  for (const LargestForce& alike : alike_to(force, carried, frame, among)) {
    for (const double station :
         carried.is_moment ? std::vector{carried.stations()[alike.station]}
                           : std::vector{0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9}) {  // it is alike along the member
      const auto [x, y] = diagram.at(alike.member, station, alike.value);
      Panel here = panel;
      here.curves.push_back({.x = {x}, .y = {y}, .line = Line::none, .mark = Mark::disc, .complete = true});
      const double far = add_beside(here, x, y, text, one_cm);
      if (far > nearest - 0.02 * one_cm) continue;
      nearest = far;
      best = std::move(here);
    }
  }
  panel = std::move(*best);
}

/// A row for each frame, a column for what is shown of it; on a telephone two columns at most.
Figure frame_figure(const RunResults& run, const FigureOptions& options, const std::string& title,
                    const std::vector<Shown>& columns) {
  const std::vector<const FrameForces*> frames = frames_shown(run, options);
  const bool are_slender = std::all_of(frames.begin(), frames.end(), [](const FrameForces* one) {
    return extent_of(*one).top > 1.2 * extent_of(*one).right;  // so that two stand side by side on a telephone
  });
  const bool are_three = columns.size() > 2;
  const std::size_t beside = !options.narrow ? columns.size() : are_slender || are_three ? 2 : 1;
  Figure figure{.title = title,
                .columns = static_cast<int>(beside),
                .width = options.narrow ? options.width : broad(options.width),
                .shared_legend = are_three};
  const bool has_impacts = !run.response.impacts.empty();
  const bool leaves_room = columns.size() % beside > 0;
  // Of rows so high that frames over the width of a panel can be read; two of them leave room for others on a page.
  const double above = leaves_room ? 1.0 : 0.8;  // title of a row and what is free between two [cm]
  const double highest = are_three ? 6.9 : 7.8, of_legend = are_three ? 0.5 : 0;  // [cm]
  const std::size_t rows = frames.size() * ((columns.size() + beside - 1) / beside);
  const double room = are_three && !options.narrow ? 15.6 : page_height;  // two thirds of a page [cm]
  const double height = std::min(highest, (room - of_legend) / static_cast<double>(rows) - above);
  constexpr double between = 0.8;  // of the panels of a row, and beside them [cm]
  const double width = figure.width / figure.columns - between;
  constexpr double below = 1.1;           // the frame, a number and a bar [cm]
  std::vector<std::vector<Drawn>> drawn;  // of each column
  std::vector<double> most;               // forces
  double high = 0, one_cm = 0;            // [length]
  for (const Shown& shown : columns) {
    std::vector<Drawn>& all = drawn.emplace_back();
    for (const FrameForces* frame : frames) all.push_back(drawn_of(run, shown, *frame));
    most.push_back(choose_scales(all));
    for (const Drawn& one : all) {
      high = std::max(high, one.high());
      one_cm = std::max({one_cm, one.high() / (height - below), one.wide() / width});
    }
  }
  const double low = -below * one_cm, bar = -0.85 * one_cm;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const FrameForces& frame = *frames[f];
    const Building& building = run.problem.buildings[frame.building];
    const auto [right, top] = extent_of(frame);
    double highest_of_row = top;
    for (const std::vector<Drawn>& all : drawn) highest_of_row = std::max(highest_of_row, all[f].high());
    std::string finding;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const Shown& shown = columns[c];
      const Carried& carried = shown.carried;
      const Drawn& one = drawn[c][f];
      const double factor = shown_factor(run, carried.form);
      const std::string unit = shown_unit(run, carried.form);
      const Diagram diagram(carried, frame, one.scale);
      const double side = (one_cm * width - right) / 2;  // for numbers too
      Panel panel{.x = {.from = -side, .to = right + side, .numbers = false},
                  .y = {.from = low, .to = highest_of_row, .numbers = false},
                  .height = (highest_of_row - low) / one_cm,
                  .begins_row = c == 0 && leaves_room,
                  .to_scale = true};
      panel.title = building.name + ", " + with_unit(carried.symbol, unit);
      if (shown.at_instant) {
        panel.title += " " + word(options, "at {}", seconds_text(frame.time));
      } else if (!are_three) {
        panel.title = word(options, has_impacts ? "largest, with contact and (dashed) without" : "largest of the run");
      }
      if (one.is_of_own_scale) panel.title += ", " + word(options, "own scale");
      panel.curves.push_back(members_of(diagram, frame, tone_of(options, frame.building)));
      const auto first = std::find_if(drawn[c].begin(), drawn[c].end(),
                                      [](const Drawn& each) { return !each.is_of_own_scale && each.most() > 0; });
      if (one.is_of_own_scale || &one == &*first) {  // that of all others is said once
        const double largest = factor * (one.is_of_own_scale ? one.most() : most[c]);
        add_scale(panel, one.scale / factor, largest, one_cm, unit, bar);
      }
      const auto label = [&](const char* text, bool is_first) {  // in the legend
        const bool is_there = is_first && f == 0 && c == 0 && are_three && !shown.at_instant && has_impacts;
        return is_there ? word(options, text) : std::string();
      };
      if (shown.at_instant) {
        panel.curves.push_back(
            diagram.outline(frame.instant, {.width = 0.5, .complete = true}, 0.03 * std::max(top, right)));
      }
      const std::vector<const FrameForces::Forces*> with = shown.of(frame, true), without = shown.of(frame, false);
      for (std::size_t i = 0; i < without.size() && has_impacts; ++i) {
        panel.curves.push_back(diagram.outline(*without[i], {.label = label("without contact", i == 0),
                                                             .tone = Tone::grey,
                                                             .line = Line::dashed,
                                                             .width = 0.9,
                                                             .complete = true}));
      }
      for (std::size_t i = 0; i < with.size(); ++i) {
        panel.curves.push_back(
            diagram.outline(*with[i], {.label = label("with contact", i == 0), .width = 0.9, .complete = true}));
      }
      const LargestForce& largest = one.largest;
      const auto text_of = [&](double value) { return number(factor * std::abs(value)) + " " + unit; };
      name_largest(panel, diagram, carried, frame, largest, with, text_of(largest.value), one_cm);
      figure.panels.push_back(std::move(panel));
      if (largest.member < 0 || (shown.at_instant && columns.size() == 2)) continue;
      finding += (finding.empty() ? "" : ", ") +
                 word(options, carried.largest, text_of(largest.value), member_text(options, carried, frame, largest));
      if (has_impacts && !shown.at_instant) {
        finding += ", " + word(options, "without contact {}", text_of(one.alone.value));
      }
    }
    if (finding.empty()) continue;
    const std::string when =
        are_three && columns.front().at_instant ? " " + word(options, "at {}", seconds_text(frame.time)) : "";
    figure.finding += (figure.finding.empty() ? "" : "; ") + building.name + when + ": " + finding;
  }
  return figure;
}

constexpr Carried moment{.form = "F L", .symbol = "M", .is_moment = true, .largest = "largest moment {}, {}"};
constexpr Carried shear{.form = "F", .symbol = "V", .largest = "largest shear {}, {}"};
constexpr Carried axial{.form = "F", .symbol = "N", .is_axial = true, .largest = "largest axial force {}, {}"};

}  // namespace

Figure frame_forces_figure(const RunResults& run, const FigureOptions& options) {
  return frame_figure(run, options, "What members of frames carry at one instant",
                      {{moment, true}, {shear, true}, {axial, true}});
}

Figure frame_envelope_figure(const RunResults& run, const FigureOptions& options) {
  return frame_figure(run, options, "The largest that members of frames carry, both ways",
                      {{moment, false}, {shear, false}, {axial, false}});
}

Figure frame_moment_figure(const RunResults& run, const FigureOptions& options) {
  return frame_figure(run, options, "Moments in the members of frames, on the side in tension",
                      {{moment, true}, {moment, false}});
}

Figure frame_shear_figure(const RunResults& run, const FigureOptions& options) {
  return frame_figure(run, options, "Shears in the members of frames", {{shear, true}, {shear, false}});
}

Figure frame_axial_figure(const RunResults& run, const FigureOptions& options) {
  return frame_figure(run, options, "Axial forces in the columns of frames by the motion, compression to the right",
                      {{axial, true}, {axial, false}});
}

}  // namespace bentur
