#include "phrame/algebra/linear_system.hpp"

namespace phrame {
namespace {

struct Matrix {
  fmpq_mat_t value;
  Matrix(slong rows, slong columns) { fmpq_mat_init(value, rows, columns); }
  ~Matrix() { fmpq_mat_clear(value); }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;

  void set_column(slong k, const Polynomial& p) {
    for (slong row = 0; row <= p.degree(); ++row)
      fmpq_poly_get_coeff_fmpq(fmpq_mat_entry(value, row, k), p.raw(), row);
  }
};

}  // namespace

std::optional<std::vector<Rational>> solve_for_coefficients(const std::vector<Polynomial>& columns,
                                                            const Polynomial& right_side,
                                                            long equations) {
  if (static_cast<long>(columns.size()) != equations) return std::nullopt;
  Matrix a(equations, equations);
  Matrix x(equations, 1);
  Matrix b(equations, 1);
  for (long k = 0; k < equations; ++k) a.set_column(k, columns[static_cast<std::size_t>(k)]);
  b.set_column(0, right_side);
  if (fmpq_mat_solve(x.value, a.value, b.value) == 0) return std::nullopt;
  std::vector<Rational> solution;
  for (long k = 0; k < equations; ++k)
    solution.push_back(to_rational(fmpq_mat_entry(x.value, k, 0)));
  return solution;
}

}  // namespace phrame
