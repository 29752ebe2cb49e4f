#include "phrame/io/read/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::string_view blanks_in_line = " \t\r";

std::string_view trimmed(std::string_view text, std::string_view characters) {
  const auto first = text.find_first_not_of(characters);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(characters) - first + 1);
}

char separator_of(std::string_view line) {
  for (const char c : {';', ',', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

/// Between separators; many blanks are one.
Cells fields(std::string_view line, char separator) {
  Cells list;
  for (;;) {
    const auto end =
        line.find_first_of(separator == ' ' ? blanks_in_line : std::string_view(&separator, 1));
    list.push_back(trimmed(line.substr(0, end), " \t\r\""));
    if (end == std::string_view::npos) return list;
    line.remove_prefix(end + 1);
    if (separator == ' ') line = trimmed(line, blanks_in_line);
  }
}

/// Something meant for a number, as names are not.
bool is_like_number(std::string_view field) {
  constexpr std::string_view first = "+-.0123456789";
  const std::string word = lower_case(field);
  return (!field.empty() && first.find(field.front()) != std::string_view::npos) || word == "nan" ||
         word == "inf";
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string TextTable::header_place() const { return fmt::format("line {}", header_line_); }

std::string TextTable::place(std::size_t row) const {
  return fmt::format("line {}", rows_[row].line);
}

TextTable::TextTable(std::string_view text, const TableReading& reading) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError("line 1", "the text is UTF-16; UTF-8 is wanted");
  if (text.starts_with("PK\x03\x04"))
    throw InputError("line 1",
                     "this is an archive (.npz?); an array saved by numpy.save is wanted");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // the mark of UTF-8
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
    throw InputError(fmt::format("line {}", header_line_ + 1),
                     fmt::format("there are no {}", reading.row));
  if (reading.reads_comment && names_.empty() && !comment_.empty()) take_comment_for_header();
  require_equal_widths();
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
  if (is_first) separator_ = separator_of(content);
  Cells row = fields(content, separator_);
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
          fmt::format("line {}", row.line),
          fmt::format("{} here, but {} in {}", counted(row.fields.size(), "number"), columns(),
                      names_.empty() ? "the first line of them" : "the header"));
}

Rational TextTable::number(std::size_t row, std::size_t column) const {
  const std::string_view field = rows_[row].fields[column];
  if (separator_ != ',' && field.find(',') != std::string_view::npos)
    throw InputError(fmt::format("\"{}\" is not a number: decimals have a point, not a comma",
                                 abbreviated(field)));
  return parse_rational(field);
}

}  // namespace phrame
