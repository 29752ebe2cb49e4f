#pragma once
#include "phrame/export.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/other_form.hpp"
#include "phrame/integrate/path_end.hpp"
#include "phrame/integrate/pole_table.hpp"

namespace phrame::inline v0 {

/// The integral of a rational function, and its value from one end to another.
struct IntegralQuery {
  RationalFunction integrand;     ///< f
  std::string variable = "x";     ///< its letter
  Form form = Form::automatic;    ///< how logarithms are written
  Style style = Style::textbook;  ///< in which functions the antiderivative is written
  /// Where they are listed: so many poles with their residues, and more are counted.
  std::optional<long> most_poles = {};
  /// The ends of a definite integral.
  struct Ends {
    /// @{ In either order.
    PathEnd from;
    PathEnd to;
    /// @}
    AtPoles at_poles = AtPoles::refuse;  ///< what is done with poles between them
  };
  std::optional<Ends> ends = {};  ///< none for the antiderivative alone
  long digits = 17;               ///< of the value
};

/// A definite integral, rounded.
struct DefiniteValue {
  /// @{ As asked.
  PathEnd from;
  PathEnd to;
  /// @}
  bool principal_value = false;     ///< may there be poles between the ends?
  Decimal value;                    ///< correctly rounded
  std::optional<ExactValue> exact;  ///< where it is known in finite terms
};

/// An antiderivative, and the definite integral asked for.
struct IntegralAnswer {
  RationalFunction integrand;             ///< f
  std::string variable;                   ///< its letter
  Antiderivative antiderivative;          ///< F with F′ = f, checked
  OtherForm other;                        ///< F in the style asked for, if another than logarithms
  std::optional<PoleTable> poles;         ///< of what is a sum over poles
  std::optional<DefiniteValue> definite;  ///< where ends were given
  long digits;                            ///< of its value
};

/// Throws DomainError as radical_form() and path_integral(), Undecided where the value cannot be
/// rounded.
PHRAME_API IntegralAnswer answer(const IntegralQuery& query);

}  // namespace phrame
