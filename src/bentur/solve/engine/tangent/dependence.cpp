#include "bentur/solve/engine/tangent/dependence.h"

#include <algorithm>
#include <numbers>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// C = M Φ D Φᵀ M.
MatrixXd damping_matrix(const Body& body) {
  const MatrixXd shapes = body.mass * body.modes.shapes;
  return shapes * body.modal_damping * shapes.transpose();
}

bool is_of_same_body(const BodyRow& a, const BodyRow& b) {
  return a.body == b.body && a.row.size() == b.row.size() && a.ground.size() == b.ground.size();
}

/// Contacts of a meeting stay what they are of it.
bool are_of_same_meetings(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contact& x, const Contact& y) {
    return x.place.meeting == y.place.meeting && x.place.family == y.place.family && x.place.seam == y.place.seam;
  });
}

template <class List>
bool are_of_same_bodies(const List& a, const List& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return is_of_same_body(x.at.left, y.at.left) && is_of_same_body(x.at.right, y.at.right);
  });
}

/// Whether numbers change as much below as above, as far as round-off lets that be seen.
bool changes_evenly(const VectorXd& below, const VectorXd& here, const VectorXd& above) {
  constexpr double uneven = 1e-3, round_off = 1e-12;
  const VectorXd change = above - below;
  return ((above - here) - (here - below)).lpNorm<Eigen::Infinity>() <=
         uneven * change.lpNorm<Eigen::Infinity>() + round_off * here.lpNorm<Eigen::Infinity>();
}

/// Where a contact or joint is: its rows, and the width of a contact.
bool moves_evenly(const BodyRow& below, const BodyRow& here, const BodyRow& above) {
  return changes_evenly(below.row, here.row, above.row) && changes_evenly(below.ground, here.ground, above.ground);
}

bool moves_evenly(const Interface& below, const Interface& here, const Interface& above) {
  return moves_evenly(below.left, here.left, above.left) && moves_evenly(below.right, here.right, above.right);
}

/// Contacts stand at corners: where two of them are at one place, it moves otherwise one way than the other.
bool moves_evenly(const System& system, const Variation& by) {
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const auto width = [](const Contact& contact) { return VectorXd::Constant(1, contact.width); };
    const Contact &below = by.below.contacts[i], &here = system.contacts[i], &above = by.above.contacts[i];
    if (!moves_evenly(below.at, here.at, above.at)) return false;
    if (!changes_evenly(width(below), width(here), width(above))) return false;
  }
  for (std::size_t i = 0; i < system.joints.size(); ++i) {
    if (!moves_evenly(by.below.joints[i].at, system.joints[i].at, by.above.joints[i].at)) return false;
  }
  return true;
}

/// The input of a harmonic motion a time after it has begun.
GroundInput harmonic_input(const HarmonicMotion& motion, double time) {
  constexpr double round_off = 1e-9;
  if (time < -round_off * motion.period) return {};
  const double nu = 2.0 * std::numbers::pi / motion.period;
  const double peak = motion.displacement_amplitude * nu * nu;
  const bool sine = motion.phase == HarmonicMotion::Phase::sine;
  return (sine ? GroundInput{0.0, -peak * nu} : GroundInput{-peak, 0.0}).later(time, nu);
}

bool differ(const GroundMotion& a, const GroundMotion& b) {
  if (const auto* sampled = std::get_if<SampledMotion>(&a)) return !(*sampled == std::get<SampledMotion>(b));
  const auto* one = std::get_if<HarmonicMotion>(&a);
  if (one == nullptr) return false;
  const auto& other = std::get<HarmonicMotion>(b);
  return one->period != other.period || one->displacement_amplitude != other.displacement_amplitude;
}

}  // namespace

std::optional<std::string> trouble_of(const System& system, const Variation& by) {
  for (const System* other : {&by.below, &by.above}) {
    if (other->bodies.size() != system.bodies.size()) return "changes the number of buildings";
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
      if (other->bodies[b].dofs() != system.bodies[b].dofs()) return "changes the floors of a building";
      if (other->bodies[b].modes.omega.size() != system.bodies[b].modes.omega.size())
        return "changes a building's modes";
    }
    if (!are_of_same_bodies(system.contacts, other->contacts) ||
        !are_of_same_meetings(system.contacts, other->contacts) || !are_of_same_bodies(system.joints, other->joints)) {
      return "changes where buildings touch";
    }
    if (other->motions.size() != system.motions.size()) return "changes the number of motions";
    for (std::size_t c = 0; c < system.motions.size(); ++c) {
      const GroundMotion &one = system.motions[c], &moved = other->motions[c];
      if (one.index() != moved.index()) return "changes the kind of motion";
      const auto* sampled = std::get_if<SampledMotion>(&one);
      if (sampled == nullptr) continue;
      const auto& samples = std::get<SampledMotion>(moved);
      if (samples.time_step != sampled->time_step || samples.acceleration.size() != sampled->acceleration.size()) {
        return "changes the time step of a record";
      }
    }
  }
  if (!moves_evenly(system, by)) return "moves the places where buildings touch otherwise one way than the other";
  return std::nullopt;
}

Dependence::Dependence(const System& system, const ModalSystem& modal)
    : system_(&system),
      bodies_(system.bodies.size()),
      rows_(modal.elements.size()),
      initial_q_(MatrixXd::Zero(modal.size, 0)),
      initial_v_(MatrixXd::Zero(modal.size, 0)),
      offsets_(MatrixXd::Zero(std::ssize(modal.elements), 0)),
      nu_(MatrixXd::Zero(modal.components(), 0)),
      delays_(MatrixXd::Zero(std::ssize(system.bodies), 0)) {}

Dependence::Dependence(const System& system, const ModalSystem& modal, const std::vector<Variation>& variations)
    : Dependence(system, modal) {
  count_ = std::ssize(variations);
  variations_ = &variations;
  for (MatrixXd* of : {&initial_q_, &initial_v_, &offsets_, &nu_, &delays_}) of->setZero(of->rows(), count_);
  for (Index p = 0; p < count_; ++p) {
    const Variation& by = variations[p];
    take_bodies(system, modal, by, p);
    take_rows(system, modal, by, p);
    for (std::size_t i = 0; i < system.contacts.size(); ++i) {
      offsets_(static_cast<Index>(i), p) = -(by.above.contacts[i].width - by.below.contacts[i].width) / (2.0 * by.step);
    }
    take_motion(system, by, p);
  }
  moves_delays_ = !delays_.isZero(0.0);
  moves_nu_ = !nu_.isZero(0.0);
}

void Dependence::take_bodies(const System& system, const ModalSystem& modal, const Variation& by, Index p) {
  const double rate = 1.0 / (2.0 * by.step);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body &body = system.bodies[b], &below = by.below.bodies[b], &above = by.above.bodies[b];
    const Index n = modal.blocks[b].modes, begin = modal.blocks[b].begin, ways = modal.components();
    if (n == 0) continue;
    const MatrixXd& shapes = body.modes.shapes;
    const auto over = [&](const MatrixXd& more, const MatrixXd& less) -> MatrixXd {
      return shapes.transpose() * (rate * (more - less)) * shapes;
    };
    MatrixXd block(n, 3 * n + ways);
    block << -over(above.mass, below.mass), -over(above.stiffness, below.stiffness),
        -over(damping_matrix(above), damping_matrix(below)), -(shapes.transpose() * (rate * (above.load - below.load)));
    // Rebuilt damping has round-off of its own where nothing differs.
    if (above.modal_damping == below.modal_damping && above.modes.shapes == below.modes.shapes &&
        above.mass == below.mass) {
      block.middleCols(2 * n, n).setZero();
    }
    if (!block.isZero(0.0)) {
      OfBody& of = bodies_[b];
      of.parameters.push_back(p);
      of.matrices.conservativeResize(of.matrices.rows() + n, block.cols());
      of.matrices.bottomRows(n) = block;
    }
    const auto start = [&](const std::vector<VectorXd>& more, const std::vector<VectorXd>& less, MatrixXd& to) {
      if (more.empty()) return;
      to.col(p).segment(begin, n) = shapes.transpose() * (body.mass * (rate * (more[b] - less[b])));
    };
    start(by.above.initial_displacement, by.below.initial_displacement, initial_q_);
    start(by.above.initial_velocity, by.below.initial_velocity, initial_v_);
  }
}

void Dependence::take_rows(const System& system, const ModalSystem& modal, const Variation& by, Index p) {
  const double rate = 1.0 / (2.0 * by.step);
  const auto take = [&](Index element, const Interface& below, const Interface& above) {
    OfRow of{p, VectorXd::Zero(modal.size), VectorXd::Zero(modal.size)};
    for (const auto& [less, more] : {std::pair(&below.left, &above.left), std::pair(&below.right, &above.right)}) {
      if (more->body < 0) continue;
      const ModalSystem::Block& block = modal.blocks[more->body];
      const VectorXd moved = system.bodies[more->body].modes.shapes.transpose() * (rate * (more->row - less->row));
      of.row.segment(block.begin, block.modes) += moved;
      of.push.segment(block.begin, block.modes) -= moved;
      of.row.segment(block.begin + block.modes, more->ground.size()) += rate * (more->ground - less->ground);
    }
    if (!of.row.isZero(0.0)) rows_[element].push_back(std::move(of));
  };
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    take(static_cast<Index>(i), by.below.contacts[i].at, by.above.contacts[i].at);
  }
  for (std::size_t i = 0; i < system.joints.size(); ++i) {
    take(modal.joint(static_cast<Index>(i)), by.below.joints[i].at, by.above.joints[i].at);
  }
}

void Dependence::take_motion(const System& system, const Variation& by, Index p) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    delays_(static_cast<Index>(b), p) = (by.above.delay(b) - by.below.delay(b)) / (2.0 * by.step);
  }
  bool moves = false, sampled = false;
  for (std::size_t c = 0; c < system.motions.size(); ++c) {
    moves = moves || differ(by.above.motions[c], by.below.motions[c]);
    sampled = sampled || std::holds_alternative<SampledMotion>(system.motions[c]);
    nu_(static_cast<Index>(c), p) =
        (angular_frequency(by.above.motions[c]) - angular_frequency(by.below.motions[c])) / (2.0 * by.step);
  }
  if (!moves) return;
  Moved moved{p, by.step, nullptr, nullptr};
  if (sampled) {
    moved.below = std::make_unique<TimeGrid>(by.below);
    moved.above = std::make_unique<TimeGrid>(by.above);
  }
  moved_.push_back(std::move(moved));
}

Dependence::Laws Dependence::laws(Index element, Index parameter) const {
  const Variation& by = (*variations_)[parameter];
  const Index contacts = std::ssize(system_->contacts);
  const auto law = [&](const System& of) {
    return element < contacts ? of.contacts[element].law.get() : of.joints[element - contacts].law.get();
  };
  return {law(by.below), law(by.above), by.step};
}

bool Dependence::inputs(long segment, double time, const std::vector<GroundInput>& inputs, MatrixXd& values,
                        MatrixXd& slopes) const {
  const Index ways = nu_.rows();
  const bool moves = moves_delays_ || !moved_.empty();
  if (!moves && values.cols() == count_ && values.rows() == std::ssize(inputs)) return false;
  values.setZero(std::ssize(inputs), count_);
  slopes.setZero(std::ssize(inputs), count_);
  for (Index b = 0; moves_delays_ && b < delays_.rows(); ++b) {
    for (Index c = 0; c < ways; ++c) {
      const GroundInput& input = inputs[b * ways + c];
      const double nu = angular_frequency(system_->motions[c]);
      values.row(b * ways + c) = -input.slope * delays_.row(b);
      slopes.row(b * ways + c) = nu * nu * input.value * delays_.row(b);
    }
  }
  std::vector<GroundInput> below, above;
  for (const Moved& moved : moved_) {
    const Variation& by = (*variations_)[moved.parameter];
    if (moved.above) {
      moved.below->input(segment, below);
      moved.above->input(segment, above);
    } else {
      below.assign(inputs.size(), {});
      above = below;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const std::size_t c = i % ways;
      if (const auto* harmonic = std::get_if<HarmonicMotion>(&by.below.motions[c])) {
        const double since = time - system_->delay(i / ways);
        below[i] = harmonic_input(*harmonic, since);
        above[i] = harmonic_input(std::get<HarmonicMotion>(by.above.motions[c]), since);
      }
      values(static_cast<Index>(i), moved.parameter) += (above[i].value - below[i].value) / (2.0 * moved.step);
      slopes(static_cast<Index>(i), moved.parameter) += (above[i].slope - below[i].slope) / (2.0 * moved.step);
    }
  }
  return moves;
}

}  // namespace bentur::engine
