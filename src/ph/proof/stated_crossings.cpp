// The path is seen along v: (x, y) is the part of r across v, in coordinates of the same sense as
// (r′, r″, v), and z = v·r the height. The Bernstein coefficients of an arc hold it in their convex
// hull, and its direction in their cone.
#include "phrame/ph/proof/stated_crossings.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

// The limits of docs/certificate.md.
constexpr long most_work = 2'000'000'000;
constexpr long most_halvings = 40;

/// What ends a proof.
struct NotProved {
  std::string why;
};

void require(bool holds, const char* why) {
  if (!holds) throw NotProved{why};
}

/// The work that is done, in units of docs/certificate.md.
class Budget {
 public:
  void spend(std::size_t work) {
    work_ += static_cast<long>(work);
    require(work_ <= most_work,
            "parts of the curve are too close to each other, as they are seen along v");
  }

 private:
  long work_ = 0;
};

using Coefficients = std::vector<Integer>;

/// On [0, 1/2] and [1/2, 1], times 2ⁿ.
std::pair<Coefficients, Coefficients> halves(Coefficients c) {
  const std::size_t n = c.size() - 1;
  Coefficients left;
  Coefficients right;
  for (std::size_t k = 0; k <= n; ++k) {
    left.push_back(c.front() << (n - k));
    right.push_back(c.back() << (n - k));
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] += c[i + 1];
    c.pop_back();
  }
  std::ranges::reverse(right);
  return {left, right};
}

/// The Bernstein coefficients on [lower, upper], times one positive number.
template <std::size_t Count>
std::array<Coefficients, Count> bernstein_of(const std::array<Polynomial, Count>& list,
                                             const Rational& lower, const Rational& upper) {
  long degree = 1;
  for (const Polynomial& p : list) degree = std::max(degree, p.degree());
  std::array<std::vector<Rational>, Count> exact;
  Integer common = 1;
  for (std::size_t i = 0; i < Count; ++i) {
    exact[i] = to_bernstein(compose(list[i], {lower, upper - lower}), degree);
    for (const Rational& x : exact[i]) common = lcm(common, Integer(denominator(x)));
  }
  std::array<Coefficients, Count> found;
  for (std::size_t i = 0; i < Count; ++i)
    for (const Rational& x : exact[i])
      found[i].push_back(Integer(numerator(x)) * (common / Integer(denominator(x))));
  return found;
}

int sign_of_cross(const Integer& x, const Integer& y, const Integer& u, const Integer& v) {
  return (x * v - y * u).sign();
}

/// A part of a segment: (x, y)/w, z/w and a vector along the derivative of (x, y)/w.
class SeenArc {
 public:
  using Place = std::array<Coefficients, 4>;  ///< x, y, z, w
  using Slope = std::array<Coefficients, 2>;

  SeenArc(Place place, Slope slope) : place_(std::move(place)), slope_(std::move(slope)) {
    const Coefficients& w = place_[3];
    is_bounded_ = std::ranges::all_of(w, [](const Integer& x) { return x.sign() > 0; });
    if (!is_bounded_) return;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < w.size(); ++k)
        points_[i].push_back(Rational(place_[i][k]) / Rational(w[k]));
      const auto [least, most] = std::ranges::minmax_element(points_[i]);
      least_[i] = *least;
      most_[i] = *most;
    }
  }

  std::array<SeenArc, 2> halves() const {
    std::array<Place, 2> place;
    std::array<Slope, 2> slope;
    for (std::size_t i = 0; i < 4; ++i)
      std::tie(place[0][i], place[1][i]) = phrame::halves(place_[i]);
    for (std::size_t i = 0; i < 2; ++i)
      std::tie(slope[0][i], slope[1][i]) = phrame::halves(slope_[i]);
    return {SeenArc(std::move(place[0]), std::move(slope[0])),
            SeenArc(std::move(place[1]), std::move(slope[1]))};
  }

  /// Of the derivative.
  std::size_t count_slopes() const { return slope_[0].size(); }
  std::size_t bits() const {
    long most = 0;
    const auto look = [&](const Coefficients& list) {
      for (const Integer& x : list) most = std::max(most, bit_length(x));
    };
    for (const Coefficients& list : place_) look(list);
    for (const Coefficients& list : slope_) look(list);
    return static_cast<std::size_t>(most);
  }

  /// Is the direction less than a right angle from that at the start of `first`?
  bool is_forward_from(const SeenArc& first) const {
    for (std::size_t k = 0; k < count_slopes(); ++k)
      if ((first.slope_[0][0] * slope_[0][k] + first.slope_[1][0] * slope_[1][k]).sign() <= 0)
        return false;
    return true;
  }

  bool is_apart_from(const SeenArc& b) const {
    if (!is_bounded_ || !b.is_bounded_) return false;
    for (std::size_t i = 0; i < 2; ++i)
      if (most_[i] < b.least_[i] || b.most_[i] < least_[i]) return true;
    return false;
  }

  /// The sign of a × b for all directions a of this and b of that; 0 where there is none.
  int turn_to(const SeenArc& b) const {
    std::set<int> signs;
    for (std::size_t i = 0; i < count_slopes(); ++i)
      for (std::size_t k = 0; k < b.count_slopes(); ++k)
        signs.insert(sign_of_cross(slope_[0][i], slope_[1][i], b.slope_[0][k], b.slope_[1][k]));
    return signs.size() == 1 ? *signs.begin() : 0;
  }

  /// Is it strictly between the lines through the ends of the other one along its own chord?
  bool is_between_ends_of(const SeenArc& other) const {
    if (!is_bounded_ || !other.is_bounded_) return false;
    const auto& [x, y, z] = points_;
    const Rational dx = x.back() - x.front();
    const Rational dy = y.back() - y.front();
    const auto side = [&, &x = x, &y = y](const Rational& a, const Rational& b) {
      std::set<int> signs;
      for (std::size_t k = 0; k < x.size(); ++k)
        signs.insert(Rational(dx * (y[k] - b) - dy * (x[k] - a)).sign());
      return signs.size() == 1 ? *signs.begin() : 0;
    };
    const int first = side(other.points_[0].front(), other.points_[1].front());
    return first != 0 && side(other.points_[0].back(), other.points_[1].back()) == -first;
  }

  /// 1 where it is higher, −1 where it is lower, 0 where that is not told.
  int height_above(const SeenArc& other) const {
    return least_[2] > other.most_[2] ? 1 : most_[2] < other.least_[2] ? -1 : 0;
  }

 private:
  Place place_;
  Slope slope_;
  bool is_bounded_ = false;
  std::array<std::vector<Rational>, 3> points_;
  std::array<Rational, 3> least_;
  std::array<Rational, 3> most_;
};

/// The law of the page.
class CrossingsProof {
 public:
  CrossingsProof(const std::vector<Curve>& segments, const Vector<Rational>& v)
      : segments_(segments), v_(v) {
    while (v_[m_] == 0) --m_;
  }

  /// The sign of the crossing that two arcs have.
  int crossing(const StatedArc& first, const StatedArc& second) {
    for (const StatedArc* arc : {&first, &second})
      require(arc->segment < static_cast<long>(segments_.size()) && arc->lower >= 0 &&
                  arc->lower < arc->upper && arc->upper <= 1,
              "a box is not on the curve");
    require(first.segment < second.segment ||
                (first.segment == second.segment && first.upper <= second.lower),
            "the parts of a box are not one behind the other");
    const SeenArc a = arc(first);
    const SeenArc b = arc(second);
    budget_.spend(1000 * a.count_slopes() * b.count_slopes());
    const int turn = a.turn_to(b);
    require(turn != 0, "the arcs of a box may be parallel");
    require(a.is_between_ends_of(b) && b.is_between_ends_of(a), "the arcs of a box may not cross");
    const int height = a.height_above(b);
    require(height != 0, "it is not told which arc of a box is above the other");
    return turn * height;
  }

  void are_all(const std::vector<StatedCrossing>& crossings) {
    for (const StatedCrossing& stated : crossings) {
      require(crossing(stated.first, stated.second) == stated.sign,
              "a crossing has the other sign");
      std::vector<const StatedCrossing*>& others = boxes_[numbers_of(stated)];
      budget_.spend(5000 * others.size());
      for (const StatedCrossing* other : others)
        require(
            are_disjoint(stated.first, other->first) || are_disjoint(stated.second, other->second),
            "two boxes meet");
      others.push_back(&stated);
    }
    std::map<std::size_t, SeenArc> arcs;
    std::vector<Pair> pairs;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      arcs.emplace(k, arc({static_cast<long>(k), 0, 1}));
      for (std::size_t j = k; j < segments_.size(); ++j) pairs.emplace_back(k, j);
    }
    for (unsigned long depth = 0; !pairs.empty(); ++depth) {
      std::erase_if(pairs, [&](const Pair& pair) { return is_told(pair, arcs, depth); });
      require(pairs.empty() || depth < most_halvings,
              "parts of the curve meet, as they are seen along v");
      std::map<std::size_t, SeenArc> next;
      for (const Pair& pair : pairs)
        for (const std::size_t k : {pair.first, pair.second}) {
          if (next.contains(2 * k)) continue;
          const SeenArc& whole = arcs.at(k);
          const std::size_t n = whole.count_slopes();
          budget_.spend(100'000 + 500 * n * n * (1 + whole.bits() / 256));
          auto [left, right] = whole.halves();
          next.emplace(2 * k, std::move(left));
          next.emplace(2 * k + 1, std::move(right));
        }
      arcs = std::move(next);
      std::vector<Pair> parts;
      for (const auto& [i, j] : pairs)
        for (const std::size_t a : {2 * i, 2 * i + 1})
          for (const std::size_t b : {2 * j, 2 * j + 1})
            if (a <= b) parts.emplace_back(a, b);
      pairs = std::move(parts);
    }
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;

  static std::pair<long, long> numbers_of(const StatedCrossing& c) {
    return {c.first.segment, c.second.segment};
  }

  static bool are_disjoint(const StatedArc& a, const StatedArc& b) {
    return a.lower >= b.upper || b.lower >= a.upper;
  }

  /// Has it no crossing but those of the boxes?
  bool is_told(const Pair& pair, const std::map<std::size_t, SeenArc>& arcs, unsigned long depth) {
    const auto [i, j] = pair;
    const SeenArc& a = arcs.at(i);
    const SeenArc& b = arcs.at(j);
    const std::size_t count = segments_.size() << depth;
    budget_.spend(10'000);
    if (i == j) return a.is_forward_from(a);
    if (i + 1 == j) return a.is_forward_from(a) && b.is_forward_from(a);
    if (i == 0 && j + 1 == count) return b.is_forward_from(b) && a.is_forward_from(b);
    if (a.is_apart_from(b)) return true;
    const auto found = boxes_.find({i >> depth, j >> depth});
    if (found == boxes_.end()) return false;
    budget_.spend(4000 * found->second.size());
    const auto is_in = [depth](std::size_t k, const StatedArc& box) {
      const Integer unit = Integer(1) << depth;
      const Integer low = Integer(k) - (Integer(k >> depth) << depth);
      return box.lower <= Rational(low) / Rational(unit) &&
             Rational(low + 1) / Rational(unit) <= box.upper;
    };
    return std::ranges::any_of(found->second, [&, i = i, j = j](const StatedCrossing* box) {
      return is_in(i, box->first) && is_in(j, box->second);
    });
  }

  SeenArc arc(const StatedArc& part) {
    const Curve& curve = segments_[static_cast<std::size_t>(part.segment)];
    const auto seen = [this](const Vector<Polynomial>& a) {
      const std::size_t i = (m_ + 1) % 3;
      const std::size_t j = (m_ + 2) % 3;
      const Rational sense = v_[m_] > 0 ? 1 : -1;
      return std::array{sense * (v_[m_] * a[i] - v_[i] * a[m_]),
                        sense * (v_[m_] * a[j] - v_[j] * a[m_])};
    };
    const Vector<Polynomial> X = numerator(curve);
    const auto [x, y] = seen(X);
    const Rational sign = curve.weight()(0) > 0 ? 1 : -1;
    const std::array place{sign * x, sign * y, sign * dot(as_polynomials(v_), X),
                           sign * curve.weight()};
    const std::array slope = seen(hodograph_numerator(curve));
    long most = 0;
    for (const Polynomial& p : place) most = std::max(most, p.degree() + 1);
    for (const Polynomial& p : slope) most = std::max(most, p.degree() + 1);
    budget_.spend(3000 * static_cast<std::size_t>(most) * static_cast<std::size_t>(most));
    return {bernstein_of(place, part.lower, part.upper),
            bernstein_of(slope, part.lower, part.upper)};
  }

  const std::vector<Curve>& segments_;
  Vector<Rational> v_;
  std::size_t m_ = 2;  ///< the last coordinate of v that is not 0
  Budget budget_;
  std::map<std::pair<long, long>, std::vector<const StatedCrossing*>> boxes_;
};

}  // namespace

std::string objection_to_crossings(const std::vector<Curve>& segments, const Vector<Rational>& v,
                                   const std::vector<StatedCrossing>& crossings) {
  try {
    CrossingsProof(segments, v).are_all(crossings);
    return "";
  } catch (const NotProved& objection) {
    return objection.why;
  }
}

std::optional<StatedCrossing> box_around(const std::vector<Curve>& segments,
                                         const Vector<Rational>& v, const ArcCentre& first,
                                         const ArcCentre& second) {
  for (long halvings = 1; halvings < most_halvings; ++halvings) {
    const Rational half = power_of_two(-halvings);
    const Rational grid = half / 64;
    const auto around = [&](const ArcCentre& centre) {
      const Rational middle = grid * Rational(floor(Rational(centre.t / grid)));
      return StatedArc{centre.segment, std::max(Rational(0), Rational(middle - half)),
                       std::min(Rational(1), Rational(middle + half))};
    };
    StatedCrossing box{around(first), around(second), 0};
    try {
      box.sign = CrossingsProof(segments, v).crossing(box.first, box.second);
      return box;
    } catch (const NotProved&) {
      continue;
    }
  }
  return std::nullopt;
}

}  // namespace phrame
