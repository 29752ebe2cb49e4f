#pragma once
#include <functional>
#include <map>

#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// p(t + z) as a series in z; of a ball t the balls of all series around its points.
BallPolynomial taylor_series(const Polynomial& p, const RealBall& t, long length, long bits);

/// How a plane segment r′ = p·H/W² goes and turns, with signs that algebra decides.
struct SegmentTurning {
  int first_sign = 1;                      ///< of p just after the start
  std::vector<RealAlgebraic> reversals;    ///< in (0, 1), where p changes its sign
  int first_turn = 0;                      ///< of H × H′ likewise; 0 on a straight line
  std::vector<RealAlgebraic> inflections;  ///< in (0, 1), where that changes its sign
  Vector<Rational> first_direction;        ///< H(0)
  Vector<Rational> last_direction;         ///< H(1)
  /// Is it known that the branches at a place in (0, 1) where p changes its sign have no other
  /// point in common while H stays in a half-plane, nor with what is smoothly joined to them? Of
  /// parts with a place of `breaks` in them, or at an end, it is not.
  bool parts_at_reversals = false;
  std::vector<RealAlgebraic> breaks = {};  ///< as where the path of an offset turns back
};

/// A curve of one or several segments, each on [0, 1], by Taylor series of its position: all that
/// is asked of a curve to find its crossings. Where it has cusps, its turning is wanted, too.
struct CurveSeries {
  /// A vector around a place of a segment.
  using Series = std::function<Vector<BallPolynomial>(std::size_t segment, const RealBall& t,
                                                      long length, long bits)>;
  std::size_t segments = 0;  ///< at least one
  /// r of a segment around t, as balls: where t is one, of all series around its points. Copies
  /// share what it is made from.
  Series position;
  Series direction = {};                     ///< along H likewise, where the turning is known
  std::vector<SegmentTurning> turning = {};  ///< of the segments, or empty
  /// The segment that starts where each one ends, or no_segment. Empty where that is the next one,
  /// and of the last one the first.
  std::vector<std::size_t> behind = {};
  /// Of a path: the segments with cusps in which it does not turn back, with H there, along r′.
  std::map<std::size_t, Vector<Polynomial>> through_cusps = {};
  /// A box around each segment, whose balls need not be finite; or empty.
  std::vector<Vector<RealBall>> boxes = {};
};
inline constexpr std::size_t no_segment = static_cast<std::size_t>(-1);  ///< behind an open end

/// Of such a curve. Cost: the roots of p, of each rational segment whose p is not constant.
CurveSeries series_of(const Path& path);
/// Around t a vector along r′, so many terms: H where the segment goes through cusps, nowhere 0,
/// and r′ elsewhere. `position` is that there, of one term more at least.
Vector<BallPolynomial> along_motion(const CurveSeries& curve, std::size_t segment,
                                    const RealBall& t, const Vector<BallPolynomial>& position,
                                    long length, long bits);
/// Of rational curves in a plane z = const, with what is behind each of them and their turning.
/// Cost: the roots of p and of H × H′.
CurveSeries plane_series(const std::vector<RationalCurve>& segments,
                         std::vector<std::size_t> behind);

}  // namespace phrame
