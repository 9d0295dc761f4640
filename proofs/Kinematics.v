(** Tangent operators: the twist, the body twist and their inverses, for every map and for Cayley maps.

    A moving vector is v + ε v' over the dual numbers of [K], where ε² = 0; its tensor is then R + ε R'.
    The scalars f, g and h of x = v·v belong to one map when the dual parts of f and g are ((1 - g x) h - f g) y and
    (f h - g²) y, where y = v·v'. *)

From dualcay Require Export Displacements.

Section Definitions.
  Context {K : CommutativeRing}.
  Implicit Types (f g h fi hi half power : K) (v : Vector K).

  Definition tangent f g h v := isotropic f g h v.
  Definition tangent_inv half fi hi v := isotropic (half * fi) (- half) (half * hi) v.

  (** Cayley map of order n: [power], [q_inverse] and [n_inverse] are the inverses of (1 + x)^n, q and n. *)
  Definition cayley_h n power v := 2 * (c (dot v v) n * power).
  Definition dcay n power v := tangent (cayley_f n power v) (cayley_g n power v) (cayley_h n power v) v.
  Definition dcay_inv half n q_inverse n_inverse v :=
    tangent_inv half (p (dot v v) n * q_inverse) (d (dot v v) n * (q_inverse * n_inverse)) v.

  (** Twist of a moving tensor with dual part R': R' = skew(ω) R. *)
  Definition is_twist (R : Tensor (dual K)) (omega : Vector K) := tdu R = tmul (skew omega) (tre R).
  Definition is_body_twist (R : Tensor (dual K)) (omega : Vector K) := tdu R = tmul (tre R) (skew omega).
End Definitions.

Section AnyMap.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (f g h half fi hi : K) (v u : Vector K) (R A B : Tensor K).

  Lemma tadd_cancel A B C : tadd A C = tadd B C -> A = B.
  Proof.
    intros E. apply tensor_eq; [ apply (f_equal t11) in E | apply (f_equal t12) in E | apply (f_equal t13) in E
      | apply (f_equal t21) in E | apply (f_equal t22) in E | apply (f_equal t23) in E
      | apply (f_equal t31) in E | apply (f_equal t32) in E | apply (f_equal t33) in E ]; cbn in E; combine (1 *: E).
  Qed.

  (** A tensor with R R^T = I and det R = 1 carries skew tensors along: skew(R u) R = R skew(u). *)
  Theorem skew_carried R u : tmul R (transpose R) = identity -> det R = 1 ->
    tmul (skew (apply R u)) R = tmul R (skew u).
  Proof.
    intros O D.
    assert (E : tmul (transpose R) (tmul (skew (apply R u)) R) = tscale (det R) (skew u)) by (entries; ring).
    rewrite D in E. apply (f_equal (tmul R)) in E. rewrite <- tmul_assoc, O in E.
    rewrite (proj2 (tmul_identity _ _)) in E. rewrite E. entries; ring.
  Qed.

  (** The twist ω of R' = skew(ω) R is the vector of R' R^T. *)
  Theorem twist_is_vect half (R : Tensor (dual K)) omega : half * 2 = 1 ->
    tmul (tre R) (transpose (tre R)) = identity ->
    is_twist R omega -> vect half (tmul (tdu R) (transpose (tre R))) = omega.
  Proof. intros H O ->. rewrite tmul_assoc, O, (proj1 (tmul_identity _ _)). now apply vect_skew. Qed.

  (** Twists are unique. *)
  Theorem twist_unique half (R : Tensor (dual K)) a b : half * 2 = 1 -> tmul (tre R) (transpose (tre R)) = identity ->
    is_twist R a -> is_twist R b -> a = b.
  Proof. intros H O E F. now rewrite <- (twist_is_vect half R a H O E), (twist_is_vect half R b H O F). Qed.

  (** ω = T v', CP23 (86), with R' = skew(ω) R, CP23 (70). *)
  Theorem twist f g h v v' : f * f + dot v v * (g * g) = 2 * g ->
    is_twist (rotation (Dual f (((1 - g * dot v v) * h - f * g) * dot v v') : dual K)
                       (Dual g ((f * h - g * g) * dot v v')) (vdual v v'))
             (apply (tangent f g h v) v').
  Proof.
    intros H. apply (tadd_cancel _ _ (tscale (2 * g) (tmul (skew v') (skew v)))). rewrite <- H at 1. unfold tangent.
    entries; ring.
  Qed.

  (** T^T = R^T T, and ω_B = T^T v', CP23 (86), with R' = R skew(ω_B), CP23 (74). *)
  Theorem body_tangent f g h v : f * f + dot v v * (g * g) = 2 * g ->
    transpose (tangent f g h v) = tmul (transpose (rotation f g v)) (tangent f g h v).
  Proof.
    intros H. unfold tangent. rewrite rotation_isotropic, !isotropic_transpose, isotropic_product.
    generalize dependent (dot v v). intros x H. f_equal; [ring|combine (1 *: H)|ring].
  Qed.

  Theorem body_twist R omega (M : Tensor (dual K)) : tre M = R -> tmul R (transpose R) = identity ->
    tmul (transpose R) R = identity -> det R = 1 -> is_twist M omega -> is_body_twist M (apply (transpose R) omega).
  Proof.
    intros <- O P D E. unfold is_body_twist. rewrite <- skew_carried by assumption.
    now rewrite <- apply_product, O, apply_identity.
  Qed.

  (** T T⁻¹ = T⁻¹ T = I. *)
  Theorem inverse half f g h fi hi v : half * 2 = 1 ->
    f * fi + g * dot v v = 2 -> g * fi = f -> f * hi + h * fi + dot v v * (h * hi) = g ->
    tmul (tangent f g h v) (tangent_inv half fi hi v) = identity /\
    tmul (tangent_inv half fi hi v) (tangent f g h v) = identity.
  Proof.
    intros H A B C. unfold tangent, tangent_inv. rewrite !isotropic_product, <- (isotropic_identity K v).
    generalize dependent (dot v v). intros x A C. split.
    all: f_equal; [combine (half *: A +: 1 *: H)|combine (half *: B)|combine (half *: C)].
  Qed.

  (** T v = (f + h x) v, and T^T v alike. *)
  Theorem axis f g h v :
    apply (tangent f g h v) v = vscale (f + h * dot v v) v /\
    apply (transpose (tangent f g h v)) v = vscale (f + h * dot v v) v.
  Proof. unfold tangent. rewrite isotropic_transpose. split; entries; ring. Qed.

  Theorem determinant f g h v : f * f + dot v v * (g * g) = 2 * g ->
    det (tangent f g h v) = 2 * ((f + h * dot v v) * g).
  Proof. intros H. unfold tangent. rewrite isotropic_det. combine ((f + h * dot v v) *: H). Qed.

  (** 2 q' = ω q, CP23 (75), for a quaternion s + w v with the slopes of one map. *)
  Theorem quaternion_rate s w h v v' s' w' : s * s + dot v v * (w * w) = 1 ->
    2 * s' = - ((2 * (s * w) + h * dot v v) * w * dot v v') -> 2 * w' = (h * s - 2 * (w * (w * w))) * dot v v' ->
    Quat (2 * s') (vadd (vscale (2 * w') v) (vscale (2 * w) v')) =
    qmul (Quat 0 (apply (tangent (2 * (s * w)) (2 * (w * w)) h v) v')) (quaternion s w v).
  Proof.
    intros H E F. rewrite E, F. replace (2 * w) with (2 * w * (s * s + dot v v * (w * w))) by (rewrite H; ring).
    unfold tangent. entries; ring.
  Qed.
End AnyMap.

Section Cayley.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (half power root q_inverse n_inverse u y x : K) (v omega : Vector K) (n : nat).

  (** The dual part of the inverse of (1 + X)^n at X = x + ε 2 y. *)
  Lemma power_slope n x y power (power' : K) :
    (Dual power power' : dual K) * pow (1 + (Dual x (2 * y) : dual K)) (S n) = 1 ->
    power * pow (1 + x) (S n) = 1 /\ power' = - (2 * (of_nat (S n) * pow (1 + x) n * y * (power * power))).
  Proof.
    intros E. rewrite dual_pow in E. cbn [re du add dual dual_add one] in E. change (re (1 : dual K)) with (1 : K) in E.
    change (du (1 : dual K)) with (0 : K) in E. apply (f_equal re) in E as F. apply (f_equal du) in E. cbn in E, F.
    cbn [of_nat pow]. split; [exact F|]. combine (power *: E +: - power' *: F).
  Qed.

  (** Dual parts of f and g: the Cayley scalars are those of one map. *)
  Theorem cayley_slopes n v v' power (power' : K) :
    (Dual power power' : dual K) * pow (1 + dot (vdual v v') (vdual v v')) (S n) = 1 ->
    cayley_f (S n) (Dual power power' : dual K) (vdual v v') = Dual (cayley_f (S n) power v)
      (((1 - cayley_g (S n) power v * dot v v) * cayley_h (S n) power v
        - cayley_f (S n) power v * cayley_g (S n) power v)
       * dot v v') /\
    cayley_g (S n) (Dual power power' : dual K) (vdual v v') = Dual (cayley_g (S n) power v)
      ((cayley_f (S n) power v * cayley_h (S n) power v - cayley_g (S n) power v * cayley_g (S n) power v) * dot v v').
  Proof.
    unfold cayley_f, cayley_g, cayley_h, c. rewrite parts_of_dot. intros [H E]%power_slope.
    rewrite <- (norm_slope K) in E. apply power_norm in H. generalize dependent (dot v v). generalize (dot v v').
    intros y x H E. destruct (slopes_are_dual_parts K x (2 * y) (S n)) as [-> ->]. subst power'.
    set (P := p x (S n)) in *. set (Q := q x (S n)) in *. set (P' := p_slope x (S n)). set (Q' := q_slope x (S n)).
    split; apply dual_eq; cbn [re du mul add dual dual_mul dual_add one]; try ring.
    - combine (- (4 * 2 * (Q * P') * power * y) *: H).
    - combine (- (4 * 2 * (Q * Q') * power * y) *: H).
  Qed.

  (** The real part of a dual tensor of order n is its tensor at the real part of v. *)
  Lemma real_part_of_tensor n v v' power (power' : K) :
    (Dual power power' : dual K) * pow (1 + dot (vdual v v') (vdual v v')) (S n) = 1 ->
    tre (cayley_tensor (S n) (Dual power power' : dual K) (vdual v v')) = cayley_tensor (S n) power v.
  Proof. intros [E F]%cayley_slopes. unfold cayley_tensor. rewrite E, F. entries; ring. Qed.

  Lemma real_part_of_power n v v' power (power' : K) :
    (Dual power power' : dual K) * pow (1 + dot (vdual v v') (vdual v v')) (S n) = 1 ->
      power * pow (1 + dot v v) (S n) = 1.
  Proof. rewrite parts_of_dot. intros H%power_slope. apply H. Qed.

  (** ω = dcay v', CP23 (86), with R' = skew(ω) R, CP23 (70). *)
  Theorem cayley_twist n v v' power (power' : K) :
    (Dual power power' : dual K) * pow (1 + dot (vdual v v') (vdual v v')) (S n) = 1 ->
    is_twist (cayley_tensor (S n) (Dual power power' : dual K) (vdual v v')) (apply (dcay (S n) power v) v').
  Proof.
    intros H. pose proof (cayley_unit _ _ _ _ (real_part_of_power _ _ _ _ _ H)) as U. apply cayley_slopes in H as [E F].
    unfold cayley_tensor. rewrite E, F; now apply twist.
  Qed.

  (** ω = vect(R' R^T). *)
  Theorem cayley_twist_is_vect half n v v' power (power' : K) : half * 2 = 1 ->
    (Dual power power' : dual K) * pow (1 + dot (vdual v v') (vdual v v')) (S n) = 1 ->
    vect half (tmul (tdu (cayley_tensor (S n) (Dual power power' : dual K) (vdual v v')))
                    (transpose (cayley_tensor (S n) power v))) = apply (dcay (S n) power v) v'.
  Proof.
    intros T H. rewrite <- (real_part_of_tensor _ _ _ _ _ H). apply twist_is_vect; [exact T| |now apply cayley_twist].
    rewrite (real_part_of_tensor _ _ _ _ _ H). apply cayley_orthogonal. eapply real_part_of_power, H.
  Qed.

  (** dcay^T = R^T dcay. *)
  Theorem cayley_body_tangent n power v : power * pow (1 + dot v v) n = 1 ->
    transpose (dcay n power v) = tmul (transpose (cayley_tensor n power v)) (dcay n power v).
  Proof. intros H. apply body_tangent, cayley_unit, H. Qed.

  (** ω_B = R^T ω = dcay^T v', CP23 (86), with R' = R skew(ω_B), CP23 (74). *)
  Theorem cayley_body_twist n v v' power (power' : K) :
    (Dual power power' : dual K) * pow (1 + dot (vdual v v') (vdual v v')) (S n) = 1 ->
    is_body_twist (cayley_tensor (S n) (Dual power power' : dual K) (vdual v v'))
      (apply (transpose (dcay (S n) power v)) v').
  Proof.
    intros H. pose proof (real_part_of_power _ _ _ _ _ H) as P. destruct (cayley_orthogonal _ _ _ _ P) as (O & T & D).
    rewrite cayley_body_tangent, apply_product by exact P.
    apply body_twist; [now apply real_part_of_tensor|assumption..|now apply cayley_twist].
  Qed.

  (** dcay, CP23 (88), with the bracket divided by x, and dcay⁻¹, CP23 (89), likewise. *)
  Theorem dcay_brackets n power v :
    tscale (dot v v) (dcay (S n) power v) = isotropic
      (dot v v * cayley_f (S n) power v) (dot v v * cayley_g (S n) power v)
      (2 * ((of_nat (S n) * pow (1 + dot v v) n - p (dot v v) (S n) * q (dot v v) (S n)) * power)) v.
  Proof. rewrite <- (bracket_c K). unfold dcay, tangent, cayley_h. entries; ring. Qed.

  Theorem dcay_inv_brackets half n q_inverse n_inverse v :
    tscale (dot v v) (dcay_inv half n q_inverse n_inverse v) = isotropic
      (dot v v * (half * (p (dot v v) n * q_inverse))) (- (dot v v * half))
      (half * (((1 + dot v v) * q (dot v v) n - of_nat n * p (dot v v) n) * (q_inverse * n_inverse))) v.
  Proof. rewrite <- (bracket_d K). unfold dcay_inv, tangent_inv. entries; ring. Qed.

  (** dcay dcay⁻¹ = dcay⁻¹ dcay = I. *)
  Theorem cayley_inverse half n power q_inverse n_inverse v : half * 2 = 1 -> power * pow (1 + dot v v) n = 1 ->
    q (dot v v) n * q_inverse = 1 -> of_nat n * n_inverse = 1 ->
    tmul (dcay n power v) (dcay_inv half n q_inverse n_inverse v) = identity /\
    tmul (dcay_inv half n q_inverse n_inverse v) (dcay n power v) = identity.
  Proof.
    intros T H%power_norm Q N. pose proof (brackets_related K (dot v v) n) as B.
    pose proof (bracket_d K (dot v v) n) as D. unfold dcay, dcay_inv. apply inverse; [exact T| | |];
    unfold cayley_f, cayley_g, cayley_h.
    - combine (2 * (p (dot v v) n * p (dot v v) n * power) *: Q +: 2 *: H).
    - combine (2 * (p (dot v v) n * q (dot v v) n * power) *: Q).
    - combine (2 * (p (dot v v) n * d (dot v v) n * power * n_inverse) *: Q
        +: - (2 * (c (dot v v) n * power * p (dot v v) n * q_inverse)) *: N
        +: 2 * (c (dot v v) n * power * q_inverse * n_inverse) *: D
        +: 2 * (c (dot v v) n * (1 + dot v v) * power * n_inverse) *: Q +: 2 * (power * n_inverse) *: B
        +: 2 * (power * q (dot v v) n * q (dot v v) n) *: N).
  Qed.

  (** Rates of v, CP23 (87), (90), (91): v' = dcay⁻¹ ω and v' = dcay⁻ᵀ ω_B. *)
  Theorem rates half n power q_inverse n_inverse v v' : half * 2 = 1 -> power * pow (1 + dot v v) n = 1 ->
    q (dot v v) n * q_inverse = 1 -> of_nat n * n_inverse = 1 ->
    apply (dcay_inv half n q_inverse n_inverse v) (apply (dcay n power v) v') = v' /\
    apply (transpose (dcay_inv half n q_inverse n_inverse v)) (apply (transpose (dcay n power v)) v') = v'.
  Proof.
    intros T H Q N. destruct (cayley_inverse half n power q_inverse n_inverse v T H Q N) as [A B].
    rewrite <- !apply_product, <- transpose_product, A, B. split; entries; ring.
  Qed.

  (** f + h x = 2 n / (1 + x), where [u] is the inverse of 1 + x. *)
  Lemma stretch n power u v : power * pow (1 + dot v v) (S n) = 1 -> (1 + dot v v) * u = 1 ->
    cayley_f (S n) power v + cayley_h (S n) power v * dot v v = 2 * (of_nat (S n) * u).
  Proof.
    intros H U. pose proof (bracket_c K (dot v v) n) as B. unfold cayley_f, cayley_h. cbn [pow] in H.
    combine (2 * power *: B +: 2 * (of_nat (S n) * u) *: H +: - (2 * (of_nat (S n) * power * pow (1 + dot v v) n)) 
      *: U).
  Qed.

  (** dcay v = dcay^T v = 2 n v / (1 + x). *)
  Theorem cayley_axis n power u v : power * pow (1 + dot v v) (S n) = 1 -> (1 + dot v v) * u = 1 ->
    apply (dcay (S n) power v) v = vscale (2 * (of_nat (S n) * u)) v /\
    apply (transpose (dcay (S n) power v)) v = vscale (2 * (of_nat (S n) * u)) v.
  Proof. intros H U. rewrite <- (stretch n power u v H U). apply axis. Qed.

  (** det dcay = 8 n q² / (1 + x)^(n+1). *)
  Theorem cayley_determinant n power u v : power * pow (1 + dot v v) (S n) = 1 -> (1 + dot v v) * u = 1 ->
    det (dcay (S n) power v) = 4 * (2 * (of_nat (S n) * (q (dot v v) (S n) * q (dot v v) (S n)) * (power * u))).
  Proof.
    intros H U. unfold dcay. rewrite determinant, (stretch n power u v H U) by now apply cayley_unit. unfold cayley_g.
      ring.
  Qed.

  (** 2 q' = ω q, CP23 (75), where the dual part of the root is that of a root of (1 + x)^-n. *)
  Theorem cayley_quaternion_rate half n v v' root (root' : K) : half * 2 = 1 ->
    (Dual root root' : dual K) * (Dual root root' : dual K) * pow (1 + dot (vdual v v') (vdual v v')) (S n) = 1 ->
    let moving := cayley_quaternion (S n) (Dual root root' : dual K) (vdual v v') in
    qscale 2 (Quat (du (scalar moving)) (vdu (vector moving))) =
    qmul (Quat 0 (apply (dcay (S n) (root * root) v) v')) (cayley_quaternion (S n) root v).
  Proof.
    intros T H. cbv zeta.
    set (x := dot v v) in *. set (y := dot v v'). set (m := of_nat (S n) * pow (1 + x) n).
    rewrite parts_of_dot in H. fold x y in H. apply power_slope in H as [H E]. cbn [re du] in H, E. fold m in E.
    pose proof (power_norm K _ _ _ H) as N. pose proof (p_slope_equation K x (S n)) as P.
    pose proof (norm_slope K x n) as M. pose proof (bracket_c K x n) as B. fold m in M, B.
    assert (R : root' = - (m * y * (root * root * root))).
    { combine (half * root * pow (1 + x) (S n) *: E +: - ((root' + m * y * (root * root * root)) * half * 2) *: H
        +: - (root' + m * y * (root * root * root)) *: T). }
    transitivity (Quat (2 * (p_slope x (S n) * (2 * y) * root + p x (S n) * root'))
      (vadd (vscale (2 * (q_slope x (S n) * (2 * y) * root + q x (S n) * root')) v)
            (vscale (2 * (q x (S n) * root)) v'))).
    { unfold cayley_quaternion. rewrite parts_of_dot. fold x y.
      destruct (slopes_are_dual_parts K x (2 * y) (S n)) as [-> ->]. entries; ring. }
    rewrite (quaternion_rate K (p x (S n) * root) (q x (S n) * root)
      (cayley_h (S n) (root * root) v) v v').
    - f_equal. f_equal. unfold dcay, cayley_f, cayley_g. fold x. f_equal. f_equal; ring.
    - apply cayley_quaternion_norm, H.
    - fold x y. unfold cayley_h. fold x. rewrite R. unfold m in *. cbn [pow] in *.
      combine (2 * (pow (1 + x) n * (root * root * root) * y) *: P
        +: - (4 * (p_slope x (S n) * y * root)) *: H
        +: 2 * (root * root * root * q x (S n) * y) *: B).
    - fold x y. unfold cayley_h, c. fold x. rewrite R.
      combine (2 * (q x (S n) * (root * root * root) * y) *: M
        +: - (4 * (q_slope x (S n) * root * y)) *: N).
  Qed.

  (** 2 q' = q ω_B, CP23 (76): with ω_B = R^T ω, q ω_B = ω q. *)
  Theorem cayley_body_quaternion_rate n root v omega : root * root * pow (1 + dot v v) n = 1 ->
    qmul (cayley_quaternion n root v) (Quat 0 (apply (transpose (cayley_tensor n (root * root) v)) omega)) =
    qmul (Quat 0 omega) (cayley_quaternion n root v).
  Proof.
    intros H. destruct (cayley_orthogonal _ _ _ _ H) as [O _].
    pose proof (cayley_sandwich K n root v (apply (transpose (cayley_tensor n (root * root) v)) omega) H) as S.
    rewrite <- apply_product, O, apply_identity in S.
      apply (f_equal (fun r => qmul r (cayley_quaternion n root v))) in S.
    rewrite <- S, !qmul_assoc.
    assert (U : qmul (conj (cayley_quaternion n root v)) (cayley_quaternion n root v) = qone).
    { rewrite <- (cayley_quaternion_unit K n root v H). entries; ring. }
    now rewrite U, (proj1 (qmul_one _ _)).
  Qed.
End Cayley.
