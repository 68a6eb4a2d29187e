#include "bentur/report/files/figure_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/io/json_position.h"
#include "bentur/report/figures/internal/colours.h"

namespace bentur {
namespace {

using Node = nlohmann::json;

/// Reads each value into its member, and says of each that is none what it must be.
class Reader {
 public:
  Reader(const std::string& file, Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

  void read(const Node& node, const std::string& where, Figure& to) {
    table(node, where,
          {field("title", to.title), field("finding", to.finding), field("panels", to.panels),
           field("columns", to.columns), field("shares", to.shares), field("width", to.width),
           field("shared_legend", to.shared_legend)});
    if (to.columns < 1) error(where + "columns", std::to_string(to.columns), "must be 1 or more");
    if (!(to.width >= 2 && to.width <= 100)) error(where + "width", fmt::format("{}", to.width), "must be in [2, 100]");
  }

 private:
  struct Field {
    std::string key;
    std::function<void(const Node&, const std::string&)> read;
  };

  template <class T>
  Field field(std::string key, T& to) {
    return {std::move(key), [this, &to](const Node& node, const std::string& where) { read(node, where, to); }};
  }

  void error(const std::string& key, const std::string& value, const std::string& rule) {
    diagnostics_.add({.position = {.file = file_}, .key = key, .value = value, .rule = rule});
  }

  void table(const Node& node, const std::string& where, const std::vector<Field>& fields) {
    if (!node.is_object()) return error(where, kind(node), "must be a table of keys");
    for (const auto& [key, value] : node.items()) {
      const std::string& name = key;
      const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& one) { return one.key == name; });
      const std::string path = fmt::format("{}{}{}", where, where.empty() ? "" : ".", key);
      if (found != fields.end()) {
        found->read(value, path);
        continue;
      }
      std::vector<std::string> known;
      for (const Field& one : fields) known.push_back(one.key);
      const std::string near = nearest(key, known);
      const std::string others = near.empty() ? fmt::format(", must be one of {}", fmt::join(known, ", ")) : "";
      diagnostics_.add({.position = {.file = file_},
                        .key = path,
                        .rule = "is not a known key" + others,
                        .suggestion = near,
                        .unknown_key = true});
    }
  }

  static std::string kind(const Node& node) {
    if (node.is_object()) return "a table";
    if (node.is_array()) return "a list";
    return node.dump(-1, ' ', false, Node::error_handler_t::replace);
  }

  void read(const Node& node, const std::string& where, Panel& to) {
    table(node, where,
          {field("title", to.title), field("x", to.x), field("y", to.y), field("height", to.height),
           field("rows", to.rows), field("across", to.across), field("to_scale", to.to_scale), field("unit", to.unit),
           field("curves", to.curves), field("rules", to.rules), field("events", to.events), field("texts", to.texts),
           field("map", to.map), field("note", to.note), field("names_at_ends", to.names_at_ends)});
    if (!(to.height >= 0.5 && to.height <= 100)) {
      error(where + ".height", fmt::format("{}", to.height), "must be in [0.5, 100]");
    }
    for (const auto& [name, count] : {std::pair(".rows", to.rows), {".across", to.across}}) {
      if (count < 1) error(where + name, std::to_string(count), "must be 1 or more");
    }
  }

  void read(const Node& node, const std::string& where, Axis& to) {
    table(node, where,
          {field("label", to.label), field("from", to.from), field("to", to.to), field("logarithmic", to.logarithmic),
           field("names", to.names), field("number", to.number), field("places", to.places),
           field("numbers", to.numbers), field("least", to.least)});
    if (to.from && to.to && !(*to.from < *to.to)) {
      error(where + ".to", fmt::format("{}", *to.to), "must be greater than from");
    }
    if (to.logarithmic && ((to.from && *to.from <= 0) || (to.to && *to.to <= 0))) {
      error(where, "", "is logarithmic, and so must end above zero");
    }
  }

  void read(const Node& node, const std::string& where, Curve& to) {
    table(node, where,
          {field("label", to.label), field("x", to.x), field("y", to.y), field("top", to.top), field("tone", to.tone),
           field("line", to.line), field("mark", to.mark), field("legend_mark", to.legend_mark),
           field("width", to.width), field("complete", to.complete), field("mark_size", to.mark_size),
           field("of_several", to.of_several), field("in_legend", to.in_legend)});
    if (!(to.mark_size > 0 && to.mark_size <= 20)) {
      error(where + ".mark_size", fmt::format("{}", to.mark_size), "must be in (0, 20]");
    }
  }

  void read(const Node& node, const std::string& where, PlaceText& to) {
    table(node, where,
          {field("x", to.x), field("y", to.y), field("text", to.text), field("side", to.side), field("room", to.room),
           field("tone", to.tone)});
    if (to.room < 0) error(where + ".room", fmt::format("{}", to.room), "must be 0 or more");
  }

  void read(const Node& node, const std::string& where, RuleLine& to) {
    table(node, where,
          {field("at", to.at), field("vertical", to.vertical), field("label", to.label), field("tone", to.tone),
           field("line", to.line)});
  }

  void read(const Node& node, const std::string& where, Events& to) {
    table(node, where, {field("label", to.label), field("x", to.x)});
  }

  void read(const Node& node, const std::string& where, HeatMap& to) {
    table(node, where,
          {field("x_edges", to.x_edges), field("y_edges", to.y_edges), field("values", to.values),
           field("label", to.label), field("ratio", to.ratio), field("range", to.range)});
  }

  void read(const Node& node, const std::string& where, std::string& to) {
    if (!node.is_string()) return error(where, kind(node), "must be text");
    to = node.get<std::string>();
  }

  void read(const Node& node, const std::string& where, bool& to) {
    if (!node.is_boolean()) return error(where, kind(node), "must be true or false");
    to = node.get<bool>();
  }

  void read(const Node& node, const std::string& where, int& to) {
    if (!node.is_number_integer() || node < 0 || node > 1000) return error(where, kind(node), "must be a whole number");
    to = node.get<int>();
  }

  void read(const Node& node, const std::string& where, double& to) {
    if (!node.is_number() || !std::isfinite(node.get<double>())) return error(where, kind(node), "must be a number");
    to = node.get<double>();
    if (std::abs(to) > 1e300) error(where, kind(node), "must be in [-1e300, 1e300]");  // so that an axis has a length
  }

  void read(const Node& node, const std::string& where, std::pair<double, double>& to) {
    if (!node.is_array() || node.size() != 2) return error(where, kind(node), "must be two numbers");
    read(node[0], where + "[0]", to.first);
    read(node[1], where + "[1]", to.second);
  }

  void read(const Node& node, const std::string& where, std::vector<double>& to) {
    if (!node.is_array()) return error(where, kind(node), "must be a list of numbers");
    to.assign(node.size(), not_known);
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (!node[i].is_null()) read(node[i], fmt::format("{}[{}]", where, i), to[i]);
    }
  }

  template <class T>
  void read(const Node& node, const std::string& where, std::vector<T>& to) {
    if (!node.is_array()) return error(where, kind(node), "must be a list");
    to.resize(node.size());
    for (std::size_t i = 0; i < node.size(); ++i) read(node[i], fmt::format("{}[{}]", where, i), to[i]);
  }

  template <class T>
  void read(const Node& node, const std::string& where, std::optional<T>& to) {
    read(node, where, to.emplace());
  }

  void read(const Node& node, const std::string& where, Tone& to) {
    std::vector<std::string> names;
    for (const Colour& one : colours) names.emplace_back(one.name);
    names.front() = "black";  // on paper
    word(node, where, to, names);
  }

  void read(const Node& node, const std::string& where, PlaceText::Side& to) {
    word(node, where, to, {"right", "left", "above", "below", "middle"});
  }

  void read(const Node& node, const std::string& where, Line& to) {
    word(node, where, to, {"none", "solid", "dashed", "dotted", "dash-dot", "long-dash", "dash-dot-dot"});
  }

  void read(const Node& node, const std::string& where, Mark& to) {
    word(node, where, to, {"none", "disc", "circle", "square", "triangle", "diamond", "cross"});
  }

  /// `words` in the order of the enumeration.
  template <class T>
  void word(const Node& node, const std::string& where, T& to, const std::vector<std::string>& words) {
    const auto found = node.is_string() ? std::find(words.begin(), words.end(), node.get<std::string>()) : words.end();
    if (found != words.end()) {
      to = static_cast<T>(std::distance(words.begin(), found));
      return;
    }
    diagnostics_.add({.position = {.file = file_},
                      .key = where,
                      .value = kind(node),
                      .rule = fmt::format("must be one of {}", fmt::join(words, ", ")),
                      .suggestion = node.is_string() ? nearest(node.get<std::string>(), words) : ""});
  }

  const std::string& file_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<Figure> figure_from_json(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  Figure figure;
  try {
    Reader(file, diagnostics).read(Node::parse(text), "", figure);
  } catch (const Node::parse_error& error) {
    diagnostics.error(json_position(file, text, error.byte), no_json);
  }
  if (!diagnostics.ok()) return std::nullopt;
  return figure;
}

}  // namespace bentur
