#pragma once

#include <string>
#include <vector>

#include "bentur/io/results/internal/figure_list.h"
#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/model/plan/plan_row.h"

namespace bentur {

/// What figures of buildings in plan show beyond the histories, as those of a row have it: `Run` is a PlanRun, const
/// where it is written. Frames stand as buildings do, by the name of theirs and of their plane.
template <class File, class Run>
void plan_figures(File& file, Run& run, const std::string& length, const std::string& force) {
  struct Data {  // as FigureList takes it; what is written stays where it is
    decltype((run.closer.floors)) floor_spectra;
    decltype((run.closer.frames)) frames;
  } data{run.closer.floors, run.closer.frames};
  const Problem row = row_of(run.problem);
  FigureList<File, Data>(file, data, row.buildings, length, force).floor_spectra();
  std::vector<Building> frames;
  for (const PlanFramePlace& place : frames_with_members(run.c, run.problem)) {
    frames.emplace_back().name = frame_name(run.problem, place);
  }
  FigureList<File, Data>(file, data, frames, length, force).frames();
}

}  // namespace bentur
