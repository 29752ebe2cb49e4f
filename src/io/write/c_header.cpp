#include "phrame/io/write/c_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/io/write/frame_start.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/version.hpp"

namespace phrame::inline v0 {
namespace {

/// `items` of one line each, up to a line of 100 characters.
template <class T>
std::string wrapped(const std::vector<T>& items, const char* format) {
  std::string text;
  std::size_t width = 0;
  for (const T& item : items) {
    const std::string word = fmt::format(fmt::runtime(format), item) + ",";
    const bool fits = width > 0 && width + 1 + word.size() <= 100;
    text += fits ? " " : text.empty() ? "  " : "\n  ";
    width = (fits ? width : 1) + 1 + word.size();
    text += word;
  }
  return text;
}

/// The tables of one function: rows of center, scale and coefficients, ends and first pieces.
std::string tables(const std::string& name, const PiecewisePolynomial& p, const char* index) {
  std::string rows;
  for (const PolynomialPiece& piece : p.pieces()) {
    std::vector<double> row{piece.center, piece.scale};
    row.insert(row.end(), piece.coefficients.begin(), piece.coefficients.end());
    rows += fmt::format("  {{{:a}}},\n", fmt::join(row, ", "));
  }
  return fmt::format(
      "static const double {0}_rows[{1}][{2}] = {{\n{3}}};\n"
      "static const double {0}_ends[{4}] = {{\n{5}\n}};\n"
      "static const {8} {0}_first[{6}] = {{\n{7}\n}};\n\n",
      name, p.pieces().size(), 2 + p.shape().size(), rows, p.ends().size(),
      wrapped(p.ends(), "{:a}"), p.first().size(), wrapped(p.first(), "{}"), index);
}

constexpr const char* preamble =
    R"(/*
 * {title}
 *
 * double {p}_theta(double t)
 *   The angle in radians, continuous but at corners of the path, of the rotation-minimizing frame (f2, f3) to the
 *   {reference};
 *   f2 = cos(theta) {second} + sin(theta) {third}, theta(0) = {start}.
{normal} *   Its error is at most {P}_THETA_ERROR = {angle_error}.
 *
 * void {p}_theta_array(const double *t, double *theta, size_t n)
 *   theta[k] = {p}_theta(t[k]), to the last bit where nothing is fused; theta may be t. Fast for
 *   ascending t, and wherever neighbours are near each other: then vector instructions are made of
 *   it, by gcc with -O3.
 *
{frame_text} * For {from} <= t <= {to}; NaN for other t, and where doubles are not rounded to nearest.
 *
{near} * C99, C11, or C++17 and later. The errors are proved, rounding included, for IEEE 754 doubles
 * rounded to nearest, with or without fused multiplication and addition; not where sums are
 * rearranged, as by -ffast-math.
 * Made by phrame {version}. Do not edit.
 */
)"
    "#ifndef {p}_H\n"
    "#define {p}_H\n\n"
    "#include <float.h>\n"
    "#include <stddef.h>\n\n"
    "#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \\\n"
    "    FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD > 64\n"
    "#error \"the errors are not proved where doubles are computed loosely, or with more digits\"\n"
    "#endif\n"
    "#if FLT_RADIX != 2 || DBL_MANT_DIG != 53\n"
    "#error \"the errors are proved for IEEE 754 doubles only\"\n"
    "#endif\n\n"
    R"(/* An array without elements where constants are floats, as by -fsingle-precision-constant. */
typedef char {p}_has_double_constants[sizeof(1.0) == sizeof(double) ? 1 : -1];

#define {P}_FROM {from_hex}
#define {P}_TO {to_hex}
#define {P}_THETA_ERROR {angle_error_hex}
{frame_define}
)";

constexpr const char* frame_text =
    R"( * void {p}_frame(double t, double f1[3], double f2[3], double f3[3])
 *   The frame: f1 {tangent}, f2 as above, f3 = cos(theta) e3 - sin(theta) e2.
 *   The error of every component is at most {P}_FRAME_ERROR = {frame_error}.
 *
 * void {p}_frame_array(const double *t, double *frames, size_t n)
 *   The frames at t[0], t[1], ...: of each, nine numbers f1, f2, f3; fast as above.
 *
)";

constexpr const char* find_function =
    R"(/* Are doubles rounded to nearest? */
static inline int {p}_rounds_to_nearest(void)
{{
  const volatile double tiny = 0x1p-60;
  return 1 + tiny == 1 && 1 - tiny == 1;
}}

static inline int {p}_is_inside(double t)
{{
  return t >= {P}_FROM && t <= {P}_TO;
}}

static inline {number} {p}_find(double t, double cells_per_unit,
                                const {index} *first, const double *ends)
{{
  const {number} cell = ({number})((t - {P}_FROM) * cells_per_unit);
  {number} low = first[cell];
  {number} high = first[cell + 1];
  if (high - low <= 1) return low + ({number})((low < high) & (t >= ends[high]));
  while (low < high) {{
    const {number} middle = (low + high + 1) / 2;
    if (t < ends[middle])
      high = middle - 1;
    else
      low = middle;
  }}
  return low;
}}

/* Loops of so many turns are made of vector instructions by compilers. */
enum {{ {p}_block = 16 }};

/* How many of t[0], t[1], ..., of so many, a block at most, are between low and high, as t[0] is?
 * By one comparison: where t are in disorder, each of two would go either way. */
static inline size_t {p}_run(const double *t, size_t many, double low, double high)
{{
  size_t k = 1;
  while (k < many && k < {p}_block && (t[k] - low) * (high - t[k]) > 0) ++k;
  return k;
}}

/* Polynomial number j of so many in a row of the table, at a block of t in its piece. */
static inline void {p}_horner(const double *c, int j, int polynomials, const double *t, double *s)
{{
  double y[{p}_block], sum[{p}_block];
  for (int k = 0; k < {p}_block; ++k) {{
    y[k] = (t[k] - c[0]) * c[1];
    sum[k] = c[2 + j];
  }}
  c += 2 + j;
  for (int m = 1; m < {degree}; ++m)
    for (int k = 0; k < {p}_block; ++k) sum[k] = sum[k] * y[k] + c[m * polynomials];
  const double first = c[{degree} * polynomials], second = c[({degree} + 1) * polynomials];
  for (int k = 0; k < {p}_block; ++k) s[k] = first + (second + sum[k] * y[k]);
}}

)";

constexpr const char* theta_function =
    R"(static inline double {p}_theta_by(const double *c, double t)
{{
  const double y = (t - c[0]) * c[1];
  double s = c[2];
  for (int k = 3; k < {constant}; ++k) s = s * y + c[k];
  return c[{constant}] + (c[{constant} + 1] + s * y);
}}

static inline double {p}_theta(double t)
{{
  if (!({p}_is_inside(t) && {p}_rounds_to_nearest())) return (t - t) / (t - t);
  return {p}_theta_by({p}_theta_rows[{p}_find(t, {cells}, {p}_theta_first, {p}_theta_ends)], t);
}}

static inline void {p}_theta_array(const double *t, double *theta, size_t n)
{{
  const int is_nearest = {p}_rounds_to_nearest();
  for (size_t k = 0, size; k < n; k += size) {{
    size = 1;
    if (!(is_nearest && {p}_is_inside(t[k]))) {{
      theta[k] = (t[k] - t[k]) / (t[k] - t[k]);
      continue;
    }}
    const {number} i = {p}_find(t[k], {cells}, {p}_theta_first, {p}_theta_ends);
    const double *c = {p}_theta_rows[i];
    size = {p}_run(t + k, n - k, {p}_theta_ends[i], {p}_theta_ends[i + 1]);
    if (size == {p}_block) {{
      double s[{p}_block];
      {p}_horner(c, 0, 1, t + k, s);
      for (size_t m = 0; m < {p}_block; ++m) theta[k + m] = s[m];
    }} else {{
      for (size_t m = k; m < k + size; ++m) theta[m] = {p}_theta_by(c, t[m]);
    }}
  }}
}}

)";

constexpr const char* frame_function =
    R"(/* Of the unit quaternion b of the rotation. */
static inline void {p}_rotate(double u, double v, double p, double q, double f1[3], double f2[3], double f3[3])
{{
  const double uu = u * u, vv = v * v, pp = p * p, qq = q * q;
  f1[0] = uu + vv - pp - qq;
  f1[1] = 2 * (u * q + v * p);
  f1[2] = 2 * (v * q - u * p);
  f2[0] = 2 * (v * p - u * q);
  f2[1] = uu - vv + pp - qq;
  f2[2] = 2 * (u * v + p * q);
  f3[0] = 2 * (u * p + v * q);
  f3[1] = 2 * (p * q - u * v);
  f3[2] = uu - vv - pp + qq;
}}

static inline void {p}_frame_by(const double *c, double t, double f1[3], double f2[3], double f3[3])
{{
  const double y = (t - c[0]) * c[1];
  double b[4];
  for (int k = 0; k < 4; ++k) b[k] = c[2 + k];
  for (int j = 6; j < {constant}; j += 4)
    for (int k = 0; k < 4; ++k) b[k] = b[k] * y + c[j + k];
  for (int k = 0; k < 4; ++k) b[k] = c[{constant} + k] + (c[{constant} + 4 + k] + b[k] * y);
  {p}_rotate(b[0], b[1], b[2], b[3], f1, f2, f3);
}}

static inline void {p}_frame(double t, double f1[3], double f2[3], double f3[3])
{{
  if (!({p}_is_inside(t) && {p}_rounds_to_nearest())) {{
    for (int k = 0; k < 3; ++k) f1[k] = f2[k] = f3[k] = (t - t) / (t - t);
    return;
  }}
  {p}_frame_by({p}_frame_rows[{p}_find(t, {cells}, {p}_frame_first, {p}_frame_ends)], t, f1, f2, f3);
}}

static inline void {p}_frame_array(const double *t, double *frames, size_t n)
{{
  const int is_nearest = {p}_rounds_to_nearest();
  for (size_t k = 0, size; k < n; k += size) {{
    double *to = frames + 9 * k;
    size = 1;
    if (!(is_nearest && {p}_is_inside(t[k]))) {{
      for (int i = 0; i < 9; ++i) to[i] = (t[k] - t[k]) / (t[k] - t[k]);
      continue;
    }}
    const {number} i = {p}_find(t[k], {cells}, {p}_frame_first, {p}_frame_ends);
    const double *c = {p}_frame_rows[i];
    size = {p}_run(t + k, n - k, {p}_frame_ends[i], {p}_frame_ends[i + 1]);
    if (size == {p}_block) {{
      double b[4][{p}_block];
      for (int j = 0; j < 4; ++j) {p}_horner(c, j, 4, t + k, b[j]);
      for (int m = 0; m < {p}_block; ++m, to += 9)
        {p}_rotate(b[0][m], b[1][m], b[2][m], b[3][m], to, to + 3, to + 6);
    }} else {{
      for (size_t m = k; m < k + size; ++m, to += 9) {p}_frame_by(c, t[m], to, to + 3, to + 6);
    }}
  }}
}}

)";

/// "4.4e-16", rounded up.
std::string decimal_above(double x) { return upper_bound_text(exact_rational(x)); }

/// As a comment in C may hold it: on one line, ASCII, and not its end.
std::string in_comment(const std::string& name) {
  std::string text = abbreviated(name, 60);
  for (char& c : text)
    if (c < ' ' || c > '~' || c == '/' || c == '\\') c = '?';
  return text;
}

/// What the angle is measured from, as the comment has it.
std::string about_reference(const CompiledAnswer& header) {
  if (header.reference == Reference::frenet)
    return "Frenet frame, tangent, normal n and binormal b, continued through inflections";
  if (header.up)
    return fmt::format(
        "frame (e1, e2, e3) of v = {},\n *   e2 = v x e1/|v x e1|, e3 = e1 x e2; segment k has k "
        "<= t <= k + 1",
        abbreviated(*header.up));
  return std::string(
             "Euler-Rodrigues frame (e1, e2, e3) = (A i A*, A j A*, A k A*)/|A|^2, where\n"
             " *   A = u + v i + p j + q k is the preimage of the ") +
         (header.path.path.segments().size() == 1
              ? "curve"
              : "segment, chosen such that this frame is\n"
                " *   continuous; segment k has k <= t <= k + 1");
}

/// What f1 is; two lines.
const char* about_tangent(const CompiledAnswer& header) {
  return header.up
             ? "is the unit tangent r'/|r'|, or its opposite behind a cusp\n *   where r turns "
               "back"
             : "along A i A* (the unit tangent, or its opposite where the multiplier is\n *   "
               "negative)";
}

/// θ(0).
std::string start_of(const CompiledAnswer& header) {
  if (const auto* exact = std::get_if<FrameAngle>(&header.start_angle))
    return abbreviated(to_string(*exact));
  return std::get<Decimal>(header.start_angle).value;
}

/// A line of the comment, where f2 does not start at an angle to the reference frame.
std::string about_start(const FrameStart& start) {
  if (const auto* least = std::get_if<LeastRotation>(&start))
    return fmt::format(" *   At the start {}.\n", to_sentence(*least, true));
  const auto* normal = std::get_if<StartNormal>(&start);
  if (normal == nullptr) return "";
  return fmt::format(" *   f2(0) is along {}, projected to the normal plane.\n",
                     abbreviated(normal->vector));
}

/// A paragraph of the comment, where the curve stands for another.
std::string about_curve(const std::optional<Nearness>& near) {
  if (!near) return "";
  const std::string frames = near->rmf_difference
                                 ? fmt::format(
                                       ";\n * rotation-minimizing frames of the two differ by at "
                                       "most {} radians",
                                       upper_bound_text(*near->rmf_difference))
                                 : "";
  return fmt::format(
      " * The curve is an exact one that is at most {} from the one that was given{}.\n *\n",
      upper_bound_text(near->distance), frames);
}

}  // namespace

std::string to_c_header(const CompiledAnswer& header, const std::string& prefix) {
  using fmt::arg;
  const std::string& p = prefix;
  std::string upper = p;
  std::transform(p.begin(), p.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  // An unsigned short has 16 bits, and an unsigned long 32, or more.
  const auto is_long = [](const PiecewisePolynomial& table) {
    return table.pieces().size() > 65536;
  };
  const bool needs_long = is_long(*header.angle) || (header.rotation && is_long(*header.rotation));
  const char* index = needs_long ? "unsigned long" : "unsigned short";
  const char* number = needs_long ? "unsigned long" : "unsigned";
  const auto fill = [&](const char* text, const PiecewisePolynomial& table) {
    const long constant = 2 + table.shape().position(0);
    return fmt::format(fmt::runtime(text), arg("p", p), arg("P", upper), arg("index", index),
                       arg("number", number),
                       arg("cells", fmt::format("{:a}", table.cells_per_unit())),
                       arg("constant", constant), arg("degree", table.shape().degree));
  };
  std::string about_frame, define_frame;
  if (header.rotation) {
    const double error = component_error(header);
    about_frame = fmt::format(fmt::runtime(frame_text), arg("p", p), arg("P", upper),
                              arg("tangent", about_tangent(header)),
                              arg("frame_error", decimal_above(error)));
    define_frame = fmt::format("#define {}_FRAME_ERROR {:a}\n", upper, error);
  }
  const double error = angle_error(header);
  const bool is_frenet = header.reference == Reference::frenet;
  const std::string& name = header.path.name;
  std::string text = fmt::format(
      fmt::runtime(preamble), arg("p", p), arg("P", upper),
      arg("title", name.empty() ? "A rotation-minimizing frame"
                                : "A rotation-minimizing frame of " + in_comment(name)),
      arg("reference", about_reference(header)), arg("second", is_frenet ? "n" : "e2"),
      arg("third", is_frenet ? "b" : "e3"), arg("start", start_of(header)),
      arg("normal", about_start(header.start)), arg("near", about_curve(header.path.near)),
      arg("angle_error", decimal_above(error)), arg("angle_error_hex", fmt::format("{:a}", error)),
      arg("frame_text", about_frame), arg("frame_define", define_frame),
      arg("from", header.angle->from()), arg("to", header.angle->to()),
      arg("from_hex", fmt::format("{:a}", header.angle->from())),
      arg("to_hex", fmt::format("{:a}", header.angle->to())), arg("version", version));
  text += fill(find_function, *header.angle);
  text += tables(p + "_theta", *header.angle, index) + fill(theta_function, *header.angle);
  if (header.rotation)
    text += tables(p + "_frame", *header.rotation, index) + fill(frame_function, *header.rotation);
  return text + "#endif\n";
}

std::string prefix_from(const std::string& name) {
  std::string prefix;
  for (const char c : name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_plain)
      prefix += c;
    else if (!prefix.empty() && prefix.back() != '_')
      prefix += '_';
  }
  prefix = prefix.substr(0, 40);
  while (!prefix.empty() && prefix.back() == '_') prefix.pop_back();
  if (prefix.empty()) return "curve";
  if (std::isdigit(static_cast<unsigned char>(prefix.front())) != 0) prefix.insert(0, "curve_");
  return prefix;
}

bool is_prefix(const std::string& text) {
  const auto is_letter = [](unsigned char c) { return c < 128 && std::isalpha(c) != 0; };
  return !text.empty() && text.size() <= 60 && text.back() != '_' &&
         text.find("__") == std::string::npos && is_letter(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), [&](unsigned char c) {
           return is_letter(c) || (c < 128 && std::isdigit(c) != 0) || c == '_';
         });
}

}  // namespace phrame
