#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/internal/burst.h"
#include "bentur/report/kinds/internal/convex_area.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/scene/tones.h"

namespace bentur {
namespace {

using Eigen::Index;

struct PlanBox {
  PlanPoint low, high;
};

PlanBox box_of(const PlanRings& rings) {
  PlanBox box{rings.front().front(), rings.front().front()};
  for (const std::vector<PlanPoint>& ring : rings) {
    for (const PlanPoint& at : ring) box = {box.low.cwiseMin(at), box.high.cwiseMax(at)};
  }
  return box;
}

bool meet(const PlanBox& a, const PlanBox& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// The picture at one instant.
class PlanPicture {
 public:
  PlanPicture(const PlanRun& run, const PlanInstant& instant, const FigureOptions& options)
      : run_(run),
        scene_(run),
        options_(options),
        tones_(tones_of(run.problem, run.response)),
        time_(instant.time),
        shown_(*instant.point) {
    const double level = contact_at(run.problem, *instant.point).contact->elevation;
    for (const PlanBuilding& building : run.problem.buildings) {
      const auto b = std::ssize(floors_);
      floors_.push_back(nearest_floor(building.model, level));
      motions_.push_back(building.is_rigid() ? Eigen::Vector3d(0, 0, 0)
                                             : floor_motion(run.response.course.time.empty() ? run.response.histories
                                                                                             : run.response.course,
                                                            b, floors_.back(), time_));
      rings_.push_back(moved_rings(b));
      boxes_.push_back(box_of(rings_.back()));
    }
    for (const Impact& impact : run.response.impacts) {
      const bool is_on = instant.impact && lasts_at(impact, time_);
      if (is_on && contact_at(run.problem, impact.point).contact->elevation == level) touching_.insert(impact.point);
    }
    size_ = 0.045 * (scene_.upper() - scene_.lower()).maxCoeff();
  }

  Panel panel(const std::string& title, double height) {
    panel_ = {.title = title,
              .x = {.numbers = false},
              .y = {.numbers = false},
              .height = height,
              .to_scale = true,
              .unit = run_.c.units.length};
    for (std::size_t g = 0; g < run_.problem.gaps.size(); ++g) add_gap(g);
    for (Index b = 0; b < std::ssize(run_.problem.buildings); ++b) add_footprint_at_rest(b);
    for (Index b = 0; b < std::ssize(run_.problem.buildings); ++b) add_footprint(b);
    if (has_centres()) add_centres();
    add_links();
    add_not_modelled();
    add_points();
    add_names();
    return std::move(panel_);
  }

  [[nodiscard]] double magnification() const { return scene_.magnification(); }

  /// What the tones of names say where they have two.
  [[nodiscard]] std::string key_of_names() const {
    if (has_centres()) return {};
    return word(options_, touching_.empty() ? "Names in black: the buildings of the place shown"
                                            : "Names in black: buildings that strike now");
  }

 private:
  [[nodiscard]] PlanPoint moved(Index b, const PlanPoint& at) const {
    return scene_.place(at, movement_of(run_.problem.buildings[b].model, floors_[b], at, motions_[b]));
  }

  void add_footprint_at_rest(Index b) {
    const PlanBuilding& building = run_.problem.buildings[b];
    if (building.is_rigid()) return;
    for (const std::vector<PlanPoint>& ring : scene_.outlines(building.model.footprint)) {
      Curve curve{.tone = Tone::grey, .line = Line::dotted, .width = 0.7, .complete = true};
      for (const PlanPoint& at : ring) add(curve, scene_.place(at));
      panel_.curves.push_back(std::move(curve));
    }
  }

  [[nodiscard]] PlanRings moved_rings(Index b) const {
    PlanRings rings = scene_.outlines(run_.problem.buildings[b].model.footprint);
    for (std::vector<PlanPoint>& ring : rings) {
      for (PlanPoint& at : ring) at = moved(b, at);
    }
    return rings;
  }

  [[nodiscard]] double level_of(Index b) const { return run_.problem.buildings[b].model.elevations[floors_[b]]; }

  /// Whether what stands above a building may cover something of it.
  [[nodiscard]] bool is_above(Index other, Index b) const {
    return level_of(other) > level_of(b) && !run_.problem.buildings[other].is_rigid();
  }

  /// Of what stands above a building that which may cover something of its floor.
  [[nodiscard]] std::vector<PlanRings> rings_above(Index b) const {
    std::vector<PlanRings> above;
    for (Index other = 0; other < std::ssize(rings_); ++other) {
      if (is_above(other, b) && meet(boxes_[other], boxes_[b])) above.push_back(rings_[other]);
    }
    return above;
  }

  [[nodiscard]] bool is_covered(Index b, const PlanPoint& at) const {
    for (Index other = 0; other < std::ssize(rings_); ++other) {
      if (is_above(other, b) && lies_in(at, rings_[other])) return true;
    }
    return false;
  }

  /// Seen from above: what a higher floor covers is not seen. Their displacements are of different levels, so that they
  /// lie over one another without having met.
  void add_footprint(Index b) {
    const std::vector<PlanRings> above = rings_above(b);
    for (const std::vector<PlanPoint>& ring : rings_[b]) {
      Curve curve{.label = run_.problem.buildings[b].name,
                  .tone = tones_[b],
                  .width = 1.5,
                  .complete = true,
                  .in_legend = false};
      if (has_centres() && b > 0) curve.line = line_beside(curve.tone, tones_[b - 1]);
      for (const std::vector<PlanPoint>& line : seen_parts(ring, above)) {
        if (!curve.x.empty()) add(curve, PlanPoint::Constant(not_known));
        for (const PlanPoint& at : line) add(curve, at);
      }
      if (!curve.x.empty()) panel_.curves.push_back(std::move(curve));
    }
  }

  /// Of more buildings there is room for names and what is struck alone.
  [[nodiscard]] bool has_centres() const { return run_.problem.buildings.size() <= 6; }

  /// Those that strike one another now; where none do, those of the place that is shown.
  [[nodiscard]] std::set<Index> struck_buildings() const {
    std::set<Index> all;
    for (const Index point : touching_.empty() ? std::set<Index>{shown_} : touching_) {
      const PlanGap& gap = run_.problem.gaps[contact_at(run_.problem, point).gap];
      all.insert({gap.left, gap.right});
    }
    return all;
  }

  /// In each footprint where it is broadest, above or below its centres where there are any.
  void add_names() {
    NameRows rows{.half_height = 0.5 * high_name * length_of_cm(), .marks = marks()};
    if (!has_centres()) {
      std::vector<std::vector<PlanRings>> above;
      for (Index b = 0; b < std::ssize(rings_); ++b) above.push_back(rings_above(b));
      const std::set<Index> struck = struck_buildings();
      Index b = 0;
      for (PlaceText& name : places_of_names(run_.problem, rings_, rows, length_of_cm(), above)) {
        if (struck.count(b++) == 0) name.tone = Tone::grey;
        if (fits(name)) panel_.texts.push_back(std::move(name));
      }
      return;
    }
    rows.parts = {0.75, 0.25, 0.5};
    for (Index b = 0; b < std::ssize(run_.problem.buildings); ++b) {
      const PlanBuilding& building = run_.problem.buildings[b];
      PlaceText name = place_of_name(building.name, rings_[b], rows, rings_above(b));
      if (fits(name)) {
        panel_.texts.push_back(std::move(name));
      } else {
        for (Curve& curve : panel_.curves) curve.in_legend = curve.in_legend || curve.label == building.name;
      }
    }
  }

  /// Where marks and rays lie, with some room around them.
  [[nodiscard]] std::vector<Box> marks() const {
    constexpr double of_one = 0.08;  // half of a mark of size 1, with room [cm]
    std::vector<Box> boxes;
    for (const Curve& curve : panel_.curves) {
      const bool are_rays = curve.tone == Tone::red && curve.top.empty() && curve.line == Line::solid;
      const double half = curve.mark != Mark::none ? of_one * curve.mark_size * length_of_cm() : 0;
      if (!are_rays && half == 0) continue;
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (std::isnan(curve.x[i])) continue;
        boxes.push_back({curve.x[i] - half, curve.x[i] + half, curve.y[i] - half, curve.y[i] + half});
      }
    }
    return boxes;
  }

  /// Whether the words of a name have room for each of them, about.
  [[nodiscard]] bool fits(const PlaceText& name) const {
    double longest = 0;
    for (std::size_t at = 0; at < name.text.size();) {
      const std::size_t end = std::min(name.text.find(' ', at), name.text.size());
      longest = std::max(longest, text_width(name.text.substr(at, end - at)));
      at = end + 1;
    }
    return longest * length_of_cm() < name.room;
  }

  /// About.
  [[nodiscard]] double length_of_cm() const {
    constexpr double margins = 0.6, wide = 12, share = 0.5;  // [cm], [cm], of a figure with panels side by side [-]
    const double width = options_.width >= wide ? share * options_.width : options_.width - margins;
    const PlanPoint size = scene_.upper() - scene_.lower();
    return std::max(size.x() / width, size.y() / panel_.height);
  }

  /// What the hardest blow at a contact was: its force, or where impacts take no time its impulse.
  [[nodiscard]] double blow_at(Index point) const {
    if (has_forces()) return run_.response.points[point].peak_force;
    double most = 0;
    for (const Impact& impact : run_.response.impacts) {
      if (impact.point == point) most = std::max(most, impact.impulse);
    }
    return most;
  }
  [[nodiscard]] bool has_forces() const {
    const auto& points = run_.response.points;
    return std::any_of(points.begin(), points.end(), [](const PointSummary& one) { return one.peak_force > 0; });
  }
  [[nodiscard]] double hardest_blow() const {
    double most = 0;
    for (Index i = 0; i < std::ssize(run_.response.points); ++i) most = std::max(most, blow_at(i));
    return most;
  }

  /// The strip between two buildings, in parts for each place of a contact, by the hardest blow at any level.
  void add_gap(std::size_t g) {
    const PlanGap& gap = run_.problem.gaps[g];
    const Stretch& stretch = gap.stretch;
    std::vector<std::pair<double, double>> blows;  // where along the stretch, how hard
    const Index first = first_contact(run_.problem, g);
    for (Index i = 0; i < std::ssize(gap.contacts) && !stretch.is_corner(); ++i) {
      if (!gap.contacts[i].is_of_joint()) continue;
      const double along = gap.contacts[i].along;
      auto found = std::find_if(blows.begin(), blows.end(), [&](const auto& one) { return one.first == along; });
      if (found == blows.end()) found = blows.insert(blows.end(), {along, 0.0});
      found->second = std::max(found->second, blow_at(first + i));
    }
    std::sort(blows.begin(), blows.end());
    const double most = hardest_blow();
    const auto tone_of = [&](std::size_t i) {
      const double blow = blows[i].second;
      return blow > most / 2 ? Tone::red : blow > 0 ? Tone::gold : Tone::pale;
    };
    double from = stretch.from;
    for (std::size_t i = 0; i < blows.size(); ++i) {
      const bool is_last = i + 1 == blows.size();
      if (!is_last && tone_of(i + 1) == tone_of(i)) continue;
      const double to = is_last ? stretch.to : (blows[i].first + blows[i + 1].first) / 2;
      add_strip(stretch, from, to, tone_of(i), most);
      from = to;
    }
  }

  /// Hatches across gaps where at some level and time a floor goes inside what it faces and no contact is modelled.
  void add_not_modelled() {
    Curve hatches{.label = word(options_, "contact not modelled"), .tone = Tone::red, .width = 0.9, .complete = true};
    std::size_t number = 0;  // among what all gaps watch
    for (const PlanGap& gap : run_.problem.gaps) {
      const PlanPoint across = 0.4 * size_ * gap.stretch.n, along(-across.y(), across.x());
      for (const PlanWatched& watched : gap.watched) {
        if (!run_.response.watched[number++].closes) continue;
        const StretchCorner at = gap.at(watched);
        for (const double step : {-1.5, -0.5, 0.5, 1.5}) {
          if (!hatches.x.empty()) add(hatches, {not_known, not_known});
          add(hatches, scene_.place(at.left) - across + (step - 0.4) * along);
          add(hatches, scene_.place(at.right) + across + (step + 0.4) * along);
        }
      }
    }
    if (!hatches.x.empty()) panel_.curves.push_back(std::move(hatches));
  }

  void add_strip(const Stretch& stretch, double from, double to, Tone tone, double most) {
    Curve strip{.tone = tone, .complete = true};
    if (tone != Tone::pale) strip.label = label_of(tone, most);
    const double least = 0.004 * (scene_.upper() - scene_.lower()).maxCoeff();  // so that none is too thin to see
    std::vector<PlanPoint> corners = {stretch.on_edge(0, from), stretch.on_edge(0, to), stretch.on_edge(1, to),
                                      stretch.on_edge(1, from)};
    for (PlanPoint& at : corners) at = scene_.place(at);
    const double thin = std::min(stretch.n.dot(corners[3] - corners[0]), stretch.n.dot(corners[2] - corners[1]));
    const PlanPoint wider = 0.5 * std::max(0.0, 2 * least - thin) * stretch.n;
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] += i < 2 ? PlanPoint(-wider) : wider;
    add_area(strip, corners);
    panel_.curves.push_back(std::move(strip));
  }

  /// In the legend; each once.
  std::string label_of(Tone tone, double most) {
    if (!labelled_.insert(tone).second) return {};
    const std::string_view form = has_forces() ? "F" : "F s";
    return tone == Tone::red ? word(options_, "hardest impact {} to {}", number(most / 2 * shown_factor(run_, form)),
                                    shown_value(run_, most, form))
                             : word(options_, "hardest impact up to {}", shown_value(run_, most / 2, form));
  }

  void add_centres() {
    Curve masses{.label = word(options_, "centre of mass"), .line = Line::none, .mark = Mark::disc, .complete = true};
    Curve rigidity{
        .label = word(options_, "centre of rigidity"), .line = Line::none, .mark = Mark::cross, .complete = true};
    for (const PlanCentre& centre : centres_of(run_)) {
      if (centre.floor != floors_[centre.building]) continue;
      const PlanPoint at = moved(centre.building, centre.at);
      if (!is_covered(centre.building, at)) add(centre.of_rigidity ? rigidity : masses, at);
    }
    if (masses.x.empty()) return;
    panel_.curves.push_back(std::move(rigidity));
    panel_.curves.push_back(std::move(masses));
  }

  /// Those of the level shown, from edge to edge.
  void add_links() {
    std::string label = word(options_, "link");
    for (const PlanLink& link : run_.problem.links) {
      if (!is_at(link, floors_, run_.problem)) continue;
      Curve line{.label = std::exchange(label, ""), .width = 4, .complete = true};
      add(line, moved(link.link.left, link.stretch.on_edge(0, link.along)));
      add(line, moved(link.link.right, link.stretch.on_edge(1, link.along)));
      panel_.curves.push_back(std::move(line));
    }
  }

  /// What happens at a place of a gap, at all its levels.
  struct PointMarks {
    StretchCorner place;
    bool is_shown = false, strikes = false, is_struck = false, slips = false;  // of the level shown
    bool is_struck_elsewhere = false;
  };

  [[nodiscard]] std::vector<PointMarks> marks_of(std::size_t g, const std::set<Index>& slips) const {
    const PlanGap& gap = run_.problem.gaps[g];
    std::vector<PointMarks> all;
    for (Index i = 0; i < std::ssize(gap.contacts); ++i) {
      const PlanContact& contact = gap.contacts[i];
      const StretchCorner place = gap.at(contact);
      const auto is_there = [&](const PointMarks& one) {
        return one.place.left == place.left && one.place.right == place.right;
      };
      auto found = std::find_if(all.begin(), all.end(), is_there);
      if (found == all.end()) found = all.insert(all.end(), {.place = place});
      const Index point = first_contact(run_.problem, g) + i;
      const bool is_struck = run_.response.points[point].impacts > 0;
      if (floor_at(run_.problem, gap, contact, 0) == floors_[gap.left] &&
          floor_at(run_.problem, gap, contact, 1) == floors_[gap.right]) {
        found->is_shown = true;
        found->strikes = found->strikes || touching_.count(point) > 0;
        found->is_struck = found->is_struck || is_struck;
        found->slips = found->slips || slips.count(point) > 0;
      } else {
        found->is_struck_elsewhere = found->is_struck_elsewhere || is_struck;
      }
    }
    return all;
  }

  /// Contacts at both edges of the level shown; corners that strike then, and those that did before or will, or do at
  /// another level alone; which of them slip off at some time, and corners that are none of their own.
  void add_points() {
    Curve open{.line = Line::none, .mark = Mark::circle, .complete = true, .mark_size = 0.8};
    open.label = word(options_, "contact point");
    open.tone = Tone::grey;
    Curve hit = open;
    hit.label = word(options_, "struck point");
    hit.tone = Tone::red;
    hit.mark = Mark::disc;  // distinct in grey, as the larger one of what strikes now
    Curve elsewhere = open;
    elsewhere.label = word(options_, "touched at another level");
    elsewhere.tone = Tone::red;
    Curve now = hit;
    now.label = word(options_, "strikes now");
    now.mark_size = 1.8;
    Curve slid = hit;
    slid.label = word(options_, "slips off");
    slid.mark = Mark::diamond;
    slid.mark_size = 2.2;  // around the other
    Curve merged = open;
    merged.label = word(options_, "merged corner");
    merged.mark = Mark::triangle;
    std::set<Index> slips;
    for (const Impact& impact : run_.response.impacts) {
      if (impact.slipped) slips.insert(impact.point);
    }
    std::vector<PlanPoint> bursts;
    for (std::size_t g = 0; g < run_.problem.gaps.size(); ++g) {
      const PlanGap& gap = run_.problem.gaps[g];
      const auto mark = [&](Curve& marks, const StretchCorner& at) {
        add(marks, moved(gap.left, at.left));
        add(marks, moved(gap.right, at.right));
      };
      for (const StretchCorner& corner : merged_corners(run_.problem, gap)) mark(merged, corner);
      for (const PointMarks& one : marks_of(g, slips)) {
        if (one.slips) mark(slid, one.place);
        if (one.strikes) {
          mark(now, one.place);
          bursts.push_back((moved(gap.left, one.place.left) + moved(gap.right, one.place.right)) / 2);
        } else if (one.is_struck) {
          mark(hit, one.place);
        } else if (one.is_struck_elsewhere) {
          mark_seen(elsewhere, gap, one.place);
        } else if (one.is_shown && has_centres()) {  // of many buildings those that nothing strikes are left out
          mark(open, one.place);
        }
      }
    }
    const double size = bursts.size() > 2 ? 0.6 * size_ : size_;
    for (const PlanPoint& at : bursts) panel_.curves.push_back(burst(at.x(), at.y(), size));
    for (Curve* const marks : {&merged, &open, &elsewhere, &hit, &slid, &now}) {
      if (!marks->x.empty()) panel_.curves.push_back(std::move(*marks));
    }
  }

  /// At both edges, as far as nothing above covers them; at both where it covers both.
  void mark_seen(Curve& marks, const PlanGap& gap, const StretchCorner& at) const {
    const PlanPoint left = moved(gap.left, at.left), right = moved(gap.right, at.right);
    const bool hides_left = is_covered(gap.left, left), hides_right = is_covered(gap.right, right);
    if (!hides_left || hides_right) add(marks, left);
    if (!hides_right || hides_left) add(marks, right);
  }

  static void add(Curve& curve, const PlanPoint& at) {
    curve.x.push_back(at.x());
    curve.y.push_back(at.y());
  }

  const PlanRun& run_;
  PlanScene scene_;
  const FigureOptions& options_;
  std::vector<Tone> tones_;
  double time_, size_ = 0;
  Index shown_;  // contact
  std::vector<Index> floors_;
  std::vector<Eigen::Vector3d> motions_;
  std::vector<PlanRings> rings_;  // of the floors, moved
  std::vector<PlanBox> boxes_;    // of these
  std::set<Index> touching_;      // contacts
  std::set<Tone> labelled_;
  Panel panel_;
};

/// "t = 3.0910 s", what lies between, and what happens then.
std::string instant_text(const PlanRun& run, const PlanInstant& instant, const FigureOptions& options,
                         const std::string& between) {
  std::string what = word(options, "closest, without contact");
  if (instant.impact) {
    const Impact& impact = run.response.impacts[*instant.impact];
    what = word(options, "impact {}", std::to_string(*instant.impact + 1)) + ": " + strength_text(run, impact, options);
    if (run.problem.gaps.size() > 1) {
      what += ", " + gap_name(run.problem, run.problem.gaps[contact_at(run.problem, impact.point).gap]);
    }
  }
  return fmt::format("t = {:.4f} s{}{}, {}, {}", instant.time, between, what, level_text(run, *instant.point, options),
                     along_text(run, *instant.point));
}

}  // namespace

Figure scene_figure(const PlanRun& run, const FigureOptions& options) {
  const PlanInstant instant = telling_instant(run.response, asked_points(run, options));
  PlanPicture picture(run, instant, options);
  const std::string factor = word(options, "magnified {} times", number(picture.magnification()));
  return {.title = "The buildings from above at one instant: " + instant_text(run, instant, options, ", "),
          .finding = instant_text(run, instant, options, ", "),
          .part = picture.key_of_names(),
          .panels = {picture.panel(instant_text(run, instant, options, ", " + factor + "; "), 0.8 * options.width)},
          .width = options.width};
}

}  // namespace bentur
