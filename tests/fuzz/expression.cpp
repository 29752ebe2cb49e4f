// Any bytes: a rational function or an end of a path, or an InputError of one line with a column.
// What is read is read again from the text that phrame prints, once the products have their sign.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/endpoint.hpp"
#include "phrame/io/write/endpoint_text.hpp"
#include "phrame/io/write/text.hpp"

namespace {

using namespace phrame;

void require(bool holds) {
  if (!holds) std::abort();
}

void require_place(const InputError& error) {
  require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  require(error.place().starts_with("column "));
}

std::string with_product_signs(std::string text, const std::string& variable) {
  for (std::size_t at = text.find(variable); at != std::string::npos;
       at = text.find(variable, at + variable.size() + 1))
    if (at > 0 && text[at - 1] != ' ' && !text.substr(0, at).ends_with("−")) text.insert(at, "*");
  return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  const ExpressionLimits limits{1000, {40, 2000}};
  try {
    const Expression f = parse_expression(text, std::nullopt, limits);
    const std::string variable = f.variable.empty() ? "t" : f.variable;
    const auto part = [&](const Polynomial& p) {
      return "(" + with_product_signs(formatted(p, Notation::unicode, variable), variable) + ")";
    };
    const std::string printed = part(f.value.numerator()) + "/" + part(f.value.denominator());
    require(parse_expression(printed, variable).value == f.value);
  } catch (const InputError& error) {
    require_place(error);
  }
  try {
    to_text(parse_endpoint(text, limits));
  } catch (const InputError& error) {
    require_place(error);
  }
  return 0;
}
