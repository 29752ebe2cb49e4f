(* A checker of certificates (docs/certificate.md) that is proved right: if `accept c` computes to true, then what the
   certificate c says of its curve, of the rotation-minimizing frame and of its angles is true of real numbers.

   First what a certificate is and what it states; then how it is checked; then the proof. The statement uses the
   definitions of rotation_minimizing.v. *)
From Coq Require Import Reals ZArith QArith Qreals List Lra Lia Bool.
From Coquelicot Require Import Coquelicot.
Require Import rotation_minimizing polynomials quadrature.
Import ListNotations.
Open Scope R_scope.

(* ---- A certificate and what it states. Polynomials are lists of their coefficients from the constant term up. *)

(* |theta(time) - angle| <= radius. *)
Record claim := Claim { time : Q; angle : Q; radius : Q }.

(* The preimage A = u + v i + p j + q k and the multiplier f; then r', sigma, h, g; the rate of the angle,
   numerator/denominator, and what it was reduced by; angles. *)
Record certificate := Certificate {
  cu : list Q; cv : list Q; cp : list Q; cq : list Q; multiplier : list Q;
  cx' : list Q; cy' : list Q; cz' : list Q; csigma : list Q; ch : list Q; cg_re : list Q; cg_im : list Q;
  numerator : list Q; denominator : list Q; common : list Q;
  claims : list claim }.

(* The value of a polynomial. *)
Fixpoint value (a : list Q) (x : R) : R := match a with [] => 0 | c :: a => Q2R c + x * value a x end.

(* What is between 0 and t, both included. *)
Definition within (t s : R) := Rmin 0 t <= s <= Rmax 0 t.
(* Where A is reached from 0 without a zero. *)
Definition clear (A : R -> quaternion) (t : R) := forall s, within t s -> 0 < sigma (A s).

Definition multiple (k : R) (a : quaternion) := Quaternion (k * qu a) (k * qv a) (k * qp a) (k * qq a).

(* Of A0, which A is a multiple of and which has no zero on [0, 1], the frame and its angle. *)
Definition frame_statement (A0 A0' : R -> quaternion) :=
  let D := clear A0 in
  let theta t := 0 + RInt (fun s => -2 * h (A0 s) (A0' s) / sigma (A0 s)) 0 t in
  let f2 t := turn2 (theta t) (e2 (A0 t)) (e3 (A0 t)) in
  let f3 t := turn3 (theta t) (e2 (A0 t)) (e3 (A0 t)) in
  open_interval D /\ (forall t, 0 <= t <= 1 -> D t) /\
  theta 0 = 0 /\
  (forall t, D t -> is_derive theta t (-2 * h (A0 t) (A0' t) / sigma (A0 t))) /\
  rotation_minimizing D (fun t => e1 (A0 t)) f2 f3 /\
  (forall g2 g3, rotation_minimizing D (fun t => e1 (A0 t)) g2 g3 ->
    exists a, forall t, D t -> g2 t = turn2 a (f2 t) (f3 t) /\ g3 t = turn3 a (f2 t) (f3 t)).

Definition angle_statement (A0 A0' : R -> quaternion) (l : claim) :=
  clear A0 (Q2R (time l)) /\
  Rabs (RInt (fun s => -2 * h (A0 s) (A0' s) / sigma (A0 s)) 0 (Q2R (time l)) - Q2R (angle l)) <= Q2R (radius l).

Definition statement (c : certificate) :=
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
  (* The preimage without its real zeros, which are those of the polynomial k. *)
  exists (k : poly) (n : positive) (A0 A0' : R -> quaternion),
    is_zero k = false /\ (forall s, A s = multiple (at_real k s / IZR (Zpos n)) (A0 s)) /\
    (forall s, quaternion_derivative A0 s (A0' s)) /\
    (* e1 is along r'. *)
    (forall t, clear A0 t ->
      r' t = scale (value (multiplier c) t * (at_real k t / IZR (Zpos n)) ^ 2 * sigma (A0 t)) (e1 (A0 t))) /\
    frame_statement A0 A0' /\
    (* The angles. *)
    (forall l, In l (claims c) -> angle_statement A0 A0' l).

(* ---- How it is checked *)

(* A list of fractions as one of integers over a common denominator. *)
Definition denominator_of (a : list Q) : positive :=
  Z.to_pos (fold_right (fun c d => Z.lcm (Zpos (Qden c)) d) 1%Z a).
Definition over (d : positive) (a : list Q) : poly :=
  map (fun c => Qnum c * (Zpos d / Zpos (Qden c)))%Z a.
(* That over this denominator nothing is lost. *)
Definition is_over (d : positive) (a : list Q) :=
  forallb (fun c => (Zpos d / Zpos (Qden c) * Zpos (Qden c) =? Zpos d)%Z) a.

(* The polynomial a, of fractions, is n/d. *)
Definition is_fraction (a : list Q) (n : poly) (d : positive) :=
  let e := denominator_of a in
  is_over e a && same (times (Zpos d) (over e a)) (times (Zpos e) n).

(* Four polynomials with integer coefficients, and what is computed of them as of quaternions. *)
Record curve := Curve { iu : poly; iv : poly; ip : poly; iq : poly }.
Definition derived_curve A := Curve (derived (iu A)) (derived (iv A)) (derived (ip A)) (derived (iq A)).
Definition sum := plus_poly.
Definition prod := mult_poly.
Definition diff := minus_poly.
Definition isigma A :=
  sum (sum (prod (iu A) (iu A)) (prod (iv A) (iv A))) (sum (prod (ip A) (ip A)) (prod (iq A) (iq A))).
Definition ih A A' :=
  sum (diff (prod (iu A) (iv A')) (prod (iu A') (iv A))) (diff (prod (ip A') (iq A)) (prod (ip A) (iq A'))).
Definition ig_re A A' :=
  sum (diff (prod (iu A) (iq A')) (prod (iv A) (ip A'))) (diff (prod (iv A') (ip A)) (prod (iu A') (iq A))).
Definition ig_im A A' :=
  diff (sum (prod (iu A) (ip A')) (prod (iv A) (iq A'))) (sum (prod (iu A') (ip A)) (prod (iv A') (iq A))).
Definition ix A :=
  diff (sum (prod (iu A) (iu A)) (prod (iv A) (iv A))) (sum (prod (ip A) (ip A)) (prod (iq A) (iq A))).
Definition iy A := times 2 (sum (prod (iu A) (iq A)) (prod (iv A) (ip A))).
Definition iz A := times 2 (diff (prod (iv A) (iq A)) (prod (iu A) (ip A))).

(* Greatest common divisors, by Euclid's algorithm with integers; here the highest coefficient is the first. Nothing
   rests on them: what they divide is multiplied again. *)
Fixpoint stripped (a : poly) : poly :=
  match a with [] => [] | c :: a' => if (c =? 0)%Z then stripped a' else a end.
Definition primitive_part (a : poly) : poly :=
  let g := fold_right Z.gcd 0%Z a in if (g =? 0)%Z then a else map (fun c => c / g)%Z a.
Fixpoint less_front (k : Z) (a : poly) (l : Z) (b : poly) : poly :=
  match a, b with
  | c :: a, d :: b => (k * c - l * d)%Z :: less_front k a l b
  | _, _ => times k a
  end.
Fixpoint remainder (fuel : nat) (a b : poly) : poly :=
  match fuel, a, b with
  | S fuel, c :: a', d :: b' =>
      if (length a <? length b)%nat then a
      else let g := Z.gcd c d in remainder fuel (stripped (less_front (d / g) a' (c / g) b')) b
  | _, _, _ => a
  end.
Fixpoint gcd_poly (fuel : nat) (a b : poly) : poly :=
  match fuel, b with
  | S fuel, _ :: _ => gcd_poly fuel b (primitive_part (remainder (S (length a)) a b))
  | _, _ => primitive_part a
  end.
Fixpoint quotient (fuel : nat) (a b : poly) : poly :=
  match fuel, a, b with
  | S fuel, c :: a', d :: b' =>
      if (length a <? length b)%nat then []
      else let k := (c / d)%Z in k :: quotient fuel (less_front 1 a' k b') b
  | _, _, _ => []
  end.
Definition highest_first (a : poly) := stripped (rev' a).
Definition divided (a b : poly) := rev' (quotient (S (length a)) (highest_first a) (highest_first b)).
Definition common_divisor (A : curve) : poly :=
  let gcd a b :=
    let a := highest_first a in
    let b := highest_first b in
    rev' (gcd_poly (S (length a + length b)) a b) in
  gcd (iu A) (gcd (iv A) (gcd (ip A) (iq A))).

(* For the integral: the same rate by lists of integers of the same length, the denominator positive at 0. *)
Definition padded (n : nat) (a : poly) := plus_poly a (repeat 0%Z n).
Definition as_integers (n d : list Q) : poly * poly :=
  let a := denominator_of n in
  let b := denominator_of d in
  let n := times (Zpos b) (over a n) in
  let d := times (Zpos a) (over b d) in
  let g := Z.gcd (fold_right Z.gcd 0%Z n) (fold_right Z.gcd 0%Z d) in
  let g := if (hd 0 d <? 0)%Z then (- g)%Z else g in
  let reduced a := map (fun c => c / g)%Z a in
  (padded (length d) (reduced n), padded (length n) (reduced d)).

Definition within_radius (l : claim) (low high : Q) :=
  Qle_bool (angle l - radius l)%Q low && Qle_bool high (angle l + radius l)%Q.

(* The integral of n/d on [0, 1] is what l says. *)
Definition integral_shows (depth terms : nat) (unit : positive) (n d : poly) (l : claim) :=
  match integral depth terms (Zpos unit) n d with
  | None => false
  | Some (low, high) => within_radius l (Qmake low unit) (Qmake high unit)
  end.

(* Intervals are halved at most `depth` times, one inside another. *)
Definition check_angle (depth : nat) (A0 : curve) (n d : poly) (l : claim) :=
  let a := Qnum (time l) in
  let b := Zpos (Qden (time l)) in
  if is_positive depth (fst (stretched a b (isigma A0))) then
    if (a =? 0)%Z || is_zero (ih A0 (derived_curve A0)) then within_radius l 0 0
    else
      let n := times a (fst (stretched a b n)) in
      let d := times b (fst (stretched a b d)) in
      let bits := (Z.log2_up (Zpos (Qden (radius l)) / Qnum (radius l)) + 16)%Z in
      let shows bits := integral_shows depth (length d * Z.to_nat bits) (Z.to_pos (2 ^ bits)) n d l in
      if shows bits then true else shows (bits + 240)%Z
  else false.

Definition accept_within (depth : nat) (c : certificate) : bool :=
  let d := denominator_of (cu c ++ cv c ++ cp c ++ cq c) in
  let A := Curve (over d (cu c)) (over d (cv c)) (over d (cp c)) (over d (cq c)) in
  let A' := derived_curve A in
  let e := denominator_of (multiplier c) in
  let f := over e (multiplier c) in
  let k := common_divisor A in
  let A0 := Curve (divided (iu A) k) (divided (iv A) k) (divided (ip A) k) (divided (iq A) k) in
  let s := isigma A in
  let t := isigma A0 in
  let m := denominator_of (common c) in
  let nn := denominator_of (numerator c) in
  let dn := denominator_of (denominator c) in
  let (n1, d1) := as_integers (numerator c) (denominator c) in
  is_over d (cu c) && is_over d (cv c) && is_over d (cp c) && is_over d (cq c) && is_over e (multiplier c) &&
  is_fraction (cx' c) (prod f (ix A)) (e * (d * d)) &&
  is_fraction (cy' c) (prod f (iy A)) (e * (d * d)) &&
  is_fraction (cz' c) (prod f (iz A)) (e * (d * d)) &&
  is_fraction (csigma c) s (d * d) && is_fraction (ch c) (ih A A') (d * d) &&
  is_fraction (cg_re c) (ig_re A A') (d * d) && is_fraction (cg_im c) (ig_im A A') (d * d) &&
  is_over m (common c) && is_over nn (numerator c) && is_over dn (denominator c) &&
  same (times (-2 * Zpos (nn * m)) (ih A A'))
    (times (Zpos (d * d)) (prod (over nn (numerator c)) (over m (common c)))) &&
  same (times (Zpos (dn * m)) s)
    (times (Zpos (d * d)) (prod (over dn (denominator c)) (over m (common c)))) &&
  negb (is_zero k) &&
  same (iu A) (prod k (iu A0)) && same (iv A) (prod k (iv A0)) &&
  same (ip A) (prod k (ip A0)) && same (iq A) (prod k (iq A0)) &&
  is_positive depth t &&
  same (times (-2) (prod (ih A0 (derived_curve A0)) d1)) (prod n1 t) &&
  Nat.eqb (length n1) (length d1) &&
  forallb (check_angle depth A0 n1 d1) (claims c).

Definition accept := accept_within 400.

(* ---- The proof *)

Lemma value_over d a x : is_over d a = true -> at_real (over d a) x = IZR (Zpos d) * value a x.
Proof.
  unfold is_over, over; induction a as [| c a IH]; cbn [forallb map at_real value]; [intros _; ring |].
  intros [C H]%andb_true_iff; apply Z.eqb_eq in C; rewrite (IH H), Rmult_plus_distr_l; f_equal; [| ring].
  rewrite <- C at 2; unfold Q2R; rewrite !mult_IZR; field; apply IZR_neq; discriminate.
Qed.

Lemma positive_real (p : positive) : 0 < IZR (Zpos p).
Proof. apply IZR_lt; reflexivity. Qed.

Lemma value_fraction a n d x : is_fraction a n d = true -> value a x = at_real n x / IZR (Zpos d).
Proof.
  intros [O S]%andb_true_iff; apply (at_same _ _ x) in S; rewrite !at_times, value_over in S by exact O.
  pose proof (positive_real d); pose proof (positive_real (denominator_of a)) as E.
  apply (Rmult_eq_reg_l (IZR (Zpos (denominator_of a)))); [| lra].
  apply (Rmult_eq_reg_l (IZR (Zpos d))); [| lra]; rewrite S; field; lra.
Qed.

(* The real quaternions of four polynomials. *)
Definition reals (A : curve) (s : R) :=
  Quaternion (at_real (iu A) s) (at_real (iv A) s) (at_real (ip A) s) (at_real (iq A) s).

Ltac values := unfold sum, prod, diff; rewrite ?at_minus, ?at_plus, ?at_times, ?at_minus, ?at_plus, ?at_mult.

Lemma at_isigma A s : at_real (isigma A) s = sigma (reals A s).
Proof. unfold isigma, sigma, reals; values; simpl; ring. Qed.
Lemma at_ih A A' s : at_real (ih A A') s = h (reals A s) (reals A' s).
Proof. unfold ih, h, reals; values; simpl; ring. Qed.
Lemma at_ig_re A A' s : at_real (ig_re A A') s = g_re (reals A s) (reals A' s).
Proof. unfold ig_re, g_re, reals; values; simpl; ring. Qed.
Lemma at_ig_im A A' s : at_real (ig_im A A') s = g_im (reals A s) (reals A' s).
Proof. unfold ig_im, g_im, reals; values; simpl; ring. Qed.
Lemma at_ixyz A s :
  Vector (at_real (ix A) s) (at_real (iy A) s) (at_real (iz A) s) = rotated (reals A s) (Vector 1 0 0).
Proof. apply vector_eq; unfold ix, iy, iz, rotated, reals; values; simpl; ring. Qed.

Lemma reals_derivative A s : quaternion_derivative (reals A) s (reals (derived_curve A) s).
Proof. split; [| split; [| split]]; apply at_derived. Qed.

Lemma reals_continuous A s : quaternion_continuous (reals A) s.
Proof. split; [| split; [| split]]; apply at_continuous. Qed.

(* Where A is clear is an open interval. *)
Lemma clear_interval A : (forall s, continuous (fun s => sigma (A s)) s) -> open_interval (clear A).
Proof.
  intro C; split.
  - intros t T.
    assert (P : locally t (fun s => 0 < sigma (A s))).
    { apply (C t (fun y => 0 < y)); apply (open_gt 0); apply T; unfold within, Rmin, Rmax; destruct (Rle_dec 0 t); lra. }
    destruct P as [eps P]; exists eps; intros x X s S.
    destruct (Rle_dec (Rmin 0 t) s) as [S1 | S1]; [destruct (Rle_dec s (Rmax 0 t)) as [S2 | S2] |].
    + apply T; split; assumption.
    + apply P; revert X; unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl.
      unfold within, Rmin, Rmax, Rabs in *; repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
    + apply P; revert X; unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl.
      unfold within, Rmin, Rmax, Rabs in *; repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
  - intros a b t Ta Tb X s S; destruct (Rle_dec 0 t); [apply Tb | apply Ta];
      unfold within, Rmin, Rmax in *; repeat destruct Rle_dec; lra.
Qed.

(* From [0, 1] to what is between 0 and m/n. *)
Lemma within_ratio m n s : (0 < n)%Z -> m <> 0%Z -> within (IZR m / IZR n) s ->
  exists x, 0 <= x <= 1 /\ s = IZR m / IZR n * x.
Proof.
  intros N M W; apply IZR_lt in N; apply IZR_neq in M.
  assert (Z : IZR m / IZR n <> 0) by (intro E; apply M; apply (Rmult_eq_reg_r (/ IZR n)); [| apply Rinv_neq_0_compat; lra]; unfold Rdiv in E; lra).
  exists (s / (IZR m / IZR n)); set (t := IZR m / IZR n) in *; split; [| field; exact Z].
  unfold within, Rmin, Rmax in W; destruct (Rle_dec 0 t).
  - split; [apply Rcomplements.Rdiv_le_0_compat | apply Rle_div_l]; lra.
  - replace (s / t) with (- s / - t) by (field; exact Z).
    split; [apply Rcomplements.Rdiv_le_0_compat | apply Rle_div_l]; lra.
Qed.

Lemma stretched_positive m n a : (0 < n)%Z ->
  (forall x, 0 <= x <= 1 -> 0 < at_real (fst (stretched m n a)) x) ->
  forall s, within (IZR m / IZR n) s -> 0 < at_real a s.
Proof.
  intros N P s S; assert (F : 0 < IZR (n ^ Z.of_nat (length a))) by (apply IZR_lt, Z.pow_pos_nonneg; lia).
  destruct (Z.eq_dec m 0) as [-> | M].
  - specialize (P 0); rewrite at_stretched in P by lia.
    assert (s = 0) as -> by (revert S; unfold within, Rdiv; rewrite Rmult_0_l, Rmin_left, Rmax_left by lra; lra).
    rewrite Rmult_0_r in P; apply (Rmult_lt_reg_l _ _ _ F); lra.
  - destruct (within_ratio m n s N M S) as (x & X & ->).
    specialize (P x X); rewrite at_stretched in P by lia; apply (Rmult_lt_reg_l _ _ _ F); lra.
Qed.

(* The integral from 0 to m/n, on [0, 1]. *)
Lemma stretched_integral m n a b : (0 < n)%Z -> length a = length b ->
  (forall s, within (IZR m / IZR n) s -> at_real b s <> 0) ->
  RInt (fun x => at_real (times m (fst (stretched m n a))) x / at_real (times n (fst (stretched m n b))) x) 0 1 =
  RInt (fun s => at_real a s / at_real b s) 0 (IZR m / IZR n).
Proof.
  intros N L P; set (t := IZR m / IZR n) in *; pose proof (IZR_lt _ _ N) as N'.
  assert (E : ex_RInt (fun s => at_real a s / at_real b s) (t * 0 + 0) (t * 1 + 0)).
  { replace (t * 0 + 0) with 0 by ring; replace (t * 1 + 0) with t by ring.
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)); intros s S; apply quotient_continuous, P, S. }
  pose proof (RInt_comp_lin _ t 0 0 1 E) as H.
  replace (t * 0 + 0) with 0 in H by ring; replace (t * 1 + 0) with t in H by ring; rewrite <- H.
  apply RInt_ext; intros x X; rewrite Rmin_left, Rmax_right in X by lra.
  rewrite !at_times, !at_stretched by lia; fold t; rewrite L, Rplus_0_r.
  assert (F : 0 < IZR (n ^ Z.of_nat (length b))) by (apply IZR_lt, Z.pow_pos_nonneg; lia).
  unfold scal; simpl; unfold mult; simpl; unfold t; field; repeat split; try lra.
  apply P; unfold within, t, Rmin, Rmax; destruct (Rle_dec 0 (IZR m / IZR n)); nra.
Qed.

Lemma within_radius_sound l low high v : within_radius l low high = true ->
  Q2R low <= v <= Q2R high -> Rabs (v - Q2R (angle l)) <= Q2R (radius l).
Proof.
  intros [A B]%andb_true_iff V; apply Qle_bool_iff, Qle_Rle in A; apply Qle_bool_iff, Qle_Rle in B.
  rewrite Q2R_minus in A; rewrite Q2R_plus in B; apply Rcomplements.Rabs_le_between; lra.
Qed.

Lemma integral_shows_sound depth terms unit n d l :
  length n = length d -> integral_shows depth terms unit n d l = true ->
  (forall x, 0 <= x <= 1 -> 0 < at_real d x) /\
  Rabs (RInt (fun x => at_real n x / at_real d x) 0 1 - Q2R (angle l)) <= Q2R (radius l).
Proof.
  intros L H; unfold integral_shows in H.
  destruct (integral depth terms (Zpos unit) n d) as [[low high] |] eqn:I; [| discriminate].
  apply integral_sound in I as [D I]; [split; [exact D |] | reflexivity | exact L].
  apply (within_radius_sound _ _ _ _ H); unfold encloses in I; cbn [fst snd] in I.
  set (v := RInt _ 0 1) in *; clearbody v.
  pose proof (positive_real unit) as U; unfold Q2R; cbn [Qnum Qden].
  split; [apply Rle_div_l | apply Rle_div_r]; try exact U; lra.
Qed.

Lemma check_angle_sound depth A0 n d l : length n = length d ->
  (forall s, -2 * h (reals A0 s) (reals (derived_curve A0) s) * at_real d s = at_real n s * sigma (reals A0 s)) ->
  check_angle depth A0 n d l = true -> angle_statement (reals A0) (reals (derived_curve A0)) l.
Proof.
  intros L E H; unfold check_angle in H; cbv zeta in H.
  destruct (is_positive depth _) eqn:P in H; [| discriminate].
  set (a := Qnum (time l)) in *; set (b := Zpos (Qden (time l))) in *.
  assert (B : (0 < b)%Z) by reflexivity.
  assert (T : Q2R (time l) = IZR a / IZR b) by reflexivity.
  assert (C : clear (reals A0) (Q2R (time l))).
  { intros s S; rewrite <- at_isigma; rewrite T in S; revert S; apply stretched_positive; [exact B |].
    exact (is_positive_sound _ _ P). }
  split; [exact C |].
  set (w := fun s => -2 * h (reals A0 s) (reals (derived_curve A0) s) / sigma (reals A0 s)).
  destruct (_ || is_zero _)%bool eqn:Z in H.
  - (* There is nothing to integrate. *)
    apply (within_radius_sound _ _ _ _ H).
    replace (RInt w 0 (Q2R (time l))) with 0; [change (Q2R 0) with (0 / 1); lra |].
    apply orb_true_iff in Z as [Z | Z].
    + apply Z.eqb_eq in Z; rewrite T, Z; unfold Rdiv; rewrite Rmult_0_l, RInt_point; reflexivity.
    + symmetry; rewrite (RInt_ext _ (fun _ => 0)).
      * rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; ring.
      * intros s S; unfold w; rewrite <- at_ih, (at_zero _ s Z); unfold Rdiv.
        rewrite Rmult_0_r; apply Rmult_0_l.
  - set (n' := times a (fst (stretched a b n))) in *; set (d' := times b (fst (stretched a b d))) in *.
    assert (K : exists depth' terms unit, integral_shows depth' terms unit n' d' l = true)
      by (destruct (integral_shows _ _ _ _ _ _) eqn:S in H; do 3 eexists; [exact S | exact H]).
    clear H; destruct K as (depth' & terms & unit & H).
    apply integral_shows_sound in H as [D H];
      [| unfold n', d'; rewrite !length_times, !length_stretched; exact L].
    assert (D' : forall s, within (IZR a / IZR b) s -> 0 < at_real d s).
    { apply stretched_positive; [exact B |]; intros x X; specialize (D x X); unfold d' in D; rewrite at_times in D.
      apply (Rmult_lt_reg_l (IZR b)); [apply IZR_lt, B | lra]. }
    unfold n', d' in H; rewrite (stretched_integral a b n d B L) in H by (intros s S; apply Rgt_not_eq, D', S).
    rewrite <- T in H.
    assert (W : RInt (fun s => at_real n s / at_real d s) 0 (Q2R (time l)) = RInt w 0 (Q2R (time l))).
    { apply RInt_ext; intros s S.
      assert (S' : within (Q2R (time l)) s) by (split; lra).
      specialize (C s S'); rewrite T in S'; specialize (D' s S').
      unfold w; apply (Rmult_eq_reg_r (at_real d s * sigma (reals A0 s))); [| nra].
      transitivity (at_real n s * sigma (reals A0 s)); [field; lra |]; rewrite <- E; field; lra. }
    rewrite W in H; exact H.
Qed.

(* Real multiples. *)
Lemma sigma_multiple k a : sigma (multiple k a) = k * k * sigma a.
Proof. unfold sigma, multiple; simpl; ring. Qed.
Lemma h_multiple k l a a' :
  h (multiple k a) (multiple l a') = k * l * h a a'.
Proof. unfold h, multiple; simpl; ring. Qed.
Lemma g_re_multiple k l a a' : g_re (multiple k a) (multiple l a') = k * l * g_re a a'.
Proof. unfold g_re, multiple; simpl; ring. Qed.
Lemma g_im_multiple k l a a' : g_im (multiple k a) (multiple l a') = k * l * g_im a a'.
Proof. unfold g_im, multiple; simpl; ring. Qed.
Lemma rotated_multiple k a w : rotated (multiple k a) w = scale (k * k) (rotated a w).
Proof. apply vector_eq; unfold rotated, multiple; simpl; ring. Qed.
Lemma scale_scale k l w : scale k (scale l w) = scale (k * l) w.
Proof. apply vector_eq; simpl; ring. Qed.

Theorem accept_within_sound depth c : accept_within depth c = true -> statement c.
Proof.
  unfold accept_within; set (d := denominator_of (_ ++ _)); set (e := denominator_of (multiplier c)).
  set (f := over e (multiplier c)).
  set (A := Curve (over d (cu c)) (over d (cv c)) (over d (cp c)) (over d (cq c))).
  set (A' := derived_curve A).
  set (k := common_divisor A); clearbody k.
  set (A0 := Curve (divided _ _) (divided _ _) (divided _ _) (divided _ _)); clearbody A0.
  cbv zeta; destruct (as_integers _ _) as [n1 d1].
  rewrite !andb_true_iff, negb_true_iff.
  set (m := denominator_of (common c)); set (nn := denominator_of (numerator c)).
  set (dn := denominator_of (denominator c)).
  intros H; decompose [and] H; clear H.
  pose proof (positive_real d) as Dp; pose proof (positive_real e) as Ep.
  set (At := fun s => Quaternion (value (cu c) s) (value (cv c) s) (value (cp c) s) (value (cq c) s)).
  assert (EA : forall s, At s = multiple (/ IZR (Zpos d)) (reals A s)).
  { intro s; unfold At, multiple, reals, A; cbn [qu qv qp qq iu iv ip iq]; rewrite !value_over by assumption.
    f_equal; field; lra. }
  assert (DA : forall s, quaternion_derivative At s (multiple (/ IZR (Zpos d)) (reals (derived_curve A) s))).
  { intro s; assert (X : quaternion_derivative (fun s => multiple (/ IZR (Zpos d)) (reals A s)) s
        (multiple (/ IZR (Zpos d)) (reals (derived_curve A) s))).
    { destruct (reals_derivative A s) as (X1 & X2 & X3 & X4).
      split; [| split; [| split]]; apply is_derive_scal; assumption. }
    destruct X as (X1 & X2 & X3 & X4).
    split; [| split; [| split]]; eapply is_derive_ext; try eassumption; intro; cbv beta; rewrite EA; reflexivity. }
  assert (INV : forall s,
    Vector (value (cx' c) s) (value (cy' c) s) (value (cz' c) s) =
      scale (value (multiplier c) s) (rotated (At s) (Vector 1 0 0)) /\
    value (csigma c) s = sigma (At s) /\
    value (ch c) s = h (At s) (multiple (/ IZR (Zpos d)) (reals (derived_curve A) s)) /\
    value (cg_re c) s = g_re (At s) (multiple (/ IZR (Zpos d)) (reals (derived_curve A) s)) /\
    value (cg_im c) s = g_im (At s) (multiple (/ IZR (Zpos d)) (reals (derived_curve A) s))).
  { intro s; rewrite EA, rotated_multiple, sigma_multiple, h_multiple, g_re_multiple, g_im_multiple, scale_scale.
    rewrite <- at_ixyz, <- at_isigma, <- at_ih, <- at_ig_re, <- at_ig_im.
    repeat match goal with
    | H : is_fraction ?a _ _ = true |- _ => rewrite (value_fraction a _ _ s H); clear H
    end.
    assert (F : value (multiplier c) s = at_real f s / IZR (Zpos e))
      by (unfold f; rewrite value_over by assumption; field; lra).
    rewrite !Pos2Z.inj_mul, !mult_IZR, F; fold A'.
    repeat split; [apply vector_eq; cbn [vx vy vz scale] | | | |]; unfold prod; rewrite ?at_mult; field; lra. }
  assert (E0 : forall s, At s = multiple (at_real k s / IZR (Zpos d)) (reals A0 s)).
  { intro s; rewrite EA; unfold reals, multiple; cbn [qu qv qp qq].
    repeat match goal with
    | H : same _ (prod k _) = true |- _ => apply (at_same _ _ s) in H; unfold prod in H; rewrite at_mult in H; rewrite H; clear H
    end; f_equal; field; lra. }
  assert (RATE : forall s,
    -2 * h (At s) (multiple (/ IZR (Zpos d)) (reals (derived_curve A) s)) =
      value (numerator c) s * value (common c) s /\
    sigma (At s) = value (denominator c) s * value (common c) s).
  { intro s; rewrite EA, sigma_multiple, h_multiple, <- at_isigma, <- at_ih; fold A'.
    pose proof (positive_real m) as Mp; pose proof (positive_real nn) as Np; pose proof (positive_real dn) as Np'.
    repeat match goal with
    | H : same (times _ _) (times (Zpos (d * d)) _) = true |- _ => apply (at_same _ _ s) in H;
        rewrite !at_times in H; unfold prod in H; rewrite at_mult, !value_over in H by assumption;
        rewrite ?mult_IZR, !Pos2Z.inj_mul, !mult_IZR in H; revert H
    end.
    fold m nn dn; intros R1 R2; split.
    - apply (Rmult_eq_reg_l (IZR (Zpos nn) * IZR (Zpos m) * (IZR (Zpos d) * IZR (Zpos d))));
        [| repeat apply Rmult_integral_contrapositive_currified; lra].
      transitivity (-2 * (IZR (Zpos nn) * IZR (Zpos m)) * at_real (ih A A') s); [field |]; lra.
    - apply (Rmult_eq_reg_l (IZR (Zpos dn) * IZR (Zpos m) * (IZR (Zpos d) * IZR (Zpos d))));
        [| repeat apply Rmult_integral_contrapositive_currified; lra].
      transitivity (IZR (Zpos dn) * IZR (Zpos m) * at_real (isigma A) s); [field |]; lra. }
  assert (ALONG : forall t, clear (reals A0) t ->
    Vector (value (cx' c) t) (value (cy' c) t) (value (cz' c) t) =
    scale (value (multiplier c) t * (at_real k t / IZR (Zpos d)) ^ 2 * sigma (reals A0 t)) (e1 (reals A0 t))).
  { intros t T; specialize (T t); rewrite (proj1 (INV t)), E0, rotated_multiple, scale_scale.
    unfold e1; rewrite scale_scale; f_equal.
    assert (P : 0 < sigma (reals A0 t)) by (apply T; unfold within, Rmin, Rmax; destruct (Rle_dec 0 t); lra).
    field; lra. }
  unfold statement; exists (fun s => multiple (/ IZR (Zpos d)) (reals (derived_curve A) s)).
  split; [exact DA | split; [exact INV | split; [exact RATE |]]].
  exists k, d, (reals A0), (reals (derived_curve A0)).
  split; [assumption | split; [exact E0 | split; [apply reals_derivative | split; [exact ALONG | split]]]].
  - assert (C : forall s, continuous (fun s => sigma (reals A0 s)) s).
    { intro s; apply (continuous_ext (at_real (isigma A0))); [intro; apply at_isigma | apply at_continuous]. }
    assert (P : forall t, clear (reals A0) t -> 0 < sigma (reals A0 t)).
    { intros t T; apply T; unfold within, Rmin, Rmax; destruct (Rle_dec 0 t); lra. }
    assert (U : forall t, 0 <= t <= 1 -> clear (reals A0) t).
    { intros t T s S; unfold within in S; rewrite Rmin_left, Rmax_right in S by lra.
      rewrite <- at_isigma; eapply is_positive_sound; [eassumption | lra]. }
    split; [exact (clear_interval _ C) | split; [exact U |]].
    apply frame_by_theta; auto using clear_interval, reals_derivative, reals_continuous.
    apply U; lra.
  - intros l L.
    match goal with
    | H : forallb _ (claims c) = true |- _ => rewrite forallb_forall in H; specialize (H l L); rename H into G
    end.
    revert G; apply check_angle_sound; [apply Nat.eqb_eq; assumption |].
    intro s.
    match goal with
    | H : same (times (-2) _) (prod n1 _) = true |- _ => apply (at_same _ _ s) in H; rename H into G
    end.
    unfold prod in G; rewrite at_times, !at_mult, at_ih, at_isigma in G; lra.
Qed.

(* If all is accepted, all is true. *)
Theorem accept_sound c : accept c = true -> statement c.
Proof. apply accept_within_sound. Qed.

Print Assumptions accept_sound.
