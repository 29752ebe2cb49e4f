#include "paths.hpp"

// Segments: (turned over, X₁, X₂, X₃, W), (u, v, p, q, f, r(0)) of a PH curve and (turned over,
// from, to, variable, x, y, z) of formulas.
namespace phrame::inline v0::python {
namespace {

nb::object packed(const Formula& f) {
  nb::list steps;
  for (const Formula::Step& step : f.steps())
    steps.append(nb::make_tuple(static_cast<int>(step.operation), step.left, step.right,
                                to_python(step.number), to_python(step.pi_multiple)));
  return nb::tuple(steps);
}

Formula unpacked_formula(nb::handle packed) {
  std::vector<Formula::Step> steps;
  for (const nb::handle item : nb::list(packed))
    steps.push_back({static_cast<Formula::Operation>(nb::cast<int>(item[0])),
                     nb::cast<std::size_t>(item[1]), nb::cast<std::size_t>(item[2]),
                     rational(item[3], "number"), rational(item[4], "pi_multiple")});
  return Formula(std::move(steps));
}

nb::object packed(const RationalCurve& curve, VariableName) {
  const auto& [x, y, z] = curve.numerator();
  const bool is_turned = RationalCurve(curve.numerator(), curve.weight()) != curve;
  return nb::make_tuple(is_turned, to_python(x.coefficients()), to_python(y.coefficients()),
                        to_python(z.coefficients()), to_python(curve.weight().coefficients()));
}

nb::object packed(const ExpressionCurve& curve, VariableName variable) {
  const auto& [x, y, z] = curve.position();
  const std::string letter = variable == VariableName::kept ? curve.variable() : "";
  return nb::make_tuple(curve.orientation() < 0, packed(curve.from()), packed(curve.to()),
                        nb::str(letter.c_str()), packed(x), packed(y), packed(z));
}

nb::object packed(const PhSegment& segment, VariableName) {
  const Curve& curve = segment.curve();
  const auto& [u, v, p, q] = curve.preimage();
  if (!curve.is_polynomial()) {
    const Vector<Polynomial> X = numerator(curve);
    return nb::make_tuple(to_python(u.coefficients()), to_python(v.coefficients()),
                          to_python(p.coefficients()), to_python(q.coefficients()),
                          to_python(curve.multiplier().coefficients()),
                          to_python(X[0].coefficients()), to_python(X[1].coefficients()),
                          to_python(X[2].coefficients()), to_python(curve.weight().coefficients()));
  }
  return nb::make_tuple(to_python(u.coefficients()), to_python(v.coefficients()),
                        to_python(p.coefficients()), to_python(q.coefficients()),
                        to_python(curve.multiplier().coefficients()), to_python(curve.start()));
}

Segment unpacked(nb::handle packed) {
  const bool is_rational_ph = nb::len(packed) == 9;
  if (nb::len(packed) == 6 || is_rational_ph) {
    QuaternionPolynomial a{polynomial(packed[0], "u"), polynomial(packed[1], "v"),
                           polynomial(packed[2], "p"), polynomial(packed[3], "q")};
    Polynomial f = polynomial(packed[4], "f");
    if (!is_rational_ph)
      return PhSegment(Curve(std::move(a), std::move(f), vector(packed[5], "start")));
    return PhSegment(Curve::quotient(
        std::move(a), std::move(f),
        {polynomial(packed[5], "x"), polynomial(packed[6], "y"), polynomial(packed[7], "z")},
        polynomial(packed[8], "w")));
  }
  const auto made = [&]() -> Segment {
    if (nb::len(packed) == 5)
      return RationalCurve(
          {polynomial(packed[1], "x"), polynomial(packed[2], "y"), polynomial(packed[3], "z")},
          polynomial(packed[4], "w"));
    return ExpressionCurve(
        {unpacked_formula(packed[4]), unpacked_formula(packed[5]), unpacked_formula(packed[6])},
        unpacked_formula(packed[1]), unpacked_formula(packed[2]), nb::cast<std::string>(packed[3]));
  }();
  return nb::cast<bool>(packed[0]) ? turned_over(made) : made;
}

}  // namespace

nb::object packed_path(const Path& path, VariableName variable) {
  nb::list list;
  for (const Segment& segment : path.segments())
    list.append(std::visit([&](const auto& curve) { return packed(curve, variable); }, segment));
  return nb::tuple(list);
}

nb::object packed_frame(const FrameThrough& frame) {
  nb::list joints;
  for (const auto& [joint, f2, turns] : frame.joints)
    joints.append(nb::make_tuple(joint, to_python(f2), turns));
  return nb::make_tuple(nb::tuple(joints), frame.is_smooth, nb::str(name_of(frame.axis).c_str()));
}

std::optional<FrameThrough> unpacked_frame(nb::handle packed) {
  if (packed.is_none()) return std::nullopt;
  FrameThrough frame{{}, nb::cast<bool>(packed[1]), tangent_axis(nb::cast<std::string>(packed[2]))};
  const nb::object joints = packed[0];
  for (const nb::handle joint : nb::list(nb::handle(joints)))
    frame.joints.push_back(
        {nb::cast<std::size_t>(joint[0]), vector(joint[1], "f2"), nb::cast<long>(joint[2])});
  return frame;
}

Path unpacked_path(nb::handle packed) {
  std::vector<Segment> segments;
  for (const nb::handle item : nb::list(packed)) segments.push_back(unpacked(item));
  return joined(std::move(segments));
}

nb::object packed_parameters(const NamedPath& named) {
  std::vector<Rational> joints;
  for (const Real& joint : named.parameters) {
    if (!joint.exact()) return nb::none();
    joints.push_back(*joint.exact());
  }
  return to_python(joints);
}

std::vector<Real> unpacked_parameters(nb::handle packed, const Path& path) {
  if (packed.is_none())
    return formula_parameters(std::get<ExpressionCurve>(path.segments().front()));
  const std::vector<Rational> joints = rationals(packed, "parameters");
  return {joints.begin(), joints.end()};
}

}  // namespace phrame::python
