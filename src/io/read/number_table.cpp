#include "phrame/io/read/number_table.hpp"

#include <fmt/format.h>

#include <optional>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/npy.hpp"
#include "phrame/io/read/text_table.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {

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
    throw InputError(fmt::format("{}, {}", place(row), name), error.reason());
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

std::unique_ptr<NumberTable> read_number_table(std::string_view bytes,
                                               const TableReading& reading) {
  if (NpyTable::is_one(bytes)) return std::make_unique<NpyTable>(bytes);
  return std::make_unique<TextTable>(bytes, reading);
}

}  // namespace phrame
