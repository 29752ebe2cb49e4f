#include "phrame/cli/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "phrame/algebra/as_written.hpp"
#include "phrame/cli/exchange.hpp"
#include "phrame/io/read/angle.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/point_table.hpp"
#include "phrame/io/read/roll.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/nearness.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/construct/near.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame::inline v0::cli {
namespace {

/// read(text, options) of the file; its errors name the file.
template <class Read>
auto read_by(Read read, const CurveOptions& options) {
  const std::string text = options.content();
  return at_place(name_of_file(options.path), ":", [&] { return read(text, options); });
}

/// Reads a path of any format from text or JSON.
template <class Source>
NamedPath read_any(const Source& source, const CurveOptions& options) {
  CurveLimits limits = options.limits;
  if (options.gap) limits.gap = parse_positive_option("--gap", *options.gap);
  FileReading reading = options.reading;
  if (options.path != "-" && Exchange::current() == nullptr)
    reading.beside = files_beside(options.path);
  return phrame::read_any_path(source, limits, reading);
}

NamedCurve read_one_curve(std::string_view text, const CurveOptions& options) {
  return phrame::read_curve(text, options.limits);
}

/// The path of an exchange, where `file` names one instead of a file; else null.
const NamedPath* given_path(const std::string& file, const FileReading& reading) {
  const auto* path = Exchange::content<NamedPath>(file);
  if (path == nullptr) return nullptr;
  reading.refuse_skipping("a curve that was read before");
  reading.refuse_picking("a curve that was read before");
  return path;
}

NamedPhPath ph_path_of(const NamedPath& named) {
  if (auto ph = with_preimages(named)) return *std::move(ph);
  throw InputError("", fmt::format("this command {}", needs_ph(named.path)));
}

/// A PH path of a file in any format. A file in another format than curve/1 and spline/1 that holds
/// another path is refused since that is not PH; all else for the reason why it cannot be read.
NamedPhPath read_ph_path(std::string_view text, const CurveOptions& options) {
  if (!options.reading.is_plain()) return ph_path_of(read_any(text, options));
  try {
    return phrame::read_path(text, options.limits);
  } catch (const InputError& error) {
    if (error.place() != "/phrame" && !error.place().starts_with("1:")) throw;
    const std::exception_ptr first = std::current_exception();
    std::optional<NamedPath> other;
    try {
      other = read_any(text, options);
    } catch (const InputError&) {
      if (error.place().starts_with("1:")) throw;  // it knows more formats
      std::rethrow_exception(first);
    }
    return ph_path_of(*other);
  }
}

/// The PH curve nearby to suggest; so far for a single polynomial curve only.
std::optional<NearSuggestion> suggestion_of(const Path& path) {
  if (is_straight(path)) return std::nullopt;  // any frame that does not turn is right
  const RationalCurve* curve = rational_curve(path.segments().front());
  if (path.segments().size() > 1 || curve == nullptr || !curve->weight().is_constant())
    return std::nullopt;
  return near_suggestion(hodograph(*curve), point(*curve, 0));
}

bool is_polynomial(const Segment& segment) {
  const RationalCurve* curve = rational_curve(segment);
  return curve != nullptr && curve->weight().is_constant();
}

/// Of one that is rational, segment k of so many.
std::string needs_polynomial(std::size_t k, std::size_t count) {
  return fmt::format("needs a polynomial Pythagorean-hodograph curve, and {} is a rational one",
                     count == 1 ? "this" : fmt::format("segment {}", k + 1));
}

/// Throws InputError, of that file, where one is rational.
void require_polynomial(const std::vector<Curve>& segments, const std::string& file) {
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (!segments[k].is_polynomial())
      throw InputError(file, "this command " + needs_polynomial(k, segments.size()));
}

}  // namespace

std::string needs_ph(const Path& path) {
  const auto& segments = path.segments();
  const auto ph = std::find_if(segments.begin(), segments.end(), ph_curve);
  const auto other = std::find_if_not(segments.begin(), segments.end(), ph_curve);
  if (other == segments.end()) {
    const auto rational = std::find_if_not(segments.begin(), segments.end(), is_polynomial);
    return needs_polynomial(static_cast<std::size_t>(rational - segments.begin()), segments.size());
  }
  const std::string none = fmt::format(
      "needs a Pythagorean-hodograph curve, and {} is none",
      ph == segments.end() ? "this" : fmt::format("segment {}", other - segments.begin() + 1));
  if (is_straight(path))
    return none + " but a straight line, where any frame that does not turn is the right one";
  if (std::all_of(segments.begin(), segments.end(), is_polynomial))
    return none +
           " (\"phrame identify --near\" finds one near it, \"phrame construct\" one through "
           "points)";
  return none + " (\"phrame construct\" finds one through points)";
}

void add_reference(Command& command, std::string& name, const std::string& what) {
  command.add_choice("--frame", name, {"erf", "frenet"}, what);
}

Reference chosen_reference(const std::string& name) {
  return choose<Reference>("--frame", name, reference_names());
}

void require_reference(const std::optional<Reference>& asked, const UpOption& up,
                       const Path& path) {
  if (asked == Reference::euler_rodrigues && !path.has_erf())
    throw InputError("--frame", "\"erf\" " + needs_ph(path));
  if (up.vector && asked && asked != Reference::up)
    throw InputError("--up", std::string("is of --frame up, and --frame is ") + name_of(*asked));
}

void fail_for_spline(const std::string& option, const std::string& value) {
  throw InputError(option, "\"" + abbreviated(value) + "\" is for single curves; this is a spline");
}

void add_near(Command& command, std::optional<std::string>& near) {
  command.add_option("--near", "EPS", near,
                     "where control points are those of no PH curve, as rounded ones are, take\n"
                     "one that is at most EPS away");
}

void add_skip_invalid(Command& command, FileReading& reading) {
  command.add_flag("--skip-invalid", reading.skips_invalid,
                   "of tables, leave out rows that miss a number and points that are those\n"
                   "before them");
}

void RollOption::add_to(Command& command) {
  command.add_option(
      "--roll", "EXPR", roll,
      "an angle by which the frame is turned about e1 beside: 15deg, a rational function\n"
      "of t in radians, \"t^2/3\", or in degrees, \"30*t deg\", or a list of angles at\n"
      "t = 0, 1, ..., between which it is linear");
  command.add_option("--roll-column", "NAME", column,
                     "of a table of points: the column with these values in radians, \"bank\", or\n"
                     "degrees, \"bank:deg\"");
  command.not_with({"--roll"}, {"--roll-column"});
}

std::vector<Rational> CurveOptions::column(const std::string& option,
                                           const std::string& name) const {
  if (path == "-" && Exchange::current() == nullptr)
    throw InputError(option, "standard input is read once: the table is to be a file");
  return at_place(name_of_file(path), ":",
                  [&] { return read_column(read_file(path), name, reading); });
}

std::string RollOption::column_name() const {
  if (!column) return "";
  return column->ends_with(":deg") ? column->substr(0, column->size() - 4) : *column;
}

Roll RollOption::chosen(const CurveOptions& curve) const {
  if (roll) return at_place("--roll", ", ", [&] { return parse_roll(with_plain_minus(*roll)); });
  if (!column) return {};
  const bool are_degrees = column->ends_with(":deg");
  std::vector<Angle> angles;
  for (const Rational& x : curve.column("--roll-column", column_name()))
    angles.push_back(are_degrees ? Angle(x / 180, 0) : Angle(x));
  return Roll(angles);
}

void RollOption::check(const Roll& made, std::size_t segments) const {
  at_option(roll ? "--roll" : "--roll-column", [&] { made.require_along(segments); });
}

std::optional<Rational> parse_near_option(const std::optional<std::string>& near) {
  if (!near) return std::nullopt;
  Rational epsilon = parse_option("--near", *near);
  if (epsilon <= 0) throw InputError("--near", as_written(epsilon) + " is not a distance > 0");
  return epsilon;
}

void CurveOptions::add_curve_to(Command& command) {
  command.add_argument("CURVE", path,
                       "a curve file, \"-\" for standard input\n"
                       "(JSON, a table of points, SVG, DXF, STEP, IGES, G-code, glTF and others)");
  add_near(command, near);
  command.add_option("--max-corner", "ANGLE", max_corner,
                     "refuse a path whose tangent breaks by more at a joint: 1e-6, 5deg, pi/4");
  add_skip_invalid(command, reading);
  command.add_choice("--kind", reading.kind,
                     {"natural", "periodic", "polyline", "bezier", "bspline"},
                     "what the points of a table are: of a natural (default) or periodic cubic\n"
                     "spline or a polyline, or control points of a bezier curve or a bspline");
  command.add_option("--gap", "EPS", gap,
                     "close gaps between segments, and at the ends, of at most EPS (default: of\n"
                     "what rounding leaves)");
  command.add_option("--pick", "NAME", reading.pick,
                     "of a file with several curves, the one of this name");
  limits.near_option = "--near";
}

void CurveOptions::add_to(Command& command) {
  add_curve_to(command);
  command.add_output(output);
  add_max_degree(command, limits);
}

void CurveOptions::add_input_to(Command& command) {
  add_curve_to(command);
  add_max_degree(command, limits);
}

std::string CurveOptions::content() const { return bytes ? *bytes : read_file(path); }

NamedCurve CurveOptions::read_curve() const {
  // As a path the curve has e₁ = r′/|r′| at the start.
  const NamedPhPath named = near || given_path(path, reading) || !reading.is_plain()
                                ? read_path()
                                : NamedPhPath(read_by(read_one_curve, *this));
  require_polynomial(named.path.segments(), name_of_file(path));
  return one_curve(named);
}

NamedCurve CurveOptions::one_curve(const NamedPhPath& named) const {
  if (!named.path.is_curve())
    throw InputError(name_of_file(path) + ":/phrame", "this is a spline; one curve is wanted");
  return {named.name, named.path.segments().front(), named.near};
}

std::pair<NamedCurve, std::vector<Rational>> CurveOptions::read_curve_at(
    const Parameters& asked) const {
  auto [named, at] = read_path_at(asked);
  return {one_curve(named), std::move(at)};
}

std::pair<NamedPhPath, std::vector<Rational>> CurveOptions::read_path_at(
    const Parameters& asked) const {
  if (asked.kind() != ParameterKind::t) {
    const NamedPath named = read_any_path();
    std::vector<Rational> at = asked.fractions_on(named);
    return {at_place(path, ":", [&] { return ph_path_of(named); }), std::move(at)};
  }
  NamedPhPath named = read_path_with_preimages();
  std::vector<Rational> at = asked.fractions_on(named);
  return {std::move(named), std::move(at)};
}

NamedPhPath CurveOptions::read_path() const {
  NamedPhPath named = read_path_with_preimages();
  require_polynomial(named.path.segments(), name_of_file(path));
  return named;
}

std::variant<NamedPhPath, NotNear> CurveOptions::read_path_near() const {
  const Rational within = epsilon().value();
  const auto near_to = [&](const NamedPath& named) {
    return at_option("", [&] { return near_path(named, within); });
  };
  return at_place(name_of_file(path), ":", [&]() -> std::variant<NamedPhPath, NotNear> {
    if (const NamedPath* named = given_path(path, reading)) return near_to(*named);
    const std::string text = content();
    // Control points that are written as such may leave gaps, which near_path() closes.
    if (reading.is_plain() && !curve_file_format(text).empty())
      return phrame::read_path_near(text, within, limits);
    return near_to(read_any(text, *this));
  });
}

NamedPhPath CurveOptions::read_path_with_preimages() const {
  const auto within = epsilon();
  if (const NamedPath* named = given_path(path, reading); named != nullptr && !within)
    return at_place(path, ":", [&] { return ph_path_of(*named); });
  if (!within) return read_by(read_ph_path, *this);
  const std::string file = name_of_file(path);
  auto read = read_path_near();
  if (const auto* none = std::get_if<NotNear>(&read))
    throw InputError(file, to_line(*none, *within));
  auto& named = std::get<NamedPhPath>(read);
  if (named.near)
    note_at_end(fmt::format("{}: in its place a PH {} {}", file,
                            named.path.is_curve() ? "curve" : "spline", to_line(*named.near)));
  return std::move(named);
}

namespace {

std::string angle_text(const Corner& corner) {
  return fmt::format("{:.3g} radians at t = {}", approximate(corner.angle.enclose(64)),
                     corner.segment);
}

void refuse_corners_beyond(const Angle& most, const std::vector<Corner>& corners,
                           const std::string& file) {
  for (const Corner& corner : corners)
    if (sign_of(corner.angle + -to_real(most)) > 0)
      throw InputError(file, "the path has a corner of " + angle_text(corner) +
                                 ", more than --max-corner allows");
}

}  // namespace

NamedPath CurveOptions::read_any_path() const {
  std::optional<Angle> most;
  if (max_corner) {
    most = parse_angle_option("--max-corner", *max_corner);
    if (sign_of(to_real(*most)) < 0) throw InputError("--max-corner", "the angle is negative");
  }
  NamedPath named = read_near_or_any();
  if (!most && !is_for_frames) return named;
  const auto corners = phrame::corners(named.path);
  if (corners.empty()) return named;
  const std::string file = name_of_file(path);
  if (most) refuse_corners_beyond(*most, corners, file);
  constexpr double rounding = 1e-6;
  const Corner& greatest = phrame::greatest(corners);
  if (is_for_frames && approximate(greatest.angle.enclose(64)) > rounding)
    note(fmt::format(
        "{}: {}{}: frames turn there at once, by the least rotation, and curvature is "
        "infinite",
        file,
        corners.size() == 1 ? "1 corner, of "
                            : fmt::format("{} corners, the greatest of ", corners.size()),
        angle_text(greatest)));
  return named;
}

NamedPath CurveOptions::read_near_or_any() const {
  if (near) return read_path();
  if (const NamedPath* named = given_path(path, reading)) {
    if (gap) throw InputError("--gap", "is for files, not for a curve that was read before");
    return *named;
  }
  const auto* node = Exchange::content<JsonNode>(path);
  NamedPath read = node != nullptr ? read_any(*node, *this) : read_by(read_any<std::string>, *this);
  for (const std::string& text : read.notes) note(fmt::format("{}: {}", name_of_file(path), text));
  if (read.path.is_ph() || !is_for_frames) return read;
  if (const auto near_one = suggestion_of(read.path))
    note_at_end(fmt::format(
        "{}: a PH curve is at most {} away; with --near {} the answer has a closed form",
        name_of_file(path), upper_bound_text(near_one->distance),
        upper_bound_text(near_one->epsilon, 1)));
  return read;
}

void add_by(Command& command, std::string& by, const std::string& what, bool has_times) {
  std::vector<std::string> names = keys(parameter_kinds());
  std::string more;
  if (has_times) {
    names.emplace_back("time");
    more = ";\ntime: of a motion with --feed";
  }
  command.add_choice("--by", by, std::move(names),
                     what +
                         ", 0 to the number of segments;\n"
                         "native: the parameter of the file, as knots, times and s of formulas\n"
                         "are; unit: t over the number of segments; arc-length, or fraction of it" +
                         more);
}

void Parameters::add_to(Command& command, const std::vector<std::string>& others, bool has_times) {
  command.add_list("--at", "T,...", at, "values of t, separated by commas: 0,1/2,-3,0.25");
  command.add_number("--samples", samples, {2, 10'000'000},
                     "N equally spaced values of t from start to end (N ≥ 2), after those of --at");
  std::vector<std::string> all{"--at", "--samples"};
  all.insert(all.end(), others.begin(), others.end());
  add_by(command, by,
         fmt::format("what {} are values of: t (default)",
                     fmt::join(all, all.size() > 2 ? ", " : " and ")),
         has_times);
  command.only_with({"--by"}, all);
}

void require_parameter(const Path& path, ParameterKind kind) {
  if (kind == ParameterKind::unit && path.segments().size() == 1)
    throw InputError("--by", "\"unit\" is t itself along one segment");
}

Real t_by(const NamedPath& named, ParameterKind kind, const Rational& x) {
  require_parameter(named.path, kind);
  return parameter(at_option("--by", [&] { return Parametrization(named, kind); }).point(x).at);
}

ParameterKind Parameters::kind() const { return choose("--by", by, parameter_kinds()); }

Parametrization Parameters::on(const NamedPath& named) const {
  require_parameter(named.path, kind());
  return at_option("--by", [&] { return Parametrization(named, kind()); });
}

std::vector<Rational> Parameters::given() const { return parse_list_option("--at", at); }

std::vector<Rational> Parameters::fractions_on(const NamedPath& named) const {
  std::vector<Rational> ts = given();
  if (kind() == ParameterKind::t) {
    for (long k = 0; k < samples; ++k) ts.push_back(named.path.end() * Rational(k, samples - 1));
    return ts;
  }
  std::vector<Rational> found;
  for (const ParameterPoint& point : on(named).points(ts, samples)) {
    const Real t = parameter(point.at);
    if (!t.exact())
      throw InputError(
          "--by",
          fmt::format(
              "the t of the place {} is irrational, and this command takes t that are fractions",
              approximate(point.value.enclose(64))));
    found.push_back(*t.exact());
  }
  return found;
}

std::vector<std::string> split(const std::vector<std::string>& lists) {
  std::vector<std::string> parts;
  for (std::string_view rest : lists) {
    for (auto comma = rest.find(','); comma != std::string_view::npos; comma = rest.find(',')) {
      parts.emplace_back(trimmed(rest.substr(0, comma)));
      rest.remove_prefix(comma + 1);
    }
    parts.emplace_back(trimmed(rest));
  }
  return parts;
}

std::string with_plain_minus(std::string text) {
  constexpr std::string_view minus = "−";
  for (std::size_t at = text.find(minus); at != std::string::npos; at = text.find(minus, at))
    text.replace(at, minus.size(), "-");
  return text;
}

Rational parse_option(const std::string& option, const std::string& text) {
  return at_place(option, ", ", [&] { return parse_number(with_plain_minus(text)); });
}

Rational parse_positive_option(const std::string& option, const std::string& text) {
  const Rational x = parse_option(option, text);
  if (x <= 0) throw InputError(option, "\"" + abbreviated(text) + "\" is not > 0");
  return x;
}

Angle parse_angle_option(const std::string& option, const std::string& text) {
  return at_place(option, ", ", [&] { return parse_angle(with_plain_minus(text)); });
}

std::vector<Rational> parse_list_option(const std::string& option,
                                        const std::vector<std::string>& lists) {
  std::vector<Rational> numbers;
  for (const std::string& text : split(lists)) numbers.push_back(parse_option(option, text));
  return numbers;
}

Vector<Rational> parse_vector_option(const std::string& option, const std::string& text) {
  const auto parts = split({text});
  if (parts.size() != 3)
    throw InputError(option, "\"" + abbreviated(text) + "\" is not a vector x,y,z");
  return {parse_option(option, parts[0]), parse_option(option, parts[1]),
          parse_option(option, parts[2])};
}

Vector<Rational> parse_normal_option(const std::string& option, const std::string& text,
                                     const Path& path, const Place& at) {
  Vector<Rational> normal = parse_vector_option(option, text);
  at_option(option, [&] { require_start_normal(StartNormal(normal), path, at); });
  return normal;
}

void add_digits(Command& command, long& digits) {
  command.add_number(
      "--digits", digits, {1, 100'000},
      fmt::format("significant decimal digits, correctly rounded (default {})", digits));
}

void StartOptions::add_to(Command& command, Rule otherwise, const std::string& text) {
  otherwise_ = otherwise;
  const bool is_angle = otherwise == Rule::reference;
  const std::string by_default = text.empty() ? "default" : text;
  command.add_choice(
      "--start", rule, {"least", "erf", "up", "frenet"},
      fmt::format("f2 at t = 0, before --theta0 turns it: least{}, by the least rotation that\n"
                  "takes the x axis to e1, where it takes the y axis; or erf, up or frenet{}:\n"
                  "the frame that angles are measured from",
                  is_angle ? "" : fmt::format(" ({})", by_default),
                  is_angle ? fmt::format(" ({})", by_default) : ""));
  command.add_option("--theta0", "ANGLE", angle,
                     "the angle from there to f2 at t = 0: radians, or such as pi/4 or 45deg\n"
                     "(default 0)");
  command.add_option("--start-normal", "X,Y,Z", normal,
                     "f2 at t = 0, projected to the normal plane; instead of --start, --theta0");
  command.not_with({"--start-normal"}, {"--start", "--theta0"});
}

FrameStart StartOptions::start() const {
  if (normal) return StartNormal(parse_vector_option("--start-normal", *normal));
  const Angle turn = angle ? parse_angle_option("--theta0", *angle) : Angle();
  const bool is_least =
      rule.empty()
          ? otherwise_ == Rule::least_rotation
          : choose<bool>("--start", rule,
                         {{"least", true}, {"erf", false}, {"up", false}, {"frenet", false}});
  return is_least ? FrameStart(LeastRotation{turn}) : FrameStart(turn);
}

std::optional<FrameStart> StartOptions::given() const {
  if (rule.empty() && !angle && !normal) return std::nullopt;
  return start();
}

void StartOptions::check(const Path& path, Reference reference) const {
  if (const std::string& name = name_of(reference);
      !rule.empty() && rule != "least" && rule != name)
    throw InputError("--start", fmt::format("\"{}\" is not the frame that angles are measured from "
                                            "here, \"{}\"",
                                            rule, name));
  if (!normal) return;
  at_option("--start-normal", [&] { require_start_normal(std::get<StartNormal>(start()), path); });
}

void StartOptions::check(const Path& path, const std::optional<Vector<Rational>>& v,
                         std::optional<Reference> asked) const {
  check(path, reference_of(path, v, asked));
}

void UpOption::add_to(Command& command, const std::string& what) {
  command.add_option("--up", "X,Y,Z", vector, "the vector v that makes the\n" + what);
}

std::optional<Vector<Rational>> UpOption::chosen(const Path& path, bool is_wanted) const {
  if (!vector) return is_wanted ? std::optional(up_vector(path)) : std::nullopt;
  const Vector<Rational> v = parse_vector_option("--up", *vector);
  at_option("--up", [&] { require_up_vector(path, v); });
  return v;
}

void TextLength::add_to(Command& command) {
  command.add_flag("--full", is_full, "in text, abridge nothing: long polynomials, numbers, lists");
  command.only_with({"--full"}, {"--print text"});
}

void TextLength::write(const std::string& path, const std::string& printed) const {
  write_output(path, for_reading(printed, is_full));
}

void add_max_degree(Command& command, CurveLimits& limits) {
  command.add_number(
      "--max-degree", limits.max_degree, {1, 1'000'000},
      fmt::format("refuse curves of a higher degree (default {})", limits.max_degree));
}

}  // namespace phrame::cli
