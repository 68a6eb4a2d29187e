#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bentur/io/results/internal/variable_pass.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// What figures show beyond the histories: `Data` is FigureData, const where it is written.
template <class File, class Data>
class FigureList : private VariablePass<File> {
  using Pass = VariablePass<File>;
  using Pass::each, Pass::file_, Pass::fit, Pass::made, Pass::named, Pass::pass, Pass::single;

 public:
  FigureList(File& file, Data& figures, const std::vector<Building>& buildings, std::string length, std::string force)
      : Pass(file),
        figures_(figures),
        buildings_(buildings),
        length_(std::move(length)),
        force_(std::move(force)),
        moment_(force_ + " " + length_) {}

  void all() {
    close_up();
    spectrum();
    nearest_floor();
    floor_spectra();
    frames();
  }

  void floor_spectra() {
    auto& spectra = figures_.floor_spectra;
    if (!file_.has("floor_spectrum_period", !spectra.floors.empty())) return;
    const ResultDimension period = file_.dimension({"floor_spectrum_period", spectra.periods.size()});
    const ResultDimension floor = file_.dimension({"floor_spectrum", spectra.floors.size()});
    fit(spectra.floors, floor.size);
    pass({"floor_spectrum_period", {period}, "s", "period of linear oscillators on floors"}, spectra.periods);
    single({"floor_spectrum_damping", {}, "1", "damping ratio of linear oscillators on floors"}, spectra.damping);
    named({"floor_spectrum_building", {floor}, "", "buildings of the floors with a spectrum"}, spectra.floors,
          &FloorSpectra::Floor::building, buildings_);
    std::vector<int> floors;
    for (const auto& one : spectra.floors) floors.push_back(static_cast<int>(one.floor));
    made({"floor_spectrum_floor", {floor}, "", "their numbers, counted from 0"}, floors);
    if constexpr (File::reads) {
      for (std::size_t i = 0; i < floors.size(); ++i) spectra.floors[i].floor = floors[i];
    }
    Eigen::MatrixXd along(2, static_cast<Eigen::Index>(floor.size));
    for (std::size_t i = 0; i < spectra.floors.size(); ++i)
      along.col(static_cast<Eigen::Index>(i)) = spectra.floors[i].along;
    if (file_.has("floor_spectrum_along", !along.isZero(0))) {
      made({"floor_spectrum_along",
            {floor, {"floor_spectrum_component", 2}},
            "1",
            "directions along x and y, of length 1, of their motion"},
           along);
      if constexpr (File::reads) {
        for (std::size_t i = 0; i < spectra.floors.size(); ++i)
          spectra.floors[i].along = along.col(static_cast<Eigen::Index>(i));
      }
    }
    const auto spectrum = [&](const std::string& suffix, const std::string& what, auto member) {
      std::vector<double> values;
      for (const auto& one : spectra.floors) {
        values.insert(values.end(), (one.*member).begin(), (one.*member).end());
      }
      made({"floor_spectrum_acceleration" + suffix,
            {floor, period},
            length_ + " s-2",
            "spectral pseudo-acceleration of floors" + what},
           values);
      if constexpr (File::reads) {
        for (std::size_t i = 0; i < floors.size(); ++i) {
          const auto from = values.begin() + static_cast<std::ptrdiff_t>(i * period.size);
          (spectra.floors[i].*member).assign(from, from + static_cast<std::ptrdiff_t>(period.size));
        }
      }
    };
    spectrum("", "", &FloorSpectra::Floor::with_contact);
    spectrum("_no_contact", " without contact", &FloorSpectra::Floor::without_contact);
  }

  void frames() {
    for (std::size_t b = 0; b < buildings_.size(); ++b) {
      const Eigen::Index building = static_cast<Eigen::Index>(b);
      const auto found = std::find_if(figures_.frames.begin(), figures_.frames.end(),
                                      [&](const FrameForces& one) { return one.building == building; });
      if (!file_.has(fmt::format("member_time_{}", b + 1), found != figures_.frames.end())) continue;
      if constexpr (File::reads) {
        frame(figures_.frames.emplace_back(FrameForces{.building = building}), fmt::format("_{}", b + 1));
      } else {
        frame(*found, fmt::format("_{}", b + 1));
      }
    }
  }

 private:
  void close_up() {
    auto& found = figures_.close_up;
    if (!file_.has("close_up_time", found.has_value())) return;
    if constexpr (File::reads) found.emplace();
    const ResultDimension time = file_.dimension({"close_up_time", found->time.size()});
    single({"close_up_impact", {}, "", "number of the impact shown, counted from 0"}, found->impact);
    pass({"close_up_time", {time}, "s", "time of the samples of one impact"}, found->time);
    pass({"close_up_opening", {time}, length_, "opening of its contact point"}, found->opening);
    pass({"close_up_force", {time}, force_, "force of its contact point"}, found->force);
  }

  void spectrum() {
    if (!file_.has("spectrum_period", !figures_.spectrum.empty())) return;
    const ResultDimension period = file_.dimension({"spectrum_period", figures_.spectrum_periods.size()});
    fit(figures_.spectrum, period.size);
    pass({"spectrum_period", {period}, "s", "period of linear oscillators"}, figures_.spectrum_periods);
    single({"spectrum_damping", {}, "1", "damping ratio of linear oscillators"}, figures_.spectrum_damping);
    each({"spectrum_displacement", {period}, length_, "spectral displacement of the ground motion"}, figures_.spectrum,
         &OscillatorPeaks::displacement);
    each({"spectrum_acceleration", {period}, length_ + " s-2", "spectral pseudo-acceleration of the ground motion"},
         figures_.spectrum, &OscillatorPeaks::pseudo_acceleration);
  }

  /// Of the watched floor that comes nearest to what it faces.
  void nearest_floor() {
    auto& nearest = figures_.nearest;
    if (!file_.has("watched_floor_of", nearest.has_value())) return;
    if constexpr (File::reads) nearest.emplace();
    const std::string which = " the floor that comes nearest to what it faces without a contact that is modelled";
    const auto building = [&](const std::string& name, const std::string& what, auto& of) {
      std::vector<std::string> names;
      if constexpr (!File::reads) names = {buildings_.at(of).name};
      made({name, {}, "", what + which}, names);
      if constexpr (File::reads) of = number_of(names.front(), name);
    };
    building("watched_left", "building to the left of", nearest->left);
    building("watched_right", "building to the right of", nearest->right);
    building("watched_floor_of", "building with", nearest->floor_of);
    std::vector<int> floor = {static_cast<int>(nearest->floor)}, faces = {nearest->faces_floor ? 1 : 0},
                     closes = {nearest->closes ? 1 : 0};
    made({"watched_floor", {}, "", "number, counted from 0, of" + which}, floor);
    made({"watched_faces_floor", {}, "", "1: a floor, 0: a column, is what is faced by" + which}, faces);
    made({"watched_closes", {}, "", "1: is inside what it faces for some time," + which}, closes);
    single({"watched_elevation", {}, length_, "elevation of" + which}, nearest->elevation);
    single({"watched_width", {}, length_, "gap at rest of" + which}, nearest->width);
    single({"watched_least_opening", {}, length_, "least opening, negative inside what it faces, of" + which},
           nearest->least_opening);
    single({"watched_least_time", {}, "s", "time of the least opening of" + which}, nearest->least_time);
    if constexpr (File::reads) {
      nearest->floor = floor.front();
      nearest->faces_floor = faces.front() != 0;
      nearest->closes = closes.front() != 0;
      nearest->gap = nearest->left;
    }
    const ResultDimension time = file_.dimension({"watched_time", nearest->time.size()});
    pass({"watched_time", {time}, "s", "instants joined by straight lines of the opening of" + which}, nearest->time);
    pass({"watched_opening", {time}, length_, "opening, negative inside what it faces, of" + which}, nearest->opening);
  }

  template <class Frame>
  void frame(Frame& of, const std::string& number) {
    const std::string owner = fmt::format(" the members of building \"{}\"", buildings_[of.building].name);
    const ResultDimension members = file_.dimension({"member" + number, of.members.size()});
    fit(of.members, members.size);
    const ResultDimension station = file_.dimension({"member_station", std::size(MemberForces::stations)});
    single({"member_time" + number, {}, "s", "instant of the forces in" + owner}, of.time);
    std::vector<std::string> kinds;
    std::vector<int> levels, numbers;
    for (const FrameMember& member : of.members) {
      kinds.emplace_back(member.of_beam ? "beam" : "column");
      levels.push_back(static_cast<int>(member.level));
      numbers.push_back(static_cast<int>(member.number));
    }
    made({"member_kind" + number, {members}, "", "column or beam, of" + owner}, kinds);
    made({"member_level" + number, {members}, "", "storeys of columns, floors of beams, of" + owner}, levels);
    made({"member_number" + number, {members}, "", "lines of columns, bays of beams, of" + owner}, numbers);
    if constexpr (File::reads) {
      for (std::size_t n = 0; n < kinds.size(); ++n) {
        of.members[n].of_beam = kinds[n] == "beam";
        of.members[n].level = levels[n];
        of.members[n].number = numbers[n];
      }
    }
    each({"member_from" + number,
          {members},
          length_,
          "lower ends above the base, left ends from the left line, of" + owner},
         of.members, &FrameMember::from);
    each({"member_to" + number, {members}, length_, "upper and right ends of" + owner}, of.members, &FrameMember::to);
    each({"member_place" + number, {members}, length_, "columns from the left line, beams above the base, of" + owner},
         of.members, &FrameMember::place);
    const auto forces = [&](const std::string& suffix, const std::string& what, auto& one) {
      const std::string name = suffix + number, all = what + owner;
      pass({"member_moment" + name, {members, station}, moment_, "moment at quarters of the length" + all},
           one.moments);
      pass({"member_shear" + name, {members}, force_, "shear" + all}, one.shears);
      pass({"member_axial" + name, {members}, force_, "compression, NaN of beams," + all}, one.axial);
    };
    forces("", " at that instant, of", of.instant);
    forces("_max", ", largest over the run, of", of.most);
    forces("_min", ", least over the run, of", of.least);
    forces("_max_no_contact", ", largest without contact, of", of.most_without_contact);
    forces("_min_no_contact", ", least without contact, of", of.least_without_contact);
  }

  Eigen::Index number_of(const std::string& name, const std::string& variable) const {
    const auto found =
        std::find_if(buildings_.begin(), buildings_.end(), [&](const Building& one) { return one.name == name; });
    if constexpr (File::reads) {
      if (found == buildings_.end()) file_.source.fail(variable + " names no building of it");
    }
    return found - buildings_.begin();
  }

  Data& figures_;
  const std::vector<Building>& buildings_;
  std::string length_, force_, moment_;
};

}  // namespace bentur
