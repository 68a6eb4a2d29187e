#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "tests/invariance/random_case.h"

namespace bentur::test {

inline std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{:.17g}", text.empty() ? "" : ", ", value);
  return "[" + text + "]";
}

inline std::string rows(const Eigen::MatrixXd& matrix) {
  std::string text;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    text += (text.empty() ? "" : ", ") + list({row.begin(), row.end()});
  }
  return "[" + text + "]";
}

inline std::string text_of(const Section& section) {
  return fmt::format("[{{ area = {:.17g}, inertia = {:.17g}, mass = {:.17g} }}]", section.area, section.inertia,
                     section.mass);
}

inline std::string text_of(const BuildingSpec& building) {
  std::string text = fmt::format("[[building]]\nname = \"{}\"\n", building.name);
  if (const auto* modal = std::get_if<ModalDamping>(&building.damping)) {
    text += modal->ratios.size() == 1 ? fmt::format("damping = {:.17g}\n", modal->ratios[0])
                                      : fmt::format("damping = {{ modal = {} }}\n", list(modal->ratios));
  } else if (const auto* rayleigh = std::get_if<RayleighDamping>(&building.damping)) {
    text += fmt::format("damping = {{ rayleigh = {{ ratios = {}, periods = {} }} }}\n", list(rayleigh->ratios),
                        list(rayleigh->periods));
  } else if (const auto* mass = std::get_if<MassProportionalDamping>(&building.damping)) {
    text += fmt::format("damping = {{ mass_proportional = {:.17g} }}\n", mass->ratio);
  }
  if (const auto* frame = std::get_if<PlaneFrame>(&building.structure)) {
    text += fmt::format(
        "[building.frame]\nelastic_modulus = {:.17g}\nstorey_heights = {}\nbay_widths = {}\ncolumns = {}\nbeams = {}\n"
        "floor_masses = {}\nmass_matrix = \"{}\"\ncondensation = \"{}\"\n",
        frame->elastic_modulus, list(frame->storey_heights), list(frame->bay_widths), text_of(frame->columns[0]),
        text_of(frame->beams[0]), list(frame->floor_masses),
        frame->mass_matrix == MassMatrix::lumped ? "lumped" : "consistent",
        frame->condensation == Condensation::static_   ? "static"
        : frame->condensation == Condensation::dynamic ? "dynamic"
                                                       : "none");
  } else if (const auto* stick = std::get_if<Stick>(&building.structure)) {
    text += fmt::format("[building.stick]\nstorey_heights = {}\nmasses = {}\nstiffnesses = {}\n",
                        list(stick->storey_heights), list(stick->masses), list(stick->stiffnesses));
  } else {
    const auto& matrices = std::get<MatricesSpec>(building.structure);
    text += fmt::format("[building.matrices]\nelevations = {}\nmass = {}\nstiffness = {}\n", list(matrices.elevations),
                        rows(matrices.mass), rows(matrices.stiffness));
    if (const auto* damping = std::get_if<MatrixDamping>(&building.damping)) {
      text += fmt::format("damping = {}\n", rows(damping->matrix));
    }
  }
  return text;
}

inline std::string text_of(const ContactSpec& contact) {
  std::string text = fmt::format("law = \"{}\"", contact.law);
  for (const auto& [key, values] : contact.numbers) text += fmt::format(", {} = {:.17g}", key, values[0]);
  for (const auto& [key, word] : contact.words) text += fmt::format(", {} = \"{}\"", key, word);
  return text;
}

inline std::string text_of(const Case& c, const std::string& record) {
  std::string text = fmt::format("title = \"{}\"\n", c.title);
  for (const BuildingSpec& building : c.buildings) text += text_of(building);
  for (std::size_t g = 0; g < c.gaps.size(); ++g) {
    text += fmt::format("[[gap]]\nbetween = [\"{}\", \"{}\"]\nelevations = {}\nwidth = {}\ncontact = {{ {} }}\n",
                        c.buildings[g].name, c.buildings[g + 1].name, list(c.gaps[g].elevations),
                        list(c.gaps[g].widths), text_of(c.gaps[g].contact));
  }
  text += "[excitation]\n";
  if (const auto* sampled = std::get_if<SampledMotion>(&c.excitation.motion)) {
    text += fmt::format("kind = \"record\"\nfile = \"{}\"\nunit = \"m/s2\"\ntime_step = {:.17g}\n", record,
                        sampled->time_step);
  } else if (const auto* harmonic = std::get_if<HarmonicMotion>(&c.excitation.motion)) {
    text += fmt::format("kind = \"harmonic\"\nperiod = {:.17g}\nphase = \"{}\"\ndisplacement_amplitude = {:.17g}\n",
                        harmonic->period, harmonic->phase == HarmonicMotion::Phase::sine ? "sine" : "cosine",
                        harmonic->displacement_amplitude);
  } else {
    text += "kind = \"none\"\n";
  }
  if (!std::holds_alternative<NoMotion>(c.excitation.motion)) {
    text += fmt::format("delays = {}\n", list(c.excitation.delays));
    if (c.excitation.kinematics == Kinematics::absolute) text += "kinematics = \"absolute\"\n";
  }
  const auto initial = [&](const char* key, const std::vector<std::vector<double>>& values) {
    if (values.empty()) return;
    std::string entries;
    for (std::size_t b = 0; b < values.size(); ++b) {
      entries += fmt::format("{}{} = {}", b == 0 ? "" : ", ", c.buildings[b].name, list(values[b]));
    }
    text += fmt::format("{} = {{ {} }}\n", key, entries);
  };
  if (!c.initial.velocities.empty()) text += "[initial]\n";
  initial("displacements", c.initial.displacements);
  initial("velocities", c.initial.velocities);
  return text + fmt::format("[analysis]\nduration = {:.17g}\n", c.analysis.duration);
}

/// Writes the case so that the program can run it, its record beside it.
inline void write_case(const Case& c, const std::filesystem::path& folder, const std::string& name) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / (name + ".toml")) << text_of(c, name + ".txt");
  if (const auto* sampled = std::get_if<SampledMotion>(&c.excitation.motion)) {
    std::ofstream record(folder / (name + ".txt"));
    for (const double a : sampled->acceleration) record << fmt::format("{:.17g}\n", a);
  }
}

}  // namespace bentur::test
