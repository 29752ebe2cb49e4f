#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/along/path_length.hpp"

namespace phrame::inline v0 {

/// By which number a point of a path is told.
enum class ParameterKind {
  t,           ///< ours: segment k = 0, 1, … is from k to k + 1
  native,      ///< that of the file of the path: knots, times, s of formulas
  unit,        ///< t over the number of segments, 0 to 1
  arc_length,  ///< from the start
  fraction,    ///< of the whole arc length, 0 to 1
};

/// A value of a parameter, and the point of the path that has it.
struct ParameterPoint {
  Real value;  ///< as asked, or of equally spaced ones
  Place at;    ///< of several at a joint the later segment, but for the end
};

/// A path by one of its parameters. Copies are cheap and share what was found.
class PHRAME_API Parametrization {
 public:
  /// Throws DomainError where the file of the path has no parameter but t, and that is asked for.
  explicit Parametrization(const NamedPath& named, ParameterKind kind = ParameterKind::t);

  const Path& path() const { return named_.path; }      ///< along which it is
  ParameterKind kind() const { return kind_; }          ///< which one
  const PathLength& length() const { return length_; }  ///< along that
  Real from() const;                                    ///< its value at the start of the path
  /// Its value at the end; it may be less than from() where it is that of formulas.
  Real to() const;

  /// Where it is x. A value beyond an end that rounds to the same double is that end, so that
  /// doubles from float(from()) to float(to()) are on the path. Throws DomainError for others that
  /// are not on the path, where a PH curve by itself goes on for all t; Undecided as
  /// PathLength::point(), and where a fraction of the arc length is not told from that of a joint:
  /// it is where segments before and behind that have the same speed |r′(t)| or |r′(1 − t)|.
  ParameterPoint point(const Rational& x) const;
  /// So many, ≥ 2 or none, equally spaced from start to end; of irrational arc lengths up to the
  /// greatest double of at most the length.
  std::vector<ParameterPoint> samples(long count) const;
  std::vector<Real> sample_values(long count) const;  ///< of these, without their points
  /// The points of these values and then the samples, if count > 0.
  std::vector<ParameterPoint> points(const std::vector<Rational>& values, long count = 0) const;

 private:
  Place place(const Rational& x) const;
  Place place_of_fraction(const Rational& x) const;

  NamedPath named_;
  ParameterKind kind_;
  PathLength length_;
};

}  // namespace phrame
