(* The verified checker as a program: writes accept.ml, which check_certificate_verified.ml calls. Integers become those
   of Zarith, by Coq's own table of their operations and the three lines below; lists, pairs and truth values those of
   OCaml. *)
From Coq Require Import ZArith Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
Require Import verified_checker.

Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".
Extract Constant Z.ltb => "Big_int_Z.lt_big_int".
Extract Constant Z.leb => "Big_int_Z.le_big_int".

Extraction "accept.ml" accept.
