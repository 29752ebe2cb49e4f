#include "phrame/io/write/passage.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

// A passage is begin, the full text, middle, the abridged text, end.
constexpr char passage_begin = '\x02';
constexpr char passage_middle = '\x1f';
constexpr char passage_end = '\x03';

std::string in_length(std::string_view text, bool full) {
  std::string read;
  for (;;) {
    const auto begin = text.find(passage_begin);
    read += text.substr(0, begin);
    if (begin == std::string_view::npos) return read;
    const auto middle = text.find(passage_middle, begin);
    const auto end = text.find(passage_end, middle);
    if (end == std::string_view::npos) throw DomainError("a text with half a passage");
    read += full ? text.substr(begin + 1, middle - begin - 1)
                 : text.substr(middle + 1, end - middle - 1);
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::string passage(std::string_view full, std::string_view abridged) {
  std::string text(1, passage_begin);
  text += full;
  text += passage_middle;
  text += abridged;
  return text += passage_end;
}

std::string for_reading(std::string_view text, bool in_full) {
  const bool has_passages = text.find(passage_begin) != std::string_view::npos;
  return in_length(text, in_full) +
         (has_passages && !in_full ? "\nLong parts are abridged (--full prints it all).\n" : "");
}

std::string abridged(std::string_view text) { return in_length(text, false); }

std::size_t text_width(std::string_view text) {
  std::size_t width = 0;
  bool counts = true;
  for (const char c : text) {
    if (c == passage_begin || c == passage_middle || c == passage_end)
      counts = c != passage_begin;
    else if (counts && (static_cast<unsigned char>(c) & 0xC0U) != 0x80U)
      ++width;  // a continuation byte of UTF-8 is no character
  }
  return width;
}

}  // namespace phrame
