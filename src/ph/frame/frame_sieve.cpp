#include "phrame/ph/frame/frame_sieve.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/compiled_rotation.hpp"

// With the vectors (T, F₂, F₃) of a rotation-minimizing frame, compiled, f₂ is at the angle
//   arg(x + iy),  x = f₂·F₂, y = f₂·F₃,
// and at arg((x + iy)(x₀ − iy₀)) against the first frame. That grows with its tangent, as long as
// it is less than π/2 in size, and changes by less than that does.

namespace phrame::inline v0 {
namespace {

/// Is it > 0 on [0, 1]?
bool is_positive_on(const Polynomial& p) {
  return p(0) > 0 && (p.is_constant() || count_real_roots(p, closed_interval(0, 1)) == 0);
}

/// Is e₁ the tangent T everywhere?
bool has_forward_tangents(const Path& path) {
  return std::all_of(path.segments().begin(), path.segments().end(), [](const Segment& segment) {
    if (const Curve* ph = ph_curve(segment)) return is_positive_on(ph->multiplier());
    if (const auto* curve = std::get_if<ExpressionCurve>(&segment)) return curve->orientation() > 0;
    return is_positive_on(std::get<RationalCurve>(segment).multiplier());
  });
}

PiecewisePolynomial compiled(const PathAngle& angle) {
  if (!has_forward_tangents(angle.path()))
    throw DomainError("frames by their greatest errors: the curve turns back");
  return compiled_rotation(angle, {}, compensated_shape(4));
}

Vector<NearNumber> all_within(const Vector<DoubleDouble>& v, double error) {
  return {within(v[0], error), within(v[1], error), within(v[2], error)};
}

/// Of the angle between vectors of these lengths, from their inner product.
NearBounds cosine(const NearNumber& inner_product, const NearBounds& lengths) {
  return quotient(size_bounds(inner_product), lengths);
}

/// | |f| − 1 | = ||f|² − 1|/(|f| + 1)
NearBounds off_unit(const NearNumber& square) {
  const NearBounds size = root(size_bounds(square));
  return quotient(size_bounds(square - NearNumber{{1, 0}, 0}), {1 + size.lower, 1 + size.upper});
}

/// Not 0, and not so small or large that anything would be lost.
bool is_of_usual_length(const NearNumber& square) {
  return square.value.high > 0x1p-100 && square.value.high < 0x1p100;
}

/// Of the angle between a and b, |b| = 1.
NearBounds sine(const Vector<NearNumber>& a, const Vector<NearNumber>& b,
                const NearNumber& square_of_a) {
  const Vector<NearNumber> c = cross(a, b);
  return root(quotient(size_bounds(dot(c, c)), size_bounds(square_of_a)));
}

Vector<double> approximately(const Vector<NearNumber>& v) {
  return {v[0].value.high, v[1].value.high, v[2].value.high};
}

Vector<double> unit(const Vector<double>& v) { return 1 / std::sqrt(dot(v, v)) * v; }

constexpr double most_tangent = 11;  // of an angle of 1.48

}  // namespace

FrameSieve::FrameSieve(const PathAngle& angle, const FrameCheckOptions& options, bool is_by_length)
    : path_(angle.path()), rotation_(compiled(angle)) {
  const auto tolerance = static_cast<double>(options.tolerance);
  constexpr double tiny = 0x1p-900;  // below, what is rounded might be too great or too small
  tolerance_ = {tolerance < tiny ? 0 : tolerance * (1 - 0x1p-50),
                std::max(tolerance * (1 + 0x1p-50), tiny)};
  if (is_by_length) length_.emplace(path_);
  for (std::size_t k = 1; k < path_.segments().size(); ++k)
    has_corners_ = has_corners_ || path_.has_corner(k);
}

void FrameSieve::Greatest::offer(const Row& row, const Bounds& x) {
  if (x.upper < least_) return;
  least_ = std::max(least_, x.lower);
  rows_.emplace_back(row, x.upper);
  if (is_full()) std::erase_if(rows_, [&](const auto& at) { return at.second < least_; });
}

void FrameSieve::Greatest::add_to(std::vector<Row>& rows) const {
  for (const auto& [row, upper] : rows_)
    if (upper >= least_) rows.push_back(row);
}

void FrameSieve::Waypoints::offer(const Row& row, double angle) {
  constexpr std::size_t most = 64;
  if (!rows_.empty() && !(std::abs(angle - rows_.back().second) >= gap_)) return;
  rows_.emplace_back(row, angle);
  if (rows_.size() < most) return;
  const auto [least, greatest] = std::minmax_element(
      rows_.begin(), rows_.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  gap_ = std::max(2 * gap_, (greatest->second - least->second) / (most / 2));
  const auto before = std::move(rows_);
  rows_.clear();
  for (const auto& [at, its_angle] : before)
    if (rows_.empty() || std::abs(its_angle - rows_.back().second) >= gap_)
      rows_.emplace_back(at, its_angle);
}

void FrameSieve::Waypoints::add_to(std::vector<Row>& rows) const {
  for (const auto& [row, angle] : rows_) rows.push_back(row);
}

/// Not before the last one, for certain?
bool FrameSieve::follows(const NearNumber& t) const {
  if (count_ == 0) return true;
  const NearNumber way = t - t_;
  const bool is_same = t.error == 0 && t_.error == 0 && way.value.high == 0;
  return is_same || is_positive(way);
}

/// No value where it is not told, or which side of a corner it is on.
std::optional<NearNumber> FrameSieve::parameter(const NearNumber& number) const {
  const bool is_start = number.value.high == 0;
  const auto t = length_ && !is_start ? length_->parameter(number) : std::optional(number);
  if (!t || !has_corners_) return t;
  const double joint = std::nearbyint(t->value.high);
  const bool is_inside = 0 < joint && joint < rotation_.to();
  if (is_inside && std::abs(t->value.high - joint) < 0x1p-20 &&
      path_.has_corner(static_cast<std::size_t>(joint)))
    return std::nullopt;
  return t;
}

/// Of arg(x + iy), |arg| < π/2; of others there are no bounds.
FrameSieve::Bounds FrameSieve::tangent_of(const NearNumber& x, const NearNumber& y) {
  if (!is_positive(x)) return {-HUGE_VAL, HUGE_VAL};
  const NearBounds size = quotient(size_bounds(y), size_bounds(x));
  if (size.lower == 0) return {-size.upper, size.upper};
  return y.value.high > 0 ? Bounds{size.lower, size.upper} : Bounds{-size.upper, -size.lower};
}

/// As guessed_up_vectors() has it, but for the last digits.
std::array<double, 2> FrameSieve::turned(const Vector<NearNumber>& tangent,
                                         const Vector<NearNumber>& f2) {
  const Vector<double> e1 = approximately(tangent);
  const Vector<double> f = unit(approximately(f2));
  const Vector<double> normal = unit(f - dot(f, e1) * e1);
  const std::array<Vector<double>, 2> normals{normal, cross(e1, normal)};
  if (count_ == 0) first_normals_ = normals;
  std::array<double, 2> result{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Vector<double> c = cross(first_normals_[k], normals[k]);
    result[k] = dot(c, c);
  }
  return result;
}

std::optional<FrameSieve::Deviation> FrameSieve::deviation(const NearFrame& frame) {
  const auto t = parameter(frame.t);
  const auto near = t ? near_values<4>(rotation_, *t) : std::nullopt;
  if (!near) return std::nullopt;
  const Quaternion<DoubleDouble> b{near->values[0], near->values[1], near->values[2],
                                   near->values[3]};
  // As in CompiledFrames.
  const double error = frame_error(near->error) + 0x1p-94;
  const Vector<NearNumber> tangent = all_within(rotated_i(b), error);
  const NearNumber f2_square = dot(frame.f2, frame.f2);
  if (!is_of_usual_length(f2_square)) return std::nullopt;

  const NearNumber x = dot(frame.f2, all_within(rotated_j(b), error));
  const NearNumber y = dot(frame.f2, all_within(rotated_k(b), error));
  if (!first_) first_.emplace(x, y);
  const auto& [x0, y0] = *first_;
  Deviation found{
      tangent_of(x * x0 + y * y0, y * x0 - x * y0), {}, {}, {}, turned(tangent, frame.f2)};

  const NearBounds f2_size = root(size_bounds(f2_square));
  found.orthogonality = cosine(dot(frame.f2, tangent), f2_size);
  found.length = off_unit(f2_square);
  const Vector<NearNumber>& forward = frame.tangent ? *frame.tangent : tangent;
  if (frame.f3) {
    const NearNumber f3_square = dot(*frame.f3, *frame.f3);
    if (!is_of_usual_length(f3_square) || !is_positive(dot(forward, cross(frame.f2, *frame.f3))))
      return std::nullopt;
    const NearBounds f3_size = root(size_bounds(f3_square));
    found.orthogonality = greater(found.orthogonality, cosine(dot(*frame.f3, tangent), f3_size));
    found.orthogonality =
        greater(found.orthogonality, cosine(dot(frame.f2, *frame.f3), product(f2_size, f3_size)));
    found.length = greater(found.length, off_unit(f3_square));
  }
  if (frame.tangent) {
    const NearNumber square = dot(forward, forward);
    if (!is_of_usual_length(square) || !is_positive(dot(forward, tangent))) return std::nullopt;
    found.length = greater(found.length, off_unit(square));
    found.tangent_sine = sine(forward, tangent, square);
  }
  return found;
}

/// Those that are told; false where one is not told or the first.
bool FrameSieve::find_faults(const Row& row, const Deviation& found) {
  const std::array<const NearBounds*, told_faults.size()> numbers{
      &found.tangent_sine, &found.orthogonality, &found.length};
  bool is_all = true;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k]->upper <= tolerance_.lower) continue;
    if (numbers[k]->lower > tolerance_.upper) {
      is_all = is_all && !faults_[k].empty();
      faults_[k].push_back(row.number);
    } else {
      is_all = false;
    }
  }
  return is_all;
}

/// Where a frame is not told, the steps to it and from it are seen of the rows.
void FrameSieve::step_to(const Row& row, const std::optional<Deviation>& found) {
  if (found && last_angle_) {
    const Bounds& a = *last_angle_;
    const Bounds& b = found->angle;
    const double most = std::max(b.upper - a.lower, a.upper - b.lower);
    const double least = std::max(b.lower - a.upper, a.lower - b.upper);
    // dφ = d tan φ/(1 + tan²φ), and |tan φ| is at most this.
    const double tangent =
        std::max({std::abs(a.lower), std::abs(a.upper), std::abs(b.lower), std::abs(b.upper)});
    greatest_step_.upper = std::max(greatest_step_.upper, most * (1 + 0x1p-50));
    greatest_step_.lower =
        std::max(greatest_step_.lower, least / (1 + tangent * tangent) * (1 - 0x1p-50));
  }
  if (!found && row.number > 0) rows_.push_back(last_row_);
  if (!found || (row.number > 0 && !last_angle_)) rows_.push_back(row);
  last_angle_ = found ? std::optional(found->angle) : std::nullopt;
}

bool FrameSieve::add(const NearFrame& frame, std::uint64_t place) {
  if (!follows(frame.t)) return false;
  const double t = frame.t.value.high;
  const bool is_before = t < 0 || (t == 0 && frame.t.error > 0);
  const bool is_beyond =
      !length_ && (t > rotation_.to() || (t == rotation_.to() && frame.t.error > 0));
  if (is_before || is_beyond) return false;
  const Row row{count_, place};
  const auto found = deviation(frame);
  if (row.number == 0) {
    if (!found) return false;
    first_row_ = row;
  }
  step_to(row, found);
  last_row_ = row;
  t_ = frame.t;
  ++count_;
  by_number_.offer(row, static_cast<double>(row.number));
  if (rows_.size() > 3 * most_rows) return false;
  if (!found) return true;
  if (!(found->angle.lower > -most_tangent && found->angle.upper < most_tangent)) return false;
  if (!find_faults(row, *found)) rows_.push_back(row);
  highest_.offer(row, found->angle);
  lowest_.offer(row, {-found->angle.upper, -found->angle.lower});
  by_angle_.offer(row, (found->angle.lower + found->angle.upper) / 2);
  cosines_.offer(row, {found->orthogonality.lower, found->orthogonality.upper});
  lengths_.offer(row, {found->length.lower, found->length.upper});
  // Of less there are no guesses; and the square is off by less than that.
  for (std::size_t k = 0; k < 2; ++k)
    if (const double x = found->turned[k]; x > 0.9e-6)
      turned_[k].offer(row, {x * (1 - 1e-11), x * (1 + 1e-11)});
  return !highest_.is_full() && !lowest_.is_full() && !cosines_.is_full() && !lengths_.is_full() &&
         !turned_[0].is_full() && !turned_[1].is_full();
}

std::vector<FrameSieve::Row> FrameSieve::rows() const {
  std::vector<Row> all = rows_;
  all.push_back(first_row_);
  all.push_back(last_row_);
  for (const Greatest* greatest :
       {&highest_, &lowest_, &cosines_, &lengths_, &turned_[0], &turned_[1]})
    greatest->add_to(all);
  by_angle_.add_to(all);
  by_number_.add_to(all);
  std::sort(all.begin(), all.end(), [](const Row& a, const Row& b) { return a.number < b.number; });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const Row& a, const Row& b) { return a.number == b.number; }),
            all.end());
  return all;
}

}  // namespace phrame
