#pragma once
#include "phrame/integrate/path_end.hpp"
#include "phrame/integrate/radicals.hpp"
#include "phrame/integrate/real_form.hpp"

namespace phrame {

/// A definite integral, rounded.
struct DefiniteValue {
  PathEnd from;
  PathEnd to;
  bool principal_value = false;
  Decimal value;
  std::optional<ExactValue> exact;
};

/// What `phrame integrate` shows.
struct IntegralReport {
  RationalFunction integrand;
  std::string variable;  ///< its letter
  Antiderivative antiderivative;
  std::optional<RealForm> real = std::nullopt;          ///< shown instead of the antiderivative
  std::optional<RadicalForm> radicals = std::nullopt;   ///< likewise
  std::optional<TextbookForm> textbook = std::nullopt;  ///< likewise, but for JSON
  bool says_checked = true;  ///< is it said that the derivative was checked? (It always was.)
  std::optional<DefiniteValue> definite = std::nullopt;
  long digits = 0;               ///< of the value
  bool lists_all_poles = false;  ///< text only: however many they are
};

std::string to_text(const IntegralReport& report);   ///< for reading, Unicode
std::string to_latex(const IntegralReport& report);  ///< the closed form and the value
std::string to_json(const IntegralReport& report);   ///< integral/1

}  // namespace phrame
