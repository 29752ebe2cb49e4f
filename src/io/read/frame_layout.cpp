#include "phrame/io/read/frame_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "phrame/io/read/column_name.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

using ColumnNames = std::vector<std::string>;

using Group = NumberTable::Group;

/// Those of the body in the world.
using Axes = std::array<Vector<Rational>, 3>;

/// By the unit quaternion along q.
Axes axes_by(RationalQuaternion q, bool is_inverse) {
  const Rational size = norm(q);
  if (is_inverse) q = {q.u, -q.v, -q.p, -q.q};
  const auto unit = [&](Vector<Rational> v) {
    for (Rational& x : v) x /= size;
    return v;
  };
  return {unit(rotated_i(q)), unit(rotated_j(q)), unit(rotated_k(q))};
}

/// The columns of the matrix; the rows of one that turns the world to the body.
Axes axes_by(const NumberTable& table, std::size_t row, const PoseColumns& matrix,
             bool is_inverse) {
  Axes axes;
  for (std::size_t k = 0; k < 9; ++k) {
    const std::size_t i = k / 3;
    const std::size_t j = k % 3;
    (is_inverse ? axes[i][j] : axes[j][i]) =
        table.number(row, {matrix.rotation[k]}, fmt::format("column {}", matrix.rotation[k] + 1));
  }
  return axes;
}

/// The frame of which one axis is the tangent.
void set_frame(GivenFrame& frame, const Axes& axes, const FrameReading& reading) {
  const std::size_t first = reading.tangent_axis;
  frame.tangent = axes[first];
  frame.f2 = axes[(first + 1) % 3];
  frame.f3 = axes[(first + 2) % 3];
  if (!reading.is_axis_reversed) return;
  for (Rational& x : *frame.tangent) x = -x;
  std::swap(frame.f2, *frame.f3);
}

}  // namespace

FrameLayout::FrameLayout(const ColumnNames& names, const std::string& place,
                         FrameReading::Quaternion order)
    : place_(place), position_(position_columns(names)) {
  find_parameter(names);
  for (Group* group : {&f2_, &f3_, &e1_, &q_}) find(*group, names);
  if (f2_.columns.empty() && !has_quaternions())
    fail(fmt::format("columns f2x, f2y, f2z or qw, qx, qy, qz are wanted; these are {}",
                     abbreviated(fmt::format("{}", fmt::join(names, ", ")), 120)));
  for (const Group* group : {&f2_, &f3_, &e1_})
    if (!group->columns.empty() && has_quaternions())
      fail(fmt::format("columns of vectors ({}) and of quaternions (qw) exclude each other",
                       group->column(0)));
  if (!has_quaternions() || order == FrameReading::Quaternion::named) return;
  std::sort(q_.columns.begin(), q_.columns.end());  // from left to right
  if (order == FrameReading::Quaternion::xyzw)
    std::rotate(q_.columns.begin(), q_.columns.begin() + 3, q_.columns.end());
}

/// Of frames that say where they are, a time or nothing may stand for it.
void FrameLayout::find_parameter(const ColumnNames& names) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == "t") {
      if (t_.columns.empty()) t_.columns.emplace_back();
      t_.columns[0].push_back(k);
    }
  if (!t_.columns.empty()) return;
  const auto other = std::find_if(names.begin(), names.end(), [](const std::string& name) {
    const std::string word = lower_case(name);
    return word == "t" || word == "time" || word == "timestamp";
  });
  if (position_ && other != names.end()) time_ = static_cast<std::size_t>(other - names.begin());
  if (position_) return;
  fail(other == names.end()
           ? fmt::format("a column \"t\" is wanted; these are {}",
                         abbreviated(fmt::format("{}", fmt::join(names, ", ")), 120))
           : fmt::format("missing is the column t: \"{}\" is another name", abbreviated(*other)));
}

std::vector<std::size_t> FrameLayout::columns() const {
  std::vector<std::size_t> list;
  for (const Group* group : {&t_, &f2_, &f3_, &e1_, &q_})
    for (const auto& column : group->columns) list.insert(list.end(), column.begin(), column.end());
  if (position_ && !has_parameters()) list.insert(list.end(), position_->begin(), position_->end());
  if (matrix_) list.insert(list.end(), matrix_->rotation.begin(), matrix_->rotation.end());
  if (time_) list.push_back(*time_);
  return list;
}

/// All columns of the group or none; a name that is right but for upper and lower case is an error.
void FrameLayout::find(Group& group, const ColumnNames& names) const {
  ColumnNames found;
  ColumnNames missing;
  std::string misspelt;
  for (std::size_t k = 0; k < group.ends.size(); ++k) {
    const std::string wanted = group.column(k);
    group.columns.emplace_back();
    for (std::size_t at = 0; at < names.size(); ++at)
      if (names[at] == wanted)
        group.columns.back().push_back(at);
      else if (lower_case(names[at]) == wanted)
        misspelt = names[at];
    (group.columns.back().empty() ? missing : found).push_back(wanted);
  }
  if (missing.empty()) return;
  if (!found.empty() || !misspelt.empty())
    fail(fmt::format(
        "missing {} {}: {}", missing.size() == 1 ? "is the column" : "are the columns",
        fmt::join(missing, ", "),
        misspelt.empty()
            ? fmt::format("{} {} there", fmt::join(found, ", "), found.size() == 1 ? "is" : "are")
            : fmt::format("\"{}\" is another name", abbreviated(misspelt))));
  group.columns.clear();
}

GivenFrame FrameLayout::frame(const NumberTable& table, std::size_t row,
                              const FrameReading& reading) const {
  GivenFrame frame{reading.parameters.empty() ? Rational() : reading.parameters.at(row), {}};
  if (reading.parameters.empty() && has_parameters())
    frame.t = table.number(row, t_.columns[0], "t");
  if (matrix_) {
    set_frame(frame, axes_by(table, row, *matrix_, reading.is_inverse), reading);
    return frame;
  }
  if (!has_quaternions()) {
    frame.f2 = table.vector(row, f2_);
    if (!f3_.columns.empty()) frame.f3 = table.vector(row, f3_);
    if (!e1_.columns.empty()) frame.tangent = table.vector(row, e1_);
    return frame;
  }
  const auto [w, x, y, z] = table.numbers(row, q_);
  const RationalQuaternion q{w, x, y, z};
  if (norm(q) == 0) throw InputError(table.place(row), "the quaternion is 0");
  set_frame(frame, axes_by(q, reading.is_inverse), reading);
  return frame;
}

std::optional<GivenPosition> FrameLayout::position(const NumberTable& table,
                                                   std::size_t row) const {
  if (!position_) return std::nullopt;
  GivenPosition found{Rational(static_cast<long>(row)), {}};
  if (has_parameters()) found.t = table.number(row, t_.columns[0], "t");
  if (time_) found.t = table.number(row, {*time_}, "time");
  for (std::size_t c = 0; c < 3; ++c) {
    // Where the frames have parameters, nothing depends on it.
    if (has_parameters() && table.is_missing(row, (*position_)[c])) return std::nullopt;
    found.r[c] = table.number(row, {(*position_)[c]}, "position");
  }
  return found;
}

std::optional<FrameLayout::VectorColumns> FrameLayout::vector_columns() const {
  if (matrix_ || has_quaternions() || !has_parameters()) return std::nullopt;
  bool is_single = t_.columns[0].size() == 1;
  const auto columns = [&](const Group& group) {
    std::array<std::size_t, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
      is_single = is_single && group.columns[k].size() == 1;
      at[k] = group.columns[k].front();
    }
    return at;
  };
  VectorColumns found{t_.columns[0].front(), columns(f2_), std::nullopt, std::nullopt, position_};
  if (!f3_.columns.empty()) found.f3 = columns(f3_);
  if (!e1_.columns.empty()) found.tangent = columns(e1_);
  return is_single ? std::optional(found) : std::nullopt;
}

void add_triple(ColumnNames& names, std::string_view name) {
  for (const char end : {'x', 'y', 'z'}) names.push_back(fmt::format("{}{}", name, end));
}

namespace {

/// The columns of a table without a header; none for a number of them that says nothing.
ColumnNames names_by_number(std::size_t columns) {
  const bool is_ours = columns >= 13;  // and whatever our tables have behind
  const bool has_position = columns == 8 || is_ours;
  ColumnNames names{"t"};
  if (has_position) add_triple(names, "");
  if (columns == 5 || columns == 8) {
    names.insert(names.end(), {"qw", "qx", "qy", "qz"});
    return names;
  }
  if (columns == 10 || is_ours) add_triple(names, "e1");
  if (columns == 4 || columns == 7 || columns == 10 || is_ours) add_triple(names, "f2");
  if (columns == 7 || columns == 10 || is_ours) add_triple(names, "f3");
  return names.size() == 1 ? ColumnNames{} : names;
}

/// The names of the columns, of which `result` tells how they were found.
ColumnNames names_of(const NumberTable& table, const FrameReading& reading, GivenTable& result) {
  ColumnNames names = table.names();
  if (!names.empty() && !reading.names.empty())
    throw InputError("--header",
                     "is for tables without a header; this one has one: " + table.header_place());
  if (!names.empty()) return names;
  names = reading.names.empty() ? names_by_number(table.columns()) : reading.names;
  if (names.empty())
    throw InputError(table.place(0),
                     fmt::format("there is no header, and of {} it is not known what they "
                                 "are: 4, 5, 7, 8, 10, and 13 or more are, and matrices of 12 and "
                                 "16 numbers; --header names them",
                                 counted(table.columns(), "column")));
  if (!reading.names.empty() && names.size() != table.columns())
    throw InputError("--header", fmt::format("{} for {}", counted(names.size(), "name"),
                                             counted(table.columns(), "column")));
  if (reading.names.empty()) result.columns = names;
  result.skipped = table.columns() - names.size();
  return names;
}

}  // namespace

FrameLayout frame_layout(const NumberTable& table, const FrameReading& reading,
                         GivenTable& result) {
  if (table.names().empty() && reading.names.empty())
    if (const auto matrix = matrix_columns(table)) {
      result.has_matrices = true;
      result.notes.push_back(
          fmt::format("{} columns without names are taken for {}", table.columns(), matrix->what));
      return FrameLayout(*matrix);
    }
  return {names_of(table, reading, result),
          reading.names.empty() ? table.header_place() : "--header", reading.quaternion};
}

}  // namespace phrame
