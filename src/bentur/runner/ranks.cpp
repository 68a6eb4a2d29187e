#include "bentur/runner/ranks.h"

#include <cstdlib>
#include <stdexcept>

// The only source that knows MPI.
#ifdef BENTUR_HAS_MPI
#define OMPI_SKIP_MPICXX 1  // the C interface alone
#include <mpi.h>
#endif

namespace bentur {

#ifdef BENTUR_HAS_MPI

namespace {

/// What Open MPI's mpirun, srun and other launchers leave in the environment.
bool launched() {
  for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

}  // namespace

Ranks::Ranks() {
  if (!launched()) return;
  int provided = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS ||
      provided < MPI_THREAD_FUNNELED) {
    throw std::runtime_error("MPI cannot be used beside threads here");
  }
  begun_ = true;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
  if (begun_) MPI_Finalize();
}

bool Ranks::available() noexcept { return true; }

void Ranks::send(int to, int tag, const std::string& bytes) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD);
}

std::optional<Ranks::Message> Ranks::receive() {
  if (size_ == 1) return std::nullopt;
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.from, message.tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

void Ranks::end_job(int status) noexcept {
  if (begun_) MPI_Abort(MPI_COMM_WORLD, status);
}

#else

/// Several processes that know nothing of one another would all write the same files.
Ranks::Ranks() {
  for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* const size = std::getenv(name);
    if (size != nullptr && std::atoi(size) > 1) {
      throw std::runtime_error(
          "built without MPI, so it cannot be one of several processes: start it without mpirun, which uses all "
          "processors of "
          "this machine by threads; or build it where CMake finds MPI (Debian: libopenmpi-dev), as ./dev build does");
    }
  }
}
Ranks::~Ranks() = default;
bool Ranks::available() noexcept { return false; }
void Ranks::send(int, int, const std::string&) { throw std::logic_error("built without MPI"); }
std::optional<Ranks::Message> Ranks::receive() { return std::nullopt; }
void Ranks::end_job(int) noexcept {}

#endif

}  // namespace bentur
