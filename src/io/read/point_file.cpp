#include "phrame/io/read/point_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/text_table.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame {
namespace {

using Vectors = std::vector<Vector<Rational>>;
using Node = JsonNode;
/// Where the k-th entry of a list stands: of "points", 3 the place of the fourth point.
using Location = std::function<std::string(std::string_view list, std::size_t k)>;

/// What is wrong in any format.
void require_meaning(const GivenPoints& given, const Location& place) {
  for (std::size_t k = 0; k < given.tangents.size(); ++k)
    if (given.tangents[k] == Vector<Rational>{})
      throw InputError(place("tangents", k), "the tangent is 0, which is no direction");
  for (std::size_t k = 1; k < given.parameters.size(); ++k)
    if (given.parameters[k] <= given.parameters[k - 1])
      throw InputError(
          place("parameters", k),
          fmt::format("{} is not greater than the parameter before it, {}",
                      as_written(given.parameters[k]), as_written(given.parameters[k - 1])));
  if (!given.derivatives.empty()) return;
  for (std::size_t k = 1; k < given.points.size(); ++k)
    if (given.points[k] == given.points[k - 1])
      throw InputError(place("points", k),
                       fmt::format("the point {} is that before it; only with derivatives is it "
                                   "known how a curve goes from one to the other",
                                   abbreviated(given.points[k])));
}

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
                           "parameters", "note"});
  return read_points(node);
}

using Columns = NumberTable::Group;

/// Which columns hold what is read.
class PointLayout {
 public:
  explicit PointLayout(const std::vector<std::string>& names, const std::string& place) {
    const auto find = [&](const std::string& wanted) -> std::optional<std::size_t> {
      std::optional<std::size_t> found;
      for (std::size_t k = 0; k < names.size(); ++k)
        if (lower_case(names[k]) == wanted) {
          if (found) throw InputError(place, fmt::format("two columns have the name {}", wanted));
          found = k;
        }
      return found;
    };
    t_ = find("t");
    constexpr std::array<const char*, 5> other_names{"time", "timestamp", "parameter", "u", "s"};
    for (const char* name : other_names)
      if (!t_ && std::ranges::count(names, name, lower_case) == 1) {
        t_ = find(name);
        is_called_t_ = false;
      }
    for (Columns* group : {&points_, &derivatives_, &tangents_})
      for (std::size_t k = 0; k < 3; ++k)
        if (const auto column = find(group->column(k))) {
          if (group->columns.size() < k)
            throw InputError(place, fmt::format("missing is the column {}",
                                                group->column(group->columns.size())));
          group->columns.push_back({*column});
        }
    if (points_.columns.size() < 2)
      throw InputError(place, "columns x, y and z are wanted, or x and y");
    for (const Columns* group : {&derivatives_, &tangents_})
      if (!group->columns.empty() && group->columns.size() != points_.columns.size())
        throw InputError(
            place, fmt::format("{} of {}, but {} of x", counted(group->columns.size(), "column"),
                               group->column(0), points_.columns.size()));
    if (!derivatives_.columns.empty()) tangents_.columns.clear();
    std::vector<bool> is_read(names.size(), false);
    if (t_) is_read[*t_] = true;
    for (const Columns* group : {&points_, &derivatives_, &tangents_})
      for (const auto& column : group->columns) is_read[column.front()] = true;
    for (std::size_t k = 0; k < names.size(); ++k)
      if (!is_read[k]) skipped_.push_back(names[k]);
    if (!is_called_t_) t_name_ = names[*t_];
  }

  GivenPoints read(const NumberTable& table) const {
    GivenPoints given;
    given.is_planar = points_.columns.size() == 2;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      given.points.push_back(table.vector(row, points_));
      if (!derivatives_.columns.empty())
        given.derivatives.push_back(table.vector(row, derivatives_));
      if (!tangents_.columns.empty()) given.tangents.push_back(table.vector(row, tangents_));
      if (t_ && is_called_t_) given.parameters.push_back(table.number(row, {*t_}, "t"));
    }
    given.skipped_columns = skipped_;
    if (!is_called_t_) read_other_parameters(table, given);
    return given;
  }

 private:
  /// Of a column that is not called t, if it has increasing numbers: else it means something else.
  void read_other_parameters(const NumberTable& table, GivenPoints& given) const {
    given.parameter_column = t_name_;
    const auto leave_out = [&](const std::string& why) {
      leave_parameters_out(given, fmt::format("{}: {}", table.place(given.parameters.size()), why));
    };
    for (std::size_t row = 0; row < table.rows(); ++row) {
      Rational t;
      try {
        t = table.number(row, *t_);
      } catch (const InputError& error) {
        return leave_out(error.reason());
      }
      if (row > 0 && t <= given.parameters.back())
        return leave_out(abbreviated(to_string(t)) + " is not greater than that before it");
      given.parameters.push_back(t);
    }
  }
  std::optional<std::size_t> t_;
  bool is_called_t_ = true;
  std::string t_name_;
  std::vector<std::string> skipped_;
  Columns points_{""};
  Columns derivatives_{"d"};
  Columns tangents_{"e1"};
};

GivenPoints read_table(const NumberTable& table) {
  std::vector<std::string> names = table.names();
  if (names.empty()) {
    names = {"x", "y", "z"};
    if (table.columns() != 2 && table.columns() != 3)
      throw InputError(table.place(0),
                       fmt::format("there is no header, and of {} it is not known what they are: "
                                   "2 are x, y and 3 are x, y, z",
                                   counted(table.columns(), "column")));
    names.resize(table.columns());
  }
  GivenPoints given = PointLayout(names, table.header_place()).read(table);
  if (given.points.size() < 2)
    throw InputError(table.place(0), "there is one point; a curve needs two at least");
  require_meaning(given, [&](std::string_view, std::size_t k) { return table.place(k); });
  return given;
}

/// A comment above the numbers is their header where it says which of them is x.
std::unique_ptr<NumberTable> table_of_points(std::string_view bytes) {
  auto table = read_number_table(bytes, {true, "points"});
  const auto& names = table->names();
  if (names.empty() || std::ranges::find(names, "x", lower_case) != names.end()) return table;
  return read_number_table(bytes, {false, "points"});
}

}  // namespace

void leave_parameters_out(GivenPoints& given, const std::string& why) {
  given.skipped_columns.push_back(fmt::format("{} ({})", given.parameter_column, why));
  given.parameter_column.clear();
  given.parameters.clear();
}

std::vector<std::string> notes_on_columns(const GivenPoints& given) {
  std::vector<std::string> notes;
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

GivenPoints read_points(std::string_view bytes) {
  const auto first = bytes.find_first_not_of(" \t\r\n", bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  if (first != std::string_view::npos && bytes[first] == '{') return read_json(bytes);
  return read_table(*table_of_points(bytes));
}

}  // namespace phrame
