#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/ph/construct/near.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame::inline v0 {

/// Whether a curve is PH, and its preimage.
struct IdentificationAnswer {
  /// The PH curve that was found near a curve that is not PH.
  struct Near {
    Rational epsilon;                        ///< as asked
    std::variant<NearCurve, NotNear> found;  ///< the PH curve, or how far away the nearest one is
  };

  std::string name;                            ///< of the curve
  std::variant<Curve, NotPythagorean> result;  ///< the PH curve, or why the curve is not PH
  std::optional<Near> near = std::nullopt;     ///< where it was asked for
  /// A hint where no ε was given and a PH curve is near.
  std::optional<NearSuggestion> suggestion = std::nullopt;
  bool is_rational = false;  ///< is it a rational curve, of which W²r′ = f · A i A* is asked for?
};

/// A PH spline: the given one, or the one that stands for a spline that is not PH.
struct PathIdentification {
  NamedPhPath path;  ///< the spline
};

/// Identifies the curve. Where it is not PH and ε is given, a PH curve at most ε away is looked
/// for. Throws as identify().
PHRAME_API IdentificationAnswer answer(const NamedHodograph& query,
                                       const std::optional<Rational>& epsilon = std::nullopt);
/// The same of a rational curve, near which none is looked for.
PHRAME_API IdentificationAnswer answer(const NamedRationalCurve& query);

}  // namespace phrame
