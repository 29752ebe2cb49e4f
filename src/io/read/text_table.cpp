#include "phrame/io/read/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/column_name.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::string_view blanks_in_line = " \t\r";

/// Where the field ends that the line begins with, npos at its end; separators in quotes are none.
std::size_t end_of_field(std::string_view line, std::string_view separators) {
  const auto quote = line.find_first_not_of(' ');
  if (quote == std::string_view::npos || line[quote] != '"') return line.find_first_of(separators);
  auto close = line.find('"', quote + 1);
  while (close != std::string_view::npos && line.substr(close + 1).starts_with('"'))
    close = line.find('"', close + 2);  // "" is a quote in quotes
  if (close == std::string_view::npos)
    throw InputError(fmt::format("the quote before \"{}\" is not closed on its line",
                                 abbreviated(line.substr(quote + 1))));
  return line.find_first_of(separators, close + 1);
}

/// Between separators; many blanks are one.
Cells fields(std::string_view line, char separator) {
  const std::string_view separators =
      separator == ' ' ? blanks_in_line : std::string_view(&separator, 1);
  Cells list;
  for (;;) {
    const auto end = end_of_field(line, separators);
    list.push_back(trimmed(line.substr(0, end), " \t\r\""));
    if (end == std::string_view::npos) return list;
    line.remove_prefix(end + 1);
    if (separator == ' ') line = trimmed(line, blanks_in_line);
  }
}

bool has_outside_quotes(std::string_view line, char wanted) {
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == wanted && !is_quoted) return true;
  }
  return false;
}

/// A decimal as it is written: [sign] digits mark digits [exponent].
struct WrittenDecimal {
  char mark;               ///< '.' or ','
  std::size_t before = 0;  ///< digits in front of it
  std::size_t behind = 0;
  bool begins_with_zero = false;
};

std::optional<WrittenDecimal> decimal(std::string_view field) {
  constexpr std::string_view digits = "0123456789";
  if (field.starts_with('-') || field.starts_with('+')) field.remove_prefix(1);
  const auto mark = field.find_first_not_of(digits);
  if (mark == std::string_view::npos || (field[mark] != '.' && field[mark] != ','))
    return std::nullopt;
  auto end = std::min(field.find_first_not_of(digits, mark + 1), field.size());
  const WrittenDecimal found{field[mark], mark, end - mark - 1, field.starts_with('0')};
  if (found.before + found.behind == 0) return std::nullopt;
  if (end < field.size() && std::string_view("eEdD").find(field[end]) != std::string_view::npos) {
    ++end;
    if (end < field.size() && (field[end] == '-' || field[end] == '+')) ++end;
    if (end == field.size() || field.find_first_not_of(digits, end) != std::string_view::npos)
      return std::nullopt;
    end = field.size();
  }
  return end == field.size() ? std::optional(found) : std::nullopt;
}

/// Is it a row of numbers between tabs, of which some have a decimal comma?
bool has_commas_between_tabs(std::string_view line) {
  const Cells cells = fields(line, '\t');
  bool has_comma = false;
  for (const std::string_view cell : cells) {
    const auto number = decimal(cell);
    if (number && number->mark == ',' && number->behind > 0)
      has_comma = true;
    else if (cell.find(',') != std::string_view::npos)
      return false;
  }
  return cells.size() > 1 && has_comma;
}

char separator_of(std::string_view line) {
  if (has_outside_quotes(line, '\t') && !has_outside_quotes(line, ';') &&
      has_commas_between_tabs(line))
    return '\t';
  for (const char c : {';', ',', '\t'})
    if (has_outside_quotes(line, c)) return c;
  return ' ';
}

/// "1.0D+00", as Fortran writes numbers of double precision, with an E; else as it is.
std::string with_e(std::string_view field) {
  std::string text(field);
  const auto at = text.find_first_of("dD");
  if (at == std::string::npos || at == 0 || text.find_first_not_of("+-.,0123456789") != at)
    return text;
  text[at] = 'e';
  return text;
}

/// Something meant for a number, as names are not.
bool is_like_number(std::string_view field) {
  constexpr std::string_view first = "+-.0123456789";
  const std::string word = lower_case(field);
  return (!field.empty() && field != "-" && first.find(field.front()) != std::string_view::npos) ||
         word == "nan" || word == "inf";
}

}  // namespace

std::vector<std::string> header_names(std::string_view line) {
  line = trimmed(line, blanks_in_line);
  std::vector<std::string> names;
  for (const std::string_view field : fields(line, separator_of(line)))
    names.push_back(column_name(field).name);
  return names;
}

std::string TextTable::header_place() const { return line_place(header_line_); }

std::string TextTable::place(std::size_t row) const { return line_place(rows_[row].line); }

TextTable::TextTable(std::string_view text, const TableForm& reading) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError("line 1", "the text is UTF-16; UTF-8 is wanted");
  if (text.starts_with("PK\x03\x04"))
    throw InputError("line 1",
                     "this is an archive (.npz?); an array saved by numpy.save is wanted");
  text = without_mark(text);
  if (text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size())).starts_with('{'))
    throw InputError("line 1", "this is JSON; a table of text or an array of NumPy is wanted");
  for (long line = 1; !text.empty(); ++line) {
    const auto end = std::min(text.find_first_of("\r\n"), text.size());
    add(trimmed(text.substr(0, end), blanks_in_line), line);
    const auto next = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
    text.remove_prefix(std::min(next, text.size()));
  }
  if (names_.empty() && rows_.empty())
    throw InputError("line 1", "a table of numbers is wanted, below the names of its columns");
  if (rows_.empty())
    throw InputError(line_place(header_line_ + 1), fmt::format("there are no {}", reading.row));
  if (reading.reads_comment && names_.empty() && !comment_.empty()) take_comment_for_header();
  take_units_off();
  require_equal_widths();
  find_decimal_mark();
}

void TextTable::add(std::string_view content, long line) {
  if (content.empty()) {
    has_gap_ = !rows_.empty();
    return;
  }
  if (content.front() == '#') {
    if (!rows_.empty() || !names_.empty()) return;
    content.remove_prefix(std::min(content.find_first_not_of('#'), content.size()));
    comment_ = trimmed(content, blanks_in_line);
    comment_line_ = line;
    return;
  }
  const bool is_first = separator_ == 0;
  Cells row;
  try {
    if (is_first) separator_ = separator_of(content);
    row = fields(content, separator_);
  } catch (const InputError& error) {
    throw InputError(line_place(line), error.reason());
  }
  if (is_first && (std::none_of(row.begin(), row.end(), is_like_number) ||
                   std::find(row.begin(), row.end(), "t") != row.end())) {
    names_.assign(row.begin(), row.end());
    header_line_ = line;
  } else {
    rows_.push_back({std::move(row), line, has_gap_});
    has_gap_ = false;
  }
}

/// numpy.savetxt writes its header as a comment, with the separators that the caller wrote.
void TextTable::take_comment_for_header() {
  for (const char separator : {separator_, ';', ',', '\t', ' '}) {
    const Cells words = fields(comment_, separator);
    if (words.size() != rows_.front().fields.size()) continue;
    names_.assign(words.begin(), words.end());
    header_line_ = comment_line_;
    return;
  }
}

void TextTable::require_equal_widths() const {
  for (const Row& row : rows_)
    if (row.fields.size() != columns())
      throw InputError(
          line_place(row.line),
          fmt::format("{} here, but {} in {}", counted(row.fields.size(), "number"), columns(),
                      names_.empty() ? "the first line of them" : "the header"));
}

/// Those of the names, and of a row of them below.
void TextTable::take_units_off() {
  if (names_.empty()) return;
  units_.resize(names_.size());
  for (std::size_t k = 0; k < names_.size(); ++k) {
    ColumnName name = column_name(names_[k]);
    names_[k] = std::move(name.name);
    units_[k] = std::move(name.unit);
  }
  const Cells& first = rows_.front().fields;
  const auto is_of_units = [](std::string_view field) { return field.empty() || is_unit(field); };
  const bool has_letters = std::ranges::any_of(first, [](std::string_view field) {
    return !field.empty() && !is_like_number(field) && field != "-";
  });
  const auto empty = static_cast<std::size_t>(std::ranges::count(first, std::string_view()));
  if (first.size() != names_.size() || 2 * empty >= first.size() || !has_letters ||
      !std::ranges::all_of(first, is_of_units))
    return;
  for (std::size_t k = 0; k < first.size(); ++k)
    if (units_[k].empty()) units_[k] = unit_in(first[k]);
  rows_.erase(rows_.begin());
  if (rows_.empty()) throw InputError(line_place(header_line_ + 1), "there are only units");
}

/// A comma is a decimal one where no number has a point and at least one can be read in no other
/// way: 1,234 may be 1234.
void TextTable::find_decimal_mark() {
  const std::string_view* shown = nullptr;
  const auto is_surely_decimal = [](const WrittenDecimal& number) {
    return number.behind != 3 || number.before == 0 || number.before > 3 || number.begins_with_zero;
  };
  for (const Row& row : rows_)
    for (const std::string_view& field : row.fields) {
      const auto number = decimal(field);
      if (!number) continue;
      if (number->mark == '.') {
        has_point_ = true;
        return;
      }
      if (is_surely_decimal(*number) && shown == nullptr) shown = &field;
    }
  if (shown == nullptr) return;
  has_decimal_comma_ = true;
  std::string read(*shown);
  std::ranges::replace(read, ',', '.');
  notes_.push_back(
      fmt::format("commas are decimal ones: {} is {}", abbreviated(*shown), abbreviated(read)));
}

bool TextTable::is_missing(std::size_t row, std::size_t column) const {
  return is_missing_text(rows_[row].fields[column]);
}

Rational TextTable::number(std::size_t row, std::size_t column) const {
  const std::string_view field = rows_[row].fields[column];
  if (field.empty()) throw InputError("the field is empty");
  std::string text = with_e(field);
  if (const auto given = decimal(field); given && given->mark == ',' && !has_decimal_comma_)
    throw InputError(
        fmt::format("\"{}\" is not {}", abbreviated(field),
                    has_point_ ? "a number: decimals elsewhere have a point, not a comma"
                               : "clear: its comma may be a decimal one or one of thousands"));
  else if (given && given->mark == ',')
    std::ranges::replace(text, ',', '.');
  return parse_rational(text);
}

}  // namespace phrame
