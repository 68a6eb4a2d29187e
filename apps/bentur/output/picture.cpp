#include "output/picture.h"

#include <fmt/format.h>

#include <utility>

#include "bentur/report/files/picture.h"
#include "bentur/report/words.h"
#include "session.h"

namespace bentur::cli {

RunPictures::RunPictures(const RunFolder& results, std::vector<std::string> formats)
    : folder_(results.folder() / "figures"), formats_(std::move(formats)), rules_(results.rules()) {
  if (formats_.empty()) return;
  for (const std::string& name : run_figure_names()) expect_figure(folder_, name, formats_, rules_);
}

void RunPictures::write(const std::vector<NamedFigure>& figures, bool quiet) const {
  try {
    write_figures(folder_, figures, formats_, rules_);
    if (quiet) return;
    std::string list;
    for (const NamedFigure& one : figures) list += (list.empty() ? "" : ", ") + one.name;
    message(fmt::format("Wrote the figures {} into {}", list, folder_.string()));
    tell_letters(figures);
  } catch (const NoConverter& error) {
    message(fmt::format("bentur: {}; all else is in {}", error.what(), folder_.string()));
  }
}

FigureOptions RunPictures::options(const std::string& language) {
  FigureOptions options;
  options.say = figure_words(language);
  options.language = language;
  return options;
}

}  // namespace bentur::cli
