(** Dual quaternion and orthogonal dual tensor of a vector v, for every map and for the Cayley map of order n.

    A map is given by the scalars s and w of its quaternion s + w v, with s² + x w² = 1 and x = v·v. Its tensor has
    f = 2 s w and g = 2 w², so that f² + x g² = 2 g. The Cayley map of order n needs the inverse of (1 + x)^n only. *)

From dualcay Require Export Tensors Polynomials.

Section Definitions.
  Context {K : CommutativeRing}.
  Implicit Types (s w f g : K) (v : Vector K) (r : Quaternion K).

  Definition quaternion s w v := Quat s (vscale w v).
  Definition rotation f g v := tadd (tadd identity (tscale f (skew v))) (tscale g (tmul (skew v) (skew v))).

  (** Cayley map of order n; [power] is the inverse of (1 + x)^n, and [root] its square root. *)
  Definition cayley_f n power v := 2 * (p (dot v v) n * q (dot v v) n * power).
  Definition cayley_g n power v := 2 * (q (dot v v) n * q (dot v v) n * power).
  Definition cayley_tensor n power v := rotation (cayley_f n power v) (cayley_g n power v) v.
  Definition cayley_quaternion n root v := quaternion (p (dot v v) n * root) (q (dot v v) n * root) v.

  Definition norm_squared r := scalar r * scalar r + dot (vector r) (vector r).

  (** Tensor of a unit quaternion, CP23 (24). *)
  Definition tensor_of r := rotation (2 * scalar r) 2 (vector r).
End Definitions.

Section Laws.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (s w f g power root : K) (v u : Vector K) (r : Quaternion K).

  Theorem rotation_isotropic f g v : rotation f g v = isotropic (1 - g * dot v v) f g v.
  Proof. entries; ring. Qed.

  (** A factor of the vector may be moved to f and g. *)
  Theorem rotation_scaled f g k v : rotation f g (vscale k v) = rotation (f * k) (g * (k * k)) v.
  Proof. entries; ring. Qed.

  (** R is orthogonal with determinant 1, CP23 (13), (72), (73). *)
  Theorem rotation_orthogonal f g v : f * f + dot v v * (g * g) = 2 * g ->
    tmul (rotation f g v) (transpose (rotation f g v)) = identity /\
    tmul (transpose (rotation f g v)) (rotation f g v) = identity /\ det (rotation f g v) = 1.
  Proof.
    intros H. rewrite rotation_isotropic, isotropic_transpose, !isotropic_product, isotropic_det.
    rewrite <- (isotropic_identity K v).
    generalize dependent (dot v v); intros x H. split; [|split].
    - f_equal; [combine (x *: H)|ring|combine (- (1) *: H)].
    - f_equal; [combine (x *: H)|ring|combine (- (1) *: H)].
    - combine (x *: H).
  Qed.

  (** The quaternion has norm 1, and q r q* = R r. *)
  Theorem quaternion_unit s w v : s * s + dot v v * (w * w) = 1 ->
    qmul (quaternion s w v) (conj (quaternion s w v)) = qone.
  Proof. intros H. unfold dot in H. entries; [combine (1 *: H)|ring..]. Qed.

  Theorem sandwich s w v u : s * s + dot v v * (w * w) = 1 ->
    qmul (qmul (quaternion s w v) (Quat 0 u)) (conj (quaternion s w v)) =
    Quat 0 (apply (rotation (2 * (s * w)) (2 * (w * w)) v) u).
  Proof.
    intros H. rewrite rotation_isotropic.
    replace (1 - 2 * (w * w) * dot v v) with (s * s - dot v v * (w * w)) by combine (1 *: H).
    entries; ring.
  Qed.

  Theorem scalars_of_unit s w v : s * s + dot v v * (w * w) = 1 ->
    2 * (s * w) * (2 * (s * w)) + dot v v * (2 * (w * w) * (2 * (w * w))) = 2 * (2 * (w * w)).
  Proof. intros H. combine (4 * (w * w) *: H). Qed.

  Lemma unit_parts r : qmul r (conj r) = qone -> norm_squared r = 1.
  Proof.
    intros H%(f_equal scalar). unfold norm_squared, dot. cbn in H. unfold dot in H. cbn in H. combine (1 *: H).
  Qed.

  Lemma norm_of_product q r : norm_squared (qmul q r) = norm_squared q * norm_squared r.
  Proof. unfold norm_squared. entries. ring. Qed.

  (** The tensor of a product of unit quaternions is the product of their tensors, CP23 (24). *)
  Theorem composition_of_tensors r2 r1 : qmul r2 (conj r2) = qone -> qmul r1 (conj r1) = qone ->
    tensor_of (qmul r2 r1) = tmul (tensor_of r2) (tensor_of r1).
  Proof.
    intros H%unit_parts G%unit_parts. pose proof (norm_of_product r2 r1) as N. rewrite H, G in N.
    assert (parts : forall r, norm_squared r = 1 -> tensor_of r =
      isotropic (scalar r * scalar r - dot (vector r) (vector r)) (2 * scalar r) 2 (vector r)).
    { unfold tensor_of, norm_squared. intros r E. rewrite rotation_isotropic. f_equal. combine (- (1) *: E). }
    rewrite !parts by (assumption || combine (1 *: N)). entries; ring.
  Qed.

  (** Powers of 1 + v are p_n + q_n v. *)
  Theorem quaternion_powers v n : qpow (Quat 1 v) n = quaternion (p (dot v v) n) (q (dot v v) n) v.
  Proof.
    induction n as [|n E]; [entries; ring|]. cbn [qpow]. rewrite E. unfold quaternion. next.
    apply quaternion_eq; [|apply vector_eq]; cbn; unfold dot; cbn; ring.
  Qed.

  (** p² + x q² in the scalars of the Cayley map. *)
  Theorem power_norm n x power : power * pow (1 + x) n = 1 -> power * (p x n * p x n + x * (q x n * q x n)) = 1.
  Proof. now rewrite norm. Qed.

  Theorem cayley_unit n power v : power * pow (1 + dot v v) n = 1 ->
    cayley_f n power v * cayley_f n power v + dot v v * (cayley_g n power v * cayley_g n power v) =
      2 * cayley_g n power v.
  Proof.
    intros H%power_norm. unfold cayley_f, cayley_g. combine (4 * (q (dot v v) n * q (dot v v) n * power) *: H).
  Qed.

  (** R of order n is orthogonal with determinant 1, CP23 (13), (72), (73). *)
  Theorem cayley_orthogonal n power v : power * pow (1 + dot v v) n = 1 ->
    tmul (cayley_tensor n power v) (transpose (cayley_tensor n power v)) = identity /\
    tmul (transpose (cayley_tensor n power v)) (cayley_tensor n power v) = identity /\
    det (cayley_tensor n power v) = 1.
  Proof. intros H. apply rotation_orthogonal, cayley_unit, H. Qed.

  (** R of order n is I + 2 p q (1 + x)^-n skew(v) + 2 q² (1 + x)^-n skew(v)², CP23 (57); its entries of the form
      a I + b skew(v) + c v ⊗ v. *)
  Theorem cayley_tensor_isotropic n power v : power * pow (1 + dot v v) n = 1 ->
    cayley_tensor n power v = isotropic
      ((p (dot v v) n * p (dot v v) n - dot v v * (q (dot v v) n * q (dot v v) n)) * power)
      (2 * (p (dot v v) n * q (dot v v) n * power)) (2 * (q (dot v v) n * q (dot v v) n * power)) v.
  Proof.
    intros H%power_norm. unfold cayley_tensor. rewrite rotation_isotropic. f_equal. unfold cayley_g.
      combine (- (1) *: H).
  Qed.

  (** Quaternion of order n, CP23 (53): a power of 1 + v, of norm 1, whose sandwich is R. *)
  Theorem cayley_quaternion_power n root v : cayley_quaternion n root v = qscale root (qpow (Quat 1 v) n).
  Proof. rewrite quaternion_powers. entries; ring. Qed.

  Theorem cayley_quaternion_norm n root v : root * root * pow (1 + dot v v) n = 1 ->
    p (dot v v) n * root * (p (dot v v) n * root) + dot v v * (q (dot v v) n * root * (q (dot v v) n * root)) = 1.
  Proof. intros H%power_norm. combine (1 *: H). Qed.

  Theorem cayley_quaternion_unit n root v : root * root * pow (1 + dot v v) n = 1 ->
    qmul (cayley_quaternion n root v) (conj (cayley_quaternion n root v)) = qone.
  Proof. intros H. apply quaternion_unit, cayley_quaternion_norm, H. Qed.

  Theorem cayley_sandwich n root v u : root * root * pow (1 + dot v v) n = 1 ->
    qmul (qmul (cayley_quaternion n root v) (Quat 0 u)) (conj (cayley_quaternion n root v)) =
    Quat 0 (apply (cayley_tensor n (root * root) v) u).
  Proof.
    intros H. unfold cayley_quaternion. rewrite (sandwich _ _ _ _ (cayley_quaternion_norm n root v H)).
    unfold cayley_tensor, cayley_f, cayley_g. f_equal. f_equal. f_equal; ring.
  Qed.

  (** R_(m+n) = R_m R_n. *)
  Theorem tensors_of_orders_multiply m n power_m power_n v :
    power_m * pow (1 + dot v v) m = 1 -> power_n * pow (1 + dot v v) n = 1 ->
    cayley_tensor (m + n) (power_m * power_n) v = tmul (cayley_tensor m power_m v) (cayley_tensor n power_n v).
  Proof.
    intros H G. rewrite !cayley_tensor_isotropic, isotropic_product by
      (try assumption; rewrite pow_add; combine ((power_n * pow (1 + dot v v) n) *: H +: 1 *: G)).
    destruct (addition K (dot v v) m n) as [-> ->]. apply power_norm in H, G. f_equal; ring.
  Qed.
End Laws.
