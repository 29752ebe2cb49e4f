#include "phrame/io/write/sha256.hpp"

#include "io/reference.hpp"
#include "phrame/io/write/exact_form.hpp"
#include "support/rational_curves.hpp"

using namespace phrame;
using namespace phrame::test;

// NIST, Examples with Intermediate Values (SHA256.pdf, SHA2_Additional.pdf), for FIPS 180-4.
TEST_CASE("sha256: the examples of NIST") {
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("\xbd") == "68325720aabd7c82f30f554b313d0570c95accbb7dc4b5aae11204c08ffe732b");
  CHECK(sha256(std::string(55, '\0')) ==
        "02779466cdec163811d078815c633f21901413081449002f24aa3e80f0b88ef7");
  CHECK(sha256(std::string(56, '\0')) ==
        "d4817aa5497628e7c77e6b606107042bbba3130888c5f47a375e6179be789fbb");
  CHECK(sha256(std::string(64, '\0')) ==
        "f5a5fd42d16a20302798ef6ed309979b43003d2320d9f0e8ea9831a92759fb4b");
  CHECK(sha256(std::string(1000, 'A')) ==
        "c2e686823489ced2017f6059b8b239318b6364f6dcd835d0a519105a1eadd6e4");
  CHECK(sha256(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// A i A* = (1 − t², 2t, 0) for A = 1 + tk, times f = t² + 2t.
TEST_CASE("exact_form: r' and r(0), whatever the preimage") {
  const QuaternionPolynomial a{{1}, {}, {}, {0, 1}};
  const Curve curve(a, Polynomial{0, 2, 1}, {Rational(1, 2), 0, -3});
  const std::string text = exact_form(curve);
  CHECK(text == "dx 0 2 1 -2 -1\ndy 0 0 4 2\ndz\nstart 1/2 0 -3\n");
  // A·(3 + 4i)/5: the frame is turned, the curve is the same.
  const Rational c(3, 5);
  const Rational s(4, 5);
  const QuaternionPolynomial turned{{c}, {s}, {0, s}, {0, c}};
  CHECK(exact_form(Curve(turned, Polynomial{0, 2, 1}, {Rational(1, 2), 0, -3})) == text);
}

// ((1 − t²), 2t, 0)/(1 + t²) has the derivative (−4t, 2 − 2t², 0)/(1 + t²)².
TEST_CASE("exact_form: of a rational curve r' is in lowest terms, whatever the weight") {
  const std::string text = "dx 0 -4\ndy 2 0 -2\ndz\nover 1 0 2 0 1\nstart 1 0 0\n";
  CHECK(exact_form(quarter_circle()) == text);
  CHECK(exact_form(with_factor(quarter_circle(), Polynomial{5, -2})) == text);
}
