#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace bentur {

/// The processes of one MPI job that this one is part of. Started any other way than by mpirun (or srun), or built
/// without MPI, a process is alone: rank 0 of 1, and MPI is not touched. One object per program; one thread uses it.
class Ranks {
 public:
  struct Message {
    int from = 0;
    int tag = 0;
    std::string bytes;
  };

  Ranks();
  /// Ends the job's communication; waits for the others.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  /// Whether the program was built with MPI.
  [[nodiscard]] static bool available() noexcept;

  [[nodiscard]] int rank() const noexcept { return rank_; }
  [[nodiscard]] int size() const noexcept { return size_; }

  void send(int to, int tag, const std::string& bytes);
  /// A message that has come, or nothing.
  [[nodiscard]] std::optional<Message> receive();

  /// Ends all processes of the job at once, this one too, with an exit status; does nothing when alone.
  void end_job(int status) noexcept;

 private:
  bool begun_ = false;
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace bentur
