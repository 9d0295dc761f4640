(** Commutative rings, and the dual numbers over a ring, which are a commutative ring again.

    Scalars are elements of an arbitrary commutative ring [K]. A number that must be invertible is a premise: 2 has the
    inverse [half] when [half * 2 = 1]. *)

From Coq Require Export Ring.

Record CommutativeRing := make_ring {
  carrier :> Type;
  zero : carrier;
  one : carrier;
  add : carrier -> carrier -> carrier;
  mul : carrier -> carrier -> carrier;
  sub : carrier -> carrier -> carrier;
  opp : carrier -> carrier;
  laws : ring_theory zero one add mul sub opp (@eq carrier) }.

Arguments zero {_}.
Arguments one {_}.
Arguments add {_} _ _.
Arguments mul {_} _ _.
Arguments sub {_} _ _.
Arguments opp {_} _.

Declare Scope scalar_scope.
Delimit Scope scalar_scope with scalar.
Bind Scope scalar_scope with carrier.
Notation "0" := zero : scalar_scope.
Notation "1" := one : scalar_scope.
Notation "2" := (add one one) : scalar_scope.
Notation "3" := (add one (add one one)) : scalar_scope.
Notation "4" := (mul (add one one) (add one one)) : scalar_scope.
Notation "a + b" := (add a b) : scalar_scope.
Notation "a - b" := (sub a b) : scalar_scope.
Notation "a * b" := (mul a b) : scalar_scope.
Notation "- a" := (opp a) : scalar_scope.
Global Open Scope scalar_scope.

Section Scalars.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types a b c : K.

  (** Natural numbers and powers in a ring. *)
  Fixpoint of_nat (n : nat) : K := match n with O => 0 | S m => 1 + of_nat m end.
  Fixpoint pow a (n : nat) : K := match n with O => 1 | S m => a * pow a m end.

  Theorem of_nat_add m n : of_nat (m + n) = of_nat m + of_nat n.
  Proof. induction m; cbn; [|rewrite IHm]; ring. Qed.

  Theorem of_nat_mul m n : of_nat (m * n) = of_nat m * of_nat n.
  Proof. induction m; cbn; [|rewrite of_nat_add, IHm]; ring. Qed.

  Theorem pow_add a m n : pow a (m + n) = pow a m * pow a n.
  Proof. induction m; cbn; [|rewrite IHm]; ring. Qed.

  Theorem pow_mul_base a b n : pow (a * b) n = pow a n * pow b n.
  Proof. induction n; cbn; [|rewrite IHn]; ring. Qed.

  Theorem pow_one n : pow 1 n = 1.
  Proof. induction n; cbn; [|rewrite IHn]; ring. Qed.

  (** An equation may be multiplied by an invertible number. *)
  Theorem cancel a b unit inverse : unit * inverse = 1 -> unit * a = unit * b -> a = b.
  Proof.
    intros H E. replace a with (inverse * (unit * a)) by (ring [H]). rewrite E. ring [H].
  Qed.

  (** A number has at most one inverse. *)
  Theorem inverse_unique a b c : a * b = 1 -> a * c = 1 -> b = c.
  Proof. intros H G. apply (cancel b c a b H). now rewrite H, G. Qed.

  (** Sums of multiples of known equations: [c *: e +: e'] has the sides c l + l' and c r + r'. *)
  Lemma scaled {a b} c : a = b -> c * a = c * b.
  Proof. now intros ->. Qed.

  Lemma added {a b a' b'} : a = b -> a' = b' -> a + a' = b + b'.
  Proof. now intros -> ->. Qed.

  Lemma by_difference {a b l r : K} : l = r -> a - b = l - r -> a = b.
  Proof.
    intros H E. rewrite H in E. transitivity (a - b + b); [ring|]. rewrite E. ring.
  Qed.
End Scalars.

Arguments of_nat {K} n.
Arguments pow {K} a n.
Notation "c *: e" := (scaled _ c e) (at level 40, left associativity).
Notation "e +: f" := (added _ e f) (at level 50, left associativity).

(** [combine (c *: e +: d *: f)] proves an equation whose difference of sides is that multiple of known equations. *)
Ltac combine H := refine (by_difference _ H _); ring.

(** Dual numbers a + ε b over a ring, with ε² = 0. *)
Record DualNumber (K : CommutativeRing) := Dual { re : K; du : K }.
Arguments Dual {K} re du.
Arguments re {K} _.
Arguments du {K} _.

Section DualNumbers.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).

  Definition dual_add (a b : DualNumber K) := Dual (re a + re b) (du a + du b).
  Definition dual_sub (a b : DualNumber K) := Dual (re a - re b) (du a - du b).
  Definition dual_mul (a b : DualNumber K) := Dual (re a * re b) (re a * du b + du a * re b).
  Definition dual_opp (a : DualNumber K) := Dual (- re a) (- du a).

  (** Dual numbers over a commutative ring are a commutative ring. *)
  Theorem dual_laws : ring_theory (Dual 0 0) (Dual 1 0) dual_add dual_mul dual_sub dual_opp (@eq (DualNumber K)).
  Proof.
    split; intros; unfold dual_add, dual_sub, dual_mul, dual_opp; repeat match goal with a : DualNumber K |- _ =>
      destruct a end; cbn; f_equal; ring.
  Qed.

  Definition dual : CommutativeRing := make_ring _ _ _ _ _ _ _ dual_laws.

  (** The embedding of K: numbers without dual part. *)
  Definition constant (a : K) : dual := Dual a 0.

  Theorem dual_eq (a b : dual) : re a = re b -> du a = du b -> a = b.
  Proof. destruct a, b; cbn. now intros -> ->. Qed.

  Theorem dual_of_nat n : of_nat (K := dual) n = constant (of_nat n).
  Proof. induction n as [|n E]; [easy|]. cbn. rewrite E. apply dual_eq; cbn; ring. Qed.

  (** The dual part of a power is that of x^n by the power rule, n x^(n-1) x'. *)
  Theorem dual_pow (a : dual) n : pow a (S n) = Dual (pow (re a) (S n)) (of_nat (S n) * pow (re a) n * du a).
  Proof.
    induction n as [|n E]; [apply dual_eq; cbn; ring|].
    change (pow a (S (S n))) with (a * pow a (S n)). rewrite E. apply dual_eq; cbn; ring.
  Qed.
End DualNumbers.

Arguments dual_eq {K a b} _ _.
Arguments constant {K} a.
