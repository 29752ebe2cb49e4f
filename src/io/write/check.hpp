#pragma once
#include <optional>
#include <string>
#include <vector>

#include "phrame/answer/check.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// How the table of the frames was read.
struct TableReading {
  /// How it would better have been read.
  struct Other {
    std::string options;  ///< as they are typed: "--quaternion xyzw"
    bool passes;          ///< the frames pass by it; else their tangents are right, at least
  };
  std::vector<std::string> columns = {};  ///< t, x, y, … where their number told what they are
  std::size_t skipped = 0;                ///< further columns there
  /// "t is taken for the arc length", where that was found out; else empty.
  std::string parameters = {};
  /// Of a longer table, the rows that decide what is said of all.
  struct Part {
    std::vector<std::size_t> numbers;               ///< of the frames, in the whole table
    std::vector<std::vector<std::size_t>> samples;  ///< of each finding, in that
    std::size_t rows;                               ///< so many that has
  };
  std::optional<Part> part = std::nullopt;  ///< where the frames are these only
  /// Where frames that do not pass would be better with other options.
  std::optional<Other> better = std::nullopt;
};

/// The verdict and its reason in a line.
PHRAME_API std::string summary(const CheckAnswer& answer);
/// For reading, Unicode.
PHRAME_API std::string to_text(const CheckAnswer& answer, const TableReading& reading);
PHRAME_API std::string to_json(const CheckAnswer& answer,
                               const TableReading& reading);  ///< check/1; of whole tables

}  // namespace phrame
