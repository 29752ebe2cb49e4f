#include <algorithm>

#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

/// Of one curve, or of a spline of them.
struct CertificateObject {
  std::variant<Certificate, PathCertificate> certificate;
  std::string name;
};

CertificateObject object_of(std::variant<NamedCertificate, NamedPathCertificate> read) {
  return std::visit(
      [](auto& named) {
        return CertificateObject{std::move(named.certificate), std::move(named.name)};
      },
      read);
}

const std::vector<AngleClaim>& claims_of(const CertificateObject& self) {
  return std::visit(
      [](const auto& c) -> const auto& { return c.claims; }, self.certificate);
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
  auto path = path_of(std::get<PathCertificate>(self.certificate));
  if (std::holds_alternative<std::string>(path))
    throw DomainError("curve: the segments of this certificate do not go on from one another");
  return wrap(NamedPath(self.name, std::get<Path>(std::move(path))));
}

}  // namespace

void bind_certificate(nb::module_& m, PathClass& path) {
  const auto certify_path = [](const PathObject& self, nb::handle at, nb::handle digits,
                               const Text<"frame">& frame, Flag<"holonomy"> holonomy,
                               Flag<"writhe"> writhe) {
    const PhPath ph = with_preimages_of(self, "certify").path;
    const auto ts = at.is_none() ? std::vector{ph.end()} : rationals(at, "at");
    const long n = count(digits, "digits", 1, 100'000);
    const Reference reference = chosen<Reference>(
        frame, "frame", {{"erf", Reference::euler_rodrigues}, {"frenet", Reference::frenet}});
    if (!ph.is_curve() && reference == Reference::frenet)
      throw DomainError("frame: \"frenet\" is for single curves; this is a spline");
    const bool is_about_closed = holonomy || writhe;
    if (is_about_closed && reference == Reference::frenet)
      throw DomainError("frame: \"frenet\" does not go with holonomy and writhe");
    return without_gil([&]() -> CertificateObject {
      if (ph.is_curve() && !is_about_closed)
        return {certify(ph.segments().front(), reference, ts, n), self.named.name};
      return {certify(ph, ts, n, {holonomy, writhe}), self.named.name};
    });
  };
  path.def("certify", certify_path, argument("at") = nb::none(), argument("digits") = 50,
           argument("frame") = "erf", argument("holonomy") = false, argument("writhe") = false,
           nb::sig("def certify(self, at: Numbers | None = None, digits: int = 50, "
                   "frame: str = 'erf', holonomy: bool = False, writhe: bool = False) -> "
                   "Certificate"),
           "Angles, by default the one at the end, with what proves them, and of one PH curve what "
           "kinds it is of. Of a spline of PH curves without corners the angles are to the "
           "Euler-Rodrigues frame; of a closed path also the holonomy, and the writhe with all "
           "crossings that are seen along a vector. Curves may be polynomial or rational.");
  auto type = nb::class_<CertificateObject>(m, "Certificate", "docs/certificate.md.");
  using C = CertificateObject;
  const auto from_json = [](const Text<"text">& text) {
    return object_of(read_any_certificate(text));
  };
  type.def_static("from_json", from_json, argument("text"),
                  nb::sig("def from_json(text: str) -> Certificate"),
                  "Of a certificate/1 or path-certificate/1 file, true or not.")
      .def(
          "json", [](const C& c) { return written(c, c.name); },
          "The certificate/1 file, of a spline the path-certificate/1 file.")
      .def_prop_ro(
          "curve", [](const C& c) { return certified_path(c); }, nb::sig("def curve(self) -> Path"),
          "Of which it is. Raises DomainError where segments of a spline do not go on from each "
          "other.")
      .def_prop_ro(
          "claims",
          [](const C& c) {
            nb::list list;
            for (const AngleClaim& claim : claims_of(c))
              list.append(nb::make_tuple(to_python(claim.t), to_decimal(claim.theta),
                                         to_decimal(claim.radius)));
            return nb::tuple(list);
          },
          nb::sig("def claims(self) -> tuple[tuple[fractions.Fraction, decimal.Decimal, "
                  "decimal.Decimal], ...]"),
          "Angles as they are stated, true or not: (t, θ, radius), |θ(t) − θ| ≤ radius.")
      .def(
          "objections",
          [](const C& c) {
            std::vector<std::string> list;
            for (const Statement& statement : verified(c)) {
              if (statement.is_proved()) continue;
              const auto* what = std::get_if<std::string>(&statement.what);
              const auto* claim = std::get_if<AngleClaim>(&statement.what);
              list.push_back((what != nullptr ? *what : "angle at " + to_string(claim->t)) + ": " +
                             statement.objection);
            }
            return list;
          },
          "Verifies every statement by another way: what is not proved, and why.")
      .def(
          "is_proved",
          [](const C& c) {
            const auto found = verified(c);
            return std::all_of(found.begin(), found.end(),
                               [](const Statement& s) { return s.is_proved(); });
          },
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
             const std::size_t n = claims_of(c).size();
             const bool is_spline = std::holds_alternative<PathCertificate>(c.certificate);
             return "<Certificate of " + std::to_string(n) + (n == 1 ? " angle" : " angles") +
                    (is_spline ? " of a spline" : " and the kind of the curve") +
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
