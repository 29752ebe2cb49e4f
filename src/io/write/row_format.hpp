#pragma once
#include <string>
#include <vector>

namespace phrame::inline v0 {

/// How a table is written row by row, of which there are so many.
struct RowFormat {
  std::string (*header)(const std::vector<std::string>& columns, std::size_t rows);
  void (*append)(std::string& text, const std::vector<double>& row);
};
RowFormat csv_rows();  ///< as to_csv()
RowFormat npy_rows();  ///< as to_npy()

}  // namespace phrame
