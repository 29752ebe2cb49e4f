#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// Asks for integrals along a path from its start to its end, as its length.
struct TotalsQuery {
  long digits = 17;                               ///< of all values
  std::optional<NamedPath> other = std::nullopt;  ///< with which a closed path may be linked
  /// v × e₁ is what the turns of the normal of a closed path are counted from, where they are
  /// asked.
  std::optional<Vector<Rational>> helicity_about = std::nullopt;
};

/// Such an integral, and what else a closed path has.
enum class Quantity {
  length,          ///< ∫ ds
  erf_twist,       ///< ∫ 2h/σ dt
  torsion,         ///< ∫ τ ds
  curvature,       ///< ∫ κ ds
  rotation_index,  ///< ∫ |κ| ds/2π of a plane path
  bending_energy,  ///< ∫ κ² ds
  frenet_energy,   ///< ∫ (κ² + τ²) ds
  // Of a path that is not PH, instead of erf_twist:
  up_twist,  ///< ∫ e₂′·e₃ dt of the frame of v
  // Of a plane path:
  signed_rotation_index,  ///< ∫ κ ds/2π, κ > 0 to the left
  // Of a path that is closed with a continuous tangent:
  holonomy,      ///< by which angle in (−π, π] a rotation-minimizing frame comes back turned
  closing_turn,  ///< −holonomy/length
  writhe,        ///< Gauss's integral over the curve twice
  self_linking,  ///< writhe + ∫ τ ds/2π, whole
  linking,       ///< with the other closed path, whole
  helicity,      ///< turns of the signed normal about e₁, SignedFrenet::turns_about()
};

/// "twist of the ERF".
PHRAME_API const char* name_of(Quantity quantity);

/// All totals of a path.
struct TotalsAnswer {
  /// One of them.
  struct Row {
    Quantity quantity;                                ///< which one
    std::optional<PathTotal> total = std::nullopt;    ///< where it is a sum over the segments
    std::optional<Decimal> value = std::nullopt;      ///< no value where it is infinite
    std::optional<Infinite> infinite = std::nullopt;  ///< the pole, then
    std::string reason = {};                          ///< why there is neither
    std::optional<Rational> exact = std::nullopt;  ///< the value, where it is seen to be rational
  };
  NamedPath path;         ///< as asked
  std::vector<Row> rows;  ///< of all quantities that such a path has, in their order
  long digits;            ///< of the values
  /// v of up_twist, where the path is no PH path.
  std::optional<Vector<Rational>> up = std::nullopt;
};

/// Throws Undecided, naming the quantity, where one cannot be rounded. What is undecided about a
/// closed path, and what has no value along formulas, has its reason in its row instead.
PHRAME_API TotalsAnswer answer(const NamedPath& path, const TotalsQuery& query);

}  // namespace phrame
