#pragma once
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/json_node.hpp"

namespace phrame::inline v0 {

// What curve files are made of.

/// What turns lists of numbers into polynomials.
class CoefficientBasis {
 public:
  /// That at "basis".
  CoefficientBasis(const JsonNode& curve, const CurveLimits& limits);

  void require_list(const JsonNode& list) const;
  /// In the Bernstein basis a short list would silently mean another degree: an error.
  void require_equal_lengths(const JsonNode& parent, const std::vector<JsonNode>& lists) const;

  Polynomial polynomial(const std::vector<Rational>& coefficients) const;
  Polynomial polynomial(const JsonNode& list) const { return polynomial(list.numbers()); }

 private:
  CurveLimits limits_;
  bool bernstein_ = false;
};

/// Three numbers.
Vector<Rational> read_point(const JsonNode& node);
/// The components of a preimage, at "u", "v", "p" and "q".
QuaternionPolynomial read_components(const JsonNode& node, const CoefficientBasis& basis);
/// The text at "phrame".
std::string format_of(const JsonNode& node);
void require_format(const JsonNode& node, std::string_view wanted);
/// The keys of curve/1, all of them.
void require_curve_keys(const JsonNode& node);
/// Requires an object of the format curve/1 with known keys only.
void require_curve(const JsonNode& node);
/// The text at "name"; may be missing.
std::string read_name(const JsonNode& curve);
/// A curve that is given by its preimage.
NamedCurve read_preimage_curve(const JsonNode& node, const CurveLimits& limits);
/// The Bézier curve whose control points are `list`.
NamedHodograph read_bezier(const JsonNode& node, const JsonNode& list, const CurveLimits& limits);

}  // namespace phrame
