#pragma once
#include <variant>

#include "phrame/export.hpp"
#include "phrame/integrate/radicals.hpp"
#include "phrame/integrate/real_form.hpp"

namespace phrame::inline v0 {

/// How an antiderivative is written.
enum class Style {
  logarithms,  ///< as it is: sums of logarithms over roots
  textbook,    ///< in real functions, as far as that is short
  real,
  radicals,
};

/// An antiderivative in another style than with its logarithms, up to a constant.
using OtherForm = std::variant<std::monostate, TextbookForm, RealForm, RadicalForm>;

/// Throws DomainError as radical_form().
PHRAME_API OtherForm other_form(const Antiderivative& F, Style style);

}  // namespace phrame
