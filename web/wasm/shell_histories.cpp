#include <emscripten/val.h>

#include <vector>

#include "shell.h"

namespace bentur::web {
namespace {

using emscripten::val;

/// A copy: memory of WebAssembly moves when it grows.
val array(const std::vector<double>& values) {
  return val::global("Float64Array").new_(val(emscripten::typed_memory_view(values.size(), values.data())));
}

/// One array for each row.
val rows(const Eigen::MatrixXd& matrix) {
  val list = val::array();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    std::vector<double> values(static_cast<std::size_t>(matrix.cols()));
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) values[static_cast<std::size_t>(k)] = matrix(row, k);
    list.call<void>("push", array(values));
  }
  return list;
}

}  // namespace

val Studio::histories() const {
  val all = val::object();
  if (!run_) return all;
  const Histories& histories = run_->response.histories;
  all.set("time", array(histories.time));
  all.set("ground", array(histories.ground_acceleration));
  all.set("opening", rows(histories.opening));
  all.set("force", rows(histories.force));
  val buildings = val::array();
  for (std::size_t b = 0; b < histories.displacement.size(); ++b) {
    val one = val::object();
    one.set("displacement", rows(histories.displacement[b]));
    one.set("drift", rows(histories.drift_ratio[b]));
    one.set("shear", rows(histories.storey_shear[b]));
    buildings.call<void>("push", one);
  }
  all.set("buildings", buildings);
  return all;
}

}  // namespace bentur::web
