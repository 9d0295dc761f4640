(** What emitted programs compute with: numbers of a field, and dual quantities as lists of components.

    A program is the text of a kernel, read back as a function of real numbers. Its results are the components of a
    vector, tensor or quaternion over dual numbers: all real parts first, then all dual parts. *)

From Coq Require Export Field.
From dualcay Require Export Kinematics.

(** A field in which 2, 3, 4 and so on are not 0, such as the real numbers. *)
Record Field := make_field {
  numbers :> CommutativeRing;
  divide : numbers -> numbers -> numbers;
  invert : numbers -> numbers;
  field_laws : field_theory 0 1 add mul sub opp divide invert (@eq numbers);
  no_multiple_is_zero n : of_nat (S n) <> 0 :> numbers }.

Notation "a / b" := (divide _ a b) : scalar_scope.

Section Components.
  Context {K : Field}.
  Implicit Types v : Vector (dual K).

  Definition vector_parts v :=
    (v1 (vre v), v2 (vre v), v3 (vre v), v1 (vdu v), v2 (vdu v), v3 (vdu v)).

  Definition quaternion_parts (r : Quaternion (dual K)) :=
    (re (scalar r), v1 (vre (vector r)), v2 (vre (vector r)), v3 (vre (vector r)),
     du (scalar r), v1 (vdu (vector r)), v2 (vdu (vector r)), v3 (vdu (vector r))).

  Definition tensor_parts (R : Tensor (dual K)) :=
    (t11 (tre R), t12 (tre R), t13 (tre R), t21 (tre R), t22 (tre R), t23 (tre R), t31 (tre R), t32 (tre R), t33 (tre R),
     t11 (tdu R), t12 (tdu R), t13 (tdu R), t21 (tdu R), t22 (tdu R), t23 (tdu R), t31 (tdu R), t32 (tdu R), t33 (tdu R)).

  (** Homogeneous matrix of a rotation and a translation, by rows. *)
  Definition pose_parts (Q : Tensor K) (rho : Vector K) : K * K * K * K * K * K * K * K * K * K * K * K * K * K * K * K :=
    (t11 Q, t12 Q, t13 Q, v1 rho, t21 Q, t22 Q, t23 Q, v2 rho, t31 Q, t32 Q, t33 Q, v3 rho, 0, 0, 0, 1).
End Components.

Section Laws.
  Variable K : Field.
  Add Field numbers : (field_laws K).

  Lemma pairs_equal (A B : Type) (a a' : A) (b b' : B) : a = a' -> b = b' -> (a, b) = (a', b').
  Proof. now intros -> ->. Qed.

  (** Inverse of a dual number. *)
  Lemma inverse_parts (a w : dual K) : a * w = 1 -> re a <> 0 /\ w = Dual (1 / re a) (- (du a / (re a * re a))).
  Proof.
    destruct a as [a a'], w as [w w']. intros E. apply (f_equal re) in E as F. apply (f_equal du) in E. cbn in E, F |- *.
    assert (N : a <> 0).
    { intros Z. rewrite Z in F. apply (F_1_neq_0 (field_laws K)). rewrite <- F. ring. }
    assert (w = 1 / a) as -> by (replace w with (a * w / a) by (field; exact N); now rewrite F).
    split; [exact N|]. apply dual_eq; [easy|]. cbn.
    replace w' with ((a * w' + a' * (1 / a)) / a - a' / (a * a)) by (field; exact N). rewrite E. field. exact N.
  Qed.

  Lemma inverse_parts_left (a w : dual K) : w * a = 1 -> re a <> 0 /\ w = Dual (1 / re a) (- (du a / (re a * re a))).
  Proof. intros E. apply inverse_parts. rewrite <- E. apply (Rmul_comm (laws (dual K))). Qed.

  Lemma inverse_of (a b : K) : a * b = 1 -> b = 1 / a.
  Proof.
    intros E. assert (N : a <> 0) by (intros Z; apply (F_1_neq_0 (field_laws K)); rewrite <- E, Z; ring).
    transitivity (a * b / a); [field; exact N|]. now rewrite E.
  Qed.

  (** A root of the inverse of (1 + X)^n at X = x + ε 2 y: its dual part is -n y / (1 + x) times its real part. *)
  Lemma root_parts n x y r (r' : K) :
    (Dual r r' : dual K) * (Dual r r' : dual K) * pow (1 + (Dual x (2 * y) : dual K)) (S n) = 1 ->
    r <> 0 /\ 1 + x <> 0 /\ r' = - (of_nat (S n) * y * r / (1 + x)).
  Proof.
    change ((Dual r r' : dual K) * (Dual r r' : dual K)) with (Dual (r * r) (r * r' + r' * r) : dual K). intros [E F]%power_slope.
    cbn [pow] in E. assert (N : r <> 0) by (intros Z; apply (F_1_neq_0 (field_laws K)); rewrite <- E, Z; ring).
    assert (M : 1 + x <> 0) by (intros Z; apply (F_1_neq_0 (field_laws K)); rewrite <- E, Z; ring).
    assert (T : 1 + 1 <> 0 :> K) by (intros Z; apply (no_multiple_is_zero K 1); rewrite <- Z; cbn; ring).
    repeat split; [exact N|exact M|]. replace r' with ((r * r' + r' * r) / (2 * r)) by (field; split; assumption).
    replace (pow (1 + x) n) with (1 / (r * r * (1 + x))) in F.
    - rewrite F. field. repeat split; assumption.
    - symmetry. apply inverse_of. refine (eq_trans _ E). ring.
  Qed.
End Laws.

Arguments inverse_parts {K a w} _.
Arguments inverse_parts_left {K a w} _.
Arguments inverse_of {K a b} _.

(** [split_entries] leaves one goal for each component of a list, in order; [entry] proves a goal of components. *)
Ltac split_entries := repeat apply pairs_equal.

(** [different known] proves that a number is not 0 because another form of it, [known], is not 0. *)
Ltac different known := let Z := fresh in intros Z; apply known; refine (eq_trans _ Z); cbn; ring.
Ltac multiple K n := lazymatch n with
  | O => fail "a divisor may be 0"
  | S ?m => different (no_multiple_is_zero K m) || multiple K m
  end.
Ltac fold_in_goal f := let unfolded := eval cbv in f in change unfolded with f.
Ltac nonzero K :=
  fold_in_goal (@zero K); fold_in_goal (@one K); fold_in_goal (@add K); fold_in_goal (@mul K); fold_in_goal (@sub K);
  fold_in_goal (@opp K); fold_in_goal (divide K); fold_in_goal (invert K); repeat split; first [assumption | match goal with H : _ <> 0 |- _ => different H end | multiple K 25].
Ltac entry K := cbn; repeat progress (unfold dot; cbn); first [ring | field; nonzero K].

(** [scalar_entries v vo] turns equations of scalars at v·v into equations of their real and dual parts at any x;
    divisors are known not to be 0 by the premises. *)
Ltac scalar_entries v vo :=
  cbv beta iota zeta;
  change (v1 v * v1 v + v2 v * v2 v + v3 v * v3 v) with (dot v v) in *;
  let x := fresh "x" in let y := fresh "y" in
  generalize dependent (dot v v); intros x; generalize (dot v vo); intros y; intros; unfold c, d in *; cbn in *;
  try assert (1 + x <> 0) by (let Z := fresh in intros Z; match goal with H : _ <> 0 |- _ => apply H; rewrite Z; ring end);
  repeat match goal with |- _ /\ _ => split end; try apply dual_eq.

(** [known_root sqrt R] replaces the root in a text by 1 / r, where R says that r times the root is 1. *)
Ltac known_root sqrt R := lazymatch type of R with
  | ?r * sqrt ?a = _ => match goal with |- context [sqrt ?text] => replace text with a by ring; rewrite (inverse_of R) end
  | ?r * ?a = _ => replace r with (1 / a) by (symmetry; apply inverse_of; refine (eq_trans _ R); ring)
  end.
