#include "phrame/io/read/frame_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/column_name.hpp"
#include "phrame/io/read/frames_of_table.hpp"
#include "phrame/io/read/pose_columns.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

using ColumnNames = std::vector<std::string>;

using Group = NumberTable::Group;

/// Which columns hold what is read.
class Layout {
 public:
  Layout(const ColumnNames& names, const std::string& place, FrameReading::Quaternion order);
  /// Of matrices, without a parameter.
  explicit Layout(const PoseColumns& matrix) : matrix_(matrix), position_(matrix.position) {}

  GivenFrame frame(const NumberTable& table, std::size_t row, const FrameReading& reading) const;
  /// Where the frame is, at its parameter, its time or, without them, the number of its row.
  std::optional<GivenPosition> position(const NumberTable& table, std::size_t row) const;
  bool has_quaternions() const { return !q_.columns.empty(); }
  bool has_parameters() const { return !t_.columns.empty(); }
  /// Those whose numbers are needed.
  std::vector<std::size_t> columns() const;

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw InputError(place_, reason); }
  void find_parameter(const ColumnNames& names);
  void find(Group& group, const ColumnNames& names) const;

  std::string place_;
  std::optional<PoseColumns> matrix_;
  std::optional<std::array<std::size_t, 3>> position_;
  std::optional<std::size_t> time_;  ///< where there is no parameter
  Group t_{"t", " "};
  Group f2_{"f2"};
  Group f3_{"f3"};
  Group e1_{"e1"};
  Group q_{"q", "wxyz"};
};

Layout::Layout(const ColumnNames& names, const std::string& place, FrameReading::Quaternion order)
    : place_(place), position_(position_columns(names)) {
  find_parameter(names);
  for (Group* group : {&f2_, &f3_, &e1_, &q_}) find(*group, names);
  if (f2_.columns.empty() && !has_quaternions())
    fail("columns f2x, f2y, f2z or qw, qx, qy, qz are wanted");
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
void Layout::find_parameter(const ColumnNames& names) {
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
           ? "a column \"t\" is wanted"
           : fmt::format("missing is the column t: \"{}\" is another name", abbreviated(*other)));
}

std::vector<std::size_t> Layout::columns() const {
  std::vector<std::size_t> list;
  for (const Group* group : {&t_, &f2_, &f3_, &e1_, &q_})
    for (const auto& column : group->columns) list.insert(list.end(), column.begin(), column.end());
  if (position_ && !has_parameters()) list.insert(list.end(), position_->begin(), position_->end());
  if (matrix_) list.insert(list.end(), matrix_->rotation.begin(), matrix_->rotation.end());
  if (time_) list.push_back(*time_);
  return list;
}

/// All columns of the group or none; a name that is right but for upper and lower case is an error.
void Layout::find(Group& group, const ColumnNames& names) const {
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

GivenFrame Layout::frame(const NumberTable& table, std::size_t row,
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

std::optional<GivenPosition> Layout::position(const NumberTable& table, std::size_t row) const {
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

void add_triple(ColumnNames& names, std::string_view name) {
  for (const char end : {'x', 'y', 'z'}) names.push_back(fmt::format("{}{}", name, end));
}

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

Layout layout_of(const NumberTable& table, const FrameReading& reading, GivenTable& result) {
  if (table.names().empty() && reading.names.empty())
    if (const auto matrix = matrix_columns(table)) {
      result.has_matrices = true;
      result.notes.push_back(
          fmt::format("{} columns without names are taken for {}", table.columns(), matrix->what));
      return Layout(*matrix);
    }
  return {names_of(table, reading, result),
          reading.names.empty() ? table.header_place() : "--header", reading.quaternion};
}

}  // namespace

GivenTable frames_of_table(std::unique_ptr<NumberTable> table, const FrameReading& reading,
                           std::size_t at_most) {
  GivenTable result;
  const Layout layout = layout_of(*table, reading, result);
  if (reading.skips_invalid) table = without_missing(std::move(table), layout.columns());
  result.has_quaternions = layout.has_quaternions();
  result.has_parameters = layout.has_parameters();
  const std::size_t rows = table->rows();
  const std::size_t count = std::min(rows, std::max(at_most, std::size_t{2}));
  result.frames.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t row = count == rows ? k : k * (rows - 1) / (count - 1);
    result.frames.push_back(layout.frame(*table, row, reading));
    if (auto position = layout.position(*table, row)) result.positions.push_back(*position);
  }
  result.notes.insert(result.notes.begin(), table->notes().begin(), table->notes().end());
  return result;
}

GivenTable read_frames(std::string_view bytes, const FrameReading& reading, std::size_t at_most) {
  return frames_of_table(read_number_table(bytes, {reading.names.empty(), "frames"}), reading,
                         at_most);
}

std::vector<GivenPosition> read_positions(std::string_view bytes, const FrameReading& reading) {
  const auto table = read_number_table(bytes, {});
  const auto number = [&](std::size_t row, std::string_view name) {
    const auto found = std::ranges::find(reading.names, name);
    return table->number(row, static_cast<std::size_t>(found - reading.names.begin()));
  };
  std::vector<GivenPosition> positions;
  for (std::size_t row = 0; row < table->rows(); ++row)
    positions.push_back({number(row, "t"), {number(row, "x"), number(row, "y"), number(row, "z")}});
  return positions;
}

namespace {

/// The orders of the nine numbers of a matrix: by rows or by columns, the tangent at any place.
std::vector<ColumnNames> matrix_names(bool has_position) {
  std::vector<ColumnNames> all;
  for (const bool is_transposed : {true, false})
    for (std::size_t first = 0; first < 3; ++first) {
      std::array<std::string_view, 3> vectors{"e1", "f2", "f3"};
      std::rotate(vectors.begin(), vectors.begin() + (3 - first) % 3, vectors.end());
      ColumnNames names{"t"};
      if (has_position) add_triple(names, "");
      for (std::size_t k = 0; k < 9; ++k)
        names.push_back(fmt::format("{}{}", vectors[is_transposed ? k % 3 : k / 3],
                                    "xyz"[is_transposed ? k / 3 : k % 3]));
      all.push_back(names);
    }
  return all;
}

}  // namespace

std::vector<FrameReading> other_readings(const GivenTable& table, const FrameReading& reading) {
  std::vector<FrameReading> others;
  using Quaternion = FrameReading::Quaternion;
  if (table.has_quaternions || table.has_matrices) {
    for (const bool is_other_order : {false, true})
      if (table.has_quaternions || !is_other_order)
        for (const std::size_t turn : {0U, 2U, 1U})
          for (const bool is_opposite : {false, true})
            for (const bool is_inverse : {false, true}) {
              FrameReading other = reading;
              if (is_other_order)
                other.quaternion =
                    reading.quaternion == Quaternion::xyzw ? Quaternion::wxyz : Quaternion::xyzw;
              other.tangent_axis = (reading.tangent_axis + turn) % 3;
              other.is_axis_reversed = reading.is_axis_reversed != is_opposite;
              other.is_inverse = reading.is_inverse != is_inverse;
              if (other != reading) others.push_back(other);
            }
    const auto changes = [&](const FrameReading& other) {
      return (other.quaternion != reading.quaternion ? 1 : 0) +
             (other.tangent_axis != reading.tangent_axis ? 1 : 0) +
             (other.is_axis_reversed != reading.is_axis_reversed ? 1 : 0) +
             (other.is_inverse != reading.is_inverse ? 1 : 0);
    };
    std::stable_sort(
        others.begin(), others.end(),
        [&](const FrameReading& a, const FrameReading& b) { return changes(a) < changes(b); });
    return others;
  }
  if (table.columns.empty() || table.skipped > 0) return {};
  const std::size_t columns = table.columns.size();
  std::vector<ColumnNames> names;
  if (columns == 10 || columns == 13) names = matrix_names(columns == 13);
  if (columns == 7)
    for (const std::string_view first : {"e1", ""}) {
      names.push_back({"t"});
      add_triple(names.back(), first);
      add_triple(names.back(), "f2");
    }
  for (const ColumnNames& list : names) {
    FrameReading other = reading;
    other.names = list;
    others.push_back(other);
  }
  return others;
}

std::string to_options(const FrameReading& reading) {
  ColumnNames options;
  using Quaternion = FrameReading::Quaternion;
  if (reading.quaternion != Quaternion::named)
    options.push_back(reading.quaternion == Quaternion::xyzw ? "--quaternion xyzw"
                                                             : "--quaternion wxyz");
  if (reading.is_axis_reversed || reading.tangent_axis != 0)
    options.push_back(fmt::format("--tangent-axis{}{}", reading.is_axis_reversed ? "=-" : " ",
                                  "xyz"[reading.tangent_axis]));
  if (reading.is_inverse) options.emplace_back("--inverse");
  if (!reading.names.empty())
    options.push_back(fmt::format("--header {}", fmt::join(reading.names, ",")));
  return fmt::format("{}", fmt::join(options, " "));
}

}  // namespace phrame
