#include "phrame/io/read/npy_header.hpp"

#include <fmt/format.h>

#include <charconv>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {
namespace {

[[noreturn]] void fail_in_header(const std::string& reason) { throw InputError("header", reason); }

class LiteralReader {
 public:
  explicit LiteralReader(std::string_view text) : rest_(text) {}

  /// Blanks, and then c?
  bool take(char c) {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\n'))
      rest_.remove_prefix(1);
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void want(char c) {
    if (!take(c))
      fail_in_header(fmt::format("\"{}\" is wanted before \"{}\"", c, abbreviated(rest_)));
  }
  bool is_done() {
    take('\n');
    return rest_.empty();
  }

  PythonLiteral read(int depth = 0) {
    if (depth > 4) fail_in_header("is nested too deeply");
    for (const char open : {'(', '['})
      if (take(open)) return sequence(open, depth);
    for (const char quote : {'\'', '"'})
      if (take(quote)) return text(quote);
    for (const std::string_view word : {"True", "False"})
      if (rest_.starts_with(word)) {
        rest_.remove_prefix(word.size());
        return {PythonLiteral::Kind::truth, std::string(word)};
      }
    return number();
  }

 private:
  PythonLiteral sequence(char open, int depth) {
    PythonLiteral result{PythonLiteral::Kind::sequence, {open}};
    const char close = open == '(' ? ')' : ']';
    while (!take(close)) {
      result.items.push_back(read(depth + 1));
      if (take(',')) continue;
      want(close);
      break;
    }
    return result;
  }

  PythonLiteral text(char quote) {
    PythonLiteral result{PythonLiteral::Kind::text};
    for (;;) {
      if (rest_.empty()) fail_in_header("a string does not end");
      const char c = rest_.front();
      rest_.remove_prefix(1);
      if (c == quote) return result;
      if (c == '\\')
        fail_in_header(fmt::format("the name \"{}\\…\" has a backslash", abbreviated(result.text)));
      result.text += c;
    }
  }

  PythonLiteral number() {
    PythonLiteral result{PythonLiteral::Kind::number};
    const char* const end = rest_.data() + rest_.size();
    const auto [next, error] = std::from_chars(rest_.data(), end, result.number);
    if (error != std::errc())
      fail_in_header(fmt::format("\"{}\" is not a number or a name", abbreviated(rest_)));
    rest_.remove_prefix(static_cast<std::size_t>(next - rest_.data()));
    take('L');  // as Python 2 wrote them
    return result;
  }

  std::string_view rest_;
};

}  // namespace

NpyHeader read_npy_header(std::string_view text) {
  LiteralReader in(text);
  NpyHeader header;
  bool has_descr = false;
  bool has_shape = false;
  bool has_order = false;
  in.want('{');
  while (!in.take('}')) {
    const PythonLiteral key = in.read();
    in.want(':');
    const PythonLiteral value = in.read();
    if (key.text == "descr") {
      header.descr = value;
      has_descr = true;
    } else if (key.text == "fortran_order" && value.kind == PythonLiteral::Kind::truth) {
      header.is_fortran = value.text == "True";
      has_order = true;
    } else if (key.text == "shape" && value.kind == PythonLiteral::Kind::sequence) {
      header.shape.clear();
      for (const PythonLiteral& size : value.items) {
        if (size.kind != PythonLiteral::Kind::number)
          fail_in_header("shape is not made of numbers");
        header.shape.push_back(size.number);
      }
      has_shape = true;
    } else {
      fail_in_header(fmt::format("\"{}\" is not understood", abbreviated(key.text)));
    }
    if (!in.take(',')) {
      in.want('}');
      break;
    }
  }
  if (!in.is_done() || !has_descr || !has_shape || !has_order)
    fail_in_header("descr, fortran_order and shape are wanted, and nothing else");
  return header;
}

}  // namespace phrame
