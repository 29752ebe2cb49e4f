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
    for (const std::size_t column : columns)
      if (const Rational other = number(row, column); other != value)
        throw InputError(fmt::format("two columns have this name, one with {}, one with {}",
                                     as_written(value), as_written(other)));
    return value;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}, {}", place(row), name), error.reason());
  }
}

std::unique_ptr<NumberTable> read_number_table(std::string_view bytes,
                                               const TableReading& reading) {
  if (NpyTable::is_one(bytes)) return std::make_unique<NpyTable>(bytes);
  return std::make_unique<TextTable>(bytes, reading);
}

}  // namespace phrame
