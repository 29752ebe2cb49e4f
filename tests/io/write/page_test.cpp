#include "phrame/io/write/page.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/io/write/page_template.hpp"
#include "support/curves.hpp"
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

PageAnswer page(const std::string& name) {
  PageQuery query;
  query.samples = 5;
  return answer(NamedPath{name, Path(test::quintic), {}}, query);
}

}  // namespace

TEST_CASE("page: the table is that of the frames, with θ, its rate and the speed") {
  const PageAnswer found = page("q");
  CHECK(found.frames ==
        std::vector{TabulatedFrame::rmf, TabulatedFrame::euler_rodrigues, TabulatedFrame::frenet});
  CHECK(found.table.rows.size() == 5);
  const auto& names = found.table.columns;
  CHECK(std::vector<std::string>(names.end() - 6, names.end()) ==
        std::vector<std::string>{"s", "curvature", "torsion", "theta", "theta_rate", "speed"});
  // θ′ = −8t(t − 1)/σ with σ = 37t⁴ − 72t³ + 46t² − 12t + 6 [Farouki 2003]: 2/σ and σ at 1/2.
  const std::vector<double>& middle = found.table.rows[2];
  const double sigma = 37.0 / 16 - 9 + 11.5 - 6 + 6;
  CHECK(middle.back() == sigma);
  CHECK(middle[middle.size() - 2] == 2 / sigma);
  CHECK_FALSE(found.is_closed);
}

TEST_CASE("page: a straight line has no Frenet frame, and its torsion is left out") {
  const Path line(Curve(QuaternionPolynomial{{1, 1}, {}, {}, {}}));
  const PageAnswer found = answer(NamedPath{"line", line, {}}, PageQuery{});
  CHECK(found.frames == std::vector{TabulatedFrame::rmf, TabulatedFrame::euler_rodrigues});
  CHECK(std::find(found.table.columns.begin(), found.table.columns.end(), "nx") ==
        found.table.columns.end());
}

TEST_CASE("page: its numbers are the table, and names are inert") {
  if (!has_pages()) {
    CHECK_THROWS_AS(to_page(page("")), DomainError);
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
