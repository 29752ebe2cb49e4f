(* What a certificate (docs/certificate.md) states, as far as verified_checker.v checks it, about real numbers. To know
   what is proved of a certificate that is accepted, this file and the definitions of rotation_minimizing.v are to be
   read, and no other; of polynomials.v `at_real` and `is_zero`.

   Polynomials are lists of their coefficients from the constant term up. *)
From Coq Require Import Reals ZArith QArith Qreals List.
From Coquelicot Require Import Coquelicot.
Require Import rotation_minimizing polynomials.
Import ListNotations.
Open Scope R_scope.

(* |theta(time) - angle| <= radius. *)
Record claim := Claim { time : Q; angle : Q; radius : Q }.

(* What kind of curve it is, with witnesses: zeros that are rational, vectors, a cosine, w, omega and a constant. *)
Inductive decision :=
  | Regular | NotRegular (cusps : list Q)
  | Inflection (points : list Q) | NoInflection
  | Line (direction : Q * Q * Q) | NotLine
  | Planar (normal : Q * Q * Q) | NotPlanar
  | Helical (axis : Q * Q * Q) (cos_squared : Q) | NotHelical
  | ErfIsRmf | ErfIsNotRmf
  | Rrmf (re im : list Q)
  | DoublePh (omega : list Q) (constant : Q)
  | Monotone | NotMonotone.

(* The preimage A = u + v i + p j + q k and the multiplier f; then r', sigma, h, g; the rate of the angle to the
   Euler-Rodrigues frame, numerator/denominator, and what it was reduced by; where the angles are those to the Frenet
   frame, `bend` is Re gamma, Im gamma and G, g = G gamma; numerator and denominator of what may be an antiderivative of
   the rate, for angles that are exact: nothing is stated of it; the angles; the decisions. *)
Record certificate := Certificate {
  cu : list Q; cv : list Q; cp : list Q; cq : list Q; multiplier : list Q;
  cx' : list Q; cy' : list Q; cz' : list Q; csigma : list Q; ch : list Q; cg_re : list Q; cg_im : list Q;
  numerator : list Q; denominator : list Q; common : list Q;
  bend : option (list Q * list Q * list Q); rational : list Q * list Q;
  claims : list claim; decisions : list decision }.

(* The value of a polynomial. *)
Fixpoint value (a : list Q) (x : R) : R := match a with [] => 0 | c :: a => Q2R c + x * value a x end.

(* What is between 0 and t, both included. *)
Definition within (t s : R) := Rmin 0 t <= s <= Rmax 0 t.
(* Where A is reached from 0 without a zero. *)
Definition clear (A : R -> quaternion) (t : R) := forall s, within t s -> 0 < sigma (A s).

Definition multiple (k : R) (a : quaternion) := Quaternion (k * qu a) (k * qv a) (k * qp a) (k * qq a).

(* The angle of the rate w is theta, and f, g turned by it are with e a rotation-minimizing frame on D, and but for a
   constant turn the only one. *)
Definition frame_statement (D : R -> Prop) (w theta : R -> R) (e f g : R -> vector) :=
  let f2 t := turn2 (theta t) (f t) (g t) in
  let f3 t := turn3 (theta t) (f t) (g t) in
  open_interval D /\ (forall t, 0 <= t <= 1 -> D t) /\
  theta 0 = 0 /\ (forall t, D t -> is_derive theta t (w t)) /\
  rotation_minimizing D e f2 f3 /\
  (forall g2 g3, rotation_minimizing D e g2 g3 ->
    exists a, forall t, D t -> g2 t = turn2 a (f2 t) (f3 t) /\ g3 t = turn3 a (f2 t) (f3 t)).

(* The angle of this rate is, at each time claimed, within the radius of what is claimed, and D reaches there. *)
Definition angles_statement (D : R -> Prop) (w : R -> R) (l : list claim) :=
  forall x, In x l ->
    D (Q2R (time x)) /\ Rabs (RInt w 0 (Q2R (time x)) - Q2R (angle x)) <= Q2R (radius x).

(* Of A0, which A is a multiple of and which has no zero on [0, 1]. *)
Definition rate (A0 A0' : R -> quaternion) s := -2 * h (A0 s) (A0' s) / sigma (A0 s).
Definition erf_statement (A0 A0' : R -> quaternion) :=
  frame_statement (clear A0) (rate A0 A0') (fun t => 0 + RInt (rate A0 A0') 0 t)
    (fun t => e1 (A0 t)) (fun t => e2 (A0 t)) (fun t => e3 (A0 t)).

(* Of gamma = a + i b, where neither A0 nor gamma has a zero: the Frenet frame, with the normal and the binormal
   turned over where G is negative. *)
Definition norm_squared (a b : R -> R) s := a s * a s + b s * b s.
Definition both_clear (A0 : R -> quaternion) (a b : R -> R) (t : R) :=
  forall s, within t s -> 0 < sigma (A0 s) /\ 0 < norm_squared a b s.
Definition gamma_rate (A0 A0' : R -> quaternion) (a b a' b' : R -> R) s :=
  rate A0 A0' s + (a s * b' s - b s * a' s) / norm_squared a b s.
Definition gamma_normal (A0 : R -> quaternion) (a b : R -> R) s :=
  scale (/ sqrt (norm_squared a b s)) (add (scale (a s) (e2 (A0 s))) (scale (- b s) (e3 (A0 s)))).
Definition gamma_binormal (A0 : R -> quaternion) (a b : R -> R) s :=
  scale (/ sqrt (norm_squared a b s)) (add (scale (b s) (e2 (A0 s))) (scale (a s) (e3 (A0 s)))).
Definition frenet_statement (A0 A0' : R -> quaternion) (a b a' b' : R -> R) :=
  frame_statement (both_clear A0 a b) (gamma_rate A0 A0' a b a' b')
    (fun t => 0 + RInt (gamma_rate A0 A0' a b a' b') 0 t)
    (fun t => e1 (A0 t)) (gamma_normal A0 a b) (gamma_binormal A0 a b).

(* x, y, z, of which r' is a multiple. *)
Definition xyz (A0 : R -> quaternion) s := rotated (A0 s) (Vector 1 0 0).
Definition real_vector (l : Q * Q * Q) := let '(x, y, z) := l in Vector (Q2R x) (Q2R y) (Q2R z).
Definition no_vector := Vector 0 0 0.
Definition triple_product a b c := dot a (cross b c).
(* The determinant of four rows x, y, z, sigma. *)
Definition det4 (a : vector) (k : R) b l c m d n :=
  n * triple_product a b c - m * triple_product a b d + l * triple_product a c d - k * triple_product b c d.

(* A = k A0, r' = f A i A*. *)
Definition decision_statement (f k : R -> R) (A0 A0' : R -> quaternion) (d : decision) : Prop :=
  match d with
  | Regular => forall s, 0 <= s <= 1 -> f s <> 0 /\ k s <> 0
  | NotRegular _ => exists s, 0 <= s <= 1 /\ f s * k s = 0
  | Inflection _ =>
      (exists s, 0 <= s <= 1 /\ g_squared (A0 s) (A0' s) = 0) /\ exists s, g_squared (A0 s) (A0' s) <> 0
  | NoInflection =>
      (forall s, 0 <= s <= 1 -> 0 < g_squared (A0 s) (A0' s)) \/ (forall s, g_squared (A0 s) (A0' s) = 0)
  | Line l => real_vector l <> no_vector /\ forall s, cross (xyz A0 s) (real_vector l) = no_vector
  | NotLine => exists s t, cross (xyz A0 s) (xyz A0 t) <> no_vector
  | Planar l => real_vector l <> no_vector /\ forall s, dot (real_vector l) (xyz A0 s) = 0
  | NotPlanar => exists s t u, triple_product (xyz A0 s) (xyz A0 t) (xyz A0 u) <> 0
  | Helical l c =>
      (exists s t u, triple_product (xyz A0 s) (xyz A0 t) (xyz A0 u) <> 0) /\ real_vector l <> no_vector /\
      forall s, dot (real_vector l) (xyz A0 s) ^ 2 = Q2R c * dot (real_vector l) (real_vector l) * sigma (A0 s) ^ 2
  | NotHelical => exists s t u v,
      det4 (xyz A0 s) (sigma (A0 s)) (xyz A0 t) (sigma (A0 t)) (xyz A0 u) (sigma (A0 u)) (xyz A0 v) (sigma (A0 v)) <> 0
  | ErfIsRmf => forall s, h (A0 s) (A0' s) = 0
  | ErfIsNotRmf => exists s, h (A0 s) (A0' s) <> 0
  | Rrmf re im =>
      (exists s, norm_squared (value re) (value im) s <> 0) /\
      exists a' b' : R -> R, forall s, is_derive (value re) s (a' s) /\ is_derive (value im) s (b' s) /\
        (value re s * b' s - value im s * a' s) * sigma (A0 s) =
          - h (A0 s) (A0' s) * norm_squared (value re) (value im) s
  | DoublePh w c => forall s, 4 * (k s ^ 4 * g_squared (A0 s) (A0' s)) = Q2R c * value w s ^ 2
  | Monotone =>
      (forall s, 0 <= s <= 1 -> 0 <= h (A0 s) (A0' s)) \/ (forall s, 0 <= s <= 1 -> h (A0 s) (A0' s) <= 0)
  | NotMonotone => exists s t, 0 < s < 1 /\ 0 < t < 1 /\ h (A0 s) (A0' s) < 0 < h (A0 t) (A0' t)
  end.

(* With A0 the preimage without its real zeros. *)
Definition statement_about (c : certificate) (A0 A0' : R -> quaternion) :=
  let A s := Quaternion (value (cu c) s) (value (cv c) s) (value (cp c) s) (value (cq c) s) in
  let r' s := Vector (value (cx' c) s) (value (cy' c) s) (value (cz' c) s) in
  exists A' : R -> quaternion, (forall s, quaternion_derivative A s (A' s)) /\
  (* r' = f A i A*, and the invariants. *)
  (forall s, r' s = scale (value (multiplier c) s) (rotated (A s) (Vector 1 0 0)) /\
    value (csigma c) s = sigma (A s) /\ value (ch c) s = h (A s) (A' s) /\
    value (cg_re c) s = g_re (A s) (A' s) /\ value (cg_im c) s = g_im (A s) (A' s)) /\
  (* The rate. *)
  (forall s, -2 * h (A s) (A' s) = value (numerator c) s * value (common c) s /\
    sigma (A s) = value (denominator c) s * value (common c) s) /\
  (* The zeros are those of the polynomial k. *)
  exists (k : poly) (n : positive),
    is_zero k = false /\ (forall s, A s = multiple (at_real k s / IZR (Zpos n)) (A0 s)) /\
    (forall s, quaternion_derivative A0 s (A0' s)) /\
    (* e1 is along r'. *)
    (forall t, clear A0 t ->
      r' t = scale (value (multiplier c) t * (at_real k t / IZR (Zpos n)) ^ 2 * sigma (A0 t)) (e1 (A0 t))) /\
    erf_statement A0 A0' /\
    (forall x, In x (decisions c) ->
      decision_statement (value (multiplier c)) (fun s => at_real k s / IZR (Zpos n)) A0 A0' x) /\
    (* The angles. *)
    match bend c with
    | None => angles_statement (clear A0) (rate A0 A0') (claims c)
    | Some (re, im, G) =>
        (forall s, g_re (A s) (A' s) = value G s * value re s /\ g_im (A s) (A' s) = value G s * value im s) /\
        exists a' b' : R -> R,
          (forall s, is_derive (value re) s (a' s) /\ is_derive (value im) s (b' s)) /\
          frenet_statement A0 A0' (value re) (value im) a' b' /\
          angles_statement (both_clear A0 (value re) (value im))
            (gamma_rate A0 A0' (value re) (value im) a' b') (claims c)
    end.

Definition statement (c : certificate) := exists A0 A0' : R -> quaternion, statement_about c A0 A0'.
