#include "phrame/io/write/certificate.hpp"

#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0 {
namespace {

JsonOutput json_of(const LengthClaim& claim) {
  return {{"t", to_string(claim.t)}, {"length", claim.length}, {"radius", claim.radius}};
}

JsonOutput json_of(const IntegralSegment& segment) {
  const auto terms = [](const GridPolynomial& p) {
    return array_of(p.terms, [](const Integer& x) -> JsonOutput { return x.str(); });
  };
  const auto& [x, y, z] = segment.position;
  return {{"x", phrame::json_of(x)},
          {"y", phrame::json_of(y)},
          {"z", phrame::json_of(z)},
          {"w", phrame::json_of(segment.weight)},
          {"square", phrame::json_of(segment.square)},
          {"pieces", array_of(segment.pieces, [&](const IntegralPiece& piece) -> JsonOutput {
             return {{"to", to_string(piece.to)},
                     {"root_bits", piece.root.bits},
                     {"root", terms(piece.root)},
                     {"rate_bits", piece.rate.bits},
                     {"rate", terms(piece.rate)}};
           })}};
}

JsonOutput json_of(const GaussianInteger& z) { return {z.re.str(), z.im.str()}; }

JsonOutput json_of(const std::vector<RootDisc>& discs) {
  return array_of(discs, [](const RootDisc& disc) -> JsonOutput {
    return {{"center", json_of(disc.center)},
            {"radius", disc.radius.str()},
            {"residue", json_of(disc.residue)},
            {"residue_radius", disc.residue_radius.str()}};
  });
}

JsonOutput json_of(const StatedPoint& point) {
  const Interval& i = point.interval;
  if (*i.lower == *i.upper) return {{"t", to_string(*i.lower)}, {"order", point.order}};
  return {{"t",
           {{"polynomial", phrame::json_of(point.polynomial)},
            {"interval", {to_string(*i.lower), to_string(*i.upper)}}}},
          {"order", point.order}};
}

JsonOutput json_of(const std::vector<StatedPoint>& points) {
  return array_of(points, [](const StatedPoint& point) { return json_of(point); });
}

JsonOutput json_of(const AngleClaim& claim) {
  JsonOutput json = {{"t", to_string(claim.t)}, {"theta", claim.theta}, {"radius", claim.radius}};
  if (claim.turn)
    json["turn"] = {{"index", claim.turn->index},
                    {"signs", {claim.turn->at_zero, claim.turn->at_t}}};
  if (claim.symmetry)
    json["symmetry"] = claim.symmetry->shift ? to_string(*claim.symmetry->shift) : "mirror";
  return json;
}

JsonOutput json_of(const StatedDecisions& d) {
  const auto answer = [](bool yes) { return JsonOutput{{"answer", yes}}; };
  JsonOutput json = {
      {"regular", {{"answer", d.regular}, {"cusps", json_of(d.cusps)}}},
      {"inflections", {{"answer", d.has_inflections}, {"points", json_of(d.inflections)}}},
      {"line", answer(d.line.has_value())},
      {"planar", answer(d.normal.has_value())},
      {"helical", answer(d.helix.has_value())},
      {"double_ph", answer(d.double_ph.has_value())},
      {"primitive", {{"answer", d.primitive}, {"content", phrame::json_of(d.content)}}},
      {"erf_is_rmf", answer(d.erf_is_rmf)},
      {"rrmf", answer(d.rational_frame.has_value())},
      {"erf_monotone",
       {{"answer", d.erf_monotone},
        {"zeros_of_h", json_of(d.zeros_of_h)},
        {"extrema", json_of(d.extrema)}}}};
  if (d.line) json["line"]["direction"] = phrame::json_of(*d.line);
  if (d.normal) json["planar"]["normal"] = phrame::json_of(*d.normal);
  if (d.helix) {
    json["helical"]["axis"] = phrame::json_of(d.helix->axis);
    json["helical"]["cos_squared"] = to_string(d.helix->cosine_squared);
  }
  if (d.double_ph) {
    json["double_ph"]["constant"] = to_string(d.double_ph->constant);
    json["double_ph"]["omega"] = phrame::json_of(d.double_ph->omega);
  }
  if (d.rational_frame) json["rrmf"]["w"] = phrame::json_of(*d.rational_frame);
  return json;
}

JsonOutput json_of(const Certificate& c, const std::string& name,
                   const std::optional<Nearness>& near) {
  const auto logs = [](const CertifiedLogs& sum) -> JsonOutput {
    return {{"index", json_of(sum.index)},
            {"residue", json_of(sum.residue)},
            {"roots", json_of(sum.roots)}};
  };
  JsonOutput json = {{"phrame", "certificate/1"},
                     {"curve", json_of(NamedCurve{name, c.curve, near})},
                     {"frame", name_of(c.reference)}};
  if (!c.curve.is_polynomial()) {
    const auto& [x, y, z] = numerator(c.curve);
    json["position"] = {
        {"x", json_of(x)}, {"y", json_of(y)}, {"z", json_of(z)}, {"w", json_of(c.curve.weight())}};
  }
  json.update(
      {{"hodograph", JsonOutput::array({json_of(c.hodograph[0]), json_of(c.hodograph[1]),
                                        json_of(c.hodograph[2])})},
       {"sigma", json_of(c.sigma)},
       {"h", json_of(c.h)},
       {"g", json_of(c.g)},
       {"rate",
        {{"numerator", json_of(c.rate.numerator)},
         {"denominator", json_of(c.rate.denominator)},
         {"common", json_of(c.rate.common)},
         {"coprime_modulo", c.rate.modulus.str()}}},
       {"bits", c.bits},
       {"antiderivative", {{"rational", json_of(c.rational)}, {"logs", array_of(c.logs, logs)}}}});
  if (c.bend)
    json["bend"] = {{"polynomial", json_of(c.bend->polynomial)},
                    {"content", json_of(c.bend->content)}};
  json["claims"] = array_of(c.claims, [](const AngleClaim& claim) { return json_of(claim); });
  json["decisions"] = json_of(c.decisions);
  return json;
}

JsonOutput json_of(const FormulaSegment& f) {
  const auto text = [](const Formula& g) { return full_text(g, "s"); };
  const auto piece = [](const ModelPiece& p) -> JsonOutput {
    return {{"to", to_string(p.to)}, {"order", p.order}, {"bits", p.bits}};
  };
  return {{"expressions",
           {{"x", text(f.position[0])},
            {"y", text(f.position[1])},
            {"z", text(f.position[2])},
            {"from", text(f.from)},
            {"to", text(f.to)}}},
          {"pieces", array_of(f.pieces, piece)}};
}

JsonOutput json_of(const StatedArc& arc) {
  return {{"segment", arc.segment}, {"interval", {to_string(arc.lower), to_string(arc.upper)}}};
}

JsonOutput json_of(const ClosedClaims& closed) {
  JsonOutput json = JsonOutput::object();
  if (const auto& claim = closed.holonomy)
    json["holonomy"] = {
        {"turns", claim->turns}, {"value", claim->value}, {"radius", claim->radius}};
  if (const auto& claim = closed.writhe) {
    const auto crossing = [](const StatedCrossing& c) -> JsonOutput {
      return {{"first", json_of(c.first)}, {"second", json_of(c.second)}, {"sign", c.sign}};
    };
    json["writhe"] = {{"projection", phrame::json_of(claim->projection)},
                      {"crossings", array_of(claim->crossings, crossing)},
                      {"value", claim->value},
                      {"radius", claim->radius}};
  }
  return json;
}

}  // namespace

std::string write_certificate(const Certificate& certificate, const std::string& name,
                              const std::optional<Nearness>& near) {
  return pretty(json_of(certificate, name, near));
}

std::string write_certificate(const PathCertificate& certificate, const std::string& name) {
  JsonOutput json = {{"phrame", "path-certificate/1"}};
  if (!name.empty()) json["name"] = name;
  json["segments"] = array_of(certificate.segments,
                              [](const Certificate& c) { return json_of(c, "", std::nullopt); });
  json["claims"] =
      array_of(certificate.claims, [](const AngleClaim& claim) { return json_of(claim); });
  if (certificate.closed) json["closed"] = json_of(*certificate.closed);
  return pretty(json);
}

std::string write_certificate(const IntegralCertificate& certificate, const std::string& name) {
  JsonOutput json = {{"phrame", "integral-certificate/1"}};
  if (!name.empty()) json["name"] = name;
  json["frame"] = certificate.frame ? name_of(*certificate.frame) : "none";
  if (certificate.frame == Reference::up) json["up"] = phrame::json_of(certificate.up);
  const auto each = [](const auto& x) { return json_of(x); };
  json["segments"] = array_of(certificate.segments, [&](const CertifiedSegment& segment) {
    return std::visit(each, segment);
  });
  json["claims"] =
      certificate.frame ? array_of(certificate.angles, each) : array_of(certificate.lengths, each);
  return pretty(json);
}

}  // namespace phrame
