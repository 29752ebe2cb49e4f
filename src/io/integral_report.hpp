#pragma once
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/radicals.hpp"
#include "phrame/integrate/real_form.hpp"
#include "phrame/io/expression.hpp"

namespace phrame {

/// A definite integral, rounded.
struct DefiniteValue {
  Endpoint from;
  Endpoint to;
  bool principal_value = false;
  Decimal value;
  std::optional<ExactValue> exact;
};

/// What `phrame integrate` shows.
struct IntegralReport {
  Expression integrand;
  Antiderivative antiderivative;
  std::optional<RealForm> real = std::nullopt;         ///< shown instead of the antiderivative
  std::optional<RadicalForm> radicals = std::nullopt;  ///< likewise
  bool says_checked = true;  ///< is it said that the derivative was checked? (It always was.)
  bool is_automatic = true;  ///< nobody asked for this form of the logarithms
  std::optional<DefiniteValue> definite = std::nullopt;
  long digits = 0;               ///< of the value
  bool lists_all_poles = false;  ///< text only: however many they are
};

std::string to_text(const IntegralReport& report);   ///< for reading, Unicode
std::string to_latex(const IntegralReport& report);  ///< the closed form and the value
std::string to_json(const IntegralReport& report);   ///< integral/1

}  // namespace phrame
