#include "phrame/io/read/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/json_table.hpp"
#include "phrame/io/read/npy.hpp"
#include "phrame/io/read/text_table.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {

std::string NumberTable::place_in_row(std::size_t row, std::size_t /*column*/,
                                      std::string_view name) const {
  return fmt::format("{}, {}", place(row), name);
}

Rational NumberTable::number(std::size_t row, const std::vector<std::size_t>& columns,
                             std::string_view name) const {
  try {
    const Rational value = number(row, columns.front());
    for (std::size_t k = 1; k < columns.size(); ++k)
      if (const Rational other = number(row, columns[k]); other != value)
        throw InputError(fmt::format("two columns have this name, one with {}, one with {}",
                                     as_written(value), as_written(other)));
    return value;
  } catch (const InputError& error) {
    const bool is_skippable = is_missing(row, columns.front());
    throw InputError(
        place_in_row(row, columns.front(), name),
        error.reason() + (is_skippable ? "; --skip-invalid leaves such rows out" : ""));
  }
}

std::array<Rational, 4> NumberTable::numbers(std::size_t row, const Group& group) const {
  std::array<Rational, 4> list;
  for (std::size_t k = 0; k < group.columns.size(); ++k)
    list[k] = number(row, group.columns[k], group.column(k));
  return list;
}

Vector<Rational> NumberTable::vector(std::size_t row, const Group& group) const {
  const auto [x, y, z, none] = numbers(row, group);
  return {x, y, z};
}

TableOfRows::TableOfRows(std::unique_ptr<NumberTable> table, std::vector<std::size_t> rows,
                         std::string note)
    : table_(std::move(table)), rows_(std::move(rows)) {
  names_ = table_->names();
  units_ = table_->units();
  notes_ = table_->notes();
  notes_.push_back(std::move(note));
}

std::unique_ptr<NumberTable> with_rows(std::unique_ptr<NumberTable> table,
                                       std::vector<std::size_t> rows, std::string_view why) {
  const std::size_t count = table->rows() - rows.size();
  if (count == 0) return table;
  if (rows.empty()) throw InputError(table->place(0), fmt::format("all rows are {}", why));
  std::size_t first = 0;
  while (first < rows.size() && rows[first] == first) ++first;
  std::string note =
      fmt::format("left out {} {} {}, {}{}", count == 1 ? "is" : "are", counted(count, "row"), why,
                  count == 1 ? "" : "the first ", table->place(first));
  return std::make_unique<TableOfRows>(std::move(table), std::move(rows), std::move(note));
}

std::unique_ptr<NumberTable> without_missing(std::unique_ptr<NumberTable> table,
                                             const std::vector<std::size_t>& columns) {
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < table->rows(); ++row)
    if (std::ranges::none_of(columns, [&](std::size_t k) { return table->is_missing(row, k); }))
      kept.push_back(row);
  return with_rows(std::move(table), std::move(kept), "without a number");
}

std::unique_ptr<NumberTable> read_number_table(std::string_view bytes, const TableForm& reading) {
  if (NpyTable::is_one(bytes)) return std::make_unique<NpyTable>(bytes);
  const auto first = bytes.find_first_not_of(" \t\r\n", bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  if (first != std::string_view::npos && bytes[first] == '[')
    return std::make_unique<JsonTable>(parse_json(bytes));
  if (first != std::string_view::npos && bytes[first] == '{')
    if (JsonValue document = parse_json(bytes); is_frame_table(JsonNode(document)))
      return std::make_unique<JsonTable>(std::move(document));
  return std::make_unique<TextTable>(bytes, reading);
}

}  // namespace phrame
