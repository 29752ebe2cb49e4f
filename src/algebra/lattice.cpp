#include "phrame/algebra/lattice.hpp"

#include <utility>

#include "phrame/algebra/flint.hpp"

namespace phrame::inline v0 {
namespace {

struct IntegerMatrix {
  fmpz_mat_t value;
  IntegerMatrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(value, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ~IntegerMatrix() { fmpz_mat_clear(value); }
  IntegerMatrix(const IntegerMatrix&) = delete;
  IntegerMatrix& operator=(const IntegerMatrix&) = delete;

  fmpz* at(std::size_t row, std::size_t column) {
    return fmpz_mat_entry(value, static_cast<slong>(row), static_cast<slong>(column));
  }
};

IntegerRows rows_of(IntegerMatrix& matrix, std::size_t rows, std::size_t columns) {
  IntegerRows result(rows);
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x) result[y].emplace_back(matrix.at(y, x));
  return result;
}

/// Where there is a transform, it is multiplied likewise.
IntegerRows reduced(const IntegerRows& basis, fmpz_mat_struct* transform) {
  const std::size_t rows = basis.size();
  const std::size_t columns = basis.front().size();
  IntegerMatrix lattice(rows, columns);
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x) fmpz_set(lattice.at(y, x), basis[y][x].raw());
  fmpz_lll_t method;
  fmpz_lll_context_init_default(method);
  fmpz_lll(lattice.value, transform, method);
  return rows_of(lattice, rows, columns);
}

}  // namespace

IntegerRows reduced_basis(const IntegerRows& basis) { return reduced(basis, nullptr); }

ReducedBasis reduced_basis_with_transform(const IntegerRows& basis) {
  const std::size_t rows = basis.size();
  IntegerMatrix transform(rows, rows);
  fmpz_mat_one(transform.value);
  IntegerRows found = reduced(basis, transform.value);
  return {std::move(found), rows_of(transform, rows, rows)};
}

}  // namespace phrame
