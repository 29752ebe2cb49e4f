#include "phrame/answer/page.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/end_normal.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/proof/certify.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long page_digits = 17;
/// Formulas of more segments, and C of their length, are not for reading.
constexpr std::size_t most_formulas = 8;
/// The energies of so many segments take about a second,
constexpr std::size_t most_totals = 64;
/// and of so high degrees n of A, by the sum of n³; with C and the certificate they have too many
/// digits for a page, too.
constexpr long most_work = 20'000;

/// Of more segments rows are at their ends only, and decisions are left out, which keeps pages of
/// 1000 segments below 2 MB.
constexpr std::size_t most_in_full = 500;

/// Equally many on each of `count` segments, ends and joints among them.
std::vector<PathParameter> spread(std::size_t count, long samples) {
  const long segments = static_cast<long>(count);
  const long fewest = count > most_in_full ? 1 : 2;
  const long parts = std::max(fewest, (samples - 1 + segments - 1) / segments);
  std::vector<PathParameter> at;
  for (std::size_t k = 0; k < count; ++k)
    for (long j = 0; j < parts; ++j) at.push_back({k, Rational(j, parts)});
  at.push_back({count - 1, 1});
  return at;
}

TableColumns page_columns(const std::vector<TabulatedFrame>& frames, const FrameStart& start) {
  TableColumns columns{frames};
  columns.scalars = {TabulatedScalar::arc_length, TabulatedScalar::curvature,
                     TabulatedScalar::torsion};
  columns.start = start;
  columns.may_be_empty = true;
  return columns;
}

/// Where rows are: where frames are given, spread evenly, and where graphs turn round.
std::vector<PathParameter> places(std::size_t count, const PageQuery& query,
                                  const PathTurns& turns) {
  std::set<PathParameter, decltype(&is_before)> places(&is_before);
  // Of several at one place the first stays.
  const auto add = [&places](const PathParameter& at) {
    const auto next = places.lower_bound(at);
    if (next != places.end() && is_same_place(*next, at)) return;
    if (next != places.begin() && is_same_place(*std::prev(next), at)) return;
    places.insert(next, at);
  };
  for (const GivenFrame& frame : query.given) add(locate_inside(count, frame.t));
  for (const PathParameter& at : spread(count, query.samples)) add(at);
  for (const PathParameter& at : turns.at) add(at);
  return {places.begin(), places.end()};
}

/// Is the path too much for what takes long?
bool is_heavy(const Path& path) {
  long work = 0;
  for (const Segment& segment : path.segments())
    if (const Curve* curve = ph_curve(segment)) {
      const long n = preimage_degree(*curve);
      work += n * n * n;
    }
  return work > most_work;
}

/// What the given frames are, if there are any.
std::optional<CheckAnswer> check_of(const NamedPath& named, const PageQuery& query) {
  if (query.given.empty()) return std::nullopt;
  return answer(named, CheckQuery{query.given, {.start = query.start, .up = query.up}});
}

FrameStart start_of(const PageQuery& query, const std::optional<CheckAnswer>& check) {
  if (query.start) return *query.start;
  if (check && query.given.front().t == 0 && check->verdict.errors.front())
    return StartNormal(query.given.front().f2);
  return {};
}

void add_vector(std::vector<double>& row, const std::optional<Vector<Rational>>& v) {
  for (std::size_t k = 0; k < 3; ++k)
    row.push_back(v ? round_to_double((*v)[k]) : std::numeric_limits<double>::quiet_NaN());
}

/// The frames that were given, and how far each is off; empty cells where none is.
void add_given(PageRows& rows, const CheckAnswer& check, std::size_t count) {
  FrameTable& table = rows.table;
  for (const char* name : {"g2x", "g2y", "g2z", "g3x", "g3y", "g3z", "error"})
    table.columns.emplace_back(name);
  std::vector<std::optional<std::size_t>> given(rows.at.size());
  for (std::size_t k = 0; k < check.frames.size(); ++k) {
    const PathParameter place = locate_inside(count, check.frames[k].t);
    auto at = std::lower_bound(rows.at.begin(), rows.at.end(), place, is_before);
    if (at == rows.at.end() || !is_same_place(*at, place)) --at;
    given[static_cast<std::size_t>(at - rows.at.begin())] = k;
  }
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    std::vector<double>& row = table.rows[k];
    if (!given[k]) {
      row.resize(table.columns.size(), std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    add_vector(row, check.frames[*given[k]].f2);
    add_vector(row, check.frames[*given[k]].f3);
    const auto& error = check.verdict.errors[*given[k]];
    row.push_back(error ? round_to_double(error->midpoint())
                        : std::numeric_limits<double>::quiet_NaN());
  }
  // What is given is not asked for its limits.
  for (PageJump& jump : rows.jumps) {
    const std::vector<double>& row = table.rows[jump.row];
    for (std::size_t k = jump.before.size(); k < row.size(); ++k) jump.before.push_back(row[k]);
  }
}

/// A column more, with number k of row k.
template <class Number>
void add_column(FrameTable& table, const std::string& name, Number number) {
  table.columns.push_back(name);
  for (std::size_t k = 0; k < table.rows.size(); ++k)
    table.rows[k].push_back(round_to_double(number(k)));
}

/// Takes the vectors of a frame out of the table where they are nowhere defined, as the Frenet
/// frame of a straight line.
void drop_undefined(PageRows& rows, std::vector<TabulatedFrame>& frames) {
  FrameTable& table = rows.table;
  constexpr std::size_t before = 7;  // t, r, e₁
  for (std::size_t k = frames.size(); k-- > 0;) {
    const auto first = static_cast<std::ptrdiff_t>(before + 6 * k);
    const auto is_defined = [first](const std::vector<double>& row) {
      return !std::isnan(row[static_cast<std::size_t>(first)]);
    };
    if (std::any_of(table.rows.begin(), table.rows.end(), is_defined)) continue;
    table.columns.erase(table.columns.begin() + first, table.columns.begin() + first + 6);
    for (auto& row : table.rows) row.erase(row.begin() + first, row.begin() + first + 6);
    for (auto& [joint, row] : rows.jumps) row.erase(row.begin() + first, row.begin() + first + 6);
    frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

/// Polynomials with a proof, of few segments and where they can be had.
std::optional<CompiledAnswer> compiled_if_short(const NamedPath& named,
                                                const CompiledQuery& query) {
  if (named.path.segments().size() > most_formulas) return std::nullopt;
  try {
    return answer(named, query);
  } catch (const Undecided&) {
    return std::nullopt;
  }
}

AngleQuery formulas(const NamedPath& named, const PageQuery& query, const FrameStart& start) {
  AngleQuery formulas{.up = query.up, .start = start, .digits = page_digits, .most_poles = 64};
  formulas.wants_formula = named.path.segments().size() <= most_formulas;
  return formulas;
}

/// Columns of θ and, where it has closed forms by the Euler–Rodrigues frame, of θ′ and |r′|.
void add_angles(FrameTable& table, const PathAngle& angle, const StartAngle& start,
                const std::vector<PathParameter>& at) {
  add_column(table, "theta", [&](std::size_t k) { return angle.value(at[k], start); });
  if (angle.reference() != Reference::euler_rodrigues) return;
  add_column(table, "theta_rate",
             [&](std::size_t k) { return angle.closed_form(at[k].segment)->rate()(at[k].t); });
  add_column(table, "speed", [&](std::size_t k) {
    const Curve& curve = *ph_curve(angle.path().segments()[at[k].segment]);
    const Rational w = curve.weight()(at[k].t);
    return abs(Rational(curve.multiplier()(at[k].t) * sigma(curve.preimage())(at[k].t) / (w * w)));
  });
}

/// What does not take too long of a path of PH curves by their Euler–Rodrigues frame.
void add_decided(PageAnswer& page, const NamedPath& named, const FrameStart& from) {
  const auto& segments = named.path.segments();
  if (segments.size() <= most_in_full) page.classification = answer(named, ClassificationQuery{});
  if (is_heavy(named.path)) return;
  if (segments.size() <= most_totals) page.totals = answer(named, TotalsQuery{page_digits});
  if (segments.size() == 1)
    page.certificate =
        certify(*ph_curve(segments.front()), Reference::euler_rodrigues, {1}, page_digits);
  page.compiled = compiled_if_short(named, CompiledQuery{.start = from});
}

/// Through the orientations that come with the path, unless an end is asked for.
PathTwist twist_of(const NamedPath& named, const PageQuery& query, const PathAngle& angle,
                   const FrameStart& from) {
  if (named.frame && !query.end_normal) return {angle, *named.frame};
  return minimal_twist(angle, from, end_of_frame(query.end_normal));
}

}  // namespace

PageAnswer answer(const NamedPath& named, const PageQuery& query) {
  const Path& path = named.path;
  const std::size_t count = path.segments().size();
  const PathAngle angle = angle_to(query.up, path);
  const bool is_to_erf = angle.reference() == Reference::euler_rodrigues;
  const bool is_closed = closure(path).is_closed == true;
  require_open(query.end_normal, is_closed);
  std::vector<TabulatedFrame> frames{
      TabulatedFrame::rmf, is_to_erf ? TabulatedFrame::euler_rodrigues : TabulatedFrame::up,
      TabulatedFrame::frenet};
  const bool has_ends = is_closed || query.end_normal || named.frame;
  if (has_ends) frames.push_back(TabulatedFrame::exact_mtf);
  std::optional<CheckAnswer> check = check_of(named, query);
  const FrameStart from = start_of(query, check);
  const StartAngle start = start_angle(from, angle);
  TableColumns columns = page_columns(frames, from);
  if (has_ends) columns.exact_mtf = twist_of(named, query, angle, from);
  const auto table_at = [&](const std::vector<PathParameter>& at) {
    FrameTable table = frame_table(angle, columns, std::vector<Place>(at.begin(), at.end()));
    add_angles(table, angle, start, at);
    return table;
  };
  PathTurns turns = path_turns(angle);
  PageRows rows = page_rows(places(count, query, turns), table_at);
  rows.table.near = named.near;
  drop_undefined(rows, frames);
  if (check) add_given(rows, *check, count);

  PageAnswer page{.angle = answer(named, formulas(named, query, from)),
                  .info = answer(named, InfoQuery{page_digits}),
                  .frames = std::move(frames),
                  .table = std::move(rows.table),
                  .check = std::move(check),
                  .is_closed = is_closed,
                  .jumps = std::move(rows.jumps),
                  .turns = std::move(turns)};
  if (is_to_erf) {
    add_decided(page, named, from);
  } else {
    page.totals = answer(named, TotalsQuery{page_digits});
    page.compiled = compiled_if_short(named, CompiledQuery{.up = angle.up(), .start = from});
  }
  return page;
}

}  // namespace phrame
