#include "bentur/study/remedy/optimiser.h"

#include <exception>
#include <limits>
#include <stdexcept>

#ifdef BENTUR_HAS_NLOPT
#include <nlopt.h>

#include <memory>
#endif

namespace bentur {

#ifdef BENTUR_HAS_NLOPT
namespace {

constexpr double least_step = 1e-4;  // of u
constexpr double first_step = 0.1;

/// What NLopt calls back with. Nothing may be thrown through it.
struct Call {
  const PlaceFunction* function;
  nlopt_opt optimiser;
  std::exception_ptr* failure;
};

double call(unsigned n, const double* u, double* /*gradient*/, void* data) {
  const auto& that = *static_cast<const Call*>(data);
  try {
    if (!*that.failure) return (*that.function)(std::vector<double>(u, u + n));
  } catch (...) {
    *that.failure = std::current_exception();
  }
  nlopt_force_stop(that.optimiser);
  return std::numeric_limits<double>::max();
}

void search(nlopt_algorithm algorithm, const Minimisation& what) {
  if (what.evaluations == 0) return;
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> owner(
      nlopt_create(algorithm, static_cast<unsigned>(what.start.size())), &nlopt_destroy);
  const nlopt_opt optimiser = owner.get();
  if (optimiser == nullptr) throw std::runtime_error("NLopt has no memory left");
  std::exception_ptr failure;
  Call objective{&what.objective, optimiser, &failure};
  Call constraint{&what.constraint, optimiser, &failure};
  nlopt_set_lower_bounds1(optimiser, 0);
  nlopt_set_upper_bounds1(optimiser, 1);
  nlopt_set_min_objective(optimiser, &call, &objective);
  if (what.constraint) nlopt_add_inequality_constraint(optimiser, &call, &constraint, 0);
  nlopt_set_maxeval(optimiser, static_cast<int>(what.evaluations));
  nlopt_set_xtol_abs1(optimiser, least_step);
  nlopt_set_initial_step1(optimiser, first_step);
  std::vector<double> u = what.start;
  double least = 0;
  nlopt_optimize(optimiser, u.data(), &least);  // what was found is known to who evaluates
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

bool has_optimiser() { return true; }
void search_everywhere(const Minimisation& what) { search(NLOPT_GN_DIRECT_L, what); }
void search_nearby(const Minimisation& what) { search(NLOPT_LN_COBYLA, what); }

#else

bool has_optimiser() { return false; }
void search_everywhere(const Minimisation& /*what*/) { throw std::logic_error("built without NLopt"); }
void search_nearby(const Minimisation& /*what*/) { throw std::logic_error("built without NLopt"); }

#endif

}  // namespace bentur
