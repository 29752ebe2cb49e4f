(* The verified checker as a program: writes accept.ml, which check_certificate_verified.ml calls. Integers become those
   of Zarith, by Coq's own table of their operations and the four functions below; lists, pairs and truth values those of
   OCaml. *)
From Coq Require Import ZArith Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
Require Import verified_checker verified_path_checker.

Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".
Extract Constant Z.ggcd => "Big_int_Z.(fun a b ->
  let g = gcd_big_int a b in
  if sign_big_int g = 0 then (g, (g, g)) else (g, (div_big_int a g, div_big_int b g)))".
Extract Constant Z.ltb => "Big_int_Z.lt_big_int".
Extract Constant Z.leb => "Big_int_Z.le_big_int".

Extraction "accept.ml" accept accept_path.
