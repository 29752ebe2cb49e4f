#pragma once
#include <string>
#include <string_view>

#include "phrame/export.hpp"

namespace phrame::inline v0 {

// A text for reading has passages in two lengths: all of it, and what a screen line can bear. Such
// a text is made of strings as any other; who prints it chooses between the two with for_reading().
// In between both are there, among control characters, which names and numbers never have.

/// A passage. In neither length is there another passage.
PHRAME_API std::string passage(std::string_view full, std::string_view abridged);
/// A text with its passages in full, or abridged and with a last line that says how to see them.
PHRAME_API std::string for_reading(std::string_view text, bool in_full);
/// A text with its passages abridged.
PHRAME_API std::string abridged(std::string_view text);

/// The number of characters, where one code point is one character; of the abridged text.
PHRAME_API std::size_t text_width(std::string_view text);

}  // namespace phrame
