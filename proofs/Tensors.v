(** Vectors, tensors and quaternions by components over a commutative ring.

    With dual numbers as scalars they are dual vectors, dual tensors and dual quaternions. *)

From dualcay Require Export Rings.

Record Vector (K : CommutativeRing) := Vec { v1 : K; v2 : K; v3 : K }.
Arguments Vec {K} v1 v2 v3.
Arguments v1 {K} _.
Arguments v2 {K} _.
Arguments v3 {K} _.

Record Tensor (K : CommutativeRing) := Ten {
  t11 : K; t12 : K; t13 : K;
  t21 : K; t22 : K; t23 : K;
  t31 : K; t32 : K; t33 : K }.
Arguments Ten {K} t11 t12 t13 t21 t22 t23 t31 t32 t33.
Arguments t11 {K} _. Arguments t12 {K} _. Arguments t13 {K} _.
Arguments t21 {K} _. Arguments t22 {K} _. Arguments t23 {K} _.
Arguments t31 {K} _. Arguments t32 {K} _. Arguments t33 {K} _.

Record Quaternion (K : CommutativeRing) := Quat { scalar : K; vector : Vector K }.
Arguments Quat {K} scalar vector.
Arguments scalar {K} _.
Arguments vector {K} _.

Section Definitions.
  Context {K : CommutativeRing}.
  Implicit Types (a b c : K) (u v w : Vector K) (A B : Tensor K).

  Definition vzero : Vector K := Vec 0 0 0.
  Definition vadd u v := Vec (v1 u + v1 v) (v2 u + v2 v) (v3 u + v3 v).
  Definition vsub u v := Vec (v1 u - v1 v) (v2 u - v2 v) (v3 u - v3 v).
  Definition vscale a v := Vec (a * v1 v) (a * v2 v) (a * v3 v).
  Definition dot u v := v1 u * v1 v + v2 u * v2 v + v3 u * v3 v.
  Definition cross u v :=
    Vec (v2 u * v3 v - v3 u * v2 v) (v3 u * v1 v - v1 u * v3 v) (v1 u * v2 v - v2 u * v1 v).

  Definition identity : Tensor K := Ten 1 0 0 0 1 0 0 0 1.
  Definition skew v := Ten 0 (- v3 v) (v2 v) (v3 v) 0 (- v1 v) (- v2 v) (v1 v) 0.
  Definition dyad u v := Ten
    (v1 u * v1 v) (v1 u * v2 v) (v1 u * v3 v)
    (v2 u * v1 v) (v2 u * v2 v) (v2 u * v3 v)
    (v3 u * v1 v) (v3 u * v2 v) (v3 u * v3 v).
  Definition tadd A B := Ten
    (t11 A + t11 B) (t12 A + t12 B) (t13 A + t13 B)
    (t21 A + t21 B) (t22 A + t22 B) (t23 A + t23 B)
    (t31 A + t31 B) (t32 A + t32 B) (t33 A + t33 B).
  Definition tscale a A := Ten
    (a * t11 A) (a * t12 A) (a * t13 A)
    (a * t21 A) (a * t22 A) (a * t23 A)
    (a * t31 A) (a * t32 A) (a * t33 A).
  Definition transpose A := Ten (t11 A) (t21 A) (t31 A) (t12 A) (t22 A) (t32 A) (t13 A) (t23 A) (t33 A).
  Definition row1 A := Vec (t11 A) (t12 A) (t13 A).
  Definition row2 A := Vec (t21 A) (t22 A) (t23 A).
  Definition row3 A := Vec (t31 A) (t32 A) (t33 A).
  Definition apply A v := Vec (dot (row1 A) v) (dot (row2 A) v) (dot (row3 A) v).
  Definition tmul A B := Ten
    (dot (row1 A) (row1 (transpose B))) (dot (row1 A) (row2 (transpose B))) (dot (row1 A) (row3 (transpose B)))
    (dot (row2 A) (row1 (transpose B))) (dot (row2 A) (row2 (transpose B))) (dot (row2 A) (row3 (transpose B)))
    (dot (row3 A) (row1 (transpose B))) (dot (row3 A) (row2 (transpose B))) (dot (row3 A) (row3 (transpose B))).
  Definition det A := dot (row1 A) (cross (row2 A) (row3 A)).

  (** Vector of the skew part of a tensor; [half] is the inverse of 2. *)
  Definition vect half A := vscale half (Vec (t32 A - t23 A) (t13 A - t31 A) (t21 A - t12 A)).

  (** a I + b skew(v) + c v ⊗ v, the form of all tensors of this project. *)
  Definition isotropic a b c v := tadd (tadd (tscale a identity) (tscale b (skew v))) (tscale c (dyad v v)).

  Definition qone : Quaternion K := Quat 1 vzero.
  Definition qmul (q r : Quaternion K) := Quat
    (scalar q * scalar r - dot (vector q) (vector r))
    (vadd (vadd (vscale (scalar q) (vector r)) (vscale (scalar r) (vector q))) (cross (vector q) (vector r))).
  Definition qadd (q r : Quaternion K) := Quat (scalar q + scalar r) (vadd (vector q) (vector r)).
  Definition qscale a (q : Quaternion K) := Quat (a * scalar q) (vscale a (vector q)).
  Definition conj (q : Quaternion K) := Quat (scalar q) (vscale (- (1)) (vector q)).
  Fixpoint qpow (q : Quaternion K) n := match n with O => qone | S m => qmul q (qpow q m) end.
End Definitions.

(** Vectors, tensors and quaternions are equal if their entries are. *)
Section Equality.
  Context {K : CommutativeRing}.

  Theorem vector_eq (u v : Vector K) : v1 u = v1 v -> v2 u = v2 v -> v3 u = v3 v -> u = v.
  Proof. destruct u, v; cbn. congruence. Qed.

  Theorem tensor_eq (A B : Tensor K) :
    t11 A = t11 B -> t12 A = t12 B -> t13 A = t13 B ->
    t21 A = t21 B -> t22 A = t22 B -> t23 A = t23 B ->
    t31 A = t31 B -> t32 A = t32 B -> t33 A = t33 B -> A = B.
  Proof. destruct A, B; cbn. congruence. Qed.

  Theorem quaternion_eq (q r : Quaternion K) : scalar q = scalar r -> vector q = vector r -> q = r.
  Proof. destruct q, r; cbn. congruence. Qed.
End Equality.

(** [entries] turns an equation of vectors, tensors or quaternions into equations of their entries. *)
Ltac entries := lazymatch goal with
  | |- _ = _ :> Vector _ => apply vector_eq
  | |- _ = _ :> Tensor _ => apply tensor_eq
  | |- _ = _ :> Quaternion _ => apply quaternion_eq; [|apply vector_eq]
  | |- _ => idtac
  end; unfold det; cbn; repeat progress (unfold dot; cbn).

Section Parts.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).

  (** Real and dual parts of dual vectors and tensors. *)
  Definition vdual (v w : Vector K) : Vector (dual K) :=
    Vec (Dual (v1 v) (v1 w) : dual K) (Dual (v2 v) (v2 w)) (Dual (v3 v) (v3 w)).
  Definition vre (v : Vector (dual K)) := Vec (re (v1 v)) (re (v2 v)) (re (v3 v)).
  Definition vdu (v : Vector (dual K)) := Vec (du (v1 v)) (du (v2 v)) (du (v3 v)).
  Definition tdual (A B : Tensor K) : Tensor (dual K) := Ten
    (Dual (t11 A) (t11 B) : dual K) (Dual (t12 A) (t12 B)) (Dual (t13 A) (t13 B))
    (Dual (t21 A) (t21 B)) (Dual (t22 A) (t22 B)) (Dual (t23 A) (t23 B))
    (Dual (t31 A) (t31 B)) (Dual (t32 A) (t32 B)) (Dual (t33 A) (t33 B)).
  Definition tre (A : Tensor (dual K)) := Ten
    (re (t11 A)) (re (t12 A)) (re (t13 A)) (re (t21 A)) (re (t22 A)) (re (t23 A)) (re (t31 A)) (re (t32 A))
      (re (t33 A)).
  Definition tdu (A : Tensor (dual K)) := Ten
    (du (t11 A)) (du (t12 A)) (du (t13 A)) (du (t21 A)) (du (t22 A)) (du (t23 A)) (du (t31 A)) (du (t32 A))
      (du (t33 A)).

  Theorem parts_of_product (A B : Tensor (dual K)) :
    tre (tmul A B) = tmul (tre A) (tre B) /\ tdu (tmul A B) = tadd (tmul (tre A) (tdu B)) (tmul (tdu A) (tre B)).
  Proof. split; entries; ring. Qed.

  Theorem parts_of_dot v w : dot (vdual v w) (vdual v w) = Dual (dot v v) (2 * dot v w) :> dual K.
  Proof. apply dual_eq; entries; ring. Qed.
End Parts.

Arguments vdual {K} v w.
Arguments tdual {K} A B.
Arguments vre {K} v.
Arguments vdu {K} v.
Arguments tre {K} A.
Arguments tdu {K} A.

Section Laws.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (a b c half : K) (u v w : Vector K) (A B C : Tensor K) (q r s : Quaternion K).

  Theorem tmul_assoc A B C : tmul (tmul A B) C = tmul A (tmul B C).
  Proof. entries; ring. Qed.

  Theorem tmul_identity A : tmul A identity = A /\ tmul identity A = A.
  Proof. split; entries; ring. Qed.

  Theorem apply_product A B v : apply (tmul A B) v = apply A (apply B v).
  Proof. entries; ring. Qed.

  Theorem apply_identity v : apply identity v = v.
  Proof. entries; ring. Qed.

  Theorem transpose_product A B : transpose (tmul A B) = tmul (transpose B) (transpose A).
  Proof. entries; ring. Qed.

  Theorem det_product A B : det (tmul A B) = det A * det B.
  Proof. entries; ring. Qed.

  Theorem skew_applied u v : apply (skew u) v = cross u v.
  Proof. entries; ring. Qed.

  (** skew(v)² = v ⊗ v - (v·v) I. *)
  Theorem skew_squared v : tmul (skew v) (skew v) = isotropic (- dot v v) 0 1 v.
  Proof. entries; ring. Qed.

  (** skew(v) is determined by v: the vector of skew(v) is v. *)
  Theorem vect_skew half v : half * 2 = 1 -> vect half (skew v) = v.
  Proof. intros H. entries; ring [H]. Qed.

  (** The tensors a I + b skew(v) + c v ⊗ v are closed under products: their algebra is commutative. *)
  Theorem isotropic_product a b c a' b' c' v :
    tmul (isotropic a b c v) (isotropic a' b' c' v) =
    isotropic (a * a' - dot v v * (b * b')) (a * b' + b * a')
      (a * c' + c * a' + b * b' + dot v v * (c * c')) v.
  Proof. entries; ring. Qed.

  Theorem isotropic_transpose a b c v : transpose (isotropic a b c v) = isotropic a (- b) c v.
  Proof. entries; ring. Qed.

  Theorem isotropic_identity v : isotropic 1 0 0 v = identity.
  Proof. entries; ring. Qed.

  Theorem isotropic_applied a b c v u :
    apply (isotropic a b c v) u = vadd (vadd (vscale a u) (vscale b (cross v u))) (vscale (c * dot v u) v).
  Proof. entries; ring. Qed.

  Theorem isotropic_det a b c v :
    det (isotropic a b c v) = (a + c * dot v v) * (a * a + dot v v * (b * b)).
  Proof. entries; ring. Qed.

  Theorem qmul_assoc q r s : qmul (qmul q r) s = qmul q (qmul r s).
  Proof. entries; ring. Qed.

  Theorem qmul_one q : qmul q qone = q /\ qmul qone q = q.
  Proof. split; entries; ring. Qed.
End Laws.
