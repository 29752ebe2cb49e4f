#include "phrame/ph/construct/near_plane_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/ph/curve/complex_form.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"

// With x + iy for (x, y) a quintic is r′ = w², w = w₀B₀ + w₁B₁ + w₂B₂. w₀ and w₂ are real multiples
// of a root of the tangent at the ends, which neighbours share, so that the tangent is continuous,
// exactly. All are rounded from doubles; that a quintic is near enough is proved by fractions.

namespace phrame::inline v0 {
namespace {

using Complex = std::complex<double>;

Complex approximate(const GaussianRational& z) {
  return {static_cast<double>(z.re), static_cast<double>(z.im)};
}

/// The least and the greatest of the coordinates differ by no more.
Rational size_of(const Path& path) {
  Rational size = 0;
  Vector<Rational> first = point(*rational_curve(path.segments().front()), 0);
  for (const Segment& segment : path.segments()) {
    const RationalCurve& curve = *rational_curve(segment);
    for (const Rational& t : {Rational(1, 3), Rational(2, 3), Rational(1)})
      size = std::max(size, largest(point(curve, t) - first));
  }
  return 2 * size;
}

/// What stands for a segment.
struct Piece {
  Curve curve;              ///< from any start
  Vector<Rational> change;  ///< from its start to its end
  bool is_exact;            ///< is it the segment itself?
};

/// A segment of the path, in doubles' range.
struct Given {
  Segment segment;
  const RationalCurve& curve;
  bool is_ph;
  bool is_line;
  Vector<Polynomial> numerator = {};  ///< of one that is replaced

  /// Along r′ at the start and at the end, and, of others, inside.
  Vector<Rational> tangent(const Rational& t) const {
    Vector<Rational> H{curve.direction()[0](t), curve.direction()[1](t), 0};
    const int sign = t == 0   ? orientation(segment)
                     : t == 1 ? end_orientation(segment)
                              : curve.multiplier()(t).sign();
    return sign < 0 ? Rational(-1) * H : H;
  }
  double speed(const Rational& t) const {
    const Rational W = curve.weight()(t);
    const Rational factor = abs(curve.multiplier()(t)) / (W * W);
    const Vector<Rational> v = factor * tangent(t);
    return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]));
  }
};

/// Is it a line on which the curve does not turn back, as far as Bernstein coefficients tell?
bool is_line_one_way(const RationalCurve& curve, int orientation) {
  if (std::max(curve.direction()[0].degree(), curve.direction()[1].degree()) > 0) return false;
  const auto speed = to_bernstein(curve.multiplier(), std::max(curve.multiplier().degree(), 0L));
  return std::ranges::all_of(speed, [&](const Rational& x) { return orientation * x.sign() >= 0; });
}

class PlanePath {
 public:
  PlanePath(const Path& path, const Rational& epsilon)
      : path_(path), epsilon_(epsilon), square_(epsilon * epsilon) {
    for (std::size_t k = 0; k < path.segments().size(); ++k) add_given(k);
    const Rational size = size_of(path);
    const double share = std::log2(static_cast<double>(Rational(size / epsilon)));
    places_ = std::clamp(static_cast<long>(std::ceil(share)) + 16, 20L, 50L);
    scale_ = std::lround(std::log2(static_cast<double>(size)) / 2);
    is_closed_ = path.ends_meet();
  }

  NearPath make() {
    start_ = point(given_.front().curve, 0);
    at_ = start_;
    Stage stage("segments", given_.size());
    for (std::size_t k = 0; k < given_.size(); ++k, stage.advance()) add(k);
    if (is_closed_) close();
    return joined_pieces();
  }

 private:
  void add_given(std::size_t k) {
    const Segment& segment = path_.segments()[k];
    const RationalCurve* curve = rational_curve(segment);
    if (curve == nullptr) throw DomainError(fmt::format("segment {} is given by formulas", k + 1));
    if (!curve->direction()[2].is_zero())
      throw DomainError(fmt::format("segment {} is not in a plane z = const", k + 1));
    const bool is_ph = ph_curve(segment) != nullptr;
    const bool is_line = is_line_one_way(*curve, orientation(segment));
    given_.push_back({segment, *curve, is_ph, is_line});
    if (!is_ph) given_.back().numerator = curve->numerator();
  }

  // ---- Tangents.

  /// z with z² along v: exactly the same for all vectors along v.
  GaussianRational root_along(const Vector<Rational>& v) const {
    const Vector<Rational> unit = Rational(1 / largest(v)) * v;
    const Complex z =
        std::sqrt(Complex(static_cast<double>(unit[0]), static_cast<double>(unit[1])));
    return rounded(z, places_);
  }

  static GaussianRational rounded(const Complex& z, long places) {
    return {rounded_to_places(exact_rational(z.real()), places),
            rounded_to_places(exact_rational(z.imag()), places)};
  }

  /// z with z² along the tangent of a PH curve there.
  static GaussianRational root_of(const Given& given, const Rational& t) {
    const ComplexForm form = complex_form(*ph_curve(given.segment)).value();
    const Polynomial common = gcd(form.root.re, form.root.im);
    const GaussianRational z{exact_quotient(form.root.re, common)(t),
                             exact_quotient(form.root.im, common)(t)};
    const GaussianRational square = z * z;
    const Vector<Rational> v = given.tangent(t);
    if ((square.re * v[0] + square.im * v[1]).sign() > 0) return z;
    return z * GaussianRational{0, 1};
  }

  /// Has the tangent no corner between the two, or one that is taken for a rounding?
  static bool is_smooth(const Given& before, const Given& after) {
    const Vector<Rational> a = before.tangent(1);
    const Vector<Rational> b = after.tangent(0);
    const Rational sine = squared_sine(a, b);
    const auto is_fixed = [](const Given& x) { return x.is_ph || x.is_line; };
    if (is_fixed(before) && is_fixed(after)) return sine == 0;
    const Rational rounding(1, 1'000'000);
    return sine < rounding;
  }

  /// The segment before k or behind it, with which it is smooth.
  const Given* neighbour(std::size_t k, bool is_behind) const {
    const std::size_t n = given_.size();
    if (!is_closed_ && k == (is_behind ? n - 1 : 0)) return nullptr;
    const Given& other = given_[is_behind ? (k + 1) % n : (k + n - 1) % n];
    const bool is_one = is_behind ? is_smooth(given_[k], other) : is_smooth(other, given_[k]);
    return is_one ? &other : nullptr;
  }

  /// z with z² along the tangent at an end of segment k, which is not PH, as its neighbour has it.
  GaussianRational root_at(std::size_t k, bool is_end) const {
    const Given& own = given_[k];
    const Given* other = neighbour(k, is_end);
    if (other != nullptr && other->is_ph) return root_of(*other, is_end ? 0 : 1);
    if (own.is_line || other == nullptr) return root_along(own.tangent(is_end ? 1 : 0));
    if (other->is_line) return root_along(other->tangent(0));
    return root_along(is_end ? own.tangent(1) : other->tangent(1));
  }

  // ---- Segments.

  void add(std::size_t k) {
    const Given& given = given_[k];
    if (given.is_ph) {
      const Curve& curve = *ph_curve(given.segment);
      const Vector<Rational> change = point(given.curve, 1) - point(given.curve, 0);
      const Rational moved = largest(at_ - point(given.curve, 0));
      distance_ = std::max(distance_, Rational(2 * moved * moved));
      keep({curve, change, true});
    } else if (given.is_line) {
      add_line(k);
    } else {
      add_quintics(k, 0, 1, root_at(k, false), root_at(k, true), 0);
    }
  }

  void keep(Piece piece) {
    at_ = at_ + piece.change;
    pieces_.push_back(std::move(piece));
  }

  void add_line(std::size_t k) {
    const Given& given = given_[k];
    const Vector<Rational> way = point(given.curve, 1) - at_;
    const bool is_free = neighbour(k, false) == nullptr && neighbour(k, true) == nullptr;
    const GaussianRational z = is_free ? root_along(way) : root_at(k, false);
    const GaussianRational along = z * z;
    const Rational square = along.re * along.re + along.im * along.im;
    const Rational share = (way[0] * along.re + way[1] * along.im) / square;
    const Rational length = rounded_to_places(share, places_ - 2 * scale_);
    if (!(length > 0)) fail(k);
    const Vector<Rational> change{length * along.re, length * along.im, 0};
    const Vector<Rational> at_start = at_ - point(given.curve, 0);
    const Vector<Rational> at_end = at_ + change - point(given.curve, 1);
    const Rational off = std::max(dot(at_start, at_start), dot(at_end, at_end));
    if (off > square_) fail(k);
    distance_ = std::max(distance_, off);
    const GaussianPolynomial w{Polynomial{z.re}, Polynomial{z.im}};
    keep({Curve(from_complex_root(w), Polynomial{length}), change, false});
  }

  /// Quintics for the part [a, b] of segment k, with these roots of the tangents at its ends.
  void add_quintics(std::size_t k, const Rational& a, const Rational& b, const GaussianRational& za,
                    const GaussianRational& zb, int depth) {
    constexpr int most_halvings = 48;
    if (depth > most_halvings || pieces_.size() > most_pieces) fail(k);
    if (auto piece = quintic(given_[k], a, b, za, zb)) {
      keep(*std::move(piece));
      return;
    }
    const Rational middle = (a + b) / 2;
    // At a cusp the tangent is that of either side.
    const GaussianRational z = root_along(given_[k].tangent(middle));
    add_quintics(k, a, middle, za, z, depth + 1);
    add_quintics(k, middle, b, z, zb, depth + 1);
  }

  std::optional<Piece> quintic(const Given& given, const Rational& a, const Rational& b,
                               const GaussianRational& za, const GaussianRational& zb) {
    const Vector<Rational> way = point(given.curve, b) - at_;
    const Complex D(static_cast<double>(way[0]), static_cast<double>(way[1]));
    const double chord = std::abs(D);
    if (chord == 0) return std::nullopt;
    const auto h = static_cast<double>(Rational(b - a));
    // Where the speed has a zero the parameter is another one.
    const auto end = [&](const GaussianRational& z, const Rational& t, bool is_opposite) {
      const double speed = std::clamp(h * given.speed(t), chord / 4, chord * 4);
      const Rational size = rounded_to_places(
          exact_rational(std::sqrt(speed) / std::abs(approximate(z))), places_ - scale_);
      return GaussianRational{is_opposite ? -size : size, 0} * z;
    };
    const GaussianRational w0 = end(za, a, false);
    const bool is_opposite = (std::conj(approximate(za)) * approximate(zb)).real() < 0;
    const GaussianRational w2 = end(zb, b, is_opposite);
    const Complex p = approximate(w0);
    const Complex q = approximate(w2);
    // (4w₁ + 3(w₀ + w₂))² = 120·D − 15(w₀² + w₂²) + 10·w₀w₂
    const Complex root = std::sqrt(120.0 * D - 15.0 * (p * p + q * q) + 10.0 * p * q);
    const Complex sum = 3.0 * (p + q);
    const Complex wanted = (p + q) / 2.0;
    Complex w1 = (root - sum) / 4.0;
    if (const Complex other = (-root - sum) / 4.0; std::abs(other - wanted) < std::abs(w1 - wanted))
      w1 = other;
    const GaussianRational middle = rounded(w1, places_ - scale_);
    const GaussianPolynomial w{from_bernstein({w0.re, middle.re, w2.re}),
                               from_bernstein({w0.im, middle.im, w2.im})};
    const GaussianPolynomial hodograph = w * w;
    const Polynomial x = antiderivative(hodograph.re);
    const Polynomial y = antiderivative(hodograph.im);
    if (!is_near(given, a, b, x, y)) return std::nullopt;
    return Piece{Curve(from_complex_root(w)), {x(1), y(1), 0}, false};
  }

  /// Is at + (x, y) near the part? |X − W·(at + (x, y))|/W by Bernstein coefficients.
  bool is_near(const Given& given, const Rational& a, const Rational& b, const Polynomial& x,
               const Polynomial& y) {
    const Polynomial part{a, b - a};
    const Polynomial W = compose(given.curve.weight(), part);
    const std::array<Polynomial, 2> off{
        compose(given.numerator[0], part) - W * (x + Polynomial{at_[0]}),
        compose(given.numerator[1], part) - W * (y + Polynomial{at_[1]})};
    const long n = std::max({off[0].degree(), off[1].degree(), 1L});
    const auto weights = to_bernstein(W, std::max(W.degree(), 0L));
    const Rational least = *std::min_element(weights.begin(), weights.end());
    if (!(least > 0)) return false;
    const auto dx = to_bernstein(off[0], n);
    const auto dy = to_bernstein(off[1], n);
    Rational greatest = 0;
    for (std::size_t k = 0; k < dx.size(); ++k)
      greatest = std::max(greatest, Rational(dx[k] * dx[k] + dy[k] * dy[k]));
    const Rational square = greatest / (least * least);
    // Room for what closes the path.
    if (square > Rational(225, 256) * square_) return false;
    distance_ = std::max(distance_, square);
    return true;
  }

  // ---- The whole.

  /// Lengthens two segments, those that are replaced first, so that the end is the start.
  void close() {
    const Vector<Rational> gap = start_ - at_;
    if (gap == Vector<Rational>{}) return;
    const auto cross = [](const Vector<Rational>& a, const Vector<Rational>& b) {
      return Rational(a[0] * b[1] - a[1] * b[0]);
    };
    const auto better = [&](const Piece& x, const Piece& y) {
      return std::pair(!x.is_exact, largest(x.change)) < std::pair(!y.is_exact, largest(y.change));
    };
    Piece& first = *std::max_element(pieces_.begin(), pieces_.end(), better);
    Piece* second = nullptr;
    Rational best = 0;
    for (Piece& piece : pieces_)
      if (const Rational area = abs(cross(first.change, piece.change));
          area > best && (second == nullptr || !piece.is_exact || second->is_exact)) {
        second = &piece;
        best = area;
      }
    if (second == nullptr) return;  // it goes there and back
    const Rational det = cross(first.change, second->change);
    const Rational more = cross(gap, second->change) / det;
    const Rational more_of_second = cross(first.change, gap) / det;
    const Rational moved =
        abs(more) * largest(first.change) + abs(more_of_second) * largest(second->change);
    lengthen(first, 1 + more);
    lengthen(*second, 1 + more_of_second);
    // |a + b|² for |a|² = distance and |b| ≤ 2·moved.
    const Rational root = square_root_above(distance_) + 2 * moved;
    distance_ = root * root;
  }

  static void lengthen(Piece& piece, const Rational& factor) {
    if (!(factor > 0)) throw Undecided("PH path nearby: it does not close");
    piece.change = factor * piece.change;
    piece.curve = scaled(piece.curve, factor);
  }

  NearPath joined_pieces() {
    std::vector<Curve> curves;
    Vector<Rational> start = start_;
    for (const Piece& piece : pieces_) {
      curves.push_back(translated(piece.curve, start - piece.curve.start()));
      start = start + piece.change;
    }
    if (distance_ > square_) throw Undecided("PH path nearby: it does not close within that");
    const Rational distance = std::min(square_root_above(distance_), epsilon_);
    return {joined(curves), {distance, distance, places_, std::nullopt, epsilon_}};
  }

  [[noreturn]] static void fail(std::size_t k) {
    throw Undecided(fmt::format("segment {}: no PH curves were found that are near enough", k + 1));
  }

  static constexpr std::size_t most_pieces = 200'000;

  const Path& path_;
  Rational epsilon_;
  Rational square_;  ///< of ε
  std::vector<Given> given_;
  long places_;  ///< w is rounded to multiples of 2^(scale − places)
  long scale_;   ///< the size is about 4^scale
  bool is_closed_;
  Vector<Rational> start_{};
  Vector<Rational> at_{};  ///< where what is made ends
  std::vector<Piece> pieces_;
  Rational distance_ = 0;  ///< the greatest, squared
};

}  // namespace

NearPath near_plane_path(const Path& path, const Rational& epsilon) {
  if (!(epsilon > 0)) throw DomainError("PH path nearby: epsilon is not positive");
  return PlanePath(path, epsilon).make();
}

NamedPhPath near_ph_path(const NamedPath& named, const Rational& epsilon) {
  try {
    auto found = near_path(named, epsilon);
    if (auto* path = std::get_if<NamedPhPath>(&found)) return std::move(*path);
  } catch (const DomainError&) {  // it has corners, or is not polynomial
  }
  NearPath near = near_plane_path(named.path, epsilon);
  return {named.name, std::move(near.path), std::move(near.nearness)};
}

}  // namespace phrame
