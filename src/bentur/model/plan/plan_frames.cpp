#include "bentur/model/plan/plan_frames.h"

#include <algorithm>

namespace bentur {

using Eigen::Index;

std::string frame_name(const PlanProblem& problem, const PlanFramePlace& place) {
  const PlanBuilding& building = problem.buildings[place.building];
  return building.name + ", " + building.model.planes[place.plane].name;
}

Index hinges_before(const PlanModel& model, Index plane) {
  Index before = 0;
  for (Index p = 0; p < plane; ++p) before += std::ssize(model.planes[p].hinges.places);
  return before;
}

std::vector<PlanFramePlace> frames_that_yield(const PlanProblem& problem) {
  std::vector<PlanFramePlace> places;
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const std::vector<PlanModel::Plane>& planes = problem.buildings[b].model.planes;
    for (Index p = 0; p < std::ssize(planes); ++p) {
      if (planes[p].hinges.size() > 0 || !planes[p].infills.empty()) places.push_back({b, p});
    }
  }
  return places;
}

RunResults frames_of(const PlanRun& run) { return frames_of(run, frames_that_yield(run.problem)); }

RunResults frames_of(const PlanRun& run, const std::vector<PlanFramePlace>& places) {
  RunResults frames;
  frames.c.title = run.c.title;
  frames.c.units = run.c.units;
  frames.c.analysis = run.c.analysis;
  frames.problem.duration = run.problem.duration;
  frames.response.status = run.response.status;
  frames.response.collapse_no_contact = run.response.collapse_no_contact;
  frames.response.points = run.response.points;  // by whose forces units are shown
  frames.response.histories.time = run.response.histories.time;
  double largest = 0;  // storey shear, likewise
  for (const PlanPeaks& peaks : run.response.buildings) {
    for (const Eigen::VectorXd* const list : {&peaks.shear_x, &peaks.shear_y}) {
      if (list->size() > 0) largest = std::max(largest, list->maxCoeff());
    }
  }
  for (const PlanFramePlace& place : places) {
    const Index b = place.building, p = place.plane;
    const PlanModel& model = run.problem.buildings[b].model;
    const PlanModel::Plane& plane = model.planes[p];
    Building& building = frames.problem.buildings.emplace_back();
    building.name = frame_name(run.problem, place);
    building.model.elevations = model.elevations;
    building.model.storey_heights = model.storey_heights;
    building.model.floor_masses = model.floor_masses;
    building.model.slab = model.slab;
    building.model.stiffness_factor = model.stiffness_factor;
    building.model.hinges = plane.hinges;
    building.model.infills = plane.infills;
    building.modes.omega = run.problem.buildings[b].modes.omega;
    building.bays = plane.bays;
    const PlanPeaks& of = run.response.buildings[b];
    BuildingPeaks& peaks = frames.response.buildings.emplace_back(of.planes[p].frame);
    peaks.drift_ratio = of.planes[p].drift_ratio;
    peaks.storey_shear.setConstant(model.floors(), largest);
    Histories& histories = frames.response.histories;
    const Index hinges = std::ssize(plane.hinges.places);
    const Index before = hinges_before(model, p);
    const bool known = b < std::ssize(run.response.histories.hinge_moment) &&
                       run.response.histories.hinge_moment[b].rows() >= before + hinges;
    const auto rows = [&](const std::vector<Eigen::MatrixXd>& list) {
      return known ? Eigen::MatrixXd(list[b].middleRows(before, hinges)) : Eigen::MatrixXd();
    };
    histories.hinge_moment.push_back(rows(run.response.histories.hinge_moment));
    histories.hinge_rotation.push_back(rows(run.response.histories.hinge_rotation));
    const Index samples = std::ssize(histories.time);
    histories.displacement.emplace_back(
        Eigen::MatrixXd::Zero(model.floors(), samples));  // of pictures: it stands still
    for (auto* const list : {&histories.node_displacement, &histories.foundation}) list->emplace_back(0, samples);
  }
  return frames;
}

}  // namespace bentur
