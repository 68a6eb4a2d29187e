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
  const char *form, *symbol;  ///< of its unit; what it is called in short
  bool is_moment = false, is_axial = false;
  const char* title;    ///< of the data
  const char* largest;  ///< "largest moment {}: {}"

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

/// A frame and the forces that its diagrams have to show.
struct Drawn {
  const FrameForces* frame = nullptr;
  double right = 0, top = 0;  ///< how far its members reach [length]
  double reach = 0;           ///< of its largest force [length]
  LargestForce then = {}, largest = {}, alone = {};
  double scale = 0;  ///< of its forces [length per unit]
  bool is_of_own_scale = false;

  [[nodiscard]] double most() const {
    return std::max({std::abs(then.value), std::abs(largest.value), std::abs(alone.value)});
  }
  [[nodiscard]] double high() const { return top + 1.15 * reach; }
};

Drawn drawn_of(const RunResults& run, const Carried& carried, const FrameForces& frame) {
  const StructuralModel& model = run.problem.buildings[frame.building].model;
  const auto [right, top] = extent_of(frame);
  double shortest = INFINITY;  // bay or storey
  for (const FrameMember& member : frame.members) {
    if (member.of_beam) shortest = std::min(shortest, member.length());
  }
  for (Eigen::Index f = model.first_storey(); f < model.floors(); ++f) {
    shortest = std::min(shortest, model.storey_heights[f]);
  }
  // A third of the shortest bay or storey; of a tall frame more, so that it can be seen.
  Drawn drawn{.frame = &frame, .right = right, .top = top, .reach = std::max(shortest / 3, 0.04 * top)};
  drawn.then.take(carried, frame, frame.instant);
  for (const FrameForces::Forces* one : {&frame.most, &frame.least}) drawn.largest.take(carried, frame, *one);
  if (run.response.impacts.empty()) return drawn;
  for (const FrameForces::Forces* one : {&frame.most_without_contact, &frame.least_without_contact}) {
    drawn.alone.take(carried, frame, *one);
  }
  return drawn;
}

/// Frames and what they carry have one scale, so that they can be compared; but what would be too small to be read has
/// its own. @returns the largest force
double choose_scales(std::vector<Drawn>& drawn) {
  constexpr double too_small = 0.1;  // of the largest
  double most = 0, scale = INFINITY;
  for (const Drawn& one : drawn) most = std::max(most, one.most());
  for (Drawn& one : drawn) {
    if (!(one.most() > 0)) continue;
    one.scale = one.reach / one.most();
    one.is_of_own_scale = one.most() < too_small * most;
    if (!one.is_of_own_scale) scale = std::min(scale, one.scale);
  }
  for (Drawn& one : drawn) {
    if (one.most() > 0 && !one.is_of_own_scale) one.scale = scale;
  }
  return most;
}

Figure frame_figure(const RunResults& run, const FigureOptions& options, const Carried& carried) {
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
  const bool are_slender = std::all_of(frames.begin(), frames.end(), [](const FrameForces* one) {
    return extent_of(*one).top > 1.2 * extent_of(*one).right;  // so that two stand side by side on a telephone
  });
  Figure figure{.title = carried.title,
                .columns = options.narrow && !are_slender ? 1 : 2,  // a building's two panels beside one another
                .width = options.narrow ? options.width : broad(options.width)};
  const bool has_impacts = !run.response.impacts.empty();
  // Of rows so high that frames over the width of a panel can be read; two of them leave room for others on a page.
  constexpr double title = 0.8, highest = 7.8;  // with what is free between two rows; of a row [cm]
  const std::size_t rows = 2 * frames.size() / static_cast<std::size_t>(figure.columns);
  const double height = std::min(highest, page_height / static_cast<double>(rows) - title);
  constexpr double between = 0.8;  // of the two panels of a row, and beside them [cm]
  const double width = figure.width / figure.columns - between;
  const double factor = shown_factor(run, carried.form);
  const std::string unit = shown_unit(run, carried.form);
  constexpr double below = 1.1;  // the frame, a number and a bar [cm]
  std::vector<Drawn> drawn;
  double high = 0, one_cm = 0;  // [length]
  for (const FrameForces* frame : frames) {
    drawn.push_back(drawn_of(run, carried, *frame));
    high = std::max(high, drawn.back().high());
  }
  for (const Drawn& one : drawn) {
    one_cm = std::max({one_cm, high / (height - below), (one.right + 2.3 * one.reach) / width});
  }
  const double most = choose_scales(drawn);
  const double low = -below * one_cm, bar = -0.85 * one_cm;
  const auto first = std::find_if(drawn.begin(), drawn.end(), [](const Drawn& one) { return !one.is_of_own_scale; });
  const std::string own_scale = ", " + word(options, "own scale");
  for (const Drawn& one : drawn) {
    const FrameForces* const frame = one.frame;
    const Building& building = run.problem.buildings[frame->building];
    const auto [right, top] = std::pair(one.right, one.top);
    LargestForce then = one.then, largest = one.largest;
    const Diagram diagram(carried, *frame, one.scale);
    const double beside = (one_cm * width - right) / 2;  // for numbers too
    Panel panel{.x = {.from = -beside, .to = right + beside, .numbers = false},
                .y = {.from = low, .to = one.high(), .numbers = false},
                .height = (one.high() - low) / one_cm,
                .to_scale = true};
    Curve members{.tone = tone_of(options, frame->building), .width = 1.2, .complete = true};
    for (Eigen::Index n = 0; n < std::ssize(frame->members); ++n) {
      for (const double station : {0.0, 1.0}) {
        const auto [x, y] = diagram.at(n, station, 0);
        members.x.push_back(x);
        members.y.push_back(y);
      }
      members.x.push_back(not_known);
      members.y.push_back(not_known);
    }
    panel.curves.push_back(std::move(members));
    const auto named = [&](Panel& of, LargestForce& force, const std::vector<const FrameForces::Forces*>& among) {
      if (force.member < 0) return;
      const std::string text = number(factor * std::abs(force.value)) + " " + unit;
      std::optional<Panel> best;
      double nearest = INFINITY;
      for (const LargestForce& alike : alike_to(force, carried, *frame, among)) {
        for (const double station : carried.is_moment ? std::vector{carried.stations()[alike.station]}
                                                      : std::vector{0.5, 0.35, 0.65}) {  // it is alike along the member
          const auto [x, y] = diagram.at(alike.member, station, alike.value);
          Panel here = of;
          here.curves.push_back({.x = {x}, .y = {y}, .line = Line::none, .mark = Mark::disc, .complete = true});
          const double far = add_beside(here, x, y, text, one_cm);
          if (far > nearest - 0.02 * one_cm) continue;
          nearest = far;
          best = std::move(here);
          force = alike;
        }
      }
      of = std::move(*best);
    };
    Panel instant = panel;
    if (one.is_of_own_scale || &one == &*first) {  // that of all others is said once
      add_scale(instant, one.scale / factor, factor * (one.is_of_own_scale ? one.most() : most), one_cm, unit, bar);
    }
    instant.title = building.name + ", " + with_unit(carried.symbol, unit) + " " +
                    word(options, "at {}", seconds_text(frame->time)) + (one.is_of_own_scale ? own_scale : "");
    instant.curves.push_back(
        diagram.outline(frame->instant, {.width = 0.5, .complete = true}, 0.03 * std::max(top, right)));
    instant.curves.push_back(diagram.outline(frame->instant, {.width = 0.9, .complete = true}));
    named(instant, then, {&frame->instant});
    figure.panels.push_back(std::move(instant));

    panel.title = word(options, has_impacts ? "largest, with contact and (dashed) without" : "largest of the run") +
                  (one.is_of_own_scale ? own_scale : "");
    if (has_impacts) {
      for (const FrameForces::Forces* of : {&frame->most_without_contact, &frame->least_without_contact}) {
        panel.curves.push_back(
            diagram.outline(*of, {.tone = Tone::grey, .line = Line::dashed, .width = 0.9, .complete = true}));
      }
    }
    for (const FrameForces::Forces* of : {&frame->most, &frame->least}) {
      panel.curves.push_back(diagram.outline(*of, {.width = 0.9, .complete = true}));
    }
    named(panel, largest, {&frame->most, &frame->least});
    figure.panels.push_back(std::move(panel));
    if (largest.member < 0) continue;
    figure.finding += (figure.finding.empty() ? "" : "; ") + building.name + ": " +
                      word(options, carried.largest, number(factor * std::abs(largest.value)) + " " + unit,
                           member_text(options, carried, *frame, largest));
    if (!has_impacts) continue;
    figure.finding +=
        ", " + word(options, "without contact {}", number(factor * std::abs(one.alone.value)) + " " + unit);
  }
  return figure;
}

}  // namespace

Figure frame_moment_figure(const RunResults& run, const FigureOptions& options) {
  return frame_figure(run, options,
                      {.form = "F L",
                       .symbol = "M",
                       .is_moment = true,
                       .title = "Moments in the members of frames, on the side in tension",
                       .largest = "largest moment {}, {}"});
}

Figure frame_shear_figure(const RunResults& run, const FigureOptions& options) {
  return frame_figure(
      run, options,
      {.form = "F", .symbol = "V", .title = "Shears in the members of frames", .largest = "largest shear {}, {}"});
}

Figure frame_axial_figure(const RunResults& run, const FigureOptions& options) {
  return frame_figure(run, options,
                      {.form = "F",
                       .symbol = "N",
                       .is_axial = true,
                       .title = "Axial forces in the columns of frames by the motion, compression to the right",
                       .largest = "largest axial force {}, {}"});
}

}  // namespace bentur
