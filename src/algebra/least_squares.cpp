#include "phrame/algebra/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace phrame::inline v0 {
namespace {

/// The mirror that takes x to (alpha, 0, …, 0): its normal replaces x.
struct Mirror {
  double alpha;
  double factor;
};

Mirror mirror(std::span<double> x) {
  const double size = euclidean_norm(x);
  if (!(size > 0)) return {x[0], 0};
  const double alpha = x[0] > 0 ? -size : size;  // so that nothing cancels
  x[0] -= alpha;
  return {alpha, 1 / (size * std::abs(x[0]))};
}

double inner(std::span<const double> x, std::span<const double> y) {
  return std::inner_product(x.begin(), x.end(), y.begin(), 0.0);
}

void reflect(std::span<double> x, std::span<const double> normal, double factor) {
  const double along = factor * inner(x, normal);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] -= along * normal[k];
}

/// The squares of the lengths of what is left of columns. Of each, what is done is taken away, and
/// the rest is summed anew where digits have cancelled.
class RestSquares {
 public:
  explicit RestSquares(const std::vector<std::vector<double>>& columns)
      : known_(squares(columns)), now_(known_) {}
  std::size_t longest(std::size_t from) const {
    const auto first = now_.begin() + static_cast<std::ptrdiff_t>(from);
    return static_cast<std::size_t>(std::max_element(first, now_.end()) - now_.begin());
  }
  void exchange(std::size_t a, std::size_t b) {
    std::swap(known_[a], known_[b]);
    std::swap(now_[a], now_[b]);
  }
  void take_away(std::size_t column, double x, std::span<const double> rest) {
    constexpr double few_digits = 1e-6;
    now_[column] -= x * x;
    if (now_[column] > few_digits * known_[column]) return;
    now_[column] = known_[column] = inner(rest, rest);
  }

 private:
  static std::vector<double> squares(const std::vector<std::vector<double>>& columns) {
    std::vector<double> result;
    result.reserve(columns.size());
    for (const auto& column : columns) result.push_back(inner(column, column));
    return result;
  }

  std::vector<double> known_;
  std::vector<double> now_;
};

}  // namespace

double euclidean_norm(std::span<const double> x) { return std::sqrt(inner(x, x)); }

PivotedQr::PivotedQr(const DoubleRows& matrix)
    : columns(matrix.front().size()), order(matrix.front().size()), rows(matrix.size()) {
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t x = 0; x < columns.size(); ++x) {
    columns[x].reserve(rows);
    for (const auto& row : matrix) columns[x].push_back(row[x]);
  }
  diagonal.reserve(rows);
  factors.reserve(rows);
  RestSquares squares(columns);
  for (std::size_t k = 0; k < std::min(rows, columns.size()); ++k) {
    const std::size_t pivot = squares.longest(k);
    squares.exchange(k, pivot);
    std::swap(columns[k], columns[pivot]);
    std::swap(order[k], order[pivot]);
    const auto normal = std::span(columns[k]).subspan(k);
    const auto [alpha, factor] = mirror(normal);
    if (factor == 0) break;
    diagonal.push_back(alpha);
    factors.push_back(factor);
    for (std::size_t j = k + 1; j < columns.size(); ++j) {
      const auto rest = std::span(columns[j]).subspan(k);
      reflect(rest, normal, factor);
      squares.take_away(j, rest[0], rest.subspan(1));
    }
  }
}

// R = (R₁ R₂) has R₂ taken away by mirrors from the right, from the last row on: row k is then
// (…, ρ, …, 0), its mirror's normal is at k and in R₂.
LeastSquares::LeastSquares(const DoubleRows& matrix, double nothing) : qr_(matrix) {
  auto& diagonal = qr_.diagonal;
  while (rank_ < diagonal.size() &&
         std::abs(diagonal[rank_]) > nothing * std::abs(diagonal.front()))
    ++rank_;
  factors_.resize(rank_);
  const std::size_t more = qr_.columns.size() - rank_;
  if (more == 0) return;
  std::vector<double> normal;
  for (std::size_t k = rank_; k-- > 0;) {
    normal.assign(1, diagonal[k]);
    for (std::size_t j = rank_; j < qr_.columns.size(); ++j) normal.push_back(qr_.columns[j][k]);
    const auto [alpha, factor] = mirror(normal);
    factors_[k] = factor;
    diagonal[k] = alpha;
    for (std::size_t y = 0; y < k; ++y) {
      double along = qr_.columns[k][y] * normal[0];
      for (std::size_t j = 0; j < more; ++j) along += qr_.columns[rank_ + j][y] * normal[j + 1];
      qr_.columns[k][y] -= factor * along * normal[0];
      for (std::size_t j = 0; j < more; ++j)
        qr_.columns[rank_ + j][y] -= factor * along * normal[j + 1];
    }
    // Where R₂ was is room for the rest of the normal; with its first element 1.
    factors_[k] *= normal[0] * normal[0];
    for (std::size_t j = 0; j < more; ++j) qr_.columns[rank_ + j][k] = normal[j + 1] / normal[0];
  }
}

std::vector<double> LeastSquares::operator()(std::span<const double> b) const {
  std::vector<double> c(b.begin(), b.end());
  for (std::size_t k = 0; k < rank_; ++k)
    reflect(std::span(c).subspan(k), std::span(qr_.columns[k]).subspan(k), qr_.factors[k]);
  std::vector<double> y(qr_.columns.size(), 0.0);
  for (std::size_t k = rank_; k-- > 0;) {
    y[k] = c[k];
    for (std::size_t j = k + 1; j < rank_; ++j) y[k] -= qr_.columns[j][k] * y[j];
    y[k] /= qr_.diagonal[k];
  }
  for (std::size_t k = 0; k < rank_; ++k) {
    double along = y[k];
    for (std::size_t j = rank_; j < y.size(); ++j) along += qr_.columns[j][k] * y[j];
    y[k] -= factors_[k] * along;
    for (std::size_t j = rank_; j < y.size(); ++j) y[j] -= factors_[k] * along * qr_.columns[j][k];
  }
  std::vector<double> x(y.size());
  for (std::size_t k = 0; k < y.size(); ++k) x[qr_.order[k]] = y[k];
  return x;
}

std::vector<double> least_singular_vector(const DoubleRows& matrix) {
  constexpr double tiny = 1e-15;
  constexpr int steps = 4;
  const PivotedQr qr(matrix);
  const std::size_t n = qr.columns.size();
  const double least = qr.diagonal.empty() ? 1 : tiny * std::abs(qr.diagonal.front());
  const auto r = [&](std::size_t y, std::size_t x) {
    if (y < x) return y < qr.diagonal.size() ? qr.columns[x][y] : 0.0;
    if (y < qr.diagonal.size() && std::abs(qr.diagonal[y]) >= least) return qr.diagonal[y];
    return least;
  };
  // x ↦ (RᵀR)⁻¹x, at first of a vector of ±1 that makes the result long: Cline, Moler, Stewart and
  // Wilkinson, An estimate for the condition number of a matrix, SIAM J. Numer. Anal. 16 (1979).
  std::vector<double> x(n, 0.0);
  for (int step = 0; step < steps; ++step) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < k; ++j) x[k] -= r(j, k) * x[j];
      if (step == 0) x[k] += x[k] < 0 ? -1 : 1;
      x[k] /= r(k, k);
    }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) x[k] -= r(k, j) * x[j];
      x[k] /= r(k, k);
    }
    const double size = euclidean_norm(x);
    for (double& value : x) value /= size;
  }
  std::vector<double> result(n);
  for (std::size_t k = 0; k < n; ++k) result[qr.order[k]] = x[k];
  return result;
}

std::vector<double> eliminated(DoubleRows matrix, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t y = k + 1; y < n; ++y)
      if (std::abs(matrix[y][k]) > std::abs(matrix[pivot][k])) pivot = y;
    std::swap(matrix[k], matrix[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t y = k + 1; y < n; ++y) {
      const double factor = matrix[y][k] / matrix[k][k];
      for (std::size_t x = k + 1; x < n; ++x) matrix[y][x] -= factor * matrix[k][x];
      b[y] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t x = k + 1; x < n; ++x) b[k] -= matrix[k][x] * b[x];
    b[k] /= matrix[k][k];
  }
  return b;
}

}  // namespace phrame
