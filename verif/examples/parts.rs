use imogene_compiled::{Program, Simulation};
use imogene_contract::{Request, Unit};
use std::sync::Arc;
use std::time::Instant;
fn main() {
    for name in std::env::args().skip(1) {
        let request = Request::new(Unit::from_name(&name).unwrap());
        let design = imogene_rtl::emit::design(&request).unwrap();
        let subject = imogene_verif::unit::subject(&request).unwrap();
        let base = imogene_verif::random::stimuli(&subject, 500, 1).concat()[0].clone();
        let frame: Vec<Vec<u64>> = (0..20000)
            .map(|i| {
                let mut x = base.clone();
                x[0] = 1;
                x[1] = (i == 0) as i64;
                x[2] = (i > 0 && i % 640 == 0) as i64;
                x.iter()
                    .zip(&subject.inputs)
                    .map(|(v, s)| s.bits(*v))
                    .collect()
            })
            .collect();
        let random: Vec<Vec<u64>> = imogene_verif::random::stimuli(&subject, 20000, 1)
            .concat()
            .iter()
            .map(|x| {
                x.iter()
                    .zip(&subject.inputs)
                    .map(|(v, s)| s.bits(*v))
                    .collect()
            })
            .collect();
        for (what, stimulus) in [("frame", &frame), ("random", &random)] {
            for four in [false, true] {
                let program = Arc::new(if four {
                    Program::in_lanes(&design, &[])
                } else {
                    Program::new(&design, &[])
                });
                let mut t = [f64::MAX; 3];
                for _ in 0..20 {
                    let mut s = Simulation::new(&program);
                    let a = Instant::now();
                    for x in stimulus {
                        s.set_all(x.iter().copied());
                    }
                    let b = Instant::now();
                    for x in stimulus {
                        s.set_all(x.iter().copied());
                        s.clock();
                    }
                    let c = Instant::now();
                    for x in stimulus {
                        s.set_all(x.iter().copied());
                        s.clock();
                        std::hint::black_box(s.outputs());
                    }
                    let d = Instant::now();
                    let n = stimulus.len() as f64;
                    for (k, v) in [b - a, c - b, d - c].into_iter().enumerate() {
                        t[k] = t[k].min(v.as_secs_f64() / n * 1e9);
                    }
                }
                println!(
                    "{name} {what} four={four} set {:.0} ns, set+clock {:.0}, all {:.0} ns; {} inputs {}",
                    t[0],
                    t[1],
                    t[2],
                    subject.inputs.len(),
                    program.describe()
                );
            }
        }
    }
}
