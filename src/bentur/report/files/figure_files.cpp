#include "bentur/report/files/figure_files.h"

#include <optional>
#include <system_error>

#include "bentur/io/output/atomic_file.h"
#include "bentur/report/files/picture.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

void write_figures(const std::filesystem::path& folder, const std::vector<NamedFigure>& figures,
                   const std::vector<std::string>& formats, const OutputRules& rules) {
  AtomicFiles files(folder, rules);
  std::optional<NoConverter> missing;
  for (const auto& [name, figure] : figures) {
    const FigureText text = figure_text(figure, name);
    files.add(name + std::string(figure_data_ending), text.data, ResultKind::figure_data);
    files.add(name + ".py", text.script, ResultKind::figure_script);
    for (const std::string& format : formats) {
      if (missing && format != "svg") continue;
      try {
        std::string file = name;
        file.append(".").append(format);
        files.add(file, draw(figure, format), ResultKind::picture);
      } catch (const NoConverter& error) {
        missing = error;
      }
    }
  }
  files.commit();
  if (missing) throw NoConverter(*missing);
}

void expect_figure(const std::filesystem::path& folder, const std::string& name,
                   const std::vector<std::string>& formats, const OutputRules& rules) {
  const auto expect = [&](const std::string& ending, ResultKind kind) {
    static_cast<void>(output_target(folder / (name + ending), kind, rules));
  };
  expect(std::string(figure_data_ending), ResultKind::figure_data);
  expect(".py", ResultKind::figure_script);
  for (const std::string& format : formats) expect("." + format, ResultKind::picture);
}

namespace {

template <class Run>
std::vector<NamedFigure> figures_of(const Run& run, const FigureOptions& options) {
  std::vector<NamedFigure> figures;
  for (const FigureKind& kind : figure_kinds(run)) {
    figures.push_back({kind.name, make_figure(run, kind.name, options)});
  }
  return figures;
}

}  // namespace

std::vector<NamedFigure> run_figures(const RunResults& results, const FigureOptions& options) {
  return figures_of(results, options);
}

std::vector<NamedFigure> run_figures(const PlanRun& run, const FigureOptions& options) {
  return figures_of(run, options);
}

void remove_run_figures(const std::filesystem::path& folder, const OutputRules& rules) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) return;
  for (const std::string& name : run_figure_names()) {
    if (!is_result(folder / (name + ".py"), ResultKind::figure_script)) continue;
    // The script last: by it the others are known.
    for (const std::string_view ending : {figure_data_ending, {".svg"}, {".pdf"}, {".png"}, {".py"}}) {
      const std::filesystem::path file = folder / (name + std::string(ending));
      if (!rules.is_input(file)) std::filesystem::remove(file, ignored);
    }
  }
  std::filesystem::remove(folder, ignored);  // fails, as it should, where something else is in it
}

}  // namespace bentur
