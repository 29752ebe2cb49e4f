#include "phrame/algebra/linear_system.hpp"

#include <algorithm>

namespace phrame::inline v0 {
namespace {

struct RationalMatrix {
  fmpq_mat_t value;
  RationalMatrix(slong rows, slong columns) { fmpq_mat_init(value, rows, columns); }
  ~RationalMatrix() { fmpq_mat_clear(value); }
  RationalMatrix(const RationalMatrix&) = delete;
  RationalMatrix& operator=(const RationalMatrix&) = delete;

  void set_column(slong k, const Polynomial& p) {
    for (slong row = 0; row <= p.degree(); ++row)
      fmpq_poly_get_coeff_fmpq(fmpq_mat_entry(value, row, k), p.raw(), row);
  }
};

struct BallMatrix {
  arb_mat_t value;
  BallMatrix(slong rows, slong columns) { arb_mat_init(value, rows, columns); }
  ~BallMatrix() { arb_mat_clear(value); }
  BallMatrix(const BallMatrix&) = delete;
  BallMatrix& operator=(const BallMatrix&) = delete;

  void set_column(slong k, const std::vector<RealBall>& x) {
    slong row = 0;
    for (const RealBall& entry : x) arb_set(arb_mat_entry(value, row++, k), entry.raw());
  }
};

}  // namespace

std::optional<std::vector<RealBall>> solve(const std::vector<std::vector<RealBall>>& columns,
                                           const std::vector<RealBall>& right_side, long bits) {
  const auto size = static_cast<slong>(columns.size());
  BallMatrix a(size, size);
  BallMatrix x(size, 1);
  BallMatrix b(size, 1);
  for (slong k = 0; k < size; ++k) a.set_column(k, columns[static_cast<std::size_t>(k)]);
  b.set_column(0, right_side);
  if (arb_mat_solve(x.value, a.value, b.value, bits) == 0) return std::nullopt;
  std::vector<RealBall> solution(columns.size());
  for (slong k = 0; k < size; ++k)
    arb_set(solution[static_cast<std::size_t>(k)].raw(), arb_mat_entry(x.value, k, 0));
  return solution;
}

/// In the reduced echelon form of the matrix with the columns p_k, a column without a pivot is the
/// combination of pivot columns before it that stands in it.
std::vector<std::vector<Rational>> linear_relations(const std::vector<Polynomial>& p) {
  long rows = 1;
  for (const Polynomial& column : p) rows = std::max(rows, column.degree() + 1);
  const auto columns = static_cast<long>(p.size());
  RationalMatrix a(rows, columns);
  for (long k = 0; k < columns; ++k) a.set_column(k, p[static_cast<std::size_t>(k)]);
  fmpq_mat_rref(a.value, a.value);
  std::vector<std::vector<Rational>> relations;
  std::vector<std::size_t> pivots;  // the column of the pivot of each row
  for (long k = 0; k < columns; ++k) {
    const auto row = static_cast<long>(pivots.size());
    if (row < rows && fmpq_is_zero(fmpq_mat_entry(a.value, row, k)) == 0) {
      pivots.push_back(static_cast<std::size_t>(k));
      continue;
    }
    std::vector<Rational> relation(p.size());
    relation[static_cast<std::size_t>(k)] = 1;
    for (long i = 0; i < row; ++i)
      relation[pivots[static_cast<std::size_t>(i)]] = -Rational(fmpq_mat_entry(a.value, i, k));
    relations.push_back(std::move(relation));
  }
  return relations;
}

}  // namespace phrame
