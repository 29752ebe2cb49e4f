(* Enclosures of integrals of quotients of polynomials with integer coefficients, by integers.

   [0, 1] is halved until, with x = (1 + y)/2, the denominator b0 + b1 y + ... has b0 > |b1| + |b2| + ... by a wide
   margin: then it is positive on [-1, 1], the quotient a/b has a power series there that converges fast, and what
   p, a partial sum of it, rounded, leaves of a is e = a - p b, of which each value is at most the sum of the |ek|. So
   a/b differs from p by at most that over b0 - |b1| - |b2| - ..., however p was found. *)
From Coq Require Import Reals ZArith List Lra Lia Bool.
From Coquelicot Require Import Coquelicot.
Require Import polynomials.
Import ListNotations.
Open Scope R_scope.

(* ---- What is computed. Numbers are in units of 1/unit. *)

Fixpoint dot_product (a b : poly) : Z :=
  match a, b with c :: a, d :: b => (c * d + dot_product a b)%Z | _, _ => 0%Z end.
Fixpoint all_tiny (n : nat) (a : poly) : bool :=
  match n, a with
  | O, _ => true
  | S n, c :: a => (Z.abs c <=? 1)%Z && all_tiny n a
  | _, _ => false
  end.

(* The power series of unit a/(b0 + y b), rounded down, up to where it has become tiny; `found` is what there is of it,
   the last coefficient first. Nothing rests on this. *)
Fixpoint series (fuel : nat) (unit : Z) (a : poly) (b0 : Z) (b : poly) (found : poly) : poly :=
  match fuel, a with
  | O, _ => rev' found
  | S fuel, [] =>
      if all_tiny (length b) found then rev' found
      else series fuel unit [] b0 b ((- dot_product b found / b0)%Z :: found)
  | S fuel, c :: a =>
      series fuel unit a b0 b (((c * unit - dot_product b found) / b0)%Z :: found)
  end.

(* The mean value of y^(k-1) p(y) on [-1, 1] for odd k, each term rounded down. *)
Fixpoint mean (k : Z) (p : poly) : Z :=
  match p with
  | [] => 0
  | [c] => c / k
  | c :: _ :: p => c / k + mean (k + 2) p
  end%Z.

Definition margin := 4%Z.

(* That of a/b on [-1, 1]: numbers that are not greater, and not less. *)
Definition enclosed_mean (terms : nat) (unit : Z) (a b : poly) : option (Z * Z) :=
  match b with
  | [] => None
  | b0 :: b' =>
      let rest := (b0 - size b')%Z in
      if (margin * size b' <? b0)%Z then
        let p := series terms unit a b0 b' [] in
        let error := (size (minus_poly (times unit a) (mult_poly p b)) / rest + 1)%Z in
        let m := mean 1 p in
        Some (m - error, m + Z.of_nat (length p) + error)%Z
      else None
  end.

(* The integral of a/b on [0, 1], a and b being lists of the same length. *)
Fixpoint integral (depth terms : nat) (unit : Z) (a b : poly) : option (Z * Z) :=
  let a1 := fst (stretched 1 2 a) in
  let b1 := fst (stretched 1 2 b) in
  let a2 := shifted a1 in
  let b2 := shifted b1 in
  match enclosed_mean terms unit a2 b2, depth with
  | Some found, _ => Some found
  | None, O => None
  | None, S depth =>
      match integral depth terms unit a1 b1 with
      | None => None
      | Some (low, high) =>
          match integral depth terms unit a2 b2 with
          | None => None
          | Some (low', high') => Some ((low + low') / 2, (high + high') / 2 + 1)%Z
          end
      end
  end.

(* Whether b > 0 on [0, 1]. (Of || and && Coq computes both sides.) *)
Fixpoint is_positive (depth : nat) (b : poly) : bool :=
  let b1 := fst (stretched 1 2 b) in
  let b2 := shifted b1 in
  match b2 with
  | [] => false
  | b0 :: b' =>
      if (size b' <? b0)%Z then true
      else match depth with O => false | S depth => if is_positive depth b1 then is_positive depth b2 else false end
  end.

(* ---- Its proof *)

Lemma floor_bounds (n k : Z) : (0 < k)%Z -> IZR (n / k) <= IZR n / IZR k < IZR (n / k) + 1.
Proof.
  intro K; pose proof (IZR_lt _ _ K) as K'.
  pose proof (Z.mul_div_le n k K) as L; pose proof (Z.mul_succ_div_gt n k K) as G.
  apply IZR_le in L; apply IZR_lt in G; rewrite mult_IZR in L, G; rewrite succ_IZR in G.
  split; [apply Rle_div_r | apply Rlt_div_l]; lra.
Qed.

(* The primitive function of y^k a(y). *)
Fixpoint primitive (k : nat) (a : poly) (y : R) : R :=
  match a with [] => 0 | c :: a => IZR c * (y ^ S k / INR (S k)) + primitive (S k) a y end.

Lemma primitive_derivative a : forall k y, is_derive (primitive k a) y (y ^ k * at_real a y).
Proof.
  induction a as [| c a IH]; intros k y.
  - apply (is_derive_ext (fun _ => 0)); [reflexivity |].
    replace (y ^ k * at_real [] y) with 0 by (simpl; ring); apply (is_derive_const 0 y).
  - pose proof (IH (S k) y) as H.
    assert (N : INR (S k) <> 0) by (apply not_0_INR; discriminate).
    assert (P : is_derive (fun y => IZR c * (y ^ S k / INR (S k))) y (IZR c * y ^ k)).
    { auto_derive; [exact I |]. cbn [Nat.pred]; field; exact N. }
    replace (y ^ k * at_real (c :: a) y) with (IZR c * y ^ k + y ^ S k * at_real a y) by (simpl; ring).
    exact (is_derive_plus _ _ _ _ _ P H).
Qed.

Lemma mean_bounds n : forall p k, (length p <= n)%nat ->
  IZR (mean (Z.of_nat (S (2 * k))) p) <= (primitive (2 * k) p 1 - primitive (2 * k) p (-1)) / 2
    <= IZR (mean (Z.of_nat (S (2 * k))) p) + INR (length p).
Proof.
  assert (E : forall k c, IZR (c / Z.of_nat (S (2 * k))) <=
      (IZR c * (1 ^ S (2 * k) / INR (S (2 * k))) - IZR c * ((-1) ^ S (2 * k) / INR (S (2 * k)))) / 2
      <= IZR (c / Z.of_nat (S (2 * k))) + 1).
  { intros k c; rewrite pow1, pow_1_odd.
    assert (N : INR (S (2 * k)) <> 0) by (apply not_0_INR; discriminate).
    replace ((IZR c * (1 / INR (S (2 * k))) - IZR c * (-1 / INR (S (2 * k)))) / 2)
      with (IZR c / IZR (Z.of_nat (S (2 * k)))) by (rewrite <- INR_IZR_INZ; field; exact N).
    pose proof (floor_bounds c (Z.of_nat (S (2 * k)))); lia || (split; [apply H | left; apply H]; lia). }
  induction n as [| n IH]; intros p k L.
  - destruct p; [simpl; lra | inversion L].
  - destruct p as [| c [| d p]]; [simpl; lra | |].
    + specialize (E k c); cbn [mean primitive length]; change (INR 1) with 1; lra.
    + assert (L' : (length p <= n)%nat) by (simpl in L; lia).
      specialize (E k c); specialize (IH p (S k) L').
      replace (2 * S k)%nat with (S (S (2 * k))) in IH by lia.
      replace (Z.of_nat (S (S (S (2 * k))))) with (Z.of_nat (S (2 * k)) + 2)%Z in IH by lia.
      cbn [mean primitive length].
      set (j := S (2 * k)) in *.
      assert (O : (-1) ^ S j = 1).
      { replace (S j) with (2 * S k)%nat by (unfold j; lia); apply pow_1_even. }
      rewrite (pow1 (S j)), O, plus_IZR, !S_INR; rewrite ?S_INR in *.
      pose proof (pos_INR (length p)); lra.
Qed.

Lemma quotient_continuous a b x : at_real b x <> 0 -> continuous (fun x => at_real a x / at_real b x) x.
Proof.
  intro N; apply (continuous_mult (K := R_AbsRing)); [apply at_continuous |].
  apply continuous_Rinv_comp; [apply at_continuous | exact N].
Qed.

Lemma quotient_integrable a b low high : low <= high ->
  (forall x, low <= x <= high -> at_real b x <> 0) ->
  ex_RInt (fun x => at_real a x / at_real b x) low high.
Proof.
  intros L N; apply (ex_RInt_continuous (V := R_CompleteNormedModule)); intros x X.
  rewrite Rmin_left, Rmax_right in X by exact L; apply quotient_continuous, N, X.
Qed.

(* What the values of the functions computed mean: low <= unit v <= high. *)
Definition encloses (unit : Z) (found : Z * Z) (v : R) :=
  IZR (fst found) <= IZR unit * v <= IZR (snd found).

Lemma tail_positive b0 b y : (size b < b0)%Z -> -1 <= y <= 1 ->
  IZR (b0 - size b) <= at_real (b0 :: b) y.
Proof.
  intros S Y; pose proof (size_bounds b y Y) as B; rewrite minus_IZR; simpl.
  assert (T : Rabs (y * at_real b y) <= IZR (size b)).
  { rewrite Rabs_mult; apply Rle_trans with (1 * Rabs (at_real b y)); [| lra].
    apply Rmult_le_compat_r; [apply Rabs_pos | apply Rabs_le; exact Y]. }
  pose proof (Rcomplements.Rabs_le_between (y * at_real b y) (IZR (size b))) as [H _].
  specialize (H T); lra.
Qed.

Lemma size_nonnegative a : (0 <= size a)%Z.
Proof. induction a as [| c a IH]; simpl; lia. Qed.

(* How far a/b is from p. *)
Lemma quotient_close unit a b p rest y : (0 < unit)%Z -> (0 < rest)%Z ->
  -1 <= y <= 1 -> IZR rest <= at_real b y ->
  Rabs (IZR unit * (at_real a y / at_real b y) - at_real p y) <=
    IZR (size (minus_poly (times unit a) (mult_poly p b)) / rest + 1).
Proof.
  intros U P Y B.
  apply IZR_lt in P as P'; assert (N : 0 < at_real b y) by lra.
  pose proof (size_bounds (minus_poly (times unit a) (mult_poly p b)) y Y) as E.
  rewrite at_minus, at_times, at_mult in E.
  set (e := size _) in *.
  replace (IZR unit * (at_real a y / at_real b y) - at_real p y) with
    ((IZR unit * at_real a y - at_real p y * at_real b y) / at_real b y) by (field; lra).
  unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ at_real b y)) by (left; apply Rinv_0_lt_compat, N).
  apply Rle_trans with (IZR e / IZR rest).
  - apply Rmult_le_compat; [apply Rabs_pos | left; apply Rinv_0_lt_compat, N | exact E |].
    apply Rinv_le_contravar; assumption.
  - rewrite plus_IZR; left; apply floor_bounds, P.
Qed.

Lemma enclosed_mean_sound terms unit a b found : (0 < unit)%Z ->
  enclosed_mean terms unit a b = Some found ->
  (forall y, -1 <= y <= 1 -> 0 < at_real b y) /\
  encloses unit found (RInt (fun y => at_real a y / at_real b y) (-1) 1 / 2).
Proof.
  intros U H; destruct b as [| b0 b]; [discriminate |].
  unfold enclosed_mean in H.
  destruct (Z.ltb_spec (margin * size b) b0) as [S |]; [| discriminate].
  pose proof (size_nonnegative b) as Sn.
  assert (S' : (size b < b0)%Z) by (unfold margin in S; lia).
  injection H as <-.
  set (p := series _ _ _ _ _ _); clearbody p.
  set (rest := (b0 - size b)%Z).
  assert (R0 : (0 < rest)%Z) by (unfold rest; lia).
  assert (B : forall y, -1 <= y <= 1 -> IZR rest <= at_real (b0 :: b) y)
    by (intros y Y; apply tail_positive; assumption).
  assert (P : forall y, -1 <= y <= 1 -> 0 < at_real (b0 :: b) y)
    by (intros y Y; apply IZR_lt in R0; specialize (B y Y); lra).
  split; [exact P |].
  pose proof (fun y Y => quotient_close unit a (b0 :: b) p rest y U R0 Y (B y Y)) as C.
  set (error := (_ / rest + 1)%Z) in *; clearbody error.
  set (F := fun y => at_real a y / at_real (b0 :: b) y) in *.
  assert (I : is_RInt F (-1) 1 (RInt F (-1) 1)).
  { apply (RInt_correct (V := R_CompleteNormedModule)), quotient_integrable; [lra |].
    intros y Y; apply Rgt_not_eq, P, Y. }
  set (J := RInt F (-1) 1) in *; clearbody J.
  assert (I' : is_RInt (fun y => IZR unit * F y) (-1) 1 (IZR unit * J))
    by exact (is_RInt_scal F (-1) 1 (IZR unit) J I).
  assert (Q : is_RInt (at_real p) (-1) 1 (primitive 0 p 1 - primitive 0 p (-1))).
  { apply (is_RInt_derive (V := R_CompleteNormedModule) (primitive 0 p) (at_real p)); intros y _.
    - pose proof (primitive_derivative p 0 y) as D; rewrite Rmult_1_l in D; exact D.
    - apply at_continuous. }
  pose proof (mean_bounds (length p) p 0 (le_n _)) as M; change (2 * 0)%nat with 0%nat in M.
  change (Z.of_nat 1) with 1%Z in M.
  set (v := primitive 0 p 1 - primitive 0 p (-1)) in *; clearbody v.
  assert (K : forall k : R, is_RInt (fun _ => k) (-1) 1 (2 * k)).
  { intro k; replace (2 * k) with (scal (1 - -1) k) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_const (V := R_CompleteNormedModule)). }
  assert (Low : v - 2 * IZR error <= IZR unit * J).
  { apply (is_RInt_le (fun y => at_real p y - IZR error) (fun y => IZR unit * F y) (-1) 1); [lra | | exact I' |].
    - exact (is_RInt_minus _ _ _ _ _ _ Q (K (IZR error))).
    - intros y Y; assert (Y' : -1 <= y <= 1) by lra; specialize (C y Y').
      apply Rcomplements.Rabs_le_between in C; unfold F; lra. }
  assert (High : IZR unit * J <= v + 2 * IZR error).
  { apply (is_RInt_le (fun y => IZR unit * F y) (fun y => at_real p y + IZR error) (-1) 1); [lra | exact I' | |].
    - exact (is_RInt_plus _ _ _ _ _ _ Q (K (IZR error))).
    - intros y Y; assert (Y' : -1 <= y <= 1) by lra; specialize (C y Y').
      apply Rcomplements.Rabs_le_between in C; unfold F; lra. }
  unfold encloses; cbn [fst snd].
  rewrite !plus_IZR, minus_IZR, <- INR_IZR_INZ; lra.
Qed.

(* The halves and the middle. *)
Section Halves.
Variable a : poly.
Let a1 := fst (stretched 1 2 a).
Let a2 := shifted a1.
Let w := IZR (2 ^ Z.of_nat (length a)).

Lemma at_left x : at_real a1 x = w * at_real a (1 / 2 * x).
Proof. apply (at_stretched 1 2); discriminate. Qed.

Lemma at_right x : at_real a2 x = w * at_real a (1 / 2 * x + 1 / 2).
Proof. unfold a2; rewrite at_shifted, at_left; do 2 f_equal; field. Qed.

Lemma half_factor : 0 < w.
Proof. apply IZR_lt, Z.pow_pos_nonneg; lia. Qed.
End Halves.

Lemma same_length_halves a b : length a = length b ->
  length (fst (stretched 1 2 a)) = length (fst (stretched 1 2 b)) /\
  length (shifted (fst (stretched 1 2 a))) = length (shifted (fst (stretched 1 2 b))).
Proof. intro L; rewrite !length_shifted, !length_stretched; auto. Qed.

Section Quotient.
Variables a b : poly.
Hypothesis L : length a = length b.
Let f x := at_real a x / at_real b x.
Let a1 := fst (stretched 1 2 a).
Let b1 := fst (stretched 1 2 b).

Lemma quotient_left x : at_real b1 x <> 0 -> at_real a1 x / at_real b1 x = f (1 / 2 * x).
Proof.
  unfold a1, b1, f; rewrite !at_left, L; intro N; pose proof (half_factor b).
  field; split; [intro E; apply N; rewrite E; ring | lra].
Qed.

Lemma quotient_right x : at_real (shifted b1) x <> 0 ->
  at_real (shifted a1) x / at_real (shifted b1) x = f (1 / 2 * x + 1 / 2).
Proof.
  unfold a1, b1, f; rewrite !at_right, L; intro N; pose proof (half_factor b).
  field; split; [intro E; apply N; rewrite E; ring | lra].
Qed.

Lemma positive_left x : 0 < at_real b1 (2 * x) -> 0 < at_real b x.
Proof.
  unfold b1; rewrite at_left; replace (1 / 2 * (2 * x)) with x by field.
  pose proof (half_factor b) as W; intro P; apply (Rmult_lt_reg_l _ _ _ W); lra.
Qed.

Lemma positive_right x : 0 < at_real (shifted b1) (2 * x - 1) -> 0 < at_real b x.
Proof.
  unfold b1; rewrite at_right; replace (1 / 2 * (2 * x - 1) + 1 / 2) with x by field.
  pose proof (half_factor b) as W; intro P; apply (Rmult_lt_reg_l _ _ _ W); lra.
Qed.

Lemma integral_of_middle : (forall y, -1 <= y <= 1 -> 0 < at_real (shifted b1) y) ->
  RInt (fun y => at_real (shifted a1) y / at_real (shifted b1) y) (-1) 1 / 2 = RInt f 0 1.
Proof.
  intro P.
  assert (E : ex_RInt f 0 1).
  { apply quotient_integrable; [lra |].
    intros x X; apply Rgt_not_eq, positive_right, P; lra. }
  assert (E' : ex_RInt f (1 / 2 * -1 + 1 / 2) (1 / 2 * 1 + 1 / 2))
    by (replace (1 / 2 * -1 + 1 / 2) with 0 by field; replace (1 / 2 * 1 + 1 / 2) with 1 by field; exact E).
  pose proof (RInt_comp_lin f (1 / 2) (1 / 2) (-1) 1 E') as H.
  replace (1 / 2 * -1 + 1 / 2) with 0 in H by field; replace (1 / 2 * 1 + 1 / 2) with 1 in H by field.
  rewrite <- H.
  assert (I : is_RInt (fun y => at_real (shifted a1) y / at_real (shifted b1) y) (-1) 1
      (RInt (fun y => at_real (shifted a1) y / at_real (shifted b1) y) (-1) 1)).
  { apply (RInt_correct (V := R_CompleteNormedModule)), quotient_integrable; [lra |].
    intros y Y; apply Rgt_not_eq, P, Y. }
  apply (is_RInt_scal _ _ _ (1 / 2)) in I.
  symmetry; etransitivity; [apply (is_RInt_unique (V := R_CompleteNormedModule)); eapply is_RInt_ext; [| exact I] |].
  - intros y Y; rewrite Rmin_left, Rmax_right in Y by lra.
    unfold scal; simpl; unfold mult; simpl; rewrite quotient_right; [reflexivity |].
    apply Rgt_not_eq, P; lra.
  - unfold scal; simpl; unfold mult; simpl; field.
Qed.

Lemma integral_of_halves :
  (forall y, 0 <= y <= 1 -> 0 < at_real b1 y) -> (forall y, 0 <= y <= 1 -> 0 < at_real (shifted b1) y) ->
  RInt f 0 1 = (RInt (fun y => at_real a1 y / at_real b1 y) 0 1 +
    RInt (fun y => at_real (shifted a1) y / at_real (shifted b1) y) 0 1) / 2.
Proof.
  intros P Q.
  assert (E : ex_RInt f 0 (1 / 2)).
  { apply quotient_integrable; [lra |].
    intros x X; apply Rgt_not_eq, positive_left, P; lra. }
  assert (E' : ex_RInt f (1 / 2) 1).
  { apply quotient_integrable; [lra |].
    intros x X; apply Rgt_not_eq, positive_right, Q; lra. }
  rewrite <- (RInt_Chasles f 0 (1 / 2) 1 E E'); unfold plus; simpl.
  assert (H : forall F G c, (forall y, 0 < y < 1 -> G y = F (1 / 2 * y + c)) ->
      ex_RInt F c (1 / 2 + c) -> ex_RInt G 0 1 -> RInt F c (1 / 2 + c) = RInt G 0 1 / 2).
  { intros F G c FG EF EG.
    assert (EF' : ex_RInt F (1 / 2 * 0 + c) (1 / 2 * 1 + c))
      by (rewrite Rmult_0_r, Rmult_1_r, Rplus_0_l; exact EF).
    pose proof (RInt_comp_lin F (1 / 2) c 0 1 EF') as C.
    rewrite Rmult_0_r, Rmult_1_r, Rplus_0_l in C; rewrite <- C.
    apply (RInt_correct (V := R_CompleteNormedModule)), (is_RInt_scal _ _ _ (1 / 2)) in EG.
    etransitivity; [apply (is_RInt_unique (V := R_CompleteNormedModule)); eapply is_RInt_ext; [| exact EG] |].
    - intros y Y; rewrite Rmin_left, Rmax_right in Y by lra.
      unfold scal; simpl; unfold mult; simpl; rewrite FG by exact Y; reflexivity.
    - unfold scal; simpl; unfold mult; simpl; field. }
  pose proof (H f (fun y => at_real a1 y / at_real b1 y) 0) as H1.
  pose proof (H f (fun y => at_real (shifted a1) y / at_real (shifted b1) y) (1 / 2)) as H2.
  rewrite Rplus_0_r in H1; replace (1 / 2 + 1 / 2) with 1 in H2 by field.
  rewrite H1, H2; [field | | exact E' | | | exact E |].
  - intros y Y; apply quotient_right, Rgt_not_eq, Q; lra.
  - apply quotient_integrable; [lra |]; intros y Y; apply Rgt_not_eq, Q, Y.
  - intros y Y; rewrite Rplus_0_r; apply quotient_left, Rgt_not_eq, P; lra.
  - apply quotient_integrable; [lra |]; intros y Y; apply Rgt_not_eq, P, Y.
Qed.

Lemma positive_of_halves :
  (forall y, 0 <= y <= 1 -> 0 < at_real b1 y) -> (forall y, 0 <= y <= 1 -> 0 < at_real (shifted b1) y) ->
  forall x, 0 <= x <= 1 -> 0 < at_real b x.
Proof.
  intros P Q x X; destruct (Rle_dec x (1 / 2));
    [apply positive_left, P | apply positive_right, Q]; lra.
Qed.
End Quotient.

Theorem integral_sound depth terms unit : (0 < unit)%Z -> forall a b found,
  length a = length b -> integral depth terms unit a b = Some found ->
  (forall x, 0 <= x <= 1 -> 0 < at_real b x) /\
  encloses unit found (RInt (fun x => at_real a x / at_real b x) 0 1).
Proof.
  intro U; induction depth as [| depth IH]; intros a b found L H; cbn [integral] in H;
    (destruct (enclosed_mean _ _ _ _) as [found' |] eqn:M;
    [ injection H as <-; apply enclosed_mean_sound in M as [P E]; [| exact U];
      rewrite (integral_of_middle a b L P) in E; split; [| exact E];
      intros x X; apply positive_right, P; lra
    | try discriminate ]).
  destruct (integral _ _ _ _ _) as [[low high] |] eqn:H1 in H; [| discriminate].
  destruct (integral _ _ _ _ _) as [[low' high'] |] eqn:H2 in H; [| discriminate].
  injection H as <-.
  destruct (same_length_halves a b L) as [L1 L2].
  destruct (IH _ _ _ L1 H1) as [P1 [E1 E1']]; destruct (IH _ _ _ L2 H2) as [P2 [E2 E2']].
  split; [apply (positive_of_halves b); assumption |].
  rewrite (integral_of_halves a b L P1 P2); unfold encloses; cbn [fst snd] in *.
  pose proof (floor_bounds (low + low') 2 eq_refl) as F; pose proof (floor_bounds (high + high') 2 eq_refl) as G.
  rewrite plus_IZR in F, G |- *; lra.
Qed.

Theorem is_positive_sound depth : forall b, is_positive depth b = true ->
  forall x, 0 <= x <= 1 -> 0 < at_real b x.
Proof.
  assert (M : forall b b0 b', shifted (fst (stretched 1 2 b)) = b0 :: b' -> (size b' < b0)%Z ->
      forall x, 0 <= x <= 1 -> 0 < at_real b x).
  { intros b b0 b' E S x X; apply positive_right; rewrite E.
    apply Rlt_le_trans with (IZR (b0 - size b')); [apply IZR_lt; lia |].
    apply tail_positive; [exact S | lra]. }
  induction depth as [| depth IH]; intros b H; cbn [is_positive] in H;
    destruct (shifted _) as [| b0 b'] eqn:E; try discriminate;
    destruct (Z.ltb_spec (size b') b0) as [S |]; try exact (M b b0 b' E S); try discriminate.
  destruct (is_positive depth (fst (stretched 1 2 b))) eqn:H1 in H; [| discriminate]; rewrite <- E in H.
  apply positive_of_halves; [apply IH, H1 | apply IH, H].
Qed.
