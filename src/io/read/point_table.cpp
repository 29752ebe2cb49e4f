#include "phrame/io/read/point_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/column_name.hpp"
#include "phrame/io/read/point_file.hpp"
#include "phrame/io/read/pose_columns.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Columns = NumberTable::Group;
using Names = std::vector<std::string>;

/// Where positions have other names than x, y and z.
struct OtherNames {
  std::array<std::optional<std::size_t>, 3> columns;
  std::string shown;  ///< "pos_x, pos_y, pos_z"
};

/// Those of the one family that has an x. That of tx is a tangent where there is another one.
OtherNames find_other_names(const Names& names, const std::string& place) {
  Names families;
  for (const std::string& name : names)
    if (const auto found = position_column(name);
        found && found->axis == 0 && std::ranges::find(families, found->family) == families.end())
      families.push_back(found->family);
  if (families.size() > 1) std::erase(families, "t");
  if (families.size() > 1)
    throw InputError(place, fmt::format("columns of {} positions have an x, \"{}\" and \"{}\": "
                                        "which of them is the curve's is not known",
                                        families.size(), families[0], families[1]));
  OtherNames other;
  for (std::size_t k = 0; k < names.size() && !families.empty(); ++k) {
    const auto found = position_column(names[k]);
    if (!found || found->family != families.front()) continue;
    auto& column = other.columns[found->axis];
    if (column)
      throw InputError(place, fmt::format("two columns have the name {}", abbreviated(names[k])));
    column = k;
  }
  for (const auto& column : other.columns)
    if (column) other.shown += (other.shown.empty() ? "" : ", ") + names[*column];
  return other;
}

/// Which columns hold what is read.
class PointLayout {
 public:
  /// With radii r is the third coordinate, where there is a column of that name.
  PointLayout(const Names& names, const std::string& place, bool has_radii)
      : names_(names), place_(place) {
    find_parameter();
    if (has_radii && find("r"))
      for (Columns* group : {&points_, &derivatives_}) group->ends = "xyr";
    for (Columns* group : {&points_, &derivatives_, &tangents_}) find_group(*group);
    if (points_.columns.size() < 2)
      throw InputError(place, "columns x, y and z are wanted, or x and y");
    for (const Columns* group : {&derivatives_, &tangents_})
      if (!group->columns.empty() && group->columns.size() != points_.columns.size())
        throw InputError(
            place, fmt::format("{} of {}, but {} of x", counted(group->columns.size(), "column"),
                               group->column(0), points_.columns.size()));
    if (!derivatives_.columns.empty()) tangents_.columns.clear();
  }

  /// Those whose numbers are needed.
  std::vector<std::size_t> columns() const {
    std::vector<std::size_t> list;
    if (t_ && is_called_t_) list.push_back(*t_);
    for (const Columns* group : {&points_, &derivatives_, &tangents_})
      for (const auto& column : group->columns) list.push_back(column.front());
    if (const auto w = std::ranges::find(names_, "w", lower_case); w != names_.end())
      list.push_back(static_cast<std::size_t>(w - names_.begin()));
    return list;
  }

  GivenPoints read(const NumberTable& table) const {
    GivenPoints given;
    given.is_planar = points_.columns.size() == 2;
    given.points.reserve(table.rows());
    for (std::size_t row = 0; row < table.rows(); ++row) {
      given.points.push_back(table.vector(row, points_));
      if (!derivatives_.columns.empty())
        given.derivatives.push_back(table.vector(row, derivatives_));
      if (!tangents_.columns.empty()) given.tangents.push_back(table.vector(row, tangents_));
      if (t_ && is_called_t_) given.parameters.push_back(table.number(row, {*t_}, "t"));
    }
    given.skipped_columns = skipped();
    if (!is_called_t_) read_other_parameters(table, given);
    if (!shown_.empty())
      given.notes.push_back(fmt::format("the columns {} are taken for the position", shown_));
    note_unit(table, given);
    return given;
  }

 private:
  std::optional<std::size_t> find(const std::string& wanted) const {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (lower_case(names_[k]) == wanted) {
        if (found) throw InputError(place_, fmt::format("two columns have the name {}", wanted));
        found = k;
      }
    return found;
  }

  void find_parameter() {
    t_ = find("t");
    constexpr std::array<const char*, 5> other_names{"time", "timestamp", "parameter", "u", "s"};
    for (const char* name : other_names)
      if (!t_ && std::ranges::count(names_, name, lower_case) == 1) {
        t_ = find(name);
        is_called_t_ = false;
      }
  }

  void find_group(Columns& group) {
    std::array<std::optional<std::size_t>, 3> columns;
    for (std::size_t k = 0; k < 3; ++k) columns[k] = find(group.column(k));
    if (group.name.empty() && !columns[0] && !columns[1] && !columns[2]) {
      OtherNames other = find_other_names(names_, place_);
      columns = other.columns;
      shown_ = std::move(other.shown);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (!columns[k]) continue;
      if (group.columns.size() < k)
        throw InputError(
            place_, fmt::format("missing is the column {}", group.column(group.columns.size())));
      group.columns.push_back({*columns[k]});
    }
  }

  Names skipped() const {
    std::vector<bool> is_read(names_.size(), false);
    if (t_) is_read[*t_] = true;
    for (const Columns* group : {&points_, &derivatives_, &tangents_})
      for (const auto& column : group->columns) is_read[column.front()] = true;
    Names list;
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (!is_read[k]) list.push_back(names_[k]);
    return list;
  }

  /// Of a column that is not called t, if it has increasing numbers: else it means something else.
  void read_other_parameters(const NumberTable& table, GivenPoints& given) const {
    given.parameter_column = names_[*t_];
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

  /// One for all coordinates, which a note names; derivatives have it over that of t.
  void note_unit(const NumberTable& table, GivenPoints& given) const {
    const auto& units = table.units();
    if (units.empty()) return;
    const auto unit = [&](std::size_t column) {
      return units[column].empty() ? "no unit" : units[column];
    };
    const auto unit_text = [](const std::string& name) {
      return name == "no unit" ? name : fmt::format("the unit \"{}\"", abbreviated(name));
    };
    const std::size_t x = points_.columns[0].front();
    const auto require = [&](const Columns& group, const std::string& wanted) {
      for (const auto& column : group.columns)
        if (unit(column.front()) != wanted)
          throw InputError(
              table.header_place(),
              fmt::format("{} has {}, but by {} it is to have {}", names_[column.front()],
                          unit_text(unit(column.front())), names_[x], unit_text(wanted)));
    };
    require(points_, unit(x));
    if (!derivatives_.columns.empty()) {
      const std::string own = unit(derivatives_.columns[0].front());
      const std::string per = t_ && !units[*t_].empty() ? "/" + units[*t_] : "";
      const bool is_left_out = own == "no unit" || (per.empty() && own.starts_with(unit(x) + "/"));
      require(derivatives_, is_left_out ? own : unit(x) + per);
    }
    if (!units[x].empty())
      given.notes.push_back(fmt::format("the coordinates are in {}", abbreviated(units[x])));
  }

  Names names_;
  std::string place_;
  std::optional<std::size_t> t_;
  bool is_called_t_ = true;
  std::string shown_;
  Columns points_{""};
  Columns derivatives_{"d"};
  Columns tangents_{"e1"};
};

/// The names of the columns of a table that has none, with what a note is to say of it.
struct GuessedNames {
  Names names;
  std::string note = {};
};

GuessedNames names_by_number(const NumberTable& table) {
  const std::size_t count = table.columns();
  if (count == 2) return {{"x", "y"}};
  if (count == 3) return {{"x", "y", "z"}};
  if (count == 8 && is_unit_quaternion(table, 4))
    return {{"t", "x", "y", "z", "", "", "", ""},
            "8 columns without names are taken for t, a position and a quaternion"};
  if (const auto matrix = matrix_columns(table)) {
    Names names(count);
    for (std::size_t k = 0; k < 3; ++k) names[matrix->position[k]] = "xyz"[k];
    return {names, fmt::format("{} columns without names are taken for {}", count, matrix->what)};
  }
  const bool is_of_poses = count == 8 || count == 12 || count == 16;
  throw InputError(
      table.place(0),
      fmt::format("there is no header, and of {} it is not known what they are: 2 are x, y and 3 "
                  "are x, y, z{}",
                  counted(count, "column"),
                  !is_of_poses ? ""
                  : count == 8
                      ? ", 8 t, x, y, z and a quaternion of length 1, which is not here"
                      : fmt::format(", {} a matrix with a rotation, which is not here", count)));
}

/// The rows whose points are not those before them.
std::vector<std::size_t> rows_that_move(const std::vector<Vector<Rational>>& points) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (rows.empty() || points[k] != points[rows.back()]) rows.push_back(k);
  return rows;
}

}  // namespace

bool names_positions(const Names& names) {
  return std::ranges::any_of(names, [](const std::string& name) {
    if (lower_case(name) == "x") return true;
    const auto found = position_column(name);
    return found && found->axis == 0;
  });
}

void require_meaning(const GivenPoints& given,
                     const std::function<std::string(std::string_view list, std::size_t k)>& place,
                     std::string_view advice) {
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
                                   "known how a curve goes from one to the other{}",
                                   abbreviated(given.points[k]), advice));
}

PointTable read_point_rows(std::unique_ptr<NumberTable> table, const FileReading& reading) {
  GuessedNames guessed{table->names()};
  if (guessed.names.empty()) guessed = names_by_number(*table);
  const PointLayout layout(guessed.names, table->header_place(), reading.has_radii);
  if (reading.skips_invalid) table = without_missing(std::move(table), layout.columns());
  GivenPoints given = layout.read(*table);
  if (reading.skips_invalid && given.derivatives.empty()) {
    const std::size_t before = table->rows();
    table = with_rows(std::move(table), rows_that_move(given.points), "with the point before them");
    if (table->rows() < before) given = layout.read(*table);
  }
  given.notes.insert(given.notes.begin(), table->notes().begin(), table->notes().end());
  if (!guessed.note.empty()) {
    given.notes.insert(given.notes.begin(), guessed.note);
    given.skipped_columns.clear();
  }
  if (given.points.size() < 2)
    throw InputError(table->place(0), "there is one point; a curve needs two at least");
  require_meaning(
      given, [&](std::string_view, std::size_t k) { return table->place(k); },
      "; --skip-invalid leaves it out");
  return {std::move(table), std::move(given)};
}

}  // namespace phrame
