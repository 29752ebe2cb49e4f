#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/io/read/expression_token.hpp"

namespace phrame {

/// Reads an expression by the precedence of its operators, with two stacks (Dijkstra's shunting
/// yard): nothing recurses, so that no depth of parentheses, signs or exponents is too much. Here
/// is the stack of operations that wait for their right operands; whoever derives from it has the
/// stack of operands, and is told what to do with the last of them as soon as it can be done.
class OperatorReader {
 protected:
  /// `operands` is what may begin one, for complaints: "a number or \"(\"". The variable is given,
  /// "" for none, or it is the first name that is taken for it.
  OperatorReader(std::string_view text, std::string_view operands,
                 const std::optional<std::string>& variable)
      : text_(text),
        operand_names_(operands),
        variable_(variable.value_or("")),
        variable_is_given_(variable.has_value()) {}
  virtual ~OperatorReader() = default;

  /// All of the text is one operand at last. Throws InputError.
  void read();

  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    throw InputError(column_of(text_, at), reason);
  }
  std::string_view text() const { return text_; }
  std::size_t at() const { return at_; }  ///< of the token that is read
  const std::string& variable() const { return variable_; }
  bool variable_is_given() const { return variable_is_given_; }
  /// Refuses a name that is not the variable, with this advice: where another one is given, and
  /// where another was there first.
  void take_variable(std::string_view name, const std::string& of_given = {},
                     const std::string& of_second = {});

  /// @{ An operand more. Of a name that is a function is said with its parenthesis.
  virtual void push_number(std::string_view number) = 0;
  virtual void push_name(std::string_view name) = 0;
  /// @}
  /// Of a name before a "(".
  virtual bool is_function(std::string_view) const { return false; }
  /// The last operand becomes its negative; its sign is at that byte.
  virtual void negate(std::size_t at) = 0;
  /// The last two become one: + - * / or ^.
  virtual void combine(char sign) = 0;
  /// The last one becomes a power, by what ends at that byte.
  virtual void raise(const Rational& exponent, std::size_t end) = 0;
  /// The last one is in parentheses, or the argument of the function.
  virtual void enclose(std::size_t begin, std::size_t end, std::string_view function) = 0;
  /// What is said where two operands have no operator between them.
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
