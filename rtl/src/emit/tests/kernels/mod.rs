//! Kernels one operation long and longer: what rust-hdl's simulation computes, the emitted Verilog computes in Icarus Verilog.
//!
//! rust-hdl's own text of the same kernels runs beside it; where that one differs is part of the test.

mod bench;

use super::super::emit_block;
use crate::kernel::*;
use bench::{icarus, is_legal, vectors};
use rust_hdl::core::prelude::{Block, generate_verilog, simulate};

const VECTORS: usize = 4000;

/// Words of a vector: a, b, n, s, t, w, v, u, h, k, p.
const WIDTHS: [usize; 11] = [8, 8, 3, 8, 8, 40, 40, 40, 16, 16, 1];
const NAMES: [&str; 11] = ["a", "b", "n", "s", "t", "w", "v", "u", "h", "k", "p"];

/// A kernel as a test meets it.
#[derive(Clone)]
struct Tested {
    module: String,
    width: usize,
    text: String,
    /// rust-hdl's own text, in a module of the same name.
    raw: String,
    results: Vec<u64>,
}

macro_rules! kernel {
    ($name:ident, $out:ty, { $($update:tt)* }) => {
        struct $name {
            a: Signal<In, Word<8>>,
            b: Signal<In, Word<8>>,
            n: Signal<In, Word<3>>,
            s: Signal<In, Int<8>>,
            t: Signal<In, Int<8>>,
            w: Signal<In, Word<40>>,
            v: Signal<In, Int<40>>,
            u: Signal<In, Int<40>>,
            h: Signal<In, Int<16>>,
            k: Signal<In, Int<16>>,
            p: Signal<In, Bit>,
            result: Signal<Out, $out>,
            one: Constant<Word<8>>,
            limit: Constant<Word<8>>,
            places: Constant<Word<6>>,
            place: Constant<Word<8>>,
            zero: Constant<Int<8>>,
            _asleep: bool,
        }

        block! {
            [] $name []
            inputs { a, b, n, s, t, w, v, u, h, k, p }
            parts { result, one, limit, places, place, zero }
            data { }
        }

        impl Logic for $name {
            $($update)*
        }

        impl $name {
            fn new() -> Self {
                Self {
                    a: Signal::default(),
                    b: Signal::default(),
                    n: Signal::default(),
                    s: Signal::default(),
                    t: Signal::default(),
                    w: Signal::default(),
                    v: Signal::default(),
                    u: Signal::default(),
                    h: Signal::default(),
                    k: Signal::default(),
                    p: Signal::default(),
                    result: Signal::default(),
                    one: constant(1),
                    limit: constant(100),
                    places: constant(5),
                    place: constant(13),
                    zero: signed_constant(0),
                    _asleep: false,
                }
            }

            fn tested(vectors: &[[u64; 11]]) -> Tested {
                let modules = emit_block(Self::new()).expect(stringify!($name));
                assert_eq!(modules.len(), 1, "a kernel is one module");
                let (module, text) = modules.into_iter().next().expect("one module");
                let mut block = Self::new();
                block.connect_all();
                let raw = generate_verilog(&block).replace("module top(", &format!("module {module}("));
                let run = |vector: &[u64; 11]| {
                    let [a, b, n, s, t, w, v, u, h, k, p] = *vector;
                    block.a.next = Word::new(a);
                    block.b.next = Word::new(b);
                    block.n.next = Word::new(n);
                    block.s.next = Int::new(s as i64);
                    block.t.next = Int::new(t as i64);
                    block.w.next = Word::new(w);
                    block.v.next = Int::new(v as i64);
                    block.u.next = Int::new(u as i64);
                    block.h.next = Int::new(h as i64);
                    block.k.next = Int::new(k as i64);
                    block.p.next = p == 1;
                    assert!(simulate(&mut block, 20), "{} oscillates", stringify!($name));
                    block.result.val().word()
                };
                Tested {
                    module,
                    width: <$out as Synth>::BITS,
                    text,
                    raw,
                    results: vectors.iter().map(run).collect(),
                }
            }
        }
    };
}

/// Kernels whose own text by rust-hdl is no Verilog, and those whose text computes something else: docs/emission.md.
const REFUSED: [&str; 1] = ["slice_of_sum"];
const WRONG: [&str; 9] = [
    "wide_sum",
    "mask_is_equal",
    "narrowed_is_below",
    "extended",
    "extended_difference",
    "extended_signed_sum",
    "product_is_below",
    "signed_read_extended",
    "nested_branches",
];

mod nested;
mod single;
mod traps;

/// How many results of each kernel differ from the simulation, with its name.
fn differences(
    kernels: &[Tested],
    text: impl Fn(&Tested) -> &str,
    is_clean: bool,
) -> Vec<(&str, usize)> {
    let found = icarus(kernels, text, is_clean, &vectors());
    assert_eq!(found.len(), VECTORS * kernels.len());
    let count = |(place, kernel): (usize, &Tested)| {
        let differs =
            |index: &usize| found[index * kernels.len() + place] != Some(kernel.results[*index]);
        (0..VECTORS).filter(differs).count()
    };
    let counts = kernels.iter().enumerate().map(count);
    let names = kernels.iter().map(|kernel| kernel.module.as_str());
    names.zip(counts).filter(|(_, count)| *count > 0).collect()
}

#[test]
fn every_kernel_computes_the_same_in_simulation_and_in_verilog() {
    let vectors = vectors();
    let kernels = [
        traps::all(&vectors),
        single::all(&vectors),
        nested::all(&vectors),
    ]
    .concat();
    assert_eq!(kernels.len(), 56);
    let wrong = differences(&kernels, |kernel| &kernel.text, true);
    assert!(wrong.is_empty(), "of {VECTORS} vectors differ: {wrong:?}");
    // rust-hdl's own text of the same kernels.
    let (legal, refused): (Vec<_>, Vec<_>) = kernels
        .into_iter()
        .partition(|kernel| is_legal(&kernel.raw));
    let refused: Vec<&str> = refused.iter().map(|k| k.module.as_str()).collect();
    let wrong = differences(&legal, |kernel| &kernel.raw, false);
    println!("rust-hdl's text: refused {refused:?}, of {VECTORS} vectors differ {wrong:?}");
    let wrong: Vec<&str> = wrong.iter().map(|(name, _)| *name).collect();
    assert_eq!(refused, REFUSED);
    assert_eq!(wrong, WRONG);
}
