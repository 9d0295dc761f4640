(** Binomial sums of p_n, q_n, c_n and d_n, CP23 (51), (52), (63), (64), and the binomial theorem. *)

From dualcay Require Export Polynomials.
From Coq Require Import Lia.

(** Binomial coefficients, by Pascal's rule. *)
Fixpoint choose (n k : nat) : nat :=
  match n, k with
  | _, O => 1
  | O, S _ => 0
  | S m, S j => choose m j + choose m (S j)
  end.

Theorem choose_zero n : choose n 0 = 1%nat.
Proof. now destruct n. Qed.

Theorem choose_one n : choose n 1 = n.
Proof. induction n as [|n E]; [easy|]. cbn [choose]. now rewrite E, choose_zero. Qed.

Theorem choose_beyond n : forall k, n < k -> choose n k = 0%nat.
Proof. induction n; intros [|k] H; cbn; try lia. rewrite !IHn; lia. Qed.

Section Sums.
  Variable K : CommutativeRing.
  Add Ring scalars : (laws K).
  Implicit Types x y : K.

  (** Sum of the terms j = 0 … count - 1. *)
  Fixpoint sum (term : nat -> K) (count : nat) : K := match count with O => 0 | S m => sum term m + term m end.

  Theorem sum_equal f g count : (forall j, f j = g j) -> sum f count = sum g count.
  Proof. intros E. induction count; cbn; now rewrite ?IHcount, ?E. Qed.

  Theorem sum_add f g count : sum (fun j => f j + g j) count = sum f count + sum g count.
  Proof. induction count; cbn; [|rewrite IHcount]; ring. Qed.

  Theorem sum_scale a f count : sum (fun j => a * f j) count = a * sum f count.
  Proof. induction count; cbn; [|rewrite IHcount]; ring. Qed.

  Theorem sum_first f count : sum f (S count) = f 0%nat + sum (fun j => f (S j)) count.
  Proof. induction count; [cbn; ring|]. change (sum f (S (S count))) with (sum f (S count) + f (S count)).
    rewrite IHcount. cbn. ring. Qed.

  (** Sums over every second binomial coefficient, from [first] on: the terms are (-x)^j C(n, 2 j + first). *)
  Definition alternate x first n count := sum (fun j => pow (- x) j * of_nat (choose n (2 * j + first))) count.

  Theorem alternate_next x first n count :
    alternate x (S first) (S n) count = alternate x (S first) n count + alternate x first n count.
  Proof.
    unfold alternate. rewrite <- sum_add. apply sum_equal. intros j. rewrite <- plus_n_Sm. cbn [choose].
    rewrite of_nat_add. ring.
  Qed.

  (** A sum is its first term minus x times the sum that starts two coefficients later. *)
  Theorem alternate_first x first n count : n < 2 * count ->
    alternate x first n (S count) = of_nat (choose n first) - x * alternate x (S (S first)) n (S count).
  Proof.
    intros H. unfold alternate at 1. rewrite sum_first. change (2 * 0 + first)%nat with first.
    replace (alternate x (S (S first)) n (S count)) with (alternate x (S (S first)) n count)
      by (unfold alternate; cbn [sum]; rewrite (choose_beyond n (2 * count + S (S first))) by lia; cbn [of_nat]; ring).
    unfold alternate. replace (sum _ count) with
      (- x * sum (fun j => pow (- x) j * of_nat (choose n (2 * j + S (S first)))) count).
    - cbn [pow]. ring.
    - rewrite <- sum_scale. apply sum_equal. intros j.
      replace (2 * S j + first)%nat with (2 * j + S (S first))%nat by lia. cbn [pow]. ring.
  Qed.

  Theorem alternate_zero x n count : n < 2 * count -> alternate x 0 n (S count) = 1 - x * alternate x 2 n (S count).
  Proof. intros H. rewrite alternate_first, choose_zero by exact H. cbn [of_nat]. ring. Qed.

  Theorem alternate_start x first count : alternate x (S first) 0 count = 0.
  Proof. induction count as [|k E]; unfold alternate in *; cbn [sum]; [ring|]. rewrite E, <- plus_n_Sm.
    cbn [choose of_nat]. ring. Qed.

  (** Binomial sums of p_n and q_n; terms beyond n are zero. *)
  Theorem binomial_sums x n count : n < 2 * count -> p x n = alternate x 0 n (S count) /\ q x n =
    alternate x 1 n (S count).
  Proof.
    induction n as [|n I]; intros H.
    - rewrite alternate_zero, !alternate_start by lia. cbn. split; ring.
    - destruct I as [E F]; [lia|]. next. rewrite (alternate_next x 0 n). rewrite <- E, <- F. split; [|ring].
      rewrite alternate_zero by lia. rewrite (alternate_next x 1 n), <- F. rewrite E, alternate_zero by lia. ring.
  Qed.

  (** Binomial theorem; and the sum that remains when 1 is taken away and x divided out. *)
  Definition binomial x first n count := sum (fun j => pow x j * of_nat (choose n (j + first))) count.

  Theorem binomial_next x first n count : binomial x (S first) (S n) count =
    binomial x (S first) n count + binomial x first n count.
  Proof.
    unfold binomial. rewrite <- sum_add. apply sum_equal. intros j. rewrite <- plus_n_Sm. cbn [choose].
    rewrite of_nat_add. ring.
  Qed.

  Theorem binomial_zero x n count : n < count -> binomial x 0 n (S count) = 1 + x * binomial x 1 n (S count).
  Proof.
    intros H. unfold binomial at 1. rewrite sum_first. change (0 + 0)%nat with 0%nat. rewrite choose_zero. cbn [of_nat].
    replace (binomial x 1 n (S count)) with (binomial x 1 n count)
      by (unfold binomial; cbn [sum]; rewrite (choose_beyond n (count + 1)) by lia; cbn [of_nat]; ring).
    unfold binomial. replace (sum _ count) with (x * sum (fun j => pow x j * of_nat (choose n (j + 1))) count).
    - cbn [pow]. ring.
    - rewrite <- sum_scale. apply sum_equal. intros j. replace (S j + 0)%nat with (j + 1)%nat by lia. cbn [pow]. ring.
  Qed.

  Theorem binomial_start x first count : binomial x (S first) 0 count = 0.
  Proof. induction count as [|k E]; unfold binomial in *; cbn [sum]; [ring|]. rewrite E, <- plus_n_Sm.
    cbn [choose of_nat]. ring. Qed.

  Theorem binomial_theorem x n count : n < count -> pow (1 + x) n = binomial x 0 n (S count).
  Proof.
    induction n as [|n I]; intros H.
    - rewrite binomial_zero, binomial_start by lia. cbn. ring.
    - cbn [pow]. rewrite I by lia. rewrite (binomial_zero x (S n)), binomial_next by lia.
      rewrite (binomial_zero x n) by lia. ring.
  Qed.

  (** d_n = q_n + n a_n - r_n with a_n and r_n the sums from 2 and from 3. *)
  Theorem binomial_sum_of_d x n count : n < 2 * count ->
    d x n = alternate x 1 n (S count) + of_nat n * alternate x 2 n (S count) - alternate x 3 n (S count).
  Proof.
    induction n as [|n I]; intros H.
    - rewrite !alternate_start. unfold d. cbn. ring.
    - rewrite d_next, I by lia. rewrite !alternate_next. destruct (binomial_sums x n count) as [-> ->]; [lia|].
      cbn [of_nat]. ring.
  Qed.

  (** Sums from 2, of (1 + x)^n and of p_2n, together are 2 q_n². *)
  Theorem sums_of_squares x n count : n + n < 2 * count ->
    binomial x 1 n (S count) + alternate x 2 (n + n) (S count) = 2 * (q x n * q x n).
  Proof.
    induction n as [|n I]; intros H.
    - cbn [Nat.add]. rewrite binomial_start, alternate_start. cbn. ring.
    - rewrite <- plus_n_Sm. cbn [Nat.add]. rewrite binomial_next, !alternate_next.
      destruct (binomial_sums x (n + n) count) as [<- <-]; [lia|]. destruct (doubling K x n) as [D E]. rewrite D, E.
      rewrite <- (binomial_theorem x n count), <- norm by lia. specialize (I ltac:(lia)). next. combine (1 *: I).
  Qed.

  (** 2 c_n = 2 n s_(n-1) + r_2n with s the sum of (1 + x)^(n-1) from 1 and r the sum from 3. *)
  Theorem binomial_sum_of_c x n count : S n + S n < 2 * count ->
    2 * c x (S n) = 2 * (of_nat (S n) * binomial x 1 n (S count)) + alternate x 3 (S n + S n) (S count).
  Proof.
    induction n as [|n I]; intros H.
    - cbn [Nat.add]. rewrite binomial_start, !alternate_next, !alternate_start. unfold c.
      cbn. ring.
    - rewrite c_next. specialize (I ltac:(lia)).
      replace (S (S n) + S (S n))%nat with (S (S (S n + S n))) by lia. rewrite !alternate_next.
      pose proof (sums_of_squares x (S n) count ltac:(lia)) as Q.
      pose proof (alternate_first x 1 (S n + S n) count ltac:(lia)) as R. rewrite choose_one, of_nat_add in R.
      destruct (binomial_sums x (S n + S n) count) as [_ F]; [lia|]. rewrite (proj2 (doubling K x (S n))) in F.
      rewrite (q_next x (S n)). rewrite binomial_next in *. rewrite (binomial_zero x n) in * by lia.
      cbn [of_nat] in *.
      combine ((1 + x) *: I +: 1 *: R +: 2 *: F +: - (2) *: Q).
  Qed.
End Sums.
