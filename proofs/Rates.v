(** Poses, lines and products; derivatives of the tangent operators, their Jacobians and the structure equation.

    Slopes are twice the derivatives by x: the dual part of f at v + ε v' is the slope of f times v·v'. *)

From dualcay Require Export Kinematics.

Section Poses.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (Q : Tensor K) (a r rho omega : Vector K) (M : Tensor (dual K)).

  (** R(V) = (I + ε skew(ρ)) Q, CP23 (14): with dual numbers as scalars a twist is a displacement ρ = T v°. *)
  Theorem pose M rho : is_twist M rho -> M = tmul (tdual identity (skew rho)) (tdual (tre M) (tscale 0 identity)).
  Proof.
    intros E. transitivity (tdual (tre M) (tdu M)); [entries; now apply dual_eq|]. rewrite E.
    apply tensor_eq; apply dual_eq; cbn; unfold dot; cbn; ring.
  Qed.

  (** A line with direction a through the point r is moved to direction Q a through ρ + Q r. *)
  Theorem line Q rho a r : tmul Q (transpose Q) = identity -> det Q = 1 ->
    apply (tmul (tdual identity (skew rho)) (tdual Q (tscale 0 identity))) (vdual a (cross r a)) =
    vdual (apply Q a) (cross (vadd rho (apply Q r)) (apply Q a)).
  Proof.
    intros O D. pose proof (f_equal (fun A => apply A a) (skew_carried K Q r O D)) as E.
    cbn beta in E. rewrite !apply_product, !skew_applied in E.
    transitivity (vdual (apply Q a) (vadd (cross rho (apply Q a)) (apply Q (cross r a)))).
    - apply vector_eq; apply dual_eq; cbn; repeat (unfold dot; cbn); ring.
    - rewrite <- E. apply vector_eq; apply dual_eq; cbn; repeat (unfold dot; cbn); ring.
  Qed.

  (** Twist of a product: ω = ω2 + R2 ω1. *)
  Theorem twist_of_a_product M2 M1 omega2 omega1 : tmul (tre M2) (transpose (tre M2)) = identity -> det (tre M2) = 1 ->
    is_twist M2 omega2 -> is_twist M1 omega1 -> is_twist (tmul M2 M1) (vadd omega2 (apply (tre M2) omega1)).
  Proof.
    unfold is_twist. intros O D E F. destruct (parts_of_product K M2 M1) as [-> ->]. rewrite E, F.
    pose proof (skew_carried K _ omega1 O D) as C. rewrite <- (tmul_assoc _ (tre M2) (skew omega1)), <- C.
    entries; ring.
  Qed.
End Poses.

Section Operators.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (f g h half fi hi : K) (v u a b : Vector K).

  (** Rate of an operator f I + g skew(v) + h v ⊗ v, with the slopes f_y, g_y, h_y. *)
  Definition operator_rate f_y g_y g h_y h v v' :=
    tadd (tscale (dot v v') (isotropic f_y g_y h_y v))
      (tadd (tscale g (skew v')) (tscale h (tadd (dyad v' v) (dyad v v')))).

  Theorem rate_of_operator f f_y g g_y h h_y v v' :
    tdu (isotropic (Dual f (f_y * dot v v') : dual K) (Dual g (g_y * dot v v')) (Dual h (h_y * dot v v')) (vdual v v')) =
    operator_rate f_y g_y g h_y h v v'.
  Proof. entries; ring. Qed.

  (** T (T⁻¹)' = -T' T⁻¹. *)
  Theorem rate_of_inverse (T T_inverse : Tensor (dual K)) : tmul T T_inverse = identity ->
    tmul (tre T) (tdu T_inverse) = tscale (- (1)) (tmul (tdu T) (tre T_inverse)).
  Proof.
    intros E. destruct (parts_of_product K T T_inverse) as [_ P]. rewrite E in P.
    apply (tadd_cancel K _ _ (tmul (tdu T) (tre T_inverse))). rewrite <- P. entries; ring.
  Qed.

  (** Jacobian of a v-dependent operator applied to a: T' a = J(a) v'. *)
  Definition jacobian f_y g_y g h_y h v a :=
    tadd (dyad (apply (isotropic f_y g_y h_y v) a) v)
      (tadd (tscale (- g) (skew a)) (tscale h (tadd (tscale (dot v a) identity) (dyad v a)))).

  Theorem jacobian_of_operator f_y g_y g h_y h v v' a :
    apply (operator_rate f_y g_y g h_y h v v') a = apply (jacobian f_y g_y g h_y h v a) v'.
  Proof. entries; ring. Qed.

  (** The same for the transposed operator. *)
  Theorem jacobian_of_transpose f_y g_y g h_y h v v' a :
    apply (transpose (operator_rate f_y g_y g h_y h v v')) a = apply (jacobian f_y (- g_y) (- g) h_y h v a) v'.
  Proof. entries; ring. Qed.

  (** Structure equation: J(b) a - J(a) b = (T a) × (T b), for the slopes of one map. *)
  Theorem structure_equation f g h h_y v a b : f * f + dot v v * (g * g) = 2 * g ->
    let f_y := (1 - g * dot v v) * h - f * g in
    let g_y := f * h - g * g in
    vsub (apply (jacobian f_y g_y g h_y h v b) a) (apply (jacobian f_y g_y g h_y h v a) b) =
    cross (apply (tangent f g h v) a) (apply (tangent f g h v) b).
  Proof.
    intros H. unfold dot in H. cbv zeta. unfold tangent. entries.
    - combine (- (v2 a * v3 b - v3 a * v2 b) *: H).
    - combine (- (v3 a * v1 b - v1 a * v3 b) *: H).
    - combine (- (v1 a * v2 b - v2 a * v1 b) *: H).
  Qed.

  (** In the body: J_B(b) a - J_B(a) b = -(T^T a) × (T^T b). *)
  Theorem body_structure_equation f g h h_y v a b : f * f + dot v v * (g * g) = 2 * g ->
    let f_y := (1 - g * dot v v) * h - f * g in
    let g_y := f * h - g * g in
    vsub (apply (jacobian f_y (- g_y) (- g) h_y h v b) a) (apply (jacobian f_y (- g_y) (- g) h_y h v a) b) =
    vscale (- (1)) (cross (apply (transpose (tangent f g h v)) a) (apply (transpose (tangent f g h v)) b)).
  Proof.
    intros H. unfold dot in H. cbv zeta. unfold tangent. entries.
    - combine ((v2 a * v3 b - v3 a * v2 b) *: H).
    - combine ((v3 a * v1 b - v1 a * v3 b) *: H).
    - combine ((v1 a * v2 b - v2 a * v1 b) *: H).
  Qed.
End Operators.

Section Slopes.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (x y power power_slope u q_inverse n_inverse : K).

  (** Second slopes of p_n and q_n, and the slopes of c_n and d_n. *)
  Fixpoint p_curvature x n : K := match n with
    | O => 0
    | S m => p_curvature x m - 2 * q_slope x m - x * q_curvature x m
    end
  with q_curvature x n : K := match n with O => 0 | S m => p_curvature x m + q_curvature x m end.
  Definition c_slope x n := 2 * (p x n * q_curvature x n - q x n * p_curvature x n).
  Definition d_slope x n := q_slope x n - 2 * q_curvature x n - 2 * p_curvature x n.

  Lemma p_curvature_next x n : p_curvature x (S n) = p_curvature x n - 2 * q_slope x n - x * q_curvature x n.
  Proof. easy. Qed.
  Lemma q_curvature_next x n : q_curvature x (S n) = p_curvature x n + q_curvature x n. Proof. easy. Qed.

  Theorem curvatures_are_dual_parts x y n :
    p_slope (Dual x y : dual K) n = Dual (p_slope x n) (p_curvature x n * y) /\
    q_slope (Dual x y : dual K) n = Dual (q_slope x n) (q_curvature x n * y).
  Proof.
    induction n as [|n [E F]]; [split; apply dual_eq; cbn; ring|].
    rewrite p_curvature_next, q_curvature_next. next. rewrite E, F, (proj2 (slopes_are_dual_parts K x y n)).
    split; apply dual_eq; cbn; ring.
  Qed.

  Theorem bracket_slopes x y n :
    c (Dual x y : dual K) n = Dual (c x n) (c_slope x n * y) /\ d (Dual x y : dual K) n =
      Dual (d x n) (d_slope x n * y).
  Proof.
    unfold c, d. destruct (slopes_are_dual_parts K x y n) as [-> ->].
      destruct (curvatures_are_dual_parts x y n) as [-> ->].
    split; apply dual_eq; unfold c, d, c_slope, d_slope; cbn; ring.
  Qed.

  (** Slopes of f, g and h, at the inverse [power] of (1 + x)^n and the inverse [u] of 1 + x. *)
  Theorem tangent_slopes n x y power (power' : K) u : (1 + x) * u = 1 ->
    (Dual power power' : dual K) * pow (1 + (Dual x (2 * y) : dual K)) (S n) = 1 ->
    let X : dual K := Dual x (2 * y) in
    let W : dual K := Dual power power' in
    let f := 2 * (p x (S n) * q x (S n) * power) in
    let g := 2 * (q x (S n) * q x (S n) * power) in
    let h := 2 * (c x (S n) * power) in
    2 * (p X (S n) * q X (S n) * W) = Dual f ((h - 2 * (of_nat (S n) * u * g)) * y) /\
    2 * (q X (S n) * q X (S n) * W) =
      Dual g ((4 * (2 * (q x (S n) * q_slope x (S n) * power)) - 2 * (of_nat (S n) * u * g)) * y) /\
    2 * (c X (S n) * W) = Dual h ((4 * (c_slope x (S n) * power) - 2 * (of_nat (S n) * u * h)) * y).
  Proof.
    intros U H X W f g h. apply power_slope in H as [H E]. pose proof (p_slope_equation K x (S n)) as P.
    assert (E' : power' = - (2 * (of_nat (S n) * u * y * power))).
    { rewrite E. cbn [pow] in H. combine (2 * (of_nat (S n) * pow (1 + x) n * y * power * power) *: U
        +: - (2 * (of_nat (S n) * u * y * power)) *: H). }
    unfold X, W, f, g, h. destruct (slopes_are_dual_parts K x (2 * y) (S n)) as [-> ->].
    rewrite (proj1 (bracket_slopes x (2 * y) (S n))), E'. repeat split; apply dual_eq;
      cbn [re du mul add dual dual_mul dual_add one];
      try ring.
    unfold c. combine (4 * (q x (S n) * power * u * y) *: P +:
      - (4 * (2 * (q x (S n) * p_slope x (S n) * power * y))) *: U).
  Qed.

  (** Slopes of the scalars of the inverse operator, p / q and d / (n q). *)
  Theorem inverse_slopes n x y q_inverse (q_inverse' : K) n_inverse :
    q (Dual x (2 * y) : dual K) n * (Dual q_inverse q_inverse' : dual K) = 1 ->
    p (Dual x (2 * y) : dual K) n * (Dual q_inverse q_inverse' : dual K) =
      Dual (p x n * q_inverse) (- (c x n * (q_inverse * q_inverse)) * y) /\
    d (Dual x (2 * y) : dual K) n * ((Dual q_inverse q_inverse' : dual K) * constant n_inverse) =
      Dual (d x n * (q_inverse * n_inverse))
        ((2 * d_slope x n - 2 * (d x n * q_slope x n * q_inverse)) * (q_inverse * n_inverse) * y).
  Proof.
    destruct (slopes_are_dual_parts K x (2 * y) n) as [-> ->]. rewrite (proj2 (bracket_slopes x (2 * y) n)). intros H.
    apply (f_equal re) in H as Q. apply (f_equal du) in H. cbn in H, Q.
    assert (E : q_inverse' = - (2 * (q_slope x n * (q_inverse * q_inverse) * y))).
    { combine (q_inverse *: H +: - q_inverse' *: Q). }
    rewrite E. split; apply dual_eq; cbn; try ring. unfold c. combine (- (2 * (p_slope x n * q_inverse * y)) *: Q).
  Qed.
End Slopes.
