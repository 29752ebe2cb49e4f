#include "phrame/io/write/passage.hpp"

#include <doctest/doctest.h>

using namespace phrame;

TEST_CASE("passage: a text is read in full or abridged, and that it is abridged is said") {
  const std::string text = "a " + passage("long", "l…") + " b " + passage("", "⟨c⟩") + "\n";
  CHECK(for_reading(text, true) == "a long b \n");
  CHECK(abridged(text) == "a l… b ⟨c⟩\n");
  CHECK(for_reading(text, false) ==
        abridged(text) + "\nLong parts are abridged (--full prints it all).\n");
  CHECK(for_reading("a\n", false) == "a\n");
  CHECK(text_width(text) == 11);
}

TEST_CASE("passage: the width counts characters, not bytes") {
  CHECK(text_width("") == 0);
  CHECK(text_width("abc") == 3);
  CHECK(text_width("−2t²") == 4);  // 3 + 1 + 1 + 2 bytes
  CHECK(text_width("⟨σ⟩") == 3);
}
