// Doubles, from a common origin: what they round is less than `error_` in every distance. A point
// is no nearer to a Bézier curve than along any unit vector n to all control points; with n across
// the chord that is short of the distance by the sagitta, of second order. Of a part c of a whose
// ends have their feet on one cubic of b, c − (b between the feet), with the same share of the
// parameter, is a cubic, and no point of c is farther from b than its control points are from 0:
// that is of second order, too. By the triangle inequality no point is farther than the middle and
// what it is away from there.
#include "phrame/ph/offset/plane_gap.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/curve_arc.hpp"

namespace phrame::inline v0 {
namespace {

struct Point {
  double x;
  double y;
};
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Point mean(const Point& a, const Point& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
double size(const Point& a) { return std::hypot(a.x, a.y); }
Point between(const Point& a, const Point& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

using Bezier = std::array<Point, 4>;

std::array<Bezier, 2> halves(const Bezier& c) {
  const Point ab = mean(c[0], c[1]);
  const Point bc = mean(c[1], c[2]);
  const Point cd = mean(c[2], c[3]);
  const Point left = mean(ab, bc);
  const Point right = mean(bc, cd);
  const Point middle = mean(left, right);
  return {Bezier{c[0], ab, left, middle}, Bezier{middle, right, cd, c[3]}};
}

/// The greatest control point of c − b(t), with t of degree 2 by its Bernstein coefficients, as
/// curves of degree 6: no c(s) − b(t(s)) is longer.
double greatest_difference(const Bezier& c, const Bezier& b, const std::array<double, 3>& t) {
  const auto blossom = [&](double u, double v, double w) {
    const Point p = between(b[0], b[1], u);
    const Point q = between(b[1], b[2], u);
    const Point r = between(b[2], b[3], u);
    return between(between(p, q, v), between(q, r, v), w);
  };
  constexpr std::array<double, 3> of_two{1, 2, 1};
  constexpr std::array<double, 4> of_three{1, 3, 3, 1};
  constexpr std::array<double, 7> of_six{1, 6, 15, 20, 15, 6, 1};
  std::array<Point, 7> sum{};
  const auto add = [&](std::size_t k, double factor, const Point& p) {
    sum[k] = {sum[k].x + factor * p.x, sum[k].y + factor * p.y};
  };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        add(i + j + k, -of_two[i] * of_two[j] * of_two[k], blossom(t[i], t[j], t[k]));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) add(i + j, of_three[i] * of_three[j], c[i]);
  double most = 0;
  for (std::size_t k = 0; k < 7; ++k) most = std::max(most, size(sum[k]) / of_six[k]);
  return most;
}

PlaneBox around(const Point& p) { return {DoubleInterval{p.x, p.x}, DoubleInterval{p.y, p.y}}; }
PlaneBox box_of(const Bezier& c) {
  PlaneBox box = around(c[0]);
  for (const Point& p : c) box = hull_of(box, around(p));
  return box;
}
double distance(const Point& p, const PlaneBox& box) {
  const auto gap = [](double x, const DoubleInterval& range) {
    return std::max({range.lower - x, x - range.upper, 0.0});
  };
  return size({gap(p.x, box[0]), gap(p.y, box[1])});
}

/// The nearest place to a point.
struct Foot {
  double lower;  ///< of the distance
  double upper;
  std::size_t part;
  double t;  ///< its share of the parameter
};

class NearestParts {
 public:
  NearestParts(std::vector<Bezier> parts, double floor) : parts_(std::move(parts)), floor_(floor) {
    order_.resize(parts_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = k;
    boxes_.resize(4 * parts_.size());
    add(1, 0, parts_.size());
  }

  const Bezier& operator[](std::size_t k) const { return parts_[k]; }

  /// The distance is in [lower, upper]; `hint` is a part that is probably near.
  Foot foot(const Point& p, std::size_t hint) const {
    Foot found{0, std::numeric_limits<double>::infinity(), hint, 0};
    look(p, hint, found);
    const auto visit = [&](const auto& self, std::size_t node, std::size_t first,
                           std::size_t last) -> void {
      if (distance(p, boxes_[node]) > needed(found)) return;
      if (last - first == 1) return look(p, order_[first], found);
      const std::size_t middle = first + (last - first) / 2;
      const bool left_first = distance(p, boxes_[2 * node]) <= distance(p, boxes_[2 * node + 1]);
      if (left_first) self(self, 2 * node, first, middle);
      self(self, 2 * node + 1, middle, last);
      if (!left_first) self(self, 2 * node, first, middle);
    };
    visit(visit, 1, 0, parts_.size());
    found.lower = std::max(0.0, needed(found));
    return found;
  }

 private:
  /// What is farther than that is not looked at.
  double needed(const Foot& found) const { return found.upper * (1 - 0x1p-10) - floor_; }

  void add(std::size_t node, std::size_t first, std::size_t last) {
    if (last - first == 1) {
      boxes_[node] = box_of(parts_[order_[first]]);
      return;
    }
    PlaneBox starts = around(parts_[order_[first]][0]);
    for (std::size_t k = first; k < last; ++k)
      starts = hull_of(starts, around(parts_[order_[k]][0]));
    const bool by_x = starts[0].upper - starts[0].lower > starts[1].upper - starts[1].lower;
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<long>(k); };
    std::nth_element(at(first), at(middle), at(last), [&](std::size_t i, std::size_t j) {
      return by_x ? parts_[i][0].x < parts_[j][0].x : parts_[i][0].y < parts_[j][0].y;
    });
    add(2 * node, first, middle);
    add(2 * node + 1, middle, last);
    boxes_[node] = hull_of(boxes_[2 * node], boxes_[2 * node + 1]);
  }

  void look(const Point& p, std::size_t k, Foot& found) const {
    Bezier c = parts_[k];
    for (Point& x : c) x = x - p;
    look(c, k, 0, 1, found, 0);
  }

  /// The point is 0.
  void look(const Bezier& c, std::size_t k, double from, double to, Foot& found, int depth) const {
    const double start = size(c[0]);
    const double end = size(c[3]);
    if (start < found.upper) found = {0, start, k, from};
    if (end < found.upper) found = {0, end, k, to};
    const auto least_along = [&](const Point& n) {
      double least = std::numeric_limits<double>::infinity();
      double most = -least;
      for (const Point& x : c) {
        least = std::min(least, dot(n, x));
        most = std::max(most, dot(n, x));
      }
      return std::max(least, -most) / size(n);
    };
    const Point chord = c[3] - c[0];
    const auto is_away = [&](const Point& n) {
      return size(n) > 0 && least_along(n) > needed(found);
    };
    constexpr int most = 50;
    if (depth == most || is_away({-chord.y, chord.x}) || is_away(start < end ? c[0] : c[3])) return;
    if (std::max({size(c[1] - c[0]), size(c[2] - c[0]), size(chord)}) < floor_ / 2) return;
    const auto [left, right] = halves(c);
    const double middle = (from + to) / 2;
    if (start < end) look(left, k, from, middle, found, depth + 1);
    look(right, k, middle, to, found, depth + 1);
    if (start >= end) look(left, k, from, middle, found, depth + 1);
  }

  std::vector<Bezier> parts_;
  double floor_;
  std::vector<std::size_t> order_;
  std::vector<PlaneBox> boxes_;  ///< as in a heap
};

/// A part of a part of a.
struct Cell {
  std::size_t part;
  double from;  ///< its share of the parameter
  double to;
  Bezier curve;
  Foot start;
  Foot middle;
  Foot end;
  double lower;  ///< of the greatest distance
  double upper;
  double reach;  ///< no point is farther from the middle
  friend bool operator<(const Cell& a, const Cell& b) { return a.upper < b.upper; }
};

class GapSearch {
 public:
  GapSearch(const PlaneParts& a, const PlaneParts& b, const Rational& tolerance)
      : a_(a),
        b_size_(b.parts.size()),
        origin_(b.parts.front().cubic[0]),
        curves_(beziers(a)),
        size_(size_of(beziers(b), size_of(curves_, 0))),
        near_(beziers(b), size_ * 0x1p-44),
        error_((a.error + b.error) + exact_rational(size_ * 0x1p-42)),
        tolerance_(tolerance),
        limit_(static_cast<double>(tolerance - error_)),
        beyond_(static_cast<double>(tolerance + error_)) {}

  PlaneGap make() {
    std::priority_queue<Cell> open;
    std::size_t hint = 0;
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      const Foot start = near_.foot(curves_[k][0], hint);
      const Foot end = near_.foot(curves_[k][3], start.part);
      hint = end.part;
      cells_.push_back(cell(k, 0, 1, curves_[k], start, end));
      open.push(cells_.back());
    }
    const double floor = 2 * static_cast<double>(error_);
    const std::size_t most = 100'000 + 4 * (curves_.size() + b_size_);
    for (std::size_t count = 0; count < most; ++count) {
      const double upper = open.top().upper;
      const bool is_decided = upper <= limit_ || lower_ > beyond_;
      if (upper - lower_ <= (is_decided ? std::max(upper / 32, floor) : floor)) break;
      const Cell cell = open.top();
      open.pop();
      for (const Cell& half : split(cell)) open.push(half);
    }
    PlaneGap gap{std::max(Rational(0), exact_rational(lower_) - error_),
                 exact_rational(open.top().upper) + error_,
                 farthest_,
                 {}};
    if (gap.upper > tolerance_)
      for (const Cell& cell : cells_) add_stretches(cell, 0, gap.stretches);
    return gap;
  }

 private:
  std::vector<Bezier> beziers(const PlaneParts& curves) const {
    std::vector<Bezier> made;
    for (const CubicPart& part : curves.parts) {
      Bezier c;
      for (std::size_t k = 0; k < 4; ++k) {
        c[k] = {static_cast<double>(part.cubic[k][0] - origin_[0]),
                static_cast<double>(part.cubic[k][1] - origin_[1])};
        if (!std::isfinite(c[k].x) || !std::isfinite(c[k].y))
          throw DomainError("greatest_gap: a coordinate is beyond the range of doubles");
      }
      made.push_back(c);
    }
    return made;
  }

  static double size_of(const std::vector<Bezier>& curves, double size) {
    for (const Bezier& c : curves)
      for (const Point& x : c) size = std::max({size, std::abs(x.x), std::abs(x.y)});
    return size;
  }

  Cell cell(std::size_t k, double from, double to, const Bezier& c, const Foot& start,
            const Foot& end) {
    const Point at = halves(c)[0][3];
    const Foot middle = near_.foot(at, start.part);
    Cell made{k, from, to, c, start, middle, end, 0, 0, 0};
    for (const Point& x : c) made.reach = std::max(made.reach, size(x - at));
    made.upper = middle.upper + made.reach;
    if (start.part == end.part) {
      const double mean = (start.t + end.t) / 2;
      const double middle_t =
          middle.part == start.part ? std::clamp(2 * middle.t - mean, 0.0, 1.0) : mean;
      made.upper = std::min(made.upper,
                            greatest_difference(c, near_[start.part], {start.t, middle_t, end.t}));
    }
    made.lower = std::max({start.lower, middle.lower, end.lower});
    if (made.lower > lower_) {
      lower_ = made.lower;
      farthest_ = place_of(made);
    }
    return made;
  }

  /// Where it is known to be the farthest.
  static GapPlace place_of(const Cell& cell) {
    if (cell.start.lower == cell.lower) return {cell.part, cell.from};
    if (cell.end.lower == cell.lower) return {cell.part, cell.to};
    return {cell.part, (cell.from + cell.to) / 2};
  }

  std::array<Cell, 2> split(const Cell& c) {
    const auto [left, right] = halves(c.curve);
    const double middle = (c.from + c.to) / 2;
    return {cell(c.part, c.from, middle, left, c.start, c.middle),
            cell(c.part, middle, c.to, right, c.middle, c.end)};
  }

  void add_stretches(const Cell& c, int depth, std::vector<GapStretch>& stretches) {
    if (c.upper <= limit_) return;
    constexpr int most = 6;
    constexpr int most_undecided = 30;
    const bool is_proved = c.lower > beyond_;
    const bool is_short = c.lower > limit_ ? depth >= most : depth >= most_undecided || left_ == 0;
    if (!is_short && c.middle.lower - c.reach <= beyond_) {
      if (depth >= most) --left_;
      for (const Cell& half : split(c)) add_stretches(half, depth + 1, stretches);
      return;
    }
    const GapStretch next{{c.part, c.from}, {c.part, c.to}, place_of(c), c.lower, is_proved};
    if (stretches.empty() || !goes_on(stretches.back().to, next.from)) {
      stretches.push_back(next);
      return;
    }
    GapStretch& last = stretches.back();
    last.to = next.to;
    last.is_proved = last.is_proved || is_proved;
    if (next.at_least <= last.at_least) return;
    last.farthest = next.farthest;
    last.at_least = next.at_least;
  }

  bool goes_on(const GapPlace& last, const GapPlace& next) const {
    if (last.part == next.part) return last.share == next.share;
    return last.part + 1 == next.part && last.share == 1 && next.share == 0 &&
           a_.parts[last.part].cubic[3] == a_.parts[next.part].cubic[0];
  }

  const PlaneParts& a_;
  std::size_t b_size_;
  std::array<Rational, 2> origin_;
  std::vector<Bezier> curves_;
  double size_;
  NearestParts near_;
  Rational error_;
  Rational tolerance_;
  double limit_;
  double beyond_;  ///< more than the tolerance, with errors
  double lower_ = -1;
  GapPlace farthest_{};
  std::size_t left_ = 100'000;  ///< how often stretches are cut for what is not decided
  std::vector<Cell> cells_;
};

}  // namespace

Rational parameter(const PlaneParts& curves, const GapPlace& at) {
  const CubicPart& part = curves.parts[at.part];
  return part.from + exact_rational(at.share) * (part.to - part.from);
}

std::array<Rational, 2> point(const PlaneParts& curves, const GapPlace& at) {
  const PlaneCubic& c = curves.parts[at.part].cubic;
  const auto coordinate = [&](std::size_t k) {
    return from_bernstein({c[0][k], c[1][k], c[2][k], c[3][k]})(exact_rational(at.share));
  };
  return {coordinate(0), coordinate(1)};
}

PlaneGap greatest_gap(const PlaneParts& a, const PlaneParts& b, const Rational& tolerance) {
  return GapSearch(a, b, tolerance).make();
}

}  // namespace phrame
