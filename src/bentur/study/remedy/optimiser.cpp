#include "bentur/study/remedy/optimiser.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "bentur/study/remedy/internal/linear_program.h"

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

namespace {

double cost_of(unsigned n, const double* x, double* gradient, void* data) {
  const auto& program = *static_cast<const LinearProgram*>(data);
  if (gradient != nullptr) std::copy(program.cost.begin(), program.cost.end(), gradient);
  return std::inner_product(x, x + n, program.cost.begin(), 0.0);
}

void excess_of(unsigned m, double* excess, unsigned n, const double* x, double* gradient, void* data) {
  const auto& program = *static_cast<const LinearProgram*>(data);
  for (unsigned row = 0; row < m; ++row) {
    const LinearProgram::Row& one = program.rows[row];
    excess[row] = std::inner_product(x, x + n, one.of.begin(), -one.bound);
    if (gradient != nullptr) std::copy(one.of.begin(), one.of.end(), gradient + std::size_t{row} * n);
  }
}

}  // namespace

std::vector<double> minimum(const LinearProgram& program) {
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> owner(
      nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(program.cost.size())), &nlopt_destroy);
  const nlopt_opt optimiser = owner.get();
  if (optimiser == nullptr) throw std::runtime_error("NLopt has no memory left");
  auto* const data = const_cast<LinearProgram*>(&program);  // NLopt hands it back as it is
  const std::vector<double> within(program.rows.size(), 1e-10);
  nlopt_set_lower_bounds(optimiser, program.low.data());
  nlopt_set_upper_bounds(optimiser, program.high.data());
  nlopt_set_min_objective(optimiser, &cost_of, data);
  nlopt_add_inequality_mconstraint(optimiser, static_cast<unsigned>(program.rows.size()), &excess_of, data,
                                   within.data());
  nlopt_set_maxeval(optimiser, 200);
  nlopt_set_xtol_abs1(optimiser, 1e-9);
  std::vector<double> x = program.start;
  double least = 0;
  nlopt_optimize(optimiser, x.data(), &least);  // what it has when rounding ends it is near enough
  return x;
}

bool has_optimiser() { return true; }
void search_everywhere(const Minimisation& what) { search(NLOPT_GN_DIRECT_L, what); }
void search_nearby(const Minimisation& what) { search(NLOPT_LN_COBYLA, what); }

#else

bool has_optimiser() { return false; }
void search_everywhere(const Minimisation& /*what*/) { throw std::logic_error("built without NLopt"); }
std::vector<double> minimum(const LinearProgram& /*program*/) { throw std::logic_error("built without NLopt"); }
void search_nearby(const Minimisation& /*what*/) { throw std::logic_error("built without NLopt"); }

#endif

}  // namespace bentur
