#include "bentur/report/html/internal/markup.h"

#include <algorithm>
#include <optional>
#include <utility>

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
  add(name, unit, column(values));
}

void HtmlTable::add(const std::string& name, const std::string& unit, std::vector<std::string> cells, bool numeric) {
  columns_.push_back({name, unit, std::move(cells), numeric});
}

void HtmlTable::add(const HtmlTable& other) {
  columns_.insert(columns_.end(), other.columns_.begin(), other.columns_.end());
}

void HtmlTable::join(const std::string& name, const HtmlTable& other) {
  if (other.rows() == 0) return;
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
    std::vector<std::string>& cells = columns_[i].cells;
    cells.resize(all - other.rows());
    cells.insert(cells.end(), column.cells.begin(), column.cells.end());
  }
  for (Column& column : columns_) column.cells.resize(all);
}

std::vector<std::string> HtmlTable::names_from(std::size_t first) const {
  std::vector<std::string> names;
  for (std::size_t i = first; i < columns_.size(); ++i) {
    if (std::find(names.begin(), names.end(), columns_[i].name) == names.end()) names.push_back(columns_[i].name);
  }
  return names;
}

Html HtmlTable::markup(std::string_view attributes, std::size_t most) const {
  if (columns_.empty()) return {};
  const auto alignment = [](const Column& column) { return column.numeric ? "" : "class=\"t\""; };
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
  // On a phone each cell has its heading.
  const bool as_cards =
      attributes.find("cards") != std::string_view::npos || attributes.find("gaps") != std::string_view::npos;
  for (std::size_t row = 0; row < std::min(rows(), most); ++row) {
    Html line;
    for (const Column& column : columns_) {
      std::string attributes_of_cell = alignment(column);
      if (&column == &columns_.front() && row < titles_.size()) {
        attributes_of_cell += " title=\"" + Html::text(titles_[row]).str() + "\"";
      }
      if (as_cards) {
        const std::string heading = column.unit.empty() ? column.name : with_unit(column.name, column.unit);
        attributes_of_cell += " data-head=\"" + Html::text(heading).str() + "\"";
      }
      line +=
          element("td", column.numeric ? signed_text(column.cells.at(row)) : column.cells.at(row), attributes_of_cell);
    }
    const bool marked = std::find(marked_.begin(), marked_.end(), row) != marked_.end();
    body += element("tr", line, marked ? "class=\"marked\"" : "") + Html::markup("\n");
  }
  const Html table =
      element("thead", element("tr", head)) + Html::markup("\n") + element("tbody", Html::markup("\n") + body);
  return element("div", element("table", table, attributes), "class=\"wide\" tabindex=\"0\"") + Html::markup("\n");
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
