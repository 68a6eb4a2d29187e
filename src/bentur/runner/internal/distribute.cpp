#include "bentur/runner/internal/distribute.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "bentur/runner/internal/crew.h"

namespace bentur {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr double portion_seconds = 0.05;          // of work given to a thread at a time
constexpr std::size_t largest_portion = 4096;     // runs
constexpr std::size_t portions_ahead = 2;         // given to each thread, so that none waits
constexpr auto report_every = milliseconds(200);  // by other ranks, which also learns of a stop
constexpr auto sync_every = milliseconds(2000);
constexpr auto poll_every = microseconds(500);  // for messages, where there are other ranks
constexpr auto patience = milliseconds(3000);   // with other ranks after a stop

enum Tag : int { tag_report = 1, tag_order = 2 };

/// What another rank says: results, how many runs it wants, and whether it is leaving or has been told to stop.
struct Report {
  std::vector<RunResult> results;
  std::uint64_t wanted = 0;
  std::uint64_t leaving = 0;
  std::uint64_t stop = 0;
};

/// What rank 0 answers to each report but the last.
struct Order {
  RunNumbers runs;
  std::uint64_t end = 0;  // no more work
  std::uint64_t stop = 0;
};

/// Numbers and texts one behind the other; every rank runs the same program.
class Packer {
 public:
  void number(std::uint64_t n) { bytes_.append(reinterpret_cast<const char*>(&n), sizeof n); }
  void text(const std::string& t) {
    number(t.size());
    bytes_ += t;
  }
  void values(const std::vector<double>& v) {
    number(v.size());
    bytes_.append(reinterpret_cast<const char*>(v.data()), v.size() * sizeof(double));
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(const std::string& bytes) : bytes_(bytes) {}
  std::uint64_t number() {
    std::uint64_t n = 0;
    copy(&n, sizeof n);
    return n;
  }
  std::string text() {
    std::string t(number(), '\0');
    copy(t.data(), t.size());
    return t;
  }
  std::vector<double> values() {
    std::vector<double> v(number());
    copy(v.data(), v.size() * sizeof(double));
    return v;
  }

 private:
  void copy(void* to, std::size_t size) {
    if (bytes_.size() - at_ < size) throw std::runtime_error("a message of another rank is cut short");
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

std::string packed(const Report& report) {
  Packer packer;
  packer.number(report.wanted);
  packer.number(report.leaving);
  packer.number(report.stop);
  packer.number(report.results.size());
  for (const RunResult& result : report.results) {
    packer.number(result.run);
    packer.number(static_cast<std::uint64_t>(result.status));
    packer.text(result.message);
    packer.values(result.values);
  }
  return packer.take();
}

Report unpacked_report(const std::string& bytes) {
  Unpacker unpacker(bytes);
  Report report;
  report.wanted = unpacker.number();
  report.leaving = unpacker.number();
  report.stop = unpacker.number();
  for (std::uint64_t left = unpacker.number(); left > 0; --left) {
    RunResult result;
    result.run = unpacker.number();
    result.status = static_cast<RunStatus>(unpacker.number());
    result.message = unpacker.text();
    result.values = unpacker.values();
    report.results.push_back(std::move(result));
  }
  return report;
}

std::string packed(const Order& order) {
  Packer packer;
  packer.number(order.end);
  packer.number(order.stop);
  packer.number(order.runs.size());
  for (const std::size_t run : order.runs) packer.number(run);
  return packer.take();
}

Order unpacked_order(const std::string& bytes) {
  Unpacker unpacker(bytes);
  Order order;
  order.end = unpacker.number();
  order.stop = unpacker.number();
  for (std::uint64_t left = unpacker.number(); left > 0; --left) order.runs.push_back(unpacker.number());
  return order;
}

/// The threads of this process, kept in work by portions of about portion_seconds each.
class Team {
 public:
  Team(const StudyRuns& runs, const WorkOptions& options)
      : threads_(static_cast<std::size_t>(options.threads)),
        stop_(options.stop),
        crew_(options.threads, [&runs, this](const RunNumbers& portion) {
          return runs.solve(portion, [this] { return !stopping(); });
        }) {}

  [[nodiscard]] bool stopping() const { return told_ || (stop_ && stop_()); }
  void stop() { told_ = true; }

  /// How many runs it would take now.
  [[nodiscard]] std::size_t wanted() const {
    const std::size_t under_way = crew_.under_way();
    const std::size_t all = portions_ahead * threads_;
    return under_way >= all ? 0 : (all - under_way) * portion();
  }
  void give(const RunNumbers& runs) {
    const std::size_t each = std::min(portion(), (runs.size() + threads_ - 1) / threads_);
    for (std::size_t first = 0; first < runs.size(); first += each) {
      const auto begin = runs.begin() + static_cast<std::ptrdiff_t>(first);
      crew_.give({begin, begin + static_cast<std::ptrdiff_t>(std::min(each, runs.size() - first))});
    }
  }
  [[nodiscard]] bool idle() const { return crew_.under_way() == 0; }
  std::vector<RunResult> take(microseconds longest) {
    std::vector<RunResult> results = crew_.take(longest);
    solved_ += results.size();
    return results;
  }

 private:
  [[nodiscard]] std::size_t portion() const {
    if (solved_ == 0) return 1;
    const double elapsed = std::chrono::duration<double>(Clock::now() - began_).count();
    const double rate = static_cast<double>(solved_) / elapsed / static_cast<double>(threads_);
    return std::clamp(static_cast<std::size_t>(rate * portion_seconds), std::size_t{1}, largest_portion);
  }

  std::size_t threads_;
  std::function<bool()> stop_;
  std::atomic<bool> told_ = false;
  std::size_t solved_ = 0;
  Clock::time_point began_ = Clock::now();
  Crew crew_;  // last: its threads use the rest
};

/// Runs still to be handed out, in the order of the plan.
class Queue {
 public:
  Queue(const SweepPlan& plan, const Journal& journal, std::size_t takers)
      : plan_(plan), journal_(journal), takers_(takers), left_(plan.runs() - journal.done()) {}

  /// Up to `wanted` runs; towards the end fewer, so that all takers finish together.
  RunNumbers take(std::size_t wanted) {
    RunNumbers runs;
    const std::size_t share = std::max<std::size_t>(1, left_ / (2 * takers_));
    for (wanted = std::min(wanted, share); runs.size() < wanted && position_ < plan_.runs(); ++position_) {
      const std::size_t run = plan_.run_at(position_);
      if (!journal_.is_done(run)) runs.push_back(run);
    }
    left_ -= std::min(left_, runs.size());
    return runs;
  }
  [[nodiscard]] bool empty() const { return left_ == 0; }

 private:
  const SweepPlan& plan_;
  const Journal& journal_;
  std::size_t takers_;
  std::size_t left_;
  std::size_t position_ = 0;
};

class Lead {
 public:
  Lead(const StudyRuns& runs, Journal& journal, Ranks& ranks, const WorkOptions& options)
      : journal_(journal),
        ranks_(ranks),
        options_(options),
        team_(runs, options),
        queue_(runs.plan(), journal, static_cast<std::size_t>(ranks.size() * options.threads)),
        others_(ranks.size() - 1),
        all_(runs.plan().runs()) {}

  bool work() {
    while (!team_.stopping() && (journal_.done() < all_ || others_ > 0)) {
      if (const std::size_t wanted = team_.wanted(); wanted > 0 && !queue_.empty()) team_.give(queue_.take(wanted));
      step();
    }
    if (journal_.done() < all_) wind_down();
    journal_.sync();
    return journal_.done() == all_;
  }

 private:
  /// Takes and keeps what there is, and answers who asks.
  void step() {
    keep(team_.take(ranks_.size() > 1 ? microseconds(poll_every) : microseconds(milliseconds(100))));
    while (const auto message = ranks_.receive()) {
      const Report report = unpacked_report(message->bytes);
      keep(report.results);
      if (report.stop != 0) team_.stop();
      if (report.leaving != 0) {
        --others_;
        continue;
      }
      Order order;
      order.stop = team_.stopping() ? 1 : 0;
      if (order.stop == 0 && report.wanted > 0) order.runs = queue_.take(report.wanted);
      order.end = queue_.empty() ? 1 : 0;
      ranks_.send(message->from, tag_order, packed(order));
    }
    const auto now = Clock::now();
    if (now - synced_ > sync_every) {
      journal_.sync();
      synced_ = now;
    }
  }

  void keep(const std::vector<RunResult>& results) {
    for (const RunResult& result : results) journal_.write(result);
    if (options_.finished) options_.finished(journal_.done());
  }

  /// After a stop: what is solved is kept, here and where another rank still reports in time.
  void wind_down() {
    journal_.sync();
    const auto end = Clock::now() + patience;
    while (Clock::now() < end && (!team_.idle() || others_ > 0)) step();
    step();
  }

  Journal& journal_;
  Ranks& ranks_;
  const WorkOptions& options_;
  Team team_;
  Queue queue_;
  int others_;
  std::size_t all_;
  Clock::time_point synced_ = Clock::now();
};

}  // namespace

bool lead_work(const StudyRuns& runs, Journal& journal, Ranks& ranks, const WorkOptions& options) {
  return Lead(runs, journal, ranks, options).work();
}

void dismiss_work(Ranks& ranks) {
  for (int others = ranks.size() - 1; others > 0;) {
    const auto message = ranks.receive();
    if (!message) {
      std::this_thread::sleep_for(poll_every);
    } else if (unpacked_report(message->bytes).leaving != 0) {
      --others;
    } else {
      Order order;
      order.end = 1;
      ranks.send(message->from, tag_order, packed(order));
    }
  }
}

void follow_work(const StudyRuns& runs, Ranks& ranks, const WorkOptions& options) {
  Team team(runs, options);
  Report report;
  bool answered = true;  // each report but the last gets an answer, so neither side ever sends into the other's sending
  bool end = false;
  auto last = Clock::now() - report_every;
  for (;;) {
    std::vector<RunResult> results = team.take(poll_every);
    std::move(results.begin(), results.end(), std::back_inserter(report.results));
    if (const auto message = ranks.receive()) {
      Order order = unpacked_order(message->bytes);
      answered = true;
      end = order.end != 0;
      if (order.stop != 0) {
        team.stop();
        end = true;
      }
      if (!order.runs.empty()) team.give(order.runs);
    }
    if (!answered) continue;
    report.stop = team.stopping() ? 1 : 0;
    report.wanted = end || report.stop != 0 ? 0 : team.wanted();
    const bool done = (end || report.stop != 0) && team.idle();
    if (done) {
      results = team.take(poll_every);
      std::move(results.begin(), results.end(), std::back_inserter(report.results));
    }
    if (!done && report.wanted == 0 && Clock::now() - last < report_every) continue;
    report.leaving = done ? 1 : 0;
    ranks.send(0, tag_report, packed(report));
    report.results.clear();
    answered = false;
    last = Clock::now();
    if (done) return;
  }
}

}  // namespace bentur
