(** Polynomials p_n and q_n of x with their slopes, and the brackets c_n and d_n, for every n.

    They are defined by recurrences, so that nothing is divided by x. *)

From dualcay Require Export Rings.

Section Definitions.
  Context {K : CommutativeRing}.
  Variable x : K.

  (** p_(n+1) = p_n - x q_n and q_(n+1) = p_n + q_n, from p_0 = 1 and q_0 = 0. *)
  Fixpoint p (n : nat) : K := match n with O => 1 | S m => p m - x * q m end
  with q (n : nat) : K := match n with O => 0 | S m => p m + q m end.

  (** Slopes: derivatives of p_n and q_n by x. *)
  Fixpoint p_slope (n : nat) : K := match n with O => 0 | S m => p_slope m - q m - x * q_slope m end
  with q_slope (n : nat) : K := match n with O => 0 | S m => p_slope m + q_slope m end.

  Theorem p_next n : p (S n) = p n - x * q n. Proof. easy. Qed.
  Theorem q_next n : q (S n) = p n + q n. Proof. easy. Qed.
  Theorem p_slope_next n : p_slope (S n) = p_slope n - q n - x * q_slope n. Proof. easy. Qed.
  Theorem q_slope_next n : q_slope (S n) = p_slope n + q_slope n. Proof. easy. Qed.

  Definition c n := 2 * (p n * q_slope n - q n * p_slope n).
  Definition d n := q n - 2 * q_slope n - 2 * p_slope n.
End Definitions.

(** [next] replaces values of order n + 1 by those of order n. *)
Ltac next := cbn [pow of_nat Nat.add]; rewrite ?p_slope_next, ?q_slope_next, ?p_next, ?q_next.

Section Laws.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types x y i r : K.

  (** The orders start at 1 with p_1 = q_1 = 1. *)
  Theorem first_order x : p x 1 = 1 /\ q x 1 = 1.
  Proof. cbn. split; ring. Qed.

  (** Powers of 1 + i r are p_n + i r q_n, when i² = -1. *)
  Theorem powers i r n : i * i = - (1) -> pow (1 + i * r) n = p (r * r) n + i * r * q (r * r) n.
  Proof. intros H. induction n as [|n E]; [cbn; ring|]. next. rewrite E. combine (r * r * q (r * r) n *: H). Qed.

  (** p_n² + x q_n² = (1 + x)^n. *)
  Theorem norm x n : p x n * p x n + x * (q x n * q x n) = pow (1 + x) n.
  Proof. induction n as [|n E]; [cbn; ring|]. next. rewrite <- E. ring. Qed.

  (** Addition law. *)
  Theorem addition x m n :
    p x (m + n) = p x m * p x n - x * (q x m * q x n) /\ q x (m + n) = p x m * q x n + q x m * p x n.
  Proof. induction m as [|m [E F]]; [cbn; split; ring|]. next. rewrite E, F. split; ring. Qed.

  Theorem doubling x n :
    p x (n + n) = p x n * p x n - x * (q x n * q x n) /\ q x (n + n) = 2 * (p x n * q x n).
  Proof. destruct (addition x n n) as [-> ->]. split; ring. Qed.

  (** The dual part of p_n and q_n at x + ε y is the slope at x, multiplied by y. *)
  Theorem slopes_are_dual_parts x y n :
    p (Dual x y : dual K) n = Dual (p x n) (p_slope x n * y) /\
    q (Dual x y : dual K) n = Dual (q x n) (q_slope x n * y).
  Proof.
    induction n as [|n [E F]]; [split; apply dual_eq; cbn; ring|].
    next.
    rewrite E, F. split; apply dual_eq; cbn; ring.
  Qed.

  (** Closed slopes of the next order: 2 p' = -n q_(n-1) and 2 x q' = n p_(n-1) - q_n. *)
  Theorem closed_slopes x n :
    2 * p_slope x (S n) = - (of_nat (S n) * q x n) /\ 2 * (x * q_slope x (S n)) = of_nat (S n) * p x n - q x (S n).
  Proof.
    induction n as [|n [E F]]; [cbn; split; ring|].
    rewrite (p_slope_next x (S n)), (q_slope_next x (S n)), (q_next x (S n)), (p_next x n), (q_next x n) in *.
      cbn [of_nat] in *.
    split.
    - combine (1 *: E +: - (1) *: F).
    - combine (x *: E +: 1 *: F).
  Qed.

  (** 2 (1 + x) p' = n (p - q). *)
  Theorem p_slope_equation x n : 2 * ((1 + x) * p_slope x n) = of_nat n * (p x n - q x n).
  Proof.
    destruct n; [unfold c, d; cbn; ring|]. destruct (closed_slopes x n) as [E _]. rewrite (p_next x n), (q_next x n).
    combine ((1 + x) *: E).
  Qed.

  (** 2 x q' = n (p + x q) / (1 + x) - q, multiplied by 1 + x. *)
  Theorem q_slope_equation x n :
    2 * (x * ((1 + x) * q_slope x n)) = of_nat n * (p x n + x * q x n) - (1 + x) * q x n.
  Proof.
    destruct n; [unfold c, d; cbn; ring|]. destruct (closed_slopes x n) as [_ E].
      rewrite (p_next x n), (q_next x n) in *.
    combine ((1 + x) *: E).
  Qed.

  (** The slope of p² + x q² is that of (1 + x)^n. *)
  Theorem norm_slope x n :
    2 * (p x (S n) * p_slope x (S n)) + q x (S n) * q x (S n) + 2 * (x * (q x (S n) * q_slope x (S n))) =
    of_nat (S n) * pow (1 + x) n.
  Proof.
    destruct (closed_slopes x n) as [E F]. rewrite <- norm. rewrite (p_next x n), (q_next x n) in *.
    combine ((p x n - x * q x n) *: E +: (p x n + q x n) *: F).
  Qed.

  (** Brackets: x c = n (1 + x)^(n-1) - p q and x d = (1 + x) q - n p. *)
  Theorem bracket_c x n : x * c x (S n) = of_nat (S n) * pow (1 + x) n - p x (S n) * q x (S n).
  Proof.
    destruct (closed_slopes x n) as [E F]. rewrite <- norm. unfold c. rewrite (p_next x n), (q_next x n) in *.
    combine ((p x n - x * q x n) *: F +: - (x * (p x n + q x n)) *: E).
  Qed.

  Theorem bracket_d x n : x * d x n = (1 + x) * q x n - of_nat n * p x n.
  Proof.
    destruct n; [unfold c, d; cbn; ring|]. destruct (closed_slopes x n) as [E F]. unfold d.
      rewrite (p_next x n), (q_next x n) in *.
    combine (- (1) *: F +: - x *: E).
  Qed.

  (** (1 + x) c = n q² - p d, without a division by x. *)
  Theorem brackets_related x n : (1 + x) * c x n = of_nat n * (q x n * q x n) - p x n * d x n.
  Proof.
    destruct n; [unfold c, d; cbn; ring|]. destruct (closed_slopes x n) as [E F]. unfold c, d.
      rewrite (p_next x n), (q_next x n) in *.
    combine ((p x n - x * q x n) *: F +: - ((1 + x) * (p x n + q x n) + (p x n - x * q x n)) *: E).
  Qed.

  Theorem c_next x n : c x (S n) = (1 + x) * c x n + 2 * (q x n * q x (S n)).
  Proof. unfold c. next. ring. Qed.

  Theorem d_next x n : d x (S n) = d x n + p x n + of_nat (S n) * q x n.
  Proof.
    destruct n; [unfold c, d; cbn; ring|]. destruct (closed_slopes x n) as [E F]. unfold d.
    rewrite (p_slope_next x (S n)), (q_slope_next x (S n)), (q_next x (S n)), (p_next x n), (q_next x n) in *.
    cbn [of_nat] in *. combine (1 *: F +: - (1) *: E).
  Qed.

  (** Values at x = 0. *)
  Theorem values_at_zero n :
    p (0 : K) n = 1 /\ q (0 : K) n = of_nat n /\ 2 * p_slope (0 : K) n = - (of_nat n * (of_nat n - 1)) /\
    2 * (3 * q_slope (0 : K) n) = - (of_nat n * ((of_nat n - 1) * (of_nat n - 2))).
  Proof.
    induction n as [|n (E & F & G & H)]; [cbn; repeat split; ring|]. next. rewrite E, F. repeat split; try ring.
    - combine (1 *: G).
    - combine (3 *: G +: 1 *: H).
  Qed.

  Theorem brackets_at_zero n :
    3 * c (0 : K) n = 2 * (of_nat n * (of_nat n * of_nat n - 1)) /\
    3 * d (0 : K) n = of_nat n * (of_nat n * of_nat n + 2).
  Proof.
    destruct (values_at_zero n) as (E & F & G & H). unfold c, d. rewrite E, F. split.
    - combine (1 *: H +: - (3 * of_nat n) *: G).
    - combine (- (1) *: H +: - (3) *: G).
  Qed.
End Laws.
