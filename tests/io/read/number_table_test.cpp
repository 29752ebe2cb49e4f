#include "phrame/io/read/number_table.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

namespace {

/// Two rows of three signed bytes, by the format's description: magic, version, length, header.
std::string bytes_of_numpy() {
  const std::string header = "{'descr': '|i1', 'fortran_order': False, 'shape': (2, 3), }\n";
  std::string bytes = "\x93NUMPY\x01";
  bytes += '\0';
  bytes += static_cast<char>(header.size());
  bytes += '\0';
  return bytes + header + "\x01\x02\x02\x03\x04\xFB";
}

}  // namespace

TEST_CASE("number table: text and arrays of NumPy are read alike") {
  const std::string array = bytes_of_numpy();
  const auto numpy = read_number_table(array, {});
  const auto text = read_number_table("t, f2x, f2x\n1, 2, 2\n3, 4, -5", {});
  CHECK(numpy->names().empty());
  CHECK(text->names() == std::vector<std::string>{"t", "f2x", "f2x"});
  CHECK(numpy->header_place() == "header");
  CHECK(text->header_place() == "line 1");
  const NumberTable::Group group{"f2", "xyz", {{1}, {2}}};
  for (const auto& [table, place] : {std::pair(&numpy, "row 1"), {&text, "line 3"}}) {
    CHECK((*table)->rows() == 2);
    CHECK((*table)->columns() == 3);
    CHECK((*table)->place(1) == place);
    CHECK((*table)->vector(1, group) == Vector<Rational>{4, -5, 0});
    CHECK((*table)->number(0, {1, 2}, "f2x") == 2);  // twice the same
    const std::string reason = ", f2x: two columns have this name, one with 4, one with -5";
    CHECK_THROWS_WITH_AS((*table)->number(1, {1, 2}, "f2x"), (place + reason).c_str(), InputError);
  }
}
