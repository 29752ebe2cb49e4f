#include "phrame/io/read/frame_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/text_table.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

using ColumnNames = std::vector<std::string>;

using Group = NumberTable::Group;

/// Which columns hold what is read.
class Layout {
 public:
  Layout(const ColumnNames& names, const std::string& place, FrameReading::Quaternion order);

  GivenFrame frame(const NumberTable& table, std::size_t row, const FrameReading& reading) const;
  bool has_quaternions() const { return !q_.columns.empty(); }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw InputError(place_, reason); }
  void find(Group& group, const ColumnNames& names) const;

  std::string place_;
  Group t_{"t", " "};
  Group f2_{"f2"};
  Group f3_{"f3"};
  Group e1_{"e1"};
  Group q_{"q", "wxyz"};
};

Layout::Layout(const ColumnNames& names, const std::string& place, FrameReading::Quaternion order)
    : place_(place) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == "t") {
      if (t_.columns.empty()) t_.columns.emplace_back();
      t_.columns[0].push_back(k);
    }
  if (t_.columns.empty()) {
    const auto other = std::find_if(names.begin(), names.end(), [](const std::string& name) {
      return lower_case(name) == "t" || lower_case(name) == "time";
    });
    fail(other == names.end()
             ? "a column \"t\" is wanted"
             : fmt::format("missing is the column t: \"{}\" is another name", abbreviated(*other)));
  }
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

/// The frame that q means.
void set_frame(GivenFrame& frame, RationalQuaternion q, const FrameReading& reading) {
  const Rational size = norm(q);
  if (reading.is_inverse) q = {q.u, -q.v, -q.p, -q.q};
  const auto unit = [&](Vector<Rational> v) {
    for (Rational& x : v) x /= size;
    return v;
  };
  const std::array<Vector<Rational>, 3> axes{unit(rotated_i(q)), unit(rotated_j(q)),
                                             unit(rotated_k(q))};
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
  GivenFrame frame{table.number(row, t_.columns[0], "t"), {}};
  if (!has_quaternions()) {
    frame.f2 = table.vector(row, f2_);
    if (!f3_.columns.empty()) frame.f3 = table.vector(row, f3_);
    if (!e1_.columns.empty()) frame.tangent = table.vector(row, e1_);
    return frame;
  }
  const auto [w, x, y, z] = table.numbers(row, q_);
  const RationalQuaternion q{w, x, y, z};
  if (norm(q) == 0) throw InputError(table.place(row), "the quaternion is 0");
  set_frame(frame, q, reading);
  return frame;
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

GivenTable frames_of(const NumberTable& table, const FrameReading& reading, std::size_t at_most) {
  ColumnNames names = table.names();
  GivenTable result;
  if (names.empty()) {
    names = reading.names.empty() ? names_by_number(table.columns()) : reading.names;
    if (names.empty())
      throw InputError(table.place(0),
                       fmt::format("there is no header, and of {} it is not known what they "
                                   "are: 4, 5, 7, 8, 10, and 13 or more are; --header names them",
                                   counted(table.columns(), "column")));
    if (!reading.names.empty() && names.size() != table.columns())
      throw InputError("--header", fmt::format("{} for {}", counted(names.size(), "name"),
                                               counted(table.columns(), "column")));
    if (reading.names.empty()) result.columns = names;
    result.skipped = table.columns() - names.size();
  } else if (!reading.names.empty()) {
    throw InputError("--header",
                     "is for tables without a header; this one has one: " + table.header_place());
  }
  const Layout layout(names, reading.names.empty() ? table.header_place() : "--header",
                      reading.quaternion);
  result.has_quaternions = layout.has_quaternions();
  const std::size_t rows = table.rows();
  const std::size_t count = std::min(rows, std::max(at_most, std::size_t{2}));
  result.frames.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    result.frames.push_back(
        layout.frame(table, count == rows ? k : k * (rows - 1) / (count - 1), reading));
  return result;
}

}  // namespace

GivenTable read_frames(std::string_view bytes, const FrameReading& reading, std::size_t at_most) {
  return frames_of(*read_number_table(bytes, {reading.names.empty(), "frames"}), reading, at_most);
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
  if (table.has_quaternions) {
    for (const bool is_other_order : {false, true})
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
