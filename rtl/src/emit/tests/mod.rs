//! Kernels that are refused, and the text of those that are not.

mod kernels;

use super::collect::collect;
use super::merge::modules;
use crate::kernel::*;
use crate::word::bits_signed;

macro_rules! kernel {
    ($name:ident, $out:ty) => {
        struct $name {
            a: Signal<In, Word<8>>,
            b: Signal<In, Word<8>>,
            s: Signal<In, Int<8>>,
            result: Signal<Out, $out>,
            sum: Signal<Local, Word<8>>,
            one: Constant<Word<8>>,
            limit: Constant<Word<8>>,
            zero: Constant<Int<8>>,
            _asleep: bool,
        }

        block! {
            [] $name []
            inputs { a, b, s }
            parts { result, sum, one, limit, zero }
            data { }
        }

        impl $name {
            fn emitted() -> Result<String, String> {
                let block = Self {
                    a: Signal::default(),
                    b: Signal::default(),
                    s: Signal::default(),
                    result: Signal::default(),
                    sum: Signal::default(),
                    one: constant(1),
                    limit: constant(100),
                    zero: signed_constant(0),
                    _asleep: false,
                };
                let scope = collect(block).map_err(|error| error.to_string())?;
                let modules = modules(&scope, "").map_err(|error| error.to_string())?;
                Ok(modules.into_iter().map(|(_, text)| text).collect())
            }
        }
    };
}

kernel!(Latch, Word<8>);

impl Logic for Latch {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("latch");
        self.sum.next = self.a.val();
        if self.a.val() == self.b.val() {
            self.result.next = self.sum.val();
        }
    }
}

kernel!(AssignedLate, Word<8>);

impl Logic for AssignedLate {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("assigned_late");
        self.sum.next = self.a.val();
        self.result.next = self.sum.val() + self.one.val();
        self.sum.next = self.b.val();
    }
}

kernel!(Reserved, Word<8>);

impl Logic for Reserved {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("and");
        self.sum.next = self.a.val();
        self.result.next = self.sum.val();
    }
}

#[test]
fn a_module_with_the_name_of_a_keyword_is_refused() {
    assert!(Reserved::emitted().unwrap_err().contains("`and`"));
}

#[test]
fn latches_and_late_assignments_are_refused() {
    assert!(Latch::emitted().unwrap_err().contains("latch"));
    assert!(
        AssignedLate::emitted()
            .unwrap_err()
            .contains("after it was read")
    );
}

kernel!(Extended, Int<12>);

impl Logic for Extended {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("extended");
        self.sum.next = self.a.val();
        self.result.next = bits_signed::<12, 8>(self.s.val());
    }
}

kernel!(Chosen, Word<8>);

impl Logic for Chosen {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("chosen");
        self.sum.next = self.a.val() + self.b.val();
        if self.s.val() < self.zero.val() {
            self.result.next = !self.sum.val();
        } else if self.a.val() == self.limit.val() {
            self.result.next = self.one.val();
        } else {
            self.result.next = self.sum.val() - self.one.val();
        }
    }
}

#[test]
fn legal_forms_are_printed_with_their_widths() {
    let text = Extended::emitted().unwrap();
    assert!(text.contains("assign result = {{4{s[7]}}, s};"), "{text}");
    let text = Chosen::emitted().unwrap();
    assert!(text.contains("localparam [7:0] limit = 8'd100;"), "{text}");
    assert!(text.contains("assign sum = a + b;"), "{text}");
    assert!(
        text.contains(
            "assign result = (s < zero) ? ~sum :\n        (a == limit) ? one : sum - one;"
        ),
        "{text}"
    );
}

/// A memory whose read is one clock late, as rust-hdl simulates it, in the form that synthesis maps to block memory.
#[test]
fn a_memory_is_a_module_of_its_own() {
    use crate::unit::block_memory::BlockMemory;
    let scope = collect(BlockMemory::<4, 12>::new()).unwrap();
    let modules = modules(&scope, "").unwrap();
    let [(name, text)] = modules.as_slice() else {
        panic!("a memory is one module");
    };
    assert_eq!(name, "block_memory");
    for part in [
        "input  wire [3:0] write_address",
        "reg [11:0] words [0:15];",
        "kept_read_data <= words[read_address];",
        "if (write) words[write_address] <= write_data;",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
    let scope = collect(BlockMemory::<6, 12>::of_address_bits(4)).unwrap();
    let text = &super::merge::modules(&scope, "").unwrap()[0].1;
    for part in [
        "reg [11:0] words [0:15];",
        "words[read_address[3:0]]",
        "read_address[5:4]",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
}
