#include "phrame/io/read/polyline_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/curve_choice.hpp"
#include "phrame/io/read/line_points.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {
namespace {

using Words = std::vector<std::string_view>;

/// The lines of a text, one after the other, as words.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  bool next(Words& words) {
    if (text_.empty()) return false;
    ++line_;
    std::string_view rest = take_line(text_);
    words.clear();
    constexpr std::string_view blanks = " \t\r";
    for (;;) {
      rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
      if (rest.empty()) return true;
      const auto length = std::min(rest.find_first_of(blanks), rest.size());
      words.push_back(rest.substr(0, length));
      rest.remove_prefix(length);
    }
  }
  long line() const { return line_; }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(line_place(line_), reason);
  }

 private:
  std::string_view text_;
  long line_ = 0;
};

long whole_number(const Lines& in, std::string_view word) {
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    in.fail(fmt::format("\"{}\" is not a whole number", abbreviated(word)));
  return value;
}

Rational coordinate(const Lines& in, std::string_view word) {
  try {
    return parse_short_number(word);
  } catch (const InputError& error) {
    in.fail(error.reason());
  }
}

/// Vertices and what joins them, each joint with the name of its object.
struct Graph {
  std::vector<LinePoint> vertices;
  struct Edge {
    std::size_t from;
    std::size_t to;
    std::string name;
    long line;
  };
  std::vector<Edge> edges;
};

void add_edge(Graph& graph, const Lines& in, std::size_t from, std::size_t to,
              const std::string& name) {
  if (from != to) graph.edges.push_back({from, to, name, in.line()});
}

/// From 1, or from the last if negative; "7/3" has a texture vertex behind.
std::size_t vertex_index(const Lines& in, std::string_view word, std::size_t count) {
  const long index = whole_number(in, word.substr(0, word.find('/')));
  const long at = index < 0 ? static_cast<long>(count) + index : index - 1;
  if (at < 0 || at >= static_cast<long>(count))
    in.fail(fmt::format("there is no vertex {} of {}", index, count));
  return static_cast<std::size_t>(at);
}

Graph read_obj(std::string_view text) {
  Graph graph;
  Lines in(text);
  std::string name;
  for (Words words; in.next(words);) {
    if (words.empty()) continue;
    if (words[0] == "v") {
      if (words.size() < 4) in.fail("a vertex has three coordinates");
      LinePoint row{{}, in.line()};
      for (std::size_t c = 0; c < 3; ++c) row.point[c] = coordinate(in, words[c + 1]);
      graph.vertices.push_back(row);
    } else if ((words[0] == "o" || words[0] == "g") && words.size() > 1) {
      name = words[1];
    } else if (words[0] == "l") {
      for (std::size_t k = 2; k < words.size(); ++k)
        add_edge(graph, in, vertex_index(in, words[k - 1], graph.vertices.size()),
                 vertex_index(in, words[k], graph.vertices.size()), name);
    }
  }
  if (graph.edges.empty())
    throw InputError("line 1", "there is no polyline in the file: elements \"l\" are wanted");
  return graph;
}

/// What the header of a PLY file says of an element.
struct PlyElement {
  std::string name;
  long count;
  std::vector<std::string> properties;
};

std::vector<PlyElement> read_ply_header(Lines& in) {
  std::vector<PlyElement> elements;
  for (Words words; in.next(words);) {
    if (words.empty() || words[0] == "ply" || words[0] == "comment" || words[0] == "obj_info")
      continue;
    if (words[0] == "end_header") return elements;
    if (words[0] == "format" && (words.size() < 2 || words[1] != "ascii"))
      in.fail("the format is binary: save it as ASCII");
    if (words[0] == "element") {
      if (words.size() != 3) in.fail("an element has a name and a count");
      const long count = whole_number(in, words[2]);
      if (count < 0) in.fail(fmt::format("the count {} is negative", count));
      elements.push_back({std::string(words[1]), count, {}});
    }
    if (words[0] == "property") {
      if (elements.empty() || words.size() < 3) in.fail("a property belongs to an element");
      elements.back().properties.emplace_back(words.back());
    }
  }
  in.fail("the header has no end");
}

/// The word of the property of that name in a line of the element.
std::string_view word_of(const Lines& in, const PlyElement& element, const Words& words,
                         std::string_view name) {
  const auto at = std::ranges::find(element.properties, name) - element.properties.begin();
  if (at == static_cast<long>(element.properties.size()))
    in.fail(fmt::format("the element {} has no property {}", element.name, name));
  if (at >= static_cast<long>(words.size()))
    in.fail(fmt::format("the {} has no {}", element.name, name));
  return words[static_cast<std::size_t>(at)];
}

Graph read_ply(std::string_view text) {
  Graph graph;
  Lines in(text);
  bool has_joints = false;
  for (const PlyElement& element : read_ply_header(in)) {
    has_joints =
        has_joints || ((element.name == "edge" || element.name == "face") && element.count > 0);
    Words words;
    for (long k = 0; k < element.count; ++k) {
      if (!in.next(words))
        in.fail(fmt::format("the file ends at {} {} of {}", element.name, k, element.count));
      if (element.name == "vertex") {
        LinePoint row{{}, in.line()};
        for (std::size_t c = 0; c < 3; ++c)
          row.point[c] = coordinate(in, word_of(in, element, words, std::string(1, "xyz"[c])));
        graph.vertices.push_back(row);
      } else if (element.name == "edge") {
        const auto index = [&](const char* name) {
          const long at = whole_number(in, word_of(in, element, words, name));
          if (at < 0 || at >= static_cast<long>(graph.vertices.size()))
            in.fail(fmt::format("there is no vertex {}", at));
          return static_cast<std::size_t>(at);
        };
        add_edge(graph, in, index("vertex1"), index("vertex2"), "");
      }
    }
  }
  if (!has_joints)
    for (std::size_t k = 1; k < graph.vertices.size(); ++k)
      graph.edges.push_back({k - 1, k, "", 1});
  if (graph.edges.empty())
    throw InputError("line 1", "there is no polyline in the file: an element \"edge\" is wanted");
  return graph;
}

/// A polyline: its vertices, the last being the first of a loop.
struct Chain {
  std::vector<std::size_t> vertices;
  std::string name;
};

/// Those that the edges make.
std::vector<Chain> chains_of(const Graph& graph) {
  // Those of an object at a vertex: objects may share their ends.
  std::map<std::pair<std::string_view, std::size_t>, std::vector<std::size_t>> all;
  const auto edges_at = [&](std::size_t edge, std::size_t v) -> std::vector<std::size_t>& {
    return all[{graph.edges[edge].name, v}];
  };
  for (std::size_t k = 0; k < graph.edges.size(); ++k)
    for (const std::size_t v : {graph.edges[k].from, graph.edges[k].to}) {
      edges_at(k, v).push_back(k);
      if (edges_at(k, v).size() > 2)
        throw InputError(line_place(graph.edges[k].line),
                         fmt::format("three lines meet in vertex {}: this is no curve", v + 1));
    }
  std::vector<bool> is_used(graph.edges.size(), false);
  std::vector<Chain> chains;
  const auto walk = [&](std::size_t from, std::size_t edge) {
    Chain chain{{from}, graph.edges[edge].name};
    const std::size_t none = graph.edges.size();
    for (std::size_t next = edge; next != none;) {
      is_used[next] = true;
      const auto& [a, b, name, line] = graph.edges[next];
      chain.vertices.push_back(chain.vertices.back() == a ? b : a);
      next = none;
      for (const std::size_t k : edges_at(edge, chain.vertices.back()))
        if (!is_used[k]) next = k;
    }
    chains.push_back(std::move(chain));
  };
  for (const bool is_loop : {false, true})  // ends first: what is left has none
    for (std::size_t k = 0; k < graph.edges.size(); ++k)
      for (const std::size_t v : {graph.edges[k].from, graph.edges[k].to})
        if (!is_used[k] && (is_loop || edges_at(k, v).size() == 1)) walk(v, k);
  return chains;
}

std::vector<CurveLabel> labels_of(const std::vector<Chain>& chains) {
  std::map<std::string, long> count;
  std::map<std::string, long> seen;
  for (const Chain& chain : chains) ++count[chain.name];
  std::vector<CurveLabel> labels;
  for (const Chain& chain : chains) {
    const long number = ++seen[chain.name];
    labels.push_back(
        {count[chain.name] == 1 ? chain.name : fmt::format("{}#{}", chain.name, number),
         fmt::format("#{}", labels.size() + 1)});
  }
  return labels;
}

}  // namespace

bool is_polyline_file(std::string_view text) {
  Lines in(text);
  for (Words words; in.next(words);) {
    if (words.empty() || words[0].starts_with('#')) continue;
    if (words[0] == "ply") return words.size() == 1;
    if (words[0] == "v" && words.size() > 1) return true;
    const bool may_be_obj = words[0] == "o" || words[0] == "g" || words[0] == "mtllib" ||
                            words[0] == "usemtl" || words[0] == "s";
    if (!may_be_obj) return false;
  }
  return false;
}

PointCurve read_polyline(std::string_view text, const FileReading& reading) {
  const Graph graph = trimmed(text.substr(0, 4)) == "ply" ? read_ply(text) : read_obj(text);
  const std::vector<Chain> chains = chains_of(graph);
  const std::vector<CurveLabel> labels = labels_of(chains);
  const std::size_t at = chosen_curve(labels, reading.pick);
  const bool is_loop = chains[at].vertices.front() == chains[at].vertices.back();
  std::vector<LinePoint> rows;
  for (const std::size_t v : chains[at].vertices) rows.push_back(graph.vertices[v]);
  PointCurve curve =
      spline_through(std::make_unique<LinePoints>(std::move(rows)), is_loop, reading);
  curve.name = labels[at].name;
  return curve;
}

}  // namespace phrame
