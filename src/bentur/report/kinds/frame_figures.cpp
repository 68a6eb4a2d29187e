#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/frame_diagram.h"
#include "bentur/report/kinds/internal/free_place.h"
#include "bentur/report/kinds/internal/hinge_marks.h"
#include "bentur/report/kinds/internal/largest_forces.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/scene.h"

namespace bentur {
namespace {

/// What a round number is drawn as, below the frame: the largest that some force drawn to this scale reaches.
/// @param scale [length per unit shown] @param most the largest of these forces, as it is shown
/// @param label of the bar in data
void add_scale(Panel& panel, double scale, double most, double one_cm, const std::string& unit, double level,
               const std::string& label) {
  if (!(scale > 0)) return;
  const double value = at_most_125(most);
  const double length = scale * value, cap = 0.1 * one_cm;
  panel.curves.push_back({.label = label,
                          .x = {0, 0, not_known, 0, length, not_known, length, length},
                          .y = {level - cap, level + cap, not_known, level, level, not_known, level - cap, level + cap},
                          .width = 0.9,
                          .complete = true,
                          .in_legend = false});
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
struct ShownForces {
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
Drawn drawn_of(const RunResults& run, const ShownForces& shown, const FrameForces& frame) {
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
  const double part = shown.at_instant          ? 0.45
                      : shown.carried.is_moment ? 0.4
                                                : 0.3;  // of a bay or storey; bands are as wide the other way
  constexpr double least = 0.04;                        // of the height of a tall frame, so that it is seen
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
  constexpr double too_small = 0.2;  // of the largest: a sliver beside its column
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

/// Writes a value beside its dot, of several that are alike where there is most room; nowhere if that is further away
/// than `most_far` [cm]. @param at_blow what the legend calls the dot of what is at a blow; empty: it is not
void name_largest(Panel& panel, const Diagram& diagram, const Carried& carried, const FrameForces& frame,
                  const LargestForce& force, const std::vector<LargestForce>& alike, const std::string& text,
                  double one_cm, double most_far = INFINITY, const std::string& at_blow = "") {
  if (force.member < 0) return;
  constexpr double much = 0.25;  // [cm] so that figures of other sizes have it at the same one
  const Curve members = diagram.members(Tone::black, "");
  std::optional<Panel> best;
  double nearest = most_far * one_cm;
  for (const LargestForce& one : alike) {
    for (const double station :
         carried.is_moment ? std::vector{carried.stations()[one.station]}
                           : std::vector{0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9}) {  // it is alike along the member
      if (!carried.is_moment && frame.members[one.member].of_beam && (station < 0.3 || station > 0.7)) continue;
      const auto [x, y] = diagram.at(one.member, station, one.value);
      Panel here = panel;
      here.curves.push_back({.label = at_blow.empty() ? text : at_blow,
                             .x = {x},
                             .y = {y},
                             .tone = at_blow.empty() ? Tone::black : Tone::red,
                             .line = Line::none,
                             .mark = Mark::disc,
                             .complete = true,
                             .mark_size = std::isinf(most_far) ? 1 : 0.7,
                             .in_legend = !at_blow.empty()});
      const double far = add_beside(here, x, y, text, one_cm, members);
      if (far > nearest - (best ? much * one_cm : 0)) continue;
      nearest = far;
      best = std::move(here);
      if (nearest < much * one_cm) break;
    }
    if (best && nearest < much * one_cm) break;
  }
  if (best) panel = *std::move(best);
}

/// How the panels of a figure stand: a row for each frame and in it one panel for each of what is shown, or the other
/// way round, whichever draws frames larger.
struct Sheet {
  bool has_rows_of_frames = true;
  std::size_t beside = 1;
  double width = 0;          ///< of the figure [cm]
  double one_cm = 0;         ///< what a centimetre is [length]
  double of_panel = 0;       ///< how wide a panel is [cm]
  bool leaves_room = false;  ///< in the last row of a frame
};

constexpr double below_frame = 1.1;  // the frame, a number and a bar [cm]

/// Whether frames are higher than wide, so that two stand side by side on a telephone.
bool are_slender(const std::vector<Drawn>& frames) {
  return std::all_of(frames.begin(), frames.end(),
                     [](const Drawn& one) { return extent_of(*one.frame).top > 1.2 * extent_of(*one.frame).right; });
}

/// @param drawn of each of what is shown its frames
Sheet sheet_of(const std::vector<std::vector<Drawn>>& drawn, const FigureOptions& options, bool has_rows_of_frames) {
  const std::size_t count = drawn.size(), frames = drawn.front().size();
  const bool are_three = count > 2;
  Sheet sheet{.has_rows_of_frames = has_rows_of_frames,
              .beside = !has_rows_of_frames ? frames
                        : !options.narrow   ? count
                                          : static_cast<std::size_t>(are_slender(drawn.front()) || are_three ? 2 : 1)};
  sheet.width = options.narrow || sheet.beside == 1 ? options.width : broad(options.width);
  sheet.leaves_room = has_rows_of_frames && count % sheet.beside > 0;
  // Of rows so high that frames over the width of a panel can be read; two of them leave room for others on a page.
  const double above = sheet.leaves_room ? 1.0 : 0.8;  // title of a row and what is free between two [cm]
  constexpr double of_legend = 0.5, of_signs = 1.4;    // [cm]
  const double highest = are_three ? 6.9 : 7.8;        // [cm]
  const std::size_t rows = has_rows_of_frames ? frames * ((count + sheet.beside - 1) / sheet.beside) : count;
  const bool is_lower = are_three && !options.narrow && has_rows_of_frames && frames <= 2;
  const double room = is_lower ? 15.6 : page_height;  // two thirds of a page [cm]
  const double height =
      std::min(highest, (room - of_legend - of_signs) / static_cast<double>(rows) - above) - below_frame;
  constexpr double between = 0.8;  // of the panels of a row, and beside them [cm]
  sheet.of_panel = sheet.width / static_cast<double>(sheet.beside) - between;
  for (const std::vector<Drawn>& all : drawn) {
    for (const Drawn& one : all)
      sheet.one_cm = std::max({sheet.one_cm, one.high() / height, one.wide() / sheet.of_panel});
  }
  return sheet;
}

/// Diagrams of the beams, over them those of the columns where they are as large along the whole member.
/// @param in_legend what is dashed and what is not
void add_diagrams(Panel& panel, const Diagram& diagram, const FrameForces& frame, const ShownForces& shown,
                  bool has_impacts, bool in_legend, const FigureOptions& options) {
  const auto label_of = [&](bool of_beams, bool touches) {
    const std::string of_all =
        shown.at_instant || !has_impacts ? "" : word(options, touches ? "with contact" : "without contact");
    if (in_legend && !of_beams && !of_all.empty()) return of_all;
    return word(options, of_beams ? "beams" : "columns") + (of_all.empty() ? "" : ", " + of_all);
  };
  const auto band_of = [&](bool touches) {
    const std::vector<const FrameForces::Forces*> forces = shown.of(frame, touches);
    return forces.size() == 1 ? Band{.high = forces.front()} : Band{.low = forces.back(), .high = forces.front()};
  };
  const Band with = band_of(true);
  const auto fill = [&](bool of_beams) {
    Curve area =
        diagram.area(with, of_beams,
                     {.label = word(options, of_beams ? "beams" : "columns"), .tone = Tone::pale, .in_legend = false});
    if (!area.x.empty()) panel.curves.push_back(std::move(area));
  };
  const auto edge = [&](bool of_beams) {
    const auto add = [&](const Band& band, Curve style, bool touches) {
      style.label = label_of(of_beams, touches);
      style.in_legend = in_legend && !of_beams;
      style.width = 0.9;
      style.complete = true;
      Curve outline = diagram.outline(band, of_beams, std::move(style));
      if (!outline.x.empty()) panel.curves.push_back(std::move(outline));
    };
    if (!shown.at_instant && has_impacts) {
      add(band_of(false), {.tone = Tone::grey, .line = Line::dashed}, false);
    }
    add(with, {}, true);
  };
  if (shown.carried.is_moment) {
    for (const bool of_beams : {true, false}) fill(of_beams);
    for (const bool of_beams : {true, false}) edge(of_beams);
    return;
  }
  for (const bool of_beams : {true, false}) {
    fill(of_beams);
    edge(of_beams);
  }
}

/// The largest of all and that at a blow, then those of each storey and floor where there is room beside
/// them.
void name_values(Panel& panel, const Diagram& diagram, const RunResults& run, const FigureOptions& options,
                 const ShownForces& shown, const Drawn& one, double one_cm) {
  const FrameForces& frame = *one.frame;
  const Carried& carried = shown.carried;
  const std::vector<const FrameForces::Forces*> drawn = shown.of(frame, true);
  const auto value_of = [&](const LargestForce& force) {
    return short_number(shown_factor(run, carried.form) * std::abs(force.value));
  };
  const LargestForce& largest = one.largest;
  if (largest.member < 0) return;
  constexpr double least = 0.05, most_far = 0.7;  // of the largest of all, [cm]
  const std::string at_blow = word(options, "struck column, at the blow");
  const LargestForce struck =
      largest_at_blow(run, carried, frame, drawn, shown.at_instant ? std::optional(frame.time) : std::nullopt);
  const bool is_struck = struck.member >= 0 && std::abs(struck.value) > least * std::abs(largest.value);
  if (is_struck && std::abs(struck.value) > std::abs(largest.value) * (1 - 1e-6)) {
    name_largest(panel, diagram, carried, frame, struck, {struck}, value_of(struck), one_cm, INFINITY, at_blow);
  } else {
    name_largest(panel, diagram, carried, frame, largest, alike_to(largest, carried, frame, drawn, {}),
                 value_of(largest), one_cm);
    if (is_struck) {
      name_largest(panel, diagram, carried, frame, struck, {struck}, value_of(struck), one_cm, INFINITY, at_blow);
    }
  }
  Eigen::Index storeys = 0;
  for (const FrameMember& member : frame.members) storeys = std::max(storeys, member.level);
  for (Eigen::Index level = 1; level <= storeys; ++level) {
    for (const bool of_beams : {false, true}) {
      const Among among{level, of_beams};
      LargestForce force;
      for (const FrameForces::Forces* const forces : drawn) force.take(carried, frame, *forces, among);
      if (among.has(frame.members[largest.member]) || std::abs(force.value) < least * std::abs(largest.value)) continue;
      if (is_struck && among.has(frame.members[struck.member]) &&
          std::abs(force.value) < std::abs(struck.value) * (1 + 1e-6)) {
        continue;
      }
      name_largest(panel, diagram, carried, frame, force, alike_to(force, carried, frame, drawn, among),
                   value_of(force), one_cm, most_far);
    }
  }
}

Figure frame_figure(const RunResults& run, const FigureOptions& options, const std::string& title,
                    const std::vector<ShownForces>& columns) {
  const std::vector<const FrameForces*> frames = frames_shown(run, options);
  const bool are_three = columns.size() > 2;
  const bool has_impacts = !run.response.impacts.empty();
  std::vector<std::vector<Drawn>> drawn;  // of each column
  std::vector<double> most;               // forces
  for (const ShownForces& shown : columns) {
    std::vector<Drawn>& all = drawn.emplace_back();
    for (const FrameForces* frame : frames) all.push_back(drawn_of(run, shown, *frame));
    most.push_back(choose_scales(all));
  }
  Sheet sheet = sheet_of(drawn, options, true);
  if (are_three && !options.narrow && frames.size() <= 2) {
    const Sheet other = sheet_of(drawn, options, false);
    const double as_large = are_slender(drawn.front()) ? 1 : 1.05;  // values have more room in wider panels
    if (other.one_cm < as_large * sheet.one_cm) sheet = other;
  }
  Figure figure{.title = title, .columns = static_cast<int>(sheet.beside), .width = sheet.width, .shared_legend = true};
  const double one_cm = sheet.one_cm;
  const double low = -below_frame * one_cm, bar = -0.85 * one_cm;
  figure.panels.resize(frames.size() * columns.size());
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const FrameForces& frame = *frames[f];
    const Building& building = run.problem.buildings[frame.building];
    const auto [right, top] = extent_of(frame);
    std::string finding;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const ShownForces& shown = columns[c];
      const Carried& carried = shown.carried;
      const Drawn& one = drawn[c][f];
      double highest = top;  // of its row
      for (std::size_t k = 0; k < (sheet.has_rows_of_frames ? columns.size() : frames.size()); ++k) {
        highest = std::max(highest, (sheet.has_rows_of_frames ? drawn[k][f] : drawn[c][k]).high());
      }
      highest += 0.06 * one_cm;  // half the line of a beam
      const double factor = shown_factor(run, carried.form);
      const std::string unit = shown_unit(run, carried.form);
      const Diagram diagram(carried, frame, one.scale);
      const double side = (one_cm * sheet.of_panel - right) / 2;  // for numbers too
      Panel panel{.x = {.from = -side, .to = right + side, .numbers = false},
                  .y = {.from = low, .to = highest, .numbers = false},
                  .height = (highest - low) / one_cm,
                  .begins_row = c == 0 && sheet.leaves_room,
                  .to_scale = true,
                  .unit = run.c.units.length};
      const std::string what = with_unit(carried.symbol, unit);
      panel.title = building.name + ", " +
                    (shown.at_instant ? what + " " + word(options, "at {}", seconds_text(frame.time))
                                      : word(options, "{}, largest", what));
      const bool is_below = f == (sheet.has_rows_of_frames ? frames.size() - 1 : 0);
      if (is_below && (c == 0 || carried.signs != columns[c - 1].carried.signs)) {
        panel.x.label = word(options, carried.signs);
      }
      if (one.is_of_own_scale) panel.title += ", " + word(options, "own scale");
      const bool in_legend = f == 0 && c + 1 == columns.size() && !shown.at_instant && has_impacts;
      add_diagrams(panel, diagram, frame, shown, has_impacts, in_legend, options);
      panel.curves.push_back(diagram.members(tone_of(run, options, frame.building), word(options, "members")));
      const auto first = std::find_if(drawn[c].begin(), drawn[c].end(),
                                      [](const Drawn& each) { return !each.is_of_own_scale && each.most() > 0; });
      if (one.is_of_own_scale || &one == &*first) {  // that of all others is said once
        const double largest = factor * (one.is_of_own_scale ? one.most() : most[c]);
        add_scale(panel, one.scale / factor, largest, one_cm, unit, bar, word(options, "scale"));
      }
      name_values(panel, diagram, run, options, shown, one, one_cm);
      figure.panels[sheet.has_rows_of_frames ? f * columns.size() + c : c * frames.size() + f] = std::move(panel);
      const LargestForce& largest = one.largest;
      if (largest.member < 0 || (shown.at_instant && columns.size() == 2)) continue;
      const auto text_of = [&](double value) { return number(factor * std::abs(value)) + " " + unit; };
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

constexpr Carried moment{.form = "F L",
                         .symbol = "M",
                         .signs = "M without gravity, tension side",
                         .is_moment = true,
                         .largest = "largest moment {}, {}"};
constexpr Carried shear{
    .form = "F",
    .symbol = "V",
    .signs = "V without gravity; right: pushes the floor above to the right; down: lifts the left end",
    .largest = "largest shear {}, {}"};
constexpr Carried axial{.form = "F",
                        .symbol = "N",
                        .signs = "N without gravity; right: compression",
                        .is_axial = true,
                        .largest = "largest axial force {}, {}"};

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
