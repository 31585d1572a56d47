; Pixels of finished lines in raster_control.sv over the integers. Each block negates a statement: `unsat` means it holds.
(declare-const width Int) (declare-const height Int) (declare-const y Int) (declare-const done Int) (declare-const count Int)

(push) ; at the start
(assert (not (= 0 (* 0 width))))
(check-sat) (pop)

(push) ; one more line
(assert (= done (* y width)))
(assert (not (= (+ done width) (* (+ y 1) width))))
(check-sat) (pop)

(push) ; at the last pixel the count is the area
(assert (= done (* y width)))
(assert (= y (- height 1)))
(assert (= count (+ done width)))
(assert (not (= count (* width height))))
(check-sat) (pop)

(push) ; 12-bit sizes: the area fits the 24 bits of the count
(assert (and (<= 1 width 4095) (<= 1 height 4095)))
(assert (not (< (* width height) 16777216)))
(check-sat) (pop)
