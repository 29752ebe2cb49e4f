(* A checker of certificates (docs/certificate.md) that is proved right: if `accept c` computes to true, then what the
   certificate c says of its curve, of the rotation-minimizing frame and of its angles is true of real numbers:
   `statement c` of certificate_statement.v. First how it is checked; then the proof. *)
From Coq Require Import Reals ZArith QArith Qreals List Lra Lia Bool.
From Coquelicot Require Import Coquelicot.
Require Import rotation_minimizing polynomials quadrature certificate_statement.
Import ListNotations.
Open Scope R_scope.

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

(* The angle of the rate n/d, which is all there is to integrate unless it is 0, and the polynomials l, which are to be
   positive where it is claimed. Intervals are halved at most `depth` times, one inside another. *)
Definition positive_to (depth : nat) (t : Q) (a : poly) :=
  is_positive depth (fst (stretched (Qnum t) (Zpos (Qden t)) a)).
Definition check_angle (depth : nat) (l : list poly) (n d : poly) (x : claim) :=
  let a := Qnum (time x) in
  let b := Zpos (Qden (time x)) in
  if forallb (positive_to depth (time x)) l then
    if (a =? 0)%Z || is_zero n then within_radius x 0 0
    else
      let n := times a (fst (stretched a b n)) in
      let d := times b (fst (stretched a b d)) in
      let bits := (Z.log2_up (Zpos (Qden (radius x)) / Qnum (radius x)) + 16)%Z in
      let shows bits := integral_shows depth (length d * Z.to_nat bits) (Z.to_pos (2 ^ bits)) n d x in
      if shows bits then true else shows (bits + 240)%Z
  else false.

(* The angle of the rate n/d where that is the derivative of ratio = p/q, for a radius that may be 0. *)
Fixpoint at_fraction (a : poly) (t : Q) : Q :=
  match a with [] => 0 | c :: a => Qred (inject_Z c + t * at_fraction a t) end%Q.
Definition check_exact (depth : nat) (A0 : curve) (n d : poly) (ratio : list Q * list Q) (x : claim) :=
  let e := denominator_of (fst ratio ++ snd ratio) in
  let p := over e (fst ratio) in
  let q := over e (snd ratio) in
  let s := if (hd 0 q <? 0)%Z then (-1)%Z else 1%Z in
  let p := times s p in
  let q := times s q in
  let v t := (at_fraction p t / at_fraction q t)%Q in
  let w := (v (time x) - v 0)%Q in
  if forallb (positive_to depth (time x)) [isigma A0; d; q] then
    same (prod (diff (prod (derived p) q) (prod p (derived q))) d) (prod n (prod q q)) && within_radius x w w
  else false.

(* The angles to the Frenet frame: with gamma = (a + i b)/e over integers the rate is n/d + (a b' - b a')/(a a + b b).
   A has the denominator `denom`. *)
Definition check_bend (depth : nat) (A A0 : curve) (denom : positive) (n d : poly)
    (bend : list Q * list Q * list Q) (claims : list claim) :=
  let '(re, im, G) := bend in
  let e := denominator_of (re ++ im) in
  let k := denominator_of G in
  let a := over e re in
  let b := over e im in
  let norm := sum (prod a a) (prod b b) in
  let spin := diff (prod a (derived b)) (prod b (derived a)) in
  let n := sum (prod n norm) (prod spin d) in
  let d := prod d norm in
  let n' := padded (length d) n in
  let d' := padded (length n) d in
  let s := times (Zpos (e * k)) in
  let s' := times (Zpos (denom * denom)) in
  is_over e re && is_over e im && is_over k G &&
  same (s (ig_re A (derived_curve A))) (s' (prod (over k G) a)) &&
  same (s (ig_im A (derived_curve A))) (s' (prod (over k G) b)) &&
  is_positive depth norm && Nat.eqb (length n') (length d') &&
  forallb (check_angle depth [isigma A0; norm; d'] n' d') claims.

(* Decisions. That polynomials are independent is shown by their values at integers, looked for one after another. *)
Fixpoint at_integer (a : poly) (t : Z) : Z := match a with [] => 0 | c :: a => c + t * at_integer a t end%Z.
Definition ixyz A t := (at_integer (ix A) t, at_integer (iy A) t, at_integer (iz A) t).
Definition icross (a b : Z * Z * Z) : Z * Z * Z :=
  let '(x, y, z) := a in let '(u, v, w) := b in (y * w - z * v, z * u - x * w, x * v - y * u)%Z.
Definition idot (a b : Z * Z * Z) : Z := let '(x, y, z) := a in let '(u, v, w) := b in (x * u + y * v + z * w)%Z.
Definition inonzero (a : Z * Z * Z) := let '(x, y, z) := a in negb ((x =? 0) && (y =? 0) && (z =? 0))%Z.
Definition idet4 a k b l c m d n :=
  (n * idot a (icross b c) - m * idot a (icross b d) + l * idot a (icross c d) - k * idot b (icross c d))%Z.
Definition first_of (A : curve) (p : Z -> bool) : Z :=
  match find p (map Z.of_nat (seq 0 (2 * (length (iu A) + length (iv A) + length (ip A) + length (iq A))))) with
  | Some t => t
  | None => 0%Z
  end.
Definition three_points A :=
  let s := first_of A (fun s => inonzero (ixyz A s)) in
  let t := first_of A (fun t => inonzero (icross (ixyz A s) (ixyz A t))) in
  let u := first_of A (fun u => negb (idot (ixyz A s) (icross (ixyz A t) (ixyz A u)) =? 0)%Z) in
  (s, t, u).
Definition in_plane A (l : Q * Q * Q) :=
  let '(x, y, z) := l in
  let d := (Qden x * Qden y * Qden z)%positive in
  let c (q : Q) := (Qnum q * (Zpos d / Zpos (Qden q)))%Z in
  (is_over d [x; y; z], (c x, c y, c z),
   sum (sum (times (c x) (ix A)) (times (c y) (iy A))) (times (c z) (iz A))).
Definition independent A :=
  let '(s, t, u) := three_points A in negb (idot (ixyz A s) (icross (ixyz A t) (ixyz A u)) =? 0)%Z.

(* Zeros in [0, 1] by a change of sign from one point of a grid to another, or at what is given. *)
Definition grid : list Q := map (fun k => Qmake (Z.of_nat k) 256) (seq 0 257).
Definition in_unit (t : Q) := Qle_bool 0 t && Qle_bool t 1.
Definition changes_sign (grid : list Q) (a : poly) :=
  match find (fun t => negb (Qle_bool 0 (at_fraction a t))) grid,
    find (fun t => negb (Qle_bool (at_fraction a t) 0)) grid with
  | Some s, Some t => in_unit s && in_unit t
  | _, _ => false
  end.
Definition is_zero_at (a : poly) (t : Q) := in_unit t && Qeq_bool (at_fraction a t) 0.
Definition has_zero (grid : list Q) (a : poly) (hints : list Q) :=
  if existsb (is_zero_at a) hints then true else changes_sign grid a.
Definition takes_both_signs (grid : list Q) (a : poly) :=
  let inner (t : Q) := negb (Qle_bool t 0) && negb (Qle_bool 1 t) in
  existsb (fun t => inner t && negb (Qle_bool 0 (at_fraction a t))) grid &&
  existsb (fun t => inner t && negb (Qle_bool (at_fraction a t) 0)) grid.

(* a = t^m (1 - t)^n q^2 r; nothing rests on how q and r are found, nor m and n. *)
Fixpoint without (fuel : nat) (factor a : poly) : nat * poly :=
  match fuel with
  | O => (O, a)
  | S fuel =>
      let b := divided a factor in
      if same a (prod factor b) && negb (is_zero a) then let (n, c) := without fuel factor b in (S n, c) else (O, a)
  end.
Fixpoint power (a : poly) (n : nat) : poly := match n with O => [1%Z] | S n => prod a (power a n) end.
Definition keeps_sign (depth : nat) (a : poly) : bool :=
  let (m, b) := without (length a) [0%Z; 1%Z] a in
  let (n, b) := without (length a) [1%Z; (-1)%Z] b in
  let q := common_divisor (Curve b (derived b) [] []) in
  let r := divided (divided b q) q in
  let e := prod (power [0%Z; 1%Z] m) (prod (power [1%Z; (-1)%Z] n) (prod q q)) in
  if is_zero a then true
  else same a (prod e r) && (if is_positive depth r then true else is_positive depth (times (-1) r)).

Definition one_sign (depth : nat) (a : poly) := if is_positive depth a then true else is_positive depth (times (-1) a).
(* A = k A0, over this denominator. *)
Definition check_decision (depth : nat) (f k : poly) (denom : positive) (A0 : curve) (d : decision) : bool :=
  let A0' := derived_curve A0 in
  let h := ih A0 A0' in
  match d with
  | Regular => one_sign depth f && one_sign depth k
  | NotRegular cusps => if has_zero grid f cusps then true else has_zero grid k cusps
  | Inflection points =>
      let a := ig_re A0 A0' in
      let b := ig_im A0 A0' in
      let G := common_divisor (Curve a b [] []) in
      same a (prod G (divided a G)) && same b (prod G (divided b G)) && has_zero grid G points &&
      existsb (fun s => negb (at_integer (sum (prod a a) (prod b b)) s =? 0)%Z)
        (map Z.of_nat (seq 0 (2 * (length a + length b))))
  | NoInflection =>
      let n := sum (prod (ig_re A0 A0') (ig_re A0 A0')) (prod (ig_im A0 A0') (ig_im A0 A0')) in
      if is_zero n then true else is_positive depth n
  | Line l =>
      let '(is, (a, b, c), _) := in_plane A0 l in
      is && inonzero (a, b, c) && same (times c (iy A0)) (times b (iz A0)) &&
      same (times a (iz A0)) (times c (ix A0)) && same (times b (ix A0)) (times a (iy A0))
  | NotLine => let '(s, t, _) := three_points A0 in inonzero (icross (ixyz A0 s) (ixyz A0 t))
  | Planar l => let '(is, a, along) := in_plane A0 l in is && inonzero a && is_zero along
  | NotPlanar => independent A0
  | Helical l c =>
      let '(is, a, along) := in_plane A0 l in
      is && inonzero a && independent A0 &&
      same (times (Zpos (Qden c)) (prod along along)) (times (Qnum c * idot a a) (prod (isigma A0) (isigma A0)))
  | NotHelical =>
      let '(s, t, u) := three_points A0 in
      let x := at_integer (isigma A0) in
      let det v := idet4 (ixyz A0 s) (x s) (ixyz A0 t) (x t) (ixyz A0 u) (x u) (ixyz A0 v) (x v) in
      negb (det (first_of A0 (fun v => negb (det v =? 0)%Z)) =? 0)%Z
  | ErfIsRmf => is_zero h
  | ErfIsNotRmf => negb (at_integer h (first_of A0 (fun s => negb (at_integer h s =? 0)%Z)) =? 0)%Z
  | Rrmf re im =>
      let e := denominator_of (re ++ im) in
      let a := over e re in
      let b := over e im in
      let n := sum (prod a a) (prod b b) in
      is_over e re && is_over e im &&
      existsb (fun s => negb (at_integer n s =? 0)%Z) (map Z.of_nat (seq 0 (length n))) &&
      same (prod (diff (prod a (derived b)) (prod b (derived a))) (isigma A0)) (times (-1) (prod h n))
  | DoublePh w c =>
      let e := denominator_of w in
      let n := sum (prod (ig_re A0 A0') (ig_re A0 A0')) (prod (ig_im A0 A0') (ig_im A0 A0')) in
      is_over e w &&
      same (times (4 * (Zpos (Qden c) * (Zpos e * Zpos e))) (prod (prod (prod k k) (prod k k)) n))
        (times (Qnum c * (Zpos denom * Zpos denom * (Zpos denom * Zpos denom))) (prod (over e w) (over e w)))
  | Monotone => keeps_sign depth h
  | NotMonotone => takes_both_signs grid h
  end.

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
  forallb (check_decision depth f k d A0) (decisions c) &&
  match bend c with
  | None =>
      Nat.eqb (length n1) (length d1) &&
      forallb (fun x => if check_angle depth [t; d1] n1 d1 x then true
        else check_exact depth A0 n1 d1 (rational c) x) (claims c)
  | Some g => check_bend depth A A0 d n1 d1 g (claims c)
  end.

Definition accept := accept_within 400.

(* That A0. *)
Definition without_zeros (c : certificate) : curve :=
  let d := denominator_of (cu c ++ cv c ++ cp c ++ cq c) in
  let A := Curve (over d (cu c)) (over d (cv c)) (over d (cp c)) (over d (cq c)) in
  let k := common_divisor A in
  Curve (divided (iu A) k) (divided (iv A) k) (divided (ip A) k) (divided (iq A) k).

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

(* What is reached from 0 without leaving an open set is an open interval. *)
Lemma reached_interval (P : R -> Prop) : (forall s, P s -> locally s P) ->
  open_interval (fun t => forall s, within t s -> P s).
Proof.
  intro O; split.
  - intros t T.
    assert (Pt : P t) by (apply T; unfold within, Rmin, Rmax; destruct (Rle_dec 0 t); lra).
    destruct (O t Pt) as [eps L]; exists eps; intros x X s S.
    destruct (Rle_dec (Rmin 0 t) s) as [S1 | S1]; [destruct (Rle_dec s (Rmax 0 t)) as [S2 | S2] |].
    + apply T; split; assumption.
    + apply L; revert X; unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl.
      unfold within, Rmin, Rmax, Rabs in *; repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
    + apply L; revert X; unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl.
      unfold within, Rmin, Rmax, Rabs in *; repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
  - intros a b t Ta Tb X s S; destruct (Rle_dec 0 t); [apply Tb | apply Ta];
      unfold within, Rmin, Rmax in *; repeat destruct Rle_dec; lra.
Qed.

Lemma positive_open (F : R -> R) s : continuous F s -> 0 < F s -> locally s (fun s => 0 < F s).
Proof. intros C P; exact (C (fun y => 0 < y) (open_gt 0 (F s) P)). Qed.

(* From [0, 1] to what is between 0 and m/n. *)
Lemma within_ratio m n s : (0 < n)%Z -> m <> 0%Z -> within (IZR m / IZR n) s ->
  exists x, 0 <= x <= 1 /\ s = IZR m / IZR n * x.
Proof.
  intros N M W; apply IZR_lt in N; apply IZR_neq in M.
  assert (Z : IZR m / IZR n <> 0)
    by (apply Rmult_integral_contrapositive_currified; [exact M | apply Rinv_neq_0_compat; lra]).
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

Lemma positive_to_sound depth t a : positive_to depth t a = true ->
  forall s, within (Q2R t) s -> 0 < at_real a s.
Proof.
  intro P; apply (stretched_positive (Qnum t) (Zpos (Qden t))); [reflexivity |]; exact (is_positive_sound _ _ P).
Qed.

Lemma at_padded n a s : at_real (padded n a) s = at_real a s.
Proof.
  unfold padded; rewrite at_plus; replace (at_real (repeat 0%Z n) s) with 0; [ring |].
  induction n as [| n IH]; simpl; [| rewrite <- IH]; ring.
Qed.

Lemma check_angle_sound depth l n d x (w : R -> R) : length n = length d -> In d l ->
  (forall s, (forall a, In a l -> 0 < at_real a s) -> w s * at_real d s = at_real n s) ->
  check_angle depth l n d x = true ->
  (forall s, within (Q2R (time x)) s -> forall a, In a l -> 0 < at_real a s) /\
  Rabs (RInt w 0 (Q2R (time x)) - Q2R (angle x)) <= Q2R (radius x).
Proof.
  intros L I E H; unfold check_angle in H; cbv zeta in H.
  destruct (forallb (positive_to depth (time x)) l) eqn:P in H; [| discriminate].
  assert (C : forall s, within (Q2R (time x)) s -> forall a, In a l -> 0 < at_real a s).
  { intros s S a La; rewrite forallb_forall in P; exact (positive_to_sound _ _ _ (P a La) s S). }
  split; [exact C |].
  assert (W : forall s, within (Q2R (time x)) s -> w s = at_real n s / at_real d s).
  { intros s S; pose proof (C s S) as Cs; rewrite <- (E s Cs); field; apply Rgt_not_eq, Cs, I. }
  assert (W' : RInt w 0 (Q2R (time x)) = RInt (fun s => at_real n s / at_real d s) 0 (Q2R (time x))).
  { apply RInt_ext; intros s S; apply W; split; lra. }
  rewrite W'; clear W'.
  set (a := Qnum (time x)) in *; set (b := Zpos (Qden (time x))) in *.
  assert (B : (0 < b)%Z) by reflexivity.
  assert (T : Q2R (time x) = IZR a / IZR b) by reflexivity.
  destruct (_ || is_zero _)%bool eqn:Z in H.
  - (* There is nothing to integrate. *)
    apply (within_radius_sound _ _ _ _ H).
    replace (RInt _ 0 (Q2R (time x))) with 0; [change (Q2R 0) with (0 / 1); lra |].
    apply orb_true_iff in Z as [Z | Z].
    + apply Z.eqb_eq in Z; rewrite T, Z; unfold Rdiv; rewrite Rmult_0_l, RInt_point; reflexivity.
    + symmetry; rewrite (RInt_ext _ (fun _ => 0)).
      * rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; ring.
      * intros s S; rewrite (at_zero _ s Z); unfold Rdiv; apply Rmult_0_l.
  - set (n' := times a (fst (stretched a b n))) in *; set (d' := times b (fst (stretched a b d))) in *.
    assert (K : exists depth' terms unit, integral_shows depth' terms unit n' d' x = true)
      by (destruct (integral_shows _ _ _ _ _ _) eqn:S in H; do 3 eexists; [exact S | exact H]).
    clear H; destruct K as (depth' & terms & unit & H).
    apply integral_shows_sound in H as [_ H];
      [| unfold n', d'; rewrite !length_times, !length_stretched; exact L].
    unfold n', d' in H; rewrite (stretched_integral a b n d B L) in H; [rewrite <- T in H; exact H |].
    intros s S; apply Rgt_not_eq, (C s); [rewrite T; exact S | exact I].
Qed.

Lemma at_fraction_real a t : Q2R (at_fraction a t) = at_real a (Q2R t).
Proof.
  induction a as [| c a IH]; cbn [at_fraction at_real]; [unfold Q2R; simpl; ring |].
  rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_plus, Q2R_mult, IH; unfold Q2R at 1; simpl; field.
Qed.

Lemma at_zero_time : Q2R 0 = 0.
Proof. unfold Q2R; simpl; ring. Qed.

Lemma check_exact_sound depth A0 n d ratio x (w : R -> R) :
  (forall s, 0 < at_real (isigma A0) s -> 0 < at_real d s -> w s = at_real n s / at_real d s) ->
  check_exact depth A0 n d ratio x = true ->
  (forall s, within (Q2R (time x)) s -> 0 < at_real (isigma A0) s) /\
  Rabs (RInt w 0 (Q2R (time x)) - Q2R (angle x)) <= Q2R (radius x).
Proof.
  intros E H; unfold check_exact in H; cbv zeta in H.
  set (p := times _ (over _ (fst ratio))) in H; set (q := times _ (over _ (snd ratio))) in H; clearbody p q.
  destruct (forallb _ _) eqn:P in H; [| discriminate].
  apply andb_true_iff in H as [S W].
  rewrite forallb_forall in P.
  pose proof (positive_to_sound _ _ _ (P (isigma A0) ltac:(simpl; auto))) as PA.
  pose proof (positive_to_sound _ _ _ (P d ltac:(simpl; auto))) as PD.
  pose proof (positive_to_sound _ _ _ (P q ltac:(simpl; auto))) as PQ.
  split; [exact PA |]; apply (within_radius_sound _ _ _ _ W).
  set (T := Q2R (time x)) in *.
  assert (T0 : within T 0) by (unfold within, Rmin, Rmax; destruct (Rle_dec 0 T); lra).
  assert (T1 : within T T) by (unfold within, Rmin, Rmax; destruct (Rle_dec 0 T); lra).
  assert (N : forall t, within T (Q2R t) -> ~ (at_fraction q t == 0)%Q).
  { intros t I Z; apply Qeq_eqR in Z; rewrite at_fraction_real, at_zero_time in Z; specialize (PQ _ I); lra. }
  pose (F := fun s => at_real p s / at_real q s).
  assert (V : forall t, within T (Q2R t) -> Q2R (at_fraction p t / at_fraction q t) = F (Q2R t)).
  { intros t I; rewrite Q2R_div by exact (N t I); rewrite !at_fraction_real; reflexivity. }
  assert (I : RInt w 0 T = F T - F 0).
  { transitivity (RInt (fun s => at_real n s / at_real d s) 0 T).
    { apply RInt_ext; intros s I; apply E; [apply PA | apply PD]; split; lra. }
    apply is_RInt_unique, (is_RInt_derive (V := R_CompleteNormedModule) F); intros s I.
    - apply (at_same _ _ s) in S; unfold prod, diff in S; rewrite !at_mult, at_minus, !at_mult in S.
      pose proof (PQ s I) as Q0; pose proof (PD s I) as D0.
      unfold F; auto_derive.
      + repeat split; try (eexists; apply at_derived); lra.
      + change (fun y : R => at_real p y) with (at_real p); change (fun y : R => at_real q y) with (at_real q).
        rewrite (is_derive_unique _ _ _ (at_derived p s)), (is_derive_unique _ _ _ (at_derived q s)).
        apply (Rmult_eq_reg_r (at_real d s * (at_real q s * at_real q s)));
          [| repeat apply Rmult_integral_contrapositive_currified; lra].
        transitivity (at_real n s * (at_real q s * at_real q s)); [rewrite <- S |]; field; lra.
    - apply quotient_continuous, Rgt_not_eq, PD, I. }
  rewrite I, Q2R_minus, (V (time x)), (V 0%Q); rewrite ?at_zero_time; auto; fold T; lra.
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

(* ---- The frames *)

Section Frames.

Variables A0 A0' : R -> quaternion.
Hypothesis A0_derivative : forall s, quaternion_derivative A0 s (A0' s).
Hypothesis A0'_continuous : forall s, quaternion_continuous A0' s.
Hypothesis no_zero : forall s, 0 <= s <= 1 -> 0 < sigma (A0 s).

Lemma A0_continuous s : quaternion_continuous A0 s.
Proof. exact (continuous_derivative A0 s (A0' s) (A0_derivative s)). Qed.

Lemma sigma_continuous s : continuous (fun s => sigma (A0 s)) s.
Proof. destruct (A0_continuous s) as (U & V & P & Q); unfold sigma; continuity. Qed.

Lemma at_itself t : within t t.
Proof. unfold within, Rmin, Rmax; destruct (Rle_dec 0 t); lra. Qed.

Lemma clear_interval : open_interval (clear A0).
Proof.
  apply (reached_interval (fun s => 0 < sigma (A0 s))); intros s P; exact (positive_open _ s (sigma_continuous s) P).
Qed.

Lemma clear_on_unit t : 0 <= t <= 1 -> clear A0 t.
Proof. intros T s S; unfold within in S; rewrite Rmin_left, Rmax_right in S by lra; apply no_zero; lra. Qed.

Lemma erf_holds : erf_statement A0 A0'.
Proof.
  split; [exact clear_interval | split; [exact clear_on_unit |]].
  apply frame_by_theta; auto using clear_interval.
  - apply clear_on_unit; lra.
  - intros t T; exact (T t (at_itself t)).
Qed.

Variables a b a' b' : R -> R.
Hypothesis a_derivative : forall s, is_derive a s (a' s).
Hypothesis b_derivative : forall s, is_derive b s (b' s).
Hypothesis a'_continuous : forall s, continuous a' s.
Hypothesis b'_continuous : forall s, continuous b' s.
Hypothesis gamma_nonzero : forall s, 0 <= s <= 1 -> 0 < norm_squared a b s.

Lemma real_continuous (F : R -> R) s l : is_derive F s l -> continuous F s.
Proof. intro H; apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)); eexists; exact H. Qed.

Lemma norm_continuous s : continuous (norm_squared a b) s.
Proof.
  pose proof (real_continuous _ _ _ (a_derivative s)); pose proof (real_continuous _ _ _ (b_derivative s)).
  unfold norm_squared; continuity.
Qed.

Lemma gamma_rate_continuous s : 0 < sigma (A0 s) -> 0 < norm_squared a b s ->
  continuous (gamma_rate A0 A0' a b a' b') s.
Proof.
  intros P N; pose proof (rate_continuous A0 A0' s (A0_continuous s) (A0'_continuous s) P) as R.
  pose proof (real_continuous _ _ _ (a_derivative s)); pose proof (real_continuous _ _ _ (b_derivative s)).
  pose proof (norm_continuous s); specialize (a'_continuous s); specialize (b'_continuous s).
  unfold gamma_rate; apply continuous_plus_R; [exact R |].
  apply continuous_over_R; [continuity | assumption | exact N].
Qed.

Lemma frenet_holds : frenet_statement A0 A0' a b a' b'.
Proof.
  set (D := both_clear A0 a b).
  assert (I : open_interval D).
  { apply (reached_interval (fun s => 0 < sigma (A0 s) /\ 0 < norm_squared a b s)); intros s [P N].
    apply filter_and; apply positive_open; auto using sigma_continuous, norm_continuous. }
  assert (U : forall t, 0 <= t <= 1 -> D t).
  { intros t T s S; unfold within in S; rewrite Rmin_left, Rmax_right in S by lra; split;
      [apply no_zero | apply gamma_nonzero]; lra. }
  assert (D0 : D 0) by (apply U; lra).
  assert (P : forall t, D t -> 0 < sigma (A0 t)) by (intros t T; exact (proj1 (T t (at_itself t)))).
  assert (N : forall t, D t -> 0 < norm_squared a b t) by (intros t T; exact (proj2 (T t (at_itself t)))).
  destruct (angle_exists D (gamma_rate A0 A0' a b a' b') 0 I D0) as [Z R].
  { intros t T; apply gamma_rate_continuous; auto. }
  set (psi := fun t => 0 + RInt (gamma_rate A0 A0' a b a' b') 0 t) in *.
  assert (M : rotation_minimizing D (fun t => e1 (A0 t))
      (fun t => turn2 (psi t) (gamma_normal A0 a b t) (gamma_binormal A0 a b t))
      (fun t => turn3 (psi t) (gamma_normal A0 a b t) (gamma_binormal A0 a b t))).
  { pose (c := pair_c a b psi); pose (s := pair_s a b psi).
    assert (H2 : forall t, add (scale (c t) (e2 (A0 t))) (scale (s t) (e3 (A0 t))) =
      turn2 (psi t) (gamma_normal A0 a b t) (gamma_binormal A0 a b t))
      by (intro t; apply vector_eq; unfold turn2, gamma_normal, gamma_binormal, norm_squared, add, scale, c, s,
          pair_c, pair_s, Rdiv; cbn [vx vy vz]; ring).
    assert (H3 : forall t, add (scale (- s t) (e2 (A0 t))) (scale (c t) (e3 (A0 t))) =
      turn3 (psi t) (gamma_normal A0 a b t) (gamma_binormal A0 a b t))
      by (intro t; apply vector_eq; unfold turn3, gamma_normal, gamma_binormal, norm_squared, add, scale, c, s,
          pair_c, pair_s, Rdiv; cbn [vx vy vz]; ring).
    assert (T : forall t, D t -> c t * c t + s t * s t = 1 /\
      is_derive c t (- (-2 * h (A0 t) (A0' t) / sigma (A0 t)) * s t) /\
      is_derive s t (-2 * h (A0 t) (A0' t) / sigma (A0 t) * c t))
      by (intros t Ht; exact (pair_turns a b psi t _ _ _ (a_derivative t) (b_derivative t) (N t Ht) (R t Ht))).
    intros t Ht.
    destruct (pair_is_rotation_minimizing D A0 A0' (fun t _ => A0_derivative t) P c s T t Ht)
      as (F & (k & K) & (l & L)).
    rewrite H2, H3 in F; split; [exact F | split].
    - exists k; exact (derivative_ext _ _ _ _ _ H2 eq_refl K).
    - exists l; exact (derivative_ext _ _ _ _ _ H3 eq_refl L). }
  split; [exact I | split; [exact U | split; [exact Z | split; [exact R | split; [exact M |]]]]].
  intros g2 g3 G; exact (unique_but_for_a_turn D 0 _ _ _ _ _ I D0 M G).
Qed.

End Frames.

Lemma derivative_over (F : R -> R) a e s : 0 < e -> (forall s, F s = at_real a s / e) ->
  is_derive F s (at_real (derived a) s / e).
Proof.
  intros E V; apply (is_derive_ext (fun s => / e * at_real a s)); [intro; rewrite V; apply Rmult_comm |].
  replace (at_real (derived a) s / e) with (/ e * at_real (derived a) s) by (field; lra).
  apply is_derive_scal, at_derived.
Qed.

(* The angles to the Frenet frame. *)
Lemma check_bend_sound depth A A0 denom n d (At : R -> quaternion) re im G l :
  (forall s, At s = multiple (/ IZR (Zpos denom)) (reals A s)) ->
  (forall s, 0 <= s <= 1 -> 0 < sigma (reals A0 s)) ->
  (forall s, 0 < sigma (reals A0 s) -> rate (reals A0) (reals (derived_curve A0)) s * at_real d s = at_real n s) ->
  check_bend depth A A0 denom n d (re, im, G) l = true ->
  let A' s := multiple (/ IZR (Zpos denom)) (reals (derived_curve A) s) in
  (forall s, g_re (At s) (A' s) = value G s * value re s /\ g_im (At s) (A' s) = value G s * value im s) /\
  exists a' b' : R -> R,
    (forall s, is_derive (value re) s (a' s) /\ is_derive (value im) s (b' s)) /\
    frenet_statement (reals A0) (reals (derived_curve A0)) (value re) (value im) a' b' /\
    angles_statement (both_clear (reals A0) (value re) (value im))
      (gamma_rate (reals A0) (reals (derived_curve A0)) (value re) (value im) a' b') l.
Proof.
  intros EA POS R1 H; unfold check_bend in H.
  set (e := denominator_of (re ++ im)) in *; set (k := denominator_of G) in *.
  set (a := over e re) in *; set (b := over e im) in *; cbv zeta in H.
  set (norm := sum (prod a a) (prod b b)) in *.
  set (spin := diff (prod a (derived b)) (prod b (derived a))) in *.
  set (n' := padded _ _) in H; set (d' := padded _ _) in H.
  rewrite !andb_true_iff in H; destruct H as (((((((Ore & Oim) & OG) & Gre) & Gim) & NORM) & LEN) & ANGLES).
  pose proof (positive_real denom) as Dp; pose proof (positive_real e) as Ep; pose proof (positive_real k) as Kp.
  assert (Va : forall s, value re s = at_real a s / IZR (Zpos e))
    by (intro s; unfold a; rewrite value_over by assumption; field; lra).
  assert (Vb : forall s, value im s = at_real b s / IZR (Zpos e))
    by (intro s; unfold b; rewrite value_over by assumption; field; lra).
  pose proof (fun s => derivative_over (value re) a (IZR (Zpos e)) s Ep Va) as Da.
  pose proof (fun s => derivative_over (value im) b (IZR (Zpos e)) s Ep Vb) as Db.
  assert (Vn : forall s, norm_squared (value re) (value im) s = at_real norm s / (IZR (Zpos e) * IZR (Zpos e))).
  { intro s; unfold norm_squared, norm, sum, prod; rewrite Va, Vb, at_plus, !at_mult; field; lra. }
  assert (Np : forall s, 0 < at_real norm s -> 0 < norm_squared (value re) (value im) s).
  { intros s S; rewrite Vn; apply Rdiv_lt_0_compat; nra. }
  cbv zeta; split.
  - intro s; rewrite EA, g_re_multiple, g_im_multiple, <- at_ig_re, <- at_ig_im, Va, Vb.
    assert (VG : value G s = at_real (over k G) s / IZR (Zpos k)) by (rewrite value_over by assumption; field; lra).
    rewrite VG; apply (at_same _ _ s) in Gre, Gim; unfold prod in Gre, Gim.
    rewrite !at_times, at_mult, !Pos2Z.inj_mul, !mult_IZR in Gre, Gim.
    split.
    + apply (Rmult_eq_reg_l (IZR (Zpos e) * IZR (Zpos k) * (IZR (Zpos denom) * IZR (Zpos denom))));
        [| repeat apply Rmult_integral_contrapositive_currified; lra].
      transitivity (IZR (Zpos e) * IZR (Zpos k) * at_real (ig_re A (derived_curve A)) s); [field; lra |].
      rewrite Gre; field; lra.
    + apply (Rmult_eq_reg_l (IZR (Zpos e) * IZR (Zpos k) * (IZR (Zpos denom) * IZR (Zpos denom))));
        [| repeat apply Rmult_integral_contrapositive_currified; lra].
      transitivity (IZR (Zpos e) * IZR (Zpos k) * at_real (ig_im A (derived_curve A)) s); [field; lra |].
      rewrite Gim; field; lra.
  - exists (fun s => at_real (derived a) s / IZR (Zpos e)), (fun s => at_real (derived b) s / IZR (Zpos e)).
    split; [auto | split].
    + apply frenet_holds; auto using reals_derivative, reals_continuous.
      * intro s; apply continuous_mult_R; [apply at_continuous | apply continuous_const_R].
      * intro s; apply continuous_mult_R; [apply at_continuous | apply continuous_const_R].
      * intros s S; apply Np; exact (is_positive_sound _ _ NORM s S).
    + intros x X; rewrite forallb_forall in ANGLES; specialize (ANGLES x X).
      apply (check_angle_sound _ _ _ _ _ (gamma_rate (reals A0) (reals (derived_curve A0)) (value re) (value im)
        (fun s => at_real (derived a) s / IZR (Zpos e)) (fun s => at_real (derived b) s / IZR (Zpos e)))) in ANGLES.
      * destruct ANGLES as [C V]; split; [| exact V].
        intros s S; split; [rewrite <- at_isigma; apply (C s S); simpl; auto | apply Np, (C s S); simpl; auto].
      * apply Nat.eqb_eq, LEN.
      * simpl; auto.
      * intros s C.
        assert (S : 0 < sigma (reals A0 s)) by (rewrite <- at_isigma; apply C; simpl; auto).
        assert (N : 0 < at_real norm s) by (apply C; simpl; auto).
        unfold n', d'; rewrite !at_padded.
        unfold sum at 1, prod at 1 2 3; rewrite at_plus, !at_mult, <- (R1 s S).
        unfold gamma_rate; rewrite Vn, Va, Vb.
        unfold spin, diff, prod; rewrite at_minus, !at_mult; field; lra.
Qed.

(* ---- The decisions *)

Lemma at_integer_real a t : IZR (at_integer a t) = at_real a (IZR t).
Proof.
  induction a as [| c a IH]; cbn [at_integer at_real]; [reflexivity |].
  rewrite plus_IZR, mult_IZR, IH; reflexivity.
Qed.

Definition real3 (a : Z * Z * Z) := let '(x, y, z) := a in Vector (IZR x) (IZR y) (IZR z).

Lemma real_ixyz A t : real3 (ixyz A t) = xyz (reals A) (IZR t).
Proof. unfold xyz; rewrite <- at_ixyz; unfold ixyz, real3; rewrite !at_integer_real; reflexivity. Qed.
Lemma real_icross a b : real3 (icross a b) = cross (real3 a) (real3 b).
Proof.
  destruct a as [[x y] z], b as [[u v] w]; unfold cross; apply vector_eq; simpl;
    rewrite minus_IZR, !mult_IZR; reflexivity.
Qed.
Lemma real_idot a b : IZR (idot a b) = dot (real3 a) (real3 b).
Proof. destruct a as [[x y] z], b as [[u v] w]; unfold dot; simpl; rewrite !plus_IZR, !mult_IZR; reflexivity. Qed.

Lemma inonzero_real a : inonzero a = true -> real3 a <> no_vector.
Proof.
  destruct a as [[x y] z]; unfold inonzero; intros N E; injection E as X Y Z; apply eq_IZR in X, Y, Z; subst.
  discriminate.
Qed.

Lemma not_zero z : negb (z =? 0)%Z = true -> IZR z <> 0.
Proof. intros N%negb_true_iff%Z.eqb_neq E; apply N, eq_IZR, E. Qed.

Lemma independent_real A : independent A = true ->
  exists s t u, triple_product (xyz (reals A) s) (xyz (reals A) t) (xyz (reals A) u) <> 0.
Proof.
  unfold independent; destruct (three_points A) as [[s t] u]; intro N; apply not_zero in N.
  exists (IZR s), (IZR t), (IZR u); unfold triple_product.
  rewrite <- !real_ixyz, <- real_icross, <- real_idot; exact N.
Qed.

(* With the common denominator e the vector l is a/e. *)
Lemma in_plane_real A l is a along : in_plane A l = (is, a, along) -> is = true ->
  exists e, 0 < e /\ real3 a = scale e (real_vector l) /\
    forall s, at_real along s = dot (real3 a) (xyz (reals A) s).
Proof.
  destruct l as [[x y] z]; unfold in_plane; intros E I; injection E as <- <- <-.
  set (d := (Qden x * Qden y * Qden z)%positive) in *.
  exists (IZR (Zpos d)); split; [apply positive_real | split].
  - cbn [is_over forallb] in I; rewrite !andb_true_iff, !Z.eqb_eq in I; destruct I as (X & Y & Z & _).
    assert (K : forall q, (Zpos d / Zpos (Qden q) * Zpos (Qden q) = Zpos d)%Z ->
        IZR (Qnum q * (Zpos d / Zpos (Qden q))) = IZR (Zpos d) * Q2R q).
    { intros q H; rewrite <- H at 2; unfold Q2R; rewrite !mult_IZR; field; apply IZR_neq; discriminate. }
    apply vector_eq; cbn [real3 vx vy vz scale real_vector]; apply K; assumption.
  - intro s; unfold xyz; rewrite <- at_ixyz; unfold sum, dot; rewrite !at_plus, !at_times; reflexivity.
Qed.

Lemma one_sign_real depth a s : one_sign depth a = true -> 0 <= s <= 1 -> at_real a s <> 0.
Proof.
  unfold one_sign; destruct (is_positive depth a) eqn:P; intros N S.
  - apply Rgt_not_eq; exact (is_positive_sound _ _ P s S).
  - pose proof (is_positive_sound _ _ N s S) as H; rewrite at_times in H; lra.
Qed.

Lemma Qle_real s t : Qle_bool s t = true -> Q2R s <= Q2R t.
Proof. intro L; apply Qle_Rle, Qle_bool_iff, L. Qed.
Lemma Qlt_real s t : negb (Qle_bool t s) = true -> Q2R s < Q2R t.
Proof.
  intros L%negb_true_iff; apply Qlt_Rlt; destruct (Qlt_le_dec s t) as [H | H]; [exact H |].
  apply Qle_bool_iff in H; congruence.
Qed.
Lemma Q2R_one : Q2R 1 = 1.
Proof. unfold Q2R; simpl; field. Qed.

Lemma in_unit_real t : in_unit t = true -> 0 <= Q2R t <= 1.
Proof.
  intros [A B]%andb_true_iff; apply Qle_real in A, B; rewrite at_zero_time in A; rewrite Q2R_one in B; lra.
Qed.

Lemma has_zero_real grid a hints : has_zero grid a hints = true -> exists s, 0 <= s <= 1 /\ at_real a s = 0.
Proof.
  unfold has_zero; destruct (existsb _ _) eqn:E.
  - intros _; apply existsb_exists in E as (t & _ & H); apply andb_true_iff in H as [U Z].
    exists (Q2R t); split; [exact (in_unit_real t U) |].
    apply Qeq_bool_eq, Qeq_eqR in Z; rewrite at_fraction_real, at_zero_time in Z; exact Z.
  - unfold changes_sign.
    destruct (find (fun t => negb (Qle_bool 0 (at_fraction a t))) grid) as [s |] eqn:S; [| discriminate].
    destruct (find (fun t => negb (Qle_bool (at_fraction a t) 0)) grid) as [t |] eqn:T; [| discriminate].
    intros [Us Ut]%andb_true_iff; apply in_unit_real in Us, Ut.
    apply find_some, proj2, Qlt_real in S; apply find_some, proj2, Qlt_real in T.
    rewrite at_fraction_real, at_zero_time in S, T.
    assert (C : Ranalysis1.continuity (at_real a))
      by (intro x; apply continuity_pt_filterlim; exact (at_continuous a x)).
    destruct (IVT_gen (at_real a) (Q2R s) (Q2R t) 0 C) as (x & X & Z).
    { unfold Rmin, Rmax; destruct (Rle_dec (at_real a (Q2R s)) (at_real a (Q2R t))); lra. }
    exists x; split; [| exact Z].
    unfold Rmin, Rmax in X; destruct (Rle_dec (Q2R s) (Q2R t)); lra.
Qed.

Lemma takes_both_signs_real grid a : takes_both_signs grid a = true ->
  exists s t, 0 < s < 1 /\ 0 < t < 1 /\ at_real a s < 0 /\ 0 < at_real a t.
Proof.
  intros [X Y]%andb_true_iff.
  apply existsb_exists in X as (s & _ & X); apply existsb_exists in Y as (t & _ & Y).
  rewrite !andb_true_iff in X, Y; destruct X as ((X1 & X2) & X3); destruct Y as ((Y1 & Y2) & Y3).
  apply Qlt_real in X1, X2, X3, Y1, Y2, Y3; rewrite at_zero_time in X1, X3, Y1, Y3; rewrite Q2R_one in X2, Y2.
  rewrite at_fraction_real in X3, Y3; exists (Q2R s), (Q2R t); auto.
Qed.

Lemma power_nonnegative a n s : 0 <= at_real a s -> 0 <= at_real (power a n) s.
Proof.
  intro P; induction n as [| n IH]; simpl; [lra |]; unfold prod; rewrite at_mult; apply Rmult_le_pos; assumption.
Qed.

Lemma keeps_sign_real depth a : keeps_sign depth a = true ->
  (forall s, 0 <= s <= 1 -> 0 <= at_real a s) \/ (forall s, 0 <= s <= 1 -> at_real a s <= 0).
Proof.
  unfold keeps_sign; destruct (without _ _ _) as [m b]; destruct (without _ _ _) as [n b'].
  set (q := common_divisor _); set (r := divided (divided _ _) _); cbv zeta; clearbody q r.
  destruct (is_zero a) eqn:Z.
  { intros _; left; intros s _; rewrite (at_zero a s Z); lra. }
  intros [S P]%andb_true_iff.
  assert (N : forall s, 0 <= s <= 1 ->
      0 <= at_real (prod (power [0%Z; 1%Z] m) (prod (power [1%Z; (-1)%Z] n) (prod q q))) s).
  { intros s U; unfold prod; rewrite !at_mult.
    apply Rmult_le_pos; [apply power_nonnegative; simpl; lra |].
    apply Rmult_le_pos; [apply power_nonnegative; simpl; lra | apply Rle_0_sqr]. }
  set (e := prod (power _ _) _) in *; clearbody e.
  assert (V : forall s, at_real a s = at_real e s * at_real r s)
    by (intro s; apply (at_same _ _ s) in S; unfold prod in S; rewrite at_mult in S; exact S).
  destruct (is_positive depth r) eqn:R; [left | right]; intros s U; rewrite V.
  - apply Rmult_le_pos; [exact (N s U) | left; exact (is_positive_sound _ _ R s U)].
  - pose proof (is_positive_sound _ _ P s U) as H; rewrite at_times in H.
    specialize (N s U); nra.
Qed.

Lemma scale_nonzero e l : 0 < e -> scale e l <> no_vector -> l <> no_vector.
Proof. intros E N ->; apply N, vector_eq; simpl; ring. Qed.

Lemma check_decision_sound depth f k n A0 (fr : R -> R) (e : positive) x :
  (forall s, fr s = at_real f s / IZR (Zpos e)) ->
  check_decision depth f k n A0 x = true ->
  decision_statement fr (fun s => at_real k s / IZR (Zpos n)) (reals A0) (reals (derived_curve A0)) x.
Proof.
  intros F H; pose proof (positive_real e) as Ep; pose proof (positive_real n) as Np.
  destruct x; cbn [check_decision decision_statement] in *.
  - apply andb_true_iff in H as [Hf Hk]; intros s S; rewrite F.
    pose proof (one_sign_real _ _ _ Hf S); pose proof (one_sign_real _ _ _ Hk S).
    split; apply Rmult_integral_contrapositive_currified; auto; apply Rinv_neq_0_compat; lra.
  - destruct (has_zero grid f cusps) eqn:Zf;
      [apply has_zero_real in Zf as (s & U & Z) | apply has_zero_real in H as (s & U & Z)];
      exists s; (split; [exact U |]); rewrite F, Z; field; lra.
  - set (a := ig_re A0 (derived_curve A0)) in *; set (b := ig_im A0 (derived_curve A0)) in *.
    set (G := common_divisor _) in H; clearbody G.
    rewrite !andb_true_iff in H; destruct H as (((Sa & Sb) & Z) & X).
    assert (M : forall s, g_squared (reals A0 s) (reals (derived_curve A0) s) =
        at_real a s * at_real a s + at_real b s * at_real b s)
      by (intro s; unfold g_squared, a, b; rewrite at_ig_re, at_ig_im; reflexivity).
    split.
    + apply has_zero_real in Z as (s & U & Z); exists s; split; [exact U |].
      apply (at_same _ _ s) in Sa, Sb; unfold prod in Sa, Sb; rewrite at_mult in Sa, Sb.
      rewrite M, Sa, Sb, Z; ring.
    + apply existsb_exists in X as (s & _ & N); apply not_zero in N; exists (IZR s).
      rewrite at_integer_real in N; unfold sum, prod in N; rewrite at_plus, !at_mult in N; rewrite M; exact N.
  - set (m := sum _ _) in H.
    assert (M : forall s, g_squared (reals A0 s) (reals (derived_curve A0) s) = at_real m s).
    { intro s; unfold g_squared, m, sum, prod; rewrite at_plus, !at_mult, at_ig_re, at_ig_im; reflexivity. }
    destruct (is_zero m) eqn:Z; [right | left]; intros s; [| intro S]; rewrite M;
      [exact (at_zero _ s Z) | exact (is_positive_sound _ _ H s S)].
  - destruct (in_plane A0 direction) as [[is [[a b] c]] along] eqn:E.
    rewrite !andb_true_iff in H; destruct H as ((((I & N) & S1) & S2) & S3).
    destruct (in_plane_real _ _ _ _ _ E I) as (d & D & L & _).
    apply inonzero_real in N; rewrite L in N; split; [exact (scale_nonzero d _ D N) |].
    intro s; apply (at_same _ _ s) in S1, S2, S3; rewrite !at_times in S1, S2, S3.
    assert (Z : cross (xyz (reals A0) s) (scale d (real_vector direction)) = no_vector).
    { rewrite <- L; unfold xyz; rewrite <- at_ixyz; apply vector_eq; unfold cross;
        cbn [vx vy vz real3 no_vector]; lra. }
    destruct (real_vector direction) as [x y z]; destruct (xyz (reals A0) s) as [u v w].
    unfold cross, scale in *; cbn [vx vy vz] in *; injection Z as Z1 Z2 Z3.
    apply vector_eq; cbn [vx vy vz no_vector]; apply (Rmult_eq_reg_l d); lra.
  - destruct (three_points A0) as [[s t] u]; apply inonzero_real in H.
    exists (IZR s), (IZR t); rewrite <- !real_ixyz, <- real_icross; exact H.
  - destruct (in_plane A0 normal) as [[is a] along] eqn:E.
    rewrite !andb_true_iff in H; destruct H as ((I & N) & Z).
    destruct (in_plane_real _ _ _ _ _ E I) as (d & D & L & V).
    apply inonzero_real in N; rewrite L in N; split; [exact (scale_nonzero d _ D N) |].
    intro s; specialize (V s); rewrite (at_zero _ s Z), L in V.
    apply (Rmult_eq_reg_l d); [| lra]; rewrite Rmult_0_r, V; unfold dot; simpl; ring.
  - exact (independent_real _ H).
  - destruct (in_plane A0 axis) as [[is a] along] eqn:E.
    rewrite !andb_true_iff in H; destruct H as (((I & N) & T) & S).
    destruct (in_plane_real _ _ _ _ _ E I) as (d & D & L & V).
    apply inonzero_real in N; rewrite L in N; split; [exact (independent_real _ T) |].
    split; [exact (scale_nonzero d _ D N) |].
    intro s; apply (at_same _ _ s) in S; unfold prod in S.
    rewrite !at_times, !at_mult, mult_IZR, real_idot, V, at_isigma, L in S.
    pose proof (positive_real (Qden cos_squared)) as Cp; unfold Q2R.
    destruct (real_vector axis) as [x y z]; destruct (xyz (reals A0) s) as [u v w].
    unfold dot, scale in *; cbn [vx vy vz] in *.
    apply (Rmult_eq_reg_l (IZR (QDen cos_squared) * (d * d)));
      [| repeat apply Rmult_integral_contrapositive_currified; lra].
    match type of S with ?l = ?r => transitivity l; [ring |]; rewrite S end; field; lra.
  - destruct (three_points A0) as [[s t] u].
    set (v := first_of _ _) in H; apply not_zero in H.
    exists (IZR s), (IZR t), (IZR u), (IZR v).
    unfold idet4 in H; rewrite minus_IZR, plus_IZR, minus_IZR, !mult_IZR, !real_idot, !real_icross, !real_ixyz,
      !at_integer_real, !at_isigma in H.
    exact H.
  - intro s; rewrite <- at_ih; exact (at_zero _ s H).
  - set (s := first_of _ _) in H; apply not_zero in H; rewrite at_integer_real, at_ih in H.
    exists (IZR s); exact H.
  - set (d := denominator_of (re ++ im)) in *; set (a := over d re) in *; set (b := over d im) in *.
    rewrite !andb_true_iff in H; destruct H as (((Ore & Oim) & X) & S).
    pose proof (positive_real d) as Dp.
    assert (Va : forall s, value re s = at_real a s / IZR (Zpos d))
      by (intro s; unfold a; rewrite value_over by assumption; field; lra).
    assert (Vb : forall s, value im s = at_real b s / IZR (Zpos d))
      by (intro s; unfold b; rewrite value_over by assumption; field; lra).
    assert (Vn : forall s, norm_squared (value re) (value im) s =
        at_real (sum (prod a a) (prod b b)) s / (IZR (Zpos d) * IZR (Zpos d))).
    { intro s; unfold norm_squared, sum, prod; rewrite Va, Vb, at_plus, !at_mult; field; lra. }
    split.
    + apply existsb_exists in X as (s & _ & N); apply not_zero in N; rewrite at_integer_real in N.
      exists (IZR s); rewrite Vn; apply Rmult_integral_contrapositive_currified; [exact N |].
      apply Rinv_neq_0_compat, Rmult_integral_contrapositive_currified; lra.
    + exists (fun s => at_real (derived a) s / IZR (Zpos d)), (fun s => at_real (derived b) s / IZR (Zpos d)).
      intro s; split; [exact (derivative_over _ _ _ s Dp Va) | split; [exact (derivative_over _ _ _ s Dp Vb) |]].
      apply (at_same _ _ s) in S; unfold prod at 1, diff in S.
      rewrite at_mult, at_minus, at_times in S; unfold prod at 1 2 3 in S; rewrite !at_mult, at_ih, at_isigma in S.
      rewrite Vn, Va, Vb; apply (Rmult_eq_reg_l (IZR (Zpos d) * IZR (Zpos d)));
        [| repeat apply Rmult_integral_contrapositive_currified; lra].
      match type of S with ?l = ?r => transitivity l; [field; lra |]; rewrite S end; field; lra.
  - set (d := denominator_of omega) in *; apply andb_true_iff in H as [O S].
    pose proof (positive_real d) as Dp; pose proof (positive_real (Qden constant)) as Cp.
    intro s; apply (at_same _ _ s) in S; unfold sum, prod in S.
    rewrite !at_times, !at_mult, at_plus, !at_mult, at_ig_re, at_ig_im, value_over in S by exact O.
    rewrite !mult_IZR in S.
    unfold g_squared, Q2R.
    apply (Rmult_eq_reg_l (IZR (QDen constant) * (IZR (Zpos d) * IZR (Zpos d)) *
      (IZR (Zpos n) * IZR (Zpos n) * (IZR (Zpos n) * IZR (Zpos n)))));
      [| repeat apply Rmult_integral_contrapositive_currified; lra].
    match type of S with ?l = ?r => transitivity l; [field; lra |]; rewrite S end; field; lra.
  - apply keeps_sign_real in H as [H | H]; [left | right]; intros s U; rewrite <- at_ih; exact (H s U).
  - apply takes_both_signs_real in H as (s & t & S & T & L & G); exists s, t; rewrite <- !at_ih; auto.
Qed.

Theorem accept_within_sound depth c : accept_within depth c = true ->
  statement_about c (reals (without_zeros c)) (reals (derived_curve (without_zeros c))).
Proof.
  unfold accept_within, without_zeros; set (d := denominator_of (_ ++ _)); set (e := denominator_of (multiplier c)).
  set (f := over e (multiplier c)).
  set (A := Curve (over d (cu c)) (over d (cv c)) (over d (cp c)) (over d (cq c))).
  set (A' := derived_curve A).
  set (k := common_divisor A).
  set (A0 := Curve (divided _ _) (divided _ _) (divided _ _) (divided _ _)); clearbody A0; clearbody k.
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
    | H : same _ (prod k _) = true |- _ =>
        apply (at_same _ _ s) in H; unfold prod in H; rewrite at_mult in H; rewrite H; clear H
    end; f_equal; field; lra. }
  assert (POS : forall s, 0 <= s <= 1 -> 0 < sigma (reals A0 s)).
  { intros s S; rewrite <- at_isigma; eapply is_positive_sound; [eassumption | exact S]. }
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
  unfold statement_about; exists (fun s => multiple (/ IZR (Zpos d)) (reals (derived_curve A) s)).
  split; [exact DA | split; [exact INV | split; [exact RATE |]]].
  exists k, d.
  split; [assumption | split; [exact E0 | split; [apply reals_derivative | split; [exact ALONG | split; [| split]]]]].
  - apply erf_holds; auto using reals_derivative, reals_continuous.
  - intros x X.
    match goal with
    | H : forallb (check_decision _ _ _ _ _) _ = true |- _ =>
        rewrite forallb_forall in H; specialize (H x X); rename H into CH
    end.
    apply (check_decision_sound _ _ _ _ _ (value (multiplier c)) e) in CH; [exact CH |].
    intro s; unfold f; rewrite value_over by assumption; field; lra.
  - match goal with
    | H : same (times (-2) _) (prod n1 _) = true |- _ => rename H into SAME
    end.
    assert (R1 : forall s, 0 < sigma (reals A0 s) ->
        rate (reals A0) (reals (derived_curve A0)) s * at_real d1 s = at_real n1 s).
    { intros s S; apply (at_same _ _ s) in SAME; unfold prod in SAME.
      rewrite at_times, !at_mult, at_ih, at_isigma in SAME; unfold rate.
      apply (Rmult_eq_reg_r (sigma (reals A0 s))); [| lra]; rewrite <- SAME; field; lra. }
    match goal with H : match bend c with _ => _ end = true |- _ => rename H into BEND end.
    destruct (bend c) as [[[re im] G] |]; [| apply andb_true_iff in BEND as [L BEND]].
    + exact (check_bend_sound _ A A0 d n1 d1 At re im G (claims c) EA POS R1 BEND).
    + intros x X; rewrite forallb_forall in BEND; specialize (BEND x X).
      destruct (check_angle _ _ _ _ _) eqn:CH in BEND.
      2: { apply (check_exact_sound _ _ _ _ _ _ (rate (reals A0) (reals (derived_curve A0)))) in BEND.
           - destruct BEND as [C V]; split; [| exact V].
             intros s S; rewrite <- at_isigma; exact (C s S).
           - intros s S P; rewrite at_isigma in S; rewrite <- (R1 s S); field; lra. }
      clear BEND; rename CH into BEND.
      apply (check_angle_sound _ _ _ _ _ (rate (reals A0) (reals (derived_curve A0)))) in BEND.
      * destruct BEND as [C V]; split; [| exact V].
        intros s S; rewrite <- at_isigma; apply (C s S); simpl; auto.
      * apply Nat.eqb_eq, L.
      * simpl; auto.
      * intros s C; apply R1; rewrite <- at_isigma; apply C; simpl; auto.
Qed.

(* If all is accepted, all is true. *)
Theorem accept_sound c : accept c = true -> statement c.
Proof. intro H; do 2 eexists; exact (accept_within_sound _ c H). Qed.

Print Assumptions accept_sound.
