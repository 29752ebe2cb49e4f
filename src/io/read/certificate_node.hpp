#pragma once
#include <fmt/format.h>

#include "phrame/algebra/polynomial.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/ph/curve/quaternion.hpp"
#include "phrame/ph/proof/statement.hpp"

namespace phrame::inline v0 {

// What all files of certificates are made of: the grammar of docs/certificate.md.

/// The greatest number of bits and the like.
inline constexpr long most_certificate_count = 1'000'000;

/// A JSON number, an integer in {least, …, largest}.
long read_count(const JsonNode& node, long least, long largest);

/// read(item) for each item of an array.
template <class Read>
auto read_list(const JsonNode& node, Read read) {
  node.require(JsonNode::Kind::array, "an array");
  std::vector<decltype(read(node))> list;
  for (std::size_t k = 0; k < node.size(); ++k) list.push_back(read(node.item(k)));
  return list;
}

/// Three numbers, each as read(item) has it.
template <class Read>
Vector<Rational> read_vector(const JsonNode& node, Read read) {
  const auto list = read_list(node, read);
  if (list.size() != 3) node.fail(fmt::format("3 numbers are wanted, not {}", list.size()));
  return {list[0], list[1], list[2]};
}

/// At most so many coefficients, likewise.
template <class Read>
Polynomial read_coefficients(const JsonNode& node, long most, Read read) {
  node.require(JsonNode::Kind::array, "an array of coefficients");
  if (static_cast<long>(node.size()) > most)
    node.fail(fmt::format("{} coefficients are more than {}", node.size(), most));
  return Polynomial(read_list(node, read));
}

/// An integer or a fraction.
Rational read_exact(const JsonNode& node);
/// A decimal number as it is written.
std::string read_decimal(const JsonNode& node);
/// The same of one without a sign.
std::string read_radius(const JsonNode& node);

/// The bits of the longest of the least common denominator d and the coefficients of d·p.
long written_bits(const Polynomial& p);

/// What may be checked, in units of docs/certificate.md.
class WorkLimit {
 public:
  WorkLimit(std::size_t bytes, bool is_limited);

  /// Of a part of the file. Throws InputError there for what is beyond.
  void add(const JsonNode& part, const Integer& work);

 private:
  bool is_limited_;
  Integer most_;
  Integer work_ = 0;
};

}  // namespace phrame
