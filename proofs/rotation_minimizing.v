(* For every differentiable preimage A = u + v i + p j + q k without a zero, the frame that phrame computes is
   rotation-minimizing: the derivatives of f2 and f3 are parallel to the tangent.

   The vectors are the columns of the rotation that A means, e1 = A i A*/sigma and so on, in the notation of
   docs/algorithms.md: sigma = |A|^2, h = u v' - u' v - p q' + p' q, g = alpha beta' - alpha' beta with alpha = u + i v and
   beta = q + i p. Farouki, Exact rotation-minimizing frames for spatial Pythagorean-hodograph curves (2003), has
   theta' = -2h/sigma in other words. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Section Frame.

Variables u v p q : R -> R.
Hypothesis du : forall t, ex_derive u t.
Hypothesis dv : forall t, ex_derive v t.
Hypothesis dp : forall t, ex_derive p t.
Hypothesis dq : forall t, ex_derive q t.

Definition sigma t := u t * u t + v t * v t + p t * p t + q t * q t.
Hypothesis sigma_nonzero : forall t, sigma t <> 0.

Definition h t := u t * Derive v t - Derive u t * v t - p t * Derive q t + Derive p t * q t.

(* g = (u + i v)(q' + i p') - (u' + i v')(q + i p). *)
Definition g_re t := u t * Derive q t - v t * Derive p t - Derive u t * q t + Derive v t * p t.
Definition g_im t := u t * Derive p t + v t * Derive q t - Derive u t * p t - Derive v t * q t.

Definition e1x t := (u t * u t + v t * v t - p t * p t - q t * q t) / sigma t.
Definition e1y t := 2 * (u t * q t + v t * p t) / sigma t.
Definition e1z t := 2 * (v t * q t - u t * p t) / sigma t.
Definition e2x t := 2 * (v t * p t - u t * q t) / sigma t.
Definition e2y t := (u t * u t - v t * v t + p t * p t - q t * q t) / sigma t.
Definition e2z t := 2 * (u t * v t + p t * q t) / sigma t.
Definition e3x t := 2 * (u t * p t + v t * q t) / sigma t.
Definition e3y t := 2 * (p t * q t - u t * v t) / sigma t.
Definition e3z t := (u t * u t - v t * v t - p t * p t + q t * q t) / sigma t.

Ltac differentiable :=
  repeat apply conj;
  first [ exact I | apply du | apply dv | apply dp | apply dq | apply sigma_nonzero ].

Ltac differentiate :=
  unfold e1x, e1y, e1z, e2x, e2y, e2z, e3x, e3y, e3z, sigma;
  auto_derive;
  [ differentiable
  | change (fun x : R => u x) with u; change (fun x : R => v x) with v;
    change (fun x : R => p x) with p; change (fun x : R => q x) with q;
    unfold h, g_re, g_im; field; apply sigma_nonzero ].

(* How the Euler-Rodrigues frame turns. *)
Lemma e1_turns t :
  is_derive e1x t (2 / sigma t * (g_re t * e2x t - g_im t * e3x t)) /\
  is_derive e1y t (2 / sigma t * (g_re t * e2y t - g_im t * e3y t)) /\
  is_derive e1z t (2 / sigma t * (g_re t * e2z t - g_im t * e3z t)).
Proof. split; [| split]; differentiate. Qed.

Lemma e2_turns t :
  is_derive e2x t (2 / sigma t * (h t * e3x t - g_re t * e1x t)) /\
  is_derive e2y t (2 / sigma t * (h t * e3y t - g_re t * e1y t)) /\
  is_derive e2z t (2 / sigma t * (h t * e3z t - g_re t * e1z t)).
Proof. split; [| split]; differentiate. Qed.

Lemma e3_turns t :
  is_derive e3x t (2 / sigma t * (g_im t * e1x t - h t * e2x t)) /\
  is_derive e3y t (2 / sigma t * (g_im t * e1y t - h t * e2y t)) /\
  is_derive e3z t (2 / sigma t * (g_im t * e1z t - h t * e2z t)).
Proof. split; [| split]; differentiate. Qed.

(* cos theta a + sin theta b, where theta turns at the rate w. *)
Lemma turned_derivative (theta a b : R -> R) (t w a' b' l : R) :
  is_derive theta t w -> is_derive a t a' -> is_derive b t b' ->
  cos (theta t) * (a' + w * b t) + sin (theta t) * (b' - w * a t) = l ->
  is_derive (fun x => cos (theta x) * a x + sin (theta x) * b x) t l.
Proof.
  intros Hw Ha Hb <-.
  auto_derive.
  - repeat apply conj;
      first [ exact I | exists w; exact Hw | exists a'; exact Ha | exists b'; exact Hb ].
  - change (fun x : R => theta x) with theta; change (fun x : R => a x) with a;
      change (fun x : R => b x) with b.
    rewrite (is_derive_unique _ _ _ Hw), (is_derive_unique _ _ _ Ha), (is_derive_unique _ _ _ Hb).
    ring.
Qed.

Section Angle.

Variable theta : R -> R.
Hypothesis theta_rate : forall t, is_derive theta t (- 2 * h t / sigma t).

(* The Euler-Rodrigues frame turned by theta. *)
Definition f2x t := cos (theta t) * e2x t + sin (theta t) * e3x t.
Definition f2y t := cos (theta t) * e2y t + sin (theta t) * e3y t.
Definition f2z t := cos (theta t) * e2z t + sin (theta t) * e3z t.
Definition f3x t := cos (theta t) * e3x t + sin (theta t) * - e2x t.
Definition f3y t := cos (theta t) * e3y t + sin (theta t) * - e2y t.
Definition f3z t := cos (theta t) * e3z t + sin (theta t) * - e2z t.

(* f2' is parallel to e1, and so is f3': the frame is rotation-minimizing. *)
Theorem f2_is_rotation_minimizing t :
  exists c, is_derive f2x t (c * e1x t) /\ is_derive f2y t (c * e1y t) /\
            is_derive f2z t (c * e1z t).
Proof.
  exists (2 / sigma t * (g_im t * sin (theta t) - g_re t * cos (theta t))).
  destruct (e2_turns t) as [Ax [Ay Az]].
  destruct (e3_turns t) as [Bx [By Bz]].
  split; [| split].
  - apply (turned_derivative _ _ _ _ _ _ _ _ (theta_rate t) Ax Bx); field; apply sigma_nonzero.
  - apply (turned_derivative _ _ _ _ _ _ _ _ (theta_rate t) Ay By); field; apply sigma_nonzero.
  - apply (turned_derivative _ _ _ _ _ _ _ _ (theta_rate t) Az Bz); field; apply sigma_nonzero.
Qed.

Theorem f3_is_rotation_minimizing t :
  exists c, is_derive f3x t (c * e1x t) /\ is_derive f3y t (c * e1y t) /\
            is_derive f3z t (c * e1z t).
Proof.
  exists (2 / sigma t * (g_im t * cos (theta t) + g_re t * sin (theta t))).
  destruct (e2_turns t) as [Ax [Ay Az]].
  destruct (e3_turns t) as [Bx [By Bz]].
  pose proof (is_derive_opp _ _ _ Ax) as Nx.
  pose proof (is_derive_opp _ _ _ Ay) as Ny.
  pose proof (is_derive_opp _ _ _ Az) as Nz.
  unfold opp in Nx, Ny, Nz; simpl in Nx, Ny, Nz.
  split; [| split].
  - apply (turned_derivative _ _ _ _ _ _ _ _ (theta_rate t) Bx Nx); field; apply sigma_nonzero.
  - apply (turned_derivative _ _ _ _ _ _ _ _ (theta_rate t) By Ny); field; apply sigma_nonzero.
  - apply (turned_derivative _ _ _ _ _ _ _ _ (theta_rate t) Bz Nz); field; apply sigma_nonzero.
Qed.

End Angle.

(* The angle from (n, b), where n = (Re g e2 - Im g e3)/|g|, b = (Im g e2 + Re g e3)/|g|. If psi turns at the rate
   -2h/sigma + Im(g'/g), then cos psi n + sin psi b = c e2 + s e3, and (c, s) turns at the rate -2h/sigma: it is
   the frame of the theorem above. Here g = a + i b may be any function without a zero. *)
Section Frenet.

Variables psi a b : R -> R.
Hypothesis da : forall t, ex_derive a t.
Hypothesis db : forall t, ex_derive b t.
Hypothesis g_nonzero : forall t, 0 < a t * a t + b t * b t.

Definition argument_rate t :=
  (a t * Derive b t - b t * Derive a t) / (a t * a t + b t * b t).  (* Im(g'/g) *)

Hypothesis psi_rate :
  forall t, is_derive psi t (- 2 * h t / sigma t + argument_rate t).

Definition size t := sqrt (a t * a t + b t * b t).
Definition c t := (cos (psi t) * a t + sin (psi t) * b t) / size t.
Definition s t := (sin (psi t) * a t - cos (psi t) * b t) / size t.

Lemma size_positive t : 0 < size t.
Proof. apply sqrt_lt_R0, g_nonzero. Qed.

Lemma size_squared t : size t * size t = a t * a t + b t * b t.
Proof. apply sqrt_sqrt, Rlt_le, g_nonzero. Qed.

(* cos psi n + sin psi b, in the Euler-Rodrigues frame. *)
Lemma from_normal t (e2 e3 : R) :
  cos (psi t) * ((a t * e2 - b t * e3) / size t) + sin (psi t) * ((b t * e2 + a t * e3) / size t) =
  c t * e2 + s t * e3.
Proof. unfold c, s; field; apply Rgt_not_eq, size_positive. Qed.

Lemma size_rate t :
  is_derive size t ((a t * Derive a t + b t * Derive b t) / size t).
Proof.
  unfold size; auto_derive.
  - repeat apply conj; first [ exact I | apply da | apply db | apply g_nonzero ].
  - change (fun x : R => a x) with a; change (fun x : R => b x) with b.
    field; apply Rgt_not_eq, sqrt_lt_R0, g_nonzero.
Qed.

Ltac quotient t :=
  pose proof (size_rate t) as Hs; pose proof (psi_rate t) as Hp;
  pose proof (size_positive t) as P; pose proof (size_squared t) as Q;
  auto_derive;
  [ repeat apply conj;
    first [ exact I | apply da | apply db
          | eexists; exact Hs | eexists; exact Hp | apply Rgt_not_eq, P ]
  | change (fun x : R => a x) with a; change (fun x : R => b x) with b;
    change (fun x : R => psi x) with psi; change (fun x : R => size x) with size;
    rewrite (is_derive_unique _ _ _ Hs), (is_derive_unique _ _ _ Hp);
    unfold argument_rate; rewrite <- Q ].

Theorem frenet_angle t :
  is_derive c t (- (- 2 * h t / sigma t) * s t) /\ is_derive s t (- 2 * h t / sigma t * c t).
Proof.
  split; unfold c, s; quotient t;
    (field_simplify_eq;
     [ replace (size t ^ 2) with (a t * a t + b t * b t) by (rewrite <- Q; ring); ring
     | split; [ apply Rgt_not_eq, P | apply sigma_nonzero ] ]).
Qed.

End Frenet.

End Frame.

Print Assumptions f2_is_rotation_minimizing.
Print Assumptions f3_is_rotation_minimizing.
Print Assumptions frenet_angle.
