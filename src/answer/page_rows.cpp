#include "phrame/answer/page_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace phrame::inline v0 {
namespace {

/// Of so many segments all turns are shown, of more the farthest ones.
constexpr std::size_t most_segments_in_detail = 64;

void add_segment(PathTurns& path, const Turns& turns) {
  path.are_all = path.are_all && turns.are_all;
  path.slack = std::max(path.slack, turns.slack);
  for (const Plotted quantity : turns.infinite)
    if (std::find(path.infinite.begin(), path.infinite.end(), quantity) == path.infinite.end())
      path.infinite.push_back(quantity);
}

/// The least and the greatest of each quantity.
class Farthest {
 public:
  void see(std::size_t segment, const Turn& turn) {
    for (const bool is_greatest : {false, true}) {
      const auto [found, is_new] = turns_.try_emplace({turn.quantity, is_greatest}, segment, turn);
      const double best = found->second.second.about;
      if (!is_new && (is_greatest ? turn.about > best : turn.about < best))
        found->second = {segment, turn};
    }
  }
  void add_to(std::vector<PathParameter>& at) const {
    for (const auto& [key, turn] : turns_) at.push_back({turn.first, turn.second.at});
  }

 private:
  std::map<std::pair<Plotted, bool>, std::pair<std::size_t, Turn>> turns_;
};

bool is_number(const double x) { return !std::isnan(x); }

/// Which columns are looked at: the place and what is plotted, but not vectors of frames.
std::vector<std::size_t> seen_columns(const FrameTable& table) {
  std::vector<std::size_t> seen;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    for (const char* name :
         {"x", "y", "z", "s", "curvature", "torsion", "theta", "theta_rate", "speed"})
      if (table.columns[k] == name) seen.push_back(k);
  return seen;
}

/// How far the values of a column go, without the few that go far away: what a plot is scaled by.
double spread(const FrameTable& table, std::size_t column) {
  std::vector<double> values;
  for (const auto& row : table.rows)
    if (is_number(row[column])) values.push_back(row[column]);
  if (values.size() < 2) return 0;
  std::sort(values.begin(), values.end());
  const double last = static_cast<double>(values.size() - 1);
  const auto at = [&](double share) { return values[static_cast<std::size_t>(share * last)]; };
  const double inner = at(0.96) - at(0.04);
  return inner > 0 ? inner : values.back() - values.front();
}

/// Merges the rows at other places into those that are there.
void merge(PageRows& rows, const std::vector<PathParameter>& at, const FrameTable& more) {
  PageRows merged{{}, rows.table, {}};
  merged.table.rows.clear();
  merged.table.incomplete_rows += more.incomplete_rows;
  if (merged.table.first_reason.empty()) merged.table.first_reason = more.first_reason;
  std::size_t next = 0;
  const auto take = [&merged](const PathParameter& place, const std::vector<double>& row) {
    merged.at.push_back(place);
    merged.table.rows.push_back(row);
  };
  for (std::size_t k = 0; k < rows.at.size(); ++k) {
    for (; next < at.size() && is_before(at[next], rows.at[k]); ++next)
      take(at[next], more.rows[next]);
    take(rows.at[k], rows.table.rows[k]);
  }
  rows = std::move(merged);
}

/// By which share of the spread row k is away from the line between its neighbours.
double bend(const FrameTable& table, const std::vector<std::size_t>& columns,
            const std::vector<double>& spreads, std::size_t k) {
  const auto& [a, b, c] = std::tie(table.rows[k - 1], table.rows[k], table.rows[k + 1]);
  const double share = (b[0] - a[0]) / (c[0] - a[0]);
  double most = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::size_t j = columns[i];
    if (!(spreads[i] > 0)) continue;
    const double away = std::abs(b[j] - a[j] - share * (c[j] - a[j])) / spreads[i];
    if (away > most) most = away;
  }
  return most;
}

/// The middles of the parts where the graphs bend most.
std::vector<PathParameter> between(const PageRows& rows) {
  constexpr std::size_t most_places = 160;
  constexpr double seen = 0.01;             // of the spread: about a pixel
  constexpr double narrowest = 1.0 / 1000;  // of the path
  const std::vector<std::size_t> columns = seen_columns(rows.table);
  std::vector<double> spreads;
  for (const std::size_t column : columns) spreads.push_back(spread(rows.table, column));
  const double width = rows.table.rows.back()[0] - rows.table.rows.front()[0];
  std::vector<double> bends(rows.at.size(), 0);  // of the part that begins there
  for (std::size_t k = 1; k + 1 < rows.at.size(); ++k) {
    const double here = bend(rows.table, columns, spreads, k);
    for (const std::size_t part : {k - 1, k}) bends[part] = std::max(bends[part], here);
  }
  std::vector<std::size_t> parts;
  for (std::size_t k = 0; k + 1 < rows.at.size(); ++k)
    if (bends[k] > seen && rows.table.rows[k + 1][0] - rows.table.rows[k][0] > narrowest * width)
      parts.push_back(k);
  std::sort(parts.begin(), parts.end(), [&](auto a, auto b) { return bends[a] > bends[b]; });
  if (parts.size() > most_places) parts.resize(most_places);
  std::sort(parts.begin(), parts.end());
  std::vector<PathParameter> middles;
  for (const std::size_t k : parts) {
    const Rational to =
        rows.at[k + 1].segment == rows.at[k].segment ? rows.at[k + 1].t : Rational(1);
    // A double in the middle, or so.
    const Rational middle = exact_rational(round_to_double((rows.at[k].t + to) / 2));
    middles.push_back({rows.at[k].segment, middle});
  }
  return middles;
}

bool is_other(double a, double b) {
  return is_number(a) != is_number(b) || (is_number(a) && a != b);
}

/// The rows at joints that have other limits from the left.
std::vector<PageJump> jumps_of(const PageRows& rows, const RowMaker& make) {
  std::vector<std::size_t> joints;
  std::vector<PathParameter> ends;
  for (std::size_t k = 1; k < rows.at.size(); ++k)
    if (rows.at[k].segment > rows.at[k - 1].segment && rows.at[k].t == 0) {
      joints.push_back(k);
      ends.push_back({rows.at[k].segment - 1, 1});
    }
  std::vector<PageJump> jumps;
  if (ends.empty()) return jumps;
  FrameTable before = make(ends);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const std::vector<double>& row = rows.table.rows[joints[k]];
    if (!std::equal(row.begin(), row.end(), before.rows[k].begin(),
                    [](double a, double b) { return !is_other(a, b); }))
      jumps.push_back({joints[k], std::move(before.rows[k])});
  }
  return jumps;
}

}  // namespace

bool is_before(const PathParameter& a, const PathParameter& b) {
  return a.segment != b.segment ? a.segment < b.segment : a.t < b.t;
}

bool is_same_place(const PathParameter& a, const PathParameter& b) {
  if (a.segment != b.segment) return false;
  return a.t == b.t || round_to_double(a.t) == round_to_double(b.t) ||
         abs(Rational(a.t - b.t)) < power_of_two(-80);
}

PathTurns path_turns(const PathAngle& angle) {
  const auto& segments = angle.path().segments();
  PathTurns all;
  Farthest farthest;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Turns found = angle.reference() == Reference::euler_rodrigues
                            ? turns(*ph_curve(segments[k]))
                            : turns(segments[k]);
    add_segment(all, found);
    for (const Turn& turn : found.list)
      if (segments.size() > most_segments_in_detail)
        farthest.see(k, turn);
      else
        all.at.push_back({k, turn.at});
  }
  farthest.add_to(all.at);
  return all;
}

PageRows page_rows(std::vector<PathParameter> at, const RowMaker& make) {
  PageRows rows{std::move(at), {}, {}};
  rows.table = make(rows.at);
  for (int round = 0; round < 2; ++round) {
    const std::vector<PathParameter> more = between(rows);
    if (more.empty()) break;
    merge(rows, more, make(more));
  }
  rows.jumps = jumps_of(rows, make);
  return rows;
}

}  // namespace phrame
