// Says which of how many processes it is, by the source that knows MPI, built as where there is none.
#include <bentur/runner/ranks.h>

#include <cstdio>
#include <exception>

int main() {
  try {
    const bentur::Ranks ranks;
    std::printf("rank %d of %d\n", ranks.rank(), ranks.size());
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
  }
}
