#pragma once

#include <string>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

/// What figures need of histories.nc, in the words of its documentation.
struct RunData {
  struct Building {
    std::string name;
    double base = 0;                              ///< elevation [length]
    std::vector<double> elevations;               ///< [length]
    std::vector<double> peaks, peaks_no_contact;  ///< [length], per floor
    std::vector<double> periods;                  ///< [s], per mode
    std::vector<double> shapes;                   ///< modes × floors, the largest of each mode 1
  };
  struct Point {
    std::size_t left = 0;  ///< index of the left building
    std::size_t left_floor = 0, right_floor = 0;
    double elevation = 0, width = 0;  ///< [length]
  };
  struct Impact {
    std::size_t point = 0;
    double start = 0, end = 0, peak_force = 0, peak_force_time = 0;
  };

  explicit RunData(const NetcdfReader& results);

  /// The point the options ask for: hit hardest, or, where nothing is hit, nearest to it.
  [[nodiscard]] std::size_t point(const FigureOptions& options) const;
  /// Indices of the buildings to be shown beside one another: all, or of more than six the two at the point.
  [[nodiscard]] std::vector<std::size_t> shown(const FigureOptions& options) const;
  /// The hardest impact of a point; nullptr without one.
  [[nodiscard]] const Impact* hardest(std::size_t point) const;
  /// One column of a table of histories.
  [[nodiscard]] std::vector<double> history(const std::string& variable, std::size_t column) const;
  /// "300 cm".
  [[nodiscard]] std::string place(std::size_t point) const;
  /// "Model 1 | Model 2, elevation 300 cm".
  [[nodiscard]] std::string point_name(std::size_t point) const;

  const NetcdfReader& results;
  std::string length, force;  ///< units as they are read
  std::vector<Building> buildings;
  std::vector<Point> points;
  std::vector<Impact> impacts;
  std::vector<double> time;
};

// The figures of a run, one for each kind.
[[nodiscard]] Figure displacement_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure opening_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure force_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure impact_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure loop_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure envelope_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure amplification_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure modes_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure energy_figure(const RunData& run, const FigureOptions& options);
[[nodiscard]] Figure run_spectrum_figure(const RunData& run, const FigureOptions& options);

/// Line, mark and tone of curve number `index` of several that must be told apart; marks for few points alone.
void tell_apart(Curve& curve, std::size_t index);
[[nodiscard]] Mark mark_of(std::size_t index);

}  // namespace bentur
