// Ten tasks. The front page of the API reference, docs/reference/api.md, shows what stands between
// two equal marks; ten_tasks.txt is what they print, which the test of this example holds them to.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>

#include "phrame/phrame.hpp"

using namespace phrame;

namespace {

Curve quintic() {
  //! [curve]
  // r′ = A i A* with A = (2, 1, 0, 1)(1 − t)² + (0, 1, −2, 2)·2t(1 − t) + (2, 0, 0, 1)t².
  const Curve curve({from_bernstein({2, 0, 2}), from_bernstein({1, 1, 0}),
                     from_bernstein({0, -2, 0}), from_bernstein({1, 2, 1})});
  //! [curve]
  return curve;
}

NamedPhPath read(const std::string& name) {
  //! [file]
  std::ostringstream text;
  text << std::ifstream(name).rdbuf();
  const NamedPhPath named = read_path(text.str());  // a curve/1 or spline/1 file
  //! [file]
  return named;
}

void angle_at(const Curve& curve) {
  //! [angle]
  const RmfAngle theta(curve);
  const Real value = theta.value(Rational(1, 2));
  std::cout << "theta(1/2) = " << round_to_decimal(value, 50) << '\n';
  //! [angle]
}

void closed_form(const NamedPhPath& named) {
  //! [closed form]
  const AngleAnswer theta = answer(named, AngleQuery{.at = {1}, .digits = 20});
  std::cout << for_reading(to_text(theta), false) << to_latex(theta);
  //! [closed form]
}

void frames_into_array(const Curve& curve) {
  //! [frames]
  const FrameTable table =
      frame_table(curve, std::vector{TabulatedFrame::rmf}, {0, Rational(1, 2), 1});
  for (const std::vector<double>& row : table.rows)  // t, r, e1, f2, f3: 13 doubles
    std::cout << "t = " << row[0] << ", f2 = " << row[7] << ' ' << row[8] << ' ' << row[9] << '\n';
  //! [frames]
}

void million_angles(const Curve& curve) {
  //! [many]
  CompiledAngle theta(RmfAngle(curve), 0, 1);
  double largest = 0;
  for (int k = 0; k <= 1'000'000; ++k) largest = std::max(largest, theta(k / 1e6));
  std::cout << "the largest of a million angles: " << largest << '\n';
  //! [many]
}

void spline(const Curve& curve) {
  //! [spline]
  PhPath path(curve);                 // t from 0 to 1
  path.append(segment(curve, 1, 2));  // t from 1 to 2: here the same curve goes on
  const PathAngle theta(path);
  std::cout << "theta(2) = " << round_to_decimal(theta.value(2), 20) << '\n';
  //! [spline]
}

void totals(const NamedPhPath& named) {
  //! [totals]
  for (const TotalsAnswer::Row& row : answer(named, TotalsQuery{.digits = 20}).rows)
    if (row.value) std::cout << name_of(row.quantity) << ": " << *row.value << '\n';
  //! [totals]
}

void minimal_twist(const PhPath& path) {
  //! [twist]
  const FrameAngle from;  // θ = 0: e₂ of the Euler–Rodrigues frame at the start
  const FrameAngle to{Rational(-5, 8), 0};  // θ = −5π/8 at the end
  const MinimalTwist frame(PathAngle(path), from, to);
  std::cout << "twist = " << round_to_decimal(frame.twist(), 20)
            << ", theta(1/2) = " << round_to_decimal(frame.value(Rational(1, 2)), 20) << '\n';
  //! [twist]
}

void check(const Curve& curve) {
  //! [check]
  std::vector<GivenFrame> frames;  // somebody's; in truth the Euler–Rodrigues frame
  for (const Rational& t : {Rational(0), Rational(1, 2), Rational(1)})
    frames.push_back({t, euler_rodrigues_frame(curve, t).e2});
  const FrameVerdict verdict = check_frames(PathAngle(Path(curve)), frames);
  std::cout << (verdict.passes ? "right" : "off by up to ") << verdict.max_error << '\n';
  //! [check]
}

void certificate(const Curve& curve) {
  //! [certificate]
  const Certificate certificate = certify(curve, Reference::euler_rodrigues, {1}, 30);
  const std::string file = write_certificate(certificate, "quintic");  // to be sent to somebody
  std::cout << to_text(verify(read_certificate(file).certificate));
  //! [certificate]
  std::cout << "theta(1) = " << certificate.claims.front().theta << " ± "
            << certificate.claims.front().radius << '\n';
}

void integral() {
  //! [integral]
  const RationalFunction f = parse_expression("1/(x^3 - 1)").value;
  const Antiderivative F = integrate(f);  // checked: differentiate(F) == f
  const DefiniteIntegral value = definite_integral(F, Rational(2), Rational(3));
  std::cout << "integral of " << f << ": " << round_to_decimal(value.value, 40) << '\n';
  //! [integral]
}

}  // namespace

int main() {
  const Curve curve = quintic();
  const NamedPhPath named = read("curves/farouki-2003-quintic.json");
  if (named.path != PhPath(curve)) return 1;
  angle_at(curve);
  closed_form(named);
  frames_into_array(curve);
  million_angles(curve);
  spline(curve);
  totals(named);
  minimal_twist(read("curves/farouki-moon-1.json").path);
  check(curve);
  certificate(curve);
  integral();
}
