#include "phrame/io/read/drawn_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "phrame/io/read/curve_choice.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

const Vector<Rational>& first_point(const DrawnChain& chain) {
  return chain.curve.pieces.front().points.front();
}
const Vector<Rational>& last_point(const DrawnChain& chain) {
  return chain.curve.pieces.back().points.back();
}

/// The part of a Bézier curve from a to b, 0 ≤ a < b ≤ 1, as one on [0, 1].
RationalBezier part_of(const RationalBezier& curve, const Rational& a, const Rational& b) {
  using Homogeneous = std::array<Rational, 4>;
  std::vector<Homogeneous> points;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const Rational w = curve.weights.empty() ? Rational(1) : curve.weights[k];
    const Vector<Rational>& p = curve.points[k];
    points.push_back({w * p[0], w * p[1], w * p[2], w});
  }
  // What is left of t, by de Casteljau's algorithm: the first point of each of its rows.
  const auto up_to = [](std::vector<Homogeneous> row, const Rational& t) {
    for (std::size_t n = 1; n < row.size(); ++n)
      for (std::size_t k = row.size() - 1; k >= n; --k)
        for (std::size_t c = 0; c < 4; ++c) row[k][c] = (1 - t) * row[k - 1][c] + t * row[k][c];
    return row;
  };
  points = up_to(std::move(points), b);
  std::ranges::reverse(points);
  points = up_to(std::move(points), 1 - a / b);
  std::ranges::reverse(points);
  RationalBezier part;
  for (const auto& [x, y, z, w] : points) {
    part.points.push_back({x / w, y / w, z / w});
    if (!curve.weights.empty()) part.weights.push_back(w);
  }
  return part;
}

}  // namespace

DrawnCurve drawn_spline(const BSpline& spline) {
  DrawnCurve curve;
  for (BezierPiece& piece : bezier_pieces(spline)) {
    if (curve.knots.empty()) curve.knots.push_back(piece.lower);
    curve.knots.push_back(piece.upper);
    curve.pieces.push_back(std::move(piece.curve));
  }
  return curve;
}

CurvePieces lines_through(const std::vector<Vector<Rational>>& points) {
  CurvePieces lines;
  for (std::size_t k = 1; k < points.size(); ++k)
    if (points[k] != points[k - 1]) lines.push_back({{points[k - 1], points[k]}});
  return lines;
}

DrawnCurve part_between(const DrawnCurve& spline, const Rational& a, const Rational& b) {
  DrawnCurve part;
  for (std::size_t k = 0; k < spline.pieces.size(); ++k) {
    const Rational& start = spline.knots[k];
    const Rational& end = spline.knots[k + 1];
    const Rational lower = std::max(a, start);
    const Rational upper = std::min(b, end);
    if (lower >= upper) continue;
    if (part.knots.empty()) part.knots.push_back(lower);
    part.knots.push_back(upper);
    part.pieces.push_back(part_of(spline.pieces[k], Rational((lower - start) / (end - start)),
                                  Rational((upper - start) / (end - start))));
  }
  return part;
}

void turn_back(DrawnCurve& curve) {
  std::ranges::reverse(curve.pieces);
  for (RationalBezier& piece : curve.pieces) {
    std::ranges::reverse(piece.points);
    std::ranges::reverse(piece.weights);
  }
  curve.knots.clear();
}

DrawnChain::DrawnChain(DrawnCurve drawn, long line, std::string its_layer, std::string handle)
    : curve(std::move(drawn)),
      lines(curve.pieces.size(), line),
      layer(std::move(its_layer)),
      handles{std::move(handle)} {}

bool points_meet(const Vector<Rational>& p, const Vector<Rational>& q) {
  if (p == q) return true;
  Rational size = 1;
  Rational distance = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    size = std::max({size, Rational(abs(p[k])), Rational(abs(q[k]))});
    distance = std::max(distance, Rational(abs(p[k] - q[k])));
  }
  return distance * 1'000'000'000 <= size;
}

namespace {

void turn_back(DrawnChain& chain) {
  turn_back(chain.curve);
  std::ranges::reverse(chain.lines);
}

/// Puts `next` of the same layer behind the chain, or before it, where ends of them meet.
bool join_chains(DrawnChain& chain, DrawnChain& next) {
  if (chain.layer != next.layer || points_meet(first_point(chain), last_point(chain))) return false;
  if (!points_meet(last_point(chain), first_point(next)) &&
      (points_meet(last_point(chain), last_point(next)) ||
       points_meet(first_point(chain), first_point(next))))
    turn_back(next);
  const bool is_behind = points_meet(last_point(chain), first_point(next));
  if (!is_behind && !points_meet(last_point(next), first_point(chain))) return false;
  chain.curve.knots.clear();
  next.curve.knots.clear();
  DrawnChain& first = is_behind ? chain : next;
  DrawnChain& second = is_behind ? next : chain;
  CurvePieces& pieces = first.curve.pieces;
  pieces.insert(pieces.end(), second.curve.pieces.begin(), second.curve.pieces.end());
  first.lines.insert(first.lines.end(), second.lines.begin(), second.lines.end());
  first.handles.insert(first.handles.end(), second.handles.begin(), second.handles.end());
  if (!is_behind) chain = std::move(next);
  return true;
}

/// The layer, where it has one curve only, and a handle.
std::vector<CurveLabel> labels_of(const std::vector<DrawnChain>& chains, const std::string& pick) {
  std::map<std::string, int> count;
  for (const DrawnChain& chain : chains) ++count[chain.layer];
  std::vector<CurveLabel> labels;
  for (const DrawnChain& chain : chains) {
    const bool is_picked = std::ranges::find(chain.handles, pick) != chain.handles.end();
    const std::string& handle = is_picked ? pick : chain.handles.front();
    labels.push_back({count[chain.layer] == 1 ? chain.layer : "",
                      handle.empty() ? line_place(chain.lines.front()) : handle});
  }
  return labels;
}

}  // namespace

std::vector<DrawnChain> chains_of_drawing(std::vector<DrawnChain> parts) {
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t j = k + 1; j < parts.size() && !has_grown; ++j)
        if (!points_meet(first_point(parts[j]), last_point(parts[j])) &&
            join_chains(parts[k], parts[j])) {
          parts.erase(parts.begin() + static_cast<long>(j));
          has_grown = true;
        }
    }
  return parts;
}

std::vector<GivenSegment> chosen_chain(const std::vector<DrawnChain>& chains,
                                       const std::string& pick) {
  const DrawnChain& second = chains[std::min<std::size_t>(1, chains.size() - 1)];
  const DrawnChain& chain =
      chains[chosen_curve(labels_of(chains, pick), pick, line_place(second.lines.front()))];
  const auto& [pieces, knots] = chain.curve;
  std::vector<GivenSegment> segments;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::string place = line_place(chain.lines[k]);
    segments.push_back(knots.size() == pieces.size() + 1
                           ? span_segment({pieces[k], knots[k], knots[k + 1]}, place)
                           : bezier_segment(pieces[k], place));
  }
  return segments;
}

}  // namespace phrame
