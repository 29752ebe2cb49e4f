#include "phrame/io/read/given_segment.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/joints.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"

namespace phrame {
namespace {

/// A PH curve where it is one; what the segment is is taken from it.
Segment taken_curve(GivenSegment& segment) {
  auto ph = identify_segment(segment);
  if (auto* curve = std::get_if<Curve>(&ph)) return PhSegment(std::move(*curve));
  if (auto* curve = std::get_if<RationalCurve>(&segment.form)) return std::move(*curve);
  return std::get<ExpressionCurve>(std::move(segment.form));
}

}  // namespace

void fail_at(const GivenSegment& segment, const std::string& reason) {
  throw InputError(segment.place, segment.part.empty() ? reason : segment.part + ": " + reason);
}

GivenSegment bezier_segment(const RationalBezier& bezier, const std::string& place,
                            const std::string& part) {
  try {
    return {bezier_curve(bezier.points, bezier.weights), place, part};
  } catch (const DomainError& error) {
    throw InputError(place, part.empty() ? error.what() : part + ": " + error.what());
  }
}

std::variant<Curve, std::string> identify_segment(const GivenSegment& segment) {
  if (const auto* curve = std::get_if<Curve>(&segment.form)) return *curve;
  if (std::holds_alternative<ExpressionCurve>(segment.form)) return "it is given by formulas";
  const auto& curve = std::get<RationalCurve>(segment.form);
  if (!curve.weight().is_constant()) return "its weight function is no constant";
  Vector<Polynomial> hodograph = curve.direction();
  for (Polynomial& h : hodograph) h *= curve.multiplier();
  auto found = identify(hodograph, point(curve, 0));
  if (const auto* reason = std::get_if<NotPythagorean>(&found)) return to_string(*reason);
  return std::get<Curve>(std::move(found));
}

Vector<Rational> end_point(const GivenSegment& segment) {
  if (const auto* curve = std::get_if<Curve>(&segment.form)) return end_point(*curve);
  if (const auto* curve = std::get_if<RationalCurve>(&segment.form)) return point(*curve, 1);
  FormulaProgram program;
  const ExactVector end = exact_point(std::get<ExpressionCurve>(segment.form), 1, program);
  Vector<Rational> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational* x = program.rational(end[k]);
    if (x == nullptr) fail_at(segment, "it does not end at fractions: the next one needs a start");
    result[k] = *x;
  }
  return result;
}

NamedPath path_of(std::string name, std::vector<GivenSegment> segments,
                  const std::optional<Rational>& gap) {
  const std::string closed = close_gaps(segments, gap);
  Path path(taken_curve(segments.front()), segments.size());
  for (std::size_t k = 1; k < segments.size(); ++k) {
    try {
      path.append(taken_curve(segments[k]));
    } catch (const DomainError& error) {
      fail_at(segments[k], error.what());
    }
  }
  NamedPath named(std::move(name), std::move(path));
  if (!closed.empty()) named.notes.push_back(closed);
  return named;
}

}  // namespace phrame
