#include "phrame/io/sifted_frames.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/near_decimal.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/near_rows.hpp"
#include "phrame/io/frame_parameters.hpp"
#include "phrame/io/read/frame_layout.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/text_table.hpp"
#include "phrame/ph/frame/frame_sieve.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 20U;

/// The lines of a file, one after the other; one that is longer than a block is of no use.
class Lines {
 public:
  Lines(const ReadBytes& read, std::uint64_t from) : read_(read), next_(from) {}

  /// Without its end, until the next call.
  std::optional<std::string_view> next() {
    auto end = block_.find('\n', at_);
    if (end == std::string::npos) {
      block_.erase(0, at_);
      at_ = 0;
      const std::size_t before = block_.size();
      block_ += read_(next_, block_size);
      next_ += block_.size() - before;
      end = block_.find('\n', before);
      if (end == std::string::npos) {
        if (block_.empty() || block_.size() >= block_size) return std::nullopt;
        end = block_.size();
      }
    }
    place_ = next_ - (block_.size() - at_);
    const std::string_view line = std::string_view(block_).substr(at_, end - at_);
    at_ = std::min(end + 1, block_.size());
    return line;
  }
  std::uint64_t place() const { return place_; }  ///< where the last one begins
  /// Is that where all has been read?
  bool is_at(std::uint64_t size) const { return at_ == block_.size() && next_ == size; }

 private:
  const ReadBytes& read_;
  std::uint64_t next_;  ///< behind the block
  std::string block_;
  std::size_t at_ = 0;
  std::uint64_t place_ = 0;
};

/// Empty lines and comments.
bool is_skipped(std::string_view line) {
  const std::string_view content = trimmed(line);
  return content.empty() || content.front() == '#';
}

/// Is there anything that a TextTable would not read by its separators alone?
bool is_plain(std::string_view content, char separator) {
  return content.find_first_of("\"\r") == std::string_view::npos &&
         (separator == ',' || content.find(',') == std::string_view::npos);
}

/// What is above the first row, and what the columns are.
struct Head {
  std::string text;
  char separator;
  std::size_t columns;
  FrameLayout::VectorColumns at;
  std::size_t row_length;  ///< of the first row, in bytes
};

std::optional<Head> head_of(const ReadBytes& read, const FrameReading& reading) {
  Lines lines(read, 0);
  std::string above;
  std::vector<std::string> first;  // of the lines that are not skipped
  while (first.size() < 3) {
    const auto line = lines.next();
    if (!line) return std::nullopt;
    if (!is_skipped(*line))
      first.emplace_back(*line);
    else if (first.empty())
      above.append(*line) += '\n';
  }
  // Arrays of NumPy, JSON and what is no table at all are of other bytes.
  if (std::string_view("[{\xEF\xFE\xFF\x93").find(trimmed(first[0]).front()) !=
      std::string_view::npos)
    return std::nullopt;
  const std::string few = above + first[0] + "\n" + first[1] + "\n" + first[2] + "\n";
  const TextTable table(few, TableForm{reading.names.empty(), "frames"});
  const bool has_header = table.rows() == 2;
  const bool may_be_matrices = table.names().empty() && reading.names.empty() &&
                               (table.columns() == 12 || table.columns() == 16);
  if ((!has_header && table.rows() != 3) || !table.notes().empty() || may_be_matrices)
    return std::nullopt;
  if (has_header) above += first[0] + "\n";
  GivenTable ignored;
  const auto at = frame_layout(table, reading, ignored).vector_columns();
  if (!at) return std::nullopt;
  return Head{above, table.separator(), table.columns(), *at, first[1].size() + 1};
}

/// Between separators, blanks around them left out; many blanks are one.
void split(std::string_view content, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  const std::string_view separators =
      separator == ' ' ? std::string_view(" \t") : std::string_view(&separator, 1);
  for (;;) {
    const auto end =
        separators.size() == 1 ? content.find(separator) : content.find_first_of(separators);
    cells.push_back(trimmed(content.substr(0, end)));
    if (end == std::string_view::npos) return;
    content.remove_prefix(end + 1);
    if (separator == ' ') content = trimmed(content);
  }
}

/// No value where there is no plain decimal in a column that is read.
std::optional<NearFrame> near_frame(const std::vector<std::string_view>& cells,
                                    const FrameLayout::VectorColumns& at) {
  bool is_plain = true;
  const auto number = [&](std::size_t column) {
    const auto x = near_decimal(cells[column]);
    is_plain = is_plain && x;
    return x.value_or(NearNumber{});
  };
  const auto vector = [&](const std::array<std::size_t, 3>& columns) {
    return Vector<NearNumber>{number(columns[0]), number(columns[1]), number(columns[2])};
  };
  NearFrame frame{number(at.t), vector(at.f2)};
  if (at.f3) frame.f3 = vector(*at.f3);
  if (at.tangent) frame.tangent = vector(*at.tangent);
  if (at.position) vector(*at.position);
  return is_plain ? std::optional(frame) : std::nullopt;
}

/// Of the rows behind the head; false where it is of no use.
bool sift(Lines& lines, std::uint64_t size, const Head& head, FrameSieve& sieve) {
  Stage stage("megabytes", size / block_size + 1);
  std::uint64_t done = 0;
  std::vector<std::string_view> cells;
  while (const auto line = lines.next()) {
    if (lines.place() / block_size > done) {
      ++done;
      stage.advance();
    }
    if (is_skipped(*line)) continue;
    const std::string_view content = trimmed(*line);
    if (!is_plain(content, head.separator)) return false;
    split(content, head.separator, cells);
    if (cells.size() != head.columns) return false;
    const auto frame = near_frame(cells, head.at);
    if (!frame || !sieve.add(*frame, lines.place())) return false;
  }
  return lines.is_at(size);
}

}  // namespace

std::optional<SiftedTable> sifted_frames(const ReadBytes& read, std::uint64_t size,
                                         const FrameReading& reading, const NamedPath& named,
                                         std::optional<ParameterKind> by,
                                         const FrameCheckOptions& options) {
  const bool is_by_length = by == ParameterKind::arc_length;
  if (by && by != ParameterKind::t && !is_by_length) return std::nullopt;
  const auto head = head_of(read, reading);
  if (!head) return std::nullopt;
  const std::size_t wanted = by ? 0 : most_guessed_frames + 1;
  const std::size_t at_most = 2 * (size / head->row_length);
  const auto angle = [&] { return angle_to(options.up, named.path); };
  if (at_most < wanted || !are_many_rows(at_most, named.path, is_by_length, angle))
    return std::nullopt;
  return rounding_to_nearest([&]() -> std::optional<SiftedTable> {
    FrameSieve sieve(angle(), options, is_by_length);
    Lines lines(read, head->text.size());
    if (!sift(lines, size, *head, sieve) || sieve.size() < wanted) return std::nullopt;
    SiftedTable table{head->text, {}, sieve.size(), sieve.faults(), sieve.greatest_step()};
    for (const FrameSieve::Row& row : sieve.rows()) {
      constexpr std::size_t longest = 8192;
      const std::string bytes = read(row.place, longest);
      const auto end = bytes.find('\n');
      if (end == std::string::npos && row.place + bytes.size() < size) return std::nullopt;
      table.text.append(bytes, 0, end) += '\n';
      table.numbers.push_back(row.number);
    }
    return table;
  });
}

namespace {

using Kind = FrameFinding::Kind;

/// Is what as many sums leave of it, as there are rows, nothing beside it?
bool is_certain(const RealBall& x, std::size_t rows) {
  return power_of_two(16) * static_cast<long>(rows) * x.radius() < abs(x.midpoint());
}

/// Where several samples are off by the same, as on symmetric curves, the worst one is the first
/// whose ball is beyond that of the maximum so far, which is rounded with each sample. Is it the
/// same with all of them, the others being less?
bool is_worst_of_all(const FrameVerdict& verdict, const SiftedTable& few) {
  constexpr long bits = 128;
  const Rational nearly = verdict.max_error.lower() * (1 - power_of_two(-80));
  const auto equals = std::ranges::count_if(verdict.errors, [&](const auto& error) {
    return error && absolute(*error).upper() >= nearly;
  });
  if (equals == 1) return true;
  RealBall most;
  std::size_t worst = 0;
  std::size_t row = 0;
  for (std::size_t k = 0; k < verdict.errors.size(); ++k) {
    for (; row < few.numbers[k]; ++row) most = max(most, RealBall(), bits);
    ++row;
    if (!verdict.errors[k]) continue;
    const RealBall size = absolute(*verdict.errors[k]);
    if (size.upper() > most.upper()) worst = k;
    most = max(most, size, bits);
  }
  return worst == verdict.worst_sample && radius_of(most).midpoint() > power_of_two(-200);
}

/// How many t there are of frames with a principal normal, up to 4.
std::size_t number_with_normal(const CheckAnswer& found) {
  std::set<Rational> parameters;
  for (std::size_t k = 0; k < found.frames.size() && parameters.size() < 4; ++k)
    if (found.verdict.deviations[k].from_normal) parameters.insert(found.frames[k].t);
  return parameters.size();
}

/// Would it be found of all rows, too, and with the same numbers?
bool is_finding_for_all(const FrameFinding& finding, const RealBall& way, const SiftedTable& few) {
  for (const auto& x : {finding.amount, finding.residual})
    if (x && !is_certain(*x, few.rows)) return false;
  switch (finding.kind) {
    case Kind::flip:
    case Kind::frenet:
    case Kind::euler_rodrigues:
    case Kind::turned_backwards:
    case Kind::fixed_up:
      return false;
    case Kind::drift:  // no step is more than a quarter of the way
      return 4 * exact_rational(few.greatest_step.upper) <= way.lower();
    case Kind::irregular:  // one is, or it comes back by more than half of it
      return 4 * exact_rational(few.greatest_step.lower) > way.upper() ||
             2 * way.upper() < finding.amount->lower();
    default:
      return true;
  }
}

}  // namespace

bool is_for_all(const CheckAnswer& found, const SiftedTable& few) {
  const FrameVerdict& verdict = found.verdict;
  if (verdict.max_error.upper() > Rational(37, 25)) return false;
  const bool is_close = verdict.max_error.upper() <= found.options.tolerance;
  if (!is_worst_of_all(verdict, few) || (verdict.drift && !is_certain(*verdict.drift, few.rows)) ||
      (!is_close && number_with_normal(found) < 4))
    return false;
  const auto first = std::ranges::find_if(verdict.errors, [](const auto& e) { return !!e; });
  const auto last = std::find_if(verdict.errors.rbegin(), verdict.errors.rend(),
                                 [](const auto& e) { return !!e; });
  const RealBall way = absolute(subtract(**last, **first, 128));
  return std::ranges::all_of(verdict.findings, [&](const FrameFinding& finding) {
    return is_finding_for_all(finding, way, few);
  });
}

std::vector<std::vector<std::size_t>> samples_of_all(const FrameVerdict& verdict,
                                                     const SiftedTable& few) {
  std::vector<std::vector<std::size_t>> all;
  for (const FrameFinding& finding : verdict.findings) {
    std::vector<std::size_t> of_few;
    for (const std::size_t k : finding.samples) of_few.push_back(few.numbers[k]);
    const auto told = std::ranges::find(FrameSieve::told_faults, finding.kind);
    std::vector<std::size_t> samples;
    if (told == FrameSieve::told_faults.end())
      samples = std::move(of_few);
    else
      std::ranges::set_union(
          of_few, few.faults[static_cast<std::size_t>(told - FrameSieve::told_faults.begin())],
          std::back_inserter(samples));
    all.push_back(std::move(samples));
  }
  return all;
}

}  // namespace phrame
