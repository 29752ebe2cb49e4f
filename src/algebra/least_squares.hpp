#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace phrame::inline v0 {

// Small dense systems in doubles, for guesses. Nothing is proved here.

/// The rows of a matrix, all of the same length.
using DoubleRows = std::vector<std::vector<double>>;

/// M = QR of the columns in another order, by Householder's reflections, each time of the column
/// that is left the longest. Golub and Van Loan, Matrix Computations, 5.4.
struct PivotedQr {
  explicit PivotedQr(const DoubleRows& matrix);

  std::vector<std::vector<double>> columns;  ///< of R above the diagonal, of the mirrors' normals
                                             ///< from there on
  std::vector<double> diagonal;              ///< of R, as long as a column is not 0
  std::vector<double> factors;               ///< a mirror is 1 − factor·(normal)(normal)ᵀ
  std::vector<std::size_t> order;            ///< column k is that of order[k]
  std::size_t rows = 0;
};

/// The pseudo-inverse of a matrix M: b ↦ the shortest of the x for which |Mx − b| is least, by a
/// complete orthogonal decomposition. What is at most `nothing` times the greatest diagonal element
/// of R is taken for 0.
class LeastSquares {
 public:
  LeastSquares(const DoubleRows& matrix, double nothing);

  /// As many numbers as M has columns. Precondition: b has as many as M has rows.
  std::vector<double> operator()(std::span<const double> b) const;

 private:
  PivotedQr qr_;
  std::size_t rank_ = 0;
  std::vector<double> factors_;  ///< of the mirrors that take R's further columns away
};

/// An x of length 1 for which |Mx| is about as small as can be, by a few steps of inverse
/// iteration; where M has fewer rows than columns it is 0 but for rounding. Its sign is as it
/// comes.
std::vector<double> least_singular_vector(const DoubleRows& matrix);

/// The x with Mx = b, by Gauss's elimination: where a variable is in no equation with another, one
/// does not change the other's last digit. Not finite where M is singular. Precondition: M is
/// square.
std::vector<double> eliminated(DoubleRows matrix, std::vector<double> b);

/// √Σ x².
double euclidean_norm(std::span<const double> x);

/// x + factor·change.
template <std::size_t n>
std::array<double, n> moved(std::array<double, n> x, double factor,
                            std::span<const double> change) {
  for (std::size_t k = 0; k < n; ++k) x[k] += factor * change[k];
  return x;
}

}  // namespace phrame
