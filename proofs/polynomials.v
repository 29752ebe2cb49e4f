(* Polynomials with integer coefficients: lists from the constant term up. What is computed of them, and that it is
   true of their values at real numbers.

   Everything here can be computed, by Coq or as a program (verified_checker.v). *)
From Coq Require Import Reals ZArith List Lra Lia Bool.
From Coquelicot Require Import Coquelicot.
Import ListNotations.
Open Scope R_scope.

Definition poly := list Z.

(* The value at x. *)
Fixpoint at_real (a : poly) (x : R) : R :=
  match a with [] => 0 | c :: a => IZR c + x * at_real a x end.

Fixpoint plus_poly (a b : poly) : poly :=
  match a, b with
  | [], _ => b
  | _, [] => a
  | c :: a, d :: b => (c + d)%Z :: plus_poly a b
  end.
Definition times (k : Z) (a : poly) : poly := map (Z.mul k) a.
Fixpoint mult_poly (a b : poly) : poly :=
  match a with [] => [] | c :: a => plus_poly (times c b) (0%Z :: mult_poly a b) end.
Definition minus_poly a b := plus_poly a (times (-1) b).
Fixpoint derived (a : poly) : poly :=
  match a with [] => [] | c :: a => plus_poly a (0%Z :: derived a) end.
Definition is_zero (a : poly) := forallb (Z.eqb 0) a.
Definition same a b := is_zero (minus_poly a b).

(* a(x + 1). *)
Fixpoint shifted (a : poly) : poly :=
  match a with [] => [] | c :: a => let b := shifted a in plus_poly (c :: b) b end.
(* n^k a(m x/n) and n^k, for k coefficients. *)
Fixpoint stretched (m n : Z) (a : poly) : poly * Z :=
  match a with
  | [] => ([], 1%Z)
  | c :: a => let (b, w) := stretched m n a in ((c * w * n)%Z :: times m b, (w * n)%Z)
  end.
(* The sum of the absolute values of the coefficients. *)
Definition size (a : poly) : Z := fold_right (fun c s => Z.abs c + s)%Z 0%Z a.

Lemma at_plus a : forall b x, at_real (plus_poly a b) x = at_real a x + at_real b x.
Proof.
  induction a as [| c a IH]; intros [| d b] x; simpl; try ring.
  rewrite IH, plus_IZR; ring.
Qed.

Lemma at_times k a x : at_real (times k a) x = IZR k * at_real a x.
Proof. induction a as [| c a IH]; simpl; [ring |]. rewrite IH, mult_IZR; ring. Qed.

Lemma at_mult a b x : at_real (mult_poly a b) x = at_real a x * at_real b x.
Proof.
  induction a as [| c a IH]; simpl; [ring |].
  rewrite at_plus, at_times; simpl; rewrite IH; ring.
Qed.

Lemma at_minus a b x : at_real (minus_poly a b) x = at_real a x - at_real b x.
Proof. unfold minus_poly; rewrite at_plus, at_times; ring. Qed.

Lemma at_derived a x : is_derive (at_real a) x (at_real (derived a) x).
Proof.
  induction a as [| c a IH]; simpl.
  - apply (is_derive_const 0 x).
  - auto_derive; [eexists; exact IH |].
    rewrite at_plus; simpl; change (fun y : R => at_real a y) with (at_real a).
    rewrite (is_derive_unique _ _ _ IH); ring.
Qed.

Lemma at_continuous a x : continuous (at_real a) x.
Proof.
  apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)).
  eexists; apply at_derived.
Qed.

Lemma at_zero a x : is_zero a = true -> at_real a x = 0.
Proof.
  induction a as [| c a IH]; [reflexivity |].
  cbn [is_zero forallb at_real]; intros [C H]%andb_true_iff; apply Z.eqb_eq in C.
  rewrite <- C, IH by exact H; ring.
Qed.

Lemma at_same a b x : same a b = true -> at_real a x = at_real b x.
Proof. intros H%(fun H => at_zero _ x H); rewrite at_minus in H; lra. Qed.

Lemma at_shifted a x : at_real (shifted a) x = at_real a (x + 1).
Proof.
  induction a as [| c a IH]; [reflexivity |].
  change (shifted (c :: a)) with (plus_poly (c :: shifted a) (shifted a)).
  rewrite at_plus; simpl; rewrite IH; ring.
Qed.

Lemma stretched_factor m n a : snd (stretched m n a) = (n ^ Z.of_nat (length a))%Z.
Proof.
  induction a as [| c a IH]; [reflexivity |].
  cbn [stretched length]; destruct (stretched m n a) as [b w]; cbn [snd] in *.
  rewrite IH, Nat2Z.inj_succ, Z.pow_succ_r by apply Nat2Z.is_nonneg; apply Z.mul_comm.
Qed.

Lemma at_stretched m n a x : n <> 0%Z ->
  at_real (fst (stretched m n a)) x = IZR (n ^ Z.of_nat (length a)) * at_real a (IZR m / IZR n * x).
Proof.
  intro N; rewrite <- (stretched_factor m n a).
  assert (N' : IZR n <> 0) by (intro E; apply N, eq_IZR, E).
  induction a as [| c a IH]; simpl; [ring |].
  destruct (stretched m n a) as [b w]; simpl in *.
  rewrite at_times, IH, !mult_IZR; field; exact N'.
Qed.

Lemma length_plus a : forall b, length (plus_poly a b) = Nat.max (length a) (length b).
Proof. induction a as [| c a IH]; intros [| d b]; simpl; auto. Qed.

Lemma length_times k a : length (times k a) = length a.
Proof. induction a as [| c a IH]; simpl; [| rewrite IH]; reflexivity. Qed.

Lemma length_shifted a : length (shifted a) = length a.
Proof.
  induction a as [| c a IH]; [reflexivity |].
  change (shifted (c :: a)) with (plus_poly (c :: shifted a) (shifted a)).
  rewrite length_plus; cbn [length]; rewrite IH; lia.
Qed.

Lemma length_stretched m n a : length (fst (stretched m n a)) = length a.
Proof.
  induction a as [| c a IH]; [reflexivity |].
  simpl; destruct (stretched m n a) as [b w]; simpl in *; rewrite length_times, IH; reflexivity.
Qed.

(* |a(x)| on [-1, 1]. *)
Lemma size_bounds a x : -1 <= x <= 1 -> Rabs (at_real a x) <= IZR (size a).
Proof.
  intro X; induction a as [| c a IH]; simpl; [rewrite Rabs_R0; apply Rle_refl |].
  rewrite plus_IZR, abs_IZR.
  eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_l.
  rewrite Rabs_mult; apply Rle_trans with (1 * Rabs (at_real a x)); [| lra].
  apply Rmult_le_compat_r; [apply Rabs_pos | apply Rabs_le; exact X].
Qed.
