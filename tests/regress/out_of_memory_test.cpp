// (ulimit -v 30000; phrame integrate '1/(x^60-x-1)^3' --from 2 --to 3 --digits 20000) was aborted.
#include <doctest/doctest.h>

#include <limits>
#include <new>

#include "phrame/algebra/flint.hpp"
#include "phrame/algebra/out_of_memory.hpp"
#include "phrame/answer/integral.hpp"
#include "phrame/io/read/expression.hpp"
#include "phrame/io/write/answers.hpp"

using namespace phrame;

namespace {

/// Requests until one is refused; none where negative.
long left = -1;
void* (*give)(std::size_t);
void* (*give_again)(void*, std::size_t, std::size_t);
void* (*give_to_flint)(std::size_t);
void* (*give_cleared)(std::size_t, std::size_t);
void* (*give_flint_again)(void*, std::size_t);
void (*take_from_flint)(void*);

/// More than there is at the request in question.
std::size_t wanted(std::size_t size) {
  return left >= 0 && left-- == 0 ? std::numeric_limits<std::size_t>::max() / 4 : size;
}

void refuse_sometimes() {
  throw_when_out_of_memory();
  void (*take)(void*, std::size_t) = nullptr;
  mp_get_memory_functions(&give, &give_again, &take);
  mp_set_memory_functions([](std::size_t size) { return give(wanted(size)); },
                          [](void* p, std::size_t old, std::size_t size) {
                            return give_again(p, old, size > old ? wanted(size) : size);
                          },
                          take);
  __flint_get_memory_functions(&give_to_flint, &give_cleared, &give_flint_again, &take_from_flint);
  __flint_set_memory_functions(
      [](std::size_t size) { return give_to_flint(wanted(size)); },
      [](std::size_t count, std::size_t size) { return give_cleared(count, wanted(size)); },
      give_flint_again, take_from_flint);
}

std::string value(const char* integrand) {
  IntegralQuery query;
  query.integrand = parse_expression(integrand).value;
  query.digits = 60;
  query.ends = {{0, 1}};
  return to_text(answer(query));
}

}  // namespace

TEST_CASE("out of memory: whichever request is refused, what is asked next is right") {
  const char* const integrand = "(x^5+1)/((x^7+x+1)^2*(x^2+3))";
  const std::string expected = value(integrand);
  refuse_sometimes();
  long refused = 0;
  for (long at = 0;; at += 1 + at / 8) {
    left = at;
    try {
      CHECK(value(integrand) == expected);
    } catch (const std::bad_alloc&) {
      ++refused;
    }
    const bool is_over = left >= 0;
    left = -1;
    CHECK(value(integrand) == expected);
    if (is_over) break;
  }
  CHECK(refused > 40);
}

// mpz_mul() frees the digits of its result before it asks for more.
TEST_CASE("out of memory: a number that GMP was to make longer is freed once") {
  refuse_sometimes();
  mpz_t x;
  mpz_t product;
  mpz_init_set_ui(x, 3);
  mpz_pow_ui(x, x, 10'000);
  mpz_init_set_ui(product, 7);
  mpz_mul(product, product, product);
  left = 0;
  CHECK_THROWS_AS(mpz_mul(product, x, x), std::bad_alloc);
  left = -1;
  mpz_clear(product);
  mpz_clear(x);
}
