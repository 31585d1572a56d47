//! Structures of many atoms: memory for each atom, and under `IMOGENE_FULL=1` two million of them in less than one
//! gigabyte. The time that it prints is for the documentation.

mod memory;

use imogene_import::pdb::{Format, contents};
use memory::{MOST, NOW};
use std::fmt::Write;
use std::sync::atomic::Ordering;
use std::time::Instant;

/// Place of an atom: copies of ten residues in a grid.
fn place(k: usize) -> [f64; 3] {
    [k % 100, k / 100 % 100, k / 10_000].map(|v| v as f64 * 1.5 + 0.125)
}

fn pdb(count: usize) -> String {
    let mut text = String::with_capacity(82 * count);
    for k in 0..count {
        let [x, y, z] = place(k);
        let (serial, residue) = ((k + 1) % 100_000, k / 10 % 10_000);
        writeln!(
            text,
            "ATOM  {serial:>5}  CA  ALA A{residue:>4}    {x:8.3}{y:8.3}{z:8.3}  1.00 20.00           C  "
        )
        .expect("memory");
    }
    text
}

fn mmcif(count: usize) -> String {
    let mut text = String::with_capacity(100 * count);
    text += "data_LARGE\nloop_\n";
    let items = "group_PDB id type_symbol label_atom_id label_alt_id label_comp_id label_asym_id label_entity_id label_seq_id \
         pdbx_PDB_ins_code Cartn_x Cartn_y Cartn_z occupancy B_iso_or_equiv pdbx_formal_charge auth_seq_id auth_comp_id auth_asym_id \
         auth_atom_id pdbx_PDB_model_num";
    for item in items.split_whitespace() {
        writeln!(text, "_atom_site.{item}").expect("memory");
    }
    for k in 0..count {
        let [x, y, z] = place(k);
        let (serial, residue) = (k + 1, k / 10);
        writeln!(
            text,
            "ATOM {serial} C CA . ALA A 1 {residue} ? {x:.3} {y:.3} {z:.3} 1.00 20.00 ? {residue} ALA A CA 1"
        )
        .expect("memory");
    }
    text
}

#[test]
fn many_atoms_take_little_memory() {
    let is_full = std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1");
    let count = if is_full { 2_000_000 } else { 100_000 };
    for format in [Format::Pdb, Format::Mmcif] {
        let before = NOW.load(Ordering::Relaxed);
        MOST.store(before, Ordering::Relaxed);
        let text = match format {
            Format::Pdb => pdb(count),
            _ => mmcif(count),
        };
        let started = Instant::now();
        let read = contents(text.as_bytes(), format, "f").expect("readable");
        let time = started.elapsed();
        let most = MOST.load(Ordering::Relaxed) - before;
        println!(
            "{format:?}: {count} atoms, {} MB of text: {time:.2?}, {} MB with it",
            text.len() >> 20,
            most >> 20
        );
        assert_eq!(read.atoms, count);
        // The text, an atom of 72 bytes in a list that doubles, and its share of the words.
        let is_little = most - text.len() < 240 * count + (1 << 20);
        assert!(is_little, "{format:?}: {most} bytes");
        assert!(most < 1_000_000_000, "{format:?}: {most} bytes");
    }
}
