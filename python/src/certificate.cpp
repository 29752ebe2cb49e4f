#include <algorithm>

#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

/// Of one curve, of a spline of PH curves, or of integrals along curves of other kinds.
struct CertificateObject {
  std::variant<Certificate, PathCertificate, IntegralCertificate> certificate;
  std::string name;
};

CertificateObject object_of(NamedAnyCertificate read) {
  return std::visit(
      [](auto& named) {
        return CertificateObject{std::move(named.certificate), std::move(named.name)};
      },
      read);
}

/// t, the value, the radius.
nb::object python_claim(const Rational& t, const std::string& value, const std::string& radius) {
  return nb::make_tuple(to_python(t), to_decimal(value), to_decimal(radius));
}

/// What is stated of values, true or not.
nb::list claims_of(const CertificateObject& self) {
  nb::list list;
  const auto add = [&](const std::vector<AngleClaim>& angles) {
    for (const AngleClaim& c : angles) list.append(python_claim(c.t, c.theta, c.radius));
  };
  if (const auto* c = std::get_if<IntegralCertificate>(&self.certificate)) {
    add(c->angles);
    for (const LengthClaim& l : c->lengths) list.append(python_claim(l.t, l.length, l.radius));
  } else if (const auto* path = std::get_if<PathCertificate>(&self.certificate)) {
    add(path->claims);
  } else {
    add(std::get<Certificate>(self.certificate).claims);
  }
  return list;
}

bool is_of_length(const CertificateObject& self) {
  const auto* c = std::get_if<IntegralCertificate>(&self.certificate);
  return c != nullptr && !c->frame;
}

std::string written(const CertificateObject& self, const std::string& name) {
  return std::visit([&](const auto& c) { return write_certificate(c, name); }, self.certificate);
}

std::vector<Statement> verified(const CertificateObject& self) {
  return without_gil([certificate = self.certificate] {
    return std::visit([](const auto& c) { return verify(c); }, certificate);
  });
}

nb::object certified_path(const CertificateObject& self) {
  if (const auto* one = std::get_if<Certificate>(&self.certificate))
    return wrap(NamedPhPath(self.name, one->curve));
  const auto* of_integral = std::get_if<IntegralCertificate>(&self.certificate);
  auto path = of_integral != nullptr ? path_of(*of_integral)
                                     : path_of(std::get<PathCertificate>(self.certificate));
  if (std::holds_alternative<std::string>(path))
    throw DomainError("curve: the segments of this certificate do not go on from one another");
  return wrap(NamedPath(self.name, std::get<Path>(std::move(path))));
}

}  // namespace

void bind_certificate(nb::module_& m, PathClass& path) {
  const auto certify_path = [](const PathObject& self, nb::handle at, nb::handle digits,
                               nb::handle frame, nb::handle up, Flag<"length"> length,
                               Flag<"holonomy"> holonomy,
                               Flag<"writhe"> writhe) -> CertificateObject {
    const Path along = self.named.path;
    const auto ts = at.is_none() ? std::vector{along.end()} : rationals(at, "at");
    const long n = count(digits, "digits", 1, 100'000);
    const bool is_about_closed = holonomy || writhe;
    const auto of_integral = [&](IntegralCertificate c) -> CertificateObject {
      return {with_canonical_formulas(std::move(c)), self.named.name};
    };
    if (length) {
      if (is_about_closed)
        refuse("length", "holonomy and writhe are not beside lengths", nb::bool_(true));
      if (!frame.is_none() || !up.is_none())
        refuse("length", "the length has no frame", nb::bool_(true));
      return of_integral(without_gil([&] { return certify_length(along, ts, n); }));
    }
    const auto ph = with_preimages(self.named);
    const bool is_to_erf = ph && up.is_none() && (frame.is_none() || text(frame, "frame") == "erf");
    const Reference reference =
        is_to_erf ? Reference::euler_rodrigues : reference_named(frame, "frame", self, up);
    const bool is_of_one = ph && ph->path.is_curve();
    if (is_about_closed && reference != Reference::euler_rodrigues)
      refuse(holonomy ? "holonomy" : "writhe",
             "this is of paths of PH curves, by the angle to the Euler-Rodrigues frame",
             nb::bool_(true));
    if (reference == Reference::up || (reference == Reference::frenet && !is_of_one)) {
      const PathAngle angle = reference == Reference::up
                                  ? angle_to_up(along, up)
                                  : without_gil([&] { return PathAngle(along, reference); });
      return of_integral(without_gil([&] { return certify(angle, ts, n); }));
    }
    return without_gil([&]() -> CertificateObject {
      if (is_of_one && !is_about_closed)
        return {certify(ph->path.segments().front(), reference, ts, n), self.named.name};
      return {certify(ph.value().path, ts, n, {holonomy, writhe}), self.named.name};
    });
  };
  path.def(
      "certify", certify_path, argument("at") = nb::none(), argument("digits") = 50,
      argument("frame") = nb::none(), argument("up") = nb::none(), argument("length") = false,
      argument("holonomy") = false, argument("writhe") = false,
      nb::sig("def certify(self, at: Numbers | None = None, digits: int = 50, "
              "frame: str | None = None, up: Vector | None = None, length: bool = False, "
              "holonomy: bool = False, writhe: bool = False) -> Certificate"),
      "Angles, by default the one at the end, with what proves them, and of one PH curve what "
      "kinds it is of; or lengths from the start. The frame is \"erf\" (default of PH curves, "
      "which alone have it), \"up\" (default of others), that of the vector `up`, or "
      "\"frenet\", but not of paths of several segments some of which are by formulas. Of a closed "
      "path of PH curves also the holonomy, and the writhe with all crossings that are seen along "
      "a "
      "vector.");
  auto type = nb::class_<CertificateObject>(m, "Certificate", "docs/certificate.md.");
  using C = CertificateObject;
  const auto from_json = [](const Text<"text">& text) {
    return object_of(read_any_certificate(text));
  };
  type.def_static(
          "from_json", from_json, argument("text"),
          nb::sig("def from_json(text: str) -> Certificate"),
          "Of a certificate/1, path-certificate/1 or integral-certificate/1 file, true or not.")
      .def(
          "json", [](const C& c) { return written(c, c.name); },
          "The certificate/1 file, of a spline of PH curves the path-certificate/1 file, of others "
          "and of lengths the integral-certificate/1 file.")
      .def_prop_ro(
          "curve", [](const C& c) { return certified_path(c); }, nb::sig("def curve(self) -> Path"),
          "Of which it is. Raises DomainError where segments of a spline do not go on from each "
          "other.")
      .def_prop_ro(
          "claims", [](const C& c) { return nb::tuple(claims_of(c)); },
          nb::sig("def claims(self) -> tuple[tuple[fractions.Fraction, decimal.Decimal, "
                  "decimal.Decimal], ...]"),
          "Angles or lengths as they are stated, true or not: (t, θ, radius), |θ(t) − θ| ≤ radius.")
      .def_prop_ro("is_of_length", &is_of_length, "Are the claims about lengths, not angles?")
      .def(
          "objections",
          [](const C& c) {
            std::vector<std::string> list;
            for (const Statement& statement : verified(c)) {
              if (statement.is_proved()) continue;
              const auto* what = std::get_if<std::string>(&statement.what);
              const auto* angle = std::get_if<AngleClaim>(&statement.what);
              list.push_back(
                  (what != nullptr ? *what
                   : angle != nullptr
                       ? "angle at " + to_string(angle->t)
                       : "length at " + to_string(std::get<LengthClaim>(statement.what).t)) +
                  ": " + statement.objection);
            }
            return list;
          },
          "Verifies every statement by another way: what is not proved, and why.")
      .def(
          "is_proved", [](const C& c) { return are_proved(verified(c)); },
          "Is every statement proved, by another way?")
      .def(
          "__eq__",
          [](const C& c, nb::handle other) {
            return nb::isinstance<C>(other) &&
                   c.certificate == nb::cast<const C&>(other).certificate;
          },
          nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__", [](const C& c) { return nb::hash(nb::str(written(c, "").c_str())); })
      .def("__repr__",
           [](const C& c) {
             const std::size_t n = nb::len(claims_of(c));
             const bool has_kind = std::holds_alternative<Certificate>(c.certificate);
             const bool is_spline = std::holds_alternative<PathCertificate>(c.certificate);
             return "<Certificate of " + std::to_string(n) +
                    (is_of_length(c) ? " length" : " angle") + (n == 1 ? "" : "s") +
                    (has_kind    ? " and the kind of the curve"
                     : is_spline ? " of a spline"
                                 : "") +
                    (c.name.empty() ? "" : " " + abbreviated(c.name)) + ">";
           })
      .def(
          "__reduce__",
          [](const C& c) {
            return remade("_certificate", nb::str(written(c, c.name).c_str()),
                          nb::str(c.name.c_str()));
          },
          PHRAME_REDUCE_SIG);
  m.def("_certificate", [](const std::string& text, const std::string& name) {
    CertificateObject object = object_of(read_any_certificate(text, {.is_limited = false}));
    object.name = name;
    return object;
  });
  bind_python(type, "_repr_html_", "phrame._show", "certificate_html",
              "def _repr_html_(self) -> str");
  bind_copies(type);
}

}  // namespace phrame::python
