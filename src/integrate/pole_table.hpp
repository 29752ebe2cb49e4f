#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/ball.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/antiderivative.hpp"

namespace phrame::inline v0 {

/// The real or the imaginary part of a pole or residue.
struct PolePart {
  RealBall ball;  ///< more than 12 decimal digits are known, unless it contains 0
  /// Is it proved to be 0, or not to be? No value of 16384 bits tells one that is not.
  bool is_known;
};

/// A pole z of F′ and its residue c(z): a real one, or, with both signs of the imaginary parts, a
/// pair of conjugate ones.
struct PoleRow {
  /// @{ Of the pole, and of its residue.
  PolePart re;
  PolePart im;
  PolePart residue_re;
  PolePart residue_im;
  /// @}
};

/// Poles and residues of a derivative.
struct PoleTable {
  long poles = 0;             ///< of F′ that have a residue, conjugate ones counted both
  std::vector<PoleRow> rows;  ///< none where there are more than were to be listed
};

/// The poles of F′ and their residues. No value where a sum of F is not over its poles, and where
/// there are none. More than `most` are only counted.
PHRAME_API std::optional<PoleTable> pole_table(const Antiderivative& F, long most);

}  // namespace phrame
