#include "phrame/io/read/joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/gap.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// No value of formulas.
std::optional<Vector<Rational>> place_at(const GivenSegment& segment, const Rational& t) {
  if (const auto* curve = std::get_if<Curve>(&segment.form))
    return t == 0 ? curve->start()
                  : Rational(1 / curve->weight()(t)) * evaluate(numerator(*curve), t);
  if (const auto* curve = std::get_if<RationalCurve>(&segment.form)) return point(*curve, t);
  return std::nullopt;
}

/// The curve moved by `way`, times a polynomial of t.
RationalCurve moved(const RationalCurve& curve, const Vector<Rational>& way,
                    const Polynomial& share) {
  Vector<Polynomial> numerator = curve.numerator();
  for (std::size_t k = 0; k < 3; ++k) numerator[k] += way[k] * share * curve.weight();
  return RationalCurve(numerator, curve.weight());
}

/// Its ends and its middle; none of formulas.
std::vector<Vector<Rational>> places_on(const GivenSegment& segment) {
  const std::array<Rational, 3> ts{0, Rational(1, 2), 1};
  std::vector<Vector<Rational>> places;
  if (const auto* curve = std::get_if<Curve>(&segment.form)) {
    const Vector<Polynomial> r = numerator(*curve);
    for (const Rational& t : ts)
      places.push_back(Rational(1 / curve->weight()(t)) * evaluate(r, t));
  } else if (const auto* rational = std::get_if<RationalCurve>(&segment.form)) {
    for (const Rational& t : ts) places.push_back(point(*rational, t));
  }
  return places;
}

double size_of(const Polynomial& p) {
  double sum = 0;
  for (const Rational& c : p.coefficients()) sum += std::abs(static_cast<double>(c));
  return sum;
}

/// No coordinate on a polynomial segment is greater, but for rounding; infinite for others.
double bound_of(const GivenSegment& segment) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto* curve = std::get_if<RationalCurve>(&segment.form);
  if (curve == nullptr || !curve->weight().is_constant()) return infinite;
  const double size = size_of(curve->multiplier());
  double bound = 0;
  for (const Polynomial& h : curve->direction()) bound += size * size_of(h);
  for (const Rational& x : point(*curve, 0)) bound += std::abs(static_cast<double>(x));
  return std::isfinite(bound) ? bound : infinite;
}

/// The gaps of a list of segments, while they are closed.
class Gaps {
 public:
  Gaps(std::vector<GivenSegment>& segments, const std::optional<Rational>& most)
      : segments_(segments), most_(most) {}

  void close_joints() {
    for (std::size_t k = 1; k < segments_.size(); ++k) {
      const auto way = gap_between(segments_[k - 1], segments_[k]);
      if (!way) continue;
      count(*way);
      if (auto* ph = std::get_if<Curve>(&segments_[k].form))
        *ph = translated(*ph, Rational(-1) * *way);
      else
        move(segments_[k], Rational(-1) * *way, {1, -1});
    }
  }
  void close_ends() {
    if (std::holds_alternative<Curve>(segments_.back().form)) return;
    const auto way = gap_between(segments_.back(), segments_.front());
    if (!way) return;
    const Vector<Rational> start = *place_at(segments_.front(), 0);
    const auto is_far = [&](const GivenSegment& segment) {
      auto places = places_on(segment);
      places.insert(places.begin(), start);
      return is_small_beside(*way, places);
    };
    if (!std::any_of(segments_.begin(), segments_.end(), is_far)) return;
    try {
      GivenSegment last = segments_.back();
      move(last, *way, {0, 1});
      if (segments_.size() > 1) joined_segments({segments_[segments_.size() - 2], last});
      segments_.back() = std::move(last);
      count(*way);
    } catch (const InputError&) {  // moved, it is a point or turns back: the path is open
    }
  }
  std::size_t count() const { return count_; }
  const Rational& greatest() const { return greatest_; }  ///< squared

 private:
  /// From the end of one to the start of the other, where that is to be closed.
  std::optional<Vector<Rational>> gap_between(const GivenSegment& before,
                                              const GivenSegment& after) {
    const auto end = place_at(before, 1);
    const auto start = place_at(after, 0);
    if (!end || !start || *end == *start) return std::nullopt;
    const Vector<Rational> way = *start - *end;
    if (is_seen_far(way) || !are_within(most(), *end, *start)) return std::nullopt;
    return way;
  }
  /// Is it farther than what rounding leaves, whatever the places on the segments? So are the ends
  /// of nearly every open path.
  bool is_seen_far(const Vector<Rational>& way) {
    if (most_) return false;
    if (!bound_) {
      bound_ = 0;
      for (const GivenSegment& segment : segments_) bound_ = std::max(*bound_, bound_of(segment));
    }
    double size = 0;
    for (const Rational& x : way) size += std::abs(static_cast<double>(x));
    return size > 0x1p-40 * *bound_;
  }
  /// Where none is given, that of rounding all segments, found where the first gap is.
  const Rational& most() {
    if (most_) return *most_;
    most_ = 0;
    for (const GivenSegment& segment : segments_)
      most_ = std::max(*most_, rounding_gap(places_on(segment)));
    return *most_;
  }
  void count(const Vector<Rational>& way) {
    ++count_;
    greatest_ = std::max(greatest_, dot(way, way));
  }
  void move(GivenSegment& segment, const Vector<Rational>& way, const Polynomial& share) {
    try {
      segment.form = moved(std::get<RationalCurve>(segment.form), way, share);
    } catch (const DomainError& error) {
      fail_at(segment, error.what());
    }
  }

  std::vector<GivenSegment>& segments_;
  std::optional<Rational> most_;
  std::optional<double> bound_{};  ///< of all coordinates
  std::size_t count_ = 0;
  Rational greatest_{};
};

bool is_of_formulas(const Segment& segment) {
  return std::holds_alternative<ExpressionCurve>(segment);
}

std::string size_text(const Rational& square) {
  return upper_bound_text(square_root_of(square).enclose(64).upper());
}

}  // namespace

std::string open_ends(const Path& path, const std::optional<Rational>& most) {
  const auto& segments = path.segments();
  if (!is_of_formulas(segments.front()) && !is_of_formulas(segments.back())) return "";
  const Vector<Rational> start = near(position(path, {0, Rational(0)}));
  const Vector<Rational> end = near(position(path, end_of(path)));
  const Vector<Rational> middle = near(position(path, {segments.size() / 2, Rational(1, 3)}));
  const Rational gap = most ? *most : rounding_gap({start, end, middle});
  const Vector<Rational> way = end - start;
  if (!are_within(gap, start, end) || !is_small_beside(way, {start, middle}) ||
      closure(path).ends_meet != false)
    return "";
  return fmt::format("its ends are up to {} apart, and formulas are not moved: it is open",
                     size_text(dot(way, way)));
}

std::string close_gaps(std::vector<GivenSegment>& segments, const std::optional<Rational>& most) {
  // One PH curve has no joint, and its end is not moved.
  if (segments.size() == 1 && std::holds_alternative<Curve>(segments.front().form)) return "";
  Gaps gaps(segments, most);
  gaps.close_joints();
  gaps.close_ends();
  if (gaps.count() == 0) return "";
  return fmt::format("{} of at most {} closed, by moving a point",
                     gaps.count() == 1 ? "a gap" : fmt::format("{} gaps", gaps.count()),
                     size_text(gaps.greatest()));
}

}  // namespace phrame
