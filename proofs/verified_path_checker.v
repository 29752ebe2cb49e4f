(* The checker of certificates of paths, proved right: if `accept_path p` computes to true, then `path_statement p`. *)
From Coq Require Import Reals ZArith QArith Qreals List Lra Lia Bool.
From Coquelicot Require Import Coquelicot.
Require Import rotation_minimizing polynomials quadrature certificate_statement path_statement verified_checker.
Import ListNotations.
Open Scope R_scope.

(* ---- How it is checked *)

(* At a joint conj(a) b = c + y j + z k, c <> 0, for the preimages without zeros: the rotation from the one frame to the
   other has an axis normal to e1. If they are not the same but for a factor there is a corner. *)
Definition at_end (A : curve) (t : Z) := (at_integer (iu A) t, at_integer (iv A) t, at_integer (ip A) t, at_integer (iq A) t).
Definition carried (a b : Z * Z * Z * Z) :=
  let '(x, y, z, w) := a in
  let '(k, l, m, n) := b in
  ((x * l + w * m =? y * k + z * n) && negb (x * k + y * l + z * m + w * n =? 0))%Z.
Definition smooth (a b : Z * Z * Z * Z) :=
  let '(x, y, z, w) := a in
  let '(k, l, m, n) := b in
  ((x * m + y * n =? z * k + w * l) && (x * n + z * l =? w * k + y * m))%Z.
Fixpoint value_at (a : list Q) (x : Q) : Q := match a with [] => 0 | c :: a => Qred (c + x * value_at a x) end%Q.
Definition same_side (a b : certificate) := negb (Qle_bool (value_at (multiplier a) 1 * value_at (multiplier b) 0) 0).
Definition joined (a b : certificate) :=
  let x := at_end (without_zeros a) 1 in
  let y := at_end (without_zeros b) 0 in
  carried x y && (smooth x y || same_side a b).
Fixpoint all_joined (l : list certificate) :=
  match l with a :: (b :: _) as l' => joined a b && all_joined l' | _ => true end.

(* Of segment c on: its angle at t, which is 0 or is claimed, and the sum so far, known to r, are what x says. *)
Definition claimed (c : certificate) (t : Q) : option claim :=
  if Qeq_bool t 0 then Some (Claim 0 0 0) else find (fun y => Qeq_bool (time y) t) (claims c).
Definition shows (c : certificate) (t sum r : Q) (x : claim) :=
  match claimed c t with
  | Some y =>
      let theta := Qred (sum + angle y) in
      let r := Qred (r + radius y) in
      in_unit t && Qle_bool (angle x - radius x) (theta - r) && Qle_bool (theta + r) (angle x + radius x)
  | None => false
  end%Q.
Fixpoint check_sum (l : list certificate) (t sum r : Q) (x : claim) :=
  match l with
  | [] => false
  | c :: l =>
      if shows c t sum r x then true
      else match claimed c 1 with
        | Some y => check_sum l (Qred (t - 1)) (Qred (sum + angle y)) (Qred (r + radius y)) x
        | None => false
        end
  end%Q.

(* The integral of a polynomial from 0 to 1; k is 1. *)
Fixpoint integral_of (k : positive) (a : list Q) : Q :=
  match a with [] => 0 | c :: a => Qred (c / inject_Z (Zpos k) + integral_of (Pos.succ k) a) end%Q.
Definition meets (c : certificate) (s t : Q * Q * Q) :=
  let '(x, y, z) := s in
  let '(u, v, w) := t in
  (Qeq_bool (x + integral_of 1 (cx' c)) u && Qeq_bool (y + integral_of 1 (cy' c)) v &&
  Qeq_bool (z + integral_of 1 (cz' c)) w)%Q.
Fixpoint all_meet (l : list certificate) (s : list (Q * Q * Q)) :=
  match l, s with
  | c :: l, p :: (q :: _) as s' => meets c p q && all_meet l s'
  | _, _ => true
  end.

Definition no_bend (c : certificate) := match bend c with None => true | Some _ => false end.
Definition accept_path (p : path_certificate) : bool :=
  forallb accept (segments p) && forallb no_bend (segments p) && all_joined (segments p) &&
  Nat.eqb (length (starts p)) (length (segments p)) && all_meet (segments p) (starts p) &&
  forallb (fun x => check_sum (segments p) (time x) 0 0 x) (path_claims p).

(* ---- The proof *)

Definition part_of (c : certificate) : part :=
  (reals (without_zeros c), reals (derived_curve (without_zeros c))).
Definition parts := map part_of.

Lemma value_at_real a x : Q2R (value_at a x) = value a (Q2R x).
Proof.
  induction a as [| c a IH]; cbn [value_at value]; [exact at_zero_time |].
  rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_plus, Q2R_mult, IH; reflexivity.
Qed.

Lemma same_side_sound a b : same_side a b = true -> value (multiplier a) 1 * value (multiplier b) 0 > 0.
Proof.
  unfold same_side; rewrite negb_true_iff; intro H.
  assert (~ Rle (Q2R (value_at (multiplier a) 1 * value_at (multiplier b) 0)) (Q2R 0)).
  { intro K; apply Rle_Qle in K; apply Qle_bool_iff in K; congruence. }
  rewrite Q2R_mult, !value_at_real, at_zero_time in *; rewrite Q2R_one in *; lra.
Qed.

Lemma accepted c : accept c = true -> statement_about c (fst (part_of c)) (snd (part_of c)).
Proof. exact (accept_within_sound _ c). Qed.

Lemma accepted_clear c : accept c = true -> forall t, 0 <= t <= 1 -> 0 < sigma (fst (part_of c) t).
Proof.
  intros H%accepted t T; destruct H as (A' & _ & _ & _ & k & n & _ & _ & _ & _ & E & _).
  destruct E as (_ & U & _); apply (U t T); unfold within, Rmin, Rmax; destruct (Rle_dec 0 t); lra.
Qed.

Lemma accepted_angles c : accept c = true -> no_bend c = true ->
  angles_statement (clear (fst (part_of c))) (part_rate (part_of c)) (claims c).
Proof.
  intros H%accepted N; destruct H as (A' & _ & _ & _ & k & n & _ & _ & _ & _ & _ & _ & B).
  unfold no_bend in N; destruct (bend c); [discriminate | exact B].
Qed.

(* With a positive sum of squares a multiple has the same frame. *)
Lemma multiple_frame k a : k <> 0 -> 0 < sigma a ->
  e1 (multiple k a) = e1 a /\ e2 (multiple k a) = e2 a /\ e3 (multiple k a) = e3 a.
Proof.
  intros K S; unfold e1, e2, e3; rewrite sigma_multiple, !rotated_multiple, !scale_scale.
  repeat split; f_equal; field; split; lra.
Qed.

(* Vectors in the frame of a: sums, products and least rotations may be taken before or after. *)
Definition turned a w := scale (/ sigma a) (rotated a w).

Ltac vectors := unfold turned, rotated, product, conjugate, least_rotation, turn2, turn3, e1, e2, e3 in *;
  cbv [add scale dot cross vx vy vz qu qv qp qq sigma] in *.

Lemma turned_add a x y : turned a (add x y) = add (turned a x) (turned a y).
Proof. vectors; f_equal; ring. Qed.
Lemma turned_scale a k x : turned a (scale k x) = scale k (turned a x).
Proof. vectors; f_equal; ring. Qed.
Lemma turned_cross a x y : sigma a <> 0 -> turned a (cross x y) = cross (turned a x) (turned a y).
Proof. intro N; vectors; f_equal; field; exact N. Qed.
Lemma turned_dot a x y : sigma a <> 0 -> dot (turned a x) (turned a y) = dot x y.
Proof. intro N; vectors; field; exact N. Qed.
Lemma turned_least a x y w : sigma a <> 0 ->
  turned a (least_rotation x y w) = least_rotation (turned a x) (turned a y) (turned a w).
Proof.
  intro N; unfold least_rotation.
  rewrite turned_dot, !turned_add, turned_scale, !turned_cross by exact N; reflexivity.
Qed.
Definition pure w := Quaternion 0 (vx w) (vy w) (vz w).
Lemma rotated_pure a w : pure (rotated a w) = product (product a (pure w)) (conjugate a).
Proof. unfold pure, rotated, product, conjugate; cbn [vx vy vz qu qv qp qq]; f_equal; ring. Qed.
Lemma product_associates a b c : product a (product b c) = product (product a b) c.
Proof. unfold product; cbn [qu qv qp qq]; f_equal; ring. Qed.
Lemma conjugate_product a b : conjugate (product a b) = product (conjugate b) (conjugate a).
Proof. unfold product, conjugate; cbn [qu qv qp qq]; f_equal; ring. Qed.
Lemma rotated_product a b w : rotated (product a b) w = rotated a (rotated b w).
Proof.
  assert (P : pure (rotated (product a b) w) = pure (rotated a (rotated b w))).
  { rewrite !rotated_pure, conjugate_product, !product_associates; reflexivity. }
  injection P as X Y Z; apply vector_eq; assumption.
Qed.
Lemma rotated_scale a k w : rotated a (scale k w) = scale k (rotated a w).
Proof. unfold rotated, product, conjugate, scale; cbn [vx vy vz qu qv qp qq]; f_equal; ring. Qed.
Lemma turned_product a b w : sigma a <> 0 -> sigma b <> 0 -> turned (product a b) w = turned a (turned b w).
Proof.
  intros N M; unfold turned; rewrite rotated_scale, scale_scale, rotated_product; f_equal.
  replace (sigma (product a b)) with (sigma a * sigma b) by (unfold sigma, product; cbn [qu qv qp qq]; ring).
  field; split; assumption.
Qed.

(* Of the frame of (1, 0, 0), (0, 1, 0), (0, 0, 1) itself. *)
Lemma least_of_axes c y z : c <> 0 ->
  let b := Quaternion c 0 y z in
  1 + dot (Vector 1 0 0) (e1 b) > 0 /\ least_rotation (Vector 1 0 0) (e1 b) (Vector 1 0 0) = e1 b /\
  least_rotation (Vector 1 0 0) (e1 b) (Vector 0 1 0) = e2 b /\ least_rotation (Vector 1 0 0) (e1 b) (Vector 0 0 1) = e3 b.
Proof.
  intros N b; pose proof (Rlt_0_sqr c N) as C; pose proof (Rle_0_sqr y) as Y; pose proof (Rle_0_sqr z) as Z.
  unfold Rsqr in C, Y, Z; assert (S : c * c + 0 * 0 + y * y + z * z <> 0) by lra.
  destruct (closed b) as (E1 & E2 & E3); rewrite E1, E2, E3; unfold b in *; clear E1 E2 E3 b.
  assert (D : 1 + dot (Vector 1 0 0) (c1 (Quaternion c 0 y z)) = 2 * (c * c) / (c * c + 0 * 0 + y * y + z * z)).
  { cbv [dot c1 sigma vx vy vz qu qv qp qq]; field; lra. }
  split.
  { rewrite D; apply Rdiv_lt_0_compat; lra. }
  unfold least_rotation; rewrite D; cbv [c1 c2 c3 dot add scale cross sigma vx vy vz qu qv qp qq].
  repeat split; f_equal; field; split; lra.
Qed.

Lemma least_frame a c y z : c <> 0 -> 0 < sigma a ->
  let b := product a (Quaternion c 0 y z) in
  1 + dot (e1 a) (e1 b) > 0 /\ least_rotation (e1 a) (e1 b) (e1 a) = e1 b /\
  least_rotation (e1 a) (e1 b) (e2 a) = e2 b /\ least_rotation (e1 a) (e1 b) (e3 a) = e3 b.
Proof.
  intros N S; cbv zeta; assert (M : sigma (Quaternion c 0 y z) <> 0).
  { pose proof (Rlt_0_sqr c N); pose proof (Rle_0_sqr y); pose proof (Rle_0_sqr z); unfold Rsqr in *; cbv [sigma qu qv qp qq]; lra. }
  assert (K : sigma a <> 0) by lra.
  destruct (least_of_axes c y z N) as (D & E1 & E2 & E3).
  assert (T : forall w, scale (/ sigma (product a (Quaternion c 0 y z))) (rotated (product a (Quaternion c 0 y z)) w) =
    turned a (turned (Quaternion c 0 y z) w)) by (intro w; exact (turned_product a _ w K M)).
  unfold e1, e2, e3; rewrite !T; fold (turned a (Vector 1 0 0)) (turned a (Vector 0 1 0)) (turned a (Vector 0 0 1)).
  rewrite turned_dot, <- !turned_least by exact K.
  split; [exact D |].
  exact (conj (f_equal (turned a) E1) (conj (f_equal (turned a) E2) (f_equal (turned a) E3))).
Qed.

Lemma joined_frame_of A B s t : 0 < sigma (reals A (IZR s)) -> 0 < sigma (reals B (IZR t)) ->
  carried (at_end A s) (at_end B t) = true ->
  let a := reals A (IZR s) in
  let b := reals B (IZR t) in
  1 + dot (e1 a) (e1 b) > 0 /\ least_rotation (e1 a) (e1 b) (e1 a) = e1 b /\
  least_rotation (e1 a) (e1 b) (e2 a) = e2 b /\ least_rotation (e1 a) (e1 b) (e3 a) = e3 b /\
  (smooth (at_end A s) (at_end B t) = true -> e1 a = e1 b).
Proof.
  intros SA SB H a b; unfold carried, smooth, at_end in *; rewrite andb_true_iff, Z.eqb_eq, negb_true_iff, Z.eqb_neq in H.
  destruct H as (I & N); rewrite andb_true_iff, !Z.eqb_eq.
  apply (f_equal IZR) in I; assert (N' : IZR (at_integer (iu A) s * at_integer (iu B) t + at_integer (iv A) s * at_integer (iv B) t
    + at_integer (ip A) s * at_integer (ip B) t + at_integer (iq A) s * at_integer (iq B) t) <> 0) by (apply not_0_IZR; exact N).
  rewrite !plus_IZR, !mult_IZR, !at_integer_real in I; rewrite !plus_IZR, !mult_IZR, !at_integer_real in N'.
  assert (L : forall x y, x = y -> IZR x = IZR y) by (intros x y ->; reflexivity).
  unfold a, b, reals in *; clear a b N.
  set (x := at_real (iu A) (IZR s)) in *; set (y := at_real (iv A) (IZR s)) in *.
  set (z := at_real (ip A) (IZR s)) in *; set (w := at_real (iq A) (IZR s)) in *.
  set (k := at_real (iu B) (IZR t)) in *; set (l := at_real (iv B) (IZR t)) in *.
  set (m := at_real (ip B) (IZR t)) in *; set (n := at_real (iq B) (IZR t)) in *.
  set (c := x * k + y * l + z * m + w * n) in *.
  set (j := x * m + y * n - z * k - w * l); set (i := x * n + z * l - w * k - y * m).
  set (r := sigma (Quaternion x y z w)) in *.
  (* r b is a (c + j j + i k), the part at i being 0. *)
  assert (M : Quaternion k l m n = multiple (/ r) (product (Quaternion x y z w) (Quaternion c 0 j i))).
  { assert (E : forall p q, p * r = q -> p = / r * q) by (intros p q <-; field; lra).
    assert (Z : forall f p q, p = q + f * ((x * l + w * m) - (y * k + z * n)) -> p = q) by (intros f p q ->; rewrite I; ring).
    unfold multiple, product; cbn [qu qv qp qq]; f_equal; apply E; unfold r, c, j, i, sigma; cbn [qu qv qp qq];
      [apply (Z (- y)) | apply (Z x) | apply (Z w) | apply (Z (- z))]; ring. }
  assert (P : 0 < sigma (product (Quaternion x y z w) (Quaternion c 0 j i))).
  { replace (sigma (product (Quaternion x y z w) (Quaternion c 0 j i))) with (r * (c * c + j * j + i * i))
      by (unfold r, product, sigma; cbn [qu qv qp qq]; ring).
    apply Rmult_lt_0_compat; [exact SA |].
    pose proof (Rlt_0_sqr c N'); pose proof (Rle_0_sqr j); pose proof (Rle_0_sqr i); unfold Rsqr in *; lra. }
  rewrite M; destruct (multiple_frame (/ r) _ (Rinv_neq_0_compat r ltac:(lra)) P) as (-> & -> & ->).
  destruct (least_frame (Quaternion x y z w) c j i N' SA) as (D & E1 & E2 & E3).
  repeat (split; [assumption |]); intros [J K].
  apply L in J, K; rewrite !plus_IZR, !mult_IZR, !at_integer_real in J, K.
  assert (j = 0) as -> by (unfold j; fold x y z w k l m n in J; lra).
  assert (i = 0) as -> by (unfold i; fold x y z w k l m n in K; lra).
  replace (product (Quaternion x y z w) (Quaternion c 0 0 0)) with (multiple c (Quaternion x y z w))
    by (unfold multiple, product; cbn [qu qv qp qq]; f_equal; ring).
  symmetry; apply multiple_frame; [exact N' | exact SA].
Qed.

Lemma joined_frame l : forallb accept l = true -> all_joined l = true -> forall n a b,
  nth_error (parts l) n = Some a -> nth_error (parts l) (S n) = Some b ->
  let carried := least_rotation (e1 (fst a 1)) (e1 (fst b 0)) in
  1 + dot (e1 (fst a 1)) (e1 (fst b 0)) > 0 /\ carried (e1 (fst a 1)) = e1 (fst b 0) /\
  carried (e2 (fst a 1)) = e2 (fst b 0) /\ carried (e3 (fst a 1)) = e3 (fst b 0) /\
  (forall c d, nth_error l n = Some c -> nth_error l (S n) = Some d ->
    e1 (fst a 1) = e1 (fst b 0) \/ value (multiplier c) 1 * value (multiplier d) 0 > 0).
Proof.
  induction l as [| c l IH]; [intros _ _ [| n]; discriminate |].
  cbn [forallb]; rewrite andb_true_iff; intros [C L] J [| n] a b HA HB.
  - destruct l as [| c' l]; [discriminate |].
    cbn in HA, HB; injection HA as <-; injection HB as <-.
    cbn [all_joined] in J; apply andb_true_iff in J as [J _].
    cbn [forallb] in L; apply andb_true_iff in L as [C' _].
    unfold joined in J; apply andb_true_iff in J as [J K].
    destruct (joined_frame_of (without_zeros c) (without_zeros c') 1 0) as (D & E1 & E2 & E3 & F);
      [apply (accepted_clear _ C); lra | apply (accepted_clear _ C'); lra | exact J |].
    repeat (split; [assumption |]); intros d d' G G'; injection G as <-; injection G' as <-.
    apply orb_true_iff in K as [K | K]; [left; exact (F K) | right; exact (same_side_sound _ _ K)].
  - apply (IH L) with (n := n); auto.
    destruct l as [| c' l]; [reflexivity |]; cbn [all_joined] in J; apply andb_true_iff in J as [_ J]; exact J.
Qed.

(* f2 and f3 are carried as e2 and e3 are. *)
Lemma least_turn a b x y t : let R := least_rotation a b in
  R (turn2 t x y) = turn2 t (R x) (R y) /\ R (turn3 t x y) = turn3 t (R x) (R y).
Proof.
  cbv zeta; unfold least_rotation, turn2, turn3; generalize (/ (1 + dot a b)) (cos t) (sin t); intros k c s.
  cbv [add scale cross vx vy vz]; split; f_equal; ring.
Qed.

Lemma angle_to_next l : forall n a, nth_error l n = Some a ->
  angle_to l (S n) = angle_to l n + RInt (part_rate a) 0 1.
Proof.
  induction l as [| b l IH]; intros [| n] a H; try discriminate.
  - injection H as ->; destruct l; cbn; ring.
  - cbn in H; specialize (IH n a H); change (RInt (part_rate b) 0 1 + angle_to l (S n) =
      RInt (part_rate b) 0 1 + angle_to l n + RInt (part_rate a) 0 1); rewrite IH; ring.
Qed.

Lemma claimed_sound c t y : accept c = true -> no_bend c = true -> claimed c t = Some y ->
  Rabs (RInt (part_rate (part_of c)) 0 (Q2R t) - Q2R (angle y)) <= Q2R (radius y).
Proof.
  unfold claimed; intros H N; destruct (Qeq_bool t 0) eqn:Z.
  - intro E; injection E as <-; apply Qeq_bool_eq, Qeq_eqR in Z; rewrite Z; cbn [angle radius].
    rewrite at_zero_time, RInt_point; unfold zero; simpl; rewrite Rminus_0_r, Rabs_R0; lra.
  - intro F; apply find_some in F as [I E]; apply Qeq_bool_eq, Qeq_eqR in E.
    rewrite <- E; exact (proj2 (accepted_angles c H N y I)).
Qed.

Lemma Qred_real q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma check_sum_sound x l : forallb accept l = true -> forallb no_bend l = true -> forall t sum r S,
  Rabs (S - Q2R sum) <= Q2R r -> check_sum l t sum r x = true ->
  exists n a s, nth_error (parts l) n = Some a /\ 0 <= s <= 1 /\ Q2R t = INR n + s /\
    Rabs (S + angle_at (parts l) n a s - Q2R (angle x)) <= Q2R (radius x).
Proof.
  induction l as [| c l IH]; [discriminate |].
  cbn [forallb]; rewrite !andb_true_iff; intros [H L] [N M] t sum r S B; cbn [check_sum].
  destruct (shows c t sum r x) eqn:E.
  - intros _; unfold shows in E; destruct (claimed c t) as [y |] eqn:C; [| discriminate].
    apply (claimed_sound c t y H N) in C.
    rewrite !andb_true_iff in E; destruct E as [[U V] W]; apply in_unit_real in U; apply Qle_real in V, W.
    rewrite !Q2R_minus, !Qred_real, !Q2R_plus in V; rewrite !Q2R_plus, !Qred_real, !Q2R_plus in W.
    exists O, (part_of c), (Q2R t); repeat split; try (simpl; lra).
    unfold angle_at; cbn [parts map angle_to].
    apply Rabs_le_between in B; apply Rabs_le_between in C; apply Rabs_le_between; lra.
  - destruct (claimed c 1) as [y |] eqn:C; [| discriminate]; intro K.
    apply (claimed_sound c 1 y H N) in C; rewrite Q2R_one in C.
    assert (B' : Rabs (S + RInt (part_rate (part_of c)) 0 1 - Q2R (Qred (sum + angle y))) <= Q2R (Qred (r + radius y))).
    { rewrite !Qred_real, !Q2R_plus; apply Rabs_le_between in B; apply Rabs_le_between in C; apply Rabs_le_between; lra. }
    destruct (IH L M _ _ _ _ B' K) as (n & a & s & P & Q & T & V).
    exists (Datatypes.S n), a, s; split; [exact P | split; [exact Q | split]].
    + rewrite Qred_real, Q2R_minus, Q2R_one in T; rewrite S_INR; lra.
    + unfold angle_at in *; cbn [parts map angle_to]; fold parts.
        replace (S + (RInt (part_rate (part_of c)) 0 1 + angle_to (parts l) n + RInt (part_rate a) 0 s) - Q2R (angle x))
          with (S + RInt (part_rate (part_of c)) 0 1 + (angle_to (parts l) n + RInt (part_rate a) 0 s) - Q2R (angle x))
          by ring; exact V.
Qed.

(* x^k V has the derivative x^(k - 1) a, where V has the coefficients of a over k, k + 1, ... *)
Fixpoint over_powers (k : positive) (a : list Q) (x : R) : R :=
  match a with [] => 0 | c :: a => Q2R c / IZR (Zpos k) + x * over_powers (Pos.succ k) a x end.

Lemma power_derivative k x : is_derive (fun x => x ^ S k) x (INR (S k) * x ^ k).
Proof.
  replace (INR (S k) * x ^ k) with (INR (S k) * 1 * x ^ Nat.pred (S k)) by (cbn [Nat.pred]; ring).
  apply (is_derive_pow (fun x => x) (S k) x 1); exact (is_derive_id (K := R_AbsRing) x).
Qed.

Lemma over_powers_derivative a : forall k n x, IZR (Zpos k) = INR (S n) ->
  is_derive (fun x => x ^ S n * over_powers k a x) x (x ^ n * value a x).
Proof.
  induction a as [| c a IH]; intros k n x E.
  - apply (is_derive_ext (fun _ => 0)); [intro; simpl; ring |].
    replace (x ^ n * value [] x) with 0 by (simpl; ring); apply @is_derive_const.
  - pose proof (positive_real k) as P.
    apply (is_derive_ext (fun x => Q2R c / IZR (Zpos k) * x ^ S n + x ^ S (S n) * over_powers (Pos.succ k) a x)).
    { intro t; simpl; ring. }
    replace (x ^ n * value (c :: a) x) with
      (Q2R c / IZR (Zpos k) * (INR (S n) * x ^ n) + x ^ S n * value a x)
      by (rewrite <- E; cbn [value pow]; field; lra).
    apply @is_derive_plus; [apply is_derive_scal, power_derivative |].
    apply IH; rewrite Pos2Z.inj_succ, succ_IZR, E, (S_INR (S n)); ring.
Qed.

Lemma integral_of_real a : forall k, Q2R (integral_of k a) = over_powers k a 1.
Proof.
  induction a as [| c a IH]; intro k; cbn [integral_of over_powers]; [exact at_zero_time |].
  rewrite Qred_real, Q2R_plus, IH, Q2R_div by (unfold Qeq; simpl; discriminate).
  replace (Q2R (inject_Z (Zpos k))) with (IZR (Zpos k)) by (unfold Q2R, inject_Z; simpl; field); ring.
Qed.

Lemma value_continuous a x : continuous (value a) x.
Proof.
  induction a as [| c a IH]; [apply continuous_const |].
  apply (continuous_plus (fun _ => Q2R c) (fun x => x * value a x)); [apply continuous_const |].
  apply (continuous_mult (fun x => x) (value a)); [apply continuous_id | exact IH].
Qed.

Lemma RInt_value a : RInt (value a) 0 1 = Q2R (integral_of 1 a).
Proof.
  rewrite integral_of_real; apply is_RInt_unique.
  replace (over_powers 1 a 1) with (minus (1 ^ 1 * over_powers 1 a 1) (0 ^ 1 * over_powers 1 a 0))
    by (unfold minus, plus, opp; simpl; ring).
  apply (is_RInt_derive (fun x => x ^ 1 * over_powers 1 a x)); intros x _; [| apply value_continuous].
  replace (value a x) with (x ^ 0 * value a x) by (simpl; ring); apply over_powers_derivative; reflexivity.
Qed.

Lemma meets_sound c s t : meets c s t = true -> end_of c s = real_vector t.
Proof.
  destruct s as [[x y] z], t as [[u v] w]; unfold meets, end_of; rewrite !andb_true_iff, !RInt_value.
  intros [[X Y] Z]; apply Qeq_bool_eq, Qeq_eqR in X, Y, Z; rewrite Q2R_plus in X, Y, Z.
  apply vector_eq; assumption.
Qed.

Lemma all_meet_sound l : forall s, all_meet l s = true -> forall n c p q, nth_error l n = Some c ->
  nth_error s n = Some p -> nth_error s (S n) = Some q -> end_of c p = real_vector q.
Proof.
  induction l as [| d l IH]; intros [| r s] H [| n] c p q C P Q; try discriminate.
  - destruct s as [| t s]; [discriminate |]; injection C as <-; injection P as <-; injection Q as <-.
    cbn [all_meet] in H; apply andb_true_iff in H as [H _]; exact (meets_sound _ _ _ H).
  - destruct s as [| t s]; [destruct n; discriminate |].
    cbn [all_meet] in H; apply andb_true_iff in H as [_ H]; exact (IH (t :: s) H n c p q C P Q).
Qed.

Theorem accept_path_sound p : accept_path p = true -> path_statement p.
Proof.
  unfold accept_path; rewrite !andb_true_iff; intros [[[[[H N] J] LEN] M] C].
  exists (parts (segments p)); split; [| split; [apply Nat.eqb_eq, LEN | split; [exact (all_meet_sound _ _ M) |]]];
    [| split; [| split; [| split]]].
  - clear N J C LEN M; induction (segments p) as [| c l IH]; [constructor |].
    cbn [forallb] in H; apply andb_true_iff in H as [Hc Hl].
    constructor; [exact (accepted c Hc) | exact (IH Hl)].
  - intros n a E; apply nth_error_In, in_map_iff in E as E'; destruct E' as (c & <- & I).
    rewrite forallb_forall in H; specialize (H c I); pose proof (accepted_clear c H) as P.
    split; [apply clear_on_unit, P |].
    refine (proj1 (proj2 (proj2 (frame_by_theta (clear (fst (part_of c))) (fst (part_of c)) (snd (part_of c))
      (angle_to (parts (segments p)) n) _ _ _ _ _)))); intros; try apply reals_derivative; try apply reals_continuous.
    + exact (clear_interval _ _ (reals_derivative (without_zeros c))).
    + apply clear_on_unit; [exact P | lra].
    + match goal with X : clear _ ?t |- _ => exact (X t (at_itself t)) end.
  - intros n a b HA HB; destruct (joined_frame _ H J n a b HA HB) as (D & E1 & E2 & E3 & _).
    unfold path_f2, path_f3, angle_at; cbv zeta.
    destruct (least_turn (e1 (fst a 1)) (e1 (fst b 0)) (e2 (fst a 1)) (e3 (fst a 1))
      (angle_to (parts (segments p)) n + RInt (part_rate a) 0 1)) as (-> & ->).
    rewrite (angle_to_next _ n a HA), RInt_point, E2, E3; unfold zero; simpl; rewrite Rplus_0_r; auto.
  - intros n c d a b HC HD HA HB; destruct (joined_frame _ H J n a b HA HB) as (_ & _ & _ & _ & K); exact (K c d HC HD).
  - intros x I; rewrite forallb_forall in C; specialize (C x I).
    assert (B : Rabs (0 - Q2R 0) <= Q2R 0) by (rewrite at_zero_time, Rminus_0_r, Rabs_R0; lra).
    destruct (check_sum_sound x _ H N _ _ _ _ B C) as (n & a & s & P & Q & T & V).
    exists n, a, s; rewrite Rplus_0_l in V; auto.
Qed.

Print Assumptions accept_path_sound.
