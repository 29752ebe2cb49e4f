#include "phrame/io/write/nurbs.hpp"

#include <fmt/format.h>

#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0 {
namespace {

JsonOutput nurbs_json(const std::string& name, const BSpline& spline) {
  const auto text = [](const Rational& x) { return to_string(x); };
  JsonOutput json{{"phrame", "nurbs/1"}};
  if (!name.empty()) json["name"] = name;
  json["degree"] = spline.degree;
  json["knots"] = array_of(spline.knots, text);
  json["control_points"] = array_of(spline.points, [](const auto& p) { return json_of(p); });
  if (!spline.weights.empty()) json["weights"] = array_of(spline.weights, text);
  return json;
}

/// Group codes and values.
class DxfText {
 public:
  template <class T>
  void add(int code, const T& value) {
    fmt::format_to(std::back_inserter(text_), "{:>3}\n{}\n", code, value);
  }
  void add(int code, const Rational& x) { add(code, static_cast<double>(x)); }
  std::string take() && { return std::move(text_); }

 private:
  std::string text_;
};

void add_spline(DxfText& dxf, const OffsetNurbs::Part& part, const std::string& question,
                std::size_t number) {
  const BSpline& spline = part.curve;
  const bool is_rational = !spline.weights.empty();
  dxf.add(0, "SPLINE");
  dxf.add(5, fmt::format("{:X}", 0x100 + number));
  dxf.add(100, "AcDbEntity");
  dxf.add(8, fmt::format("{}-{}", question, number));
  dxf.add(100, "AcDbSpline");
  dxf.add(70, 8 + (is_rational ? 4 : 0) + (part.is_closed ? 1 : 0));
  dxf.add(71, spline.degree);
  dxf.add(72, spline.knots.size());
  dxf.add(73, spline.points.size());
  dxf.add(74, 0);
  for (const Rational& knot : spline.knots) dxf.add(40, knot);
  for (const Rational& weight : spline.weights) dxf.add(41, weight);
  for (const Vector<Rational>& p : spline.points)
    for (const int k : {0, 1, 2}) dxf.add(10 * (k + 1), p[static_cast<std::size_t>(k)]);
}

}  // namespace

std::string write_nurbs(const OffsetNurbs& nurbs) {
  if (nurbs.parts.size() == 1) return pretty(nurbs_json(nurbs.name, nurbs.parts.front().curve));
  std::string lines;
  for (const auto& part : nurbs.parts) lines += nurbs_json(nurbs.name, part.curve).dump() + "\n";
  return lines;
}

std::string write_dxf(const OffsetNurbs& nurbs) {
  DxfText dxf;
  dxf.add(0, "SECTION");
  dxf.add(2, "HEADER");
  dxf.add(9, "$ACADVER");
  dxf.add(1, "AC1015");
  dxf.add(0, "ENDSEC");
  dxf.add(0, "SECTION");
  dxf.add(2, "ENTITIES");
  for (std::size_t k = 0; k < nurbs.parts.size(); ++k)
    add_spline(dxf, nurbs.parts[k], nurbs.question, k + 1);
  dxf.add(0, "ENDSEC");
  dxf.add(0, "EOF");
  return std::move(dxf).take();
}

}  // namespace phrame
