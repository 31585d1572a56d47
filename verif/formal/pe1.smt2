; Ghost sums of pe1.sv over the integers. Each block negates a statement: `unsat` means it holds.
(declare-const a Int) (declare-const b Int) (declare-const c Int)
(declare-const x Int) (declare-const y Int)
(declare-const sum_ax Int) (declare-const sum_by Int)
(declare-const u Int) (declare-const v Int) (declare-const i Int) (declare-const j Int) (declare-const modulus Int)

(push) ; at the start, and at the first pixel of a line
(assert (not (and (= 0 (* a 0)) (= 0 (* b 0)))))
(check-sat) (pop)

(push) ; one more pixel
(assert (= sum_ax (* a x)))
(assert (not (= (+ sum_ax a) (* a (+ x 1)))))
(check-sat) (pop)

(push) ; one more line
(assert (= sum_by (* b y)))
(assert (not (= (+ sum_by b) (* b (+ y 1)))))
(check-sat) (pop)

(push) ; reduction modulo 2^N commutes with addition: residues u, v of u + i modulus, v + j modulus
(assert (not (= (+ (+ u (* i modulus)) (+ v (* j modulus))) (+ (+ u v) (* (+ i j) modulus)))))
(check-sat) (pop)
