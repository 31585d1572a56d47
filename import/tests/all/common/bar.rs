//! A part as the text of a STEP file.

use imogene_import::faces::{Compilation, FaceOptions, Part, compile_step, read_step};
use imogene_import::{ImportError, Imported};

/// A round bar, radius 1, from z = 0 to z = 2.
pub const BAR: &str = "ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('bar','',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#2),#3);
#2=MANIFOLD_SOLID_BREP('bar',#10);
#3=(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((#4,#5)) REPRESENTATION_CONTEXT('',''));
#4=(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.));
#5=(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.));
#10=CLOSED_SHELL('',(#11,#12,#13));
#11=ADVANCED_FACE('side',(#20,#21),#30,.T.);
#12=ADVANCED_FACE('floor',(#22),#31,.F.);
#13=ADVANCED_FACE('',(#23),#32,.T.);
#20=FACE_OUTER_BOUND('',#40,.T.);
#21=FACE_BOUND('',#41,.T.);
#22=FACE_OUTER_BOUND('',#42,.T.);
#23=FACE_OUTER_BOUND('',#43,.T.);
#30=CYLINDRICAL_SURFACE('',#80,1.);
#31=PLANE('',#80);
#32=PLANE('',#81);
#40=EDGE_LOOP('',(#50));
#41=EDGE_LOOP('',(#51));
#42=EDGE_LOOP('',(#52));
#43=EDGE_LOOP('',(#53));
#50=ORIENTED_EDGE('',*,*,#60,.T.);
#51=ORIENTED_EDGE('',*,*,#61,.F.);
#52=ORIENTED_EDGE('',*,*,#60,.F.);
#53=ORIENTED_EDGE('',*,*,#61,.T.);
#60=EDGE_CURVE('',#70,#70,#62,.T.);
#61=EDGE_CURVE('',#71,#71,#63,.T.);
#62=CIRCLE('',#80,1.);
#63=CIRCLE('',#81,1.);
#70=VERTEX_POINT('',#90);
#71=VERTEX_POINT('',#91);
#80=AXIS2_PLACEMENT_3D('',#92,$,$);
#81=AXIS2_PLACEMENT_3D('',#93,#94,#95);
#90=CARTESIAN_POINT('',(1.,0.,0.));
#91=CARTESIAN_POINT('',(1.,0.,2.));
#92=CARTESIAN_POINT('',(0.,0.,0.));
#93=CARTESIAN_POINT('',(0.,0.,2.));
#94=DIRECTION('',(0.,0.,1.));
#95=DIRECTION('',(1.,0.,0.));
ENDSEC;
END-ISO-10303-21;
";

/// The bar with some words changed.
pub fn changed(changes: &[(&str, &str)]) -> String {
    let mut text = BAR.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    text
}

/// The scene of a text.
pub fn read(text: &str) -> Result<Imported, ImportError> {
    let options = FaceOptions::default();
    read_step(text.as_bytes(), "bar.step", &options, &|_| None)
}

/// What is said of a text, whether it is read or refused.
pub fn said(text: &str) -> String {
    read(text).map_or_else(|error| error.to_string(), |read| read.notes.join("\n"))
}

/// The compiled part of a text.
pub fn part(text: &str) -> Part {
    compile_step(text.as_bytes(), "bar.step", &FaceOptions::default()).unwrap()
}

/// One volume, which is proven to have exactly the faces of the file, with these bounds.
pub fn is_whole(text: &str, low: [f64; 3], high: [f64; 3]) {
    let part = part(text);
    for (bound, expected) in part.model.bounds.iter().zip([low, high]) {
        for (value, expected) in bound.iter().zip(expected) {
            // Arcs are sampled every 32nd of a turn, a quarter among them.
            assert!((value - expected).abs() <= 1e-9 * high[2], "{bound:?}");
        }
    }
    let is_volume = matches!(part.solids[..], [Compilation::Volume(_)]);
    assert!(is_volume, "{text}");
}
