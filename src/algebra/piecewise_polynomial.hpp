#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "phrame/algebra/double_polynomial.hpp"

namespace phrame::inline v0 {

/// Polynomials in y = (t − center)·scale, |y| ≤ 1, which is exact in doubles, but for underflow,
/// where t is one in the piece: the scale is a power of two, and the center 0 or so near that
/// t/2 ≤ center ≤ 2t.
struct PolynomialPiece {
  double center = 0;  ///< where y = 0
  double scale = 1;   ///< a power of two
  double origin = 0;  ///< what is 0 for the polynomials that on_piece is given
  /// What a value computed in doubles is off by: at most error + error_per_y·|y|, of all
  /// polynomials together in the Euclidean norm. The error is 0 but for underflow where all are 0
  /// at y = 0, as what they stand for is.
  double error = 0;
  double error_per_y = 0;            ///< see error
  double steepness = 0;              ///< of the coefficients, once it is one of several pieces
  std::vector<double> coefficients;  ///< as a DoubleShape says

  double y(double t) const { return (t - center) * scale; }  ///< of the parameter t
};

/// A center and a scale for [from, to]. No value where there is no such center: the interval is to
/// be divided. Throws Undecided where it is smaller than 2^−900 or larger than 2^900.
std::optional<PolynomialPiece> empty_piece(double from, double to, double origin = 0);
/// p(center − origin + y/scale), all coefficients known to about `bits` bits relative to the
/// greatest, the constant one relative to itself if it is to be `definite` and is not 0. Throws
/// Undecided where it is not.
BallPolynomial on_piece(const Polynomial& p, const PolynomialPiece& piece, long bits,
                        bool is_definite = false);

/// The same over the scale, for a p that belongs to a derivative by t: by y.
BallPolynomial per_y(const Polynomial& p, const PolynomialPiece& piece, long bits);

/// A lower bound of |p| on |y| ≤ 1: |p(0)| − Σ |other coefficients|, positive or not.
RealBall least(const BallPolynomial& p, long bits);
/// Σ |p_k| without the constant coefficient: p varies by no more from its value at 0.
RealBall variation(const BallPolynomial& p, long bits);
/// Σ |p_k|/(k + 1), so that |∫₀^y |p|| ≤ |y|·that on |y| ≤ 1.
RealBall integral_bound(const BallPolynomial& p, long bits);

/// Piecewise polynomials on [from, to], found by halving it.
class PiecewisePolynomial {
 public:
  /// The polynomials for [from, to], or no value if it is to be divided.
  using Make = std::function<std::optional<PolynomialPiece>(double from, double to)>;

  /// Throws DomainError unless from < to and the length is finite, and Undecided where more than
  /// max_pieces are needed, or a piece that has no double inside, or where a coefficient or an
  /// error is too large for a double.
  PiecewisePolynomial(double from, double to, const DoubleShape& shape, const Make& make)
      : PiecewisePolynomial(std::vector{from, to}, shape, make) {}
  /// The same with these ends, ascending and at least two, among those of the pieces; max_pieces
  /// are for each interval between two of them. Cost: linear in the pieces.
  PiecewisePolynomial(const std::vector<double>& ends, const DoubleShape& shape, const Make& make);
  /// The same on [0, n] with the ends 0, 1, …, n.
  static PiecewisePolynomial on_units(std::size_t n, const DoubleShape& shape, const Make& make);
  /// More pieces than these between two ends that were given are Undecided.
  static constexpr std::size_t max_pieces = 20'000;

  double from() const { return ends_.front(); }        ///< where they begin
  double to() const { return ends_.back(); }           ///< where they end
  const DoubleShape& shape() const { return shape_; }  ///< of the coefficients of every piece
  const std::vector<PolynomialPiece>& pieces() const { return pieces_; }  ///< ascending

  /// Ascending, one more than pieces; a piece is [end, next end), the last one closed.
  const std::vector<double>& ends() const { return ends_; }
  /// @{ [from, to] is cut into cells, the floors of (t − from)·cells_per_unit() in doubles. The
  /// pieces that meet cell number k are those from first[k] to first[k + 1], often only first[k].
  double cells_per_unit() const { return cells_per_unit_; }
  const std::vector<std::uint32_t>& first() const { return first_; }
  /// @}

  /// Throws DomainError, in the name of `what`, for a t outside [from(), to()] and NaN.
  void require_inside(double t, const char* what) const {
    if (!(from() <= t && t <= to())) fail_outside(t, what);
  }
  /// The same for each t, and where there are not so many results as t.
  void require_inside(std::span<const double> t, std::size_t results, const char* what) const;
  /// The piece that t lies in. Precondition: from() ≤ t ≤ to().
  const PolynomialPiece& at(double t) const { return pieces_[index_at(t)]; }
  /// Its number.
  std::size_t index_at(double t) const {
    const std::size_t cell = cell_of(t);
    std::size_t low = first_[cell];
    std::size_t high = first_[cell + 1];
    // Of one or two pieces without a branch, which a processor could only guess.
    if (high - low <= 1) return std::min(low + static_cast<std::size_t>(t >= ends_[low + 1]), high);
    while (low < high) {
      const std::size_t middle = (low + high + 1) / 2;
      if (t < ends_[middle])
        high = middle - 1;
      else
        low = middle;
    }
    return low;
  }

 private:
  [[noreturn]] void fail_outside(double t, const char* what) const;
  std::size_t cell_of(double t) const {
    return static_cast<std::size_t>(static_cast<long>((t - ends_.front()) * cells_per_unit_));
  }
  void make_cells();

  DoubleShape shape_;
  std::vector<double> ends_;
  std::vector<PolynomialPiece> pieces_;
  double cells_per_unit_ = 1;
  std::vector<std::uint32_t> first_;
};

/// The same, for several to have.
inline std::shared_ptr<const PiecewisePolynomial> shared(PiecewisePolynomial polynomials) {
  return std::make_shared<const PiecewisePolynomial>(std::move(polynomials));
}

/// Values of `width` functions, each within `error`, and so all together in the Euclidean norm.
template <std::size_t width>
struct NearValues {
  std::array<DoubleDouble, width> values;
  double error;
};
/// What the polynomials stand for at a t that need not be a double. No value outside of them, and
/// next to the ends of some pieces. Width is 1 or 4, as that of the shape. In rounding to nearest.
template <std::size_t width>
std::optional<NearValues<width>> near_values(const PiecewisePolynomial& polynomials,
                                             const NearNumber& t);

}  // namespace phrame
