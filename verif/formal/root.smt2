; The square of the root over the integers, for root_lemma.sv and square_root.sv. Each block negates a statement: `unsat` means it
; holds.
(declare-const square Int) (declare-const root Int) (declare-const digits Int)
(declare-const x Int) (declare-const remainder Int)

(push) ; before the first row: no digits, no square
(assert (not (= 0 (* 0 0))))
(check-sat) (pop)

(push) ; digit 0: the square of 2 root
(assert (= square (* root root)))
(assert (not (= (* 4 square) (* (* 2 root) (* 2 root)))))
(check-sat) (pop)

(push) ; digit 1: the square of 2 root + 1
(assert (= square (* root root)))
(assert (not (= (+ (* 4 square) (* 4 root) 1) (* (+ (* 2 root) 1) (+ (* 2 root) 1)))))
(check-sat) (pop)

(push) ; after the last row: root^2 <= x < (root + 1)^2, and the remainder is what is left
(assert (= square (* root root)))
(assert (= x (+ square remainder)))
(assert (<= 0 remainder (* 2 root)))
(assert (not (and (<= (* root root) x) (< x (* (+ root 1) (+ root 1))) (= remainder (- x (* root root))))))
(check-sat) (pop)
