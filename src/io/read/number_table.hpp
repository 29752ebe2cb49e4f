#pragma once
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame {

/// Rows of numbers below the names of their columns, or without names, whatever the file is.
class NumberTable {
 public:
  virtual ~NumberTable() = default;

  const std::vector<std::string>& names() const { return names_; }  ///< none without a header
  virtual std::string header_place() const = 0;
  virtual std::size_t rows() const = 0;
  virtual std::size_t columns() const = 0;
  virtual std::string place(std::size_t row) const = 0;  ///< "line 3"
  /// Throws InputError, with no place, for what is no number.
  virtual Rational number(std::size_t row, std::size_t column) const = 0;
  /// The same with the place "line 3, name"; of many columns with that name, one that all have.
  Rational number(std::size_t row, const std::vector<std::size_t>& columns,
                  std::string_view name) const;

  /// The columns of a vector or a quaternion.
  struct Group {
    std::string_view name;          ///< "f2" of f2x, f2y, f2z
    std::string_view ends = "xyz";  ///< or "wxyz"
    /// In the order of `ends`, all columns of that name; none of those at the end may be there.
    std::vector<std::vector<std::size_t>> columns = {};

    std::string column(std::size_t k) const { return std::string(name) + ends[k]; }
  };
  /// Its numbers, 0 where it has no column.
  std::array<Rational, 4> numbers(std::size_t row, const Group& group) const;
  Vector<Rational> vector(std::size_t row, const Group& group) const;

 protected:
  std::vector<std::string> names_;
};

/// What a table of text is to be, for complaints, and where its columns may have their names.
struct TableReading {
  bool reads_comment = false;  ///< the last comment above the numbers may be the header
  std::string_view row = "numbers";
};

/// A table of NumPy (NpyTable), or of text (TextTable). Refers to the bytes.
std::unique_ptr<NumberTable> read_number_table(std::string_view bytes, const TableReading& reading);

}  // namespace phrame
