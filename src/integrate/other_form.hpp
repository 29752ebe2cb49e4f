#pragma once
#include <variant>

#include "phrame/integrate/radicals.hpp"
#include "phrame/integrate/real_form.hpp"
#include "phrame/integrate/style.hpp"

namespace phrame {

/// An antiderivative in another style than with its logarithms, up to a constant.
using OtherForm = std::variant<std::monostate, TextbookForm, RealForm, RadicalForm>;

/// Throws DomainError as radical_form().
OtherForm other_form(const Antiderivative& F, Style style);

}  // namespace phrame
