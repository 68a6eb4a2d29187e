#pragma once

#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "bentur/solve/engine/motion/series.h"
#include "bentur/solve/engine/run/elements.h"
#include "bentur/solve/engine/run/watch/peak_search.h"
#include "bentur/solve/engine/run/watch/span_watch.h"

namespace bentur::engine {

/// Goes over a segment of a run of many bodies island by island. An island is bodies that contacts with a force join;
/// each has a power series of its own, which lasts until an event changes a force on one of its bodies. So an event
/// costs what the bodies cost that it concerns, not what all do. Openings between islands are polynomials, too: of two
/// series that began at different times, one moved to the other's time.
///
/// The same events at the same times as by steps of all bodies, to round-off: steps are others.
class Islands {
 public:
  /// Fewer bodies are solved together.
  static constexpr std::size_t least_bodies = 8;
  /// Whether it can be asked of such bodies and contacts: there are no elements but contacts that do not rub and have
  /// forces, and no damping is full.
  [[nodiscard]] static bool serve(const ModalSystem& system, const ElementLaws& laws);

  struct Parts {
    Elements& elements;
    PeakSearch& peaks;
    SpanWatch& watched;
    double instant = 0;  ///< what is over so soon has not been [s]
    /// Before what changes at a time [s], or at the end of a segment.
    std::function<void(double)> before;
    std::function<bool()> go_on;  ///< before each event; false: it ends there
  };
  Islands(const ModalSystem& system, const ElementLaws& laws, Parts parts);

  /// Goes over a segment that begins with a state and inputs. How far it has come [s], and `state` is that there: not
  /// to the end where the force of some contact is not linear any more. Below zero where a number is not finite or
  /// events have no end, or go_on() said no.
  [[nodiscard]] double pass(double start, double length, const std::vector<GroundInput>& inputs, State& state);
  /// The state at a time [s] before which nothing more changes, for Parts::before, and the forces there.
  void evaluate(double time, State& state);
  /// Power series so far.
  [[nodiscard]] long steps() const { return steps_; }

 private:
  using Index = Eigen::Index;
  /// The power series of a body, from `start` on; times here are of the segment [s].
  struct Course {
    double start = 0, h = 0;
    int degree = 0;
    long version = 0;
    [[nodiscard]] double end() const { return start + h; }
  };
  /// Contacts between the same bodies, and watched openings likewise.
  struct Pair {
    Index left = 0, right = 0;  ///< the same where there is one alone
    std::vector<Index> contacts, watched;
    double start = 0, length = 0;  ///< over which their openings are looked at
  };
  /// What is to come next: of a contact the failing of a guard, or the end of a body's series.
  struct Next {
    double time = 0;
    Index element = 0;  ///< a contact; −1 − body
    std::size_t guard = 0;
    long version = 0;
    [[nodiscard]] bool operator<(const Next& other) const {
      return std::pair(time, element) > std::pair(other.time, other.element);  // the first is on top
    }
  };
  /// States of bodies at an instant, and how far their coordinates leave chords up to another one.
  struct Ends {
    State from, to;
    Eigen::VectorXd rise;
  };

  [[nodiscard]] const ModalSystem::Block& block(Index b) const { return system_->blocks[b]; }
  [[nodiscard]] bool presses(Index contact) const;
  [[nodiscard]] bool is_served(const Pair& pair) const;
  void place(Index body, double time, State& to) const;
  void look_ahead(const Pair& pair);
  [[nodiscard]] Polynomial deformation(const ModalSystem::Relation& of, double offset, const Pair& pair) const;
  [[nodiscard]] Polynomial side(Index body, Index begin, const Eigen::VectorXd& row, const Pair& pair) const;
  void open(Pair& pair, double time);
  void close(Pair& pair, double time);
  void close_watched(const Pair& pair, double time);
  void close(const std::vector<Index>& bodies, double time);
  void gather_islands(const std::vector<Index>& bodies);
  [[nodiscard]] bool expand(const std::vector<Index>& bodies, double time);
  [[nodiscard]] bool renew(const std::vector<Index>& bodies, double time);
  [[nodiscard]] bool go_on_from(const std::vector<Index>& bodies, double time);
  [[nodiscard]] std::vector<Pair*> pairs_of(const std::vector<Index>& bodies);
  [[nodiscard]] std::vector<Index> islands_of(std::initializer_list<Index> bodies) const;
  [[nodiscard]] bool change(const Next& next);
  void end_here(double time, State& state);

  const ModalSystem* system_;
  Parts parts_;
  Series series_;
  Expansion motion_;  ///< whose coefficients all courses have
  std::vector<double> offsets_;
  std::vector<Pair> pairs_;
  std::vector<std::size_t> pair_of_;               ///< per contact
  std::vector<std::vector<std::size_t>> of_body_;  ///< pairs
  std::vector<Course> courses_;                    ///< per body
  std::vector<Index> island_;                      ///< per body, one of its island
  std::vector<std::vector<Index>> islands_;        ///< bodies of the island of each such one
  std::vector<long> versions_;                     ///< per contact
  std::vector<char> stays_;                        ///< per contact, over what is looked at
  std::priority_queue<Next> queue_;
  double start_ = 0, length_ = 0;                ///< of the segment
  std::vector<GroundInput> inputs_, inputs_at_;  ///< at its start; scratch
  bool served_ = true;                           ///< whether forces have been linear so far
  long steps_ = 0, stamp_ = 0;
  std::vector<long> stamps_;  ///< per pair
  State from_, to_;           ///< at both ends of courses
  Eigen::VectorXd from_acceleration_, to_acceleration_, rise_, acceleration_rise_, bend_;
  State now_;
  Eigen::VectorXd now_acceleration_, part_, acceleration_part_, fourth_;  ///< scratch
  Ends ends_;                                                             ///< scratch
};

}  // namespace bentur::engine
