//! Normal of the visible face.

use super::normal::Normal;
use super::widths::Widths;
use super::words::Gradients;
use crate::raster::{Flags, Linear, pe1};
use imogene_contract::words::{CAP, FAR_ROOT, FIRST_PLANE, NEAR_ROOT};
use imogene_hdl::{Bits, Bundle, Int, Ports, Value, bundle, bundles, module, net};

bundle! {
    /// The visible face of a pixel. The number of a bare surface has one bit: its faces are roots.
    Face(scaled_root) {
        number: Bits(4),
            "visible face: 0 near root, 1 far root, 2 + i plane i, 15 near end; with the flags of its pixel";
        absent: Bits(1), "nothing is seen at the pixel: the normal is zero";
        scaled_root: Bits(scaled_root),
            "floor(sqrt(f2)) of the pixel shifted right for the normal, the low bits of a positive number";
    }

    /// What decides a component besides its own words.
    Change(width) {
        signed_root: Int(width), "scaled root, its sign changed on the near face, a clock before the flags";
        is_quadric: Bits(1), "the face is the quadric's, one clock later";
        fixed: Int(width), "the component of any other face, one clock later";
    }
}

bundles! {
    /// The words of a normal.
    NormalWords(widths: Widths, planes: u32) {
        /// Words of the quadric.
        gradients: Gradients(widths) as "";
        planes: [Normal(widths.normal); planes] as "plane", "plane #";
    }
}

/// The normal of the visible face: of the quadric from its polar plane and the root, of a plane its constant, of the
/// cap the direction to the viewer, else zero.
///
/// With the scaled root `rs` a component is the high bits of `g(x, y) - (k rs >> 6)` on the near face and of
/// `g(x, y) + (k rs >> 6)` on the far one, rounded down. A number of one bit says that there are no other faces.
/// Latency 4: the sign of the root, the inputs of the multipliers, the products, the sums. Section 2.4.2.
pub fn normal_unit(at: &str, flags: Flags, face: Face, words: NormalWords) -> Normal {
    let inputs = (flags, face, words);
    module("normal_unit", at, inputs, |(flags, face, words)| {
        let (gradients, factors) = (words.gradients, words.gradients.factors);
        let width = factors.kx.width();
        let is = |number: u64| face.number.is(number);
        let late = flags.delayed(2);
        net! {
            let scaled_root = face.scaled_root.extend(width).int();
            let signed_root = is(NEAR_ROOT).select(Int::new(0, width) - scaled_root, scaled_root).reg();
            let is_absent = face.absent.reg();
        }
        let zero = Normal::of([Int::new(0, width); 3]);
        let (is_root, fixed) = if face.number.width() == 1 {
            (Bits::new(1, 1), zero)
        } else {
            net! { let is_root = (is(NEAR_ROOT) | is(FAR_ROOT)).reg(); }
            let to_viewer = Int::new(-(1 << (width - 1)) + 1, width);
            let fixed = constant_normal(face.number, to_viewer, &words.planes);
            let fixed = ("constant", fixed).delayed(1).bare();
            let fixed = is_absent.select(zero, fixed);
            (is_root, ("fixed", fixed).delayed(2).bare())
        };
        net! { let is_quadric = (is_root & !is_absent).delay(2); }
        let component = |name: &str, g: Linear, k: Int, fixed: Int| {
            let change = Change {
                signed_root,
                is_quadric,
                fixed,
            };
            normal_component(&format!("component_{name}"), late, (g, k), change)
        };
        let normal = Normal::of([
            component("x", gradients.gx, factors.kx, fixed.nx),
            component("y", gradients.gy, factors.ky, fixed.ny),
            component("z", gradients.gz, factors.kz, fixed.nz),
        ]);
        ("", normal, "visible face")
    })
}

/// Bits of a scaled root: those of a root or of a positive number of a normal.
pub fn scaled_root_width(root: u32, normal: u32) -> u32 {
    root.min(normal - 1)
}

/// The normal of a face that is none of the quadric: of a plane its own, of the cap `cap_nz` along the line of sight,
/// else zero.
pub(super) fn constant_normal(number: Bits, cap_nz: Int, planes: &[Normal]) -> Normal {
    let none = Int::new(0, cap_nz.width());
    let cap = Normal::of([none, none, cap_nz]);
    let planes = (FIRST_PLANE..).zip(planes.iter().copied());
    let choose = |other, (own, normal)| number.is(own).select(normal, other);
    let faces = planes.chain([(CAP, cap)]);
    faces.fold(Normal::of([none; 3]), choose)
}

/// One component, two clocks after its flags.
fn normal_component(at: &str, flags: Flags, (g, k): (Linear, Int), change: Change) -> Int {
    let inputs = (flags, g, ("k", k), change);
    module("normal_component", at, inputs, |(flags, g, k, change)| {
        let (width, whole) = (k.width(), g.a.width());
        let value = pe1("g", flags, g);
        // Of the product of two numbers the bits that stand beside those of g.
        let point = 2 * width - whole - 2;
        // Delays alone, which multipliers can have as their input registers.
        net! {
            let k_late = k.reg();
            let signed_root_late = change.signed_root.reg();
            let kept_change = (k_late * signed_root_late).reg();
            let sum = value + kept_change.slice(point + whole - 1, point).int();
        }
        let component = change.is_quadric.select(sum.high(width), change.fixed);
        ("result", component.reg())
    })
}
