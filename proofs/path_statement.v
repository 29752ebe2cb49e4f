(* What the certificate of a path (docs/certificate.md) states, as far as verified_path_checker.v checks it, about real
   numbers: to be read with certificate_statement.v. *)
From Coq Require Import Reals ZArith QArith Qreals List.
From Coquelicot Require Import Coquelicot.
Require Import rotation_minimizing certificate_statement.
Import ListNotations.
Open Scope R_scope.

(* The certificates of the segments, each on its own [0, 1], where they start, and angles at times along the path, k to
   k + 1 on segment k. *)
Record path_certificate := PathCertificate {
  segments : list certificate; starts : list (Q * Q * Q); path_claims : list claim }.

(* A preimage without its real zeros, and its derivative. *)
Definition part := ((R -> quaternion) * (R -> quaternion))%type.
Definition part_rate (a : part) := rate (fst a) (snd a).

(* The sum of the angles of the first n segments, and with it the angle at t of the one behind them, and the frame. *)
Fixpoint angle_to (l : list part) (n : nat) : R :=
  match l, n with a :: l, S n => RInt (part_rate a) 0 1 + angle_to l n | _, _ => 0 end.
Definition angle_at (l : list part) n (a : part) t := angle_to l n + RInt (part_rate a) 0 t.
Definition path_f2 l n a t := turn2 (angle_at l n a t) (e2 (fst a t)) (e3 (fst a t)).
Definition path_f3 l n a t := turn3 (angle_at l n a t) (e2 (fst a t)) (e3 (fst a t)).

(* What becomes of x by the least rotation that takes the unit vector a to b, not opposite to it: it turns about n = a x b,
   |n| the sine and a.b the cosine of the angle (Rodrigues). For a = b it is x. *)
Definition least_rotation a b x :=
  add x (add (cross (cross a b) x) (scale (/ (1 + dot a b)) (cross (cross a b) (cross (cross a b) x)))).

(* From its start p to its end. *)
Definition end_of (c : certificate) (p : Q * Q * Q) :=
  add (real_vector p) (Vector (RInt (value (cx' c)) 0 1) (RInt (value (cy' c)) 0 1) (RInt (value (cz' c)) 0 1)).

Definition path_statement (p : path_certificate) := exists l : list part,
  (* All that is stated of each segment. *)
  Forall2 (fun c a => statement_about c (fst a) (snd a)) (segments p) l /\
  (* Each segment but the first starts where the one before ends. *)
  length (starts p) = length (segments p) /\
  (forall n c s t, nth_error (segments p) n = Some c -> nth_error (starts p) n = Some s ->
    nth_error (starts p) (S n) = Some t -> end_of c s = real_vector t) /\
  (* On each e1, f2, f3 are a rotation-minimizing frame, which goes on from each to the next, or is carried through the
     corner there, where the multipliers have the same sign, by the least rotation. *)
  (forall n a, nth_error l n = Some a ->
    (forall t, 0 <= t <= 1 -> clear (fst a) t) /\
    rotation_minimizing (clear (fst a)) (fun t => e1 (fst a t)) (path_f2 l n a) (path_f3 l n a)) /\
  (forall n a b, nth_error l n = Some a -> nth_error l (S n) = Some b ->
    let carried := least_rotation (e1 (fst a 1)) (e1 (fst b 0)) in
    1 + dot (e1 (fst a 1)) (e1 (fst b 0)) > 0 /\ carried (e1 (fst a 1)) = e1 (fst b 0) /\
    carried (path_f2 l n a 1) = path_f2 l (S n) b 0 /\ carried (path_f3 l n a 1) = path_f3 l (S n) b 0) /\
  (forall n c d a b, nth_error (segments p) n = Some c -> nth_error (segments p) (S n) = Some d ->
    nth_error l n = Some a -> nth_error l (S n) = Some b -> e1 (fst a 1) = e1 (fst b 0) \/
    value (multiplier c) 1 * value (multiplier d) 0 > 0) /\
  (* The angles. *)
  (forall x, In x (path_claims p) -> exists n a s, nth_error l n = Some a /\ 0 <= s <= 1 /\
    Q2R (time x) = INR n + s /\ Rabs (angle_at l n a s - Q2R (angle x)) <= Q2R (radius x)).
