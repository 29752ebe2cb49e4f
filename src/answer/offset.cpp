#include "phrame/answer/offset.hpp"

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/offset/offset_measure.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame {
namespace {

/// With 12 digits.
Decimal decimal_of(const RealBall& x) {
  constexpr long digits = 12;
  const Rational middle = x.midpoint();
  Decimal decimal = round_to_decimal(Real(middle), digits);
  decimal.radius = upper_bound_text(x.radius() + abs(middle) * power_of_ten(1 - digits));
  return decimal;
}

OffsetAnswer::Measure measure(const DefiniteIntegral& found, const std::string& name, long digits) {
  return {found.exact, rounded_or_zero(found.value, name, digits)};
}

/// What is said of one offset.
class OffsetReport {
 public:
  OffsetReport(const PhPath& path, const Offset& offset, long digits)
      : path_(path), offset_(offset), digits_(digits) {}

  OffsetAnswer::Part make() {
    OffsetAnswer::Part part{offset_.distance, paths(offset_), {}, {}, {}, false, {}, {}, {}, {}};
    for (const OffsetCusp& cusp : cusps(offset_))
      part.cusps.push_back({parameter(cusp.piece, cusp.t), cusp.turns_back});
    add_meetings(part);
    for (const std::size_t k : offset_.inner_corners) part.inner_corners.push_back(corner(k));
    const OffsetLength lengths = length(offset_);
    for (const OffsetStretch& stretch : lengths.stretches)
      part.stretches.push_back({parameter(stretch.first_piece, stretch.from),
                                parameter(stretch.last_piece, stretch.to),
                                measure(stretch.length, "the length of a stretch", digits_)});
    part.length = measure(lengths.total, "the length of the offset", digits_);
    if (const auto area = signed_area(offset_))
      part.area = measure(*area, "the area of the offset", digits_);
    return part;
  }

 private:
  /// t of the corner at the start of that segment; that where the path closes is its end.
  Rational corner(std::size_t segment) const {
    return segment == 0 ? path_.end() : Rational(static_cast<long>(segment));
  }

  RealAlgebraic parameter(std::size_t piece, const RealAlgebraic& t) const {
    const OffsetPiece& of = offset_.pieces[piece];
    if (of.is_join) return corner(of.segment);
    return affine(t, 1, Rational(static_cast<long>(of.segment)));
  }

  Decimal parameter(std::size_t piece, const RealBall& t) const {
    const OffsetPiece& of = offset_.pieces[piece];
    if (of.is_join) return round_to_decimal(Real(corner(of.segment)), 12);
    return decimal_of(add(t, RealBall(Rational(static_cast<long>(of.segment)), 64), 128));
  }

  std::array<Decimal, 2> range(const CurvePart& part) const {
    const auto end = [&](double t) { return parameter(part.segment, exact_sum(t, 0)); };
    return {end(part.lower), end(part.upper)};
  }

  void add_meetings(OffsetAnswer::Part& part) const {
    const SelfIntersections found = self_intersections(offset_);
    for (const Crossing& x : found.found) {
      const OffsetPiece& piece = offset_.pieces[x.first_segment];
      const auto at = [&](std::size_t k) {
        return decimal_of(divide(evaluate(piece.curve.numerator()[k], x.first_t, 128),
                                 evaluate(piece.curve.weight(), x.first_t, 128), 128));
      };
      part.meetings.push_back(
          {{parameter(x.first_segment, x.first_t), piece.is_join},
           {parameter(x.second_segment, x.second_t), offset_.pieces[x.second_segment].is_join},
           {at(0), at(1)}});
    }
    for (const UndecidedCrossing& x : found.undecided)
      part.undecided.push_back({range(x.first), range(x.second)});
    part.is_cut_off = found.is_cut_off;
  }

  const PhPath& path_;
  const Offset& offset_;
  long digits_;
};

}  // namespace

OffsetAnswer answer(const NamedPath& named, const OffsetQuery& query) {
  const auto path = named.path.ph();
  if (!path) throw DomainError("offset: the path is not Pythagorean-hodograph");
  OffsetAnswer answer{named, path->closing_turn().has_value(), query.join, {}};
  for (const Rational& d : query.distances)
    answer.offsets.push_back(
        OffsetReport(*path, offset(*path, d, query.join), query.digits).make());
  return answer;
}

}  // namespace phrame
