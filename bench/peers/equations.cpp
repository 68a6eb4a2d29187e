#include "bench/peers/equations.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace bentur::bench {
namespace {

/// Where a_g of any building changes its slope or jumps, with 0 and the end.
std::vector<double> breakpoints_of(const Problem& problem, const SampledMotion& motion) {
  std::vector<double> times{0, problem.duration};
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const double delay = delay_of(problem, b);
    for (std::size_t i = 0; i < motion.acceleration.size(); ++i) {
      const double time = delay + static_cast<double>(i) * motion.time_step;
      if (time > 0 && time < problem.duration) times.push_back(time);
    }
  }
  std::sort(times.begin(), times.end());
  const double same = 1e-9 * motion.time_step;
  times.erase(std::unique(times.begin(), times.end(), [same](double a, double b) { return b - a < same; }),
              times.end());
  times.back() = problem.duration;
  return times;
}

}  // namespace

Equations::Equations(const Problem& problem, double length)
    : buildings_(problem.buildings.size()), shift_(1e-14 * length) {
  const auto* motion = std::get_if<SampledMotion>(&problem.motion);
  if (motion == nullptr || problem.kinematics != Kinematics::relative || !problem.initial_displacement.empty() ||
      !problem.initial_velocity.empty()) {
    throw std::invalid_argument("the peers take a record, relative kinematics and a start at rest");
  }
  for (const Building& building : problem.buildings) {
    first_.push_back(modes_);
    const Eigen::Index count = building.modes.omega.size();
    const Eigen::VectorXd load = building.modes.shapes.transpose() * building.model.load;
    const Eigen::MatrixXd& damping = building.modal_damping;
    if (!damping.isDiagonal(1e-12)) throw std::invalid_argument("the peers take damping that does not couple modes");
    omega_.insert(omega_.end(), building.modes.omega.begin(), building.modes.omega.end());
    load_.insert(load_.end(), load.begin(), load.end());
    for (Eigen::Index i = 0; i < count; ++i) damping_.push_back(damping(i, i));
    modes_ += count;
    const double shape = building.modes.shapes.col(0).cwiseAbs().maxCoeff();
    scale_ = std::max(scale_, building.modes.omega(0) * length / shape);
  }
  first_.push_back(modes_);
  for (const ContactPoint& point : problem.points) {
    const LawParameters parameters = point.law->parameters();
    if (point.law->name() != "linear") throw std::invalid_argument("the peers take linear contact");
    const Eigen::Index left = point.left;
    Contact contact{first_[left], first_[left + 1], first_[left + 2], point.width, parameters.front().second, {}, {}};
    const Eigen::RowVectorXd of_left = -problem.buildings[left].modes.shapes.row(point.left_floor);
    const Eigen::RowVectorXd of_right = problem.buildings[left + 1].modes.shapes.row(point.right_floor);
    contact.sense.assign(of_left.begin(), of_left.end());
    contact.sense.insert(contact.sense.end(), of_right.begin(), of_right.end());
    for (std::size_t i = 0; i < contact.sense.size(); ++i) {
      contact.flexible.push_back(contact.sense[i] / omega_[contact.left + i]);
    }
    contacts_.push_back(std::move(contact));
  }
  breakpoints_ = breakpoints_of(problem, *motion);
  const double least_jump = 1e-9 * peak_acceleration(problem.motion);
  double step = 0;
  for (std::size_t j = 0; j + 1 < breakpoints_.size(); ++j) {
    const double begin = breakpoints_[j], before = step;
    step = breakpoints_[j + 1] - begin;
    bool jump = false;
    for (std::size_t b = 0; b < buildings_; ++b) {  // from within, as a_g may jump at the ends
      const double delay = delay_of(problem, b);
      const double early = acceleration_at(problem.motion, begin + 0.25 * step - delay);
      const double late = acceleration_at(problem.motion, begin + 0.75 * step - delay);
      inputs_.push_back({early - 0.5 * (late - early), 2 * (late - early) / step});
      if (j == 0) continue;
      const Input& last = inputs_[inputs_.size() - 1 - buildings_];
      jump = jump || std::abs(last.start + last.slope * before - inputs_.back().start) > least_jump;
    }
    jumps_.push_back(jump);
  }
  restart();
}

void Equations::restart() {
  closed_.assign(contacts_.size(), 0);
  interval_ = 0;
  peak_force_ = 0;
  impacts_ = evaluations_ = 0;
}

void Equations::derivative(double time, const double* y, double* rate) {
  ++evaluations_;
  const double* displacement = y;
  const double* speed = y + modes_;
  double* force = rate + modes_;
  const double since = time - breakpoints_[interval_];
  const Input* input = &inputs_[interval_ * buildings_];
  for (std::size_t b = 0; b < buildings_; ++b) {
    const double ground = input[b].start + input[b].slope * since;
    for (std::size_t i = first_[b]; i < first_[b + 1]; ++i) {
      rate[i] = omega_[i] * speed[i];
      force[i] = -omega_[i] * displacement[i] - damping_[i] * speed[i] - load_[i] * ground;
    }
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    if (closed_[c] == 0) continue;
    const Contact& contact = contacts_[c];
    const double push = -contact.stiffness * (opening(c, y) - shift_);
    for (std::size_t i = 0; i < contact.sense.size(); ++i) force[contact.left + i] += contact.sense[i] * push;
  }
}

double Equations::opening(std::size_t point, const double* y) const {
  const Contact& contact = contacts_[point];
  double sum = contact.width + shift_;
  for (std::size_t i = 0; i < contact.flexible.size(); ++i) sum += contact.flexible[i] * y[contact.left + i];
  return sum;
}

double Equations::opening_rate(std::size_t point, const double* y) const {
  const Contact& contact = contacts_[point];
  double sum = 0;
  for (std::size_t i = 0; i < contact.sense.size(); ++i) sum += contact.sense[i] * y[modes_ + contact.left + i];
  return sum;
}

void Equations::note_peak(std::size_t point, const double* y) {
  peak_force_ = std::max(peak_force_, -contacts_[point].stiffness * (opening(point, y) - shift_));
}

}  // namespace bentur::bench
