(** Tangent operators: the twist, the body twist and their inverses, for every map and for Cayley maps.

    A moving vector is v + ε v' over the dual numbers of [K], where ε² = 0; its tensor is then R + ε R'. The scalars f, g
    and h of x = v·v belong to one map when the dual parts of f and g are ((1 - g x) h - f g) y and (f h - g²) y, where
    y = v·v'. *)

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
  Theorem twist_is_vect half (R : Tensor (dual K)) omega : half * 2 = 1 -> tmul (tre R) (transpose (tre R)) = identity ->
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
      (((1 - cayley_g (S n) power v * dot v v) * cayley_h (S n) power v - cayley_f (S n) power v * cayley_g (S n) power v)
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
End Cayley.
