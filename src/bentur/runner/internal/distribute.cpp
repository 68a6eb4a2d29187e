#include "bentur/runner/internal/distribute.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "bentur/runner/internal/pool.h"

/// Values as bytes, to the last bit: every rank runs the same program.
template <>
struct nlohmann::adl_serializer<bentur::RunResult> {
  static void to_json(json& to, const bentur::RunResult& result) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(result.values.data());
    const auto* end = bytes + result.values.size() * sizeof(double);
    to = {result.run, result.status, result.message, json::binary({bytes, end})};
  }
  static void from_json(const json& from, bentur::RunResult& result) {
    from.at(0).get_to(result.run);
    from.at(1).get_to(result.status);
    from.at(2).get_to(result.message);
    const std::vector<std::uint8_t>& bytes = from.at(3).get_binary();
    result.values.resize(bytes.size() / sizeof(double));
    if (!result.values.empty()) std::memcpy(result.values.data(), bytes.data(), result.values.size() * sizeof(double));
  }
};

namespace bentur {
namespace {

using MessageJson = nlohmann::json;
using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr auto report_every = milliseconds(200);  // by other ranks, which also learns of a stop
constexpr auto sync_every = milliseconds(2000);
constexpr auto poll_every = microseconds(500);  // for messages, where there are other ranks
constexpr auto patience = milliseconds(3000);   // with other ranks after a stop

enum Tag : int { tag_report = 1, tag_order = 2 };

/// What another rank says: results, how many runs it wants, and whether it is leaving or has been told to stop.
struct Report {
  std::vector<RunResult> results;
  std::size_t wanted = 0;
  bool leaving = false;
  bool stop = false;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Report, results, wanted, leaving, stop)

/// What rank 0 answers to each report but the last.
struct Order {
  RunNumbers runs;
  bool end = false;  // no more work
  bool stop = false;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Order, runs, end, stop)

template <class Message>
std::string packed(const Message& message) {
  std::string bytes;
  MessageJson::to_msgpack(message, bytes);
  return bytes;
}

template <class Message>
Message unpacked(const std::string& bytes) {
  try {
    return MessageJson::from_msgpack(bytes).get<Message>();
  } catch (const MessageJson::exception&) {
    throw std::runtime_error("a message of another rank is cut short");
  }
}

/// Runs still to be handed out, in the order of the design.
class Queue {
 public:
  Queue(const SweepDesign& design, const Journal& journal, std::size_t takers)
      : design_(design), journal_(journal), takers_(takers), left_(design.runs() - journal.done()) {}

  /// Up to `wanted` runs; towards the end fewer, so that all takers finish together.
  RunNumbers take(std::size_t wanted) {
    RunNumbers runs;
    const std::size_t share = std::max<std::size_t>(1, left_ / (2 * takers_));
    for (wanted = std::min(wanted, share); runs.size() < wanted && position_ < design_.runs(); ++position_) {
      const std::size_t run = design_.run_at(position_);
      if (!journal_.is_done(run)) runs.push_back(run);
    }
    left_ -= std::min(left_, runs.size());
    return runs;
  }
  [[nodiscard]] bool empty() const { return left_ == 0; }

 private:
  const SweepDesign& design_;
  const Journal& journal_;
  std::size_t takers_;
  std::size_t left_;
  std::size_t position_ = 0;
};

/// Rank 0: its own threads solve runs, and the other ranks ask it for more.
class Coordinator {
 public:
  Coordinator(const StudyRuns& runs, Journal& journal, Ranks& ranks, const WorkOptions& options)
      : journal_(journal),
        ranks_(ranks),
        options_(options),
        pool_(runs, options.threads, options.stop),
        queue_(runs.design(), journal, static_cast<std::size_t>(ranks.size() * options.threads)),
        others_(ranks.size() - 1),
        all_(runs.design().runs()) {}

  bool work() {
    while (!pool_.stopping() && (journal_.done() < all_ || others_ > 0)) {
      if (const std::size_t wanted = pool_.wanted(); wanted > 0 && !queue_.empty()) pool_.give(queue_.take(wanted));
      step();
    }
    if (journal_.done() < all_) wind_down();
    journal_.sync();
    return journal_.done() == all_;
  }

 private:
  /// Takes and keeps what there is, and answers who asks.
  void step() {
    keep(pool_.take(ranks_.size() > 1 ? microseconds(poll_every) : microseconds(milliseconds(100))));
    while (const auto message = ranks_.receive()) {
      const auto report = unpacked<Report>(message->bytes);
      keep(report.results);
      if (report.stop) pool_.stop();
      if (report.leaving) {
        --others_;
        continue;
      }
      Order order;
      order.stop = pool_.stopping();
      if (!order.stop && report.wanted > 0) order.runs = queue_.take(report.wanted);
      order.end = queue_.empty();
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
    while (Clock::now() < end && (!pool_.idle() || others_ > 0)) step();
    step();
  }

  Journal& journal_;
  Ranks& ranks_;
  const WorkOptions& options_;
  Pool pool_;
  Queue queue_;
  int others_;
  std::size_t all_;
  Clock::time_point synced_ = Clock::now();
};

}  // namespace

bool coordinate(const StudyRuns& runs, Journal& journal, Ranks& ranks, const WorkOptions& options) {
  return Coordinator(runs, journal, ranks, options).work();
}

void dismiss_workers(Ranks& ranks) {
  for (int others = ranks.size() - 1; others > 0;) {
    const auto message = ranks.receive();
    if (!message) {
      std::this_thread::sleep_for(poll_every);
    } else if (unpacked<Report>(message->bytes).leaving) {
      --others;
    } else {
      ranks.send(message->from, tag_order, packed(Order{.runs = {}, .end = true}));
    }
  }
}

void work(const StudyRuns& runs, Ranks& ranks, const WorkOptions& options) {
  Pool pool(runs, options.threads, options.stop);
  Report report;
  bool answered = true;  // each report but the last gets an answer, so neither side ever sends into the other's sending
  bool end = false;
  auto last = Clock::now() - report_every;
  const auto collect = [&] {
    std::vector<RunResult> results = pool.take(poll_every);
    std::move(results.begin(), results.end(), std::back_inserter(report.results));
  };
  for (;;) {
    collect();
    if (const auto message = ranks.receive()) {
      const auto order = unpacked<Order>(message->bytes);
      answered = true;
      end = order.end || order.stop;
      if (order.stop) pool.stop();
      pool.give(order.runs);
    }
    if (!answered) continue;
    report.stop = pool.stopping();
    report.wanted = end || report.stop ? 0 : pool.wanted();
    const bool done = (end || report.stop) && pool.idle();
    if (done) collect();
    if (!done && report.wanted == 0 && Clock::now() - last < report_every) continue;
    report.leaving = done;
    ranks.send(0, tag_report, packed(report));
    report.results.clear();
    answered = false;
    last = Clock::now();
    if (done) return;
  }
}

}  // namespace bentur
