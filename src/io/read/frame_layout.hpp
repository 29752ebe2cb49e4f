#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/frame_csv.hpp"
#include "phrame/io/read/number_table.hpp"
#include "phrame/io/read/pose_columns.hpp"

namespace phrame::inline v0 {

/// Which columns of a table hold what is read of frames.
class FrameLayout {
 public:
  FrameLayout(const std::vector<std::string>& names, const std::string& place,
              FrameReading::Quaternion order);
  /// Of matrices, without a parameter.
  explicit FrameLayout(const PoseColumns& matrix) : matrix_(matrix), position_(matrix.position) {}

  GivenFrame frame(const NumberTable& table, std::size_t row, const FrameReading& reading) const;
  /// Where the frame is, at its parameter, its time or, without them, the number of its row.
  std::optional<GivenPosition> position(const NumberTable& table, std::size_t row) const;
  bool has_quaternions() const { return !q_.columns.empty(); }
  bool has_parameters() const { return !t_.columns.empty(); }
  /// Those whose numbers are needed.
  std::vector<std::size_t> columns() const;

  /// One column each.
  struct VectorColumns {
    std::size_t t;
    std::array<std::size_t, 3> f2;
    std::optional<std::array<std::size_t, 3>> f3, tangent;
    std::optional<std::array<std::size_t, 3>> position;  ///< which are read, too
  };
  /// Of frames given by vectors with parameters; no value for others, and where a name is there
  /// twice.
  std::optional<VectorColumns> vector_columns() const;

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw InputError(place_, reason); }
  void find_parameter(const std::vector<std::string>& names);
  void find(NumberTable::Group& group, const std::vector<std::string>& names) const;

  std::string place_;
  std::optional<PoseColumns> matrix_;
  std::optional<std::array<std::size_t, 3>> position_;
  std::optional<std::size_t> time_;  ///< where there is no parameter
  NumberTable::Group t_{"t", " "};
  NumberTable::Group f2_{"f2"};
  NumberTable::Group f3_{"f3"};
  NumberTable::Group e1_{"e1"};
  NumberTable::Group q_{"q", "wxyz"};
};

/// That of a table; `result` tells how its columns were found. Throws InputError where they do not
/// make frames.
FrameLayout frame_layout(const NumberTable& table, const FrameReading& reading, GivenTable& result);

/// Adds the names of three columns, "f2x", "f2y", "f2z" for "f2".
void add_triple(std::vector<std::string>& names, std::string_view name);

}  // namespace phrame
