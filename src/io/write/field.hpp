#pragma once
#include <functional>

#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/prose.hpp"

namespace phrame::inline v0 {

// An answer is described once, as a list of fields, and written from it as a text, as JSON and as
// LaTeX. In words, which is in a text and in LaTeX, labels and values are as prose() has them. Not
// a public header: it shows nlohmann's types.

// What values are in words.

std::string in_words(const Rational& x, Notation notation);
std::string in_words(const Polynomial& p, Notation notation);
std::string in_words(const GaussianPolynomial& p, Notation notation);
std::string in_words(const Vector<Rational>& v, Notation notation);
/// In LaTeX with a sign that it is rounded: "$\approx 0.125$".
std::string in_words(const Decimal& x, Notation notation);
/// As shown(): an irrational one is cut off, "0.707106781187…".
std::string in_words(const RealAlgebraic& x, Notation notation);

/// A bound from above of two digits: "6.9e-17".
std::string upper_bound_words(const Rational& x, Notation notation);

/// A polynomial that is factored in words, not in JSON.
struct Factored {
  Polynomial p;
};
std::string in_words(const Factored& x, Notation notation);
JsonOutput json_of(const Factored& x);

JsonOutput json_of(const Rational& x);

/// What a field says. The functions are called where it is written, so that nothing is written in
/// vain; what they refer to must still be there.
class Value {
 public:
  using Words = std::function<std::string(Notation)>;
  using Rows = std::function<std::vector<std::string>(Notation)>;
  using Json = std::function<JsonOutput()>;

  Value() = default;
  Value(const Words& words, Json json)
      : Value(Rows([words](Notation notation) { return std::vector{words(notation)}; }),
              std::move(json)) {}
  /// Words for several rows with the same label, or for none.
  Value(Rows rows, Json json) : rows_(std::move(rows)), json_(std::move(json)) {}
  /// x, which has in_words() and json_of().
  template <class T>
  Value(const T& x)  // NOLINT(google-explicit-constructor)
      : Value(Words([x](Notation notation) { return in_words(x, notation); }),
              [x] { return json_of(x); }) {}

  std::vector<std::string> rows(Notation notation) const { return rows_(notation); }
  JsonOutput json() const { return json_(); }
  bool has_json() const { return json_ != nullptr; }

 private:
  Rows rows_;
  Json json_;
};

struct Field {
  std::string key;    ///< in JSON; empty where JSON does not have it
  std::string label;  ///< in words; empty where text and LaTeX do not have it
  Value value;
  std::vector<Field> parts = {};  ///< rows in words; without a value an object in JSON
};
using Fields = std::vector<Field>;

/// What is in JSON only.
Field json_field(const std::string& key, const JsonOutput& value);
/// What is an object in JSON, in words a row for each part.
Field object_field(const std::string& key, Fields parts);
/// The preimage, u, v, p and q.
Field preimage_field(const QuaternionPolynomial& a);
/// The field in JSON only, and in words only: for one that stands there in another place.
Field in_json(Field field);
Field out_of_json(Field field);

/// A question, with what it is asked of in JSON beside the answer; in words "yes: " or "no: " and
/// its parts, each with its label before it.
Value yes_or_no(bool answer, const Fields& parts = {});

/// The rows in words, those of parts in the place of their field.
struct LabelledRow {
  std::string label;
  std::string words;
};
std::vector<LabelledRow> rows(const Fields& fields, Notation notation);

/// "  label      value", a line for each row.
std::string to_rows(const Fields& fields, std::size_t width);
/// An object.
JsonOutput json_of(const Fields& fields);
/// \begin{align*} … \end{align*}, a line for each row.
std::string to_align(const Fields& fields);

}  // namespace phrame
