(** Dual parts are derivatives: the dual part of a polynomial at x + ε h is its derivative at x along h.

    The derivative is the coefficient of t in f(x + t h) = f(x) + t f' + t² r(t), with a polynomial r. *)

From dualcay Require Export Rings.

(** Polynomials in any number of variables. *)
Inductive Expression (K : CommutativeRing) :=
  | Number (a : K)
  | Coordinate (index : nat)
  | Sum (e f : Expression K)
  | Difference (e f : Expression K)
  | Product (e f : Expression K).
Arguments Number {K} a.
Arguments Coordinate {K} index.
Arguments Sum {K} e f.
Arguments Difference {K} e f.
Arguments Product {K} e f.

Fixpoint value {K : CommutativeRing} (e : Expression K) (x : nat -> K) : K := match e with
  | Number a => a
  | Coordinate i => x i
  | Sum e f => value e x + value f x
  | Difference e f => value e x - value f x
  | Product e f => value e x * value f x
  end.

(** The same polynomial over the dual numbers. *)
Fixpoint over_dual {K : CommutativeRing} (e : Expression K) : Expression (dual K) := match e with
  | Number a => Number (constant a)
  | Coordinate i => Coordinate i
  | Sum e f => Sum (over_dual e) (over_dual f)
  | Difference e f => Difference (over_dual e) (over_dual f)
  | Product e f => Product (over_dual e) (over_dual f)
  end.

Section Derivatives.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types (e : Expression K) (x h : nat -> K) (t : K).

  Definition dual_value e x h : dual K := value (over_dual e) (fun i => Dual (x i) (h i) : dual K).

  Theorem real_part_is_value e x h : re (dual_value e x h) = value e x.
  Proof. induction e; cbn; unfold dual_value in *; cbn in *; try reflexivity; now rewrite IHe1, IHe2. Qed.

  Theorem dual_part_is_derivative e x h :
    exists r, forall t, value e (fun i => x i + t * h i) =
      value e x + t * du (dual_value e x h) + t * t * value r (fun _ => t).
  Proof.
    pose (t := Coordinate (K := K) 0). induction e as [a|i|e [r E] f [s F]|e [r E] f [s F]|e [r E] f [s F]].
    - exists (Number 0). intros u. cbn. ring.
    - exists (Number 0). intros u. cbn. ring.
    - exists (Sum r s). intros u. cbn [value]. rewrite E, F. cbn. fold (dual_value e x h) (dual_value f x h). ring.
    - exists (Difference r s). intros u. cbn [value]. rewrite E, F. cbn. fold (dual_value e x h) (dual_value f x h).
      ring.
    - exists (Sum (Product (Sum (Number (value e x)) (Product t (Number (du (dual_value e x h))))) s)
        (Sum (Product r (Sum (Number (value f x)) (Product t (Number (du (dual_value f x h))))))
          (Sum (Number (du (dual_value e x h) * du (dual_value f x h))) (Product (Product t t) (Product r s))))).
      intros u. cbn [value]. rewrite E, F.
      change (du (dual_value (Product e f) x h)) with
        (re (dual_value e x h) * du (dual_value f x h) + du (dual_value e x h) * re (dual_value f x h)).
      rewrite !real_part_is_value. cbn. ring.
  Qed.
End Derivatives.
