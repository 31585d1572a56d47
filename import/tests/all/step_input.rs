//! Texts of STEP files: what is refused and where, and that no text makes the reader panic.

use crate::common::bar::{BAR, changed, is_whole, read, said};
use crate::common::cases::cases;
use crate::common::list::file;
use crate::common::says;
use imogene_import::faces::{FaceOptions, read_step};
use proptest::prelude::*;
use std::fmt::Write;

#[test]
fn slips_are_reported_where_they_are() {
    // Where a quote is missing, the string goes on to the next quote that is alone.
    let table = r"
ISO-10303-21;\nHEADER | solid bar\nHEADER | bar.step:1:1: this is no STEP file; a file that begins
HEADER;\nFILE_D | FILE_D | :2:1: `FILE_DESCRIPTION` is not expected here; `HEADER;` is needed
DATA;\n | \n | :8:1: `#1` is not expected here; a section
END-ISO-10303-21;\n |  | :47:1: the end of the file is not expected here
#2=MANIFOLD | #2 MANIFOLD | :9:4: `MANIFOLD_SOLID_BREP` is not expected here; `=` is needed
'bar',#10) | 'bar',#10 | :9:33: `;` is not expected here; `,` or `)` is needed
'bar',#10 | 'bar,#10 | :14:20: `side` is not expected here; `,` or `)` is needed
#95);\n#90 | #95);\n/* #90 | :40:1: the comment has no end; `*/` ends a comment
(1.,0.,0.));\n#91 | (1.,0.,));\n#91 | :40:31: `)` is not expected here; a parameter is needed
(1.,0.,0.));\n#91 | (1.,0.,-));\n#91 | :40:31: `-` is not a number
(1.,0.,0.));\n#91 | (1.,0.,1.E999));\n#91 | :40:31: `1.E999` is not a number
(1.,0.,0.));\n#91 | (1.,0.,1.E10));\n#91 | :40:1: `#90` CARTESIAN_POINT: it is too far off
(1.,0.,0.));\n#91 | (1.,0.));\n#91 | :40:1: `#90` CARTESIAN_POINT: it has 2 coordinates; three
(1.,0.,0.));\n#91 | (1.,0.,'x'));\n#91 | :40:31: `#90` CARTESIAN_POINT: parameter 2 is a string; a number is needed
CYLINDRICAL_SURFACE('',#80,1.) | CYLINDRICAL_SURFACE('',#80) | :21:1: `#30` CYLINDRICAL_SURFACE: it has 2 parameters; at least 3 are needed
CYLINDRICAL_SURFACE('',#80,1.) | CYLINDRICAL_SURFACE('',#80,0.) | :21:1: `#30` CYLINDRICAL_SURFACE: a radius of 0
CYLINDRICAL_SURFACE('',#80,1.) | CYLINDRICAL_SURFACE('',#62,1.) | :34:1: `#62` is a CIRCLE; an AXIS2_PLACEMENT_3D is needed where it is named
CYLINDRICAL_SURFACE('',#80,1.) | CYLINDRICAL_SURFACE('',$,1.) | :21:28: `#30` CYLINDRICAL_SURFACE: parameter 2 is `$`; a reference such as `#12` is needed
CYLINDRICAL_SURFACE('',#80,1.) | CYLINDRICAL_SURFACE('',#999,1.) | :21:28: `#30` CYLINDRICAL_SURFACE names `#999`, which is not in the file
#40,.T.) | #40,.TRUE.) | :17:29: `#20` FACE_OUTER_BOUND: parameter 3 is `.TRUE.`; `.T.` or `.F.` is needed
(#20,#21),#30 | #20,#30 | :14:26: `#11` ADVANCED_FACE: parameter 2 is `#20`; a list is needed
(#20,#21),#30 | (#20,#21),#94 | `#94` is a DIRECTION; a PLANE or surface is needed
#70,#70,#62 | #70,#70,#94 | `#94` is a DIRECTION; a LINE or CIRCLE
#42=EDGE_LOOP('',(#52)); | #42=EDGE_LOOP('',()); | `#42` EDGE_LOOP: it has no edge
#42=EDGE_LOOP('',(#52)); | #42=EDGE_LOOP('',(#52,#53)); | `#42` EDGE_LOOP: `#52` does not end where `#53` begins
#95=DIRECTION('',(1.,0.,0.)) | #95=DIRECTION('',(0.,0.,0.)) | :45:1: `#95` DIRECTION: [0.0, 0.0, 0.0] has no direction
#95=DIRECTION | #94=DIRECTION | :45:1: `#94` is there already
#95=DIRECTION | #99999999999999999999=DIRECTION | :45:1: the number of `#99999999999999999999` is too large; references are `#1` to
#95=DIRECTION('', | #95=DIRECTION('',? | :45:18: `?` begins no word
#1=ADVANCED_BREP_SHAPE | #1=DRAUGHTING | bar.step: no shape representation has a face
(#2),#3); | (#80),#3); | bar.step: no shape representation has a face
";
    for [from, to, part] in cases(table) {
        let place = BAR.find(&from).unwrap_or_else(|| panic!("{from}"));
        let text = format!("{}{to}{}", &BAR[..place], &BAR[place + from.len()..]);
        // What is wrong with an entity costs the faces that need it, what is wrong with the text the file.
        let entities = "`#90`, `#30`, `#62` is, `#20`, `#11`, `#94` is a, `#42`, `#95` D";
        let costs_a_face = entities.split(", ").any(|name| part.contains(name));
        assert_eq!(read(&text).is_ok(), costs_a_face, "{to}");
        says(said(&text), part.trim_start_matches(':'));
        says(said(&text), "; ");
    }
}

#[test]
fn lists_inside_each_other_are_bounded() {
    for depth in [40, 1000, 1_000_000] {
        for (open, close) in [("(", ")"), ("A(", ")"), ("(1,", ")")] {
            let deep = format!("#95=X({}1{});", open.repeat(depth), close.repeat(depth));
            let text = changed(&[("#95=DIRECTION('',(1.,0.,0.));", &deep)]);
            says(said(&text), "a list inside too many others; at most 32");
        }
    }
    // As deep as it may be, where nobody looks.
    let deep = format!("#99=X({}1{});\n#94=", "(".repeat(32), ")".repeat(32));
    let text = changed(&[("#94=", &deep)]);
    is_whole(&text, [-1.0, -1.0, 0.0], [1.0, 1.0, 2.0]);
}

#[test]
fn entities_that_lead_back_to_themselves_are_named() {
    let table = r"
#62=CIRCLE('',#80,1.); | #62=SURFACE_CURVE('',#62,(),.CURVE_3D.); | `#62` SURFACE_CURVE: it is defined by itself
#62=CIRCLE('',#80,1.); | #62=TRIMMED_CURVE('',#64,(),(),.T.,.CARTESIAN.);#64=SEAM_CURVE('',#62,(),.CURVE_3D.); | it is defined by itself
#50=ORIENTED_EDGE('',*,*,#60,.T.); | #50=ORIENTED_EDGE('',*,*,#50,.T.); | `#50` is an ORIENTED_EDGE; an EDGE_CURVE is needed
#1=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#2),#3); | #1=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#2,#110),#3);#110=MAPPED_ITEM('',#111,#80);#111=REPRESENTATION_MAP(#80,#1); | :8:1: `#1` ADVANCED_BREP_SHAPE_REPRESENTATION: it is placed in itself
#10= | #200=STYLED_ITEM('',(#201),#2);#201=PRESENTATION_STYLE_ASSIGNMENT((#201,#201,#201,#201));\n#10= | its colour is defined by itself
";
    for [from, to, part] in cases(table) {
        says(said(&changed(&[(&from, &to)])), &part);
    }
}

/// Forty assemblies, each of which has the next one twice: a million millions of bars.
#[test]
fn assemblies_that_multiply_are_refused() {
    let mut text = String::new();
    for level in 0..40 {
        let (own, next) = (1000 + 10 * level, 1010 + 10 * level);
        writeln!(
            text,
            "#{own}=SHAPE_REPRESENTATION('',(#{},#{}),#3);#{}=MAPPED_ITEM('',#{},#80);#{}=MAPPED_ITEM('',#{},#81);#{}=REPRESENTATION_MAP(#80,#{});",
            own + 1, own + 2, own + 1, own + 3, own + 2, own + 3, own + 3,
            if level == 39 { 1 } else { next },
        )
        .unwrap();
    }
    let text = changed(&[("#2=MANIFOLD", &format!("{text}#2=MANIFOLD"))]);
    says(said(&text), "too many parts in each other; at most 64");
}

fn shipped() -> Vec<Vec<u8>> {
    let file = |name| file(&format!("parts/{name}.step"));
    ["stand", "nut", "hollow", "fillet"].map(file).to_vec()
}

#[test]
fn truncated_files_are_refused() {
    for file in shipped() {
        let end = file.len() - "END-ISO-10303-21;\n".len();
        for length in (0..end).step_by(211) {
            let read = read_step(&file[..length], "f", &FaceOptions::default(), &|_| None);
            says(read.unwrap_err(), "; ");
        }
    }
}

/// The first reference in a list of parameters after a place.
fn reference(bytes: &[u8], from: usize) -> Option<std::ops::Range<usize>> {
    let inside = |pair: &[u8]| matches!(pair[0], b'(' | b',') && pair[1] == b'#';
    let start = from + bytes[from..].windows(2).position(inside)? + 1;
    let digits = bytes[start + 1..].iter();
    let length = digits.take_while(|byte| byte.is_ascii_digit()).count();
    Some(start..start + 1 + length)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Words of one place at another, digits that are others, and references to other entities.
    #[test]
    fn changed_files_do_not_panic(file in 0..4_usize, places in proptest::collection::vec((0.0..1.0_f64, 0.0..1.0_f64, 1..24_usize, 0..9_u8), 1..6)) {
        let mut bytes = shipped()[file].clone();
        for (from, to, length, kind) in places {
            let from = (from * bytes.len() as f64) as usize;
            let to = (to * bytes.len() as f64) as usize;
            let piece = bytes[from..(from + length).min(bytes.len())].to_vec();
            let end = (to + length).min(bytes.len());
            match kind {
                0 => drop(bytes.splice(to..end, piece)),
                1 => drop(bytes.splice(to..to, piece)),
                2 | 3 => {
                    for byte in &mut bytes[to..end] {
                        if byte.is_ascii_digit() {
                            *byte = b'0' + (*byte + length as u8) % 10;
                        }
                    }
                }
                _ => {
                    if let (Some(from), Some(to)) = (reference(&bytes, from), reference(&bytes, to)) {
                        let other = bytes[from].to_vec();
                        drop(bytes.splice(to, other));
                    }
                }
            }
        }
        if let Err(error) = read_step(&bytes, "f", &FaceOptions::default(), &|_| None) {
            prop_assert!(error.to_string().contains("; "));
        }
    }
}
