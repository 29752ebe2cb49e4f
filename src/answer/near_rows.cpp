#include "phrame/answer/near_rows.hpp"

#include <algorithm>
#include <tuple>

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

/// Rows that a piece along this segment pays for, where it is one of few.
long rows_of_few(const Segment& segment) {
  const Curve* curve = ph_curve(segment);
  return curve != nullptr ? rows_in(24 + 2 * preimage_degree(*curve), *curve) + 1 : 16;
}

/// The same for a path of at least three segments, if in all of them the frame turns as little as
/// in three, and a piece pays for so many rows; no number where these are not compiled.
std::optional<long> many_as_in_three(const PathAngle& angle, long (*rows_of_one)(const Segment&)) {
  const auto& segments = angle.path().segments();
  const std::size_t n = segments.size();
  long pieces = 0;
  long rows = 0;
  for (const std::size_t k : {n / 6, n / 2, n - 1 - n / 6}) {
    const auto rotation =
        where_compiled([&] { return compiled_rotation(angle, k, {}, compensated_shape(4)); });
    if (!rotation) return std::nullopt;
    pieces += static_cast<long>(rotation->pieces().size());
    rows = std::max(rows, rows_of_one(segments[k]));
  }
  return static_cast<long>(n) * pieces * rows / 3;
}

constexpr std::size_t many_segments = 16;

/// Beside rows by NearRotations, of some microseconds, a random curve is compiled for so many, and
/// one piece for so many.
long rows_of_near_segment(const Segment& segment) {
  return 2500 + 250 * preimage_degree(*ph_curve(segment));
}
long rows_of_near_piece(const Segment&) { return 200; }

/// Does it pay to compile the path for so many rows, if they may be by NearRotations?
bool are_many_near_rows(std::size_t rows, const PathAngle& angle) {
  const Path& path = angle.path();
  const auto number = static_cast<long>(rows);
  const std::size_t segments = path.segments().size();
  if (number >= sum_over(path, rows_of_near_segment)) return true;
  if (segments < many_segments || number < sum_over(path, rows_of_near_piece)) return false;
  const auto many = many_as_in_three(angle, rows_of_near_piece);
  return many && number >= *many;
}

}  // namespace

bool are_many_rows(std::size_t rows, const Path& path, bool is_by_length,
                   const std::function<PathAngle()>& angle) {
  const auto number = static_cast<long>(rows);
  if (number >= usually_many(path, is_by_length)) return true;
  const std::size_t segments = path.segments().size();
  if (segments < many_segments || rows < segments) return false;
  const auto many = many_as_in_three(angle(), rows_of_few);
  return many && (is_by_length ? 3 * number : number) >= *many;
}

NearRows::NearRows(const PathAngle& angle, const TableColumns& columns, const StartAngle& start,
                   const RowPlaces& places)
    : columns_(columns), places_(places), orientations_(columns) {
  const Path& path = angle.path();
  const bool is_by_length = places.is_by_length();
  if (columns.digits > 0 || !columns.roll.is_zero() || angle.reference() == Reference::frenet)
    return;
  const std::size_t rows = places.size();
  const bool have_rotations =
      !is_by_length && has_frame(columns, TabulatedFrame::rmf) && has_near_rotations(angle);
  const bool are_many = have_rotations ? are_many_near_rows(rows, angle)
                        : is_by_length || are_of_rmf(columns)
                            ? are_many_rows(rows, path, is_by_length, [&] { return angle; })
                            : static_cast<long>(rows) >= sum_over(path, rows_of_piece);
  to_ = static_cast<double>(path.segments().size());
  if (are_many)
    compile(angle, start);
  else if (have_rotations)
    prepare_few(angle, start);
  has_rows_ = points_ && (frames_ || rotations_) && are_of_rmf(columns) && are_lengths(columns) &&
              (columns.scalars.empty() || length_) && !columns.have_quaternions;
}

void NearRows::compile(const PathAngle& angle, const StartAngle& start) {
  const Path& path = angle.path();
  const bool has_length = !columns_.scalars.empty() && are_lengths(columns_);
  if (places_.is_by_length() || has_length)
    length_ = where_compiled([&] { return CompiledLength(path); });
  if (places_.is_by_length() && !length_) return;
  if (goes_on(path) && start.exact && angle.reference() == Reference::euler_rodrigues) {
    if (!places_.is_by_length()) std::tie(from_, to_) = bounds_of(places_);
    if (!(from_ < to_)) return;
    const Curve& curve = *ph_curve(path.segments().front());
    points_ = where_compiled([&] { return CompiledPoints(curve, from_, to_); });
    frames_ = where_compiled(
        [&] { return CompiledFrames(curve, *angle.closed_form(0), from_, to_, *start.exact); });
  } else {
    points_ = where_compiled([&] { return CompiledPoints(path); });
    frames_ = where_compiled([&] { return CompiledFrames(angle, start); });
  }
}

/// To compile the points of a segment takes as long as some rows of exact ones.
void NearRows::prepare_few(const PathAngle& angle, const StartAngle& start) {
  constexpr std::size_t many = 8;
  rotations_.emplace(angle, start);
  const Path& path = angle.path();
  if (places_.size() < many * path.segments().size()) return;
  if (goes_on(path)) {
    std::tie(from_, to_) = bounds_of(places_);
    if (!(from_ < to_)) return;
    points_ = where_compiled(
        [&] { return CompiledPoints(*ph_curve(path.segments().front()), from_, to_); });
  } else {
    points_ = where_compiled([&] { return CompiledPoints(path); });
  }
  if (!columns_.scalars.empty() && are_lengths(columns_))
    length_ = where_compiled([&] { return CompiledLength(path); });
}

std::optional<NearNumber> NearRows::parameter(std::size_t k) const {
  if (!points_ && !frames_ && !rotations_) return std::nullopt;
  const auto number = places_.number(k);
  if (!number) return std::nullopt;
  return places_.is_by_length() ? length_->parameter(*number) : number;
}

std::optional<Vector<double>> NearRows::position(const NearNumber& t) const {
  return points_ ? points_->rounded(t) : std::nullopt;
}

// Exact fractions along a path with rational frames are products of those of all segments before:
// balls go first also where doubles do not tell, and what is left are numbers such as 0 and ±1.
std::optional<Frame<double>> NearRows::frame(const NearNumber& t, const Place& at) const {
  if (frames_) return frames_->rounded(t);
  if (!rotations_) return std::nullopt;
  const auto near = rotations_->frame(t);
  return near ? near : rotations_->by_balls(at);
}

/// The numbers of some rows, column by column.
struct NearRows::Columns {
  std::vector<double> t;
  Vector<std::vector<double>> r;
  std::vector<Frame<double>> rmf;
  std::vector<double> s;      ///< where there is a column of it
  std::vector<bool> is_told;  ///< of each row

  Columns(std::size_t count, bool may_be_told)
      : t(count), rmf(count), is_told(count, may_be_told) {}
  void leave_out(const std::vector<std::size_t>& untold) {
    for (const std::size_t k : untold) is_told[k] = false;
  }
  void set(std::vector<double>& column, std::size_t k, const std::optional<double>& x) {
    if (x)
      column[k] = *x;
    else
      is_told[k] = false;
  }
};

NearRows::Columns NearRows::made(std::size_t first, std::size_t count) const {
  Columns columns(count, has_rows_);
  if (!has_rows_) return columns;
  const RoundingToNearest mode;
  NearNumbers near(count, from_);
  if (!columns_.scalars.empty()) columns.s.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = places_.number(first + k);
    if (number && places_.is_by_length() && !columns.s.empty())
      columns.set(columns.s, k, common_double(*number));
    const auto t = number && places_.is_by_length() ? length_->parameter(*number) : number;
    const bool is_inside = t && from_ <= t->value.high && t->value.high <= to_;
    columns.set(columns.t, k, is_inside ? common_double(*t) : std::nullopt);
    if (is_inside) near.set(k, *t);
  }
  columns.leave_out(points_->rounded(near, columns.r));
  if (frames_)
    columns.leave_out(frames_->rounded(near, columns.rmf));
  else
    columns.leave_out(rotations_->frames(near, columns.rmf));
  if (!columns.s.empty() && !places_.is_by_length())
    columns.leave_out(length_->rounded(near, columns.s));
  return columns;
}

std::vector<std::size_t> NearRows::untold(std::size_t first, std::size_t count) const {
  std::vector<std::size_t> numbers;
  const Columns columns = made(first, count);
  for (std::size_t k = 0; k < count; ++k)
    if (!columns.is_told[k]) numbers.push_back(first + k);
  return numbers;
}

std::vector<std::size_t> NearRows::make(std::size_t first,
                                        std::span<std::vector<double>> rows) const {
  std::vector<std::size_t> untold;
  const Columns columns = made(first, rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!columns.is_told[k]) {
      untold.push_back(first + k);
      continue;
    }
    std::vector<double>& row = rows[k];
    const Frame<double>& rmf = columns.rmf[k];
    row.assign({columns.t[k], columns.r[0][k], columns.r[1][k], columns.r[2][k], rmf.e1[0],
                rmf.e1[1], rmf.e1[2]});
    for (std::size_t n = 0; n < columns_.frames.size(); ++n) orientations_.add(row, rmf);
    row.insert(row.end(), columns_.scalars.size(), columns.s.empty() ? 0 : columns.s[k]);
  }
  return untold;
}

}  // namespace phrame
