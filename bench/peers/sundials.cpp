#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/peers/peers.h"

namespace bentur::bench {
namespace {

constexpr long most_steps = 100'000'000;

void require(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(std::string(call) + " gave " + std::to_string(flag));
}

template <class T>
T* require(T* made, const char* call) {
  if (made == nullptr) throw std::runtime_error(std::string(call) + " failed");
  return made;
}

/// What SUNDIALS wants around a vector.
class State {
 public:
  explicit State(std::size_t size) {
#if SUNDIALS_VERSION_MAJOR >= 7
    require(SUNContext_Create(SUN_COMM_NULL, &context_), "SUNContext_Create");
#else
    require(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
#endif
    vector_ = require(N_VNew_Serial(static_cast<sunindextype>(size), context_), "N_VNew_Serial");
    N_VConst(0.0, vector_);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    N_VDestroy(vector_);
    SUNContext_Free(&context_);
  }
  [[nodiscard]] SUNContext context() const { return context_; }
  [[nodiscard]] N_Vector vector() const { return vector_; }
  [[nodiscard]] const double* data() const { return N_VGetArrayPointer(vector_); }

 private:
  SUNContext context_{};
  N_Vector vector_{};
};

extern "C" int derivative(sunrealtype time, N_Vector y, N_Vector rate, void* equations) {
  static_cast<Equations*>(equations)->derivative(time, N_VGetArrayPointer(y), N_VGetArrayPointer(rate));
  return 0;
}

/// Zero where a point touches or parts, and, while it is closed, where its force is largest.
extern "C" int events(sunrealtype /*time*/, N_Vector y, sunrealtype* values, void* data) {
  const auto* equations = static_cast<const Equations*>(data);
  const double* state = N_VGetArrayPointer(y);
  const std::size_t points = equations->points();
  for (std::size_t i = 0; i < points; ++i) {
    values[i] = equations->opening(i, state);
    values[points + i] = equations->closed(i) ? equations->opening_rate(i, state) : 1.0;
  }
  return 0;
}

/// Takes account of the roots found at y; whether the equations are others from here on.
bool take(Equations& equations, const std::vector<int>& roots, const double* y) {
  bool changed = false;
  for (std::size_t i = 0; i < equations.points(); ++i) {
    if (roots[equations.points() + i] != 0 && equations.closed(i)) equations.note_peak(i, y);
    if (roots[i] == 0) continue;
    equations.set_closed(i, roots[i] < 0);
    changed = true;
  }
  return changed;
}

/// From breakpoint to breakpoint. `advance(until, time)` returns whether it stopped at a root, `roots(list)` tells
/// which, `anew(time)` starts anew.
template <class Advance, class Roots, class Anew>
void walk(Equations& equations, const State& state, Advance advance, Roots roots, Anew anew) {
  std::vector<int> found(2 * equations.points());
  const std::vector<double>& times = equations.breakpoints();
  double time = 0;
  for (std::size_t j = 0; j + 1 < times.size(); ++j) {
    equations.enter(j);
    if (equations.jumps(j)) anew(time);
    while (time < times[j + 1]) {
      if (!advance(times[j + 1], time)) break;
      roots(found.data());
      if (take(equations, found, state.data())) anew(time);
    }
  }
}

}  // namespace

void integrate_with_cvode(Equations& equations, double tolerance) {
  State state(equations.size());
  const auto free_memory = [](void* memory) { CVodeFree(&memory); };
  const std::unique_ptr<void, decltype(free_memory)> memory(
      require(CVodeCreate(CV_ADAMS, state.context()), "CVodeCreate"), free_memory);
  require(CVodeInit(memory.get(), derivative, 0.0, state.vector()), "CVodeInit");
  require(CVodeSStolerances(memory.get(), tolerance, tolerance * equations.scale()), "CVodeSStolerances");
  require(CVodeSetUserData(memory.get(), &equations), "CVodeSetUserData");
  require(CVodeSetMaxNumSteps(memory.get(), most_steps), "CVodeSetMaxNumSteps");
  const std::unique_ptr<_generic_SUNNonlinearSolver, int (*)(SUNNonlinearSolver)> iteration(
      require(SUNNonlinSol_FixedPoint(state.vector(), 0, state.context()), "SUNNonlinSol_FixedPoint"),
      SUNNonlinSolFree);
  require(CVodeSetNonlinearSolver(memory.get(), iteration.get()), "CVodeSetNonlinearSolver");
  require(CVodeRootInit(memory.get(), static_cast<int>(2 * equations.points()), events), "CVodeRootInit");
  require(CVodeSetNoInactiveRootWarn(memory.get()), "CVodeSetNoInactiveRootWarn");
  walk(
      equations, state,
      [&](double until, double& time) {
        require(CVodeSetStopTime(memory.get(), until), "CVodeSetStopTime");
        const int flag = CVode(memory.get(), until, state.vector(), &time, CV_NORMAL);
        require(flag, "CVode");
        return flag == CV_ROOT_RETURN;
      },
      [&](int* found) { require(CVodeGetRootInfo(memory.get(), found), "CVodeGetRootInfo"); },
      [&](double time) { require(CVodeReInit(memory.get(), time, state.vector()), "CVodeReInit"); });
}

void integrate_with_arkode(Equations& equations, double tolerance, Arkode method) {
  State state(equations.size());
  const auto free_memory = [](void* memory) { ERKStepFree(&memory); };
  const std::unique_ptr<void, decltype(free_memory)> memory(
      require(ERKStepCreate(derivative, 0.0, state.vector(), state.context()), "ERKStepCreate"), free_memory);
  const ARKODE_ERKTableID table =
      method == Arkode::dormand_prince_5 ? ARKODE_DORMAND_PRINCE_7_4_5 : ARKODE_FEHLBERG_13_7_8;
  require(ERKStepSetTableNum(memory.get(), table), "ERKStepSetTableNum");
  require(ERKStepSStolerances(memory.get(), tolerance, tolerance * equations.scale()), "ERKStepSStolerances");
  require(ERKStepSetUserData(memory.get(), &equations), "ERKStepSetUserData");
  require(ERKStepSetMaxNumSteps(memory.get(), most_steps), "ERKStepSetMaxNumSteps");
  require(ERKStepRootInit(memory.get(), static_cast<int>(2 * equations.points()), events), "ERKStepRootInit");
  require(ERKStepSetNoInactiveRootWarn(memory.get()), "ERKStepSetNoInactiveRootWarn");
  walk(
      equations, state,
      [&](double until, double& time) {
        require(ERKStepSetStopTime(memory.get(), until), "ERKStepSetStopTime");
        const int flag = ERKStepEvolve(memory.get(), until, state.vector(), &time, ARK_NORMAL);
        require(flag, "ERKStepEvolve");
        return flag == ARK_ROOT_RETURN;
      },
      [&](int* found) { require(ERKStepGetRootInfo(memory.get(), found), "ERKStepGetRootInfo"); },
      [&](double time) { require(ERKStepReset(memory.get(), time, state.vector()), "ERKStepReset"); });
}

}  // namespace bentur::bench
