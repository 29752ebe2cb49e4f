#include "phrame/io/write/heading.hpp"

#include <fmt/format.h>

#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/corner.hpp"

namespace phrame::inline v0 {
namespace {

std::string closure_text(const Path& path) {
  const Closure closure = phrame::closure(path);
  if (!closure.ends_meet) return "open or closed: undecided";
  if (!*closure.ends_meet) return "open";
  if (!closure.is_closed) return "its ends meet, perhaps with their tangents: undecided";
  if (*closure.is_closed) return "closed";
  return path.ends_turned_over() ? "its ends meet, e₁ being the opposite: an odd number of cusps"
                                 : "its ends meet, where the tangent turns back";
}

/// ", with 6 corners of at most 1.57 radians"; empty where there is none.
std::string corners_text(const Path& path) {
  const auto corners = phrame::corners(path);
  if (corners.empty()) return "";
  return fmt::format(", with {} of {}{:.3g} radians", counted(corners.size(), "corner"),
                     corners.size() > 1 ? "at most " : "",
                     approximate(greatest(corners).angle.enclose(64)));
}

}  // namespace

std::string heading(const std::string& name, const Curve& curve) {
  const long n = degree(curve);
  const std::string kind = !curve.is_polynomial() ? "rational PH curve"
                           : n == 1               ? "line segment"
                           : n == 3               ? "PH cubic"
                           : n == 5               ? "PH quintic"
                           : n == 7               ? "PH septic"
                                                  : "PH curve";
  return fmt::format("{}{}, degree {} (preimage of degree {})", name_prefix(name), kind, n,
                     preimage_degree(curve));
}

std::string kind_of(const Segment& segment) {
  const RationalCurve* curve = rational_curve(segment);
  if (curve == nullptr) return "curve by formulas";
  return fmt::format("{} curve of degree {}",
                     curve->weight().is_constant() ? "polynomial" : "rational", degree(*curve));
}

std::string heading(const NamedPath& named, bool finds_ph) {
  const auto& segments = named.path.segments();
  const bool is_ph = named.path.is_ph();
  if (is_ph && segments.size() == 1) return heading(named.name, *ph_curve(segments.front()));
  const std::string kind =
      is_ph                 ? "PH spline of " + counted(segments.size(), "segment")
      : segments.size() > 1 ? fmt::format("path of {}", counted(segments.size(), "curve"))
      : finds_ph && named.path.with_preimages()
          ? fmt::format("rational PH curve of degree {}", degree(*rational_curve(segments.front())))
      : std::holds_alternative<ExpressionCurve>(segments.front())
          ? kind_of(segments.front()) + ", along which t runs from 0 to 1"
          : kind_of(segments.front());
  return fmt::format("{}{}, {}{}", name_prefix(named.name), kind, closure_text(named.path),
                     corners_text(named.path));
}

std::string note_on_sign(const Curve& curve) {
  const Signs signs = multiplier_signs(curve);
  if (!signs.negative) return "";
  return fmt::format("$f < 0$ {} $[0, 1]$: there $e₁ = A i A*/σ$ is $−r′/|r′|$",
                     signs.positive ? "in a part of" : "on");
}

std::string notes_on_signs(const PhPath& path, Notation notation) {
  std::string text;
  for (std::size_t k = 0; k < path.segments().size(); ++k)
    if (const std::string note = note_on_sign(path.segments()[k]); !note.empty())
      text += fmt::format("  segment {}: {}{}\n", k + 1, prose(note, notation),
                          notation == Notation::latex ? " \\\\" : "");
  return text.empty() ? "" : text + "\n";
}

}  // namespace phrame
