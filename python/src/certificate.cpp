#include <algorithm>

#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

struct CertificateObject {
  Certificate certificate;
  std::string name;
};

std::vector<Statement> verified(const CertificateObject& self) {
  return without_gil([certificate = self.certificate] { return verify(certificate); });
}

}  // namespace

void bind_certificate(nb::module_& m, PathClass& path) {
  const auto certify_curve = [](const PathObject& self, nb::handle at, nb::handle digits,
                                const Text<"frame">& frame) {
    const auto ts = rationals(at, "at");
    const long n = count(digits, "digits", 1, 100'000);
    const Reference reference = chosen<Reference>(
        frame, "frame", {{"erf", Reference::euler_rodrigues}, {"frenet", Reference::frenet}});
    return CertificateObject{without_gil([=, curve = curve_of(self, "certify")] {
                               return certify(curve, reference, ts, n);
                             }),
                             self.named.name};
  };
  path.def("certify", certify_curve, argument("at") = nb::make_tuple(1), argument("digits") = 50,
           argument("frame") = "erf",
           nb::sig("def certify(self, at: Numbers = (1,), digits: int = 50, frame: str = 'erf') "
                   "-> Certificate"),
           "Angles, and what kinds a PH curve is of, with what proves them.");
  auto type = nb::class_<CertificateObject>(m, "Certificate", "docs/certificate.md.");
  using C = CertificateObject;
  const auto from_json = [](const Text<"text">& text) {
    NamedCertificate read = read_certificate(text);
    return C{std::move(read.certificate), std::move(read.name)};
  };
  type.def_static("from_json", from_json, argument("text"),
                  nb::sig("def from_json(text: str) -> Certificate"),
                  "Of a certificate/1 file, true or not.")
      .def(
          "json", [](const C& c) { return write_certificate(c.certificate, c.name); },
          "The certificate/1 file.")
      .def_prop_ro(
          "curve", [](const C& c) { return wrap(NamedPhPath(c.name, c.certificate.curve)); },
          nb::sig("def curve(self) -> Path"), "Of which it is.")
      .def_prop_ro(
          "claims",
          [](const C& c) {
            nb::list list;
            for (const AngleClaim& claim : c.certificate.claims)
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
      .def("__hash__",
           [](const C& c) {
             return nb::hash(nb::str(write_certificate(c.certificate, "").c_str()));
           })
      .def("__repr__",
           [](const C& c) {
             const std::size_t n = c.certificate.claims.size();
             return "<Certificate of " + std::to_string(n) + (n == 1 ? " angle" : " angles") +
                    " and the kind of the curve" +
                    (c.name.empty() ? "" : " " + abbreviated(c.name)) + ">";
           })
      .def(
          "__reduce__",
          [from_json](const C& c) {
            return remade("_certificate", nb::str(write_certificate(c.certificate, c.name).c_str()),
                          nb::str(c.name.c_str()));
          },
          PHRAME_REDUCE_SIG);
  m.def("_certificate", [](const std::string& text, const std::string& name) {
    return CertificateObject{read_certificate(text, {.is_limited = false}).certificate, name};
  });
  bind_python(type, "_repr_html_", "phrame._show", "certificate_html",
              "def _repr_html_(self) -> str");
  bind_copies(type);
}

}  // namespace phrame::python
