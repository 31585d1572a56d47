; Ghost sums of pe2.sv over the integers. Each block negates a statement: `unsat` means it holds.
(declare-const a Int) (declare-const b Int) (declare-const c Int) (declare-const d Int) (declare-const e Int) (declare-const f Int)
(declare-const a2 Int) (declare-const b2 Int) (declare-const p0 Int) (declare-const i0 Int)
(declare-const x Int) (declare-const y Int)
(declare-const sum_a2x Int) (declare-const sum_cy Int) (declare-const sum_b2y Int)
(declare-const sum_pixels Int) (declare-const sum_lines Int)
(declare-const first_step Int) (declare-const pixel_step Int) (declare-const line_step Int)

; The closed forms. The last two are written twice themselves, to stay in the integers when a2 or b2 is odd.
(define-fun a2x ((x Int)) Int (* a2 x))
(define-fun cy ((y Int)) Int (* c y))
(define-fun b2y ((y Int)) Int (* b2 y))
(define-fun twice_pixels ((x Int) (y Int)) Int (+ (* 2 p0 x) (* 2 c x y) (* a2 x (- x 1))))
(define-fun twice_lines ((y Int)) Int (+ (* 2 i0 y) (* b2 y (- y 1))))

(push) ; at the start, and at the first pixel of a line, the sums that are cleared are 0
(assert (not (and (= 0 (a2x 0)) (= 0 (twice_pixels 0 y)) (= 0 (cy 0)) (= 0 (b2y 0)) (= 0 (twice_lines 0)))))
(check-sat) (pop)

(push) ; one more pixel: sum_a2x grows by a2
(assert (= sum_a2x (a2x x)))
(assert (not (= (+ sum_a2x a2) (a2x (+ x 1)))))
(check-sat) (pop)

(push) ; one more line: sum_cy grows by c, sum_b2y by b2
(assert (= sum_cy (cy y)))
(assert (= sum_b2y (b2y y)))
(assert (not (and (= (+ sum_cy c) (cy (+ y 1))) (= (+ sum_b2y b2) (b2y (+ y 1))))))
(check-sat) (pop)

(push) ; one more pixel: sum_pixels grows by the pixel step, p0 + sum_cy + sum_a2x
(assert (= (* 2 sum_pixels) (twice_pixels x y)))
(assert (= pixel_step (+ p0 (cy y) (a2x x))))
(assert (not (= (* 2 (+ sum_pixels pixel_step)) (twice_pixels (+ x 1) y))))
(check-sat) (pop)

(push) ; one more line: sum_lines grows by the line step, i0 + sum_b2y
(assert (= (* 2 sum_lines) (twice_lines y)))
(assert (= line_step (+ i0 (b2y y))))
(assert (not (= (* 2 (+ sum_lines line_step)) (twice_lines (+ y 1)))))
(check-sat) (pop)

(push) ; with the preconditioned words, f + sum_lines + sum_pixels is the polynomial
(assert (= a2 (* 2 a)))
(assert (= b2 (* 2 b)))
(assert (= p0 (+ d a)))
(assert (= i0 (+ e b)))
(assert (= (* 2 sum_pixels) (twice_pixels x y)))
(assert (= (* 2 sum_lines) (twice_lines y)))
(assert (not (= (+ f sum_lines sum_pixels)
                (+ (* a x x) (* b y y) (* c x y) (* d x) (* e y) f))))
(check-sat) (pop)
