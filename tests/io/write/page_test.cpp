#include "phrame/io/write/page.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/io/write/page_template.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/skip.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;
using Json = nlohmann::json;

namespace {

/// What the page says of the curve, as its program reads it.
Json data_of(const std::string& html) {
  const std::string mark = R"(id="data">)";
  const std::size_t begin = html.find(mark) + mark.size();
  return Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

/// The row at this t; there are others where the graphs turn and bend.
const std::vector<double>& row_at(const PageAnswer& page, double t) {
  const auto& rows = page.table.rows;
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row[0] == t; });
  REQUIRE(found != rows.end());
  return *found;
}

PageAnswer page(const std::string& name) {
  PageQuery query;
  query.samples = 5;
  return answer(NamedPhPath{name, PhPath(test::quintic), {}}, query);
}

}  // namespace

TEST_CASE("page: the table is that of the frames, with θ, its rate and the speed") {
  const PageAnswer found = page("q");
  CHECK(found.frames ==
        std::vector{TabulatedFrame::rmf, TabulatedFrame::euler_rodrigues, TabulatedFrame::frenet});
  CHECK(found.table.rows.size() >= 5);
  const auto& names = found.table.columns;
  CHECK(std::vector<std::string>(names.end() - 6, names.end()) ==
        std::vector<std::string>{"s", "curvature", "torsion", "theta", "theta_rate", "speed"});
  // θ′ = −8t(t − 1)/σ with σ = 37t⁴ − 72t³ + 46t² − 12t + 6 [Farouki 2003]: 2/σ and σ at 1/2.
  const std::vector<double>& middle = row_at(found, 0.5);
  const double sigma = 37.0 / 16 - 9 + 11.5 - 6 + 6;
  CHECK(middle.back() == sigma);
  CHECK(middle[middle.size() - 2] == 2 / sigma);
  CHECK_FALSE(found.is_closed);
}

TEST_CASE("page: a straight line has no Frenet frame, and its torsion is left out") {
  const PhPath line(Curve(QuaternionPolynomial{{1, 1}, {}, {}, {}}));
  const PageAnswer found = answer(NamedPhPath{"line", line, {}}, PageQuery{});
  CHECK(found.frames == std::vector{TabulatedFrame::rmf, TabulatedFrame::euler_rodrigues});
  CHECK(std::find(found.table.columns.begin(), found.table.columns.end(), "nx") ==
        found.table.columns.end());
}

TEST_CASE("page: more than 500 segments have a row at each end, and no decisions") {
  const auto row_of = [](int count) {
    const QuaternionPolynomial one{{1}, {}, {}, {}};
    PhPath steps{Curve(one)};
    for (int k = 1; k < count; ++k)
      steps.append(Curve(one, Polynomial{1}, Vector<Rational>{k, 0, 0}));
    return answer(NamedPhPath{"steps", steps, {}}, PageQuery{.samples = 3});
  };
  const PageAnswer full = row_of(500);
  CHECK(full.table.rows.size() == 1001);
  CHECK(full.classification.has_value());
  const PageAnswer lean = row_of(501);
  CHECK(lean.table.rows.size() == 502);
  CHECK(lean.table.rows[7][1] == 7);  // x
  CHECK_FALSE(lean.classification.has_value());
}

TEST_CASE("page: at a joint there is what jumps there, as it is just before") {
  PhPath path(Curve(QuaternionPolynomial{{1}, {}, {}, {}}));  // along x with the speed 1,
  path.append(Curve(QuaternionPolynomial{{2}, {}, {}, {}}, Polynomial{1}, {1, 0, 0}));  // then 4
  const PageAnswer found = answer(NamedPhPath{"", path, {}}, PageQuery{.samples = 5});
  REQUIRE(found.jumps.size() == 1);
  const auto& [row, before] = found.jumps.front();
  const std::vector<double>& after = found.table.rows[row];
  CHECK(after.front() == 1);
  CHECK(after.back() == 4);
  CHECK(before.back() == 1);
  CHECK(std::equal(before.begin(), before.begin() + 7, after.begin()));  // t, r, e₁
  const PhPath even = joined(
      {path.segments()[0], Curve(QuaternionPolynomial{{1}, {}, {}, {}}, Polynomial{1}, {1, 0, 0})});
  CHECK(answer(NamedPhPath{"", even, {}}, PageQuery{.samples = 5}).jumps.empty());
}

TEST_CASE("page: with an end normal there is the frame of minimal twist") {
  const PhPath path(test::quintic);
  const Vector<Rational> up{0, 0, 1};
  const auto check = [](const PageAnswer& found) {
    CHECK(found.frames.back() == TabulatedFrame::exact_mtf);
    const auto& names = found.table.columns;
    const auto at = [&](const char* name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    // r′ = (3, 4, 0) at t = 1, so that (0, 0, 1) is normal there.
    const std::vector<double>& last = found.table.rows.back();
    CHECK(last[at("exact_mtf2x")] == 0);
    CHECK(last[at("exact_mtf2z")] == 1);
    const std::vector<double>& first = found.table.rows.front();
    CHECK(first[at("exact_mtf2x")] == first[at("f2x")]);
    CHECK_FALSE(found.is_closed);
    if (has_pages()) CHECK(contains(to_page(found), "\"minimal twist\""));
  };
  PageQuery query{.samples = 3, .end_normal = up};
  check(answer(NamedPhPath{"q", path, {}}, query));
  check(answer(NamedPath{"q", test::by_positions(path)}, query));
  query.end_normal = {3, 4, 0};
  CHECK_THROWS_AS(answer(NamedPhPath{"q", path, {}}, query), DomainError);
}

// The Frenet frame for one: θ_Frenet is θ to it, so that its error is −θ to it, from 0 on.
TEST_CASE("page: frames that are given stand beside the exact ones, with their errors") {
  const Frames frames(test::quintic);
  PageQuery query;
  for (const Rational& t : {Rational(0), Rational(1, 2), Rational(1)}) {
    const Frame<Real> n = frames.frenet(t);
    const auto rounded = [](const Vector<Real>& v) {
      const Vector<double> x = round_to_double(v);
      return Vector<Rational>{exact_rational(x[0]), exact_rational(x[1]), exact_rational(x[2])};
    };
    query.given.push_back({t, rounded(n.e2), rounded(n.e3)});
  }
  const PageAnswer found = answer(NamedPhPath{"", PhPath(test::quintic), {}}, query);
  CHECK(found.table.columns.back() == "error");
  const RmfAngle to_frenet(test::quintic, Reference::frenet);
  for (std::size_t k = 0; k < 3; ++k) {
    const Real theta = to_frenet.value(query.given[k].t);
    // Before the error are g2 and g3; f₂ begins behind t, r and e₁.
    const std::vector<double>& row = row_at(found, round_to_double(query.given[k].t));
    CHECK(row.back() == doctest::Approx(-round_to_double(theta)).epsilon(1e-12));
    const bool has_same_start = std::abs(row[7] - row[row.size() - 7]) < 1e-15;
    CHECK(has_same_start == (k == 0));
  }
  REQUIRE(found.check);
  CHECK_FALSE(found.check->verdict.passes);
  query.start = Angle(1);
  const PageAnswer turned = answer(NamedPhPath{"", PhPath(test::quintic), {}}, query);
  CHECK(std::abs(row_at(turned, 0).back()) > 0.1);
}

TEST_CASE("page: its numbers are the table, and names are inert") {
  if (!has_pages()) {
    CHECK_THROWS_AS(to_page(page("")), DomainError);
    test::skip("phrame was built without npm or a network, so that it writes no page");
    return;
  }
  const std::string name = "</script><!-- <b> & \"q\"";
  const PageAnswer found = page(name);
  const std::string html = to_page(found);
  CHECK(contains(html, "<title>&lt;/script&gt;&lt;!-- &lt;b&gt; &amp; \"q\"</title>"));
  const Json data = data_of(html);
  CHECK(data["name"] == name);
  CHECK(data["csv"] == to_csv(found.table));
  CHECK(data["frames"].size() == 3);
  CHECK(data["poles"]["count"] == 4);
  CHECK(data["downloads"].size() == 3);
  CHECK_FALSE(contains(html, "https://unpkg"));
  CHECK_FALSE(contains(html, "<!--data-->"));
}
