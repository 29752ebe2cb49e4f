#include "phrame/answer/near_rows.hpp"

#include <algorithm>

#include "phrame/algebra/real.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/compiled_rotation.hpp"

namespace phrame::inline v0 {
namespace {

/// The least and the greatest of the numbers, as doubles.
std::pair<double, double> bounds_of(const RowPlaces& places) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto number = places.number(k);
    if (!number) continue;
    least = std::min(least, number->value.high);
    greatest = std::max(greatest, number->value.high);
  }
  return {least, greatest};
}

bool are_of_rmf(const TableColumns& columns) {
  const auto is_rmf = [](TabulatedFrame frame) { return frame == TabulatedFrame::rmf; };
  return std::all_of(columns.frames.begin(), columns.frames.end(), is_rmf);
}

bool are_lengths(const TableColumns& columns) {
  const auto is_length = [](TabulatedScalar kind) { return kind == TabulatedScalar::arc_length; };
  return std::all_of(columns.scalars.begin(), columns.scalars.end(), is_length);
}

/// Of the coefficients of the preimage, at most.
long bits_of(const Curve& curve) {
  long most = 0;
  const QuaternionPolynomial& a = curve.preimage();
  for (const Polynomial* p : {&a.u, &a.v, &a.p, &a.q})
    for (const Rational& c : p->coefficients()) most = std::max(most, phrame::bits_of(c));
  return most;
}

/// A row takes some ten microseconds, a piece as long as five to a hundred of them.
long rows_of_piece(const Segment& segment) {
  const Curve* curve = ph_curve(segment);
  return curve == nullptr ? 300 : 300 + 20 * preimage_degree(*curve);
}

/// With rotation-minimizing frames of PH curves by long fractions a row takes up to ten times as
/// long, and a piece no more.
long rows_in(long of_short_fractions, const Curve& curve) {
  constexpr long most = 8;
  return of_short_fractions / std::min(most, 1 + bits_of(curve) / 16);
}

long rows_of_rmf_piece(const Segment& segment) {
  const Curve* curve = ph_curve(segment);
  const long rows = rows_of_piece(segment);
  return curve == nullptr ? rows : rows_in(rows, *curve);
}

long sum_over(const Path& path, long (*of)(const Segment&)) {
  long sum = 0;
  for (const Segment& segment : path.segments()) sum += of(segment);
  return sum;
}

/// From so many rows on it pays to compile a path.
long usually_many(const Path& path, bool is_by_length) {
  // By arc length t is the root of a polynomial.
  return is_by_length ? sum_over(path, rows_of_piece) / 8 : sum_over(path, rows_of_rmf_piece);
}

/// The same for a path of at least three segments, if in all of them the frame turns as little as
/// in three; no number where these are not compiled.
std::optional<long> many_as_in_three(const PathAngle& angle, bool is_by_length) {
  const auto& segments = angle.path().segments();
  const std::size_t n = segments.size();
  long pieces = 0;
  long rows_of_one = 0;
  for (const std::size_t k : {n / 6, n / 2, n - 1 - n / 6}) {
    const auto rotation =
        where_compiled([&] { return compiled_rotation(angle, k, {}, compensated_shape(4)); });
    if (!rotation) return std::nullopt;
    pieces += static_cast<long>(rotation->pieces().size());
    const Curve* curve = ph_curve(segments[k]);
    const long rows_here = curve ? rows_in(24 + 2 * preimage_degree(*curve), *curve) + 1 : 16;
    rows_of_one = std::max(rows_of_one, rows_here);
  }
  return static_cast<long>(n) * pieces * rows_of_one / (is_by_length ? 9 : 3);
}

}  // namespace

bool are_many_rows(std::size_t rows, const PathAngle& angle, bool is_by_length) {
  constexpr std::size_t many_segments = 16;
  const auto number = static_cast<long>(rows);
  if (number >= usually_many(angle.path(), is_by_length)) return true;
  const std::size_t segments = angle.path().segments().size();
  if (segments < many_segments || rows < segments || angle.reference() == Reference::frenet)
    return false;
  const auto many = many_as_in_three(angle, is_by_length);
  return many && number >= *many;
}

NearRows::NearRows(const PathAngle& angle, const TableColumns& columns, const StartAngle& start,
                   const RowPlaces& places)
    : columns_(columns), places_(places), orientations_(columns) {
  const Path& path = angle.path();
  const bool is_by_length = places.is_by_length();
  if (columns.digits > 0 || !columns.roll.is_zero() || angle.reference() == Reference::frenet)
    return;
  const std::size_t rows = places.size();
  if (is_by_length || are_of_rmf(columns) ? !are_many_rows(rows, angle, is_by_length)
                                          : static_cast<long>(rows) < sum_over(path, rows_of_piece))
    return;
  const bool has_length = !columns.scalars.empty() && are_lengths(columns);
  if (places.is_by_length() || has_length)
    length_ = where_compiled([&] { return CompiledLength(path); });
  if (places.is_by_length() && !length_) return;
  const auto [from, to] =
      goes_on(path) && !places.is_by_length() ? bounds_of(places) : std::pair(0.0, 1.0);
  if (goes_on(path) && start.exact && angle.reference() == Reference::euler_rodrigues) {
    if (!(from < to)) return;
    const Curve& curve = *ph_curve(path.segments().front());
    points_ =
        where_compiled([&, least = from, most = to] { return CompiledPoints(curve, least, most); });
    frames_ = where_compiled([&, least = from, most = to] {
      return CompiledFrames(curve, *angle.closed_form(0), least, most, *start.exact);
    });
  } else {
    points_ = where_compiled([&] { return CompiledPoints(path); });
    frames_ = where_compiled([&] { return CompiledFrames(angle, start); });
  }
  has_rows_ = points_ && frames_ && are_of_rmf(columns) && are_lengths(columns) &&
              (columns.scalars.empty() || length_) && !columns.have_quaternions;
}

std::optional<NearNumber> NearRows::parameter(std::size_t k) const {
  if (!points_ && !frames_) return std::nullopt;
  const auto number = places_.number(k);
  if (!number) return std::nullopt;
  return places_.is_by_length() ? length_->parameter(*number) : number;
}

std::optional<Vector<double>> NearRows::position(const NearNumber& t) const {
  return points_ ? points_->rounded(t) : std::nullopt;
}

std::optional<Frame<double>> NearRows::frame(const NearNumber& t) const {
  return frames_ ? frames_->rounded(t) : std::nullopt;
}

bool NearRows::at(std::size_t k, std::vector<double>& row) const {
  return rounding_to_nearest([&] { return has_made(k, row); });
}

bool NearRows::has_made(std::size_t k, std::vector<double>& row) const {
  row.clear();
  const auto t = has_rows_ ? parameter(k) : std::nullopt;
  const auto shown = t ? common_double(*t) : std::nullopt;
  const auto r = shown ? position(*t) : std::nullopt;
  const auto rmf = r ? frame(*t) : std::nullopt;
  if (!rmf) return false;
  row.push_back(*shown);
  row.insert(row.end(), r->begin(), r->end());
  row.insert(row.end(), rmf->e1.begin(), rmf->e1.end());
  for (std::size_t n = 0; n < columns_.frames.size(); ++n) orientations_.add(row, *rmf);
  for (std::size_t n = 0; n < columns_.scalars.size(); ++n) {
    const auto s = places_.is_by_length() ? places_.number(k) : length_->value(*t);
    const auto rounded = s ? common_double(*s) : std::nullopt;
    if (!rounded) return false;
    row.push_back(*rounded);
  }
  return true;
}

}  // namespace phrame
