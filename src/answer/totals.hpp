#pragma once
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/frame/path_totals.hpp"

namespace phrame {

/// What does a path gather from its start to its end?
struct TotalsQuery {
  long digits = 17;  ///< of all values
};

/// What a path gathers.
enum class Quantity {
  length,          ///< ∫ ds
  erf_twist,       ///< ∫ 2h/σ dt
  torsion,         ///< ∫ τ ds
  curvature,       ///< ∫ κ ds
  rotation_index,  ///< ∫ |κ| ds/2π of a plane path
  bending_energy,  ///< ∫ κ² ds
  frenet_energy,   ///< ∫ (κ² + τ²) ds
};

/// "twist of the ERF".
const char* name_of(Quantity quantity);

/// All totals of a path.
struct TotalsAnswer {
  /// One of them.
  struct Row {
    Quantity quantity;                                ///< which one
    std::optional<PathTotal> total = std::nullopt;    ///< in closed form
    std::optional<Decimal> value = std::nullopt;      ///< no value where it is infinite
    std::optional<Infinite> infinite = std::nullopt;  ///< the pole, then
    std::string reason = {};                          ///< why there is neither
  };
  NamedPath path;         ///< as asked
  std::vector<Row> rows;  ///< of all quantities, in their order
  long digits;            ///< of the values
};

/// Throws Undecided, naming the quantity, where one cannot be rounded.
TotalsAnswer answer(const NamedPath& path, const TotalsQuery& query);

}  // namespace phrame
