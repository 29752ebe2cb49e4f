#pragma once
#include <string>
#include <string_view>

#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// Numbers and letters with blanks or commas between them, or nothing, as in the attributes of SVG.
/// Refers to the text.
class SvgNumbers {
 public:
  /// The text from there on; what is before counts for places only.
  SvgNumbers(std::string_view text, std::size_t begin);

  bool at_end() const { return at_ == text_.size(); }
  bool is_at_number() const;
  /// A number, exactly; throws InputError where there is none.
  Rational number();
  /// 0 or 1, with nothing behind it, perhaps.
  bool flag();
  /// The letter, where it is one of these; else 0.
  char take_letter(std::string_view letters);
  /// A word of letters; may be empty.
  std::string_view take_word();
  /// Is there this character? Takes it, if so.
  bool take(char c);

  /// "line:column" of what is next. Costs what is between this call and the last.
  std::string place();
  /// Throws InputError with the place and with what is there instead.
  [[noreturn]] void fail(const std::string& expected);

 private:
  void skip();

  std::string_view text_;
  std::size_t at_;
  std::size_t counted_ = 0;  ///< the bytes that line_ and line_begin_ take into account
  long line_ = 1;
  std::size_t line_begin_ = 0;
};

}  // namespace phrame
