// Let T and T̃ be the unit tangents of the two curves, η(t) < π the angle between them, κ and κ̃ the
// rates |T′| and |T̃′|. A rotation-minimizing frame is carried along the curve of tangents on the
// unit sphere by parallel transport. To go along T from 0 to t and then by the shortest arc to
// T̃(t), or by the shortest arc to T̃(0) and then along T̃, differs by the rotation around the loop
// that the two ways make, whose angle is the area, with its sign, that the arcs from T(τ) to T̃(τ),
// τ ∈ [0, t], sweep over (Gauss and Bonnet). This is the angle between the two frames, and
// continuous in t, so that it is that of the frames without multiples of 2π.
//
// Of the arcs S(τ, x), x ∈ [0, 1], the part of ∂S/∂τ at right angles to the arc is a Jacobi field,
//   (sin((1 − x)η)·a + sin(xη)·b)/sin η  with  |a| ≤ κ, |b| ≤ κ̃,
// and |∂S/∂x| = η. So the area swept over in dτ is at most
//   η ∫₀¹ |…| dx ≤ ((1 − cos η)/sin η)·(κ + κ̃) = tan(η/2)·(κ + κ̃),
// and the angle is at most Σ tan(η_i/2)(K_i + K̃_i) over parts with η ≤ η_i on them, K_i and K̃_i
// being their total curvatures, the lengths of T and T̃. The same holds where T jumps, along an arc
// of the length that is: the points next to T̃ by η_i are a convex cap.
//
// η: sin η ≤ |r′ − r̃′|/|r̃′|, and η < π/2 where |r′ − r̃′| < |r̃′|. With Bernstein coefficients d_k of
// r′ − r̃′ and c_k of r̃′, and any unit vector e: |r′ − r̃′| ≤ max |d_k|, |r̃′| ≥ min e·c_k.
//
// K: by Crofton's formula the length of T is π times the mean, over all great circles, of the
// number of points where T crosses one. T crosses that of the normal x where x·r′ changes its sign,
// at most as often as the sequence of the numbers x·c_k does (Bernstein polynomials diminish
// variation), which is as often as the polygon of arcs from each direction c_k/|c_k| to the next
// crosses it. So K is at most the length of that polygon, the sum of the angles between successive
// c_k. For parts made by subdivision it tends to K.
//
// Rounding. Coefficients are doubles, with one bound for the error of all components of a row and a
// power of 2 for itself. Sums, products, quotients and roots of doubles are off by a share of 2^−53
// at most. A mean is off by less than 2^−52 of the greatest of a row, and what its two terms were
// off by does not grow. What follows are a few operations on vectors each, good to a share of 2^−48
// of the lengths: such a share is added to what is to be an upper bound, or taken off. Where errors
// are no longer small beside a part of the row, as near a cusp, it is computed anew from the exact
// coefficients.
//
// The angle θ ≤ π/2 between two vectors has tan(θ/2) = |a × b|/(|a||b| + a·b), and half of it is at
// most (2 sin + tan)/3 of it (Huygens), which is 3 % too much at the worst.
#include "phrame/ph/construct/rmf_difference.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

constexpr int most_halvings = 48;    ///< of a part
constexpr long most_parts = 10'000;  ///< of a piece
constexpr double share = 0x1p-48;    ///< of a length, what few operations are off by

using RationalRow = std::vector<Vector<Rational>>;

/// Bernstein coefficients: 2^exponent times these, each component of which is off by ≤ radius.
struct EnclosedRow {
  std::vector<Vector<double>> vectors;
  double radius = 0;
  long exponent = 0;
};

EnclosedRow enclosed(const RationalRow& row) {
  const Rational size = largest(row);
  EnclosedRow result;
  if (size != 0) {
    result.exponent = binary_exponent(size);
    result.radius = 0x1p-50;
  }
  const Rational factor = power_of_two(-result.exponent);
  for (const auto& v : row) result.vectors.push_back(scaled_to_doubles(factor, v));
  return result;
}

double largest(const std::vector<Vector<double>>& row) {
  double result = 0;
  for (const auto& v : row)
    for (const double x : v) result = std::max(result, std::abs(x));
  return result;
}

double length(const Vector<double>& v) { return std::sqrt(dot(v, v)); }

/// De Casteljau's algorithm at t, which all means are of.
template <class V, class Mean>
std::pair<std::vector<V>, std::vector<V>> divided(std::vector<V> row, const Mean& mean) {
  std::vector<V> left;
  std::vector<V> right(row.size());
  for (std::size_t count = row.size(); count > 0; --count) {
    left.push_back(row.front());
    right[count - 1] = row[count - 1];
    for (std::size_t k = 0; k + 1 < count; ++k) row[k] = mean(row[k], row[k + 1]);
  }
  return {std::move(left), std::move(right)};
}

std::pair<EnclosedRow, EnclosedRow> halves(const EnclosedRow& row) {
  auto [left, right] = divided(row.vectors, [](const auto& a, const auto& b) {
    return Vector<double>{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  });
  const double size = largest(row.vectors);
  const double radius = size == 0 ? row.radius
                                  : row.radius + static_cast<double>(row.vectors.size()) *
                                                     (0x1p-52 * size + 0x1p-1000);
  return {{std::move(left), radius, row.exponent}, {std::move(right), radius, row.exponent}};
}

/// Of the part [from, from + step], in [0, 1].
RationalRow exact_part(RationalRow row, const Rational& from, const Rational& step) {
  const auto at = [](const Rational& t) {
    return [&t, s = Rational(1 - t)](const Vector<Rational>& a, const Vector<Rational>& b) {
      return s * a + t * b;
    };
  };
  if (from != 0) row = divided(std::move(row), at(from)).second;
  const Rational end = step / (1 - from);
  return end == 1 ? row : divided(std::move(row), at(end)).first;
}

/// ≥ the angle between the vectors, as they are in doubles.
double angle_above(const Vector<double>& a, const Vector<double>& b) {
  constexpr double pi_above = 3.1416;
  const double along = dot(a, b);
  const double lengths = length(a) * length(b);
  if (!(along > 0 && lengths > 0x1p-200)) return pi_above;
  const Vector<double> normal = cross(a, b);
  const double tangent = length(normal) / (lengths + along);
  return (2 * (2 / std::sqrt(1 + tangent * tangent) + 1) / 3) * tangent * (1 + share) + share;
}

/// ≥ the sum of the angles between successive vectors, each off by ≤ radius in its components.
double turns_above(const std::vector<Vector<double>>& row, double radius, double least_length) {
  double sum = 0;
  for (std::size_t k = 1; k < row.size(); ++k)
    sum += angle_above(row[k - 1], row[k]) + 8 * radius / least_length;
  return sum * (1 + static_cast<double>(row.size()) * share);
}

/// Where the first vector is 0 there is no bound anyway.
bool is_straight(const RationalRow& row) {
  const Vector<Rational> none{};
  for (const auto& v : row)
    if (cross(v, row.front()) != none) return false;
  return true;
}

/// A part of both curves: r̃′ and r′ − r̃′.
struct PairPart {
  EnclosedRow other;
  EnclosedRow difference;
  Rational from = 0;
  int halvings = 0;
};

std::pair<PairPart, PairPart> halves(const PairPart& part) {
  auto [other, other_end] = halves(part.other);
  auto [difference, difference_end] = halves(part.difference);
  const int halvings = part.halvings + 1;
  return {{std::move(other), std::move(difference), part.from, halvings},
          {std::move(other_end), std::move(difference_end), part.from + power_of_two(-halvings),
           halvings}};
}

/// 2^exponent·factor, a small number.
struct ScaledNumber {
  double factor = 0;
  long exponent = 0;
  Rational exact() const { return exact_rational(factor) * power_of_two(exponent); }
};

/// Where one of the curves comes from, or goes to.
struct GivenEnd {
  Vector<double> given;
  double error;      ///< of the angle to another
  Rational tangent;  ///< tan(η/2) on the part next to it
};

/// The sum, part by part.
class DifferenceBound {
 public:
  /// Is it bounded?
  bool add_piece(const HodographPair& pair) {
    other_ = pair.other;
    difference_.clear();
    for (std::size_t k = 0; k < pair.given.size(); ++k)
      difference_.push_back(pair.given[k] - pair.other[k]);
    is_other_straight_ = is_straight(pair.other);
    is_given_straight_ = is_straight(pair.given);
    is_first_of_piece_ = true;
    std::vector<PairPart> todo{{enclosed(other_), enclosed(difference_)}};
    for (long k = 0; !todo.empty(); ++k) {
      if (k == most_parts) return false;
      PairPart part = std::move(todo.back());
      todo.pop_back();
      refresh(part);
      if (!add_part(part)) {
        if (part.halvings == most_halvings) return false;
        auto [first, second] = halves(part);
        todo.push_back(std::move(second));
        todo.push_back(std::move(first));
      }
    }
    return true;
  }

  const Rational& value() const { return sum_; }

 private:
  /// So the greatest component of r̃′ is > 2^−21 as it is stored, unless all are 0.
  void refresh(PairPart& part) const {
    if (part.other.radius <= 0x1p-30 * largest(part.other.vectors)) return;
    const Rational step = power_of_two(-part.halvings);
    part.other = enclosed(exact_part(other_, part.from, step));
    part.difference = enclosed(exact_part(difference_, part.from, step));
  }

  /// No value where the part is too long to tell it well.
  bool add_part(const PairPart& part) {
    const auto& other = part.other.vectors;
    Vector<double> middle{};
    double fastest = 0;
    double difference = 0;
    for (std::size_t k = 0; k < other.size(); ++k) {
      middle = middle + other[k];
      fastest = std::max(fastest, length(other[k]));
      difference = std::max(difference, length(part.difference.vectors[k]));
    }
    const double middle_length = length(middle);
    if (!(middle_length > 0x1p-100)) return false;
    double slowest = HUGE_VAL;
    for (const auto& v : other) slowest = std::min(slowest, dot(middle, v) / middle_length);
    // √3 < 2 is for the components of vectors.
    slowest -= share * fastest + 2 * part.other.radius;
    if (!(slowest >= 0.75 * fastest)) return false;
    difference = difference * (1 + share) + 2 * part.difference.radius;
    const ScaledNumber sine{difference / slowest * (1 + share),
                            part.difference.exponent - part.other.exponent};
    const long exponent = std::clamp(sine.exponent, -600L, 600L);
    const double sine_above = std::ldexp(sine.factor, static_cast<int>(exponent)) * (1 + share);
    if (!(sine_above <= 0.5)) return false;
    const double cosine = std::sqrt(1 - sine_above * sine_above) * (1 - share);
    add(part, {sine.factor / (1 + cosine) * (1 + share), sine.exponent}, slowest);
    return true;
  }

  void add(const PairPart& part, const ScaledNumber& tangent_of_half, double slowest) {
    const long apart = std::clamp(part.difference.exponent - part.other.exponent, -2000L, 600L);
    std::vector<Vector<double>> given = part.other.vectors;
    for (std::size_t k = 0; k < given.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        given[k][c] += std::ldexp(part.difference.vectors[k][c], static_cast<int>(apart));
    // The components of r̃′ are about 1, and those of the difference less than half of that.
    const double given_radius = part.other.radius +
                                std::ldexp(part.difference.radius, static_cast<int>(apart)) +
                                0x1p-50 * slowest;
    const Rational tangent = tangent_of_half.exact();
    double turns = 0;
    if (!is_other_straight_) turns += turns_above(part.other.vectors, part.other.radius, slowest);
    if (!is_given_straight_) turns += turns_above(given, given_radius, slowest / 2);
    sum_ += tangent * exact_rational(turns * (1 + share));
    const double error = 8 * given_radius / slowest;
    if (is_first_of_piece_ && last_)  // the given tangent may jump
      sum_ += std::max(tangent, last_->tangent) *
              exact_rational((angle_above(last_->given, given.front()) + error + last_->error) *
                             (1 + share));
    last_ = GivenEnd{given.back(), error, tangent};
    is_first_of_piece_ = false;
  }

  RationalRow other_;
  RationalRow difference_;
  bool is_other_straight_ = false;
  bool is_given_straight_ = false;
  Rational sum_;
  std::optional<GivenEnd> last_;
  bool is_first_of_piece_ = true;
};

}  // namespace

std::optional<Rational> rmf_difference_bound(const std::vector<HodographPair>& pieces) {
  DifferenceBound bound;
  for (const HodographPair& piece : pieces)
    if (!bound.add_piece(piece)) return std::nullopt;
  return bound.value();
}

}  // namespace phrame
