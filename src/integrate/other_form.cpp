#include "phrame/integrate/other_form.hpp"

namespace phrame::inline v0 {

OtherForm other_form(const Antiderivative& F, Style style) {
  switch (style) {
    case Style::textbook:
      return textbook_form(F);
    case Style::real:
      return real_form(F);
    case Style::radicals:
      return radical_form(F);
    case Style::logarithms:
      break;
  }
  return {};
}

}  // namespace phrame
