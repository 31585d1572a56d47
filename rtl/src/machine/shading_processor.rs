//! Shading processor.
use super::shading::attenuation::Attenuation;
use super::shading::light_factors::LightFactors;
use super::shading::light_store::LightStore;
use super::shading::sent_light::SentLight;
use super::shading::sight::Sight;
use super::shading::view_store::ViewStore;
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;
use crate::unit::delay::WordDelay;

/// Clocks from a pixel to its colour.
pub const LATENCY: usize = 38;

/// Gives the colour of every pixel by the formula of Phong, one pixel per clock, from depth, normal, material and the flags of the sources.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid` | in | this clock carries a pixel |
/// | `x`, `y` | in | 12 bits, pixel of the screen |
/// | `depth` | in | `W` bits, two's complement; `ZMAX` is the background |
/// | `material` | in | 8 bits |
/// | `nx`, `ny`, `nz` | in | 16 bits, two's complement, any length |
/// | `flags` | in | 16 bits, bit i: source i reaches the point |
/// | `load_valid`, `load_address`, `load_data` | in | 1, 16, 32 bits; addresses in section 8.1 |
/// | `out_valid` | out | `valid`, delayed |
/// | `red`, `green`, `blue` | out | 8 bits |
///
/// Latency 38. Words stay unchanged while pixels are inside. Section 8 of the architecture; Chaillou 1991, III.1.2.
pub struct ShadingProcessor<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// Column.
    pub x: Signal<In, Word<12>>,
    /// Line.
    pub y: Signal<In, Word<12>>,
    /// Depth word.
    pub depth: Signal<In, Int<W>>,
    /// Number of the material.
    pub material: Signal<In, Word<8>>,
    /// Component x of the normal.
    pub nx: Signal<In, Int<16>>,
    /// Component y of the normal.
    pub ny: Signal<In, Int<16>>,
    /// Component z of the normal.
    pub nz: Signal<In, Int<16>>,
    /// Bit i: source i reaches the point.
    pub flags: Signal<In, Word<16>>,
    /// This clock carries a word.
    pub load_valid: Signal<In, Bit>,
    /// Its address.
    pub load_address: Signal<In, Word<16>>,
    /// The word.
    pub load_data: Signal<In, Word<32>>,
    /// A pixel comes out.
    pub out_valid: Signal<Out, Bit>,
    /// Red.
    pub red: Signal<Out, Word<8>>,
    /// Green.
    pub green: Signal<Out, Word<8>>,
    /// Blue.
    pub blue: Signal<Out, Word<8>>,
    view_store: ViewStore,
    light_stores: Vec<LightStore>,
    sight: Sight,
    attenuation: Attenuation,
    factors: Vec<LightFactors>,
    sent: Vec<SentLight>,
    valid_delay: WordDelay<Bit>,
    is_far: WordDelay<Bit>,
    material_delay: WordDelay<Word<8>>,
    late_material: WordDelay<Word<8>>,
    depth_word: Signal<Local, Word<W>>,
    wide_depth: Signal<Local, Word<32>>,
    left_depth: Signal<Local, Word<32>>,
    kept_depth: DFF<Word<32>>,
    inverted: Signal<Local, Word<32>>,
    turned_sign: Signal<Local, Word<32>>,
    kept_far: DFF<Word<32>>,
    missing: Constant<Word<8>>,
    sign_bit: Constant<Word<32>>,
    depth_mask: Constant<Word<32>>,
    far_end: Constant<Int<W>>,
    page: Signal<Local, Word<6>>,
    memory_number: Signal<Local, Word<2>>,
    is_material: Signal<Local, Bit>,
    materials: Vec<BlockMemory<8, 32>>,
    page_at: Constant<Word<8>>,
    entry_at: Constant<Word<8>>,
    material_page: Constant<Word<6>>,
    number: Vec<Constant<Word<2>>>,
    exponent: Signal<Local, Word<8>>,
    early_share: Signal<Local, Word<16>>,
    share_delay: WordDelay<Word<16>>,
    second_half: Constant<Word<8>>,
    mirror: Signal<Local, Word<16>>,
    share_r: Signal<Local, Word<16>>,
    ambient_r: Signal<Local, Word<16>>,
    share_g: Signal<Local, Word<16>>,
    ambient_g: Signal<Local, Word<16>>,
    share_b: Signal<Local, Word<16>>,
    ambient_b: Signal<Local, Word<16>>,
    term_r: Vec<Signal<Local, Word<38>>>,
    term_g: Vec<Signal<Local, Word<38>>>,
    term_b: Vec<Signal<Local, Word<38>>>,
    no_level: Constant<Word<38>>,
    half: Constant<Word<38>>,
    ambient_point: Constant<Word<8>>,
    level_at: Constant<Word<8>>,
    excess_at: Constant<Word<8>>,
    no_excess: Constant<Word<9>>,
    brightest: Constant<Word<8>>,
    ambient_delay_r: WordDelay<Word<16>>,
    wide_ambient_r: Signal<Local, Word<38>>,
    ambient_level_r: Signal<Local, Word<38>>,
    first_r: Signal<Local, Word<38>>,
    second_r: Signal<Local, Word<38>>,
    kept_low_r: DFF<Word<38>>,
    kept_high_r: DFF<Word<38>>,
    kept_sum_r: DFF<Word<38>>,
    excess_r: Signal<Local, Word<9>>,
    kept_red: DFF<Word<8>>,
    ambient_delay_g: WordDelay<Word<16>>,
    wide_ambient_g: Signal<Local, Word<38>>,
    ambient_level_g: Signal<Local, Word<38>>,
    first_g: Signal<Local, Word<38>>,
    second_g: Signal<Local, Word<38>>,
    kept_low_g: DFF<Word<38>>,
    kept_high_g: DFF<Word<38>>,
    kept_sum_g: DFF<Word<38>>,
    excess_g: Signal<Local, Word<9>>,
    kept_green: DFF<Word<8>>,
    ambient_delay_b: WordDelay<Word<16>>,
    wide_ambient_b: Signal<Local, Word<38>>,
    ambient_level_b: Signal<Local, Word<38>>,
    first_b: Signal<Local, Word<38>>,
    second_b: Signal<Local, Word<38>>,
    kept_low_b: DFF<Word<38>>,
    kept_high_b: DFF<Word<38>>,
    kept_sum_b: DFF<Word<38>>,
    excess_b: Signal<Local, Word<9>>,
    kept_blue: DFF<Word<8>>,
    _lights: usize,
    _asleep: bool,
}

block! {
    [const W: usize] ShadingProcessor [W]
    inputs { clock, valid, x, y, depth, material, nx, ny, nz, flags, load_valid, load_address, load_data }
    parts { out_valid, red, green, blue, view_store, light_stores, sight, attenuation, factors, sent, valid_delay, is_far, material_delay, late_material, depth_word, wide_depth, left_depth, kept_depth, inverted, turned_sign, kept_far, missing, sign_bit, depth_mask, far_end, page, memory_number, is_material, materials, page_at, entry_at, material_page, number, exponent, early_share, share_delay, second_half, mirror, share_r, ambient_r, share_g, ambient_g, share_b, ambient_b, term_r, term_g, term_b, no_level, half, ambient_point, level_at, excess_at, no_excess, brightest, ambient_delay_r, wide_ambient_r, ambient_level_r, first_r, second_r, kept_low_r, kept_high_r, kept_sum_r, excess_r, kept_red, ambient_delay_g, wide_ambient_g, ambient_level_g, first_g, second_g, kept_low_g, kept_high_g, kept_sum_g, excess_g, kept_green, ambient_delay_b, wide_ambient_b, ambient_level_b, first_b, second_b, kept_low_b, kept_high_b, kept_sum_b, excess_b, kept_blue }
    data { _lights }
}

impl<const W: usize> ShadingProcessor<W> {
    /// Clocks from a pixel to its colour.
    pub const fn latency() -> usize {
        LATENCY
    }

    /// A processor of one to four lights, all at once.
    ///
    /// # Panics
    ///
    /// At any other number.
    pub fn new(lights: usize) -> Self {
        assert!((1..=4).contains(&lights), "one to four lights");
        fields! {
            [clock, valid, x, y, depth, material, nx, ny, nz, flags, load_valid, load_address, load_data, out_valid, red, green, blue, depth_word, wide_depth, left_depth, kept_depth, inverted, turned_sign, kept_far, page, memory_number, is_material, exponent, early_share, mirror, share_r, ambient_r, share_g, ambient_g, share_b, ambient_b, wide_ambient_r, ambient_level_r, first_r, second_r, kept_low_r, kept_high_r, kept_sum_r, excess_r, kept_red, wide_ambient_g, ambient_level_g, first_g, second_g, kept_low_g, kept_high_g, kept_sum_g, excess_g, kept_green, wide_ambient_b, ambient_level_b, first_b, second_b, kept_low_b, kept_high_b, kept_sum_b, excess_b, kept_blue]
            view_store: ViewStore::new(),
            light_stores: (0..lights as u64).map(LightStore::new).collect(),
            sight: Sight::new(),
            attenuation: Attenuation::new(),
            factors: repeat(lights, LightFactors::new),
            sent: repeat(lights, SentLight::new),
            valid_delay: WordDelay::new(38),
            is_far: WordDelay::new(37),
            material_delay: WordDelay::new(18),
            late_material: WordDelay::new(13),
            missing: constant(32 - W as u64),
            sign_bit: constant(1 << 31),
            depth_mask: constant((((1u64 << W) - 1) << (32 - W)) & 0xffff_ffff),
            far_end: signed_constant((1 << (W - 1)) - 1),
            materials: repeat(4, BlockMemory::new),
            page_at: constant(10),
            entry_at: constant(2),
            material_page: constant(4),
            number: (0..4).map(constant).collect(),
            share_delay: WordDelay::new(13),
            second_half: constant(16),
            term_r: repeat(4, Signal::default),
            term_g: repeat(4, Signal::default),
            term_b: repeat(4, Signal::default),
            no_level: constant(0),
            half: constant(1 << 20),
            ambient_point: constant(13),
            level_at: constant(21),
            excess_at: constant(29),
            no_excess: constant(0),
            brightest: constant(255),
            ambient_delay_r: WordDelay::new(3),
            ambient_delay_g: WordDelay::new(3),
            ambient_delay_b: WordDelay::new(3),
            _lights: lights,
        }
    }
}

impl<const W: usize> Logic for ShadingProcessor<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("shading_processor");
        clock!(
            self,
            clock,
            view_store,
            sight,
            attenuation,
            valid_delay,
            is_far,
            material_delay,
            late_material,
            kept_depth,
            kept_far,
            share_delay,
            ambient_delay_r,
            kept_low_r,
            kept_high_r,
            kept_sum_r,
            kept_red,
            ambient_delay_g,
            kept_low_g,
            kept_high_g,
            kept_sum_g,
            kept_green,
            ambient_delay_b,
            kept_low_b,
            kept_high_b,
            kept_sum_b,
            kept_blue
        );
        self.view_store.load_valid.next = self.load_valid.val();
        self.view_store.load_address.next = self.load_address.val();
        self.view_store.load_data.next = self.load_data.val();
        self.valid_delay.word.next = self.valid.val();
        self.out_valid.next = self.valid_delay.late.val();
        self.is_far.word.next = self.depth.val() == self.far_end.val();
        self.depth_word.next = unsigned_cast(self.depth.val());
        self.wide_depth.next = bit_cast::<32, W>(self.depth_word.val());
        self.left_depth.next = self.wide_depth.val() << self.missing.val();
        self.kept_depth.d.next = self.left_depth.val();
        self.inverted.next = !self.left_depth.val();
        self.turned_sign.next = self.inverted.val() ^ self.sign_bit.val();
        self.kept_far.d.next = self.turned_sign.val() & self.depth_mask.val();
        self.sight.x.next = self.x.val();
        self.sight.y.next = self.y.val();
        self.sight.nx.next = self.nx.val();
        self.sight.ny.next = self.ny.val();
        self.sight.nz.next = self.nz.val();
        self.sight.size_x.next = self.view_store.size_x.val();
        self.sight.size_y.next = self.view_store.size_y.val();
        self.sight.perspective.next = self.view_store.perspective.val();
        self.sight.view_shift.next = self.view_store.view_shift.val();
        self.sight.distance.next = self.view_store.distance.val();
        self.attenuation.is_on.next = self.view_store.is_attenuated.val();
        self.attenuation.offset.next = self.view_store.offset.val();
        self.attenuation.far.next = self.kept_far.q.val();
        self.attenuation.ray_log.next = self.sight.ray_log.val();
        self.attenuation.ray_places.next = self.sight.ray_places.val();
        self.material_delay.word.next = self.material.val();
        self.late_material.word.next = self.material_delay.late.val();

        self.page.next = self
            .load_address
            .val()
            .get_bits::<6>(self.page_at.val().index());
        self.memory_number.next = self.load_address.val().get_bits::<2>(0);
        self.is_material.next =
            self.load_valid.val() & (self.page.val() == self.material_page.val());
        for i in 0..4 {
            self.materials[i].clock.next = self.clock.val();
            self.materials[i].write.next =
                self.is_material.val() & (self.memory_number.val() == self.number[i].val());
            self.materials[i].write_address.next = self
                .load_address
                .val()
                .get_bits::<8>(self.entry_at.val().index());
            self.materials[i].write_data.next = self.load_data.val();
            self.materials[i].read_address.next = self.late_material.late.val();
        }
        self.materials[3].read_address.next = self.material_delay.late.val();

        self.exponent.next = self.materials[3]
            .read_data
            .val()
            .get_bits::<8>(self.second_half.val().index());
        self.early_share.next = self.materials[3].read_data.val().get_bits::<16>(0);
        self.share_delay.word.next = self.early_share.val();
        self.share_b.next = self.share_delay.late.val();
        self.share_r.next = self.materials[2].read_data.val().get_bits::<16>(0);
        self.share_g.next = self.materials[2]
            .read_data
            .val()
            .get_bits::<16>(self.second_half.val().index());
        self.ambient_r.next = self.materials[0].read_data.val().get_bits::<16>(0);
        self.ambient_g.next = self.materials[0]
            .read_data
            .val()
            .get_bits::<16>(self.second_half.val().index());
        self.ambient_b.next = self.materials[1].read_data.val().get_bits::<16>(0);
        self.mirror.next = self.materials[1]
            .read_data
            .val()
            .get_bits::<16>(self.second_half.val().index());
        for i in 0..4 {
            self.term_r[i].next = self.no_level.val();
            self.term_g[i].next = self.no_level.val();
            self.term_b[i].next = self.no_level.val();
        }
        for i in 0..self._lights {
            self.light_stores[i].clock.next = self.clock.val();
            self.factors[i].clock.next = self.clock.val();
            self.sent[i].clock.next = self.clock.val();
            self.light_stores[i].load_valid.next = self.load_valid.val();
            self.light_stores[i].load_address.next = self.load_address.val();
            self.light_stores[i].load_data.next = self.load_data.val().get_bits::<28>(0);
            self.factors[i].flags.next = self.flags.val();
            self.factors[i].depth.next = signed_cast(self.kept_depth.q.val());
            self.factors[i].exponent.next = self.exponent.val();
            self.factors[i].attenuation.next = self.attenuation.loss.val();
            self.factors[i].place_x.next = self.sight.place_x.val();
            self.factors[i].place_y.next = self.sight.place_y.val();
            self.factors[i].ray_x.next = self.sight.ray_x.val();
            self.factors[i].ray_y.next = self.sight.ray_y.val();
            self.factors[i].ray_z.next = self.sight.ray_z.val();
            self.factors[i].normal_x.next = self.sight.normal_x.val();
            self.factors[i].normal_y.next = self.sight.normal_y.val();
            self.factors[i].normal_z.next = self.sight.normal_z.val();
            self.factors[i].across.next = self.sight.across.val();
            self.factors[i].square.next = self.sight.square.val();
            self.factors[i].turned.next = self.sight.turned.val();
            self.factors[i].normal_log.next = self.sight.normal_log.val();
            self.factors[i].ray_log.next = self.sight.ray_log.val();
            self.factors[i].source.next = self.light_stores[i].source.val();
            self.factors[i].point.next = self.light_stores[i].point.val();
            self.factors[i].shift.next = self.light_stores[i].shift.val();
            self.factors[i].base_x.next = self.light_stores[i].base_x.val();
            self.factors[i].base_y.next = self.light_stores[i].base_y.val();
            self.factors[i].base_z.next = self.light_stores[i].base_z.val();
            self.factors[i].slope_x.next = self.light_stores[i].slope_x.val();
            self.factors[i].slope_y.next = self.light_stores[i].slope_y.val();
            self.factors[i].slope_z.next = self.light_stores[i].slope_z.val();
            self.sent[i].diffuse.next = self.factors[i].diffuse.val();
            self.sent[i].specular.next = self.factors[i].specular.val();
            self.sent[i].mirror.next = self.mirror.val();
            self.sent[i].share_r.next = self.share_r.val();
            self.sent[i].colour_r.next = self.light_stores[i].colour_r.val();
            self.term_r[i].next = self.sent[i].level_r.val();
            self.sent[i].share_g.next = self.share_g.val();
            self.sent[i].colour_g.next = self.light_stores[i].colour_g.val();
            self.term_g[i].next = self.sent[i].level_g.val();
            self.sent[i].share_b.next = self.share_b.val();
            self.sent[i].colour_b.next = self.light_stores[i].colour_b.val();
            self.term_b[i].next = self.sent[i].level_b.val();
        }

        self.ambient_delay_r.word.next = self.ambient_r.val();
        self.wide_ambient_r.next = bit_cast::<38, 16>(self.ambient_delay_r.late.val());
        self.ambient_level_r.next = self.wide_ambient_r.val() << self.ambient_point.val();
        self.first_r.next = self.term_r[0].val() + self.term_r[1].val();
        self.second_r.next = self.ambient_level_r.val() + self.half.val();
        self.kept_low_r.d.next = self.first_r.val() + self.second_r.val();
        self.kept_high_r.d.next = self.term_r[2].val() + self.term_r[3].val();
        self.kept_sum_r.d.next = self.kept_low_r.q.val() + self.kept_high_r.q.val();
        self.excess_r.next = self
            .kept_sum_r
            .q
            .val()
            .get_bits::<9>(self.excess_at.val().index());
        if self.is_far.late.val() {
            self.kept_red.d.next = self.view_store.background_r.val();
        } else {
            if self.excess_r.val() == self.no_excess.val() {
                self.kept_red.d.next = self
                    .kept_sum_r
                    .q
                    .val()
                    .get_bits::<8>(self.level_at.val().index());
            } else {
                self.kept_red.d.next = self.brightest.val();
            }
        }
        self.red.next = self.kept_red.q.val();

        self.ambient_delay_g.word.next = self.ambient_g.val();
        self.wide_ambient_g.next = bit_cast::<38, 16>(self.ambient_delay_g.late.val());
        self.ambient_level_g.next = self.wide_ambient_g.val() << self.ambient_point.val();
        self.first_g.next = self.term_g[0].val() + self.term_g[1].val();
        self.second_g.next = self.ambient_level_g.val() + self.half.val();
        self.kept_low_g.d.next = self.first_g.val() + self.second_g.val();
        self.kept_high_g.d.next = self.term_g[2].val() + self.term_g[3].val();
        self.kept_sum_g.d.next = self.kept_low_g.q.val() + self.kept_high_g.q.val();
        self.excess_g.next = self
            .kept_sum_g
            .q
            .val()
            .get_bits::<9>(self.excess_at.val().index());
        if self.is_far.late.val() {
            self.kept_green.d.next = self.view_store.background_g.val();
        } else {
            if self.excess_g.val() == self.no_excess.val() {
                self.kept_green.d.next = self
                    .kept_sum_g
                    .q
                    .val()
                    .get_bits::<8>(self.level_at.val().index());
            } else {
                self.kept_green.d.next = self.brightest.val();
            }
        }
        self.green.next = self.kept_green.q.val();

        self.ambient_delay_b.word.next = self.ambient_b.val();
        self.wide_ambient_b.next = bit_cast::<38, 16>(self.ambient_delay_b.late.val());
        self.ambient_level_b.next = self.wide_ambient_b.val() << self.ambient_point.val();
        self.first_b.next = self.term_b[0].val() + self.term_b[1].val();
        self.second_b.next = self.ambient_level_b.val() + self.half.val();
        self.kept_low_b.d.next = self.first_b.val() + self.second_b.val();
        self.kept_high_b.d.next = self.term_b[2].val() + self.term_b[3].val();
        self.kept_sum_b.d.next = self.kept_low_b.q.val() + self.kept_high_b.q.val();
        self.excess_b.next = self
            .kept_sum_b
            .q
            .val()
            .get_bits::<9>(self.excess_at.val().index());
        if self.is_far.late.val() {
            self.kept_blue.d.next = self.view_store.background_b.val();
        } else {
            if self.excess_b.val() == self.no_excess.val() {
                self.kept_blue.d.next = self
                    .kept_sum_b
                    .q
                    .val()
                    .get_bits::<8>(self.level_at.val().index());
            } else {
                self.kept_blue.d.next = self.brightest.val();
            }
        }
        self.blue.next = self.kept_blue.q.val();
    }
}

clocked!(ShadingProcessor<const W: usize>);
