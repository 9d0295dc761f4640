(** Maps v = φ(α) u of any function φ of the angle, away from φ = 0.

    [s] and [c] are sine and cosine of α/2; [phi], [slope] are φ and its derivative by α; [phi_inverse],
    [slope_inverse], [s_inverse] are inverses. *)

From dualcay Require Export Kinematics.

Section AnyPhi.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (half s c phi slope phi_inverse slope_inverse s_inverse a : K) (u v : Vector K).

  Definition phi_f s c phi_inverse := 2 * (s * c * phi_inverse).
  Definition phi_g s phi_inverse := 2 * (s * s * (phi_inverse * phi_inverse)).
  Definition phi_h s c phi_inverse slope_inverse :=
    (slope_inverse - phi_f s c phi_inverse) * (phi_inverse * phi_inverse).
  Definition phi_tangent s c phi_inverse slope_inverse v :=
    tangent (phi_f s c phi_inverse) (phi_g s phi_inverse) (phi_h s c phi_inverse slope_inverse) v.
  Definition phi_tangent_inv half c s_inverse phi slope phi_inverse v :=
    tangent_inv half (phi * c * s_inverse) ((2 * slope - phi * c * s_inverse) * (phi_inverse * phi_inverse)) v.

  Lemma length_squared phi u : dot u u = 1 -> dot (vscale phi u) (vscale phi u) = phi * phi.
  Proof. intros H. transitivity (phi * phi * dot u u); [unfold dot; cbn; ring|rewrite H; ring]. Qed.

  (** f² + x g² = 2 g, hence R is orthogonal with determinant 1. *)
  Theorem phi_unit s c phi phi_inverse u : s * s + c * c = 1 -> phi * phi_inverse = 1 -> dot u u = 1 ->
    phi_f s c phi_inverse * phi_f s c phi_inverse
    + dot (vscale phi u) (vscale phi u) * (phi_g s phi_inverse * phi_g s phi_inverse) = 2 * phi_g s phi_inverse.
  Proof.
    intros H P U. rewrite (length_squared phi u U). unfold phi_f, phi_g.
    combine (4 * (s * s * phi_inverse * phi_inverse) *: H
      +: 4 * (s * s * s * s * phi_inverse * phi_inverse * (phi * phi_inverse + 1)) *: P).
  Qed.

  Theorem phi_orthogonal s c phi phi_inverse u : s * s + c * c = 1 -> phi * phi_inverse = 1 -> dot u u = 1 ->
    let R := rotation (phi_f s c phi_inverse) (phi_g s phi_inverse) (vscale phi u) in
    tmul R (transpose R) = identity /\ tmul (transpose R) R = identity /\ det R = 1.
  Proof. intros H P U. apply rotation_orthogonal. now apply phi_unit. Qed.

  (** The quaternion c + s u has norm 1; its sandwich is R. *)
  Theorem phi_quaternion s c phi phi_inverse u v : s * s + c * c = 1 -> phi * phi_inverse = 1 -> dot u u = 1 ->
    qmul (quaternion c s u) (conj (quaternion c s u)) = qone /\
    qmul (qmul (quaternion c s u) (Quat 0 v)) (conj (quaternion c s u)) =
    Quat 0 (apply (rotation (phi_f s c phi_inverse) (phi_g s phi_inverse) (vscale phi u)) v).
  Proof.
    intros H P U. assert (N : c * c + dot u u * (s * s) = 1) by (rewrite U; combine (1 *: H)).
    split; [now apply quaternion_unit|]. rewrite (sandwich K c s u v N). f_equal. f_equal.
    rewrite !rotation_isotropic, (length_squared phi u U), U.
    replace (phi_g s phi_inverse * (phi * phi)) with (2 * (s * s))
      by (unfold phi_g; combine (- (2 * (s * s) * (phi * phi_inverse + 1)) *: P)).
    unfold phi_f, phi_g. replace (2 * (c * s)) with (2 * (s * c * phi_inverse) * phi) by combine (2 * (s * c) *: P).
    replace (2 * (s * s)) with (2 * (s * s * (phi_inverse * phi_inverse)) * (phi * phi)) at 2
      by combine (2 * (s * s) * (phi * phi_inverse + 1) *: P). entries; ring.
  Qed.

  (** ω = T v', CP23 (86), with R' = skew(ω) R: the axis u + ε u' and the half angle, of rate b, move. *)
  Theorem phi_twist s c b phi slope phi_inverse slope_inverse u u' :
    s * s + c * c = 1 -> phi * phi_inverse = 1 -> slope * slope_inverse = 1 -> dot u u = 1 -> dot u u' = 0 ->
    let sine : dual K := Dual s (c * b) in
    let cosine : dual K := Dual c (- (s * b)) in
    let moving := vscale (Dual phi (slope * (2 * b)) : dual K) (vdual u u') in
    is_twist (rotation (2 * (sine * cosine)) (2 * (sine * sine)) (vdual u u'))
      (apply (phi_tangent s c phi_inverse slope_inverse (vscale phi u)) (vdu moving)).
  Proof.
    intros H P D U V sine cosine moving.
    pose proof (twist K _ _ (phi_h s c phi_inverse slope_inverse) _ (vdu moving)
      (phi_unit s c phi phi_inverse u H P U)) as E.
    replace (dot (vscale phi u) (vdu moving)) with (phi * (slope * (2 * b) * dot u u + phi * dot u u')) in E
      by (unfold moving, dot; cbn; ring).
    rewrite (length_squared phi u U), U, V in E.
    replace (vdual (vscale phi u) (vdu moving)) with moving in E by (apply vector_eq; apply dual_eq; easy).
    unfold moving in E at 1. rewrite (rotation_scaled (dual K)) in E. fold moving in E.
    assert (C : c * c = 1 - s * s) by combine (1 *: H).
    replace (2 * (sine * cosine)) with ((Dual (phi_f s c phi_inverse) (((1 - phi_g s phi_inverse * (phi * phi)) *
      phi_h s c phi_inverse slope_inverse - phi_f s c phi_inverse * phi_g s phi_inverse) *
      (phi * (slope * (2 * b) * 1 + phi * 0))) : dual K) * (Dual phi (slope * (2 * b)) : dual K)).
    replace (2 * (sine * sine)) with ((Dual (phi_g s phi_inverse) ((phi_f s c phi_inverse *
      phi_h s c phi_inverse slope_inverse - phi_g s phi_inverse * phi_g s phi_inverse) *
      (phi * (slope * (2 * b) * 1 + phi * 0))) : dual K) *
      ((Dual phi (slope * (2 * b)) : dual K) * (Dual phi (slope * (2 * b)) : dual K))).
    - exact E.
    - unfold sine, cosine, phi_h, phi_f, phi_g. apply dual_eq; cbn; ring [P D C].
    - unfold sine, cosine, phi_h, phi_f, phi_g. apply dual_eq; cbn; ring [P D C].
  Qed.

  (** T T⁻¹ = T⁻¹ T = I, where the sine has an inverse. *)
  Theorem phi_inverse_tangent half s c s_inverse phi slope phi_inverse slope_inverse u : half * 2 = 1 ->
    s * s + c * c = 1 -> s * s_inverse = 1 -> phi * phi_inverse = 1 -> slope * slope_inverse = 1 -> dot u u = 1 ->
    let T := phi_tangent s c phi_inverse slope_inverse (vscale phi u) in
    let T_inverse := phi_tangent_inv half c s_inverse phi slope phi_inverse (vscale phi u) in
    tmul T T_inverse = identity /\ tmul T_inverse T = identity.
  Proof.
    intros E H S P D U. assert (C : c * c = 1 - s * s) by combine (1 *: H).
    apply inverse; [exact E| | |]; rewrite ?(length_squared phi u U); unfold phi_h, phi_f, phi_g; ring [P D S C].
  Qed.

  (** T v = v / φ', and det T = 4 sin²(α/2) / (φ² φ'). *)
  Theorem phi_axis s c phi phi_inverse slope_inverse u : phi * phi_inverse = 1 -> dot u u = 1 ->
    let v := vscale phi u in
    apply (phi_tangent s c phi_inverse slope_inverse v) v = vscale slope_inverse v.
  Proof.
    intros P U v. unfold phi_tangent. rewrite (proj1 (axis _ _ _ _ _)). unfold v at 1 2.
    rewrite (length_squared phi u U). f_equal. unfold phi_h, phi_f. ring [P].
  Qed.

  Theorem phi_determinant s c phi phi_inverse slope_inverse u :
    s * s + c * c = 1 -> phi * phi_inverse = 1 -> dot u u = 1 ->
    det (phi_tangent s c phi_inverse slope_inverse (vscale phi u)) =
    4 * (s * s * (phi_inverse * phi_inverse) * slope_inverse).
  Proof.
    intros H P U. unfold phi_tangent. rewrite determinant by now apply phi_unit.
    rewrite (length_squared phi u U). unfold phi_h, phi_f, phi_g. ring [P].
  Qed.

  (** T^T = R^T T; hence the body twist is T^T v' as for every map. *)
  Theorem phi_body_tangent s c phi phi_inverse slope_inverse u :
    s * s + c * c = 1 -> phi * phi_inverse = 1 -> dot u u = 1 ->
    let v := vscale phi u in
    transpose (phi_tangent s c phi_inverse slope_inverse v) =
    tmul (transpose (rotation (phi_f s c phi_inverse) (phi_g s phi_inverse) v))
         (phi_tangent s c phi_inverse slope_inverse v).
  Proof. intros H P U v. apply body_tangent. now apply phi_unit. Qed.
End AnyPhi.
