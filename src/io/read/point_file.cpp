#include "phrame/io/read/point_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/point_table.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Vectors = std::vector<Vector<Rational>>;
using Node = JsonNode;

Vectors read_vectors(const Node& list, std::size_t dimension) {
  list.require(Node::Kind::array, "an array of points");
  Vectors vectors;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Node item = list.item(k);
    item.require(Node::Kind::array, fmt::format("an array of {} numbers", dimension));
    if (item.size() != dimension)
      item.fail(fmt::format("{} here, but {} in the first point", counted(item.size(), "number"),
                            dimension));
    const std::vector<Rational> numbers = item.numbers();
    Vector<Rational> v;
    std::copy(numbers.begin(), numbers.end(), v.begin());
    vectors.push_back(v);
  }
  return vectors;
}

GivenPoints read_json(std::string_view text) {
  const JsonValue document = parse_json_file(text, "file of points");
  const Node node(document);
  node.require_known_keys({"phrame", "name", "points", "derivatives", "tangents", "accelerations",
                           "parameters", "kind", "note"});
  if (const auto kind = node.find("kind"); kind && kind->string() != "polyline")
    kind->fail("of points that a curve is to pass the kind is \"polyline\", or left out");
  return read_points(node);
}

/// A comment above the numbers is their header where it says which of them is x.
std::unique_ptr<NumberTable> table_of_points(std::string_view bytes) {
  auto table = read_number_table(bytes, {true, "points"});
  if (table->names().empty() || names_positions(table->names())) return table;
  return read_number_table(bytes, {false, "points"});
}

}  // namespace

void leave_parameters_out(GivenPoints& given, const std::string& why) {
  given.skipped_columns.push_back(fmt::format("{} ({})", given.parameter_column, why));
  given.parameter_column.clear();
  given.parameters.clear();
}

std::vector<std::string> notes_on_columns(const GivenPoints& given) {
  std::vector<std::string> notes = given.notes;
  if (!given.parameter_column.empty())
    notes.push_back(fmt::format("the column {} is taken for the parameters t",
                                abbreviated(given.parameter_column)));
  const auto& skipped = given.skipped_columns;
  if (skipped.empty()) return notes;
  constexpr std::size_t most = 12;
  const std::size_t shown = skipped.size() > most + 1 ? most : skipped.size();
  std::string list;
  for (std::size_t k = 0; k < shown; ++k)
    list += (k == 0 ? "" : ", ") + (skipped[k].empty() ? "one without a name" : skipped[k]);
  if (shown < skipped.size()) list += fmt::format(" and {} more", skipped.size() - shown);
  notes.push_back(fmt::format("skipped {} {}",
                              skipped.size() == 1 ? "is the column" : "are the columns", list));
  return notes;
}

GivenPoints read_points(const JsonNode& node) {
  if (const Node format = node.at("phrame"); format.string() != "points/1")
    format.fail(
        fmt::format("the format is \"points/1\", not \"{}\"", abbreviated(format.string())));
  GivenPoints given;
  if (const auto name = node.find("name")) given.name = name->string();
  const Node points = node.at("points");
  points.require(Node::Kind::array, "an array of points");
  if (points.size() < 2)
    points.fail(fmt::format("{}; a curve needs two at least", counted(points.size(), "point")));
  const Node first = points.item(0);
  first.require(Node::Kind::array, "an array of 2 or 3 numbers");
  if (first.size() != 2 && first.size() != 3)
    first.fail(fmt::format("a point has 2 or 3 coordinates, not {}", first.size()));
  given.is_planar = first.size() == 2;
  given.points = read_vectors(points, first.size());
  const auto require_count = [&](const Node& list, std::size_t most) {
    if (list.size() < points.size() || list.size() > most)
      list.fail(fmt::format("{} for {}", list.size(), counted(points.size(), "point")));
  };
  const auto read = [&](const char* key, Vectors& vectors) {
    const auto list = node.find(key);
    if (!list) return;
    vectors = read_vectors(*list, first.size());
    require_count(*list, points.size());
  };
  read("derivatives", given.derivatives);
  read("tangents", given.tangents);
  read("accelerations", given.accelerations);
  if (!given.derivatives.empty() && !given.tangents.empty())
    node.fail("\"derivatives\" and \"tangents\" exclude each other");
  if (const auto list = node.find("parameters")) {
    list->require(Node::Kind::array, "an array of numbers");
    require_count(*list, points.size() + 1);
    given.parameters = list->numbers();
  }
  require_meaning(
      given, [](std::string_view list, std::size_t k) { return fmt::format("/{}/{}", list, k); });
  return given;
}

PointTable read_points_of_table(std::string_view bytes, const FileReading& reading) {
  return read_point_rows(table_of_points(bytes), reading);
}

std::vector<Rational> read_column(std::string_view bytes, const std::string& name,
                                  const FileReading& reading) {
  const PointTable read = read_points_of_table(bytes, reading);
  const NumberTable& table = *read.table;
  const auto& names = table.names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError(
        table.header_place(),
        fmt::format("there is no column \"{}\"{}", abbreviated(name),
                    names.empty() ? "" : fmt::format(", but {}", fmt::join(names, ", "))));
  const std::vector<std::size_t> column{static_cast<std::size_t>(found - names.begin())};
  std::vector<Rational> numbers;
  for (std::size_t row = 0; row < table.rows(); ++row)
    numbers.push_back(table.number(row, column, name));
  return numbers;
}

GivenPoints read_points(std::string_view bytes, const FileReading& reading) {
  const auto first = bytes.find_first_not_of(" \t\r\n", bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  if (first != std::string_view::npos && bytes[first] == '{') {
    reading.refuse_skipping("points/1");
    return read_json(bytes);
  }
  return read_points_of_table(bytes, reading).given;
}

}  // namespace phrame
