//! What is built, simulated, written and refused.

use imogene_hdl::{
    Bits, Bundle, Design, Int, Simulator, Value, bundle, join, memory, module, net,
    read_only_memory, unregistered, verilog,
};

fn refusal<T>(build: impl FnOnce() -> T + std::panic::UnwindSafe) -> String {
    let outcome = std::panic::catch_unwind(|| {
        Design::of(|| {
            module("part", "top", (), |()| {
                build();
            });
        });
    });
    let problem = outcome.expect_err("it is no circuit");
    problem.downcast_ref::<String>().expect("a message").clone()
}

fn assert_parts(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "{part} is not in\n{text}");
    }
}

#[test]
fn what_is_no_circuit_is_refused_with_names_and_lines() {
    let sum = refusal(|| {
        net! {
            let narrow = Bits::new(1, 4).reg();
            let wide = Bits::new(1, 5).reg();
        }
        let _ = narrow + wide;
    });
    let parts = [
        "`narrow` (word of 4 bits",
        "is added to",
        "`wide` (word of 5 bits",
        "tests/all/circuits.rs:",
        "`part`",
    ];
    assert_parts(&sum, &parts);
    assert!(refusal(|| Bits::new(16, 4)).contains("16 has no 4 bits"));
    assert!(refusal(|| Int::new(-9, 4)).contains("-9 has no 4 bits"));
    assert!(refusal(|| Bits::new(0, 65)).contains("65 bits: a value has 1 to 64"));
    assert!(refusal(|| Bits::register(3).named("idle")).contains("`idle` (word of 3 bits"));
    assert!(refusal(|| Bits::forward(3)).contains("is driven by nothing"));
    let twice = refusal(|| {
        let value = Bits::register(2).named("state");
        value.load(value);
        value.load(value);
    });
    assert_parts(&twice, &["`state`", "is loaded twice"]);
    let selects = refusal(|| Bits::new(2, 2).select(Bits::new(1, 1), Bits::new(0, 1)));
    assert_parts(&selects, &["selects, but is no single bit"]);
    let reserved = refusal(|| module("inner", "inner", ("end", Bits::new(1, 1)), |_| ()));
    assert_parts(&reserved, &["port `end` of module `inner`"]);
    let ports = || (("a", Bits::new(1, 1)), ("a", Bits::new(0, 1)));
    let twice = refusal(move || module("inner", "inner", ports(), |_| ()));
    assert!(twice.contains("two ports `a`"), "{twice}");
    let apart = refusal(|| {
        let outer = Bits::new(1, 1).reg().named("outer");
        module("inner", "inner", (), |()| ("value", outer.reg()));
    });
    assert_parts(&apart, &["`outer`", "belongs to another module"]);
}

#[test]
fn a_loop_without_a_register_is_refused_by_name() {
    let design = Design::of(|| {
        module("ring", "top", ("x", Bits::input(4)), |x| {
            let value = Bits::forward(4);
            net! { let next = value + x; }
            value.drive(next);
            ("value", value)
        });
    });
    let outcome = std::panic::catch_unwind(|| Simulator::new(&design));
    let problem = outcome.err().expect("a loop");
    let problem = problem.downcast_ref::<String>().expect("a message");
    assert_parts(problem, &["`next`", "depends on itself within one clock"]);
}

/// Two that are equal are one module; others of the same name are told apart by their width.
#[test]
fn equal_modules_are_one() {
    fn later(at: &str, value: Bits) -> Bits {
        module("later", at, ("value", value), |value| ("late", value.reg()))
    }
    let design = Design::of(|| {
        let ports = (("x", Bits::input(4)), ("y", Bits::input(5)));
        module("pair", "top", ports, |(x, y)| {
            let p = later("one", later("two", x));
            (("p", p), ("q", later("three", y)))
        });
    });
    let modules = design.top.all();
    let names: Vec<&str> = modules.iter().map(|module| &*module.name).collect();
    assert_eq!(names, ["later_w4", "later_w5", "pair"]);
}

bundle! {
    /// One element of a row.
    Link(width) {
        value: Bits(width), "what is handed on";
    }
}

/// A row of equal parts is a loop, and the enables of registers stand one within the other.
#[test]
fn verilog_is_written_as_people_read_it() {
    let design = Design::of(|| {
        let ports = (
            Link::input(8),
            ("enable", Bits::input(1)),
            ("clear", Bits::input(1)),
        );
        module("row", "top", ports, |(link, enable, clear)| {
            let step = |value: Bits, index: u32| {
                let ports = (("value", value), ("enable", enable));
                let body = |(value, enable): (Bits, Bits)| ("late", value.reg_when(enable));
                module("step", &format!("steps_{index}"), ports, body)
            };
            let last = (0..4).fold(link.value, step);
            net! {
                let count = Bits::register(8);
                let total = Bits::register(8);
            }
            count.load_when(enable, count + Bits::new(1, 8));
            total.load_when(enable & clear, last);
            (("sum", count + total), ("high", last.bit(7)))
        });
    });
    let text = verilog::write(&design.top, "my_");
    let parts = [
        "module my_row (",
        "    wire [7:0] steps_value [0:4];\n",
        "    assign steps_value[0] = value;\n",
        "    for (k = 0; k < 4; k = k + 1) begin : steps\n        my_step step (",
        ".value(steps_value[k]), .enable(enable),",
        ".late(steps_value[k + 1]));\n",
        "    assign sum = count + total;\n    assign high = steps_value[4][7];\n",
        "        if (enable) begin\n            count <= count + 8'd1;\n",
        "            if (clear) total <= steps_value[4];\n",
    ];
    assert_parts(&text, &parts);
}

/// An element of a row is called by the row's name without its `s`, if Verilog takes that.
#[test]
fn no_element_of_a_row_is_a_reserved_word() {
    let design = Design::of(|| {
        module("pair", "top", ("value", Bits::input(1)), |value| {
            let late = |value: Bits| ("late", value.reg());
            let next = |value, index: u32| {
                module("step", &format!("modules_{index}"), ("value", value), late)
            };
            ("later", (0..2).fold(value, next))
        });
    });
    let text = verilog::write(&design.top, "");
    assert_parts(&text, &["begin : modules\n        step one ("]);
}

/// A literal stands on the right of a comparison, whichever way it was asked.
#[test]
fn what_is_compared_with_a_literal_stands_before_it() {
    let design = Design::of(|| {
        let ports = ("value", Int::input(8));
        module("compared", "top", ports, |value| {
            let five = Int::new(5, 8);
            let (above, below) = (five.less(value), value.less(five));
            (
                ("above", above),
                ("below", below),
                ("at_most", !five.less(value)),
            )
        });
    });
    let text = verilog::write(&design.top, "");
    assert_parts(&text, &["above = value > 8'sd5;", "below = value < 8'sd5;"]);
    let mut simulator = Simulator::new(&design);
    let [value, above, below, at_most] =
        ["value", "above", "below", "at_most"].map(|name| simulator.port(name));
    for (number, expected) in [(4, [0, 1, 1]), (5, [0, 0, 1]), (6, [1, 0, 0])] {
        simulator.set(value, number);
        let found = [above, below, at_most].map(|port| simulator.get(port));
        assert_eq!(found, expected);
    }
}

/// A group takes new values where it is enabled, and holds them else.
#[test]
fn a_group_is_held_until_it_is_enabled() {
    let design = Design::of(|| {
        let ports = (("word", Bits::input(4)), ("number", Int::input(5)));
        let inputs = (ports, ("enable", Bits::input(1)));
        module("held", "top", inputs, |(ports, enable)| {
            let (word, number) = ports.registered_when(enable);
            (("late_word", word), ("late_number", number))
        });
    });
    let mut simulator = Simulator::new(&design);
    let names = ["word", "number", "enable", "late_word", "late_number"];
    let [word, number, enable, late_word, late_number] = names.map(|name| simulator.port(name));
    let steps = [(0, [0, 0]), (1, [4, 16]), (0, [4, 16]), (1, [6, 18])];
    for ((value, (taken, late)), first) in (3..).zip(steps).zip(15..) {
        simulator.set(word, value);
        simulator.set(number, first);
        simulator.set(enable, taken);
        simulator.clock();
        let found = [late_word, late_number].map(|port| simulator.get(port));
        assert_eq!(found, late);
    }
}

/// Two memories called alike, and nets that are called as what the text declares itself.
fn crowded() -> Design {
    Design::of(|| {
        let ports = (("write", Bits::input(1)), ("data", Bits::input(2)));
        module("crowded", "top", ports, |(write, data)| {
            net! {
                let place = data.reg_when(write);
                let unused = Bits::register(2).initially(2);
            }
            unused.load(unused + place);
            let words = || memory("words", 4, (write, place, unused), data);
            (("one", words()), ("other", words() ^ unused))
        });
    })
}

#[test]
fn what_the_text_declares_has_names_of_its_own() {
    let text = verilog::write(&crowded().top, "");
    let parts = [
        "    output reg  [1:0] one = 2'd0,\n",
        "    reg [1:0] place_2 = 2'd0, unused_2 = 2'd2, other_read = 2'd0;\n",
        "    (* no_rw_check *) reg [1:0] words [0:3];\n    (* no_rw_check *) reg [1:0] words_2 [0:3];\n",
        "        for (place = 0; place <= 3; place = place + 1) words_2[place] = 2'd0;\n",
    ];
    assert_parts(&text, &parts);
}

#[test]
fn registers_begin_as_they_say_and_memories_with_zeros() {
    let mut simulator = Simulator::new(&crowded());
    let place = simulator.point("place").expect("a net with this name");
    let [write, data, other] = ["write", "data", "other"].map(|name| simulator.port(name));
    assert_eq!(simulator.get(other), 2);
    simulator.set(write, 1);
    simulator.set(data, 1);
    // `unused` goes on by `place`, which is 1 from the second clock on; the word at 1 is written then, and read later.
    let seen = (0..4).map(|_| {
        simulator.clock();
        assert_eq!(simulator.get(place), 1);
        simulator.get(other)
    });
    assert_eq!(seen.collect::<Vec<u64>>(), [2, 3, 2, 3 ^ 1]);
}

/// A memory that is never written has its words from the beginning, and no process that writes it.
#[test]
fn memories_that_are_never_written_hold_their_contents() {
    let contents = vec![5, 0, 7, 2];
    let design = Design::of(|| {
        module("primes", "top", ("place", Bits::input(2)), |place| {
            let value = read_only_memory("kept", 3, contents.clone(), place);
            ("value", value)
        });
    });
    let mut simulator = Simulator::new(&design);
    let [place, value] = ["place", "value"].map(|name| simulator.port(name));
    assert_eq!(simulator.get(value), 0);
    for (at, word) in contents.iter().enumerate() {
        simulator.set(place, at as u64);
        simulator.clock();
        assert_eq!(simulator.get(value), *word);
    }
    let text = verilog::write(&design.top, "");
    assert!(text.contains("        kept[2] = 3'd7;\n"), "{text}");
    let has_process = text.contains("SYNTHESIS") || text.contains("if (");
    assert!(!has_process, "{text}");
}

/// What is read through a value that is driven later is read, though it stands behind that value.
#[test]
fn what_forward_values_read_is_written() {
    let design = Design::of(|| {
        let ports = (("write", Bits::input(1)), ("value", Bits::input(8)));
        module("sums", "top", ports, |(write, value)| {
            let at = Bits::new(0, 1);
            let sum = Bits::forward(16);
            let earlier = memory("kept", 2, (write, at, sum), at);
            let add = |value: Bits| ("late", value.reg());
            let low = module("part", "low", ("value", value), add);
            let kept = earlier.low(8).reg();
            sum.drive(join([kept, low]));
            ("sum", earlier)
        });
    });
    let text = verilog::write(&design.top, "");
    assert!(!text.contains("unused"), "{text}");
    assert_parts(&text, &["assign kept_value = {kept_2, low_late};"]);
}

/// A register that nobody reads is not written, and does not read.
#[test]
fn what_only_feeds_unread_registers_is_not_read() {
    let design = Design::of(|| {
        module("outer", "top", ("x", Bits::input(1)), |x| {
            let (_, late) = module("inner", "inner", ("x", x), |x| {
                (("same", x), ("late", x.reg()))
            });
            net! { let unread = late.delay(2); }
            let _ = unread;
            ("y", x.reg())
        });
    });
    let text = verilog::write(&design.top, "");
    assert!(text.contains(".late(unused_inner_late)"), "{text}");
}

/// A sum that is late by so many clocks, beside a state.
fn late_sum(at: &str, a: Bits) -> Bits {
    module("late_sum", at, ("a", a), |a| {
        let count = Bits::register(4).initially(5).named("count");
        count.load_when(a.bit(0), count + Bits::new(1, 4));
        let held = a.reg_when(a.top());
        let (once, late) = (a.reg(), a.top().delay(3));
        ("sum", once + count + held + late.extend(4))
    })
}

#[test]
fn without_registers_of_pipelines_a_circuit_works_within_the_clock() {
    let design = Design::of(|| unregistered(|| late_sum("top", Bits::input(4))));
    let mut simulator = Simulator::new(&design);
    let [a, sum] = ["a", "sum"].map(|name| simulator.port(name));
    // The state counts, and what is held under an enable is held.
    let mut seen = vec![];
    for value in [9, 1, 2] {
        simulator.set(a, value);
        seen.push(simulator.get(sum));
        simulator.clock();
    }
    assert_eq!(seen, [9 + 5 + 1, (1 + 6 + 9) % 16, 2 + 7 + 9 - 16]);
    assert_eq!(design.top.registers.len(), 2);
    // What is built behind it has its registers again.
    let design = Design::of(|| late_sum("top", Bits::input(4)));
    assert_eq!(design.top.registers.len(), 4);
}

#[test]
fn on_a_chip_states_begin_with_a_reset() {
    let design = Design::of(|| {
        module("outer", "top", ("a", Bits::input(4)), |a| {
            ("sum", late_sum("inner", a))
        })
    });
    let modules = design.top.all();
    let texts = modules.iter().map(|own| verilog::write_for_chip(own, ""));
    let texts: Vec<String> = texts.collect();
    let [inner, outer] = &texts[..] else {
        panic!("{texts:?}");
    };
    assert!(outer.contains(".clock(clock), .reset(reset)"), "{outer}");
    let reset = "        if (reset) begin\n            count <= 4'd5;\n        end\n";
    assert_parts(inner, &[reset]);
    // What makes a value later begins with nothing, and no register has a value at power-up.
    assert_eq!(inner.matches("if (reset)").count(), 1);
    assert!(!inner.contains("reg  [3:0] count ="), "{inner}");
    assert!(verilog::write(&modules[0], "").contains("count = 4'd5"));
}
