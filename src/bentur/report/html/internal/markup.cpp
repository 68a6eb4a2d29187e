#include "bentur/report/html/internal/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/utf8.h"

namespace bentur::html {
namespace {

constexpr const char* no_unit = "\xC2\xA0";  // a space that keeps the line

}  // namespace

Html Html::text(std::string_view any) { return Html(markup_text(any)); }

Html element(std::string_view name, const Html& content, std::string_view attributes) {
  std::string tag = "<" + std::string(name);
  if (!attributes.empty()) tag += " " + std::string(attributes);
  return Html::markup(tag + ">") + content + Html::markup("</" + std::string(name) + ">");
}

Html element(std::string_view name, std::string_view text, std::string_view attributes) {
  return element(name, Html::text(text), attributes);
}

Html under(std::string_view level, std::string_view heading, const HtmlTable& table) {
  return table.rows() == 0 ? Html() : element(level, heading) + table.called(heading).markup();
}

Html fold(std::string_view level, std::string_view heading, const Html& content) {
  return element("details", element("summary", element(level, heading)) + content, "class=\"fold\" open");
}

Html json_markup(std::string_view json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return Html::markup(text);
}

Html json_script(std::string_view id, std::string_view json) {
  return element("script", json_markup(json), "type=\"application/json\" id=\"" + std::string(id) + "\"") +
         Html::markup("\n");
}

void HtmlTable::add(const std::string& name, const std::string& unit, const std::vector<double>& values) {
  add(name, unit, column(values), true, values);
}

void HtmlTable::add(const std::string& name, const std::string& unit, std::vector<std::string> cells, bool numeric,
                    std::vector<double> values) {
  columns_.push_back({name, unit, std::move(cells), numeric, std::move(values)});
}

HtmlTable HtmlTable::called(std::string_view title) const {
  HtmlTable one = *this;
  one.title_ = title;
  return one;
}

void HtmlTable::make_alike(Column& column) {
  if (column.values.empty()) return;
  constexpr std::string_view bound = "≤ ";
  constexpr int digits = 4, of_least = 2;
  const std::vector<std::string> alike = bentur::column(column.values, digits, of_least);
  for (std::size_t row = 0; row < alike.size(); ++row) {
    if (std::isnan(column.values[row])) continue;
    std::string& cell = column.cells.at(row);
    cell = (cell.starts_with(bound) ? std::string(bound) : "") + alike[row];
  }
}

void HtmlTable::add(const HtmlTable& other) {
  columns_.insert(columns_.end(), other.columns_.begin(), other.columns_.end());
}

void HtmlTable::add_new(const HtmlTable& other) {
  const std::vector<Column> mine = columns_;
  for (const Column& column : other.columns_) {
    const auto says_it = [&](const Column& one) { return one.name.ends_with(column.name); };
    if (std::none_of(mine.begin(), mine.end(), says_it)) columns_.push_back(column);
  }
}

void HtmlTable::join(const std::string& name, const HtmlTable& other) {
  if (other.rows() == 0) return;
  if (title_.empty()) title_ = other.title_;
  if (columns_.empty()) add("", "", std::vector<std::string>(), false);
  const std::size_t all = rows() + other.rows();
  columns_.front().cells.resize(all, name);
  std::vector<char> taken(columns_.size() + other.columns_.size());  // names repeat, as that of what is without contact
  for (const Column& column : other.columns_) {
    std::size_t i = 1;
    const auto fits = [&] { return columns_[i].name == column.name && columns_[i].unit == column.unit; };
    while (i < columns_.size() && (taken[i] != 0 || !fits())) ++i;
    if (i == columns_.size()) add(column.name, column.unit, {}, column.numeric);
    taken[i] = 1;
    Column& mine = columns_[i];
    mine.cells.resize(all - other.rows());
    mine.cells.insert(mine.cells.end(), column.cells.begin(), column.cells.end());
    if (column.values.empty()) continue;
    mine.values.resize(all - other.rows(), not_known);
    mine.values.insert(mine.values.end(), column.values.begin(), column.values.end());
  }
  for (Column& column : columns_) {
    column.cells.resize(all);
    if (!column.values.empty()) column.values.resize(all, not_known);
  }
}

std::vector<std::string> HtmlTable::take_alike() {
  std::vector<std::string> alike;
  if (rows() < 2) return alike;
  for (std::size_t i = 1; i < columns_.size();) {
    const auto& [name, unit, cells, numeric, values] = columns_[i];
    const bool is_alike =
        !cells.front().empty() && std::count(cells.begin(), cells.end(), cells.front()) == std::ssize(cells);
    if (!is_alike) {
      ++i;
      continue;
    }
    const std::string value = numeric ? signed_text(cells.front()) : cells.front();
    alike.push_back(name + " " + value + (unit.empty() ? "" : no_unit + unit));
    columns_.erase(columns_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return alike;
}

std::vector<HtmlTable> HtmlTable::in_page_widths() const {
  constexpr std::size_t most = 118, between = 2;  // letters of a page in print, and of the room between columns
  std::vector<HtmlTable> parts;
  std::size_t taken = most;
  for (std::size_t i = 1; i < columns_.size(); ++i) {
    taken += letters(columns_[i]) + between;
    if (taken > most) {
      parts.emplace_back().columns_ = {columns_.front()};
      parts.back().title_ = title_;
      taken = letters(columns_.front()) + between + letters(columns_[i]) + between;
    }
    parts.back().columns_.push_back(columns_[i]);
  }
  return parts;
}

std::vector<std::string> HtmlTable::names_from(std::size_t first) const {
  std::vector<std::string> names;
  for (std::size_t i = first; i < columns_.size(); ++i) {
    if (std::find(names.begin(), names.end(), columns_[i].name) == names.end()) names.push_back(columns_[i].name);
  }
  return names;
}

std::size_t HtmlTable::letters(const Column& column) {
  std::size_t most = characters(column.unit).size();
  for (std::size_t from = 0; from <= column.name.size();) {
    const std::size_t to = std::min(column.name.find(' ', from), column.name.size());
    most = std::max(most, characters(std::string_view(column.name).substr(from, to - from)).size());
    from = to + 1;
  }
  for (const std::string& cell : column.cells) most = std::max(most, characters(cell).size());
  return most;
}

bool HtmlTable::is_broad() const {
  constexpr double most = 46, between = 1.5;  // letters of a telephone's width, and of the room between columns
  double all = 0;
  for (const Column& column : columns_) all += static_cast<double>(letters(column)) + between;
  return columns_.size() > 2 && all > most;
}

bool HtmlTable::is_long(const Column& column) {
  constexpr std::size_t longest = 26;  // letters of two lines in a third of a card; what is longer has its own line
  return !column.numeric && letters(column) > longest;
}

std::size_t HtmlTable::telling() const {
  std::vector<std::string> titles(rows());
  std::size_t best = 1, most = 0;
  for (std::size_t count = 1; count < columns_.size() && most < rows(); ++count) {
    for (std::size_t row = 0; row < rows(); ++row) titles[row] += columns_[count - 1].cells[row] + '\n';
    const std::size_t apart = std::set(titles.begin(), titles.end()).size();
    if (apart > most) best = count;
    most = std::max(most, apart);
  }
  return best;
}

const char* HtmlTable::cards() const {
  const auto other = std::count_if(columns_.begin() + static_cast<std::ptrdiff_t>(telling()), columns_.end(),
                                   [](const Column& one) { return !is_long(one); });
  const auto fullness = [&](double of_line) {  // of the last line
    const double left = std::fmod(static_cast<double>(other), of_line);
    return left > 0 ? left / of_line : 1;
  };
  return fullness(4) > fullness(3) ? "cards four" : "cards";
}

Html HtmlTable::markup(std::string_view attributes, OnTelephone form) const {
  const auto of_class = [&](const char* name, Heads heads) {
    return written(fmt::format("{}{}class=\"{}\"", attributes, attributes.empty() ? "" : " ", name), heads, rows());
  };
  switch (form) {
    case OnTelephone::gaps:
      return of_class("gaps", Heads::in_cells);
    case OnTelephone::checks:
      return of_class("checks", Heads::in_cells);
    case OnTelephone::said:
      return of_class("said", Heads::above);
    case OnTelephone::as_fits:
      break;
  }
  return is_broad() ? of_class(cards(), Heads::in_cells) : written(attributes, Heads::above, rows());
}

Html HtmlTable::printed(std::size_t most) const {
  HtmlTable whole = *this;
  for (Column& column : whole.columns_) make_alike(column);
  return whole.written("", Heads::above, most);
}

Html HtmlTable::written(std::string_view attributes, Heads heads, std::size_t most) const {
  if (columns_.empty()) return {};
  const std::size_t titled = heads == Heads::in_cells ? telling() : 1;  // columns that are the title of a card
  const auto head_of = [](const Column& one) { return one.unit.empty() ? one.name : with_unit(one.name, one.unit); };
  std::vector<std::string> alignments;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::string classes = columns_[i].numeric ? "" : "t";
    if (heads == Heads::in_cells && is_long(columns_[i])) classes += " long";
    if (i > 0 && i < titled) classes += classes.empty() ? "told" : " told";
    alignments.push_back(classes.empty() ? "" : fmt::format("class=\"{}\"", classes));
  }
  const bool units =
      std::any_of(columns_.begin(), columns_.end(), [](const Column& column) { return !column.unit.empty(); });
  Html head;
  for (const Column& column : columns_) {
    Html name = Html::text(column.name);
    if (units) name += Html::markup("<br>") + element("small", column.unit.empty() ? no_unit : column.unit);
    // A heading without a word would be read out as one.
    const bool is_heading = !column.name.empty();
    head += element(is_heading ? "th" : "td", name,
                    std::string(is_heading ? "scope=\"col\"" : "") + (column.numeric ? "" : " class=\"t\""));
  }
  Html body;
  std::map<std::string, int> called;  // cards so far
  for (std::size_t row = 0; row < std::min(rows(), most); ++row) {
    Html line;
    for (const Column& column : columns_) {
      std::string about = alignments[static_cast<std::size_t>(&column - columns_.data())];
      const auto put = [&](const char* name, const std::string& text) {
        about += std::string(about.empty() ? "" : " ") + name + "=\"" + Html::text(text).str() + "\"";
      };
      if (&column == &columns_.front() && row < titles_.size()) put("title", titles_[row]);
      if (heads == Heads::in_cells) put("data-head", head_of(column));
      if (&column == &columns_.front() && heads == Heads::in_cells) {
        std::string rest;
        for (std::size_t i = 1; i < titled; ++i) {
          const Column& one = columns_[i];
          rest += ", " + (one.numeric ? head_of(one) + " " + signed_text(one.cells.at(row)) : one.cells.at(row));
        }
        const int times = ++called[column.cells.at(row) + rest];
        if (times > 1) rest += fmt::format(" ({})", times);
        if (!rest.empty()) put("data-rest", rest);
      }
      line += element("td", column.numeric ? signed_text(column.cells.at(row)) : column.cells.at(row), about);
    }
    const auto is_among = [&](const std::vector<std::size_t>& rows) {
      return std::find(rows.begin(), rows.end(), row) != rows.end();
    };
    const char* const of_row = !is_among(in_sight_) ? (is_among(marked_) ? "class=\"marked\"" : "")
                               : is_among(marked_)  ? "class=\"marked in-sight\""
                                                    : "class=\"in-sight\"";
    body += element("tr", line, of_row) + Html::markup("\n");
  }
  Html title;  // shown in print alone, where the head of a table stands on each of its pages
  std::string about(attributes);
  if (!title_.empty()) {
    title = element("tr", element("th", title_, fmt::format("scope=\"colgroup\" colspan=\"{}\"", columns_.size())),
                    "class=\"titles\" hidden");
    about += fmt::format("{}aria-label=\"{}\"", about.empty() ? "" : " ", Html::text(title_).str());
  }
  const Html table =
      element("thead", title + element("tr", head)) + Html::markup("\n") + element("tbody", Html::markup("\n") + body);
  return element("div", element("table", table, about), "class=\"wide\" tabindex=\"0\"") + Html::markup("\n");
}

Html facts(const std::vector<std::pair<std::string, std::string>>& rows, const std::vector<std::string>& sources) {
  Html body;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Html source = sources.empty() ? Html() : element("td", sources.at(i), "class=\"note\"");
    body += element("tr", element("th", rows[i].first, "scope=\"row\"") + element("td", rows[i].second) + source) +
            Html::markup("\n");
  }
  return element("div", element("table", element("tbody", body), "class=\"facts\""), "class=\"wide\" tabindex=\"0\"") +
         Html::markup("\n");
}

}  // namespace bentur::html
