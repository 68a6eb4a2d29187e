#pragma once

#include <ctime>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace bentur::bench {

/// Processor time of this thread [s]: what other programs do on the machine does not count.
inline double processor_time() {
  timespec now{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) throw std::runtime_error("no clock of processor time");
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Timing {
  double minimum = 0, median = 0;  ///< of one call [s]
  int repeats = 0;                 ///< samples, each of as many calls as take a millisecond
};

/// Times `work` over `seconds` or so; at least once, and five times where one call takes less than that.
template <class Work>
Timing time_of(Work work, double seconds = 0.3) {
  double began = processor_time();
  work();  // also warms caches; counts only where it is all there is time for
  const double first = processor_time() - began;
  if (first > seconds) return {first, first, 1};
  const int calls = std::max(1, static_cast<int>(1e-3 / std::max(first, 1e-7)));
  std::vector<double> samples;
  double spent = 0;
  while (samples.size() < 5 || spent < seconds) {
    began = processor_time();
    for (int i = 0; i < calls; ++i) work();
    const double took = processor_time() - began;
    spent += took;
    samples.push_back(took / calls);
  }
  std::sort(samples.begin(), samples.end());
  return {samples.front(), samples[samples.size() / 2], static_cast<int>(samples.size())};
}

}  // namespace bentur::bench
