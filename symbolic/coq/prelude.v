(* SPDX-License-Identifier: GPL-2.0-or-later *)
(* What the emitted lemmas rest on: integers, induction, least integers, recursion, matrices as
   lists, certificates; and the axioms of the kernel, proved from Coq's real numbers. *)
Require Export Reals Lra Lia Psatz ZArith Classical ClassicalEpsilon List.
Export ListNotations.
Open Scope R_scope.
(* No files of caches beside the files that are checked. *)
#[export] Unset Lia Cache.
#[export] Unset Nia Cache.
#[export] Unset Nra Cache.

(* Integers among the real numbers. *)
Definition isint (x : R) := exists z : Z, x = IZR z.
Lemma int_num z : isint (IZR z). Proof. now exists z. Qed.
Lemma int_add x y : isint x -> isint y -> isint (x + y).
Proof. intros [a ->] [b ->]. exists (a + b)%Z. now rewrite plus_IZR. Qed.
Lemma int_mul x y : isint x -> isint y -> isint (x * y).
Proof. intros [a ->] [b ->]. exists (a * b)%Z. now rewrite mult_IZR. Qed.
Lemma int_pow x k : isint x -> isint (x ^ k).
Proof. intro I. induction k; [now exists 1%Z|now apply int_mul]. Qed.
Definition ceil (x : R) : R := IZR (1 - up (- x)).
Lemma int_ceil x : isint (ceil x). Proof. apply int_num. Qed.
Create HintDb int.
Global Hint Resolve int_num int_add int_mul int_pow int_ceil : int.
Ltac int := auto 20 with int.
Definition toN (x : R) : nat := Z.to_nat (Int_part x).
Definition fromN (k : nat) : R := IZR (Z.of_nat k).
Lemma Int_part_IZR z : Int_part (IZR z) = z.
Proof. unfold Int_part. rewrite <- (tech_up (IZR z) (z + 1)); rewrite ?plus_IZR; try lra; lia. Qed.
Lemma toN_0 : toN 0 = O. Proof. unfold toN. now rewrite (Int_part_IZR 0). Qed.
Lemma toN_next n : isint n -> 0 <= n -> toN (n + 1) = S (toN n).
Proof.
  intros [z ->] H. apply le_IZR in H. unfold toN. rewrite <- plus_IZR, !Int_part_IZR.
  rewrite Z2Nat.inj_add by lia. simpl. lia.
Qed.
Lemma fromN_toN n : isint n -> 0 <= n -> fromN (toN n) = n.
Proof.
  intros [z ->] H. apply le_IZR in H. unfold fromN, toN. now rewrite Int_part_IZR, Z2Nat.id.
Qed.
Lemma induct (P : R -> Prop) lo : isint lo -> P lo ->
  (forall n, isint n -> lo <= n /\ P n -> P (n + 1)) -> forall n, isint n -> lo <= n -> P n.
Proof.
  intros [a ->] B S n [z ->] L. apply le_IZR in L. revert z L.
  apply (Zlt_lower_bound_ind (fun z => P (IZR z)) a). intros z IH L.
  destruct (Z.eq_dec z a) as [->|N]; [exact B|].
  replace (IZR z) with (IZR (z - 1) + 1) by (rewrite minus_IZR; lra).
  apply S; [apply int_num|]. split; [apply IZR_le; lia|]. apply IH; lia.
Qed.

(* The least integer N from lo on with P. *)
Definition is_least lo (P : R -> Prop) N := isint N /\ ((exists w, isint w /\ lo <= w /\ P w) ->
  lo <= N /\ P N /\ forall w, isint w -> lo <= w -> P w -> N <= w).
Definition least lo (P : R -> Prop) : R := epsilon (inhabits 0) (is_least lo P).
Lemma least_is_least lo P : isint lo -> is_least lo P (least lo P).
Proof.
  intros [a ->]. unfold least. apply epsilon_spec.
  destruct (classic (exists w, isint w /\ IZR a <= w /\ P w)) as [[w [[z ->] [L Q]]]|E];
    [|exists 0; split; [apply int_num|tauto]].
  apply le_IZR in L. revert z L Q.
  apply (Zlt_lower_bound_ind (fun z => P (IZR z) -> exists N, is_least (IZR a) P N) a).
  intros z IH L Q.
  destruct (classic (exists y, (a <= y < z)%Z /\ P (IZR y))) as [[y [Y Py]]|F];
    [exact (IH y Y Py)|].
  exists (IZR z). split; [apply int_num|]. intros _.
  split; [now apply IZR_le|]. split; [exact Q|].
  intros w [y ->] Ly Py. apply IZR_le. apply le_IZR in Ly.
  destruct (Z_lt_le_dec y z); [|lia]. exfalso. apply F. exists y. split; [lia|exact Py].
Qed.
Lemma int_least lo P : isint lo -> isint (least lo P).
Proof. intro I. now apply least_is_least. Qed.
Lemma least_def lo P n : isint lo -> isint n -> lo <= n /\ P n ->
  lo <= least lo P /\ P (least lo P) /\ least lo P <= n.
Proof.
  intros I J [L Q]. destruct (least_is_least lo P I) as [_ H].
  destruct H as [A [B C]]; [now exists n|]. repeat split; auto.
Qed.

(* A matrix is the list of its entries, row by row. *)
Definition entry (A : list R) (k : nat) : R := nth k A 0.
Fixpoint dot (k : nat) (f : nat -> R) : R :=
  match k with O => 0 | S O => f O | S k' => dot k' f + f k' end.
Definition table (r c : nat) (f : nat -> nat -> R) : list R :=
  flat_map (fun i => map (f i) (seq 0 c)) (seq 0 r).
Definition mtimes (r m c : nat) (A B : list R) : list R :=
  table r c (fun i j => dot m (fun k => entry A (i * m + k) * entry B (k * c + j))).
Definition mtranspose (r c : nat) (A : list R) : list R :=
  table c r (fun i j => entry A (j * c + i)).
Definition munit (r : nat) : list R := table r r (fun i j => if Nat.eqb i j then 1 else 0).
Fixpoint mpow (r : nat) (A : list R) (k : nat) : list R :=
  match k with O => munit r | S k' => mtimes r r r A (mpow r A k') end.
Lemma mpow_def r A n : isint n -> mpow r A (toN 0) = munit r /\
  (0 <= n -> mpow r A (toN (n + 1)) = mtimes r r r A (mpow r A (toN n))).
Proof. intro I. split; [now rewrite toN_0|]. intro L. now rewrite (toN_next n I L). Qed.
(* Laplace's expansion by the first row that is left; s: the sign of the next column. *)
Definition signed (s : bool) (x : R) : R := if s then x else -1 * x.
Fixpoint minors (det : list nat -> R) (row : nat -> R) (s : bool) (before after : list nat) : R :=
  match after with
  | nil => 0
  | c :: nil => signed s (row c * det before)
  | c :: rest =>
      signed s (row c * det (before ++ rest)) + minors det row (negb s) (before ++ [c]) rest
  end.
Fixpoint laplace (k i n : nat) (A : list R) (columns : list nat) : R :=
  match k with
  | O => 1
  | S k' => minors (laplace k' (S i) n A) (fun j => entry A (i * n + j)) true nil columns
  end.
Definition det (n : nat) (A : list R) : R := laplace n 0 n A (seq 0 n).

(* Certificates: m (r - l) = s, where s is 0, not negative, positive. *)
Lemma zero_equation f p q : p = q -> f * (q - p) = 0. Proof. intros ->. ring. Qed.
Lemma zero_inverse f w d : w = / d -> d <> 0 -> f * (w * d - 1) = 0.
Proof. intros -> H. rewrite Rinv_l by exact H. ring. Qed.
Lemma zero_sum a b : a = 0 -> b = 0 -> a + b = 0. Proof. intros -> ->. ring. Qed.
Lemma zero_nonneg a : a = 0 -> 0 <= a. Proof. intros ->. apply Rle_refl. Qed.
Lemma gap_pos p q : p < q -> 0 < q - p. Proof. lra. Qed.
Lemma gap_nonneg p q : p <= q -> 0 <= q - p. Proof. lra. Qed.
Lemma gap_nonzero p q : ~ p = q -> q - p <> 0. Proof. intros H E. apply H. lra. Qed.
Lemma pos_nonzero x : 0 < x -> x <> 0. Proof. lra. Qed.
Lemma opp_nonzero x y : y = - x -> x <> 0 -> y <> 0. Proof. lra. Qed.
Lemma same_nonzero x y : y = x -> x <> 0 -> y <> 0. Proof. lra. Qed.
Lemma square x : 0 <= x * x. Proof. apply Rle_0_sqr. Qed.
Lemma by_eq l r m s : m * (r - l) = s -> m <> 0 -> s = 0 -> l = r.
Proof. intros E M ->. apply Rmult_integral in E. destruct E; [tauto|lra]. Qed.
Lemma by_lt l r m s : m * (r - l) = s -> 0 < m -> 0 < s -> l < r.
Proof.
  intros E M H. rewrite <- E in H. enough (0 < r - l) by lra. apply (Rmult_lt_reg_l m); lra.
Qed.
Lemma by_le l r m s : m * (r - l) = s -> 0 < m -> 0 <= s -> l <= r.
Proof.
  intros E M H. rewrite <- E in H. enough (0 <= r - l) by lra. apply (Rmult_le_reg_l m); lra.
Qed.

(* The signs of a sum of products, from the facts at hand. *)
Ltac number := clear; first [lra|solve [discrR]].
Ltac sign :=
  lazymatch goal with
  | |- _ + _ = 0 => apply zero_sum; sign
  | |- _ = 0 =>
      first [apply zero_equation; assumption | apply zero_inverse; assumption | reflexivity]
  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; sign
  | |- 0 < _ + _ =>
      first [apply Rplus_lt_le_0_compat; [sign|sign] | apply Rplus_le_lt_0_compat; [sign|sign]]
  | |- 0 < _ * (_ - _) => apply Rmult_lt_0_compat; [sign|apply gap_pos; assumption]
  | |- 0 <= _ * (_ - _) =>
      first [apply zero_nonneg; sign
            |apply Rmult_le_pos; [sign|apply gap_nonneg; first [assumption|left; assumption]]]
  | |- 0 <= _ * (_ * _) => apply Rmult_le_pos; [sign|apply square]
  | |- _ - _ <> 0 => first [apply gap_nonzero; assumption | apply pos_nonzero, gap_pos; assumption]
  | |- _ * _ <> 0 => apply Rmult_integral_contrapositive_currified; sign
  | _ => number
  end.
(* That d is not 0, where d or -d is the gap of a fact. *)
Ltac divisor gap :=
  first [apply (same_nonzero gap); [number|sign] | apply (opp_nonzero gap); [number|sign]].

(* The same formula of equal terms. *)
Lemma same_eq (T : Type) (a b c d : T) : a = c -> b = d -> (a = b <-> c = d).
Proof. intros -> ->. tauto. Qed.
Lemma same_lt a b c d : a = c -> b = d -> (a < b <-> c < d). Proof. intros -> ->. tauto. Qed.
Lemma same_le a b c d : a = c -> b = d -> (a <= b <-> c <= d). Proof. intros -> ->. tauto. Qed.
Lemma same_prop (a b : Prop) : a = b -> (a <-> b). Proof. intros ->. tauto. Qed.
Lemma same_not (a b : Prop) : (a <-> b) -> (~ a <-> ~ b). Proof. tauto. Qed.
Lemma same_and (a b c d : Prop) : (a <-> c) -> (b <-> d) -> (a /\ b <-> c /\ d). Proof. tauto. Qed.
Lemma same_or (a b c d : Prop) : (a <-> c) -> (b <-> d) -> (a \/ b <-> c \/ d). Proof. tauto. Qed.
Lemma same_imp (a b c d : Prop) : (a <-> c) -> (b <-> d) -> ((a -> b) <-> (c -> d)).
Proof. tauto. Qed.
Lemma same_iff (a b c d : Prop) : (a <-> c) -> (b <-> d) -> ((a <-> b) <-> (c <-> d)).
Proof. tauto. Qed.
Lemma same_all (P Q : R -> Prop) : (forall x, P x <-> Q x) -> ((forall x, P x) <-> forall x, Q x).
Proof. intro H. split; intros A x; apply H, A. Qed.
Lemma not_lt a b : a <= b <-> ~ b < a.
Proof. split; [apply Rle_not_lt|apply Rnot_lt_le]. Qed.

(* The axioms of the kernel. *)
Lemma ax_order x y : x < y \/ x = y \/ y < x. Proof. destruct (Rtotal_order x y); tauto. Qed.
Lemma ax_discrete i j : isint i -> isint j -> (i < j <-> i + 1 <= j).
Proof.
  intros [a ->] [b ->]. rewrite <- plus_IZR.
  split; intro H; [apply lt_IZR in H; apply IZR_le; lia|apply le_IZR in H; apply IZR_lt; lia].
Qed.
Lemma ax_ceil x : x <= ceil x /\ ceil x < x + 1.
Proof. unfold ceil. rewrite minus_IZR. destruct (archimed (- x)). lra. Qed.
Lemma minus x : -1 * x = - x. Proof. ring. Qed.
Lemma atan_bound_half x : -1 / 2 * PI < atan x /\ atan x < PI / 2.
Proof. destruct (atan_bound x). lra. Qed.
Lemma half : 1 / 2 * PI = PI / 2. Proof. field. Qed.
Lemma ax_atan_bounds x : 0 <= x -> x + -1 / 3 * x ^ 3 <= atan x /\ atan x <= x.
Proof.
  intros [H|<-]; [|rewrite atan_0; lra].
  assert (D : forall c, derivable_pt_lim atan c (/ (1 + c ^ 2))) by exact derivable_pt_lim_atan.
  destruct (MVT_cor2 (fun t => atan t + -1 * t + (1/3) * t ^ 3)
    (fun t => / (1 + t ^ 2) + -1 * 1 + (1/3) * (INR 3 * t ^ 2)) 0 x H) as [c [E C]].
  { intros c _. apply derivable_pt_lim_plus; [apply derivable_pt_lim_plus; [apply D|]|];
      apply derivable_pt_lim_scal; [apply derivable_pt_lim_id|apply (derivable_pt_lim_pow c 3)]. }
  destruct (MVT_cor2 (fun t => t + -1 * atan t) (fun t => 1 + -1 * / (1 + t ^ 2)) 0 x H)
    as [d [F G]].
  { intros d _. apply derivable_pt_lim_plus; [apply derivable_pt_lim_id|].
    apply derivable_pt_lim_scal, D. }
  rewrite atan_0 in *. assert (P : forall t, 0 < 1 + t ^ 2) by (intro t; nra).
  assert (A : / (1 + c ^ 2) + -1 * 1 + (1/3) * (INR 3 * c ^ 2) = c ^ 2 * c ^ 2 * / (1 + c ^ 2))
    by (simpl INR; pose proof (P c); field; lra).
  assert (B : 1 + -1 * / (1 + d ^ 2) = d ^ 2 * / (1 + d ^ 2)) by (pose proof (P d); field; lra).
  rewrite A in E. rewrite B in F.
  pose proof (Rinv_0_lt_compat _ (P c)). pose proof (Rinv_0_lt_compat _ (P d)).
  assert (0 <= c ^ 2 * c ^ 2 * / (1 + c ^ 2) * (x - 0))
    by (repeat apply Rmult_le_pos; try lra; apply pow2_ge_0).
  assert (0 <= d ^ 2 * / (1 + d ^ 2) * (x - 0))
    by (repeat apply Rmult_le_pos; try lra; apply pow2_ge_0).
  split; lra.
Qed.
(* Matrices of n entries are equal where all entries are. *)
Lemma same_matrix n A B : length A = n -> length B = n ->
  (forall k, (k < n)%nat -> entry A k = entry B k) -> A = B.
Proof. intros <- L H. now apply (nth_ext A B 0 0). Qed.
Ltac entries_of H k :=
  lazymatch goal with
  | |- _ /\ _ => split; [exact (f_equal (fun z => entry z k) H)|entries_of H constr:(S k)]
  | _ => exact (f_equal (fun z => entry z k) H)
  end.
Ltac from_entries k E :=
  lazymatch type of E with
  | _ /\ _ => destruct k; [exact (proj1 E)|apply proj2 in E; from_entries k E]
  | _ => destruct k; [exact E|lia]
  end.
Ltac size := first [reflexivity | match goal with |- context [toN ?n] => now destruct (toN n) end].
Ltac entrywise n :=
  let H := fresh in
  let k := fresh in
  split; intro H;
  [entries_of H O|apply (same_matrix n); [size|size|intros k ?; from_entries k H]].
(* Each axiom of the kernel is one of these. *)
Ltac axiom :=
  intros; rewrite ?minus, ?half, <- ?Rsqr_pow2;
  first [apply ax_order | lra | now apply ax_discrete | now apply Rsqr_sqrt | apply sqrt_pos
  |apply ax_ceil | apply sin_0 | apply cos_0 | apply sin_plus | rewrite cos_plus; ring
  |apply sin_neg | apply cos_neg | apply sin2_cos2 | apply sin_PI | apply cos_PI | apply sin_PI2
  |apply cos_PI2 | now apply sin_gt_0 | apply cos_decreasing_1; lra
  |apply PI_RGT_0 | rewrite <- atan_0; now apply atan_increasing | apply atan_bound_half
  |rewrite cos_atan; unfold Rdiv; ring | apply sin_atan | now apply ax_atan_bounds].
