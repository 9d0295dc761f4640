(** Multiples of an angle, the screw, branches of one pose, and composition at orders 1 and 2. *)

From dualcay Require Export Displacements.

Section Angles.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (r x a b t : K) (u v : Vector K).

  (** Cosine and sine of n θ, by the addition law, from those of θ. *)
  Fixpoint cosine a b (n : nat) : K := match n with O => 1 | S m => a * cosine a b m - b * sine a b m end
  with sine a b (n : nat) : K := match n with O => 0 | S m => a * sine a b m + b * cosine a b m end.

  Theorem cosine_next a b n : cosine a b (S n) = a * cosine a b n - b * sine a b n. Proof. easy. Qed.
  Theorem sine_next a b n : sine a b (S n) = a * sine a b n + b * cosine a b n. Proof. easy. Qed.

  Theorem circle a b n : a * a + b * b = 1 -> cosine a b n * cosine a b n + sine a b n * sine a b n = 1.
  Proof.
    intros H. induction n as [|n E]; [cbn; ring|]. rewrite cosine_next, sine_next.
    combine ((cosine a b n * cosine a b n + sine a b n * sine a b n) *: H +: 1 *: E).
  Qed.

  (** Addition law and double angle. *)
  Theorem angle_addition a b m n : cosine a b (m + n) = cosine a b m * cosine a b n - sine a b m * sine a b n /\
    sine a b (m + n) = sine a b m * cosine a b n + cosine a b m * sine a b n.
  Proof.
    induction m as [|m [E F]]; [cbn; split; ring|]. cbn [Nat.add]. rewrite !cosine_next, !sine_next, E, F. split; ring.
  Qed.

  Theorem double_angle a b n : a * a + b * b = 1 -> cosine a b (n + n) = 1 - 2 * (sine a b n * sine a b n) /\
    sine a b (n + n) = 2 * (sine a b n * cosine a b n).
  Proof.
    intros H%(circle a b n). destruct (angle_addition a b n n) as [-> ->]. split; [combine (1 *: H)|ring].
  Qed.

  (** p_n = cos(n θ) / cos(θ)^n and q_n = sin(n θ) / (cos(θ)^n tan(θ)) at x = tan²(θ), with t = tan θ. *)
  Theorem multiples_of_an_angle a b t n : a * t = b ->
    pow a n * p (t * t) n = cosine a b n /\ pow a n * (t * q (t * t) n) = sine a b n.
  Proof.
    intros <-. induction n as [|n [E F]]; [cbn; split; ring|]. rewrite cosine_next, sine_next, <- E, <- F. next.
    split; ring.
  Qed.

  (** Quaternion and tensor of a screw, CP23 (17), (23), (37), (48): with v = tan(θ) u and α = 2 n θ they are
      cos(n θ) + sin(n θ) u and I + sin(α) skew(u) + (1 - cos(α)) skew(u)². *)
  Theorem screw_quaternion a b t u n : a * t = b -> dot u u = 1 ->
    cayley_quaternion n (pow a n) (vscale t u) = quaternion (cosine a b n) (sine a b n) u.
  Proof.
    intros H U. destruct (multiples_of_an_angle a b t n H) as [<- <-]. unfold cayley_quaternion.
    replace (dot (vscale t u) (vscale t u)) with (t * t * dot u u) by (unfold dot; cbn; ring). rewrite U.
    replace (t * t * 1) with (t * t) by ring. entries; ring.
  Qed.

  Theorem screw_tensor a b t u n : a * a + b * b = 1 -> a * t = b -> dot u u = 1 ->
    cayley_tensor n (pow a n * pow a n) (vscale t u) = rotation (sine a b (n + n)) (1 - cosine a b (n + n)) u.
  Proof.
    intros C H U. destruct (double_angle a b n C) as [-> ->]. destruct (multiples_of_an_angle a b t n H) as [<- <-].
    unfold cayley_tensor, cayley_f, cayley_g. rewrite rotation_scaled.
    replace (dot (vscale t u) (vscale t u)) with (t * t * dot u u) by (unfold dot; cbn; ring). rewrite U.
    replace (t * t * 1) with (t * t) by ring. f_equal; ring.
  Qed.

  (** Moebius step: r_k = tan(θ + β) from r = tan(θ), where a and b are cosine and sine of β. *)
  Theorem moebius_step a b r r_k n : (a - b * r) * r_k = b + a * r ->
    pow (a - b * r) n * p (r_k * r_k) n = p (r * r) n * cosine a b n - r * q (r * r) n * sine a b n /\
    pow (a - b * r) n * (r_k * q (r_k * r_k) n) = p (r * r) n * sine a b n + r * q (r * r) n * cosine a b n.
  Proof.
    intros H. induction n as [|n [E F]]; [cbn; split; ring|]. rewrite cosine_next, sine_next. next. split.
    - combine ((a - b * r) *: E +: - ((a - b * r) * r_k) *: F
        +: - (p (r * r) n * sine a b n + r * q (r * r) n * cosine a b n) *: H).
    - combine ((a - b * r) * r_k *: E +: (a - b * r) *: F
        +: (p (r * r) n * cosine a b n - r * q (r * r) n * sine a b n) *: H).
  Qed.

  (** Slope of a Moebius step: (a - b r)² (1 + r_k²) = 1 + r² and (a - b r)² r_k' = r'. *)
  Theorem moebius_slope a b r r_k (r' r_k' : K) : a * a + b * b = 1 ->
    (constant a - constant b * (Dual r r' : dual K)) * (Dual r_k r_k' : dual K) =
      constant b + constant a * (Dual r r' : dual K) ->
    (a - b * r) * (a - b * r) * (1 + r_k * r_k) = 1 + r * r /\ (a - b * r) * (a - b * r) * r_k' = r'.
  Proof.
    intros C E. apply (f_equal re) in E as H. apply (f_equal du) in E. cbn in E, H. split.
    - combine (((a - b * r) * r_k + b + a * r) *: H +: (1 + r * r) *: C).
    - combine ((a - b * r) *: E +: b * r' *: H +: r' *: C).
  Qed.

  (** Branches: after a step by β with sin(n β) = 0, the vector r_k u has the pose of r u. *)
  Theorem shadow a b r r_k step_inverse power u n : dot u u = 1 -> a * a + b * b = 1 ->
    (a - b * r) * r_k = b + a * r -> (a - b * r) * step_inverse = 1 -> sine a b n = 0 ->
    power * pow (1 + r * r) n = 1 ->
    cayley_tensor n (power * (pow (a - b * r) n * pow (a - b * r) n)) (vscale r_k u) =
      cayley_tensor n power (vscale r u)
    /\ power * (pow (a - b * r) n * pow (a - b * r) n) * pow (1 + r_k * r_k) n = 1.
  Proof.
    intros U C H I Z P. pose proof (circle a b n C) as Q. rewrite Z in Q.
    destruct (moebius_step a b r r_k n H) as [E F]. rewrite Z in E, F. split.
    - unfold cayley_tensor, cayley_f, cayley_g. rewrite !rotation_scaled.
      replace (dot (vscale r_k u) (vscale r_k u)) with (r_k * r_k * dot u u) by (unfold dot; cbn; ring).
      replace (dot (vscale r u) (vscale r u)) with (r * r * dot u u) by (unfold dot; cbn; ring). rewrite U.
      replace (r_k * r_k * 1) with (r_k * r_k) by ring. replace (r * r * 1) with (r * r) by ring.
      set (P_k := p (r_k * r_k) n) in *. set (Q_k := q (r_k * r_k) n) in *.
      f_equal.
      + transitivity (2 * power * (pow (a - b * r) n * P_k * (pow (a - b * r) n * (r_k * Q_k)))); [ring|]. rewrite E, F.
        combine (2 * power * (p (r * r) n * r * q (r * r) n) *: Q).
      + transitivity (2 * power * (pow (a - b * r) n * (r_k * Q_k) * (pow (a - b * r) n * (r_k * Q_k)))); [ring|].
        rewrite F.
        combine (2 * power * (r * q (r * r) n * (r * q (r * r) n)) *: Q).
    - transitivity (power * pow (1 + r * r) n); [|exact P].
      replace (1 + r * r) with ((a - b * r) * (a - b * r) * (1 + r_k * r_k)); [rewrite !pow_mul_base; ring|].
      combine (((a - b * r) * r_k + b + a * r) *: H +: (1 + r * r) *: C).
  Qed.
End Angles.

Section Composition.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (u v a b : Vector K).

  (** Composition at n = 1, CP23 (45), with the inverse of 1 - b1·b2. *)
  Theorem composition_first_order b2 b1 inverse : (1 - dot b1 b2) * inverse = 1 ->
    qmul (Quat 1 b2) (Quat 1 b1) = qscale (1 - dot b1 b2) (Quat 1 (vscale inverse (vadd (vadd (cross b2 b1) b2) b1))).
  Proof.
    intros H. unfold dot in *. entries.
    - ring.
    - combine (- (v2 b2 * v3 b1 - v3 b2 * v2 b1 + v1 b2 + v1 b1) *: H).
    - combine (- (v3 b2 * v1 b1 - v1 b2 * v3 b1 + v2 b2 + v2 b1) *: H).
    - combine (- (v1 b2 * v2 b1 - v2 b2 * v1 b1 + v3 b2 + v3 b1) *: H).
  Qed.

  (** Composition at n = 2, CP23 (41): numerator, denominator and their relation. *)
  Definition numerator a b :=
    vadd (vadd (vscale 2 (cross a b)) (vscale (1 - dot a a) b)) (vscale (1 - dot b b) a).
  Definition denominator a b := dot (cross a b) (cross a b) + (1 - dot a b) * (1 - dot a b).

  Lemma denominator_relation a b :
    denominator a b * denominator a b + dot (numerator a b) (numerator a b) =
    (1 + dot a a) * (1 + dot b b) * denominator a b.
  Proof. unfold denominator, numerator, dot. cbn. unfold dot. ring. Qed.

  Lemma product_of_squares a b :
    qmul (qpow (Quat 1 a) 2) (qpow (Quat 1 b) 2) =
    Quat (2 * denominator a b - (1 + dot a a) * (1 + dot b b)) (vscale 2 (numerator a b)).
  Proof. unfold denominator, numerator. entries; ring. Qed.

  Theorem composition_second_order s2 s1 inverse : denominator s2 s1 * inverse = 1 ->
    let s := vscale inverse (numerator s2 s1) in
    qscale (1 + dot s s) (qmul (qpow (Quat 1 s2) 2) (qpow (Quat 1 s1) 2)) =
    qscale ((1 + dot s1 s1) * (1 + dot s2 s2)) (qpow (Quat 1 s) 2).
  Proof.
    intros H s. set (D := denominator s2 s1) in *. set (N := numerator s2 s1) in *.
    set (m := (1 + dot s2 s2) * (1 + dot s1 s1)). pose proof (denominator_relation s2 s1) as R. fold D N m in R.
    assert (L : dot s s = inverse * inverse * dot N N) by (unfold s, dot; cbn; ring).
    assert (E : 1 + dot s s = inverse * m).
    { rewrite L. combine (inverse * inverse *: R +: (m * inverse - (D * inverse + 1)) *: H). }
    rewrite product_of_squares, E. fold D N m. replace ((1 + dot s1 s1) * (1 + dot s2 s2)) with m by (unfold m; ring).
    assert (Q : qpow (Quat 1 s) 2 = Quat (2 - inverse * m) (vscale (2 * inverse) N)).
    { rewrite <- E. unfold s. entries; ring. }
    rewrite Q. clearbody D N. entries; [combine (2 * m *: H)|ring..].
  Qed.
End Composition.
