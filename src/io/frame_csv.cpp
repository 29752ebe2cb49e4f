#include "phrame/io/frame_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\"";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> fields(std::string_view line) {
  std::vector<std::string_view> list;
  for (;;) {
    const auto comma = line.find(',');
    list.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return list;
    line.remove_prefix(comma + 1);
  }
}

/// Which columns hold what is read.
class Header {
 public:
  explicit Header(std::vector<std::string_view> names, long line)
      : names_(names.begin(), names.end()) {
    const auto fail = [&](const std::string& reason) {
      throw InputError(fmt::format("line {}", line), reason);
    };
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (std::find(names_.begin(), names_.begin() + static_cast<long>(k), names_[k]) !=
          names_.begin() + static_cast<long>(k))
        fail(fmt::format("the column \"{}\" is there twice", abbreviated(names_[k])));
    t_ = find<1>({"t"});
    f2_ = find<3>({"f2x", "f2y", "f2z"});
    f3_ = find<3>({"f3x", "f3y", "f3z"});
    e1_ = find<3>({"e1x", "e1y", "e1z"});
    q_ = find<4>({"qw", "qx", "qy", "qz"});
    if (!t_) fail("a column \"t\" is wanted");
    if (!f2_ && !q_) fail("columns f2x, f2y, f2z or qw, qx, qy, qz are wanted");
    if (f2_ && q_) fail("columns of vectors (f2x) and of quaternions (qw) exclude each other");
  }

  std::size_t size() const { return names_.size(); }
  GivenFrame frame(const std::vector<std::string_view>& row, long line,
                   const QuaternionConvention& convention) const;

 private:
  template <std::size_t N>
  using Columns = std::optional<std::array<std::size_t, N>>;

  template <std::size_t N>
  Columns<N> find(const std::array<std::string_view, N>& names) const {
    std::array<std::size_t, N> columns{};
    for (std::size_t k = 0; k < N; ++k) {
      const auto found = std::find(names_.begin(), names_.end(), names[k]);
      if (found == names_.end()) return std::nullopt;
      columns[k] = static_cast<std::size_t>(found - names_.begin());
    }
    return columns;
  }

  Rational number(const std::vector<std::string_view>& row, std::size_t column, long line) const {
    try {
      return parse_rational(row[column]);
    } catch (const InputError& error) {
      throw InputError(fmt::format("line {}, {}", line, abbreviated(names_[column])),
                       error.reason());
    }
  }

  Vector<Rational> vector(const std::vector<std::string_view>& row,
                          const std::array<std::size_t, 3>& columns, long line) const {
    return {number(row, columns[0], line), number(row, columns[1], line),
            number(row, columns[2], line)};
  }

  std::vector<std::string> names_;
  Columns<1> t_;
  Columns<3> f2_;
  Columns<3> f3_;
  Columns<3> e1_;
  Columns<4> q_;
};

GivenFrame Header::frame(const std::vector<std::string_view>& row, long line,
                         const QuaternionConvention& convention) const {
  GivenFrame frame{number(row, (*t_)[0], line), {}};
  if (f2_) {
    frame.f2 = vector(row, *f2_, line);
    if (f3_) frame.f3 = vector(row, *f3_, line);
    if (e1_) frame.tangent = vector(row, *e1_, line);
    return frame;
  }
  RationalQuaternion q{number(row, (*q_)[0], line), number(row, (*q_)[1], line),
                       number(row, (*q_)[2], line), number(row, (*q_)[3], line)};
  const Rational size = norm(q);
  if (size == 0) throw InputError(fmt::format("line {}", line), "the quaternion is 0");
  if (convention.is_inverse) q = {q.u, -q.v, -q.p, -q.q};
  const auto unit = [&](Vector<Rational> v) {
    for (Rational& x : v) x /= size;
    return v;
  };
  const std::array<Vector<Rational>, 3> axes{unit(rotated_i(q)), unit(rotated_j(q)),
                                             unit(rotated_k(q))};
  const std::size_t first = convention.tangent_axis;
  frame.tangent = axes[first];
  frame.f2 = axes[(first + 1) % 3];
  frame.f3 = axes[(first + 2) % 3];
  return frame;
}

}  // namespace

std::vector<GivenFrame> read_frames(std::string_view text, const QuaternionConvention& convention) {
  std::vector<GivenFrame> frames;
  std::optional<Header> header;
  for (long line = 1; !text.empty(); ++line) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view content = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (content.empty() || content.front() == '#') continue;
    const auto row = fields(content);
    if (!header) {
      header.emplace(row, line);
      continue;
    }
    if (row.size() != header->size())
      throw InputError(fmt::format("line {}", line),
                       fmt::format("{} numbers are wanted as in the header, not {}", header->size(),
                                   row.size()));
    frames.push_back(header->frame(row, line, convention));
  }
  if (!header) throw InputError("line 1", "a header with the names of the columns is wanted");
  if (frames.empty()) throw InputError("line 2", "there are no frames");
  return frames;
}

}  // namespace phrame
