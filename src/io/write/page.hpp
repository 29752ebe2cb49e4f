#pragma once
#include <string>

#include "phrame/answer/page.hpp"

namespace phrame::inline v0 {

/// An HTML file with all that it needs, to be opened in a browser, also where there is no network:
/// the curve with its frames in space, plots, the formula, poles, what is decided, numbers to take
/// along. Its numbers are those of the answer, correctly rounded. Throws DomainError where phrame
/// was built without npm, which the page's own program is bundled with.
std::string to_page(const PageAnswer& answer);

/// Whether to_page() can write one.
bool has_pages();

}  // namespace phrame
