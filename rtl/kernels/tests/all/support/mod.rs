//! Kernels by the names of their ports, in rust-hdl's own simulation and beside ours.

use imogene_hdl::{Design, Port, Simulator};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rust_hdl::prelude::*;
use std::sync::{Arc, Mutex};

/// A kernel whose ports are words.
pub trait Kernel: Block + Default + Send + 'static {
    /// Its inputs but the clock, as the circuit calls them.
    const INPUTS: &[&str];
    /// Its outputs.
    const OUTPUTS: &[&str];
    /// Gives each input its word.
    fn set(&mut self, words: &[u64]);
    /// Gives the clock its level.
    fn clock(&mut self, level: bool);
    /// The words of the outputs.
    fn get(&self) -> Vec<u64>;
}

/// A value of rust-hdl as the bits of a word.
pub trait Word {
    /// The value of these bits.
    fn of(word: u64) -> Self;
    /// The bits.
    fn word(self) -> u64;
}

impl Word for bool {
    fn of(word: u64) -> bool {
        word == 1
    }
    fn word(self) -> u64 {
        u64::from(self)
    }
}

impl<const N: usize> Word for Bits<N> {
    fn of(word: u64) -> Self {
        word.into()
    }
    fn word(self) -> u64 {
        self.into()
    }
}

impl<const N: usize> Word for Signed<N> {
    fn of(word: u64) -> Self {
        signed_cast(word.into())
    }
    fn word(self) -> u64 {
        self.inner().into()
    }
}

/// Names the ports of a kernel; a unit without registers has no clock.
#[macro_export]
macro_rules! kernel {
    (
        $kernel:ident<$($width:ident),+>, $($clock:ident)?,
        [$($($input:ident).+),+], [$($($output:ident).+),+]
    ) => {
        impl<$(const $width: usize),+> $crate::support::Kernel for $kernel<$($width),+> {
            const INPUTS: &[&str] = &[$(stringify!($($input).+)),+];
            const OUTPUTS: &[&str] = &[$(stringify!($($output).+)),+];
            fn set(&mut self, words: &[u64]) {
                let mut words = words.iter();
                $(self.$($input).+.next = $crate::support::Word::of(*words.next().expect("a word"));)+
            }
            fn clock(&mut self, _level: bool) {
                $(self.$clock.next = _level.into();)?
            }
            fn get(&self) -> Vec<u64> {
                vec![$($crate::support::Word::word(self.$($output).+.val())),+]
            }
        }
    };
}

/// The words of a kernel after each clock, in rust-hdl's own simulation.
fn simulated<K: Kernel>(stimulus: &[Vec<u64>]) -> Vec<Vec<u64>> {
    let found = Arc::new(Mutex::new(vec![]));
    let (stimulus, list) = (stimulus.to_vec(), found.clone());
    let most_time = 2 * stimulus.len() as u64 + 2;
    let mut simulation = Simulation::<K>::new();
    simulation.add_testbench(move |mut bench: Sim<K>| {
        let mut kernel = bench.init()?;
        for words in &stimulus {
            kernel.set(words);
            kernel.clock(false);
            kernel = bench.wait(1, kernel)?;
            kernel.clock(true);
            kernel = bench.wait(1, kernel)?;
            list.lock().expect("one thread").push(kernel.get());
        }
        bench.done(kernel)
    });
    let ended = simulation.run(Box::default(), most_time);
    ended.expect("rust-hdl checks the kernel and runs it to the end");
    let found = Arc::into_inner(found).expect("the bench has ended");
    found.into_inner().expect("one thread")
}

/// What the circuit calls a port, which has no name for its outputs together.
fn own(name: &str) -> String {
    name.replace("nearest.", "").replace('.', "_")
}

fn ports(simulator: &Simulator, names: &[&str]) -> Vec<Port> {
    let port = |name: &&str| simulator.port(&own(name));
    names.iter().map(port).collect()
}

fn width(simulator: &Simulator, name: &str) -> u32 {
    let record = simulator.ports().iter().find(|port| port.name == own(name));
    record.expect("a port of the circuit").width
}

/// Words for some clocks, half of them extremes: the most negative, the greatest, -1, 0 and 1.
fn stimulus(widths: &[u32], clocks: usize) -> Vec<Vec<u64>> {
    let mut random = ChaCha8Rng::seed_from_u64(1994);
    let mut word = |width: &u32| {
        let (all, sign) = (u64::MAX >> (64 - width), 1 << (width - 1));
        let extremes = [sign, sign - 1, all, 0, 1];
        match random.random_range(0..10) {
            extreme @ 0..5 => extremes[extreme] & all,
            _ => random.random::<u64>() & all,
        }
    };
    (0..clocks)
        .map(|_| widths.iter().map(&mut word).collect())
        .collect()
}

/// The first clock at which a kernel and a circuit differ, with what they were given and gave.
pub fn difference<K: Kernel>(circuit: &Design, clocks: usize) -> Option<String> {
    let mut simulator = Simulator::new(circuit);
    let counterparts = K::INPUTS.len() + K::OUTPUTS.len();
    assert_eq!(simulator.ports().len(), counterparts);
    let [inputs, outputs] = [K::INPUTS, K::OUTPUTS].map(|names| ports(&simulator, names));
    let widths = K::INPUTS.iter().map(|name| width(&simulator, name));
    let widths: Vec<u32> = widths.collect();
    let stimulus = stimulus(&widths, clocks);
    assert_covers(&widths, &stimulus);
    let simulated = simulated::<K>(&stimulus);
    assert_eq!(simulated.len(), clocks);
    let mut clocks = stimulus.iter().zip(simulated).enumerate();
    clocks.find_map(|(clock, (words, kernel))| {
        for (port, word) in inputs.iter().zip(words) {
            simulator.set(*port, *word);
        }
        simulator.clock();
        let circuit: Vec<u64> = outputs.iter().map(|port| simulator.get(*port)).collect();
        let text =
            || format!("clock {clock}: {words:x?} gives {kernel:x?}, the circuit {circuit:x?}");
        (circuit != kernel).then(text)
    })
}

/// Every combination of the flags, and the most negative word of each input.
fn assert_covers(widths: &[u32], stimulus: &[Vec<u64>]) {
    let places =
        |wanted: bool| (0..widths.len()).filter(move |place| (widths[*place] == 1) == wanted);
    let flags = |words: &Vec<u64>| places(true).fold(0, |flags, place| 2 * flags + words[place]);
    let combinations = 1 << places(true).count();
    assert!((0..combinations).all(|all| stimulus.iter().any(|words| flags(words) == all)));
    for place in places(false) {
        let least = 1 << (widths[place] - 1);
        let is_met = stimulus.iter().any(|words| words[place] == least);
        assert!(is_met, "input {place}");
    }
}
