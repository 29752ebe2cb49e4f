#pragma once
#include <vector>

#include "phrame/ph/sweep/sweep_rates.hpp"

namespace phrame::inline v0 {

/// The corners of a profile where it is on a path.
struct SweepSection {
  double t = 0;                        ///< of the path
  std::vector<Vector<double>> points;  ///< the corners
  long folds = 0;                      ///< corners on the axis of curvature or beyond it
  /// A bound of what the corners are off, but for what the frames are.
  double rounding = 0;
  bool is_joint = false;  ///< is it only a facet of a corner away from the one before?
};

/// How the profile moves there, in doubles.
struct SweepMotion {
  Vector<double> tangent;       ///< T = r′/|r′|
  Vector<double> tangent_rate;  ///< T′
  double speed;                 ///< |r′|
  Vector<double> x;             ///< f₂, turned by φ
  Vector<double> y;             ///< f₃, turned by φ
  double scale;                 ///< λ
  double scale_rate;            ///< λ′
  double turn_rate;             ///< φ′
};

/// Sections of a body at any t.
class SweepSections {
 public:
  /// All of these must outlive this.
  SweepSections(const SweepPath& path, const SweepForm& form, const SweepTurn& turn);

  SweepSection section(std::size_t segment, double t) const;
  /// At the corner with which the segment begins: in the plane that halves it, where both sides of
  /// the body end.
  SweepSection mitre(std::size_t segment) const;
  /// By how much each corner of the profile is moved along the tangent from the section at the
  /// start of that segment to the mitre there, and against it from that at the end of the one
  /// before.
  std::vector<double> mitre_offsets(std::size_t segment) const;
  /// The way from the start of a segment to its end.
  double chord(std::size_t segment) const;
  /// From within the segment, where it is at its end.
  SweepMotion motion(std::size_t segment, double t) const;
  const std::vector<std::array<double, 2>>& corners() const { return corners_; }  ///< in doubles
  std::size_t next(std::size_t corner) const { return form_.profile.next(corner); }

 private:
  struct PathDerivatives {
    Vector<RealBall> place;
    double speed;                 ///< |r′|
    Vector<double> tangent;       ///< T, along r′
    Vector<double> tangent_rate;  ///< T′
  };
  PathDerivatives derivatives_at(std::size_t segment, double t) const;
  /// From within the segment.
  Frame<double> frame(std::size_t segment, double t) const;
  bool has_corner(std::size_t segment) const;  ///< at its start
  std::size_t before(std::size_t segment) const;
  Vector<double> tangent(std::size_t segment, double t) const {
    return derivatives_at(segment, t).tangent;
  }
  /// The corners of the profile there, from the center.
  std::vector<Vector<double>> outline(std::size_t segment, double t) const;
  SweepSection around(const PathDerivatives& at, double along,
                      const std::vector<Vector<double>>& outline) const;

  const SweepPath& path_;
  const SweepForm& form_;
  const SweepTurn& turn_;
  ScaleRates scale_;
  Vector<RealBall> origin_;  ///< 0 where the form has none yet
  std::vector<std::array<double, 2>> corners_;
};

/// The frame at the end of the path, where that closes at a corner carried through it.
Frame<double> frame_at_end(const SweepPath& path);

/// A bound of how far the triangles between two sections are from the bilinear patches through
/// their corners.
double patch_error(const SweepSections& sections, const SweepSection& a, const SweepSection& b);

/// The motion at the sections of both ends of a part, and bounds on it.
struct SweepStrip {
  SweepMotion from;
  SweepMotion to;
  SweepRates rates;
  double step;        ///< of t
  double side_angle;  ///< between a side of the profile and the curve that it stands for
  double side_error;  ///< their distance
  double reach;       ///< of the profile
  bool is_against;    ///< does the path go against e₁?
};
/// A bound of the angles between the triangles' normals and those of the part of the surface for
/// which they stand; infinite where the surface is not told from one that folds over itself.
double normal_error(const SweepSections& sections, const SweepSection& a, const SweepSection& b,
                    const SweepStrip& strip);

/// Of the corners, the least rate along the tangent; the section folds over itself where it is < 0.
double least_advance(const SweepSections& sections, const SweepMotion& motion);
/// Of each side, by how much the normal turns along it in a section that moves so, in doubles.
std::vector<double> normal_turns(const SweepSections& sections, const SweepMotion& motion);

}  // namespace phrame
