#include <pybind11/stl.h>

#include <chrono>
#include <optional>

#include "bentur/core/errors.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/limits.h"
#include "bentur/report/html/report.h"
#include "bentur/report/remark_text.h"
#include "bentur/solve/effort.h"
#include "bentur/structure/modes.h"
#include "case_run.h"
#include "toml_python.h"

namespace py = pybind11;

namespace bentur::python {

bool Watcher::operator()(double fraction) {
  if (error_) return false;
  const double now = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  if (now - asked_ < 0.05) return true;
  asked_ = now;
  const py::gil_scoped_acquire lock;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress_.is_none()) progress_(fraction);
    return true;
  } catch (py::error_already_set& error) {
    error_ = std::make_unique<py::error_already_set>(error);
    return false;
  }
}

void Watcher::rethrow() {
  if (!error_) return;
  py::error_already_set error = *error_;
  error_.reset();
  throw error;
}

py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

namespace {

/// floors × samples by columns, as samples × floors by rows: nothing is copied.
py::array_t<double> view_of(const Eigen::MatrixXd& values, const py::object& owner) {
  const py::ssize_t size = sizeof(double);
  py::array_t<double> array({values.cols(), values.rows()}, {values.rows() * size, size}, values.data(), owner);
  array.attr("setflags")(false);
  return array;
}

/// VectorXd or std::vector<double>.
template <typename Vector>
py::array_t<double> view_of(const Vector& values, const py::object& owner) {
  py::array_t<double> array({std::ssize(values)}, {sizeof(double)}, values.data(), owner);
  array.attr("setflags")(false);
  return array;
}

std::shared_ptr<PyRun> solved(const PyCase& given, double output_step, const std::vector<OwnLaw>& laws,
                              const py::object& progress) {
  if (Diagnostics found; refuse_spectrum(given.c, found)) raise_case_error(found);
  Problem problem = given.problem;
  for (const OwnLaw& own : laws) {
    bool there = false;
    for (ContactPoint& point : problem.points) {
      if (point.left != own.gap) continue;
      point.law = own.law;
      there = true;
    }
    if (!there) throw InvalidParameter("laws", std::to_string(own.gap), "is no gap with contact points");
  }
  SolveOptions options;
  options.output_step = output_step;
  options.course = output_step > 0;
  options.energy_audit = given.c.analysis.energy_audit;
  options.most_steps = static_cast<long>(given.c.analysis.limits.steps);
  const std::string refusal = beyond_limits(given.c, problem, effort(problem, given.c.analysis.solver, options));
  if (!refusal.empty()) {
    Diagnostics found;
    found.error({given.name, 0, 0}, refusal);
    raise_case_error(found);
  }
  Watcher watcher(progress);
  options.progress = [&](double fraction) { return watcher(fraction); };
  Response response;
  {
    const py::gil_scoped_release unlocked;
    response = solve(problem, given.c.analysis.solver, options);
  }
  watcher.rethrow();
  for (const OwnLaw& own : laws) {
    if (const auto* force = dynamic_cast<const ForceLaw*>(own.law.get())) force->rethrow();
  }
  if (response.status != Status::done && response.status != Status::collapsed) raise_solve_error(response.message);
  const py::gil_scoped_release unlocked;
  return std::make_shared<PyRun>(PyRun{run_results(given.c, std::move(problem), std::move(response))});
}

/// Arrays by name, lists of them where each building has its own; what is not kept is left out, or None in a list.
py::dict arrays_of(const Histories& found, const py::object& owner) {
  py::dict arrays;
  if (found.time.empty()) return arrays;
  arrays["time"] = view_of(found.time, owner);
  if (!found.ground_acceleration.empty()) arrays["ground_acceleration"] = view_of(found.ground_acceleration, owner);
  arrays["opening"] = view_of(found.opening, owner);
  arrays["force"] = view_of(found.force, owner);
  const std::pair<const char*, const std::vector<Eigen::MatrixXd>&> of_buildings[] = {
      {"displacement", found.displacement},  {"velocity", found.velocity},
      {"acceleration", found.acceleration},  {"drift_ratio", found.drift_ratio},
      {"storey_shear", found.storey_shear},  {"node_displacement", found.node_displacement},
      {"column_forces", found.column_forces}};
  for (const auto& [name, all] : of_buildings) {
    if (all.empty()) continue;
    py::list list;
    for (const Eigen::MatrixXd& one : all) {
      list.append(one.size() > 0 ? py::object(view_of(one, owner)) : py::object(py::none()));
    }
    arrays[name] = list;
  }
  return arrays;
}

py::dict histories(const std::shared_ptr<PyRun>& run) {
  const py::object owner = py::cast(run);
  const Histories& found = run->results.response.histories;
  py::dict arrays = arrays_of(found, owner);
  const auto& audit = run->results.response.energy;
  if (found.time.empty() || !audit) return arrays;
  const EnergyHistories& energy = audit->histories;
  const std::pair<const char*, const Eigen::VectorXd&> curves[] = {{"energy_input", energy.input},
                                                                   {"energy_kinetic", energy.kinetic},
                                                                   {"energy_strain", energy.strain},
                                                                   {"energy_damping", energy.damping},
                                                                   {"energy_hysteretic", energy.hysteretic},
                                                                   {"energy_contact_stored", energy.contact_stored},
                                                                   {"energy_contact_lost", energy.contact_lost}};
  for (const auto& [name, values] : curves) {
    arrays[name] = values.size() > 0 ? view_of(values, owner) : array_of(std::vector<double>(found.time.size(), 0.0));
  }
  return arrays;
}

/// Each quantity of one owner that is told of these places: name, units, what it is, values.
py::list quantities_at(const PyRun& run, Owner owner, const std::vector<QuantityPlace>& places) {
  py::list found;
  const RunView view = run.results.view();
  for (const Quantity* quantity : quantities_of(owner)) {
    if (!is_told_at_any(*quantity, view, places)) continue;
    std::vector<double> values;
    values.reserve(places.size());
    for (const QuantityPlace& at : places) values.push_back(value_of(*quantity, view, at));
    found.append(py::make_tuple(file_name(*quantity), udunits(quantity->units, view.units),
                                std::string(quantity->long_name), std::string(quantity->symbol), array_of(values),
                                std::string(quantity->key), is_whole(*quantity)));
  }
  return found;
}

py::dict places(const PyRun& run) {
  const Problem& problem = run.results.problem;
  py::dict found;
  py::list buildings, points, links, gaps, impacts;
  for (const Building& building : problem.buildings) {
    const double base = building.model.elevations.front() - building.model.storey_heights.front();
    py::dict one;
    one["name"] = building.name;
    one["elevation"] = array_of(building.model.elevations);
    one["base_elevation"] = base;
    one["rigid"] = building.is_rigid();
    one["node_elevation"] = array_of(building.model.node_elevations);
    buildings.append(one);
  }
  for (const ContactPoint& point : problem.points) {
    const std::optional<StruckColumn> struck = struck_column(problem, point);
    points.append(py::make_tuple(problem.buildings[point.left].name, problem.buildings[point.left + 1].name,
                                 point.elevation, point.width, struck ? problem.buildings[struck->building].name : "",
                                 struck ? static_cast<int>(struck->node) : -1, struck ? point.column_shear_capacity : 0,
                                 struck ? point.column_moment_capacity : 0));
  }
  for (const Link& link : problem.links) {
    links.append(py::make_tuple(problem.buildings[link.left].name, problem.buildings[link.right].name, link.elevation));
  }
  for (const Gap& gap : gaps_of(problem)) gaps.append(gap_name(problem, gap.left));
  for (const Impact& impact : run.results.response.impacts) impacts.append(impact.point);
  found["buildings"] = buildings;
  found["points"] = points;
  found["links"] = links;
  found["gaps"] = gaps;
  found["impact_points"] = impacts;
  return found;
}

std::string modes(const PyCase& given, bool jacobi) {
  std::vector<Building> buildings = given.problem.buildings;
  for (Building& building : buildings) {
    if (!jacobi || building.modes.omega.size() < building.model.dofs()) continue;
    building.modes = modes_by_jacobi(building.model.mass, building.model.stiffness);
  }
  return modes_json(buildings, given.c.units);
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<PyRun, std::shared_ptr<PyRun>>(module, "Run")
      .def("summary_json", [](const PyRun& run) { return summary_json(run.results, BENTUR_VERSION); })
      .def("impacts_csv", [](const PyRun& run) { return impacts_csv(run.results.view()); })
      .def("gap_json",
           [](const PyRun& run) {
             const RunResults& r = run.results;
             return gap_json(r, separations(r.problem, r.response, r.c.code, r.c.units), BENTUR_VERSION);
           })
      .def("histories", &histories)
      .def("course",
           [](const std::shared_ptr<PyRun>& run) { return arrays_of(run->results.response.course, py::cast(run)); })
      .def("places", &places)
      .def("remarks", [](const PyRun& run) { return remark_texts(run.results.remarks); })
      .def("run_quantities", [](const PyRun& run) { return quantities_at(run, Owner::run, {{}}); })
      .def("building_quantities",
           [](const PyRun& run, Eigen::Index b) {
             return quantities_at(run, Owner::building, {{b, 0}});
           })
      .def("floor_quantities",
           [](const PyRun& run, Eigen::Index b) {
             return quantities_at(run, Owner::floor, floors_of(run.results.problem, b));
           })
      .def("point_quantities",
           [](const PyRun& run) {
             return quantities_at(run, Owner::point, first_places(std::ssize(run.results.problem.points)));
           })
      .def("gap_quantities",
           [](const PyRun& run) {
             return quantities_at(run, Owner::gap, first_places(std::ssize(run.results.problem.buildings) - 1));
           })
      .def("link_quantities",
           [](const PyRun& run) {
             return quantities_at(run, Owner::link, first_places(std::ssize(run.results.problem.links)));
           })
      .def("impact_quantities",
           [](const PyRun& run) {
             return quantities_at(run, Owner::impact, first_places(std::ssize(run.results.response.impacts)));
           })
      .def(
          "report_html",
          [](const PyRun& run, const std::string& language) {
            const py::gil_scoped_release unlocked;
            return report_html(run.results, {.language = language, .version = BENTUR_VERSION});
          },
          py::arg("language") = "en");

  module.def(
      "solve",
      [](const PyCase& given, double output_step, const py::list& laws, const py::object& progress) {
        std::vector<OwnLaw> own;
        for (const py::handle one : laws) {
          const auto pair = one.cast<py::tuple>();
          own.push_back({pair[0].cast<Eigen::Index>(), pair[1].cast<std::shared_ptr<ContactLaw>>()});
        }
        return solved(given, output_step, own, progress);
      },
      py::arg("case"), py::arg("output_step"), py::arg("laws"), py::arg("progress"));
  module.def("has_spectrum", [](const PyCase& given) { return given.c.excitation.spectrum.has_value(); });
  module.def("spectral_gap_json", [](const PyCase& given) {
    const Case& c = given.c;
    return spectral_gap_json(c, given.problem, spectral_gaps(given.problem, *c.excitation.spectrum, c.code, c.units),
                             BENTUR_VERSION);
  });
  module.def("report_output_step", [](const PyCase& given) { return report_output_step(given.problem); });
  module.def("modes_json", &modes, py::arg("case"), py::arg("jacobi"));
}

void bind_laws(py::module_& module) {
  py::class_<ContactLaw, std::shared_ptr<ContactLaw>>(module, "ContactLaw");
  py::class_<ForceLaw, ContactLaw, std::shared_ptr<ForceLaw>>(module, "ForceLaw")
      .def(py::init<std::string, py::function, py::object>(), py::arg("name"), py::arg("force"), py::arg("energy"));
  py::class_<BranchLaw, ContactLaw, std::shared_ptr<BranchLaw>>(module, "BranchLaw")
      .def(py::init([](const std::string& name, const py::list& branches) {
             std::vector<BranchData> data;
             for (const py::handle one : branches) {
               BranchData branch;
               branch.touching = one.attr("touching").cast<bool>();
               branch.base = one.attr("base").cast<double>();
               branch.stiffness = one.attr("stiffness").cast<double>();
               branch.damping = one.attr("damping").cast<double>();
               branch.unloading_stiffness = one.attr("unloading_stiffness").cast<double>();
               for (const py::handle guard : one.attr("guards")) {
                 branch.guards.push_back({.constant = guard.attr("constant").cast<double>(),
                                          .deformation = guard.attr("deformation").cast<double>(),
                                          .speed = guard.attr("speed").cast<double>()});
                 branch.then.push_back(guard.attr("then").cast<int>());
               }
               data.push_back(std::move(branch));
             }
             return std::make_shared<BranchLaw>(name, std::move(data));
           }),
           py::arg("name"), py::arg("branches"));
}

}  // namespace bentur::python
