(** Exponentials of skew tensors and vectors as power series in the angle, CP23 (17), (23).

    The series of exponential, cosine and sine follow from their differential equations: the coefficient of index k + 1
    is that of the derivative times [over k], the inverse of k + 1. *)

From dualcay Require Export Tensors.

Section Series.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Variable over : nat -> K.

  Fixpoint cosine_term (k : nat) : K := match k with O => 1 | S m => - (over m * sine_term m) end
  with sine_term (k : nat) : K := match k with O => 0 | S m => over m * cosine_term m end.

  (** Coefficients of X with X' = skew(u) X and X(0) = I, and of Y with Y' = u Y and Y(0) = 1. *)
  Fixpoint tensor_term (u : Vector K) k := match k with
    | O => identity
    | S m => tscale (over m) (tmul (skew u) (tensor_term u m))
    end.
  Fixpoint quaternion_term (u : Vector K) k := match k with
    | O => qone
    | S m => qscale (over m) (qmul (Quat 0 u) (quaternion_term u m))
    end.

  Lemma cosine_term_next k : cosine_term (S k) = - (over k * sine_term k). Proof. easy. Qed.
  Lemma sine_term_next k : sine_term (S k) = over k * cosine_term k. Proof. easy. Qed.

  Lemma skew_times u (a b c : K) :
    tmul (skew u) (tadd (tscale a identity) (tadd (tscale b (skew u)) (tscale c (tmul (skew u) (skew u)))))
    = tadd (tscale (a - c * dot u u) (skew u)) (tscale b (tmul (skew u) (skew u))).
  Proof. entries; ring. Qed.

  (** exp(α skew(u)) = I + sin(α) skew(u) + (1 - cos(α)) skew(u)²; [start] has the constant terms of I and of 1. *)
  Definition start (k : nat) : K := match k with O => 1 | S _ => 0 end.

  Theorem exponential_of_skew u k : dot u u = 1 ->
    tensor_term u k = tadd (tscale (start k) identity)
      (tadd (tscale (sine_term k) (skew u)) (tscale (start k - cosine_term k) (tmul (skew u) (skew u)))).
  Proof.
    intros U. induction k as [|k E]; [entries; ring|]. cbn [tensor_term].
      rewrite E, skew_times, U, cosine_term_next, sine_term_next.
    generalize (cosine_term k), (sine_term k), (start k). intros c s z. entries; ring.
  Qed.

  (** exp(β u) = cos(β) + sin(β) u. *)
  Theorem exponential_of_vector u k : dot u u = 1 -> quaternion_term u k =
    Quat (cosine_term k) (vscale (sine_term k) u).
  Proof.
    intros U. induction k as [|k E]; [entries; ring|]. cbn [quaternion_term].
      rewrite E, cosine_term_next, sine_term_next.
    replace (over k * sine_term k) with (over k * (sine_term k * dot u u)) by (rewrite U; ring).
    entries; ring.
  Qed.
End Series.
