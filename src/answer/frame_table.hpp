#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/nearness.hpp"
#include "phrame/ph/curve/roll.hpp"
#include "phrame/ph/frame/frame_start.hpp"
#include "phrame/ph/twist/path_twist.hpp"
#include "phrame/ph/twist/twist_frame.hpp"

namespace phrame::inline v0 {

/// The frames that a table can hold beside t, r and e₁.
enum class TabulatedFrame {
  rmf,              ///< f₂, f₃: rotation-minimizing, from a start that is asked for
  euler_rodrigues,  ///< e₂, e₃
  frenet,           ///< n, b
  mtf,              ///< of minimal twist and rational
  exact_mtf,        ///< of minimal twist, at a constant rate
  up,               ///< v × e₁ and e₁ × (v × e₁), of length 1, of paths of any kind
  signed_frenet,    ///< n, b continued through inflections, of SignedFrenet
};

/// Is it as the curve has it, whatever it starts with, so that no roll turns it?
constexpr bool is_of_curve(TabulatedFrame kind) {
  return kind == TabulatedFrame::euler_rodrigues || kind == TabulatedFrame::frenet ||
         kind == TabulatedFrame::signed_frenet;
}

/// Numbers that it can hold as well.
enum class TabulatedScalar {
  arc_length,   ///< s, from t = 0
  curvature,    ///< κ ≥ 0, the rate at which a rotation-minimizing frame turns
  torsion,      ///< τ
  frenet_rate,  ///< √(κ² + τ²), the rate at which the Frenet frame turns
  bend_f2,  ///< k₁ of Bishop, with e₁′ = k₁ f₂ + k₂ f₃, f₂′ = −k₁ e₁ by arc length
  bend_f3,  ///< k₂, with f₃′ = −k₂ e₁
  // The angular velocity ω = e₁ × e₁′ of the rotation-minimizing frame per arc length, across e₁:
  omega_x,           ///< in x
  omega_y,           ///< in y
  omega_z,           ///< in z
  signed_curvature,  ///< κ with the sign that it has with n of SignedFrenet
  // Of the frame exact_mtf, by arc length too:
  twist_rate,     ///< the rate at which it turns about e₁
  twist_omega_x,  ///< its angular velocity, e₁ × e₁′ and that rate along e₁, in x
  twist_omega_y,  ///< in y
  twist_omega_z,  ///< in z
  twist_alpha_x,  ///< the derivative of that, in x
  twist_alpha_y,  ///< in y
  twist_alpha_z,  ///< in z
};

/// What a table holds beside t, r and e₁.
struct TableColumns {
  std::vector<TabulatedFrame> frames;         ///< two vectors each
  std::vector<TabulatedScalar> scalars = {};  ///< a column each
  /// The frame of minimal twist where there are columns for it; for t on the path only.
  std::optional<PathTwist> exact_mtf = {};
  std::vector<TwistFrame> mtf = {};  ///< likewise the rational ones along its legs
  /// Where the rotation-minimizing frame starts.
  FrameStart start = {};
  /// By what the frames rmf, up, mtf and exact_mtf are turned about e₁ beside.
  Roll roll = {};
  /// Is a cell whose number is undefined left empty? Else it is an error.
  bool may_be_empty = false;
  /// Is there each frame as a unit quaternion (x, y, z, w), too, scalar last? Of the two that turn
  /// i, j, k into it, the one whose numbers have a scalar product > 0 with those of the row before;
  /// in the first row, and where that is 0, the one where the last that is not 0 of x, y, z, w is
  /// > 0.
  bool have_quaternions = false;
  /// Is there each frame as a matrix, too? Its columns are the vectors of the frame and r, with (0,
  /// 0, 0, 1) below; its rows follow one another.
  bool have_matrices = false;
  /// Of the quaternions and matrices of exact_mtf and mtf: those of the body whose tangent axis
  /// this is.
  TangentAxis body = {};
  /// Are the quaternions those of a camera that looks along e₁, with f₂ up? They turn i, j, k into
  /// f₃, f₂, −e₁ then.
  bool are_cameras = false;
  /// With how many digits the table has all numbers as decimals, too; 0 for none.
  long digits = 0;
};

/// Numbers with a name for each column; all of them correctly rounded. NaN is an empty cell.
struct FrameTable {
  std::vector<std::string> columns;       ///< their names: "t", "x", "y", "z", "e1x", …
  std::vector<std::vector<double>> rows;  ///< as long as columns
  std::string format = "frames/1";        ///< as JSON names it
  std::size_t incomplete_rows = 0;        ///< so many have empty cells
  std::string first_reason = {};          ///< why the first of these has
  std::optional<Nearness> near = {};      ///< of the path, where it stands for what is no PH path
  /// Where a rotation-minimizing frame that is in it starts.
  std::optional<FrameStart> start = {};
  std::optional<Vector<Rational>> up = {};  ///< v of the frame up that is in it, or of the start
  /// The same numbers as decimals, where they are asked for: "" is an empty cell.
  std::vector<std::vector<std::string>> decimals = {};
};

/// t, r, e₁, the frames and the scalars asked for, at each place of a path of any kind: correctly
/// rounded values at t itself, not at the t that is shown. The rotation-minimizing frame is found
/// by this angle; where it starts at one, that is to the frame that the angle is measured from. The
/// frame up is that of the v of the angle. What is not continuous at a joint, (n, b) and the
/// scalars but s, is that of the segment named. Where a Frenet frame, a torsion or an arc length is
/// undefined, at the pole of a curvature or torsion, and where a segment that is no PH curve has no
/// Euler–Rodrigues frame, cells are left empty if they may be, or DomainError is thrown. Throws
/// InputError where a number is too large for a double, Undecided where a component of the
/// rotation-minimizing frame at an irrational t is half way between two, and where any number is
/// too near to that for the limit of round_to_double(), DomainError as start_angle(), and for a
/// frame of minimal twist that is not given.
PHRAME_API FrameTable frame_table(const PathAngle& angle, const TableColumns& columns,
                                  const std::vector<Place>& at);

class FrameRows;
/// The table of all of these rows.
PHRAME_API FrameTable frame_table(FrameRows& rows);

/// The same of a PH curve, by the angle to its Euler–Rodrigues frame.
PHRAME_API FrameTable frame_table(const Curve& curve, const TableColumns& columns,
                                  const std::vector<RealAlgebraic>& at);

/// The same with frames only, at rational t.
PHRAME_API FrameTable frame_table(const Curve& curve, const std::vector<TabulatedFrame>& frames,
                                  const std::vector<Rational>& at);

/// Appends these numbers, one a row, rounded as the others are; not where there is a column of this
/// name.
PHRAME_API void add_column(FrameTable& table, const std::string& name,
                           const std::vector<Real>& numbers, long digits = 0);
/// What the columns are called: "t", "x", "y", "z", "e1x", …
PHRAME_API std::vector<std::string> names_of(const TableColumns& columns);

}  // namespace phrame
