#include "bentur/report/html/internal/page_figures.h"

#include <algorithm>
#include <cmath>

#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/kinds/figure_width.h"
#include "bentur/report/kinds/internal/kind_table.h"
#include "bentur/report/words.h"

namespace bentur::html {
namespace {

/// More panels than `most` one below another: two side by side over a page's width, an odd one over both columns.
void spread(Figure& figure, std::size_t most) {
  std::vector<Panel>& panels = figure.panels;
  if (figure.columns > 1 || figure.width > column_width || panels.size() <= most || !figure.shares.empty()) return;
  const auto takes_room = [](const Panel& one) { return one.to_scale || one.rows > 1; };
  if (std::any_of(panels.begin(), panels.end(), takes_room)) return;
  figure.columns = 2;
  figure.width = page_width;
  std::size_t first = 0;  // of those that stand together
  for (std::size_t end = 1; end <= panels.size(); ++end) {
    if (end < panels.size() && !panels[end].begins_row) continue;
    const std::size_t paired = (end - first) / 2 * 2;
    if (first + paired < end) panels[end - 1].across = 2;
    if (paired > 0) {
      Axis &left = panels[first + paired - 2].x, &right = panels[first + paired - 1].x;
      if (left.label.empty()) left.label = right.label;
      left.numbers = left.numbers || right.numbers;
    }
    first = end;
  }
}

/// Of what is on paper a line by itself, or half a line: three of pictures so high with their captions fill a page, or
/// two of those that have three rows of panels or more.
constexpr double third_of_page = 8.05, half_of_page = 12.4;  // [cm]

std::size_t rows_of(const Figure& figure) { return figure.panels.size() / static_cast<std::size_t>(figure.columns); }

double room_of(const Figure& figure) {
  const auto is_picture = [](const Panel& one) { return one.to_scale; };
  const bool has_pictures = std::any_of(figure.panels.begin(), figure.panels.end(), is_picture);
  return rows_of(figure) >= 3 && !has_pictures ? half_of_page : third_of_page;
}

/// Of a caption below a figure over the page, or over half of it, in lines as report.css prints them [cm].
double caption_height(const std::string& caption, bool is_wide) {
  constexpr double of_line = 0.34, free = 0.25;                                           // [cm]
  const double letters = is_wide ? 120 : 58;                                              // of a line
  return free + of_line * std::ceil(static_cast<double>(caption.size() + 10) / letters);  // with its number
}

/// Above and below the end of a row near its middle, where what follows begins by itself, if it has any, or of an odd
/// number of rows each by itself: pages may end there.
std::vector<Figure> parted(const Figure& figure) {
  const std::vector<Panel>& panels = figure.panels;
  const auto stands_alone = [](const Panel& one) { return one.rows == 1 && one.across == 1; };
  const bool is_plain = std::all_of(panels.begin(), panels.end(), stands_alone);
  const auto columns = static_cast<std::size_t>(figure.columns);
  const std::size_t rows = rows_of(figure);
  std::size_t length = 0;  // of the first part
  for (std::size_t i = 1; i < panels.size() && length == 0; ++i) {
    if (panels[i].begins_row) length = i;
  }
  const bool is_in_two = length > 0;
  if (!is_in_two && is_plain && rows * columns == panels.size()) length = (rows % 2 == 0 ? rows / 2 : 1) * columns;
  if (length == 0) return {figure};
  std::vector<Figure> parts;
  for (std::size_t first = 0; first < panels.size();) {
    const std::size_t end = is_in_two && first > 0 ? panels.size() : std::min(first + length, panels.size());
    Figure& part = parts.emplace_back(figure);
    part.panels.assign(panels.begin() + static_cast<std::ptrdiff_t>(first),
                       panels.begin() + static_cast<std::ptrdiff_t>(end));
    part.panels.front().begins_row = false;
    first = end;
  }
  return parts;
}

/// A figure and what it is called.
struct Drawn {
  std::string kind, caption;
  Figure narrowest;        ///< as it was made
  Figure figure;           ///< as a page has it
  bool is_parted = false;  ///< is higher than a line
  double height = 0;       ///< of a wide one with its caption [cm]
  [[nodiscard]] bool is_wide() const { return figure.width > column_width; }
  [[nodiscard]] double below() const { return caption_height(caption, is_wide()); }
};

/// Wide figures by pages: where the next one has no room below those before it the first of the others that has. What
/// is parted begins where its first half has room, and what follows it stands below its second. @param room of the
/// first page [cm]
void fill_pages(std::vector<Drawn>::iterator first, std::vector<Drawn>::iterator last, double room) {
  constexpr double page = 26, between = 0.3;  // [cm]
  for (; first != last; ++first) {
    const auto next = std::find_if(
        first, last, [&](const Drawn& one) { return one.height / (one.is_parted ? 2 : 1) + between <= room; });
    if (next == last) {
      room = page;
    } else {
      std::rotate(first, next, next + 1);
    }
    room -= first->height + between;
    if (room < 0 && first->is_parted) room += page;
  }
}

/// Those of a column's width, of which two stand to a line, then wide ones, those that take more than a line last but
/// for where they fill a page: so the least of pages stays empty.
void order(std::vector<Drawn>& figures) {
  const auto is_narrow = [](const Drawn& one) { return !one.is_wide(); };
  bool is_odd = std::count_if(figures.begin(), figures.end(), is_narrow) % 2 != 0;
  for (auto one = figures.rbegin(); is_odd && one != figures.rend(); ++one) {
    if (!is_narrow(*one)) continue;
    spread(one->figure, 1);
    is_odd = is_narrow(*one);
  }
  for (auto one = figures.rbegin(); is_odd && one != figures.rend(); ++one) {  // one frame over the whole width
    if (!is_narrow(*one) || one->figure.panels.size() > 1 || one->figure.panels.front().to_scale) continue;
    one->figure.width = page_width;
    is_odd = false;
  }
  for (Drawn& one : figures) {
    Figure low = one.figure;
    const double room = room_of(low);
    bound_height(low, room - one.below());
    one.height = layout(low).height + one.below();
    one.is_parted = one.is_wide() && one.height > room + 0.5;
    if (one.is_parted) one.height = layout(one.figure).height + one.below();
  }
  std::stable_partition(figures.begin(), figures.end(), [](const Drawn& one) { return !one.is_parted; });
  const auto wide = std::stable_partition(figures.begin(), figures.end(), is_narrow);
  constexpr double below_heading = 24.5;  // [cm]
  const auto lines = static_cast<double>((wide - figures.begin() + 1) / 2);
  fill_pages(wide, figures.end(), below_heading - std::fmod(lines, 3) * third_of_page);
}

}  // namespace

std::vector<PageFigure> page_figures(const std::vector<FigureKind>& kinds, const MakeKind& make,
                                     const std::string& family, const std::string& language) {
  const Words say(language);
  std::vector<Drawn> all;
  FigureOptions options;
  options.say = figure_words(language);
  options.language = language;
  options.choose = true;
  for (const FigureKind& kind : kinds) {
    if (!kind.tells) continue;
    try {
      const Figure figure = make(kind.name, options);
      std::string caption = say(family + kind.name + (figure.lacks.empty() ? "" : ".without_" + figure.lacks));
      if (!figure.part.empty()) caption += ". " + figure.part;
      spread(all.emplace_back(Drawn{std::string(kind.name), caption, figure, figure}).figure, 2);
    } catch (const NoFigure&) {  // this one has nothing to show
      continue;
    }
  }
  order(all);
  std::vector<PageFigure> figures;
  for (const auto& [kind, caption, narrowest, figure, is_parted, height] : all) {
    PageFigure& shown = figures.emplace_back();
    shown.caption = caption;
    shown.wide = figure.width > column_width;
    std::vector<Figure> parts = is_parted ? parted(figure) : std::vector{figure};
    shown.is_parted = parts.size() > 1;
    for (Figure& part : parts) {
      bound_height(part, (shown.is_parted ? third_of_page : room_of(part)) - caption_height(caption, shown.wide));
      shown.svg += figure_element(part, caption);
    }
    if (!shown.wide) continue;
    const auto made = [&, of = kind](const FigureOptions& with) { return make(of, with); };
    Figure slim = narrowest.width < figure.width ? narrowest : narrow_figure(made, options);
    bound_height(slim, 15);  // of a telephone's screen, of whose width it is
    if (slim.width < figure.width) shown.slim = figure_element(slim, caption);
  }
  return figures;
}

}  // namespace bentur::html
