// The format: "\x93NUMPY", two bytes of version, the length of the header in 2 bytes (version 1) or
// 4 (2 and 3), little-endian, and the header, a dictionary in Python:
//   {'descr': '<f8', 'fortran_order': False, 'shape': (3, 10), }
// 'descr' of a structured array is a list of fields, ('name', '<f8') or ('name', '<f8', (3,)); a
// field named '' is padding. The numbers follow. (NumPy Enhancement Proposal 1.)

#include "phrame/io/read/npy.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/npy_header.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

[[noreturn]] void fail(const std::string& reason) { throw InputError("header", reason); }

/// Little- or big-endian.
std::uint64_t unsigned_integer(std::string_view bytes, bool is_big_endian) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    const char byte = bytes[is_big_endian ? k : bytes.size() - 1 - k];
    value = value << 8U | static_cast<unsigned char>(byte);
  }
  return value;
}

/// IEEE's 16 bits: a sign, 5 of the exponent, 10 of the significand.
double half_precision(std::uint64_t bits) {
  const auto exponent = static_cast<int>(bits >> 10U & 31U);
  const auto significand = static_cast<double>(bits & 1023U);
  const double sign = (bits >> 15U) != 0 ? -1 : 1;
  if (exponent == 31) return sign * (significand == 0 ? HUGE_VAL : NAN);
  return sign * (exponent == 0 ? std::ldexp(significand, -24)
                               : std::ldexp(significand + 1024, exponent - 25));
}

}  // namespace

bool NpyTable::is_one(std::string_view bytes) { return bytes.starts_with(magic); }

NpyTable::NpyTable(std::string_view bytes) {
  bytes.remove_prefix(magic.size());
  if (bytes.size() < 2) fail("the file ends in it");
  const int version = static_cast<unsigned char>(bytes[0]);
  if (version < 1 || version > 3)
    fail(fmt::format("version {} of the format .npy is not known: 1, 2 and 3 are", version));
  const std::size_t width = version == 1 ? 2 : 4;
  bytes.remove_prefix(2);
  if (bytes.size() < width) fail("the file ends in it");
  const std::uint64_t length = unsigned_integer(bytes.substr(0, width), false);
  bytes.remove_prefix(width);
  if (bytes.size() < length) fail("the file ends in it");
  const NpyHeader header = read_npy_header(bytes.substr(0, length));
  data_ = bytes.substr(length);
  if (header.descr.kind == PythonLiteral::Kind::text)
    lay_out_plain(header);
  else
    lay_out_structured(header);
}

std::string NpyTable::place(std::size_t row) const { return fmt::format("row {}", row); }

NpyTable::Type NpyTable::type_of(const std::string& text) {
  Type type;
  type.text = text;
  std::string_view rest = text;
  if (!rest.empty() && std::string_view("<>|=").find(rest.front()) != std::string_view::npos) {
    type.is_big_endian = rest.front() == '>';
    rest.remove_prefix(1);
  }
  if (rest.empty()) fail("a type is empty");
  type.kind = rest.front();
  rest.remove_prefix(1);
  if (type.kind == 'O')
    fail("the array holds objects of Python ('O'): save numbers, by array.astype(float)");
  constexpr std::size_t longest = std::size_t{1} << 30;
  const auto [next, error] = std::from_chars(rest.data(), rest.data() + rest.size(), type.size);
  const bool is_whole = next == rest.data() + rest.size() || *next == '[';  // 'M8[ns]'
  if (error != std::errc() || !is_whole || type.size > longest)
    fail(fmt::format("the type \"{}\" is not known", abbreviated(text)));
  if (type.kind == 'U') type.size *= 4;
  const bool is_read = (type.kind == 'f' && (type.size == 2 || type.size == 4 || type.size == 8)) ||
                       ((type.kind == 'i' || type.kind == 'u') &&
                        (type.size == 1 || type.size == 2 || type.size == 4 || type.size == 8));
  if (!is_read) type.kind = 0;
  return type;
}

void NpyTable::lay_out_plain(const NpyHeader& header) {
  const Type type = type_of(header.descr.text);
  if (type.kind == 0)
    fail(fmt::format("numbers of the type '{}' are not read: save doubles, by array.astype(float)",
                     abbreviated(type.text)));
  const auto& shape = header.shape;
  const bool has_matrices = shape.size() == 3 && (shape[1] == 3 || shape[1] == 4) && shape[2] == 4;
  if (shape.size() != 2 && !has_matrices)
    fail(
        fmt::format("an array of two dimensions is wanted, or of matrices, (n, 4, 4) or (n, 3, 4), "
                    "not of {}",
                    shape.size()));
  rows_ = shape[0];
  const std::size_t columns = has_matrices ? shape[1] * 4 : shape[1];
  if (rows_ == 0 || columns == 0) throw InputError("data", "there are no frames");
  const std::size_t count = data_.size() / type.size;
  if (data_.size() % type.size != 0 || count % columns != 0 || count / columns != rows_)
    throw InputError("data",
                     fmt::format("wanted: {} × {} numbers of {} each; there: {}", rows_, columns,
                                 counted(type.size, "byte"), counted(data_.size(), "byte")));
  stride_ = header.is_fortran ? type.size : columns * type.size;
  for (std::size_t k = 0; k < columns; ++k) {
    const std::size_t in_fortran = has_matrices ? k / 4 + shape[1] * (k % 4) : k;
    columns_.push_back({type, header.is_fortran ? in_fortran * rows_ * type.size : k * type.size});
  }
}

void NpyTable::lay_out_structured(const NpyHeader& header) {
  if (header.descr.kind != PythonLiteral::Kind::sequence || header.descr.items.empty())
    fail("descr is neither a type nor a list of fields");
  if (header.shape.size() != 1)
    fail(fmt::format("a structured array is wanted to be of one dimension, not of {}",
                     header.shape.size()));
  rows_ = header.shape[0];
  if (rows_ == 0) throw InputError("data", "there are no frames");
  for (const PythonLiteral& field : header.descr.items) {
    const auto& parts = field.items;
    if (parts.size() < 2 || parts.size() > 3) fail("a field is not a name, a type and a shape");
    // A name with a title is a pair, the name last.
    const std::string& name = parts[0].items.empty() ? parts[0].text : parts[0].items.back().text;
    if (parts[1].kind != PythonLiteral::Kind::text)
      fail(fmt::format("the field \"{}\" has fields itself", abbreviated(name)));
    const Type type = type_of(parts[1].text);
    std::size_t count = 1;
    if (parts.size() == 3)
      for (const PythonLiteral& size : parts[2].items) {
        if (size.number != 0 && count > data_.size() / size.number)
          throw InputError("data", "the fields are larger than the file");
        count *= size.number;
      }
    if (type.size != 0 && count > (data_.size() - stride_) / type.size)
      throw InputError("data", "the fields are larger than the file");
    const bool is_vector = parts.size() == 3;
    const bool is_quaternion = name == "q" && count == 4;
    if (name.empty() || (is_vector && count != 3 && !is_quaternion)) {  // of no use to us
      stride_ += count * type.size;
      continue;
    }
    for (std::size_t k = 0; k < count; ++k) {
      names_.push_back(!is_vector ? name : name + (is_quaternion ? "wxyz" : "xyz")[k]);
      columns_.push_back({type, stride_});
      stride_ += type.size;
    }
  }
  if (stride_ == 0 || data_.size() % stride_ != 0 || data_.size() / stride_ != rows_)
    throw InputError("data", fmt::format("wanted: {} of {}; there: {}", counted(rows_, "row"),
                                         counted(stride_, "byte"), counted(data_.size(), "byte")));
}

bool NpyTable::is_missing(std::size_t row, std::size_t column) const {
  return columns_[column].type.kind == 'f' && !std::isfinite(floating_point(row, column));
}

double NpyTable::floating_point(std::size_t row, std::size_t column) const {
  const auto& [type, offset] = columns_[column];
  const std::uint64_t bits =
      unsigned_integer(data_.substr(offset + row * stride_, type.size), type.is_big_endian);
  return type.size == 8   ? std::bit_cast<double>(bits)
         : type.size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                          : half_precision(bits);
}

Rational NpyTable::number(std::size_t row, std::size_t column) const {
  const auto& [type, offset] = columns_[column];
  if (type.kind == 0)
    throw InputError(fmt::format("numbers of the type '{}' are not read", abbreviated(type.text)));
  if (type.kind == 'f') {
    const double x = floating_point(row, column);
    if (!std::isfinite(x)) throw InputError(fmt::format("\"{}\" is not a number", x));
    return exact_rational(x);
  }
  const std::uint64_t bits =
      unsigned_integer(data_.substr(offset + row * stride_, type.size), type.is_big_endian);
  const Rational value = Rational(static_cast<long>(bits >> 32U)) * power_of_two(32) +
                         Rational(static_cast<long>(bits & 0xFFFFFFFFU));
  const auto width = static_cast<long>(8 * type.size);
  const bool is_negative = type.kind == 'i' && (bits >> (8 * type.size - 1)) != 0;
  return is_negative ? Rational(value - power_of_two(width)) : value;
}

}  // namespace phrame
