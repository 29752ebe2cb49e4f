#pragma once
#include "phrame/algebra/flint.hpp"

namespace phrame::inline v0 {

/// The rule of five for a C struct, written once. `C` names the struct and its four functions.
/// A moved-from handle equals a default-constructed one; moves and swaps do not throw.
template <class C>
class Handle {
 public:
  using Struct = typename C::Struct;

  Handle() noexcept { C::init(&value_); }
  Handle(const Handle& other) : Handle() { C::set(&value_, &other.value_); }
  Handle(Handle&& other) noexcept : Handle() { C::swap(&value_, &other.value_); }
  Handle& operator=(const Handle& other) {
    C::set(&value_, &other.value_);  // FLINT allows the two to be the same
    return *this;
  }
  Handle& operator=(Handle&& other) noexcept {
    Handle taken(static_cast<Handle&&>(other));
    C::swap(&value_, &taken.value_);
    return *this;
  }
  ~Handle() { C::clear(&value_); }

  friend void swap(Handle& a, Handle& b) noexcept { C::swap(&a.value_, &b.value_); }

  Struct* get() noexcept { return &value_; }
  const Struct* get() const noexcept { return &value_; }

 private:
  Struct value_;
};

namespace flint {

// One line a type: the functions are wrapped because many of FLINT's are `static inline`, and a
// template argument must not have internal linkage.
#define PHRAME_C_TYPE(Name, prefix)                                          \
  struct Name##Functions {                                                   \
    using Struct = prefix##_struct;                                          \
    static void init(Struct* a) noexcept { prefix##_init(a); }               \
    static void clear(Struct* a) noexcept { prefix##_clear(a); }             \
    static void set(Struct* a, const Struct* b) { prefix##_set(a, b); }      \
    static void swap(Struct* a, Struct* b) noexcept { prefix##_swap(a, b); } \
  };                                                                         \
  using Name = Handle<Name##Functions>

using fmpz_struct = fmpz;
using fmpq_struct = fmpq;
using mpq_struct = __mpq_struct;
PHRAME_C_TYPE(Fmpz, fmpz);
PHRAME_C_TYPE(Fmpq, fmpq);
PHRAME_C_TYPE(Mpq, mpq);
PHRAME_C_TYPE(FmpzPoly, fmpz_poly);
PHRAME_C_TYPE(FmpqPoly, fmpq_poly);
PHRAME_C_TYPE(Arb, arb);
PHRAME_C_TYPE(Arf, arf);
PHRAME_C_TYPE(Mag, mag);
PHRAME_C_TYPE(Acb, acb);
PHRAME_C_TYPE(ArbPoly, arb_poly);
PHRAME_C_TYPE(AcbPoly, acb_poly);
#undef PHRAME_C_TYPE

}  // namespace flint
}  // namespace phrame
