//! What a surface sends back of one light.
use crate::kernel::*;
/// Gives `colour (share diffuse + mirror specular)` for red, green, blue.
///
/// The sum of the products has 33 bits after the point, of which 16 are kept; the levels have 21. Latency 3.
pub struct SentLight {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Diffuse factor.
    pub diffuse: Signal<In, Word<17>>,
    /// Specular factor.
    pub specular: Signal<In, Word<17>>,
    /// Mirrored share of the material.
    pub mirror: Signal<In, Word<16>>,
    /// Diffused share of the material.
    pub share_r: Signal<In, Word<16>>,
    /// Diffused share of the material.
    pub share_g: Signal<In, Word<16>>,
    /// Diffused share of the material.
    pub share_b: Signal<In, Word<16>>,
    /// Colour of the light.
    pub colour_r: Signal<In, Word<17>>,
    /// Colour of the light.
    pub colour_g: Signal<In, Word<17>>,
    /// Colour of the light.
    pub colour_b: Signal<In, Word<17>>,
    /// Level, 21 bits after the point.
    pub level_r: Signal<Out, Word<38>>,
    /// Level, 21 bits after the point.
    pub level_g: Signal<Out, Word<38>>,
    /// Level, 21 bits after the point.
    pub level_b: Signal<Out, Word<38>>,
    wide_diffuse: Signal<Local, Word<18>>,
    wide_specular: Signal<Local, Word<18>>,
    wide_mirror: Signal<Local, Word<18>>,
    factor_diffuse: Signal<Local, Int<18>>,
    factor_specular: Signal<Local, Int<18>>,
    factor_mirror: Signal<Local, Int<18>>,
    kept_mirrored: DFF<Doubled<18>>,
    mirrored: Signal<Local, Word<36>>,
    wide_share_r: Signal<Local, Word<18>>,
    factor_share_r: Signal<Local, Int<18>>,
    kept_diffused_r: DFF<Doubled<18>>,
    diffused_r: Signal<Local, Word<36>>,
    both_r: Signal<Local, Word<36>>,
    kept_sent_r: DFF<Word<17>>,
    wide_sent_r: Signal<Local, Word<18>>,
    factor_sent_r: Signal<Local, Int<18>>,
    wide_colour_r: Signal<Local, Word<18>>,
    factor_colour_r: Signal<Local, Int<18>>,
    kept_level_r: DFF<Doubled<18>>,
    level_word_r: Signal<Local, Word<36>>,
    wide_share_g: Signal<Local, Word<18>>,
    factor_share_g: Signal<Local, Int<18>>,
    kept_diffused_g: DFF<Doubled<18>>,
    diffused_g: Signal<Local, Word<36>>,
    both_g: Signal<Local, Word<36>>,
    kept_sent_g: DFF<Word<17>>,
    wide_sent_g: Signal<Local, Word<18>>,
    factor_sent_g: Signal<Local, Int<18>>,
    wide_colour_g: Signal<Local, Word<18>>,
    factor_colour_g: Signal<Local, Int<18>>,
    kept_level_g: DFF<Doubled<18>>,
    level_word_g: Signal<Local, Word<36>>,
    wide_share_b: Signal<Local, Word<18>>,
    factor_share_b: Signal<Local, Int<18>>,
    kept_diffused_b: DFF<Doubled<18>>,
    diffused_b: Signal<Local, Word<36>>,
    both_b: Signal<Local, Word<36>>,
    kept_sent_b: DFF<Word<17>>,
    wide_sent_b: Signal<Local, Word<18>>,
    factor_sent_b: Signal<Local, Int<18>>,
    wide_colour_b: Signal<Local, Word<18>>,
    factor_colour_b: Signal<Local, Int<18>>,
    kept_level_b: DFF<Doubled<18>>,
    level_word_b: Signal<Local, Word<36>>,
    dropped: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [] SentLight []
    inputs { clock, diffuse, specular, mirror, share_r, share_g, share_b, colour_r, colour_g, colour_b }
    parts { level_r, level_g, level_b, wide_diffuse, wide_specular, wide_mirror, factor_diffuse, factor_specular, factor_mirror, kept_mirrored, mirrored, wide_share_r, factor_share_r, kept_diffused_r, diffused_r, both_r, kept_sent_r, wide_sent_r, factor_sent_r, wide_colour_r, factor_colour_r, kept_level_r, level_word_r, wide_share_g, factor_share_g, kept_diffused_g, diffused_g, both_g, kept_sent_g, wide_sent_g, factor_sent_g, wide_colour_g, factor_colour_g, kept_level_g, level_word_g, wide_share_b, factor_share_b, kept_diffused_b, diffused_b, both_b, kept_sent_b, wide_sent_b, factor_sent_b, wide_colour_b, factor_colour_b, kept_level_b, level_word_b, dropped }
    data {  }
}

impl SentLight {
    pub(in crate::machine) fn new() -> Self {
        fields! {
            [clock, diffuse, specular, mirror, share_r, share_g, share_b, colour_r, colour_g, colour_b, level_r, level_g, level_b, wide_diffuse, wide_specular, wide_mirror, factor_diffuse, factor_specular, factor_mirror, kept_mirrored, mirrored, wide_share_r, factor_share_r, kept_diffused_r, diffused_r, both_r, kept_sent_r, wide_sent_r, factor_sent_r, wide_colour_r, factor_colour_r, kept_level_r, level_word_r, wide_share_g, factor_share_g, kept_diffused_g, diffused_g, both_g, kept_sent_g, wide_sent_g, factor_sent_g, wide_colour_g, factor_colour_g, kept_level_g, level_word_g, wide_share_b, factor_share_b, kept_diffused_b, diffused_b, both_b, kept_sent_b, wide_sent_b, factor_sent_b, wide_colour_b, factor_colour_b, kept_level_b, level_word_b]
            dropped: constant(17),
        }
    }
}

impl Logic for SentLight {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sent_light");
        clock!(
            self,
            clock,
            kept_mirrored,
            kept_diffused_r,
            kept_sent_r,
            kept_level_r,
            kept_diffused_g,
            kept_sent_g,
            kept_level_g,
            kept_diffused_b,
            kept_sent_b,
            kept_level_b
        );
        self.wide_diffuse.next = bit_cast::<18, 17>(self.diffuse.val());
        self.wide_specular.next = bit_cast::<18, 17>(self.specular.val());
        self.wide_mirror.next = bit_cast::<18, 16>(self.mirror.val());
        self.factor_diffuse.next = signed_cast(self.wide_diffuse.val());
        self.factor_specular.next = signed_cast(self.wide_specular.val());
        self.factor_mirror.next = signed_cast(self.wide_mirror.val());
        self.kept_mirrored.d.next = self.factor_mirror.val() * self.factor_specular.val();
        self.mirrored.next = unsigned_cast(self.kept_mirrored.q.val().get_bits::<36>(0));

        self.wide_share_r.next = bit_cast::<18, 16>(self.share_r.val());
        self.factor_share_r.next = signed_cast(self.wide_share_r.val());
        self.kept_diffused_r.d.next = self.factor_share_r.val() * self.factor_diffuse.val();
        self.diffused_r.next = unsigned_cast(self.kept_diffused_r.q.val().get_bits::<36>(0));
        self.both_r.next = self.diffused_r.val() + self.mirrored.val();
        self.kept_sent_r.d.next = self.both_r.val().get_bits::<17>(self.dropped.val().index());
        self.wide_sent_r.next = bit_cast::<18, 17>(self.kept_sent_r.q.val());
        self.factor_sent_r.next = signed_cast(self.wide_sent_r.val());
        self.wide_colour_r.next = bit_cast::<18, 17>(self.colour_r.val());
        self.factor_colour_r.next = signed_cast(self.wide_colour_r.val());
        self.kept_level_r.d.next = self.factor_sent_r.val() * self.factor_colour_r.val();
        self.level_word_r.next = unsigned_cast(self.kept_level_r.q.val().get_bits::<36>(0));
        self.level_r.next = bit_cast::<38, 36>(self.level_word_r.val());

        self.wide_share_g.next = bit_cast::<18, 16>(self.share_g.val());
        self.factor_share_g.next = signed_cast(self.wide_share_g.val());
        self.kept_diffused_g.d.next = self.factor_share_g.val() * self.factor_diffuse.val();
        self.diffused_g.next = unsigned_cast(self.kept_diffused_g.q.val().get_bits::<36>(0));
        self.both_g.next = self.diffused_g.val() + self.mirrored.val();
        self.kept_sent_g.d.next = self.both_g.val().get_bits::<17>(self.dropped.val().index());
        self.wide_sent_g.next = bit_cast::<18, 17>(self.kept_sent_g.q.val());
        self.factor_sent_g.next = signed_cast(self.wide_sent_g.val());
        self.wide_colour_g.next = bit_cast::<18, 17>(self.colour_g.val());
        self.factor_colour_g.next = signed_cast(self.wide_colour_g.val());
        self.kept_level_g.d.next = self.factor_sent_g.val() * self.factor_colour_g.val();
        self.level_word_g.next = unsigned_cast(self.kept_level_g.q.val().get_bits::<36>(0));
        self.level_g.next = bit_cast::<38, 36>(self.level_word_g.val());

        self.wide_share_b.next = bit_cast::<18, 16>(self.share_b.val());
        self.factor_share_b.next = signed_cast(self.wide_share_b.val());
        self.kept_diffused_b.d.next = self.factor_share_b.val() * self.factor_diffuse.val();
        self.diffused_b.next = unsigned_cast(self.kept_diffused_b.q.val().get_bits::<36>(0));
        self.both_b.next = self.diffused_b.val() + self.mirrored.val();
        self.kept_sent_b.d.next = self.both_b.val().get_bits::<17>(self.dropped.val().index());
        self.wide_sent_b.next = bit_cast::<18, 17>(self.kept_sent_b.q.val());
        self.factor_sent_b.next = signed_cast(self.wide_sent_b.val());
        self.wide_colour_b.next = bit_cast::<18, 17>(self.colour_b.val());
        self.factor_colour_b.next = signed_cast(self.wide_colour_b.val());
        self.kept_level_b.d.next = self.factor_sent_b.val() * self.factor_colour_b.val();
        self.level_word_b.next = unsigned_cast(self.kept_level_b.q.val().get_bits::<36>(0));
        self.level_b.next = bit_cast::<38, 36>(self.level_word_b.val());
    }
}

clocked!(SentLight);
