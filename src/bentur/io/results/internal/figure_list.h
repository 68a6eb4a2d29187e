#pragma once

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
  using Pass::each, Pass::file_, Pass::fit, Pass::made, Pass::pass, Pass::single;

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
