//! STEP files that others wrote, and machine parts written by a CAD kernel, against that kernel's counts
//! (`scripts/step_witness.py`, `parts/machine/faces.json`).

use crate::common::list::{file, text};
use crate::common::says;
use imogene_import::Imported;
use imogene_import::faces::{FaceOptions, read_step};

fn read(bytes: &[u8], max_deviation: Option<f64>) -> Imported {
    let options = FaceOptions {
        max_deviation,
        no_volumes: false,
    };
    read_step(bytes, "a file", &options, &|_| None).unwrap_or_else(|error| panic!("{error}"))
}

/// Faces in the file times their placements, and how many of them are exact, approximated and rejected.
fn counts(imported: &Imported) -> [u64; 4] {
    let keys = [
        "/step/placed_faces",
        "/total/exact",
        "/total/approximated",
        "/total/rejected",
    ];
    keys.map(|key| imported.report.pointer(key).unwrap().as_u64().unwrap())
}

/// Solids and faces as OpenCASCADE 7.9.3 counts them, and how many of the faces are drawn: of the screw all but its
/// helicoids.
#[test]
fn files_of_others_have_the_faces_that_opencascade_counts() {
    for (name, solids, faces, free_form) in [
        ("NIST_MBE_PMI_1.stp", 1, 113, 0),
        ("M6_screw.step", 1, 28, 5),
        ("red_cube_blue_cylinder.step", 2, 9, 0),
        ("pipe_tee.step", 1, 7, 0),
        ("manifold.step", 1, 17, 0),
    ] {
        let imported = read(&file(&format!("import/tests/data/step/{name}")), None);
        let [all, exact, approximated, rejected] = counts(&imported);
        assert_eq!(imported.report["solids"], solids, "{name}");
        let drawn = exact + approximated;
        assert_eq!((all, drawn), (faces, faces - free_form), "{name}");
        assert_eq!(rejected, free_form, "{name}");
        assert_eq!(imported.scene.incomplete.is_some(), free_form > 0, "{name}");
    }
}

/// Every machine part is whole within a hundredth of a millimetre; a rolling-ball saddle alone is no quadric.
#[test]
fn machine_parts_are_whole_within_a_hundredth_of_a_millimetre() {
    let parts = file("parts/machine/faces.json");
    let parts: serde_json::Value = serde_json::from_slice(&parts).unwrap();
    let parts = parts.as_object().unwrap();
    assert_eq!(parts.len(), 26);
    let has_saddle = |part: &&serde_json::Value| part["surfaces"]["bspline"].is_u64();
    assert_eq!(parts.values().filter(has_saddle).count(), 1);
    for (name, expected) in parts {
        let bytes = file(&format!("parts/machine/{name}.step"));
        let imported = read(&bytes, Some(0.01));
        let [all, _, _, rejected] = counts(&imported);
        assert_eq!(imported.report["solids"], expected["solids"], "{name}");
        assert_eq!(all, expected["faces"].as_u64().unwrap(), "{name}");
        let free_form = expected["surfaces"]["bspline"].as_u64().unwrap_or(0);
        assert_eq!(rejected, free_form, "{name}: {:?}", imported.notes);
        for face in imported.report["faces"].as_array().unwrap() {
            let off = face["deviation"].as_f64().unwrap_or(0.0);
            assert!(off <= 0.01, "{name}, {}: {off}", face["name"]);
        }
    }
}

/// A shape that describes a property of a product draws nothing: the file has its solid twice, the product places it
/// once.
#[test]
fn properties_are_no_parts() {
    let text = text("parts/nut.step");
    let [number, context, product] = [
        "MANIFOLD_SOLID_BREP",
        "GEOMETRIC_REPRESENTATION_CONTEXT(3)",
        "PRODUCT_DEFINITION_SHAPE",
    ]
    .map(|name| {
        let line = text.lines().find(|line| line.contains(name));
        line.unwrap().split('=').next().unwrap().trim()
    });
    let ghost = format!(
        "#9001=SHAPE_ASPECT('solid data','',{product},.F.);
#9002=PROPERTY_DEFINITION('shape for solid data with which properties are associated','',#9001);
#9003=ADVANCED_BREP_SHAPE_REPRESENTATION('',({number}),{context});
#9004=SHAPE_DEFINITION_REPRESENTATION(#9002,#9003);
ENDSEC;
END-ISO"
    );
    let (before, _) = text.rsplit_once("ENDSEC;").unwrap();
    let (_, behind) = text.split_once("END-ISO").unwrap();
    let haunted = format!("{before}{ghost}{behind}");
    let [plain, ghost] = [text, haunted].map(|text| read(text.as_bytes(), None));
    assert_eq!(counts(&plain)[0], 10);
    assert_eq!(counts(&ghost), counts(&plain));
    assert_eq!(ghost.scene.objects.len(), plain.scene.objects.len());
}

/// An assembly whose only part is in another file.
#[test]
fn parts_in_other_files_are_read_or_named() {
    let assembly = "ISO-10303-21;HEADER;FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));ENDSEC;DATA;
#1=SHAPE_REPRESENTATION('',(#2,#3),#4);#2=AXIS2_PLACEMENT_3D('',#5,$,$);#3=AXIS2_PLACEMENT_3D('',#6,$,$);
#4=(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((#7)) REPRESENTATION_CONTEXT('',''));
#5=CARTESIAN_POINT('',(0.,0.,0.));#6=CARTESIAN_POINT('',(100.,0.,0.));
#7=(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.));
#10=SHAPE_REPRESENTATION('',(#2),#4);
#11=(REPRESENTATION_RELATIONSHIP('','',#10,#1) REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#12) SHAPE_REPRESENTATION_RELATIONSHIP());
#12=ITEM_DEFINED_TRANSFORMATION('','',#2,#3);#13=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#11,#14);
#14=PRODUCT_DEFINITION_SHAPE('','',#15);#15=NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','','',#20,#30,$);
#20=PRODUCT_DEFINITION('','',#21,$);#21=PRODUCT_DEFINITION_FORMATION('','',#22);#22=PRODUCT('a','stand','',());
#23=PRODUCT_DEFINITION_SHAPE('','',#20);#24=SHAPE_DEFINITION_REPRESENTATION(#23,#1);
#30=PRODUCT_DEFINITION('','',#31,$);#31=PRODUCT_DEFINITION_FORMATION('','',#32);#32=PRODUCT('b','nut','',());
#33=PRODUCT_DEFINITION_SHAPE('','',#30);#34=SHAPE_DEFINITION_REPRESENTATION(#33,#10);
#40=APPLIED_DOCUMENT_REFERENCE(#41,'',(#30));#41=DOCUMENT_FILE('folder/nut.step','','',#42,'',$);#42=DOCUMENT_TYPE('geometry');
ENDSEC;END-ISO-10303-21;";
    let nut = file("parts/nut.step");
    let options = FaceOptions::default();
    let beside = |name: &str| (name == "nut.step").then(|| nut.clone());
    let found = read_step(assembly.as_bytes(), "stand.step", &options, &beside).unwrap();
    let alone = read(&nut, None);
    assert_eq!(counts(&found), counts(&alone));
    assert_eq!(found.report["step"]["files"][0], "nut.step");
    let most = |imported: &Imported| {
        let cuts = imported.scene.objects.iter().flat_map(|o| &o.cuts);
        cuts.map(|cut| cut.point[0]).fold(f64::MIN, f64::max)
    };
    // Placed a tenth of a metre along x.
    assert!((most(&found) - most(&alone) - 100.0).abs() < 1e-9);
    let lost = read_step(assembly.as_bytes(), "stand.step", &options, &|_| None);
    let why = "part `nut` is in the file `nut.step`, which is not beside";
    says(lost.unwrap_err(), why);
}
