#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/io/read/expression_token.hpp"

namespace phrame::inline v0 {

/// Reads an expression by the precedence of its operators, with two stacks (Dijkstra's shunting
/// yard): nothing recurses, so that no depth of parentheses, signs or exponents is too much. Here
/// is the stack of operations that wait for their right operands. A derived class has the stack of
/// operands, whatever they are, and is called for each operation as soon as its operands are known.
class OperatorReader {
 public:
  virtual ~OperatorReader() = default;

 protected:
  /// `operands` is what may begin one, for messages: "a number or \"(\"". Without a given variable
  /// the first name that is taken for one is it; "" says that there is none.
  OperatorReader(std::string_view text, std::string_view operands,
                 const std::optional<std::string>& variable)
      : text_(text),
        operand_names_(operands),
        variable_(variable.value_or("")),
        variable_is_given_(variable.has_value()) {}

  /// All of the text is one operand at last. Throws InputError.
  void read();

  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    throw InputError(column_of(text_, at), reason);
  }
  std::string_view text() const { return text_; }
  std::size_t at() const { return at_; }  ///< of the token that is read
  const std::string& variable() const { return variable_; }
  bool variable_is_given() const { return variable_is_given_; }
  /// Refuses a name that is not the variable, with this advice: where another one was given, and
  /// where another one occurred first.
  void take_variable(std::string_view name, const std::string& of_given = {},
                     const std::string& of_second = {});

  /// @{ Puts an operand on the stack. A function is no operand: enclose() has its name.
  virtual void push_number(std::string_view number) = 0;
  virtual void push_name(std::string_view name) = 0;
  /// @}
  /// Is the name before a "(" that of a function?
  virtual bool is_function(std::string_view) const { return false; }
  /// Replaces the last operand by its negative; the sign is at this byte.
  virtual void negate(std::size_t at) = 0;
  /// Replaces the last two operands by one: their + - * / or ^.
  virtual void combine(char sign) = 0;
  /// Replaces the last operand by this power of it; the exponent ends at this byte.
  virtual void raise(const Rational& exponent, std::size_t end) = 0;
  /// The last operand is in parentheses at these bytes, the argument of the function if not empty.
  virtual void enclose(std::size_t begin, std::size_t end, std::string_view function) = 0;
  /// The message where two operands have no operator between them.
  virtual std::string missing_operator(std::string_view left, std::string_view right) const = 0;

 private:
  struct Operation {
    char sign;  ///< + - * / ^, '~' for the negative of one operand, '(' for a parenthesis
    std::size_t at;
    std::string_view function = {};  ///< of a parenthesis
  };

  std::size_t after_blanks(std::size_t at) const;
  Token read_operand(const Token& token);
  void read_operator(const Token& token);
  void read_raised_digits(std::string_view digits);
  void close_parenthesis();
  void reduce();

  std::string_view text_;
  std::string_view operand_names_;
  std::string variable_;
  bool variable_is_given_;
  std::size_t at_ = 0;
  std::string_view before_;
  bool operand_is_next_ = true;
  bool has_operand_ = false;
  std::vector<Operation> operations_;
};

}  // namespace phrame
