#pragma once
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"

namespace phrame {

/// What `phrame compile` writes.
struct CHeader {
  std::string prefix;  ///< of all names in C
  std::string curve;   ///< its name, or that of the spline
  bool is_spline = false;
  Reference reference = Reference::erf;
  Angle start_angle;
  PiecewisePolynomial angle;                    ///< of plain_shape(1)
  std::optional<PiecewisePolynomial> rotation;  ///< of plain_shape(4)
};

/// C99, self-contained: prefix_theta(t), and with a rotation prefix_frame(t, f1, f2, f3), with what
/// they are, for which t and how exactly. It compiles as C++17 too.
std::string to_c_header(const CHeader& header);

/// A prefix made of the name of a curve: letters, digits and '_'; "curve" where nothing is left.
std::string prefix_from(const std::string& name);
/// Is it a name in C that is not reserved, and no longer than 60? (C++ reserves each with "__".)
bool is_prefix(const std::string& text);

}  // namespace phrame
