#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace bentur {

/// One contact of one point from touching to parting.
struct Impact {
  int point = 0;                ///< index into Problem::points
  double start = 0;             ///< [s]
  double end = 0;               ///< [s]; the end of the analysis where `open_ended`
  bool open_ended = false;      ///< still closed when the analysis ended
  double closing_speed = 0;     ///< −ġ at the start [length/s]
  double separation_speed = 0;  ///< ġ at the end [length/s]
  double peak_force = 0;        ///< [force]
  double peak_force_time = 0;   ///< [s]
  double peak_penetration = 0;  ///< [length]
  double impulse = 0;           ///< ∫F dt [force·s]
  double energy_lost = 0;       ///< [force·length]
};

/// Extrema of the continuous response of one building; each list bottom to top, one entry per floor or storey.
struct BuildingPeaks {
  Eigen::VectorXd displacement;             ///< max |x| relative to the own base [length]
  Eigen::VectorXd displacement_no_contact;  ///< the same with contact switched off
  Eigen::VectorXd drift_ratio;              ///< max relative floor displacement over storey height [-]
  Eigen::VectorXd acceleration;             ///< max |ẍ + a_g| [length/s²]
  Eigen::VectorXd storey_shear;             ///< max |Σ_{floors ≥ j} (K x)| [force]
};

/// Totals of one contact point over the run.
struct PointSummary {
  double minimum_gap_no_contact = 0;  ///< max(0, max over time of x_left − x_right) in the free response [length]
  int impacts = 0;
  double contact_duration = 0;            ///< [s]
  double peak_force = 0;                  ///< [force]
  std::optional<double> peak_force_time;  ///< [s]
  double peak_penetration = 0;            ///< [length]
  double peak_closing_speed = 0;          ///< [length/s]
  double impulse = 0;                     ///< [force·s]
  double energy_lost = 0;                 ///< [force·length]
};

/// Samples for plots; never used to find a peak. One column per sample time.
struct Histories {
  std::vector<double> time;                   ///< [s]
  std::vector<Eigen::MatrixXd> displacement;  ///< per building, floors × samples [length]
  std::vector<Eigen::MatrixXd> velocity;      ///< [length/s]
  std::vector<Eigen::MatrixXd> acceleration;  ///< absolute [length/s²]
  std::vector<double> ground_acceleration;    ///< of the motion without delay [length/s²]
  Eigen::MatrixXd opening;                    ///< points × samples [length]
  Eigen::MatrixXd force;                      ///< points × samples [force]
};

enum class Status { done, stopped, failed };

struct Response {
  Status status = Status::done;
  std::string message;   ///< why and when, unless done
  long steps = 0;        ///< intervals over which the solution was advanced (with contact)
  long events = 0;       ///< contacts closed or opened
  double wall_time = 0;  ///< of the solution alone [s]
  std::vector<BuildingPeaks> buildings;
  std::vector<PointSummary> points;
  std::vector<Impact> impacts;  ///< by start, then point
  Histories histories;          ///< empty unless asked for
};

}  // namespace bentur
