#include "phrame/io/json_text.hpp"

namespace phrame {

JsonOutput json_of(const Polynomial& p) {
  JsonOutput list = JsonOutput::array();
  for (const Rational& c : p.coefficients()) list.push_back(to_string(c));
  return list;
}

JsonOutput json_of(const GaussianPolynomial& p) {
  return {{"re", json_of(p.re)}, {"im", json_of(p.im)}};
}

JsonOutput json_of(const RationalFunction& f) {
  return {{"numerator", json_of(f.numerator())}, {"denominator", json_of(f.denominator())}};
}

JsonOutput json_of(const Antiderivative& F, const std::string& form) {
  JsonOutput logs = JsonOutput::array();
  for (const LogSum& sum : F.logs) {
    JsonOutput argument = JsonOutput::array();
    for (const Polynomial& c : sum.argument.coefficients()) argument.push_back(json_of(c));
    logs.push_back({{"index", json_of(sum.index)},
                    {"residue", json_of(sum.residue)},
                    {"argument", argument}});
  }
  return {{"polynomial", json_of(F.polynomial)},
          {"rational", json_of(F.rational)},
          {"logs", logs},
          {"form", form},
          {"checked", true}};  // nothing unchecked leaves integrate()
}

JsonOutput json_of(const Decimal& x) { return {{"value", x.value}, {"radius", x.radius}}; }

JsonOutput json_of(const Vector<Rational>& point) {
  return {to_string(point[0]), to_string(point[1]), to_string(point[2])};
}

}  // namespace phrame
