#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "phrame/io/read/column_name.hpp"
#include "phrame/io/read/number_table.hpp"

namespace phrame::inline v0 {

/// Lines of numbers, separated by ';', ',', tabs or blanks, whichever of them comes first in this
/// list and in the first line, below the names of the columns, or without. Separators in quotes are
/// none. Empty lines and lines that begin with '#' are skipped. Names may have units (column_name),
/// or a row of units stands below them. Decimals have a point, or all of them a comma, which a note
/// says: between ';' or tabs, or in quotes. Exponents have an E, or a D as Fortran writes them.
/// Refers to the text.
class TextTable : public NumberTable {
 public:
  /// Throws InputError for what is no table, or has no row, and for rows of unequal widths.
  TextTable(std::string_view text, const TableForm& reading);

  std::string header_place() const override;
  std::size_t rows() const override { return rows_.size(); }
  std::size_t columns() const override {
    return names_.empty() ? rows_.front().fields.size() : names_.size();
  }
  std::string place(std::size_t row) const override;
  char separator() const { return separator_; }  ///< a blank for any number of blanks and tabs
  /// Is there an empty line between the row and the one before?
  bool is_after_gap(std::size_t row) const { return rows_[row].is_after_gap; }
  using NumberTable::number;
  Rational number(std::size_t row, std::size_t column) const override;
  bool is_missing(std::size_t row, std::size_t column) const override;

 private:
  struct Row {
    std::vector<std::string_view> fields;
    long line;
    bool is_after_gap;
  };
  void add(std::string_view content, long line);
  void take_comment_for_header();
  void take_units_off();
  void find_decimal_mark();
  void require_equal_widths() const;

  long header_line_ = 1;
  std::vector<Row> rows_;
  char separator_ = 0;
  bool has_gap_ = false;    ///< since the last row
  bool has_point_ = false;  ///< in one of the numbers, at least
  bool has_decimal_comma_ = false;
  std::string_view comment_;  ///< the last above the first row, without its "#"
  long comment_line_ = 0;
};

/// The names in a line above a table, without their units. Throws InputError, with no place, where
/// a quote is not closed.
std::vector<std::string> header_names(std::string_view line);

}  // namespace phrame
