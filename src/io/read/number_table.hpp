#pragma once
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// Rows of numbers below the names of their columns, or without names, whatever the file is.
class NumberTable {
 public:
  virtual ~NumberTable() = default;

  const std::vector<std::string>& names() const { return names_; }  ///< none without a header
  /// Of each column, empty where there is none; an empty list where there is no header.
  const std::vector<std::string>& units() const { return units_; }
  /// What was assumed when it was read, in sentences without a point.
  const std::vector<std::string>& notes() const { return notes_; }
  virtual std::string header_place() const = 0;
  virtual std::size_t rows() const = 0;
  virtual std::size_t columns() const = 0;
  virtual std::string place(std::size_t row) const = 0;  ///< "line 3"
  /// "line 3, x"
  virtual std::string place_in_row(std::size_t row, std::size_t column,
                                   std::string_view name) const;
  /// Is there no number: nothing, NaN, an infinity, or a word for them?
  virtual bool is_missing(std::size_t row, std::size_t column) const = 0;
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
  std::vector<std::string> units_;
  std::vector<std::string> notes_;
};

/// A table without some of its rows; the others keep their places.
class TableOfRows : public NumberTable {
 public:
  /// The rows of that table, in order, with another note.
  TableOfRows(std::unique_ptr<NumberTable> table, std::vector<std::size_t> rows, std::string note);

  std::string header_place() const override { return table_->header_place(); }
  std::size_t rows() const override { return rows_.size(); }
  std::size_t columns() const override { return table_->columns(); }
  std::string place(std::size_t row) const override { return table_->place(rows_[row]); }
  std::string place_in_row(std::size_t row, std::size_t column,
                           std::string_view name) const override {
    return table_->place_in_row(rows_[row], column, name);
  }
  using NumberTable::number;
  Rational number(std::size_t row, std::size_t column) const override {
    return table_->number(rows_[row], column);
  }
  bool is_missing(std::size_t row, std::size_t column) const override {
    return table_->is_missing(rows_[row], column);
  }

 private:
  std::unique_ptr<NumberTable> table_;
  std::vector<std::size_t> rows_;
};

/// The table with these rows only, at least one, in order; a note says how many others there are,
/// and `why` they are left out, "without a number".
std::unique_ptr<NumberTable> with_rows(std::unique_ptr<NumberTable> table,
                                       std::vector<std::size_t> rows, std::string_view why);
/// The table without the rows that miss a number in one of these columns.
std::unique_ptr<NumberTable> without_missing(std::unique_ptr<NumberTable> table,
                                             const std::vector<std::size_t>& columns);

/// What a table of text is to be, for complaints, and where its columns may have their names.
struct TableForm {
  bool reads_comment = false;  ///< the last comment above the numbers may be the header
  std::string_view row = "numbers";
};

/// A table of NumPy (NpyTable), of JSON, where it begins with a '[' or is a frames/1 (JsonTable),
/// or of text (TextTable). Refers to the bytes.
std::unique_ptr<NumberTable> read_number_table(std::string_view bytes, const TableForm& reading);

}  // namespace phrame
