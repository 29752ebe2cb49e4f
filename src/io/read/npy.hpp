#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "phrame/io/read/number_table.hpp"

namespace phrame::inline v0 {

struct NpyHeader;

/// A table in NumPy's .npy format, versions 1.0 to 3.0 (numpy.lib.format): an array of two
/// dimensions, in C or Fortran order, one of matrices, (n, 4, 4) or (n, 3, 4), whose numbers are
/// the columns, row by row, or a structured array of one dimension, whose fields are the columns; a
/// field "f2" of shape (3,) is the columns f2x, f2y, f2z, and a field "q" of shape (4,) is qw, qx,
/// qy, qz. Integers and floating-point numbers of 2, 4 and 8 bytes of either byte order are read,
/// exactly.
class NpyTable : public NumberTable {
 public:
  /// Does the file begin as such a table does?
  static bool is_one(std::string_view bytes);

  /// Refers to the bytes. Throws InputError; its place is "header" or "data".
  explicit NpyTable(std::string_view bytes);

  std::string header_place() const override { return "header"; }
  std::size_t rows() const override { return rows_; }
  std::size_t columns() const override { return columns_.size(); }
  std::string place(std::size_t row) const override;  ///< "row 3", from 0

  using NumberTable::number;
  /// NaN, infinities and types that are not read are no numbers.
  Rational number(std::size_t row, std::size_t column) const override;
  bool is_missing(std::size_t row, std::size_t column) const override;

 private:
  /// How one number is written, as "<f8" says it.
  struct Type {
    char kind = 0;  ///< 'f', 'i', 'u', or another, which is not read
    bool is_big_endian = false;
    std::size_t size = 0;  ///< in bytes
    std::string text;
  };
  struct Column {
    Type type;
    std::size_t offset;  ///< of its first number
  };
  double floating_point(std::size_t row, std::size_t column) const;
  static Type type_of(const std::string& text);
  void lay_out_plain(const NpyHeader& header);
  void lay_out_structured(const NpyHeader& header);

  std::string_view data_;
  std::vector<Column> columns_;
  std::size_t rows_ = 0;
  std::size_t stride_ = 0;  ///< from a number to that below it
};

}  // namespace phrame
