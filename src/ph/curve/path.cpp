#include "phrame/ph/curve/path.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/exact_vector.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// Where a segment begins or ends: its numbers are steps of a program.
struct SegmentEnd {
  ExactVector position;
  ExactVector direction;  ///< e₁, of any length
};

ExactVector inserted(FormulaProgram& program, const Vector<Rational>& v) {
  return {program.number(v[0]), program.number(v[1]), program.number(v[2])};
}

SegmentEnd end_at(const RationalCurve& curve, const Rational& t, FormulaProgram& program) {
  return {inserted(program, point(curve, t)), inserted(program, evaluate(curve.direction(), t))};
}

SegmentEnd end_at(const ExpressionCurve& curve, const Rational& t, FormulaProgram& program) {
  return {exact_point(curve, t, program), exact_direction(curve, t, program)};
}

SegmentEnd start_of(const Segment& segment, FormulaProgram& program) {
  return visit_curve([&](const auto& curve) { return end_at(curve, 0, program); }, segment);
}

SegmentEnd end_of(const Segment& segment, FormulaProgram& program) {
  return visit_curve([&](const auto& curve) { return end_at(curve, 1, program); }, segment);
}

/// The unit tangent, of any length, where e₁ times this sign is that.
ExactVector tangent_of(const SegmentEnd& end, int sign, FormulaProgram& program) {
  ExactVector tangent = end.direction;
  if (sign < 0)
    for (auto& x : tangent) x = program.negative(x);
  return tangent;
}

/// For messages: fractions, as the multiple whose largest component is ±1 if only the direction is
/// meant, or digits.
std::string shown_vector(const FormulaProgram& program, const ExactVector& v, bool is_direction) {
  Vector<Rational> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational* x = program.rational(v[k]);
    if (x == nullptr) {
      const auto digits = [&](std::size_t j) {
        return to_string(constant_value(program, v[j], 128), 9);
      };
      return fmt::format("({}, {}, {})", digits(0), digits(1), digits(2));
    }
    exact[k] = *x;
  }
  if (is_direction) {
    const Rational size = std::max({abs(exact[0]), abs(exact[1]), abs(exact[2])});
    for (Rational& x : exact) x /= size;
  }
  return abbreviated(exact);
}

bool decided(const std::optional<bool>& answer, const char* what) {
  if (!answer)
    throw Undecided(fmt::format("whether {} is not told: they agree to 1024 bits", what));
  return *answer;
}

std::optional<bool> turns_back(const ExactVector& before, ExactVector after,
                               FormulaProgram& program) {
  for (auto& x : after) x = program.negative(x);
  return have_same_direction(program, before, after);
}

/// Does the tangent break where it goes on like this? Throws DomainError where it turns
/// back, and Undecided where that is not told.
bool is_corner(const ExactVector& before, const ExactVector& after, FormulaProgram& program) {
  if (have_same_direction(program, before, after) == true) return false;
  if (decided(turns_back(before, after, program), "the tangent turns back at a joint"))
    throw DomainError(
        fmt::format("the tangent turns back: the spline ends in the direction {}, and it starts in "
                    "the opposite "
                    "one, so that frames are undefined there",
                    shown_vector(program, before, true)));
  return true;
}

/// Does a rational curve go on where another one ends, in the same direction? So it is at nearly
/// every joint of a long spline, and fractions tell it faster than a program.
bool is_seen_smooth(const Segment& before, const Segment& after) {
  const auto* a = std::get_if<RationalCurve>(&before);
  const auto* b = std::get_if<RationalCurve>(&after);
  if (a == nullptr || b == nullptr || point(*a, 1) != point(*b, 0)) return false;
  const Vector<Rational> old_direction = evaluate(a->direction(), 1);
  const Vector<Rational> new_direction = evaluate(b->direction(), 0);
  return cross(old_direction, new_direction) == Vector<Rational>{} &&
         dot(old_direction, new_direction).sign() == end_orientation(before) * orientation(after);
}

}  // namespace

Path::Path(Segment first, std::size_t room) : segments_(std::make_shared<Segments>()) {
  segments_->reserve(room);
  segments_->push_back(orientation(first) < 0 ? turned_over(first) : std::move(first));
}

Path::Path(const PhPath& ph) : segments_(std::make_shared<Segments>()), corners_(ph.corners()) {
  for (const Curve& curve : ph.segments()) segments_->emplace_back(PhSegment(curve));
}

Path Path::of_continuous(std::vector<Segment> segments, std::vector<std::size_t> corners) {
  Path path(std::move(segments.front()), segments.size());
  for (std::size_t k = 1; k < segments.size(); ++k) path.add(std::move(segments[k]));
  path.corners_ = std::move(corners);
  return path;
}

void Path::add(Segment next) {
  if (end_orientation(segments().back()) != orientation(next)) next = turned_over(next);
  if (segments_.use_count() > 1) segments_ = std::make_shared<Segments>(segments());
  segments_->push_back(std::move(next));
}

void Path::append(Segment next) {
  const Curve* last_ph = ph_curve(segments().back());
  const Curve* next_ph = ph_curve(next);
  if (last_ph != nullptr && next_ph != nullptr) {
    Continuation found = continuation(*last_ph, *next_ph);
    if (found.is_corner) corners_.push_back(segments().size());
    add(PhSegment(std::move(found.curve)));
    return;
  }
  if (is_seen_smooth(segments().back(), next)) {
    add(std::move(next));
    return;
  }
  FormulaProgram program;
  const SegmentEnd before = end_of(segments().back(), program);
  const SegmentEnd after = start_of(next, program);
  if (!decided(are_equal(program, before.position, after.position),
               "it starts where the spline ends"))
    throw DomainError(fmt::format("it starts at {}, but the spline ends at {}",
                                  shown_vector(program, after.position, false),
                                  shown_vector(program, before.position, false)));
  const ExactVector old_tangent = tangent_of(before, end_orientation(segments().back()), program);
  const ExactVector new_tangent = tangent_of(after, orientation(next), program);
  if (is_corner(old_tangent, new_tangent, program)) corners_.push_back(segments().size());
  add(std::move(next));
}

bool Path::has_corner(std::size_t k) const {
  return std::binary_search(corners_.begin(), corners_.end(), k);
}

bool Path::is_ph() const {
  return std::ranges::all_of(segments(), [](const Segment& segment) {
    const Curve* curve = ph_curve(segment);
    return curve != nullptr && curve->is_polynomial();
  });
}

bool Path::has_erf() const { return std::ranges::all_of(segments(), ph_curve); }

std::optional<PhPath> Path::ph() const { return is_ph() ? with_preimages() : std::nullopt; }

std::optional<PhPath> Path::with_preimages() const {
  if (!has_erf()) return std::nullopt;
  std::vector<Curve> curves;
  for (const Segment& segment : segments()) curves.push_back(*ph_curve(segment));
  return PhPath::of_continuous(std::move(curves), corners());
}

bool Path::ends_meet() const {
  const Curve* first = ph_curve(segments().front());
  const Curve* last = ph_curve(segments().back());
  if (first != nullptr && last != nullptr) return ends_at(*last, first->start());
  FormulaProgram program;
  const SegmentEnd start = start_of(segments().front(), program);
  const SegmentEnd end = end_of(segments().back(), program);
  return decided(are_equal(program, start.position, end.position), "the ends of the curve meet");
}

bool Path::is_closed() const {
  if (is_ph()) return closing_turn().has_value();
  if (!ends_meet()) return false;
  if (ends_turned_over()) return false;
  FormulaProgram program;
  const SegmentEnd start = start_of(segments().front(), program);
  const SegmentEnd end = end_of(segments().back(), program);
  if (have_same_direction(program, end.direction, start.direction) == true) return true;
  return !decided(turns_back(end.direction, start.direction, program),
                  "the tangent turns back where the ends of the curve meet");
}

bool Path::ends_turned_over() const {
  return end_orientation(segments().back()) != orientation(segments().front());
}

bool Path::closes_at_corner() const {
  if (!is_closed()) return false;
  FormulaProgram program;
  const SegmentEnd start = start_of(segments().front(), program);
  const SegmentEnd end = end_of(segments().back(), program);
  return have_same_direction(program, end.direction, start.direction) != true;
}

std::optional<GaussianRational> Path::closing_turn() const {
  if (!has_erf()) return std::nullopt;
  return phrame::closing_turn(*ph_curve(segments().front()), *ph_curve(segments().back()));
}

Closure closure(const Path& path) {
  Closure found;
  try {
    found.ends_meet = path.ends_meet();
    found.is_closed = *found.ends_meet && path.is_closed();
    found.at_corner = *found.is_closed && path.closes_at_corner();
  } catch (const Undecided& undecided) {
    found.undecided = undecided.what();
  }
  return found;
}

Path joined(std::vector<Segment> segments) {
  Path path(std::move(segments.front()), segments.size());
  for (std::size_t k = 1; k < segments.size(); ++k) path.append(std::move(segments[k]));
  return path;
}

std::optional<NamedPhPath> as_ph(const NamedPath& named) {
  return named.path.is_ph() ? with_preimages(named) : std::nullopt;
}

std::optional<NamedPhPath> with_preimages(const NamedPath& named) {
  auto path = named.path.with_preimages();
  if (!path) return std::nullopt;
  NamedPhPath ph(named.name, *std::move(path), named.near);
  ph.notes = named.notes;
  ph.frame = named.frame;
  return ph;
}

const PhSegment& segment_with_erf(const Path& path, std::size_t k) {
  if (const auto* ph = std::get_if<PhSegment>(&path.segments()[k])) return *ph;
  throw DomainError(fmt::format(
      "Euler-Rodrigues frame: segment {} is no Pythagorean-hodograph curve, it has none", k + 1));
}

bool goes_on(const Path& path) { return path.segments().size() == 1 && path.is_ph(); }

PathParameter locate(const Path& path, const Rational& t) {
  return goes_on(path) ? PathParameter{0, t} : locate_inside(path.segments().size(), t);
}

}  // namespace phrame
