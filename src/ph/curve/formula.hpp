#pragma once
#include <string>
#include <vector>

#include "phrame/algebra/rational.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// The largest numerator and denominator of an exponent.
inline constexpr long max_exponent = 1'000'000;

/// A function of one real variable, as people write it: of fractions, π and the variable by + − ·
/// /, powers, and sin, cos, exp, log, sqrt and atan. It is a list of steps, each of which applies
/// an operation to the values of earlier ones; the last value is that of the function.
class PHRAME_API Formula {
 public:
  /// What a step does to the values of the earlier steps `left` and `right`.
  enum class Operation {
    number,    ///< number + pi_multiple·π
    variable,  ///< the variable
    add,       ///< left + right
    multiply,  ///< left · right
    divide,    ///< left/right
    power,     ///< left to the power `number`; of a negative left where that is an integer
    sin,       ///< sin left
    cos,       ///< cos left
    exp,       ///< exp left
    log,       ///< the natural logarithm of left > 0
    sqrt,      ///< √left, left > 0
    atan,      ///< arctan left, in (−π/2, π/2)
  };
  /// One value.
  struct Step {
    Operation operation = Operation::number;  ///< how it is found
    std::size_t left = 0;                     ///< the first operand, an earlier step
    std::size_t right = 0;                    ///< the second one of two
    Rational number;                          ///< of a number, and the exponent of a power
    Rational pi_multiple;                     ///< of a number

    friend bool operator==(const Step&, const Step&) = default;
    friend std::strong_ordering operator<=>(const Step&, const Step&) = default;  ///< any order
  };

  /// number + pi_multiple·π.
  Formula(Rational number = 0,  // NOLINT(google-explicit-constructor)
          Rational pi_multiple = 0);
  static Formula variable();  ///< the variable itself
  /// Of at least one step, operands before what is made of them.
  explicit Formula(std::vector<Step> steps) : steps_(std::move(steps)) {}

  const std::vector<Step>& steps() const { return steps_; }  ///< at least one

  /// @{ The functions of these values. An operation that is undefined everywhere, as a division by
  /// the number 0, is found where the function is evaluated.
  friend PHRAME_API Formula operator+(const Formula& f, const Formula& g);
  friend PHRAME_API Formula operator-(const Formula& f, const Formula& g);
  friend PHRAME_API Formula operator*(const Formula& f, const Formula& g);
  friend PHRAME_API Formula operator/(const Formula& f, const Formula& g);
  friend PHRAME_API Formula operator-(const Formula& f);
  /// @}
  /// f to this power. Throws DomainError beyond max_exponent.
  friend PHRAME_API Formula power(const Formula& f, const Rational& exponent);
  /// @{ The functions of these values.
  friend PHRAME_API Formula sin(const Formula& f);
  friend PHRAME_API Formula cos(const Formula& f);
  friend PHRAME_API Formula tan(const Formula& f);  ///< sin/cos
  friend PHRAME_API Formula exp(const Formula& f);
  friend PHRAME_API Formula log(const Formula& f);
  friend PHRAME_API Formula sqrt(const Formula& f);
  friend PHRAME_API Formula atan(const Formula& f);
  /// @}

  friend bool operator==(const Formula&, const Formula&) = default;  ///< the same steps

 private:
  Formula(Operation operation, const Formula& left, const Rational& number = 0);
  Formula(Operation operation, Formula left, const Formula& right);

  std::vector<Step> steps_;
};

/// Does its value not depend on the variable, by its form?
PHRAME_API bool is_constant(const Formula& f);

/// "cos(2*s)*(2 + cos(3*s))", as curve files have it.
PHRAME_API std::string full_text(const Formula& f, const std::string& variable);
/// The same for messages: the middle is left out of what is longer than about 60 characters.
PHRAME_API std::string to_string(const Formula& f, const std::string& variable);
/// The same of each step, for messages that name a part.
PHRAME_API std::vector<std::string> step_texts(const std::vector<Formula::Step>& steps,
                                               const std::string& variable);

}  // namespace phrame
