#pragma once
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/other_form.hpp"
#include "phrame/integrate/path_end.hpp"
#include "phrame/integrate/pole_table.hpp"

namespace phrame {

/// The integral of a rational function, and its value from one end to another.
struct IntegralQuery {
  RationalFunction integrand;
  std::string variable = "x";  ///< its letter
  Form form = Form::automatic;
  Style style = Style::textbook;
  /// Where they are listed: so many poles with their residues, and more are counted.
  std::optional<long> most_poles = {};
  struct Ends {
    PathEnd from;
    PathEnd to;
    AtPoles at_poles = AtPoles::refuse;
  };
  std::optional<Ends> ends = {};
  long digits = 17;  ///< of the value
};

/// A definite integral, rounded.
struct DefiniteValue {
  PathEnd from;
  PathEnd to;
  bool principal_value = false;
  Decimal value;
  std::optional<ExactValue> exact;
};

struct IntegralAnswer {
  RationalFunction integrand;
  std::string variable;
  Antiderivative antiderivative;
  OtherForm other;
  std::optional<PoleTable> poles;  ///< of what is a sum over poles
  std::optional<DefiniteValue> definite;
  long digits;
};

/// Throws DomainError as radical_form() and path_integral(), Undecided where the value cannot be
/// rounded.
IntegralAnswer answer(const IntegralQuery& query);

}  // namespace phrame
