#include "bentur/report/figures/figure_files.h"

#include <optional>

#include "bentur/io/results/atomic_file.h"
#include "bentur/io/results/netcdf_reader.h"
#include "bentur/report/figures/gnuplot.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

void write_figures(const std::filesystem::path& folder, const std::vector<NamedFigure>& figures,
                   const std::vector<std::string>& formats) {
  AtomicFiles files(folder);
  std::optional<NoGnuplot> missing;
  for (const auto& [name, figure] : figures) {
    const FigureText text = figure_text(figure, name);
    files.add(name + ".dat", text.data);
    files.add(name + ".gp", text.script);
    for (const std::string& format : formats) {
      if (missing) break;
      try {
        std::string file = name;
        file.append(".").append(format);
        files.add(file, draw(text, name, format));
      } catch (const NoGnuplot& error) {
        missing = error;
      }
    }
  }
  files.commit();
  if (missing) throw NoGnuplot(*missing);
}

std::vector<std::string> write_run_figures(const std::filesystem::path& folder, const std::string& histories,
                                           const std::vector<std::string>& formats) {
  const NetcdfReader results(histories, "histories.nc");
  std::vector<NamedFigure> figures;
  std::vector<std::string> names;
  for (const FigureKind& kind : figure_kinds(results)) {
    figures.push_back({kind.name, make_figure(results, kind.name)});
    names.push_back(kind.name);
  }
  // First the old ones: a picture must never stand beside data of another run.
  for (const std::string& name : run_figure_names()) {
    std::error_code ignored;
    for (const char* ending : {".dat", ".gp", ".svg", ".pdf", ".png"}) {
      std::filesystem::remove(folder / (name + ending), ignored);
    }
  }
  write_figures(folder, figures, formats);
  return names;
}

}  // namespace bentur
