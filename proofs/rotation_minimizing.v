(* For every preimage A = u + v i + p j + q k without a zero, the frame that phrame computes is rotation-minimizing: the
   derivatives of f2 and f3 are parallel to the tangent; and but for a constant turn there is no other one.

   Quaternions and vectors come first, with what is said of them; then the frames; then the proofs. The notation is that
   of docs/algorithms.md. Farouki, Exact rotation-minimizing frames for spatial Pythagorean-hodograph curves (2003), has
   theta' = -2h/sigma in other words.

   What phrame proves of single curves is made of this: docs/proofs.md. *)
From Coq Require Import Reals Lra Nsatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* ---- Vectors *)

Record vector := Vector { vx : R; vy : R; vz : R }.

Definition add a b := Vector (vx a + vx b) (vy a + vy b) (vz a + vz b).
Definition scale k a := Vector (k * vx a) (k * vy a) (k * vz a).
Definition dot a b := vx a * vx b + vy a * vy b + vz a * vz b.
Definition cross a b := Vector
  (vy a * vz b - vz a * vy b) (vz a * vx b - vx a * vz b) (vx a * vy b - vy a * vx b).

(* Unit vectors, orthogonal, the third of them the product of the others. *)
Definition right_handed a b c :=
  dot a a = 1 /\ dot b b = 1 /\ dot c c = 1 /\
  dot a b = 0 /\ dot b c = 0 /\ dot c a = 0 /\ cross a b = c.

(* x and y turned by the angle a, from x to y. *)
Definition turn2 a x y := add (scale (cos a) x) (scale (sin a) y).
Definition turn3 a x y := add (scale (- sin a) x) (scale (cos a) y).

(* F' is the derivative of F at t. *)
Definition derivative (F : R -> vector) (t : R) (F' : vector) :=
  is_derive (fun s => vx (F s)) t (vx F') /\
  is_derive (fun s => vy (F s)) t (vy F') /\
  is_derive (fun s => vz (F s)) t (vz F').

(* D is an open interval. *)
Definition open_interval (D : R -> Prop) :=
  (forall t, D t -> locally t D) /\
  (forall a b t, D a -> D b -> a <= t <= b -> D t).

(* e, f, g are right-handed, and f', g' are parallel to e. *)
Definition rotation_minimizing (D : R -> Prop) (e f g : R -> vector) :=
  forall t, D t ->
    right_handed (e t) (f t) (g t) /\
    (exists k, derivative f t (scale k (e t))) /\
    (exists k, derivative g t (scale k (e t))).

(* ---- Quaternions u + v i + p j + q k *)

Record quaternion := Quaternion { qu : R; qv : R; qp : R; qq : R }.

Definition product a b := Quaternion
  (qu a * qu b - qv a * qv b - qp a * qp b - qq a * qq b)
  (qu a * qv b + qv a * qu b + qp a * qq b - qq a * qp b)
  (qu a * qp b - qv a * qq b + qp a * qu b + qq a * qv b)
  (qu a * qq b + qv a * qp b - qp a * qv b + qq a * qu b).
Definition conjugate a := Quaternion (qu a) (- qv a) (- qp a) (- qq a).
(* a w a*, which has no real part. *)
Definition rotated a w :=
  let b := product (product a (Quaternion 0 (vx w) (vy w) (vz w))) (conjugate a) in
  Vector (qv b) (qp b) (qq b).

Definition quaternion_derivative (A : R -> quaternion) (t : R) (A' : quaternion) :=
  is_derive (fun s => qu (A s)) t (qu A') /\ is_derive (fun s => qv (A s)) t (qv A') /\
  is_derive (fun s => qp (A s)) t (qp A') /\ is_derive (fun s => qq (A s)) t (qq A').
Definition quaternion_continuous (A : R -> quaternion) (t : R) :=
  continuous (fun s => qu (A s)) t /\ continuous (fun s => qv (A s)) t /\
  continuous (fun s => qp (A s)) t /\ continuous (fun s => qq (A s)) t.

(* h and g = alpha beta' - alpha' beta, alpha = u + i v, beta = q + i p, take the derivative a' of a. *)
Definition sigma a := qu a * qu a + qv a * qv a + qp a * qp a + qq a * qq a.
Definition h a a' := qu a * qv a' - qu a' * qv a - qp a * qq a' + qp a' * qq a.
Definition g_re a a' := qu a * qq a' - qv a * qp a' - qu a' * qq a + qv a' * qp a.
Definition g_im a a' := qu a * qp a' + qv a * qq a' - qu a' * qp a - qv a' * qq a.

(* The Euler-Rodrigues frame. *)
Definition e1 a := scale (/ sigma a) (rotated a (Vector 1 0 0)).
Definition e2 a := scale (/ sigma a) (rotated a (Vector 0 1 0)).
Definition e3 a := scale (/ sigma a) (rotated a (Vector 0 0 1)).

(* ---- The Frenet frame *)

Definition g_squared a a' := g_re a a' * g_re a a' + g_im a a' * g_im a a'.
Definition g_abs a a' := sqrt (g_squared a a').
Definition normal a a' :=
  scale (/ g_abs a a') (add (scale (g_re a a') (e2 a)) (scale (- g_im a a') (e3 a))).
Definition binormal a a' :=
  scale (/ g_abs a a') (add (scale (g_im a a') (e2 a)) (scale (g_re a a') (e3 a))).
(* -2h/sigma + Im(g'/g). *)
Definition frenet_rate a a' a'' :=
  -2 * h a a' / sigma a + (g_re a a' * g_im a a'' - g_im a a' * g_re a a'') / g_squared a a'.

(* ---- How the Euler-Rodrigues frame turns *)

Lemma vector_eq a b : vx a = vx b -> vy a = vy b -> vz a = vz b -> a = b.
Proof. destruct a, b; simpl; intros -> -> ->; reflexivity. Qed.

Lemma derivative_ext F G t F' G' :
  (forall s, F s = G s) -> F' = G' -> derivative F t F' -> derivative G t G'.
Proof.
  intros E <- (Hx & Hy & Hz).
  split; [| split]; eapply is_derive_ext; try eassumption; intro s; simpl; now rewrite E.
Qed.

(* e1, e2, e3 by u, v, p, q. *)
Definition c1 a := Vector
  ((qu a * qu a + qv a * qv a - qp a * qp a - qq a * qq a) / sigma a)
  (2 * (qu a * qq a + qv a * qp a) / sigma a) (2 * (qv a * qq a - qu a * qp a) / sigma a).
Definition c2 a := Vector
  (2 * (qv a * qp a - qu a * qq a) / sigma a)
  ((qu a * qu a - qv a * qv a + qp a * qp a - qq a * qq a) / sigma a)
  (2 * (qu a * qv a + qp a * qq a) / sigma a).
Definition c3 a := Vector
  (2 * (qu a * qp a + qv a * qq a) / sigma a) (2 * (qp a * qq a - qu a * qv a) / sigma a)
  ((qu a * qu a - qv a * qv a - qp a * qp a + qq a * qq a) / sigma a).

Lemma closed a : e1 a = c1 a /\ e2 a = c2 a /\ e3 a = c3 a.
Proof. repeat split; apply vector_eq; simpl; unfold Rdiv; ring. Qed.

Section Turning.
Variables u v p q : R -> R.
Variables t u' v' p' q' : R.
Hypothesis du : is_derive u t u'.
Hypothesis dv : is_derive v t v'.
Hypothesis dp : is_derive p t p'.
Hypothesis dq : is_derive q t q'.
Let A s := Quaternion (u s) (v s) (p s) (q s).
Let A' := Quaternion u' v' p' q'.
Hypothesis N : sigma (A t) <> 0.

Ltac component :=
  cbv [A A' c1 c2 c3 scale add sigma h g_re g_im vx vy vz qu qv qp qq] in *;
  auto_derive;
  [ repeat apply conj; first [ exact I | exact N | eexists; eassumption ]
  | change (fun x : R => u x) with u; change (fun x : R => v x) with v;
    change (fun x : R => p x) with p; change (fun x : R => q x) with q;
    rewrite (is_derive_unique _ _ _ du), (is_derive_unique _ _ _ dv),
      (is_derive_unique _ _ _ dp), (is_derive_unique _ _ _ dq); field; exact N ].

Lemma components_turn :
  derivative (fun s => c1 (A s)) t (scale (2 / sigma (A t))
    (add (scale (g_re (A t) A') (c2 (A t))) (scale (- g_im (A t) A') (c3 (A t))))) /\
  derivative (fun s => c2 (A s)) t (scale (2 / sigma (A t))
    (add (scale (h (A t) A') (c3 (A t))) (scale (- g_re (A t) A') (c1 (A t))))) /\
  derivative (fun s => c3 (A s)) t (scale (2 / sigma (A t))
    (add (scale (g_im (A t) A') (c1 (A t))) (scale (- h (A t) A') (c2 (A t))))).
Proof. split; [| split]; (split; [| split]); component. Qed.

End Turning.

(* How the Euler-Rodrigues frame turns. *)
Theorem frame_turns A t A' :
  quaternion_derivative A t A' -> sigma (A t) <> 0 ->
  derivative (fun s => e1 (A s)) t (scale (2 / sigma (A t))
    (add (scale (g_re (A t) A') (e2 (A t))) (scale (- g_im (A t) A') (e3 (A t))))) /\
  derivative (fun s => e2 (A s)) t (scale (2 / sigma (A t))
    (add (scale (h (A t) A') (e3 (A t))) (scale (- g_re (A t) A') (e1 (A t))))) /\
  derivative (fun s => e3 (A s)) t (scale (2 / sigma (A t))
    (add (scale (g_im (A t) A') (e1 (A t))) (scale (- h (A t) A') (e2 (A t))))).
Proof.
  intros (Hu & Hv & Hp & Hq) N.
  destruct (closed (A t)) as (E1 & E2 & E3).
  assert (N' : sigma (Quaternion (qu (A t)) (qv (A t)) (qp (A t)) (qq (A t))) <> 0) by exact N.
  destruct (components_turn _ _ _ _ _ _ _ _ _ Hu Hv Hp Hq N') as (T1 & T2 & T3).
  split; [| split].
  - refine (derivative_ext _ _ _ _ _ (fun s => eq_sym (proj1 (closed (A s)))) _ T1).
    rewrite E2, E3; destruct A'; reflexivity.
  - refine (derivative_ext _ _ _ _ _ (fun s => eq_sym (proj1 (proj2 (closed (A s))))) _ T2).
    rewrite E1, E3; destruct A'; reflexivity.
  - refine (derivative_ext _ _ _ _ _ (fun s => eq_sym (proj2 (proj2 (closed (A s))))) _ T3).
    rewrite E1, E2; destruct A'; reflexivity.
Qed.

Theorem frame_right_handed a : sigma a <> 0 -> right_handed (e1 a) (e2 a) (e3 a).
Proof.
  intro N; destruct (closed a) as (-> & -> & ->); unfold sigma in N.
  repeat split; unfold dot, cross; try apply vector_eq; simpl; unfold sigma; field; exact N.
Qed.

Lemma turn_right_handed e f g c s :
  right_handed e f g -> c * c + s * s = 1 ->
  right_handed e (add (scale c f) (scale s g)) (add (scale (- s) f) (scale c g)).
Proof.
  destruct e, f, g; unfold right_handed, dot, cross, add, scale; simpl.
  intros (H1 & H2 & H3 & H4 & H5 & H6 & H7) H; injection H7; clear H7; intros.
  repeat split; try apply vector_eq; simpl; nsatz.
Qed.

(* ---- The derivatives of combinations *)

Lemma is_derive_eq (F : R -> R) (t a b : R) : is_derive F t a -> a = b -> is_derive F t b.
Proof. intros H <-; exact H. Qed.

Lemma is_derive_same (F G : R -> R) (t l : R) :
  (forall s, F s = G s) -> is_derive F t l -> is_derive G t l.
Proof. intros E H; exact (is_derive_ext F G t l E H). Qed.

Lemma derivative_combination c s F G t c' s' F' G' :
  is_derive c t c' -> is_derive s t s' -> derivative F t F' -> derivative G t G' ->
  derivative (fun x => add (scale (c x) (F x)) (scale (s x) (G x))) t
    (add (add (scale c' (F t)) (scale (c t) F')) (add (scale s' (G t)) (scale (s t) G'))).
Proof.
  intros Hc Hs (Fx & Fy & Fz) (Gx & Gy & Gz).
  split; [| split]; simpl;
    apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule));
    apply (is_derive_mult (K := R_AbsRing)); auto using Rmult_comm.
Qed.

Lemma derivative_dot F G t F' G' :
  derivative F t F' -> derivative G t G' ->
  is_derive (fun x => dot (F x) (G x)) t (dot F' (G t) + dot (F t) G').
Proof.
  intros (Fx & Fy & Fz) (Gx & Gy & Gz).
  pose proof (is_derive_plus _ _ _ _ _ (is_derive_plus _ _ _ _ _
    (is_derive_mult _ _ t _ _ Fx Gx Rmult_comm) (is_derive_mult _ _ t _ _ Fy Gy Rmult_comm))
    (is_derive_mult _ _ t _ _ Fz Gz Rmult_comm)) as H.
  apply (is_derive_eq _ _ _ _ H); unfold plus, mult, dot; simpl; ring.
Qed.

(* A pair (c, s) that turns at the rate -2h/sigma. *)
Lemma combination_is_rotation_minimizing A t A' c s :
  quaternion_derivative A t A' -> sigma (A t) <> 0 ->
  is_derive c t (- (-2 * h (A t) A' / sigma (A t)) * s t) ->
  is_derive s t (-2 * h (A t) A' / sigma (A t) * c t) ->
  exists k, derivative (fun x => add (scale (c x) (e2 (A x))) (scale (s x) (e3 (A x)))) t
    (scale k (e1 (A t))).
Proof.
  intros HA N Hc Hs.
  destruct (frame_turns A t A' HA N) as (_ & T2 & T3).
  exists (2 / sigma (A t) * (g_im (A t) A' * s t - g_re (A t) A' * c t)).
  refine (derivative_ext _ _ _ _ _ (fun s => eq_refl) _
    (derivative_combination _ _ _ _ _ _ _ _ _ Hc Hs T2 T3)).
  apply vector_eq; simpl; field; exact N.
Qed.

(* ---- Uniqueness *)

Lemma in_basis e f g v :
  right_handed e f g -> dot v e = 0 -> v = add (scale (dot v f) f) (scale (dot v g) g).
Proof.
  intros (E1 & E2 & E3 & E4 & _ & _ & <-) H.
  assert (I : scale (dot (cross e f) (cross e f)) v =
    add (scale (dot v (cross e f)) (cross e f))
      (add (scale (- dot v e) (add (scale (dot e f) f) (scale (- dot f f) e)))
           (scale (dot v f) (add (scale (dot e e) f) (scale (- dot e f) e)))))
    by (apply vector_eq; unfold dot, cross, add, scale; simpl; ring).
  rewrite E1, E2, E3, E4, H in I.
  apply (f_equal vx) in I as Ix; apply (f_equal vy) in I as Iy; apply (f_equal vz) in I as Iz.
  unfold add, scale in *; simpl in *.
  apply vector_eq; simpl; lra.
Qed.

Lemma cross_turned e f g c s :
  right_handed e f g ->
  cross e (add (scale c f) (scale s g)) = add (scale (- s) f) (scale c g).
Proof.
  intros (E1 & _ & _ & E4 & _ & _ & <-).
  assert (I : cross e (add (scale c f) (scale s (cross e f))) =
    add (scale s (add (scale (dot e f) e) (scale (- dot e e) f))) (scale c (cross e f)))
    by (apply vector_eq; unfold dot, cross, add, scale; simpl; ring).
  rewrite I, E1, E4; apply vector_eq; unfold add, scale; simpl; ring.
Qed.

Lemma constant_on D (F : R -> R) :
  open_interval D -> (forall t, D t -> is_derive F t 0) -> forall a b, D a -> D b -> F a = F b.
Proof.
  intros [_ Dc] H.
  assert (L : forall a b, D a -> D b -> a < b -> F a = F b).
  { intros a b Ha Hb Hab; apply (eq_is_derive F a b); [| exact Hab].
    intros t Ht; apply H, (Dc a b); assumption. }
  intros a b Ha Hb; destruct (Rtotal_order a b) as [Hl | [-> | Hg]];
    [| reflexivity | symmetry]; apply L; assumption.
Qed.

Lemma angle_of c s : c * c + s * s = 1 -> exists a, cos a = c /\ sin a = s.
Proof.
  intro H.
  assert (B : -1 <= c <= 1) by (split; nra).
  assert (S : 1 - c² = s²) by (unfold Rsqr; lra).
  destruct (Rle_dec 0 s) as [P | P].
  - exists (acos c); rewrite cos_acos, sin_acos, S, sqrt_Rsqr by assumption; auto.
  - exists (- acos c); rewrite cos_neg, sin_neg, cos_acos, sin_acos, S, Rsqr_neg by assumption.
    rewrite sqrt_Rsqr by lra; split; [reflexivity | ring].
Qed.

(* Two rotation-minimizing frames with the same tangent differ by a constant turn. *)
Theorem unique_but_for_a_turn D t0 e f2 f3 g2 g3 :
  open_interval D -> D t0 ->
  rotation_minimizing D e f2 f3 -> rotation_minimizing D e g2 g3 ->
  exists a, forall t, D t -> g2 t = turn2 a (f2 t) (f3 t) /\ g3 t = turn3 a (f2 t) (f3 t).
Proof.
  intros HD H0 Hf Hg.
  assert (K : forall F G, (forall t, D t -> dot (F t) (e t) = 0 /\ dot (e t) (G t) = 0 /\
      (exists k, derivative F t (scale k (e t))) /\ (exists k, derivative G t (scale k (e t)))) ->
      forall t, D t -> dot (F t) (G t) = dot (F t0) (G t0)).
  { intros F G H t Ht; apply (constant_on D (fun t => dot (F t) (G t)) HD); try assumption.
    intros x Hx; destruct (H x Hx) as (A & B & (k & Hk) & (l & Hl)).
    apply (is_derive_eq _ _ _ _ (derivative_dot _ _ _ _ _ Hk Hl)).
    transitivity (k * dot (e x) (G x) + l * dot (F x) (e x));
      [unfold dot, scale; simpl; ring | rewrite A, B; ring]. }
  assert (C : forall t, D t -> dot (g2 t) (f2 t) = dot (g2 t0) (f2 t0)).
  { apply K; intros t Ht.
    destruct (Hf t Ht) as ((_ & _ & _ & E & _) & F & _).
    destruct (Hg t Ht) as ((_ & _ & _ & E' & _) & F' & _).
    repeat split; try assumption; rewrite <- E'; unfold dot; ring. }
  assert (S : forall t, D t -> dot (g2 t) (f3 t) = dot (g2 t0) (f3 t0)).
  { apply K; intros t Ht.
    destruct (Hf t Ht) as ((_ & _ & _ & _ & _ & E & _) & _ & F).
    destruct (Hg t Ht) as ((_ & _ & _ & E' & _) & F' & _).
    repeat split; try assumption; [rewrite <- E' | rewrite <- E]; unfold dot; ring. }
  assert (B : forall t, D t -> g2 t =
      add (scale (dot (g2 t0) (f2 t0)) (f2 t)) (scale (dot (g2 t0) (f3 t0)) (f3 t))).
  { intros t Ht; rewrite <- (C t Ht), <- (S t Ht).
    destruct (Hf t Ht) as (R & _); destruct (Hg t Ht) as ((_ & _ & _ & E & _) & _).
    apply (in_basis (e t)); [exact R | rewrite <- E; unfold dot; ring]. }
  destruct (angle_of (dot (g2 t0) (f2 t0)) (dot (g2 t0) (f3 t0))) as (a & Ca & Sa).
  { destruct (Hf t0 H0) as (R & _); destruct (Hg t0 H0) as ((_ & U & _) & _).
    pose proof (B t0 H0) as I; destruct R as (_ & U1 & U2 & _ & O & _ & _).
    apply (f_equal (dot (g2 t0))) in I; rewrite U in I.
    rewrite I; unfold dot, add, scale; simpl; ring. }
  rewrite <- Ca, <- Sa in B; exists a; intros t Ht; split; [exact (B t Ht) |].
  destruct (Hf t Ht) as (R & _); destruct (Hg t Ht) as ((_ & _ & _ & _ & _ & _ & <-) & _).
  rewrite (B t Ht); exact (cross_turned _ _ _ _ _ R).
Qed.

(* ---- The angle to the Euler-Rodrigues frame *)

Section Angle.

Variable D : R -> Prop.
Variables A A' : R -> quaternion.
Hypothesis A_derivative : forall t, D t -> quaternion_derivative A t (A' t).
Hypothesis sigma_positive : forall t, D t -> 0 < sigma (A t).

Lemma sigma_nonzero t : D t -> sigma (A t) <> 0.
Proof. intro Ht; apply Rgt_not_eq, sigma_positive, Ht. Qed.

(* (c, s) on the unit circle that turns at the rate -2h/sigma. *)
Lemma pair_is_rotation_minimizing c s :
  (forall t, D t -> c t * c t + s t * s t = 1 /\
    is_derive c t (- (-2 * h (A t) (A' t) / sigma (A t)) * s t) /\
    is_derive s t (-2 * h (A t) (A' t) / sigma (A t) * c t)) ->
  rotation_minimizing D (fun t => e1 (A t))
    (fun t => add (scale (c t) (e2 (A t))) (scale (s t) (e3 (A t))))
    (fun t => add (scale (- s t) (e2 (A t))) (scale (c t) (e3 (A t)))).
Proof.
  intros H t Ht; destruct (H t Ht) as (U & Hc & Hs); split; [| split].
  - apply turn_right_handed; [apply frame_right_handed, sigma_nonzero, Ht | exact U].
  - apply combination_is_rotation_minimizing with (A' t); auto using sigma_nonzero.
  - apply (combination_is_rotation_minimizing A t (A' t) (fun x => - s x) c);
      auto using sigma_nonzero.
    + apply (is_derive_eq _ _ _ _ (is_derive_opp _ _ _ Hs)); unfold opp; simpl; ring.
    + apply (is_derive_eq _ _ _ _ Hc); ring.
Qed.

Variable theta : R -> R.
Hypothesis theta_rate :
  forall t, D t -> is_derive theta t (-2 * h (A t) (A' t) / sigma (A t)).

Lemma cos_sin_of (psi : R -> R) t w :
  is_derive psi t w ->
  is_derive (fun x => cos (psi x)) t (- w * sin (psi t)) /\
  is_derive (fun x => sin (psi x)) t (w * cos (psi t)).
Proof.
  intro H; split; auto_derive;
    first [ eexists; exact H
          | change (fun x : R => psi x) with psi; rewrite (is_derive_unique _ _ _ H); ring ].
Qed.

Theorem turned_by_theta_is_rotation_minimizing :
  rotation_minimizing D (fun t => e1 (A t))
    (fun t => turn2 (theta t) (e2 (A t)) (e3 (A t)))
    (fun t => turn3 (theta t) (e2 (A t)) (e3 (A t))).
Proof.
  apply (pair_is_rotation_minimizing (fun t => cos (theta t)) (fun t => sin (theta t))).
  intros t Ht; split.
  - pose proof (sin2_cos2 (theta t)) as H; unfold Rsqr in H; lra.
  - exact (cos_sin_of theta t _ (theta_rate t Ht)).
Qed.

End Angle.

(* ---- The angle to the Frenet frame *)

(* If psi turns at the rate w + Im(g'/g), g = a + i b, then e^(i psi) conj(g)/|g| turns at the rate w. *)
Section Pair.

Variables a b psi : R -> R.
Variables t a' b' w : R.
Hypothesis a_derivative : is_derive a t a'.
Hypothesis b_derivative : is_derive b t b'.
Hypothesis nonzero : 0 < a t * a t + b t * b t.
Hypothesis psi_derivative :
  is_derive psi t (w + (a t * b' - b t * a') / (a t * a t + b t * b t)).

Let size x := sqrt (a x * a x + b x * b x).
Definition pair_c x := (cos (psi x) * a x + sin (psi x) * b x) / size x.
Definition pair_s x := (sin (psi x) * a x - cos (psi x) * b x) / size x.

Ltac known := change (fun x : R => a x) with a; change (fun x : R => b x) with b;
  change (fun x : R => psi x) with psi;
  rewrite (is_derive_unique _ _ _ a_derivative), (is_derive_unique _ _ _ b_derivative).

Lemma size_positive : 0 < size t.
Proof. apply sqrt_lt_R0, nonzero. Qed.

Lemma size_squared : size t ^ 2 = a t * a t + b t * b t.
Proof. simpl; rewrite Rmult_1_r; apply sqrt_sqrt, Rlt_le, nonzero. Qed.

Lemma size_rate : is_derive size t ((a t * a' + b t * b') / size t).
Proof.
  unfold size; auto_derive.
  - repeat apply conj; first [ exact I | eexists; eassumption | exact nonzero ].
  - known; field; apply Rgt_not_eq, size_positive.
Qed.

Lemma pair_turns :
  pair_c t * pair_c t + pair_s t * pair_s t = 1 /\
  is_derive pair_c t (- w * pair_s t) /\ is_derive pair_s t (w * pair_c t).
Proof.
  pose proof size_rate as Hs; pose proof size_positive as P; pose proof size_squared as Q.
  pose proof (sin2_cos2 (psi t)) as H; unfold Rsqr in H.
  revert Hs P Q; unfold pair_c, pair_s; generalize size; intros S Hs P Q.
  split; [| split].
  - field_simplify_eq; [| lra]; rewrite Q.
    replace (sin (psi t) ^ 2) with (1 - cos (psi t) * cos (psi t)) by lra; ring.
  - auto_derive;
      [ repeat apply conj; first [ exact I | eexists; eassumption | apply Rgt_not_eq, P ] |].
    known; change (fun x : R => S x) with S.
    rewrite (is_derive_unique _ _ _ Hs), (is_derive_unique _ _ _ psi_derivative), <- Q.
    field_simplify_eq; [| lra].
    replace (S t ^ 2) with (a t * a t + b t * b t) by (symmetry; exact Q); ring.
  - auto_derive;
      [ repeat apply conj; first [ exact I | eexists; eassumption | apply Rgt_not_eq, P ] |].
    known; change (fun x : R => S x) with S.
    rewrite (is_derive_unique _ _ _ Hs), (is_derive_unique _ _ _ psi_derivative), <- Q.
    field_simplify_eq; [| lra].
    replace (S t ^ 2) with (a t * a t + b t * b t) by (symmetry; exact Q); ring.
Qed.

End Pair.

Section Frenet.

Variable D : R -> Prop.
Variables A A' A'' : R -> quaternion.
Hypothesis A_derivative : forall t, D t -> quaternion_derivative A t (A' t).
Hypothesis A'_derivative : forall t, D t -> quaternion_derivative A' t (A'' t).
Hypothesis sigma_positive : forall t, D t -> 0 < sigma (A t).
Hypothesis no_inflection : forall t, D t -> 0 < g_squared (A t) (A' t).

Lemma g_abs_positive t : D t -> 0 < g_abs (A t) (A' t).
Proof. intro Ht; apply sqrt_lt_R0, no_inflection, Ht. Qed.

Lemma g_abs_squared t : D t ->
  g_abs (A t) (A' t) * g_abs (A t) (A' t) = g_squared (A t) (A' t).
Proof. intro Ht; apply sqrt_sqrt, Rlt_le, no_inflection, Ht. Qed.

(* The normal is where the tangent turns to. *)
Theorem frenet_frame t : D t ->
  derivative (fun s => e1 (A s)) t
    (scale (2 * g_abs (A t) (A' t) / sigma (A t)) (normal (A t) (A' t))) /\
  right_handed (e1 (A t)) (normal (A t) (A' t)) (binormal (A t) (A' t)).
Proof.
  intro Ht.
  pose proof (Rgt_not_eq _ _ (g_abs_positive t Ht)) as P.
  pose proof (Rgt_not_eq _ _ (sigma_positive t Ht)) as N.
  split.
  - destruct (frame_turns A t (A' t) (A_derivative t Ht) N) as (T & _).
    refine (derivative_ext _ _ _ _ _ (fun s => eq_refl) _ T).
    apply vector_eq; unfold normal, add, scale; simpl; field; auto.
  - pose proof (turn_right_handed _ _ _ (g_re (A t) (A' t) / g_abs (A t) (A' t))
      (- g_im (A t) (A' t) / g_abs (A t) (A' t)) (frame_right_handed (A t) N)) as H.
    replace (normal (A t) (A' t)) with
      (add (scale (g_re (A t) (A' t) / g_abs (A t) (A' t)) (e2 (A t)))
           (scale (- g_im (A t) (A' t) / g_abs (A t) (A' t)) (e3 (A t))))
      by (apply vector_eq; unfold normal, add, scale; simpl; field; auto).
    replace (binormal (A t) (A' t)) with
      (add (scale (- (- g_im (A t) (A' t) / g_abs (A t) (A' t))) (e2 (A t)))
           (scale (g_re (A t) (A' t) / g_abs (A t) (A' t)) (e3 (A t))))
      by (apply vector_eq; unfold binormal, add, scale; simpl; field; auto).
    apply H; field_simplify_eq; [| exact P].
    replace (g_abs (A t) (A' t) ^ 2) with (g_squared (A t) (A' t))
      by (rewrite <- g_abs_squared by exact Ht; ring).
    unfold g_squared; ring.
Qed.

(* g' = alpha beta'' - alpha'' beta. *)
Lemma g_derivative t : D t ->
  is_derive (fun s => g_re (A s) (A' s)) t (g_re (A t) (A'' t)) /\
  is_derive (fun s => g_im (A s) (A' s)) t (g_im (A t) (A'' t)).
Proof.
  intro Ht.
  destruct (A_derivative t Ht) as (Hu & Hv & Hp & Hq).
  destruct (A'_derivative t Ht) as (Ku & Kv & Kp & Kq).
  assert (M : forall F G F' G', is_derive F t F' -> is_derive G t G' ->
    is_derive (fun s => F s * G s) t (F' * G t + F t * G')).
  { intros F G F' G' HF HG; exact (is_derive_mult _ _ t _ _ HF HG Rmult_comm). }
  assert (S : forall (a b c d : R -> R) a' b' c' d',
    is_derive a t a' -> is_derive b t b' -> is_derive c t c' -> is_derive d t d' ->
    is_derive (fun s => a s + b s - c s - d s) t (a' + b' - c' - d')).
  { intros a b c d a' b' c' d' Ha Hb Hc Hd.
    exact (is_derive_minus _ _ _ _ _ (is_derive_minus _ _ _ _ _
      (is_derive_plus _ _ _ _ _ Ha Hb) Hc) Hd). }
  split.
  - apply (is_derive_same (fun s => qu (A s) * qq (A' s) + qv (A' s) * qp (A s) -
      qv (A s) * qp (A' s) - qu (A' s) * qq (A s))); [intro s; unfold g_re; ring |].
    apply (is_derive_eq _ _ _ _ (S _ _ _ _ _ _ _ _ (M _ _ _ _ Hu Kq) (M _ _ _ _ Kv Hp)
      (M _ _ _ _ Hv Kp) (M _ _ _ _ Ku Hq))); unfold g_re; ring.
  - apply (is_derive_same (fun s => qu (A s) * qp (A' s) + qv (A s) * qq (A' s) -
      qu (A' s) * qp (A s) - qv (A' s) * qq (A s))); [intro s; unfold g_im; ring |].
    apply (is_derive_eq _ _ _ _ (S _ _ _ _ _ _ _ _ (M _ _ _ _ Hu Kp) (M _ _ _ _ Hv Kq)
      (M _ _ _ _ Ku Hp) (M _ _ _ _ Kv Hq))); unfold g_im; ring.
Qed.

Variable psi : R -> R.
Hypothesis psi_rate : forall t, D t -> is_derive psi t (frenet_rate (A t) (A' t) (A'' t)).


Theorem turned_by_psi_is_rotation_minimizing :
  rotation_minimizing D (fun t => e1 (A t))
    (fun t => turn2 (psi t) (normal (A t) (A' t)) (binormal (A t) (A' t)))
    (fun t => turn3 (psi t) (normal (A t) (A' t)) (binormal (A t) (A' t))).
Proof.
  pose (c := pair_c (fun t => g_re (A t) (A' t)) (fun t => g_im (A t) (A' t)) psi).
  pose (s := pair_s (fun t => g_re (A t) (A' t)) (fun t => g_im (A t) (A' t)) psi).
  assert (H2 : forall t, add (scale (c t) (e2 (A t))) (scale (s t) (e3 (A t))) =
    turn2 (psi t) (normal (A t) (A' t)) (binormal (A t) (A' t)))
    by (intro t; apply vector_eq; unfold turn2, normal, binormal, add, scale, c, s, pair_c,
        pair_s, g_abs, g_squared, Rdiv; simpl; ring).
  assert (H3 : forall t, add (scale (- s t) (e2 (A t))) (scale (c t) (e3 (A t))) =
    turn3 (psi t) (normal (A t) (A' t)) (binormal (A t) (A' t)))
    by (intro t; apply vector_eq; unfold turn3, normal, binormal, add, scale, c, s, pair_c,
        pair_s, g_abs, g_squared, Rdiv; simpl; ring).
  assert (T : forall t, D t -> c t * c t + s t * s t = 1 /\
    is_derive c t (- (-2 * h (A t) (A' t) / sigma (A t)) * s t) /\
    is_derive s t (-2 * h (A t) (A' t) / sigma (A t) * c t)).
  { intros t Ht; destruct (g_derivative t Ht) as (Ha & Hb).
    exact (pair_turns _ _ psi t _ _ _ Ha Hb (no_inflection t Ht) (psi_rate t Ht)). }
  intros t Ht.
  destruct (pair_is_rotation_minimizing D A A' A_derivative sigma_positive c s T t Ht)
    as (R & (k & K) & (l & L)).
  rewrite H2, H3 in R; split; [exact R | split].
  - exists k; exact (derivative_ext _ _ _ _ _ H2 eq_refl K).
  - exists l; exact (derivative_ext _ _ _ _ _ H3 eq_refl L).
Qed.

End Frenet.

(* ---- The frame of a curve *)

(* Where its theorem holds. *)
Lemma everywhere : open_interval (fun _ => True).
Proof. split; [intros; apply filter_true | auto]. Qed.

Lemma between lo hi : open_interval (fun t => lo < t < hi).
Proof.
  split; [| intros; lra].
  intros t Ht; apply (open_and _ _ (open_gt lo) (open_lt hi) t Ht).
Qed.

(* The integral exists and has the derivative that it should have. *)
Lemma angle_exists D (w : R -> R) start :
  open_interval D -> D 0 -> (forall t, D t -> continuous w t) ->
  start + RInt w 0 0 = start /\
  forall t, D t -> is_derive (fun x => start + RInt w 0 x) t (w t).
Proof.
  intros [Do Dc] D0 Hw; split.
  { rewrite RInt_point; unfold zero; simpl; ring. }
  intros t Ht.
  assert (H : is_derive (fun x => RInt w 0 x) t (w t)).
  2: { apply (is_derive_eq _ _ _ _ (is_derive_plus _ _ t _ _ (is_derive_const start t) H)).
       unfold plus, zero; simpl; ring. }
  apply (is_derive_RInt w _ 0 t); [| exact (Hw t Ht)].
  apply (filter_imp D); [| exact (Do t Ht)].
  intros x Hx; apply (RInt_correct (V := R_CompleteNormedModule)).
  apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
  intros y Hy; apply Hw; unfold Rmin, Rmax in Hy.
  destruct (Rle_dec 0 x); [apply (Dc 0 x) | apply (Dc x 0)]; auto.
Qed.

(* Where cofactors make 1 of u, v, p, q, these have no common zero. *)
Lemma positive_by_cofactors a b : qu (product (conjugate b) a) = 1 -> 0 < sigma a.
Proof.
  destruct a as [u v p q], b; unfold sigma; simpl; intro H.
  assert (P : forall x, 0 <= x * x) by (intro; apply Rle_0_sqr).
  pose proof (P u); pose proof (P v); pose proof (P p); pose proof (P q).
  apply Rnot_le_lt; intro Z.
  assert (E : forall x, x * x = 0 -> x = 0) by (intros x Hx; destruct (Rmult_integral _ _ Hx); auto).
  rewrite (E u), (E v), (E p), (E q) in H by lra; lra.
Qed.

Lemma positive_by_two_cofactors a b c d : c * a + d * b = 1 -> 0 < a * a + b * b.
Proof.
  intro H; pose proof (Rle_0_sqr a) as A; pose proof (Rle_0_sqr b) as B; unfold Rsqr in A, B.
  apply Rnot_le_lt; intro Z.
  assert (E : forall x, x * x = 0 -> x = 0) by (intros x Hx; destruct (Rmult_integral _ _ Hx); auto).
  rewrite (E a), (E b) in H by lra; lra.
Qed.

(* A fraction in lower terms. *)
Lemma lower_terms a b n d k : 0 < b -> a = n * k -> b = d * k -> a / b = n / d.
Proof. intros P -> ->; field; split; intros ->; lra. Qed.

Lemma angle_of_same_rate D (w w' : R -> R) start t : open_interval D -> D 0 -> D t ->
  (forall s, D s -> w s = w' s) -> start + RInt w 0 t = start + RInt w' 0 t.
Proof.
  intros [_ Dc] D0 Dt E; f_equal; apply RInt_ext; intros s Hs; apply E.
  unfold Rmin, Rmax in Hs; destruct (Rle_dec 0 t); [apply (Dc 0 t) | apply (Dc t 0)]; auto; lra.
Qed.

(* r' = f A i A*. *)
Lemma tangent_of_curve (r : R -> vector) (f : R -> R) A t : 0 < sigma (A t) ->
  derivative r t (scale (f t) (rotated (A t) (Vector 1 0 0))) ->
  derivative r t (scale (f t * sigma (A t)) (e1 (A t))).
Proof.
  intro P; apply derivative_ext; [reflexivity |].
  apply vector_eq; unfold e1, scale; simpl; field; lra.
Qed.

(* -2h/sigma and the rate of the angle to the Frenet frame are continuous. *)
Section Continuity.
Variable t : R.
Lemma continuous_plus_R (F G : R -> R) :
  continuous F t -> continuous G t -> continuous (fun s => F s + G s) t.
Proof. exact (continuous_plus F G t). Qed.
Lemma continuous_minus_R (F G : R -> R) :
  continuous F t -> continuous G t -> continuous (fun s => F s - G s) t.
Proof. exact (continuous_minus F G t). Qed.
Lemma continuous_mult_R (F G : R -> R) :
  continuous F t -> continuous G t -> continuous (fun s => F s * G s) t.
Proof. exact (continuous_mult F G t). Qed.
Lemma continuous_over_R (F G : R -> R) :
  continuous F t -> continuous G t -> 0 < G t -> continuous (fun s => F s / G s) t.
Proof.
  intros HF HG P; apply continuous_mult_R; [exact HF |].
  apply continuous_Rinv_comp; [exact HG | lra].
Qed.
Lemma continuous_const_R (c : R) : continuous (fun _ => c) t.
Proof. apply continuous_const. Qed.
End Continuity.
Ltac continuity :=
  repeat match goal with
  | H : continuous ?F ?t |- continuous ?F ?t => exact H
  | |- continuous (fun s => @?F s / @?G s) ?t => apply (continuous_over_R t F G); [| | assumption]
  | |- continuous (fun s => @?F s + @?G s) ?t => apply (continuous_plus_R t F G)
  | |- continuous (fun s => @?F s - @?G s) ?t => apply (continuous_minus_R t F G)
  | |- continuous (fun s => @?F s * @?G s) ?t => apply (continuous_mult_R t F G)
  | |- continuous (fun s => ?c) ?t => apply (continuous_const_R t c)
  end.

Lemma continuous_derivative A t A' : quaternion_derivative A t A' -> quaternion_continuous A t.
Proof.
  intros (Hu & Hv & Hp & Hq).
  split; [| split; [| split]];
    (eapply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)); eexists; eassumption).
Qed.

Lemma rate_continuous A A' t : quaternion_continuous A t -> quaternion_continuous A' t ->
  0 < sigma (A t) -> continuous (fun s => -2 * h (A s) (A' s) / sigma (A s)) t.
Proof.
  intros (Hu & Hv & Hp & Hq) (Ku & Kv & Kp & Kq) P; unfold h, sigma in *; continuity.
Qed.

Lemma frenet_rate_continuous A A' A'' t :
  quaternion_continuous A t -> quaternion_continuous A' t -> quaternion_continuous A'' t ->
  0 < sigma (A t) -> 0 < g_squared (A t) (A' t) ->
  continuous (fun s => frenet_rate (A s) (A' s) (A'' s)) t.
Proof.
  intros (Hu & Hv & Hp & Hq) (Ku & Kv & Kp & Kq) (Lu & Lv & Lp & Lq) P Q.
  unfold frenet_rate, g_squared, g_re, g_im, h, sigma in *; continuity.
Qed.

(* Of polynomials: what their derivatives are, and that they are continuous. *)
Ltac components :=
  unfold quaternion_derivative, quaternion_continuous, derivative, rotated, product, conjugate, scale;
  cbv beta iota zeta delta [qu qv qp qq vx vy vz];
  repeat match goal with |- _ /\ _ => split end.
Ltac differentiate :=
  components; (auto_derive; [repeat split; lra | try field; repeat split; lra]).
Ltac continuous_polynomials :=
  components; (apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule));
    auto_derive; exact I).

Section Curve.

Variable D : R -> Prop.
Variables A A' A'' : R -> quaternion.
Variable start : R.
Hypothesis D_interval : open_interval D.
Hypothesis D_zero : D 0.
Hypothesis A_derivative : forall t, D t -> quaternion_derivative A t (A' t).
Hypothesis sigma_positive : forall t, D t -> 0 < sigma (A t).

Section Theta.

Hypothesis A'_continuous : forall t, D t -> quaternion_continuous A' t.

(* The Euler-Rodrigues frame turned by theta, theta(0) = start, theta' = -2h/sigma. *)
Theorem frame_by_theta (theta := fun t => start + RInt (fun s => -2 * h (A s) (A' s) / sigma (A s)) 0 t)
    (f2 := fun t => turn2 (theta t) (e2 (A t)) (e3 (A t)))
    (f3 := fun t => turn3 (theta t) (e2 (A t)) (e3 (A t))) :
  theta 0 = start /\
  (forall t, D t -> is_derive theta t (-2 * h (A t) (A' t) / sigma (A t))) /\
  rotation_minimizing D (fun t => e1 (A t)) f2 f3 /\
  (forall g2 g3, rotation_minimizing D (fun t => e1 (A t)) g2 g3 ->
    exists a, forall t, D t -> g2 t = turn2 a (f2 t) (f3 t) /\ g3 t = turn3 a (f2 t) (f3 t)).
Proof.
  destruct (angle_exists D (fun s => -2 * h (A s) (A' s) / sigma (A s)) start D_interval D_zero)
    as (H0 & Hr).
  { intros t Ht; apply rate_continuous; auto.
    exact (continuous_derivative _ _ _ (A_derivative t Ht)). }
  pose proof (turned_by_theta_is_rotation_minimizing D A A' A_derivative sigma_positive theta Hr)
    as Hf.
  split; [exact H0 | split; [exact Hr | split; [exact Hf |]]].
  intros g2 g3 Hg; exact (unique_but_for_a_turn D 0 _ _ _ _ _ D_interval D_zero Hf Hg).
Qed.

End Theta.

Hypothesis A'_derivative : forall t, D t -> quaternion_derivative A' t (A'' t).
Hypothesis A''_continuous : forall t, D t -> quaternion_continuous A'' t.
Hypothesis no_inflection : forall t, D t -> 0 < g_squared (A t) (A' t).

(* The Frenet frame turned by psi, psi(0) = start, psi' = -2h/sigma + Im(g'/g). *)
Theorem frame_by_psi (psi := fun t => start + RInt (fun s => frenet_rate (A s) (A' s) (A'' s)) 0 t)
    (f2 := fun t => turn2 (psi t) (normal (A t) (A' t)) (binormal (A t) (A' t)))
    (f3 := fun t => turn3 (psi t) (normal (A t) (A' t)) (binormal (A t) (A' t))) :
  psi 0 = start /\
  (forall t, D t -> is_derive psi t (frenet_rate (A t) (A' t) (A'' t))) /\
  rotation_minimizing D (fun t => e1 (A t)) f2 f3 /\
  (forall g2 g3, rotation_minimizing D (fun t => e1 (A t)) g2 g3 ->
    exists a, forall t, D t -> g2 t = turn2 a (f2 t) (f3 t) /\ g3 t = turn3 a (f2 t) (f3 t)).
Proof.
  destruct (angle_exists D (fun s => frenet_rate (A s) (A' s) (A'' s)) start D_interval D_zero)
    as (H0 & Hr).
  { intros t Ht; apply frenet_rate_continuous; auto.
    - exact (continuous_derivative _ _ _ (A_derivative t Ht)).
    - exact (continuous_derivative _ _ _ (A'_derivative t Ht)). }
  pose proof (turned_by_psi_is_rotation_minimizing D A A' A'' A_derivative A'_derivative
    sigma_positive no_inflection psi Hr) as Hf.
  split; [exact H0 | split; [exact Hr | split; [exact Hf |]]].
  intros g2 g3 Hg; exact (unique_but_for_a_turn D 0 _ _ _ _ _ D_interval D_zero Hf Hg).
Qed.

End Curve.

Print Assumptions frame_by_theta.
Print Assumptions frame_by_psi.
