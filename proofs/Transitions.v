(** Derivative of v(t) by v(0), change of branch or chart, and the covariance that all of them share. *)

From dualcay Require Export Kinematics.

Section Transitions.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (half : K) (v w a b : Vector K) (A B T : Tensor K) (M : Tensor (dual K)).

  Lemma skew_injective a b : skew a = skew b -> a = b.
  Proof.
    intros E. apply vector_eq; [apply (f_equal t32) in E|apply (f_equal t13) in E|apply (f_equal t21) in E]; exact E.
  Qed.

  Lemma cancel_left T A B : tmul (transpose T) T = identity -> tmul T A = tmul T B -> A = B.
  Proof.
    intros O E. apply (f_equal (tmul (transpose T))) in E. rewrite <- !tmul_assoc, O in E.
    now rewrite !(proj2 (tmul_identity _ _)) in E.
  Qed.

  Lemma cancel_right T A B : tmul T (transpose T) = identity -> tmul A T = tmul B T -> A = B.
  Proof.
    intros O E. apply (f_equal (fun C => tmul C (transpose T))) in E. rewrite !tmul_assoc, O in E.
    now rewrite !(proj1 (tmul_identity _ _)) in E.
  Qed.

  Lemma products_by_constant A M : let C := tdual A (tscale 0 identity) in
    tre (tmul C M) = tmul A (tre M) /\ tdu (tmul C M) = tmul A (tdu M) /\
    tre (tmul M C) = tmul (tre M) A /\ tdu (tmul M C) = tmul (tdu M) A.
  Proof. repeat split; entries; ring. Qed.

  (** A constant displacement E from the left leaves the body twist: E R' = (E R) skew(ω_B). *)
  Theorem body_twist_after_constant A M M0 a b : M = tmul (tdual A (tscale 0 identity)) M0 ->
    tmul (transpose (tre M)) (tre M) = identity -> is_body_twist M b -> is_body_twist M0 a -> b = a.
  Proof.
    unfold is_body_twist. intros -> O E F. destruct (products_by_constant A M0) as (R & D & _). rewrite R in *.
    apply skew_injective, (cancel_left _ _ _ O). now rewrite <- E, D, F, tmul_assoc.
  Qed.

  (** A constant displacement from the right leaves the space twist. *)
  Theorem twist_before_constant A M M0 a b : M = tmul M0 (tdual A (tscale 0 identity)) ->
    tmul (tre M) (transpose (tre M)) = identity -> is_twist M b -> is_twist M0 a -> b = a.
  Proof.
    unfold is_twist. intros -> O E F. destruct (products_by_constant A M0) as (_ & _ & R & D). rewrite R in *.
    apply skew_injective, (cancel_right _ _ _ O). now rewrite <- E, D, F, tmul_assoc.
  Qed.

  (** Transition under a prescribed space twist: the pose at t is E(t) times the pose at 0, so that a change v0' of v(0)
      and the change v' of v(t) satisfy T_B v' = T_B0 v0', hence ∂v/∂v0 = T_B⁻¹ T_B0, where T_B = T^T. *)
  Theorem transition A M M0 T T_inverse T0 v' v0' : M = tmul (tdual A (tscale 0 identity)) M0 ->
    tmul (transpose (tre M)) (tre M) = identity -> is_body_twist M (apply T v') -> is_body_twist M0 (apply T0 v0') ->
    tmul T_inverse T = identity -> v' = apply (tmul T_inverse T0) v0'.
  Proof.
    intros E O B B0 I. rewrite apply_product, <- (body_twist_after_constant A M M0 _ _ E O B B0).
    now rewrite <- apply_product, I, apply_identity.
  Qed.

  (** Transition under a prescribed body twist: ∂v/∂v0 = T⁻¹ T0. *)
  Theorem body_transition A M M0 T T_inverse T0 v' v0' : M = tmul M0 (tdual A (tscale 0 identity)) ->
    tmul (tre M) (transpose (tre M)) = identity -> is_twist M (apply T v') -> is_twist M0 (apply T0 v0') ->
    tmul T_inverse T = identity -> v' = apply (tmul T_inverse T0) v0'.
  Proof.
    intros E O B B0 I. rewrite apply_product, <- (twist_before_constant A M M0 _ _ E O B B0).
    now rewrite <- apply_product, I, apply_identity.
  Qed.

  (** Two vectors of one pose, in two branches or charts: ∂v_b/∂v_a = T_b⁻¹ T_a. *)
  Theorem change_of_chart half M T T_inverse T0 v' v0' : half * 2 = 1 -> tmul (tre M) (transpose (tre M)) = identity ->
    is_twist M (apply T v') -> is_twist M (apply T0 v0') -> tmul T_inverse T = identity ->
    v' = apply (tmul T_inverse T0) v0'.
  Proof.
    intros H O B B0 I. rewrite apply_product, <- (twist_unique K half M _ _ H O B B0).
    now rewrite <- apply_product, I, apply_identity.
  Qed.

  (** Cayley map of order n + 1 under a prescribed body twist. *)
  Theorem cayley_transition half n A v v' power (power' : K) v0 v0' power0 (power0' : K) q_inverse n_inverse :
    half * 2 = 1 ->
    (Dual power power' : dual K) * pow (1 + dot (vdual v v') (vdual v v')) (S n) = 1 ->
    (Dual power0 power0' : dual K) * pow (1 + dot (vdual v0 v0') (vdual v0 v0')) (S n) = 1 ->
    q (dot v v) (S n) * q_inverse = 1 -> of_nat (S n) * n_inverse = 1 ->
    cayley_tensor (S n) (Dual power power' : dual K) (vdual v v') =
      tmul (cayley_tensor (S n) (Dual power0 power0' : dual K) (vdual v0 v0')) (tdual A (tscale 0 identity)) ->
    v' = apply (tmul (dcay_inv half (S n) q_inverse n_inverse v) (dcay (S n) power0 v0)) v0'.
  Proof.
    intros T H H0 Q N E. pose proof (real_part_of_power _ _ _ _ _ _ H) as P.
    apply (body_transition _ _ _ (dcay (S n) power v) _ _ _ _ E); [| |now apply cayley_twist|now apply cayley_inverse].
    - rewrite (real_part_of_tensor _ _ _ _ _ _ H). now apply cayley_orthogonal.
    - now apply cayley_twist.
  Qed.

  (** Covariance of the perturbation of the pose: Σ = T P T^T is the same after P = J P0 J^T with J = T⁻¹ T0. *)
  Theorem covariance T T_inverse T0 P0 : tmul T T_inverse = identity ->
    let J := tmul T_inverse T0 in
    tmul (tmul T (tmul (tmul J P0) (transpose J))) (transpose T) = tmul (tmul T0 P0) (transpose T0).
  Proof.
    intros I J. assert (E : tmul T J = T0) by (unfold J; now rewrite <- tmul_assoc, I, (proj2 (tmul_identity _ _))).
    rewrite <- !tmul_assoc, E, tmul_assoc. now rewrite <- transpose_product, E.
  Qed.
End Transitions.
