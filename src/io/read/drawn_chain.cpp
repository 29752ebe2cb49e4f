#include "phrame/io/read/drawn_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "phrame/io/read/curve_choice.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

const Vector<Rational>& first_point(const CurvePieces& pieces) {
  return pieces.front().points.front();
}
const Vector<Rational>& last_point(const CurvePieces& pieces) {
  return pieces.back().points.back();
}

}  // namespace

void turn_back(CurvePieces& pieces) {
  std::ranges::reverse(pieces);
  for (RationalBezier& piece : pieces) {
    std::ranges::reverse(piece.points);
    std::ranges::reverse(piece.weights);
  }
}

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
  turn_back(chain.pieces);
  std::ranges::reverse(chain.lines);
}

/// Puts `next` of the same layer behind the chain, or before it, where ends of them meet.
bool join_chains(DrawnChain& chain, DrawnChain& next) {
  if (chain.layer != next.layer || points_meet(first_point(chain.pieces), last_point(chain.pieces)))
    return false;
  if (!points_meet(last_point(chain.pieces), first_point(next.pieces)) &&
      (points_meet(last_point(chain.pieces), last_point(next.pieces)) ||
       points_meet(first_point(chain.pieces), first_point(next.pieces))))
    turn_back(next);
  const bool is_behind = points_meet(last_point(chain.pieces), first_point(next.pieces));
  if (!is_behind && !points_meet(last_point(next.pieces), first_point(chain.pieces))) return false;
  chain.knots.clear();
  next.knots.clear();
  DrawnChain& first = is_behind ? chain : next;
  DrawnChain& second = is_behind ? next : chain;
  first.pieces.insert(first.pieces.end(), second.pieces.begin(), second.pieces.end());
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
                      handle.empty() ? fmt::format("line {}", chain.lines.front()) : handle});
  }
  return labels;
}

}  // namespace

std::vector<DrawnChain> chains_of_drawing(std::vector<DrawnChain> parts) {
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t j = k + 1; j < parts.size() && !has_grown; ++j)
        if (!points_meet(first_point(parts[j].pieces), last_point(parts[j].pieces)) &&
            join_chains(parts[k], parts[j])) {
          parts.erase(parts.begin() + static_cast<long>(j));
          has_grown = true;
        }
    }
  return parts;
}

std::vector<GivenSegment> chosen_chain(const std::vector<DrawnChain>& chains,
                                       const std::string& pick) {
  const auto place = [](long line) { return fmt::format("line {}", line); };
  const DrawnChain& second = chains[std::min<std::size_t>(1, chains.size() - 1)];
  const auto& [pieces, knots, lines, layer, handles] =
      chains[chosen_curve(labels_of(chains, pick), pick, place(second.lines.front()))];
  std::vector<GivenSegment> segments;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    segments.push_back(knots.size() == pieces.size() + 1
                           ? span_segment({pieces[k], knots[k], knots[k + 1]}, place(lines[k]))
                           : bezier_segment(pieces[k], place(lines[k])));
  return segments;
}

}  // namespace phrame
