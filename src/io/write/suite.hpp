#pragma once
#include <string>

#include "phrame/answer/suite.hpp"

namespace phrame::inline v0 {

/// A row for each group of curves; and the curves that fail, the worst first.
std::string to_text(const SuiteAnswer& answer);
std::string to_json(const SuiteAnswer& answer);   ///< suite/1
std::string to_latex(const SuiteAnswer& answer);  ///< a tabular with a row for each group
std::string to_html(const SuiteAnswer& answer);   ///< a table element with the same rows
/// A badge in SVG: of how many curves of the collection of this version the frames pass, and the
/// largest error.
std::string to_badge(const SuiteAnswer& answer);

/// A row for each step.
std::string to_text(const OrderAnswer& answer);
std::string to_json(const OrderAnswer& answer);   ///< order/1
std::string to_latex(const OrderAnswer& answer);  ///< a tabular
std::string to_html(const OrderAnswer& answer);   ///< a table element

}  // namespace phrame
