#include "phrame/io/read/feedrate.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/expression.hpp"
#include "phrame/io/read/expression_token.hpp"
#include "phrame/io/read/number.hpp"

namespace phrame::inline v0 {

Feedrate parse_feedrate(std::string_view text) {
  ExpressionLimits limits;
  limits.size.max_bits = most_number_bits;
  const auto [speed, variable] = parse_expression(text, std::nullopt, limits);
  if (variable.empty() || variable == "s") return {speed, Feedrate::Of::arc_length};
  if (variable == "t") return {speed, Feedrate::Of::parameter};
  if (variable == "kappa" || variable == "κ") return {speed, Feedrate::Of::curvature};
  throw InputError(in_quotes(variable) +
                   " is not one of s (arc length), t (parameter), kappa (curvature)");
}

}  // namespace phrame
