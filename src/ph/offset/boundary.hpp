#pragma once
#include <functional>
#include <optional>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/curve/curve_arc.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {

/// A part of a piece of a boundary, from where it is cut or joined to where it is again.
struct OffsetPart {
  std::size_t piece;  ///< of the offset or envelope
  Real from;          ///< its parameter in [0, 1], exact where that is known to be rational
  Real to;            ///< likewise, greater, or less where it is gone through backwards
};

/// Parts of which each starts where the one before ends.
struct TrimmedBranch {
  std::vector<OffsetPart> parts;  ///< at least one
  bool is_closed;                 ///< does the first one start where the last one ends?
};

/// A stretch of a piece of which it is not told whether it is nearer than |d|, whether the offset
/// touches itself there without being cut, or where in it it is cut. Then enclosures of the ends of
/// parts that it is are no narrower.
struct UndecidedStretch {
  std::size_t piece;  ///< of the offset or envelope
  RealBall t;         ///< all of it
};

/// A place where what is left of a piece may change, beside cusps and crossings.
struct BoundaryEvent {
  std::size_t piece;
  RealAlgebraic t;
};

/// Curves that the boundary of a plane domain is made of, and what tells what of them is.
struct BoundaryCurves {
  OffsetBranches branches;                               ///< first those that are asked for
  std::size_t own;                                       ///< how many are
  std::vector<std::optional<Vector<Rational>>> centers;  ///< of those that are arcs
  std::vector<BoundaryEvent> events = {};                ///< of those asked for
  bool meet_by_points = false;  ///< is an end of one the end of all that end in the same point?
  /// Of each the sign of its multiplier where it may be boundary; 0 of one that does not turn back.
  /// May be empty. Where the sign is the other one it is inside of what makes it, and nothing ends
  /// there.
  std::vector<int> signs = {};
  /// Is all of a box inside the domain? false says nothing.
  std::function<bool(const PlaneBox& box)> covers = {};
  /// Is it seen that arcs of a curve that is asked for and of one that is not do not meet? May be
  /// empty.
  std::function<bool(const CurveNode& own, const CurveNode& other)> are_apart = {};
  /// Is a part folded back all along, inside of what makes it? Then no boundary, nor where one
  /// ends. May be empty.
  std::function<bool(const CurvePart& part)> is_folded = {};
  /// Is that point of a piece no boundary?
  std::function<bool(std::size_t piece, const Rational& t)> is_cut = {};
  /// Is all of that part seen to be none?
  std::function<bool(std::size_t piece, const Rational& from, const Rational& to)> is_covered = {};
  /// The same, beside a short part of another piece that nearly coincides with it; may be empty.
  std::function<bool(const CurvePart& part, const CurvePart& beside)> is_covered_beside = {};
  /// Is the boundary gone through against the piece there? May be empty.
  std::function<bool(std::size_t piece, const Rational& t)> is_backward = {};
};

/// What is left of the curves.
struct TrimmedCurves {
  std::vector<TrimmedBranch> branches;      ///< by the places where they start
  std::vector<UndecidedStretch> undecided;  ///< mostly none: where branches touch
};
/// They are cut at their crossings, cusps and events, all of which are found with proof; between
/// these one rational point tells for all. Throws Undecided where so many branches touch that the
/// search is cut off, naming the function.
TrimmedCurves trimmed(const BoundaryCurves& curves, const std::string& function);

/// A branch as a path, as paths() of a TrimmedOffset has it, with its ends moved by less than
/// 10^−digits·size.
std::vector<Path> branch_paths(
    const TrimmedBranch& branch,
    const std::function<const RationalCurve&(std::size_t piece)>& curve_of, const Rational& size,
    long digits);

/// Is it a straight line of constant weight?
bool is_line(const RationalCurve& curve);

}  // namespace phrame
