#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

constexpr double symmetry_tolerance = 1e-9;  // of the largest entry [-]

/// n × n numbers, or where `diagonal_allowed` a list of n: the diagonal. Empty when something is wrong.
Eigen::MatrixXd read_matrix(const TomlView& view, std::size_t n, bool diagonal_allowed,
                            const char* each = "one per elevation") {
  const std::string what = diagonal_allowed ? "numbers (the diagonal) or of rows" : "rows";
  if (!view.is_list_of(what, {n, each})) return {};
  const auto size = static_cast<Eigen::Index>(view.size());
  if (diagonal_allowed && view.item(0).is_number()) {
    const std::vector<double> diagonal = view.as_numbers(Range::positive);
    if (diagonal.empty()) return {};
    return Eigen::Map<const Eigen::VectorXd>(diagonal.data(), size).asDiagonal();
  }
  Eigen::MatrixXd matrix(size, size);
  bool good = true;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const std::vector<double> row = view.item(i).as_numbers(Range::finite, {view.size(), "a square matrix"});
    good = good && !row.empty();
    if (good) matrix.row(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), size);
  }
  if (!good) return {};
  const double tolerance = symmetry_tolerance * matrix.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (std::abs(matrix(i, j) - matrix(j, i)) <= tolerance) continue;
      const auto entry = view.item(static_cast<std::size_t>(i)).item(static_cast<std::size_t>(j));
      entry.error_value(fmt::format("must be {} as at [{}][{}]: the matrix must be symmetric", matrix(j, i), j, i));
      good = false;
    }
  }
  if (!good) return {};
  return 0.5 * (matrix + matrix.transpose());
}

/// Smallest eigenvalue against round-off: positive, or where `semi` not negative.
void check_definite(const TomlView& view, const Eigen::MatrixXd& matrix, bool semi) {
  if (matrix.size() == 0) return;
  const double largest = matrix.cwiseAbs().maxCoeff();
  if (largest == 0 && semi) return;
  const double least = largest == 0 ? 0 : smallest_eigenvalue(matrix / largest);
  // Entries carry about as many digits as symmetry asks for; a stiffness may be that ill-conditioned without being
  // wrong.
  if (semi ? least < -symmetry_tolerance : least <= 1e-14 * static_cast<double>(matrix.rows())) {
    view.error(fmt::format("must be positive {}, its smallest eigenvalue is {:.3g}", semi ? "semidefinite" : "definite",
                           least * largest));
  }
}

}  // namespace

void read_matrices(const TomlView& entry, ReadBuilding& building) {
  const auto table = TableView::of(entry, matrices_keys());
  if (!table) return;
  const TableView& view = *table;
  for (const char* const key : {"elevations", "mass"}) {
    if (!view.has(key)) view.error_missing(key);
  }
  MatricesSpec spec;
  const auto list = view.find("elevations");
  spec.elevations = view.numbers("elevations");
  const std::vector<double>& floors = spec.elevations;
  if (std::adjacent_find(floors.begin(), floors.end(), std::greater_equal<>()) != floors.end()) {
    list->error("must ascend");
  } else if (!floors.empty()) {
    building.modes = floors.size();
    building.elevations = floors;
  }
  const std::size_t n = list ? list->size() : 0;
  if (const auto mass = view.get("mass")) {
    spec.mass = read_matrix(*mass, n, true);
    check_definite(*mass, spec.mass, false);
  }
  if (const auto stiffness = view.get("stiffness")) {
    spec.stiffness = read_matrix(*stiffness, n, false);
    check_definite(*stiffness, spec.stiffness, false);
  }
  if (const auto damping = view.find("damping")) {
    MatrixDamping given{read_matrix(*damping, n, false)};
    check_definite(*damping, given.matrix, true);
    building.spec.damping = std::move(given);
  }
  building.spec.structure = std::move(spec);
}

Eigen::MatrixXd read_stiffness_in_plan(const TomlView& entry, std::size_t storeys) {
  const auto view = TableView::of(entry, matrices_keys());
  if (!view) return {};
  view->refuse({"elevations", "mass"}, "follows from plan, which has storey_heights, masses and inertias");
  view->refuse({"damping"}, "is not for buildings in plan: give building.damping");
  const auto stiffness = view->get("stiffness");
  if (!stiffness) return {};
  Eigen::MatrixXd matrix = read_matrix(*stiffness, 3 * storeys, false, "three per storey");
  check_definite(*stiffness, matrix, false);
  return matrix;
}

}  // namespace bentur
