#include "phrame/io/read/given_segment.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/joints.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/exact_vector.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/place.hpp"

namespace phrame::inline v0 {
namespace {

/// A PH curve where it is one; what the segment is is taken from it.
Segment taken_curve(GivenSegment& segment) {
  if (auto* curve = std::get_if<RationalCurve>(&segment.form))
    if (!is_pythagorean(curve->direction())) return std::move(*curve);
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

GivenSegment span_segment(const BezierPiece& piece, const std::string& place,
                          const std::string& part) {
  GivenSegment segment = bezier_segment(piece.curve, place, part);
  segment.parameters = {piece.lower, piece.upper};
  return segment;
}

std::vector<GivenSegment> span_segments(const BSpline& spline, const std::string& place) {
  std::vector<GivenSegment> segments;
  for (const BezierPiece& piece : bezier_pieces(spline))
    segments.push_back(span_segment(piece, place,
                                    fmt::format("between the knots {} and {}",
                                                as_written(piece.lower), as_written(piece.upper))));
  return segments;
}

std::variant<Curve, std::string> identify_segment(const GivenSegment& segment) {
  if (const auto* curve = std::get_if<Curve>(&segment.form)) return *curve;
  if (std::holds_alternative<ExpressionCurve>(segment.form)) return "it is given by formulas";
  const auto& curve = std::get<RationalCurve>(segment.form);
  auto found = identify(curve);
  if (const auto* reason = std::get_if<NotPythagorean>(&found))
    return curve.weight().is_constant()
               ? to_string(*reason)
               : "its weight function W is no constant, and |W^2 r'| is no polynomial over Q";
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

namespace {

/// Of segments that follow each other; empty where they have none.
std::vector<Real> parameters_of(const std::vector<GivenSegment>& segments) {
  if (const auto* curve = std::get_if<ExpressionCurve>(&segments.front().form);
      curve != nullptr && segments.size() == 1)
    return formula_parameters(*curve);
  std::vector<Real> joints;
  joints.reserve(segments.size() + 1);
  for (const GivenSegment& segment : segments) {
    if (!segment.parameters) return {};
    const auto& [from, to] = *segment.parameters;
    if (from >= to || (!joints.empty() && joints.back().exact() != from)) return {};
    if (joints.empty()) joints.emplace_back(from);
    joints.emplace_back(to);
  }
  return joints;
}

}  // namespace

Path joined_segments(std::vector<GivenSegment> segments) {
  Path path(taken_curve(segments.front()), segments.size());
  for (std::size_t k = 1; k < segments.size(); ++k) try {
      path.append(taken_curve(segments[k]));
    } catch (const DomainError& error) {
      fail_at(segments[k], error.what());
    } catch (const Undecided& undecided) {
      throw Undecided(segments[k].place + ": " + undecided.what());
    }
  return path;
}

NamedPath path_of(std::string name, std::vector<GivenSegment> segments,
                  const std::optional<Rational>& gap) {
  std::vector<Real> parameters = parameters_of(segments);
  std::string closed = close_gaps(segments, gap);
  NamedPath named(std::move(name), joined_segments(std::move(segments)));
  if (!closed.empty()) named.notes.push_back(std::move(closed));
  if (std::string open = open_ends(named.path, gap); !open.empty())
    named.notes.push_back(std::move(open));
  named.parameters = std::move(parameters);
  return named;
}

}  // namespace phrame
